"""What the module says is what the command line says, to the last digit."""
import json
import unittest

import numpy as np

import bondstatic as bs
from program import CASES, run, tables

DOFS = ("ux", "uy", "uz", "rx", "ry", "rz")
REACTIONS = ("reaction_fx", "reaction_fy", "reaction_fz", "reaction_mx", "reaction_my", "reaction_mz")
OF_BONDS = ("normal_force", "shear_force", "twisting_moment", "bending_moment", "sigma", "tau", "energy")


class SameAsProgram(unittest.TestCase):
    def check_tables(self, case, solver):
        # Which one "auto" takes depends on the machine's load, and the last digit on whether it is a direct one.
        particles, bonds = tables(case, "--solver", solver)
        solution = bs.solve(bs.read(case), solver=solver)
        np.testing.assert_array_equal(solution.model.ids, particles["id"])
        for column, name in enumerate(DOFS):
            np.testing.assert_array_equal(solution.displacement[:, column], particles[name])
        np.testing.assert_array_equal(solution.rotation, solution.displacement[:, 3:])
        for column, name in enumerate(REACTIONS):
            np.testing.assert_array_equal(solution.reaction[:, column], particles[name])
        np.testing.assert_array_equal(solution.model.bond_ids, bonds["id"])
        ends = solution.model.ids[solution.model.bonds]
        np.testing.assert_array_equal(ends, np.column_stack([bonds["a"], bonds["b"]]))
        for name in OF_BONDS:
            np.testing.assert_array_equal(getattr(solution.bonds, name), bonds[name])
        for column, axis in enumerate("xyz"):
            np.testing.assert_array_equal(solution.bonds.force[:, column], bonds["f" + axis])
            np.testing.assert_array_equal(solution.bonds.moment[:, column], bonds["m" + axis])

    def test_cantilever(self):
        self.check_tables(CASES / "cantilever" / "case.toml", "cholmod")

    def test_packing_of_yade(self):
        for solver in ("cholmod", "multigrid"):
            self.check_tables(CASES / "yade-packing" / "press.toml", solver)

    def check_outputs(self, case, **options):
        told = json.loads(run("solve", case, "--json", *[f"--{k}={v}" for k, v in options.items()]).stdout)
        solution = bs.solve(bs.read(case), **options)
        self.assertEqual(solution.outputs, {output["name"]: output["value"] for output in told["outputs"]})

    def test_outputs_of_several_load_cases(self):
        self.check_outputs(CASES / "yade-packing" / "loads.toml", solver="cholmod")

    def test_outputs_of_a_periodic_cell(self):
        self.check_outputs(CASES / "periodic-cell" / "fcc.toml")

    def test_overrides_are_those_of_the_command_line(self):
        case = CASES / "cantilever" / "case.toml"
        values = {"bonds.0.young": 7e10}
        self.assertNotEqual(bs.solve(bs.read(case, set=values)).outputs, bs.solve(bs.read(case)).outputs)
        told = json.loads(run("solve", case, "--json", "--set", "bonds.0.young=7e10").stdout)
        self.assertEqual(bs.solve(bs.read(case, set=values)).outputs["tip"], told["outputs"][0]["value"])

    def test_threads_and_solvers_do_not_matter(self):
        case = CASES / "yade-packing" / "press.toml"
        for first, others in (({"solver": "cholmod"}, ({"threads": 4}, {"threads": 2, "solver": "eigen"})),
                              ({"solver": "multigrid"}, ({"threads": 4}, {"threads": 3}))):
            reference = bs.solve(bs.read(case), threads=1, **first)
            for options in others:
                other = bs.solve(bs.read(case), **{**first, **options})
                np.testing.assert_array_equal(other.displacement, reference.displacement)
                np.testing.assert_array_equal(other.bonds.force, reference.bonds.force)

    def test_laws_are_those_of_the_listing(self):
        listing = run("laws").stdout
        self.assertGreaterEqual(len(bs.laws()), 10)
        for name, law in bs.laws().items():
            self.assertIn(name, listing)
            self.assertEqual(law.name, name)
        young = {parameter.name: parameter for parameter in bs.laws()["timoshenko"].parameters}["young"]
        self.assertEqual((young.unit, young.default), ("Pa", None))

    def test_version_and_solvers(self):
        self.assertIn(bs.__version__, run("--version").stdout)
        listing = run("solvers").stdout
        for name in bs.solvers():
            self.assertIn(name, listing)


class SameText(unittest.TestCase):
    """str(error) is what the program prints to standard error, its own name apart."""

    def check(self, case, error_type, *settings):
        overrides = [item for key, value in settings for item in ("--set", f"{key}={json.dumps(value)}")]
        told = run("solve", case, *overrides)
        with self.assertRaises(error_type) as caught:
            bs.solve(bs.read(case, set=dict(settings)))
        error = caught.exception
        self.assertEqual(error.exit_code, told.returncode)
        self.assertEqual(str(error), told.stderr.removeprefix("bondstatic: ").removesuffix("\n"))
        return error

    def test_invalid_input(self):
        error = self.check(CASES / "cantilever" / "case.toml", bs.InputError, ("bonds.0.yuong", 1.0),
                           ("bonds.0.poisson", -3))
        self.assertGreaterEqual(len(error.faults), 2)
        self.assertTrue(all(fault.message and fault.cure for fault in error.faults))
        self.assertIsInstance(error, ValueError)

    def test_no_such_file(self):
        self.check(CASES / "nowhere.toml", bs.InputError)

    def test_mechanism(self):
        error = self.check(CASES / "cantilever" / "case.toml", bs.MechanismError, ("supports.0.fix", ["x"]))
        self.assertEqual(error.mechanisms[0].kind, "underconstrained")
        self.assertEqual(error.mechanisms[0].motions, 5)
        self.assertEqual(len(error.mechanisms[0].particles), 11)

    def test_memory(self):
        error = self.check(CASES / "yade-packing" / "press.toml", bs.OutOfMemoryError, ("solve.memory_limit", 1e5),
                           ("solve.solver", "cholmod"), ("solve.threads", 1))
        self.assertIsInstance(error, MemoryError)

    def test_accuracy(self):
        self.check(CASES / "cantilever" / "case.toml", bs.AccuracyError, ("solve.tolerance", 1e-30))


if __name__ == "__main__":
    unittest.main()
