"""compare(): a run by LAMMPS, as the program says; and motions as arrays."""
import json
import unittest
import warnings

import numpy as np

import bondstatic as bs
from program import CASES, beam, run

CASE, DUMP, BONDS = (CASES / "lammps-bpm" / name for name in ("case.toml", "dump.final", "dump.bonds"))
IDS, FORCE = ["c_bl[1]", "c_bl[2]"], ["c_bf[2]", "c_bf[3]", "c_bf[4]"]


def solved(settings=None):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", bs.BondstaticWarning)
        return bs.solve(bs.read(CASE, set=settings), solver="cholmod", threads=1)


def as_json(number):
    return None if np.isnan(number) else number


class Lammps(unittest.TestCase):
    def check(self, found, *options):
        """As the program says."""
        done = run("compare", CASE, DUMP, "--json", "--solver", "cholmod", "--threads", "1", *options)
        told = json.loads(done.stdout)["comparison"]
        self.assertEqual((found.verdict, found.reason, found.step), (told["verdict"], told["reason"], told["step"]))
        self.assertEqual(found.same, done.returncode == 0)
        self.assertEqual(list(found.fields), [field["field"] for field in told["fields"]])
        for field in told["fields"]:
            mine = found.fields[field["field"]]
            self.assertEqual((mine.difference, mine.largest, mine.run_norm, as_json(mine.scale)),
                             (field["difference"], field["largest"], field["run_norm"], field["best_fit_scale"]))
        self.assertEqual({name: as_json(number) for name, number in found.unbalance.items()}, told["state"])
        self.assertEqual([(suspect.text, suspect.left) for suspect in found.suspects],
                         [(suspect["text"], suspect["left"]) for suspect in told["suspects"]])

    def test_the_same_state(self):
        found = bs.compare(solved(), DUMP, bonds=BONDS, bond_columns=IDS, bond_force=FORCE)
        self.assertIn("normal force", found.fields)
        self.check(found, "--bonds", BONDS, "--bond-columns", ",".join(IDS), "--bond-force", ",".join(FORCE))

    def test_another_model(self):
        heard = []
        found = bs.compare(solved({"bonds.0.ks": 4.04e5}), DUMP, progress=heard.append)
        self.check(found, "--set", "bonds.0.ks=4.04e5")
        self.assertIn("shear stiffness 0.990", found.reason)
        self.assertLess(found.suspects[0].left, found.suspects[-1].left)


class Motions(unittest.TestCase):
    def setUp(self):
        self.model = bs.Model(*beam())
        self.model.bond(law="timoshenko", young=50e9, poisson=0.2)
        self.model.fix(0)
        self.model.load(10, force=(0, 0, -1.0), case="down")
        self.model.load(10, force=(0, 1.0, 0), case="across")
        self.solution = bs.solve(self.model)

    def test_with_and_without_rotations(self):
        for case in ("down", "across"):
            motion = self.solution[case].displacement
            for width in (3, 6):
                found = bs.compare(self.solution, motion[:, :width], case=case)
                self.assertTrue(found.same, found.reason)
                self.assertEqual("rotation" in found.fields, width == 6)
                self.assertEqual(found.fields["displacement"].difference, 0)
                off = bs.compare(self.solution, 0.98 * motion[:, :width], case=case)
                self.assertEqual(off.verdict, "different model")
                self.assertAlmostEqual(off.fields["displacement"].scale, 0.98, delta=1e-12)
                self.assertIn("all loads 0.98 times", off.reason)

    def test_the_end_of_a_run(self):
        model = bs.Model(*beam(3), density=2650.0)
        model.bond(law="timoshenko", young=50e9, poisson=0.2)
        model.fix(0)
        model.load(2, force=(0, 0, -1.0))
        found = bs.compare(bs.solve(model), bs.relax(model, kinematics="small").displacement)
        self.assertTrue(found.same, found.reason)

    def test_wrong_questions(self):
        motion = np.array(self.solution["down"].displacement)
        hole = motion.copy()
        hole[3, 1] = np.nan
        for text, given, options in (("2 load cases", motion, {}), ("must be positive", motion, {"tolerance": 0}),
                                     ("give bonds, too", DUMP, {"bond_columns": IDS}),
                                     ("leave them out", motion, {"step": 0}),
                                     (r"shape \(11, 2\) for 11", motion[:, :2], {}),
                                     (r"motion\[3\] is not finite", hole, {}), ("nowhere.dump", "nowhere.dump", {}),
                                     ("2 columns are named", DUMP, {"bonds": BONDS, "bond_force": FORCE[:2]})):
            case = {} if text == "2 load cases" else {"case": "down"}
            with self.assertRaisesRegex(bs.InputError, text):
                bs.compare(self.solution, given, **case, **options)
        with self.assertRaisesRegex(KeyError, "up"):
            bs.compare(self.solution, motion, case="up")


if __name__ == "__main__":
    unittest.main()
