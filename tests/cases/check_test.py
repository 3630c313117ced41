"""check.py and check_fracture.py must notice what they are there to notice.

    /usr/bin/python3 check_test.py PROGRAM
"""
import contextlib
import io
import json
import pathlib
import sys
import tempfile
import unittest

import check
import check_fracture

PROGRAM = None
CASE = """
[[particles]]
line = { from = [0, 0, 0], to = [1, 0, 0], count = 2 }
radius = 0.5
[[bonds]]
law = "generic"
kn = 4.0
ks = 1.0
kt = 1.0
kb = 1.0
[[supports]]
at = { id = 1 }
fix = "all"
[[loads]]
at = { id = 2 }
force = [2.0, 0, 0]
[[outputs]]
name = "stretch"
of = "ux"
at = { id = 2 }
expected = EXPECTED
"""


class Check(unittest.TestCase):
    def agrees(self, text):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
            case = pathlib.Path(folder) / "case.toml"
            case.write_text(text, encoding="utf-8")
            return check.check(PROGRAM, str(case))

    def test_accepts_what_is_expected(self):
        self.assertTrue(self.agrees(CASE.replace("EXPECTED", "0.5")))

    def test_accepts_a_difference_within_the_tolerance(self):
        self.assertTrue(self.agrees(CASE.replace("EXPECTED", "0.51\ntolerance = 0.02")))

    def test_refuses_a_difference_outside_of_it(self):
        self.assertFalse(self.agrees(CASE.replace("EXPECTED", "0.500000001")))

    def test_refuses_a_case_that_cannot_be_solved(self):
        self.assertFalse(self.agrees(CASE.replace("EXPECTED", "0.5").replace("kn = 4.0", "kn = -4.0")))

    def test_refuses_an_output_without_a_value(self):
        for outputs in ([], [{"name": "stretch", "value": None}], [{"name": "stretch", "value": float("nan")}]):
            self.assertFalse(all(agrees for _, agrees in check.compare({"stretch": (0.5, 1e-9)}, outputs)))

    def test_measures_from_zero_absolutely(self):
        self.assertTrue(all(agrees for _, agrees in check.compare({"s": (0.0, 1e-9)}, [{"name": "s", "value": 1e-10}])))
        self.assertFalse(all(agrees for _, agrees in check.compare({"s": (0.0, 1e-9)}, [{"name": "s", "value": 1e-8}])))


class CheckFracture(unittest.TestCase):
    SUMMARY = {"end": "separated", "peak": {"load": 2.0, "bonds": [{"bond": 7}]}, "first_break": None}

    def test_finds_what_a_path_names(self):
        for path, found in (("end", "separated"), ("peak.load", 2.0), ("peak.bonds.0.bond", 7),
                            ("first_break.load", None), ("nothing", None)):
            self.assertEqual(check_fracture.found_in(self.SUMMARY, path), found)

    def test_compares_numbers_within_the_tolerance_and_words_as_they_are(self):
        self.assertTrue(check_fracture.agree(1.01, 1.0, 0.02))
        self.assertTrue(check_fracture.agree("separated", "separated", 0))
        for found, expected in ((1.03, 1.0), (float("nan"), 1.0), (None, 1.0), ("breaks", "separated"), (1e-1, 0.0)):
            self.assertFalse(check_fracture.agree(found, expected, 0.02))

    def test_refuses_a_run_that_went_another_way(self):
        with contextlib.redirect_stdout(io.StringIO()) as told:
            case = pathlib.Path(__file__).parents[2] / "cases/fracture/bundle.toml"
            self.assertTrue(check_fracture.check(PROGRAM, case))
            weaker = json.loads(json.dumps(check_fracture.expected_of(case)))
            weaker["summary"]["peak.load"] *= 1 + 1e-12
            self.assertFalse(check_fracture.check(PROGRAM, case, weaker))
        self.assertIn("WRONG  peak.load", told.getvalue())


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
