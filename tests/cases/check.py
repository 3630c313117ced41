"""Solves a case and compares each output that has an `expected` with it.

    /usr/bin/python3 check.py PROGRAM CASE [SOLVER]
                          prints one line an output; exits 1 where one is off or the case fails. An iterative solver
                          (those in ITERATIVE) may also end with exit 4, which says that it did not reach the accuracy.
"""
import json
import subprocess
import sys
import tomllib

DEFAULT_TOLERANCE = 1e-9
ITERATIVE = {"multigrid", "petsc"}
NOT_ACCURATE = 4


def expectations(case):
    """name -> (expected, tolerance), read from the case file itself and not from what the program makes of it."""
    with open(case, "rb") as file:
        outputs = tomllib.load(file).get("outputs", [])
    return {output["name"]: (output["expected"], output.get("tolerance", DEFAULT_TOLERANCE))
            for output in outputs if "expected" in output}


def compare(expected, outputs):
    """(line, agrees) for each expectation. `outputs`: those of summary.json."""
    found = {output["name"]: output["value"] for output in outputs}
    for name, (value, tolerance) in expected.items():
        if not isinstance(found.get(name), (int, float)):
            yield f"{name}: no value, {value!r} expected", False
            continue
        error = abs(found[name] - value) / (abs(value) or 1)
        # Not `error > tolerance`: it must not pass where it is NaN.
        yield f"{name}: {found[name]!r}, {value!r} expected, off by {error:.1e} of {tolerance:.0e}", error <= tolerance


def check(program, case, solver="auto"):
    expected = expectations(case)
    solved = subprocess.run([program, "solve", case, "--json", "--solver", solver], capture_output=True, text=True,
                            check=False)
    if solved.returncode == NOT_ACCURATE and solver in ITERATIVE:
        print(f"{case}: {solver} says that it cannot\n{solved.stderr}")
        return True
    if solved.returncode != 0:
        print(f"{case}: exit {solved.returncode}\n{solved.stderr}")
        return False
    lines = list(compare(expected, json.loads(solved.stdout)["outputs"]))
    for line, agrees in lines:
        print(f"{'ok    ' if agrees else 'WRONG '} {line}")
    print(f"{case}: solved, {len(lines)} outputs have an expected value")
    return all(agrees for _, agrees in lines)


if __name__ == "__main__":
    sys.exit(0 if check(*sys.argv[1:]) else 1)
