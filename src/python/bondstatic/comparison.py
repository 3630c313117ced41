"""A DEM run's end state beside the static answer."""
from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Union

import numpy as np
import numpy.typing as npt

from . import _core
from .errors import InputError
from .solution import Progress, Solution

#: A dump or table with the state of a run's particles, or motions (n, 6) or (n, 3) in the model's order.
Run = Union[str, "os.PathLike[str]", npt.ArrayLike]


def compare(solution: Solution, run: Run, *, case: str | None = None, step: int | None = None,
            bonds: str | os.PathLike[str] | None = None, bond_columns: Sequence[str] = (),
            bond_force: Sequence[str] = (), tolerance: float = 1e-3, progress: Progress = None) -> _core.Comparison:
    """Is a run's end the static answer, and if not, why?

    solution      what bs.solve() says of the model
    run           a dump or table with ids, positions and orientations; or an array of motions from Model.x in the
                  model's order, (n, 6) with rotation vectors or (n, 3) without, as Relaxation.displacement
    case          the load case that the run has; the only one unless named
    step          of a dump; the last unless given
    bonds         local dump or table with the forces of the run's bonds
    bond_columns  of that file: which hold a bond's particles, ["c_1[1]", "c_1[2]"]
    bond_force    and which its force, and moment: 3 or 6; fx, fy, fz, mx, my, mz unless given
    tolerance     on the relative difference of displacements and rotations
    progress      called with the name of each phase of what has to be solved

    Comparison.same says whether it is; .reason why not, .suspects what would explain it, .fields how far it is apart.
    """
    position = solution._position(case)
    if not tolerance > 0:
        raise InputError(f"tolerance = {tolerance} must be positive\n    cure: give 1e-3, for one")
    if bonds is None and (len(bond_columns) > 0 or len(bond_force) > 0):
        raise InputError("bond_columns and bond_force say what the columns of bonds are\n    cure: give bonds, too")
    if isinstance(run, (str, os.PathLike)):
        return _core.compare_files(solution._solved, position, os.fspath(run), step,
                                   "" if bonds is None else os.fspath(bonds), list(bond_columns), list(bond_force),
                                   tolerance, progress)
    if step is not None or bonds is not None:
        raise InputError("step and bonds are of a run's files, and motions were given\n    cure: leave them out")
    motion = np.asarray(run, dtype=np.float64)
    count = len(solution.model)
    if motion.shape not in ((count, 6), (count, 3)):
        raise InputError(f"motions of shape {motion.shape} for {count} particles\n    cure: give ({count}, 6), or "
                         f"({count}, 3) without rotations")
    return _core.compare_motion(solution._solved, position, motion, tolerance, progress)
