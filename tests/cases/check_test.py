"""check.py must notice what it is there to notice.

    /usr/bin/python3 check_test.py PROGRAM
"""
import contextlib
import io
import pathlib
import sys
import tempfile
import unittest

import check

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


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
