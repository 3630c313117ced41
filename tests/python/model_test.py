"""Models of arrays: closed forms, choices, and what is said of wrong input."""
import copy
import time
import unittest
import warnings

import numpy as np

import bondstatic as bs
from program import CASES, beam

YOUNG, POISSON, RADIUS = 50e9, 0.2, 0.05


def cantilever(**law):
    model = bs.Model(*beam())
    model.bond(law="timoshenko", young=YOUNG, poisson=POISSON, **law)
    model.fix(0)
    return model


class ClosedForms(unittest.TestCase):
    def test_cantilever_bends_as_timoshenko_says(self):
        model = cantilever()
        model.load(10, force=(0, 0, -1000.0))
        s = bs.solve(model)
        inertia, area, shear = np.pi * RADIUS**4 / 4, np.pi * RADIUS**2, YOUNG / (2 * (1 + POISSON))
        tip = 1000.0 / (3 * YOUNG * inertia) + 1000.0 * 10 / (9 * shear * area)
        self.assertAlmostEqual(s.displacement[-1, 2] / -tip, 1, delta=1e-14)
        self.assertAlmostEqual(s.reaction[0, 2], 1000.0, delta=1e-10)
        self.assertAlmostEqual(s.reaction[0, 4], -1000.0, delta=1e-10)
        np.testing.assert_allclose(s.bonds.shear_force, 1000.0, rtol=1e-14)
        self.assertLess(s.accuracy["forward_error"], 1e-13)

    def test_bar_stretches(self):
        model = cantilever()
        model.load(10, force=(500.0, 0, 0))
        s = bs.solve(model)
        self.assertAlmostEqual(s.displacement[-1, 0] * YOUNG * np.pi * RADIUS**2 / 500.0, 1, delta=1e-14)
        np.testing.assert_allclose(s.bonds.normal_force, 500.0, rtol=1e-14)

    def test_a_parameter_of_each_bond(self):
        x, radius, bonds = beam(4)
        model = bs.Model(x, radius, bonds)
        young = np.array([1e9, 2e9, 4e9])
        model.bond(law="timoshenko", young=young, poisson=0.2)
        model.fix(0)
        model.load(3, force=(1.0, 0, 0))
        s = bs.solve(model)
        np.testing.assert_allclose(np.diff(s.displacement[:, 0]), 1 / 3 / (young * np.pi * radius**2), rtol=1e-14)
        np.testing.assert_array_equal(model.parameters()["young"], young)

    def test_periodic_cell_without_loads_is_a_material(self):
        x = np.array([[0, 0, 0], [0, 0.5, 0.5], [0.5, 0, 0.5], [0.5, 0.5, 0]])
        model = bs.Model(x, np.sqrt(0.125), cell={"size": [1, 1, 1]})
        self.assertEqual(model.bond(law="timoshenko", young=1e9, poisson=0.2, existing="add"), 24)
        s = bs.solve(model)
        self.assertEqual(list(s), ["xx", "yy", "zz", "yz", "xz", "xy"])
        stiffness = s.effective["stiffness"]
        np.testing.assert_allclose(stiffness, stiffness.T)
        np.testing.assert_allclose(s["yz"].stress[1, 2], stiffness[3, 3], rtol=1e-14)
        self.assertAlmostEqual(s.value("effective_young"), s.effective["young"])
        self.assertEqual(model.load_cases, [""])  # what was solved is another model


class Choices(unittest.TestCase):
    def held(self, at=None, **where):
        model = bs.Model(*beam())
        model.bond(law="timoshenko", young=YOUNG, poisson=POISSON)
        model.fix(at, values={"x": 1.0, "y": 0, "z": 0, "rx": 0, "ry": 0, "rz": 0}, **where)
        return list(np.flatnonzero(bs.system(model).prescribed.reshape(-1, 6)[:, 0]))

    def test_every_way_to_choose(self):
        mask = np.arange(11) < 2
        for at in (0, [0], np.array([0]), mask & (np.arange(11) == 0), lambda x: x[:, 0] < 0.01, {"id": 0},
                   {"lowest": {"axis": "x", "within": 0.01}}):
            self.assertEqual(self.held(at), [0])
        self.assertEqual(self.held(x_below=0.1), [0, 1])
        self.assertEqual(self.held(x_above=0.55, x_below=0.75), [6, 7])
        self.assertEqual(self.held(mask, x_above=0.05), [1])
        self.assertEqual(self.held([3, 1, 3]), [1, 3])

    def test_groups_and_ids(self):
        x, radius, _ = beam()
        model = bs.Model(x, radius, ids=np.arange(100, 111))
        model.group("end", x_above=0.95)
        self.assertEqual(list(model.groups["end"]), [10])
        model.bond(law="timoshenko", young=YOUNG, poisson=POISSON, gap=0.001)
        self.assertEqual(len(model.bonds), 10)
        model.fix(100)
        model.load("end", force=[0, 1, 0])
        self.assertGreater(bs.solve(model).displacement[10, 1], 0)
        with self.assertRaisesRegex(bs.InputError, r"ids\[0\] = 7 is no particle's"):
            model.fix(7)

    def test_listed_bonds_between_groups(self):
        model = bs.Model(*beam())
        model.group("left", x_below=0.5)
        model.group("right", x_above=0.5)
        self.assertEqual(model.bond(law="timoshenko", young=1e9, poisson=0.2, between="left"), 5)
        self.assertEqual(model.bond(law="timoshenko", young=2e9, poisson=0.2, between="right"), 5)
        np.testing.assert_array_equal(model.block_of_bond, [0] * 5 + [1] * 5)

    def test_totals_units_and_load_cases(self):
        model = cantilever()
        model.load(x_above=0.85, force=("2 kN", 0, 0), total=True, case="pull")
        model.load(10, moment=(0, 0, 1.0), case="bend")
        s = bs.solve(model)
        self.assertEqual(list(s.cases), ["pull", "bend"])
        self.assertAlmostEqual(s["pull"].reaction[0, 0], -2000, delta=1e-9)
        self.assertAlmostEqual(s["bend"].reaction[0, 5], -1, delta=1e-12)
        with self.assertRaisesRegex(bs.InputError, "2 load cases: pull, bend"):
            s.displacement
        with self.assertRaisesRegex(KeyError, "push"):
            s["push"]

    def test_parameters_can_be_changed(self):
        model = cantilever()
        model.load(10, force=(1.0, 0, 0))
        before = bs.solve(model)
        model.set(young="100 GPa")
        self.assertEqual(model.parameters()["young"], 100e9)
        np.testing.assert_allclose(bs.solve(model).displacement, before.displacement / 2, rtol=1e-15)
        self.assertEqual(before.model.parameters()["young"], YOUNG)
        model.set(young=np.linspace(1e9, 2e9, 10))
        self.assertEqual(model.parameters()["young"][9], 2e9)
        self.assertNotEqual(bs.solve(model).energy, before.energy)
        model.set(young=np.full(10, YOUNG))
        np.testing.assert_array_equal(bs.solve(model).displacement, before.displacement)
        for text, wrong in (("bond 0 of the block: young = -1", [-1.0] + [YOUNG] * 9),
                            (r"young\[9\] = nan", np.array([YOUNG] * 9 + [np.nan])), ("young has 9 values", [YOUNG] * 9),
                            ("no parameter", None)):
            with self.assertRaisesRegex(bs.InputError, text):
                model.set(young=wrong)
        with self.assertRaisesRegex(IndexError, "no block -1"):
            model.set(block=-1, young=1.0)
        np.testing.assert_array_equal(model.parameters()["young"], np.full(10, YOUNG))
        model.set(young=np.array(YOUNG))
        self.assertEqual(model.parameters()["young"], YOUNG)
        with self.assertRaisesRegex(bs.InputError, "no such block"):
            model.set(kappa=0.9)

    def test_an_empty_list_of_bonds_is_a_list(self):
        x, radius, _ = beam()
        model = bs.Model(x, radius, [])
        with self.assertRaisesRegex(bs.InputError, "empty list of bonds"):
            model.bond(law="timoshenko", young=YOUNG, poisson=POISSON)
        self.assertEqual(model.bond(law="timoshenko", young=YOUNG, poisson=POISSON, gap=0.001), 10)

    def test_copies_are_their_own(self):
        for another in (bs.Model.copy, copy.copy, copy.deepcopy):
            model = cantilever()
            model.output("tip", "uz", 10)
            model.load(10, force=(0, 0, -1.0))
            made = another(model)
            made.load(10, force=(0, 0, -1.0))
            made.output("twist", "rx", 10)
            self.assertAlmostEqual(bs.solve(made).outputs["tip"] / bs.solve(model).outputs["tip"], 2, delta=1e-13)
            self.assertEqual([output.name for output in model.outputs], ["tip"])

    def test_a_parameter_rules_out_what_says_the_same(self):
        model = bs.Model(*beam())
        model.bond(law="parallel", young=YOUNG, poisson=POISSON)
        self.assertNotIn("kappa", model.parameters())
        model.set(kappa=2.4)
        self.assertNotIn("poisson", model.parameters())
        self.assertEqual(model.parameters()["kappa"], 2.4)

    def test_a_lammps_data_file(self):
        model = bs.read(CASES / "lammps-bpm" / "packing.data", CASES / "lammps-bpm" / "in.lammps")
        self.assertEqual(len(model), 2068)
        self.assertEqual(model.bond(), len(model.bonds))
        self.assertGreater(len(model.bonds), 2068)
        self.assertEqual(model.laws, ["generic"])
        with self.assertWarnsRegex(bs.BondstaticWarning, "read on assumptions"):
            reference = bs.solve(bs.read(CASES / "lammps-bpm" / "case.toml"))
        name = list(reference)[0]
        np.testing.assert_allclose(bs.solve(model).displacement, reference[name].displacement, rtol=1e-9, atol=1e-18)


class WrongInput(unittest.TestCase):
    def test_outputs_of_another_model(self):
        larger = bs.Model(*beam(200))
        larger.bond(law="timoshenko", young=YOUNG, poisson=POISSON)
        model = cantilever()
        model.load(10, force=(0, 0, -1.0))
        s = bs.solve(model)
        for output in (larger.output("far", "uz", 199), larger.output("far", "normal_force", bond=199)):
            self.check('"far" is of another model', s.sensitivity, output, "young")
            model.outputs = [output]
            self.check('"far" is of another model', lambda: bs.solve(model).outputs)
            self.check('"far" is of another model', bs.calibrate, model, {"young": (1e9, 1e12)}, {"far": -1.0})

    def test_arguments_that_would_not_count(self):
        case, data = CASES / "cantilever" / "case.toml", CASES / "lammps-bpm" / "packing.data"
        self.check("is a case", bs.read, case, radius=1.0)
        self.check("set changes keys of a case", bs.read, data, set={"bonds.0.young": 1.0})
        model = bs.read(case, set={"bonds.0.young": np.float32(1.0), "supports.0.fix": np.array(["all"])[0]})
        self.assertEqual(model.parameters()["young"], 1.0)

    def check(self, text, call, *args, **kwargs):
        with self.assertRaises(bs.InputError) as caught:
            call(*args, **kwargs)
        self.assertRegex(str(caught.exception), text)
        self.assertIn("cure: ", str(caught.exception))
        self.assertEqual(caught.exception.exit_code, 2)

    def test_arrays(self):
        x, radius, bonds = beam()
        broken = x.copy()
        broken[3, 1] = np.nan
        self.check(r"x\[3\] = nan must be finite", bs.Model, broken, radius)
        self.check(r"x of shape \(11, 2\)", bs.Model, x[:, :2], radius)
        self.check(r"radius\[4\] = -1 must be positive", bs.Model, x, np.where(np.arange(11) == 4, -1.0, 1.0))
        self.check(r"radius of shape \(3,\) for 11 particles", bs.Model, x, [1, 2, 3])
        self.check(r"ids\[1\] = 5 is there twice", bs.Model, x[:2], radius, ids=[5, 5])
        self.check(r"bonds of type float64", bs.Model, x, radius, bonds.astype(float))
        self.check("size = .* must be positive", bs.Model, x, radius, cell={"size": [1, 0, 1]})
        with self.assertRaises(bs.InputError) as caught:
            bs.Model(np.full((100, 3), np.nan), 1.0)
        self.assertEqual(len(caught.exception.faults), 20)

    def test_steps(self):
        model = bs.Model(*beam())
        self.check('law = "timoschenko" is unknown.*\n.*did you mean "timoshenko"', model.bond, law="timoschenko")
        self.check("young = -5.*must be", model.bond, law="timoshenko", young=-5, poisson=0.2)
        self.check('yuong', model.bond, law="timoshenko", yuong=5e9, poisson=0.2)
        self.check("young has 3 values, 10 bonds are listed", model.bond, law="timoshenko", young=np.ones(3),
                   poisson=0.2)
        self.check("there is no particle 11", bs.Model(*beam()[:2], [[0, 11]]).bond, law="timoshenko", young=1,
                   poisson=0.2)
        self.check("selects no particle", model.fix, np.zeros(11, bool))
        self.check(r"a mask of shape \(3,\) for 11 particles", model.fix, [True, False, True])
        self.check('"q" is no degree of freedom', model.fix, 0, dofs="q")
        self.check("force", model.load, 0)
        self.check("there is no group", model.fix, "nowhere")
        with self.assertRaisesRegex(TypeError, "q_below"):
            model.fix(q_below=1)
        self.assertEqual((len(model.bonds), model.laws, model.load_cases), (0, [], [""]))  # nothing is left of them

    def test_a_step_is_whole_or_nothing(self):
        model = cantilever()
        self.check("bonded already", model.bond, law="timoshenko", young=1e9, poisson=0.2)
        self.check("finite", model.load, 10, force=(0, np.inf, 0), case="lost")
        self.assertEqual((len(model.bonds), model.load_cases), (10, [""]))
        model.load(10, force=(1.0, 0, 0))
        bs.solve(model)

    def test_solving(self):
        model = cantilever()
        self.check('solver = "mumps"', bs.solve, model, solver="mumps")
        self.check("tolerance", bs.solve, model, tolerance=-1)
        free = bs.Model(*beam())
        free.bond(law="timoshenko", young=1e9, poisson=0.2)
        with self.assertRaises(bs.MechanismError):
            bs.solve(free)
        with self.assertRaisesRegex(TypeError, "is no number"):
            model.load(10, force=object())

    def test_warnings_are_pythons(self):
        x, radius, bonds = beam()
        model = bs.Model(np.vstack([x, [[0, 5, 0]]]), radius, bonds)
        model.bond(law="timoshenko", young=1e9, poisson=0.2)
        model.fix(0)
        model.load(11, force=(1, 0, 0))
        with self.assertWarns(bs.BondstaticWarning) as caught:
            s = bs.solve(model, unsupported="drop")
        self.assertEqual(caught.filename, __file__)
        self.assertEqual(s.report["dropped"], [[11]])
        self.assertTrue(np.isnan(s.displacement[11]).all() and not np.isnan(s.displacement[:11]).any())


class Speed(unittest.TestCase):
    def test_a_million_particles_are_no_loop(self):
        count = 1_000_000
        x = np.zeros((count, 3))
        x[:, 0] = np.arange(count)
        bonds = np.column_stack([np.arange(count - 1), np.arange(1, count)])
        begin = time.perf_counter()
        model = bs.Model(x, 0.5, bonds)
        model.bond(law="timoshenko", young=1e9, poisson=0.2)
        model.fix(np.arange(count) < 10)
        model.load(x_above=count - 2.5, force=(1.0, 0, 0))
        seconds = time.perf_counter() - begin
        self.assertEqual(len(model.bonds), count - 1)
        self.assertLess(seconds, 20)  # about 1.5 s on an idle machine; a loop in Python takes minutes


if __name__ == "__main__":
    warnings.simplefilter("error", bs.BondstaticWarning)
    unittest.main()
