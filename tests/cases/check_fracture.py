"""Breaks a case of cases/fracture and compares what its summary says with fracture.toml beside this file.

    /usr/bin/python3 check_fracture.py PROGRAM CASE
                          prints one line a value; exits 1 where one is off or the case fails.
"""
import json
import pathlib
import subprocess
import sys
import tomllib


def found_in(summary, path):
    """"peak.load" -> summary["peak"]["load"]; None where there is no such thing."""
    for key in path.split("."):
        if isinstance(summary, list):
            key = int(key)
        elif not isinstance(summary, dict) or key not in summary:
            return None
        summary = summary[key]
    return summary


def agree(found, expected, tolerance):
    if isinstance(expected, (str, bool)) or not isinstance(found, (int, float)):
        return found == expected
    # Not `error > tolerance`: it must not pass where it is NaN.
    return abs(found - expected) <= tolerance * (abs(expected) or 1)


def expected_of(case):
    with open(pathlib.Path(__file__).parent / "fracture.toml", "rb") as file:
        return tomllib.load(file)[pathlib.Path(case).stem]


def check(program, case, expected=None):
    expected = expected or expected_of(case)
    overrides = [word for override in expected["set"] for word in ("--set", override)]
    done = subprocess.run([program, "fracture", case, "--json", *overrides], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(f"{case}: exit {done.returncode}\n{done.stderr}")
        return False
    summary = json.loads(done.stdout)
    all_agree = True
    for path, value in expected["summary"].items():
        found = found_in(summary, path)
        agrees = agree(found, value, expected["tolerance"])
        all_agree = all_agree and agrees
        print(f"{'ok    ' if agrees else 'WRONG '} {path}: {found!r}, {value!r} expected")
    for path, most in expected["at_most"].items():
        found = found_in(summary, path)
        agrees = isinstance(found, (int, float)) and found <= most
        all_agree = all_agree and agrees
        print(f"{'ok    ' if agrees else 'WRONG '} {path}: {found!r}, at most {most!r} expected")
    return all_agree


if __name__ == "__main__":
    sys.exit(0 if check(*sys.argv[1:]) else 1)
