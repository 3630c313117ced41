"""Models from files: cases of bondstatic, and whatever other DEM codes write."""
from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from . import _core
from .errors import InputError
from .model import Model, _warn


def read(*files: str | os.PathLike[str], set: Mapping[str, Any] | None = None, atom_style: str = "",
         bond_columns: Sequence[str] = (), step: int | None = None, radius: float | None = None) -> Model:
    """Reads a case file (.toml, or a folder with a case.toml), or files of another code that make one model.

    set           for a case: values of its keys, {"bonds.0.young": 70e9}
    atom_style    of a LAMMPS data file: "bpm/sphere", "sphere", ...; unless the file says it
    bond_columns  of a local dump: which columns are the two ids, ["c_1[1]", "c_1[2]"]
    step          of a series; the last unless given
    radius        of each particle, where no file gives radii

    A case takes `set` alone, other files all but `set`. What other codes' files give of bonds waits for bond(): their
    pairs, and stiffness where they have it. Groups, supports and loads of a LAMMPS input script are taken over.
    Model.notes says what was taken, assumed and left out.
    """
    paths = [os.fspath(file) for file in files]
    case = case_file(paths[0]) if len(paths) == 1 else None
    if case is not None:
        if atom_style or bond_columns or step is not None or radius is not None:
            raise InputError(f"{case} is a case, which says itself how its files are read\n"
                             "    cure: give set, {\"particles.0.step\": 3}, say, in place of atom_style, bond_columns, "
                             "step and radius")
        return model_of(case, set, for_fracture=False)
    if set is not None:
        raise InputError(f"{', '.join(paths)}: set changes keys of a case, and there is none\n    cure: leave it out")
    core, taken, assumed, left_out = _core.import_files(paths, atom_style, list(bond_columns), step, radius)
    model = Model._made(core)
    model.file = ", ".join(paths)
    model.notes = {"taken": taken, "assumed": assumed, "left_out": left_out}
    return model


def model_of(case: str, set: Mapping[str, Any] | None, *, for_fracture: bool) -> Model:
    """Of a case file. For fracture it must have what a run rests on."""
    core, facts = _core.read_case(case, overrides(set), for_fracture)
    model = Model._made(core)
    model.title, model.file, model.outputs, model.resolved = facts.title, facts.file, facts.outputs, facts.resolved
    model._solve, model._relax, model._fracture = facts.solve, facts.relax, facts.fracture
    _warn(facts.warnings)
    return model


def case_file(path: str) -> str | None:
    """The case that a path names; None where it is of another code."""
    if path.endswith(".toml"):
        return path
    inside = Path(path) / "case.toml"
    return str(inside) if inside.is_file() else None


def overrides(values: Mapping[str, Any] | None) -> list[str]:
    """KEY=VALUE as in TOML, whose numbers, texts, truth values and lists are those of JSON."""
    return [f"{key}={json.dumps(value, default=_plain)}" for key, value in (values or {}).items()]


def _plain(value: Any) -> Any:
    """numpy's numbers and arrays as Python's."""
    if isinstance(value, (np.generic, np.ndarray)):
        return value.tolist()
    raise TypeError(f"{value!r} is no value of a case's key")
