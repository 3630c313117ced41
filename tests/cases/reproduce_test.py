"""cases/chen2022/reproduce must fail where the program is off by a little, and where it does not answer.

    /usr/bin/python3 reproduce_test.py PROGRAM
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = None
REPRODUCE = pathlib.Path(__file__).resolve().parents[2] / "cases" / "chen2022" / "reproduce"
# Loads off by 1e-11, where there are loads.
SLIGHTLY_WRONG = """#!/bin/sh
case "$2" in */stiffness.toml) exec "{program}" "$@" ;; esac
exec "{program}" "$@" --set "loads.0.force=[0,-100000.000001,0]"
"""
# Only runs through time, and by little more than they may be off.
RUNS_WRONG = """#!/bin/sh
if [ "$1" = relax ]; then exec "{program}" "$@" --set "loads.0.force=[0,-100000.0005,0]"; fi
exec "{program}" "$@"
"""


class Reproduce(unittest.TestCase):
    def run_with(self, script):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "program"
            program.write_text(script, encoding="utf-8")
            program.chmod(0o755)
            return subprocess.run([REPRODUCE, "--program", program, "--out", pathlib.Path(folder) / "out"],
                                  capture_output=True, text=True, check=False)

    def test_notices_numbers_that_are_slightly_off(self):
        done = self.run_with(SLIGHTLY_WRONG.format(program=PROGRAM))
        self.assertEqual(done.returncode, 1, done.stderr)
        for subject in ("Fig. 8a: TBBM", "Fig. 10: EBBM", "Fig. 12: PBM", "Fig. 14: TBBM", "Fig. 16: PBM",
                        "Case 3, all: PBM"):
            self.assertIn(f"MISMATCH {subject}", done.stderr)
        self.assertNotIn("MISMATCH Stiffness", done.stderr)

    def test_notices_explicit_runs_that_end_elsewhere(self):
        done = self.run_with(RUNS_WRONG.format(program=PROGRAM))
        self.assertEqual(done.returncode, 1, done.stderr)
        for model in ("TBBM", "EBBM", "PBM"):
            for run in ("small", "finite"):
                self.assertIn(f"MISMATCH Explicit: {model}, {run}", done.stderr)
        self.assertNotIn("MISMATCH Fig", done.stderr)

    def test_fails_where_the_program_fails(self):
        done = self.run_with("#!/bin/sh\necho broken >&2\nexit 4\n")
        self.assertEqual(done.returncode, 1)
        self.assertIn("exit 4", done.stderr)
        self.assertIn("broken", done.stderr)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
