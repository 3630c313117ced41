"""The program beside the module: BONDSTATIC_PROGRAM names it, the cases are those of the repository."""
import csv
import os
import pathlib
import subprocess
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASES = ROOT / "cases"
PROGRAM = os.environ["BONDSTATIC_PROGRAM"]


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)


def tables(case, *options):
    """(particles, bonds) of `solve`, each a dict of columns."""
    with tempfile.TemporaryDirectory() as folder:
        done = run("solve", case, "--out", folder, *options)
        if done.returncode != 0:
            raise AssertionError(done.stderr)
        return [read_table(pathlib.Path(folder) / name) for name in ("particles.csv", "bonds.csv")]


def read_table(path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    columns = np.array([[float(field or "nan") for field in row] for row in rows[1:]])
    return dict(zip(rows[0], columns.T))


def beam(count=11, length=1.0, radius=0.05):
    """Centres along x and the bonds between neighbours."""
    x = np.zeros((count, 3))
    x[:, 0] = np.linspace(0, length, count)
    return x, radius, np.column_stack([np.arange(count - 1), np.arange(1, count)])
