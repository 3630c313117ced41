"""Exact derivatives from Python, against closed forms, Euler's identities and differences."""
import threading
import time
import unittest

import numpy as np

import bondstatic as bs
from program import CASES, beam

YOUNG, POISSON, RADIUS = 50e9, 0.2, 0.05


def cantilever():
    model = bs.Model(*beam())
    model.bond(law="timoshenko", young=YOUNG, poisson=POISSON, radius_factor=0.9)
    model.fix(0)
    model.load(10, force=(0, 0, -1000.0))
    model.output("tip", "uz", 10)
    return model


def two_blocks():
    model = bs.Model(*beam())
    model.group("left", x_below=0.5)
    model.group("right", x_above=0.5)
    model.bond(law="timoshenko", young=1e9, poisson=0.2, between="left")
    model.bond(law="euler-bernoulli", young=2e9, poisson=0.3, between="right")
    model.fix(0)
    model.load(10, force=(0.3, 0.2, -1.0))
    model.output("tip", "uz", 10)
    return model


class Sensitivities(unittest.TestCase):
    def test_closed_form(self):
        s = bs.solve(cantilever())
        tip = s.outputs["tip"]
        found = s.sensitivity("tip", ["young", "poisson"])
        self.assertAlmostEqual(found["young"] / (-tip / YOUNG), 1, delta=1e-12)
        area = np.pi * (0.9 * RADIUS)**2
        by_poisson = -1000.0 * 10 / 9 * 2 / (YOUNG * area)  # of the shear part, F L / (kappa A G)
        self.assertAlmostEqual(found["poisson"] / by_poisson, 1, delta=1e-9)

    def test_a_quantity_that_is_no_output(self):
        s = bs.solve(cantilever())
        self.assertEqual(s.sensitivity("uz", "young", at=10), s.sensitivity("tip", "young"))
        packing = bs.solve(bs.read(CASES / "yade-packing" / "press.toml"))
        bottom = packing.outputs["force on the lower platen"]
        output = next(o for o in packing.model.outputs if o.name == "force on the lower platen")
        found = packing.sensitivity(output, ["young", "radius_factor"])
        self.assertAlmostEqual(found["young"] * 50e9 / bottom, 1, delta=1e-11)
        self.assertGreater(abs(found["radius_factor"]), 0)
        # All reactions together balance, whatever the bonds are.
        self.assertLess(abs(packing.sensitivity("reaction_z", "radius_factor")["radius_factor"]),
                        1e-9 * abs(found["radius_factor"]))

    def test_global_is_the_sum_of_blocks_and_these_of_bonds(self):
        s = bs.solve(two_blocks())
        whole = s.sensitivity("tip", "young")["young"]
        blocks = s.sensitivity("tip", "young", by="block")["young"]
        bonds = s.sensitivity("tip", "young", by="bond")["young"]
        self.assertEqual(list(blocks), ["bonds.0.young", "bonds.1.young"])
        self.assertAlmostEqual(sum(blocks.values()) / whole, 1, delta=1e-13)
        for block in (0, 1):
            of_block = bonds[s.model.block_of_bond == block].sum()
            self.assertAlmostEqual(of_block / blocks[f"bonds.{block}.young"], 1, delta=1e-13)
            self.assertEqual(s.sensitivity("tip", f"bonds.{block}.young")[f"bonds.{block}.young"],
                             blocks[f"bonds.{block}.young"])
        # u is homogeneous of degree -1 in all moduli together.
        euler = blocks["bonds.0.young"] * 1e9 + blocks["bonds.1.young"] * 2e9
        self.assertAlmostEqual(euler / -s.outputs["tip"], 1, delta=1e-13)

    def test_jacobian_against_differences(self):
        model = two_blocks()
        model.output("twist", "rx", 10)
        model.output("moment", "bending_moment", bond=3)
        model.output("energy", "energy")
        analysis = bs.Analysis(model)
        names, step = ["bonds.0.young", "bonds.0.poisson", "bonds.1.young"], 1e-4
        jacobian = analysis.solve().jacobian(["tip", "moment", "energy"], names)
        for column, name in enumerate(names):
            _, block, parameter = name.split(".")
            value = model.parameters(int(block))[parameter]
            found = []
            for factor in (1 + step, 1 - step):
                model.set(block=int(block), **{parameter: value * factor})
                outputs = analysis.solve().outputs
                found.append([outputs["tip"], outputs["moment"], outputs["energy"]])
            model.set(block=int(block), **{parameter: value})
            difference = (np.array(found[0]) - found[1]) / (2 * step * value)
            np.testing.assert_allclose(jacobian[:, column], difference, rtol=1e-7,
                                       atol=1e-7 * np.abs(difference).max())

    def test_older_solutions_of_an_analysis_keep_theirs(self):
        model = cantilever()
        analysis = bs.Analysis(model)
        first = analysis.solve()
        before = first.sensitivity("tip", "young")["young"]
        model.set(young=YOUNG / 2)
        second = analysis.solve()
        self.assertAlmostEqual(second.sensitivity("tip", "young")["young"] / before, 4, delta=1e-11)
        self.assertEqual(first.sensitivity("tip", "young")["young"], before)
        np.testing.assert_allclose(second.displacement, 2 * first.displacement, rtol=1e-14)

    def test_an_analysis_takes_what_comes(self):
        model = cantilever()
        analysis = bs.Analysis(model)
        analysis.solve()
        model.load(5, force=(0, 0, 2000.0))
        np.testing.assert_array_equal(analysis.solve().displacement, bs.solve(model).displacement)
        model.fix(10, dofs=["z"])  # another pattern
        np.testing.assert_array_equal(analysis.solve().displacement, bs.solve(model).displacement)

    def test_bonds_with_values_of_their_own(self):
        model = cantilever()
        wanted = bs.solve(model).sensitivity("tip", "young", by="bond")["young"]
        for given in (np.full(10, YOUNG), [YOUNG] * 10):
            model.set(young=given)
            s = bs.solve(model)
            np.testing.assert_array_equal(s.sensitivity("tip", "young", by="bond")["young"], wanted)
            with self.assertRaisesRegex(bs.InputError, "each bond of bonds.0 has a young of its own"):
                s.sensitivity("tip", "young")
        model = bs.Model(*beam())
        model.bond(law="timoshenko", young=np.full(10, YOUNG), poisson=POISSON, radius_factor=0.9)
        model.fix(0)
        model.load(10, force=(0, 0, -1000.0))
        found = bs.solve(model).sensitivity("uz", "bonds.0.young", by="bond", at=10)["bonds.0.young"]
        np.testing.assert_array_equal(found, wanted)

    def test_a_quantity_with_the_name_of_an_output(self):
        model = cantilever()
        middle = model.output("uz", "uz", 5)
        s = bs.solve(model)
        self.assertEqual(s.sensitivity("uz", "young", at=10), s.sensitivity("tip", "young"))
        self.assertNotEqual(s.sensitivity("uz", "young"), s.sensitivity("tip", "young"))
        with self.assertRaisesRegex(bs.InputError, "says itself which particles"):
            s.sensitivity(middle, "young", at=10)
        with self.assertRaisesRegex(bs.InputError, "no quantity"):
            s.sensitivity("tip", "young", at=10)
        with self.assertRaisesRegex(TypeError, "bye"):
            s.sensitivity("tip", "young", bye="bond")
        np.testing.assert_array_equal(s.jacobian("tip", "young"), s.jacobian(["tip"], ["young"]))

    def test_an_analysis_that_threads_share(self):
        model = bs.Model(*beam(101))
        model.bond(law="timoshenko", young=YOUNG, poisson=POISSON)
        model.fix(0)
        model.load(100, force=(0, 0, -1000.0))
        many = [model.output(f"u{p}", "uz", p) for p in range(1, 101)] * 20
        analysis = bs.Analysis(model)
        first = analysis.solve()
        wanted = first.sensitivity("u100", "young")["young"]
        asking = threading.Thread(target=first.jacobian, args=(many, "young"))
        asking.start()
        time.sleep(0.005)  # the gradients, some tenths of a second, have the factor by now
        model.set(young=YOUNG / 2)
        second = analysis.solve()
        asking.join()
        self.assertAlmostEqual(second.sensitivity("u100", "young")["young"] / wanted, 4, delta=1e-9)

    def test_wrong_questions(self):
        s = bs.solve(cantilever())
        for text, arguments in (("yuong", ("tip", "yuong")), ("by", ("tip", "young", "everything")),
                                ("no quantity", ("uq", "young")), ("kappa", ("tip", "kappa"))):
            with self.assertRaisesRegex(bs.InputError, text):
                s.sensitivity(arguments[0], arguments[1], by=arguments[2] if len(arguments) > 2 else "global")


if __name__ == "__main__":
    unittest.main()
