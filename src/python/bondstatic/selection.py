"""Which particles are meant: ids, masks, groups, functions of the positions, half spaces."""
from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from . import _core
from .errors import InputError

#: An id or several, a mask with one truth value a particle, the name of a group, a function from positions (n, 3) to
#: such a mask, or a selector as in a case file: {"lowest": {"axis": "z", "within": 2e-3}}.
At = Union[int, str, Sequence[int], Sequence[bool], npt.NDArray[Any], Mapping[str, Any],
           Callable[[npt.NDArray[np.float64]], npt.ArrayLike], None]

Positions = Union[npt.NDArray[np.int64], None]


def selector(model: _core.Model, at: At, where: Mapping[str, Any]) -> tuple[dict[str, Any] | None, Positions]:
    """A table as in a case file, None for none, and positions that it holds for as well."""
    table: dict[str, Any] = {}
    positions: Positions = None
    if isinstance(at, str):
        table["group"] = at
    elif isinstance(at, Mapping):
        table.update(at)
    elif at is not None:
        positions = _positions(model, np.asarray(at(model.x) if callable(at) else at))
    box = _box(where)
    if box:
        table["box"] = box
    return (table if table or positions is not None else None), positions


def _positions(model: _core.Model, chosen: npt.NDArray[Any]) -> npt.NDArray[np.int64]:
    if chosen.dtype == bool:
        if chosen.shape != (len(model.ids),):
            raise InputError(f"a mask of shape {chosen.shape} for {len(model.ids)} particles\n"
                             "    cure: give one truth value for each particle")
        return np.flatnonzero(chosen)
    if chosen.size and chosen.dtype.kind not in "iu":
        raise InputError(f"particles cannot be chosen by numbers of type {chosen.dtype}\n"
                         "    cure: give ids, whole numbers, or a mask of truth values")
    return np.unique(model.positions_of(chosen.astype(np.int64).reshape(-1)))


def _box(where: Mapping[str, Any]) -> dict[str, list[Any]]:
    lowest: list[Any] = [-np.inf] * 3
    highest: list[Any] = [np.inf] * 3
    for key, value in where.items():
        axis, _, side = key.partition("_")
        if axis not in ("x", "y", "z") or side not in ("below", "above"):
            raise TypeError(f"unexpected keyword argument '{key}'; places are chosen by x_below, x_above, y_below, ...")
        (highest if side == "below" else lowest)["xyz".index(axis)] = value
    return {"min": lowest, "max": highest} if where else {}
