"""The stiffness matrix and the linear system, for who wants to solve it by other means."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import scipy.sparse as sparse

from . import _core
from .errors import InputError
from .model import Floats, Ints, Model


@dataclass(frozen=True)
class System:
    """K u = f of one load case over the degrees of freedom that are free."""

    #: (f, f), scipy CSR: symmetric, positive definite. Rotations are radians: nothing is scaled.
    K: sparse.csr_matrix
    #: (f,): 6 * row of Model.x + 0 ... 5 for x, y, z, rx, ry, rz, of each unknown.
    dofs: Ints
    #: (f,): loads, less what prescribed motions and a cell's strain take.
    rhs: Floats
    #: (6 n,): motion where it is prescribed, zero elsewhere.
    prescribed: Floats

    def displacement(self, unknowns: Floats) -> Floats:
        """(n, 6): all motions from those of the unknowns. In a periodic cell, beyond the mean strain."""
        motion = self.prescribed.copy()
        motion[self.dofs] = unknowns
        return motion.reshape(-1, 6)


def stiffness(model: Model) -> sparse.csr_matrix:
    """K as scipy CSR, (6 n, 6 n): forces and moments on all particles for their motions, in the order x, y, z, rx, ry,
    rz of each particle, rows as in Model.x. Supports do not count."""
    values, rows, starts, _, _, _ = _core.full_matrix(model._core)
    return _whole_of(values, rows, starts)


def system(model: Model, case: str | None = None, *, unsupported: str | None = None) -> System:
    """The reduced system of a load case; the only one unless named. Bodies that no support touches are an error, or
    with unsupported="drop" have no unknowns; as in the model's case unless given."""
    ready = model._ready()
    names = ready.load_cases
    if case is None and len(names) > 1:
        raise InputError(f"there are {len(names)} load cases: {', '.join(names)}\n    cure: say which is meant")
    if case is not None and case not in names:
        raise InputError(f'there is no load case "{case}"\n    cure: there are: {", ".join(names)}')
    position = 0 if case is None else names.index(case)
    drop = ready._solve.with_({"unsupported": unsupported}).drops
    values, rows, starts, dofs, right, prescribed = _core.reduced_system(ready._core, position, drop)
    return System(_whole_of(values, rows, starts), dofs, right, prescribed)


def _whole_of(values: Floats, rows: Ints, starts: Ints) -> sparse.csr_matrix:
    # Compressed columns of the lower triangle are compressed rows of the upper one.
    size = len(starts) - 1
    upper: Any = sparse.csr_matrix((values, rows, starts), shape=(size, size), copy=False)
    whole = (upper + sparse.triu(upper, 1, format="csr").T).tocsr()
    whole.sort_indices()
    return whole
