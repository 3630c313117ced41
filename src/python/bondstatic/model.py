"""The model: particles, bonds, supports, loads."""
from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from . import _core
from .errors import BondstaticWarning, InputError
from .selection import At, selector

#: A number, or a text with its unit: "50 GPa".
Quantity = Union[float, str]
Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]


class Model:
    """Bonded spheres, what holds them and what loads them, in any one consistent system of units.

    x        (n, 3), length: centres
    radius   (n,) or one number, length
    bonds    (m, 2), ids of the particles that are bonded; bond() gives them their law. Without, bonds form by
             distance, too
    ids      (n,), whole numbers; without, particles are numbered from 0 on: ids are then rows of x
    density  (n,) or one number, mass / length^3; for gravity and runs through time
    cell     a periodic cell as in a case file: {"size": [LX, LY, LZ]} or {"edges": .., "origin": .., "periodic": ..}

    Everything else is chosen as in a case file, with the same words, units and defaults. Each method either does all
    of its work or raises and leaves the model as it was. Solutions keep the model that they are of.
    """

    def __init__(self, x: npt.ArrayLike, radius: npt.ArrayLike, bonds: npt.ArrayLike | None = None, *,
                 ids: npt.ArrayLike | None = None, density: npt.ArrayLike | None = None,
                 cell: Mapping[str, Any] | None = None):
        centres = np.ascontiguousarray(x, dtype=np.float64)
        _need(centres.ndim == 2 and centres.shape[1] == 3, f"x of shape {centres.shape}", "give centres as (n, 3)")
        count = len(centres)
        _need(count > 0, "a model without particles", "give centres as (n, 3)")
        names = np.arange(count) if ids is None else _whole(ids, "ids", (count,))
        pairs = None if bonds is None else _whole(bonds, "bonds", (-1, 2))
        self._core = _core.Model(centres, _of_each(radius, "radius", count), names,
                                 None if density is None else _of_each(density, "density", count), pairs, cell)
        self._begin()

    def _begin(self) -> None:
        #: Of the case, or the file's own.
        self.title = ""
        #: Where it was read from; "" for a model made of arrays.
        self.file = ""
        #: What Solution.outputs tells; see output().
        self.outputs: list[_core.Output] = []
        #: The case as TOML with defaults and overrides filled in; "" where it is from no case.
        self.resolved = ""
        #: What was taken, assumed and left out where another code's files were read, full sentences.
        self.notes: dict[str, list[str]] = {}
        self._solve = _core.SolveOptions()
        self._relax = _core.RelaxOptions()
        self._fracture = _core.FractureOptions()

    @classmethod
    def _made(cls, core: _core.Model) -> Model:
        model = cls.__new__(cls)
        model._core = core
        model._begin()
        return model

    def copy(self) -> Model:
        """Another model that is the same now."""
        made = Model._made(_core.Model(self._core))
        made.title, made.file, made.resolved = self.title, self.file, self.resolved
        made.outputs, made.notes = list(self.outputs), dict(self.notes)
        made._solve, made._relax, made._fracture = self._solve, self._relax, self._fracture
        return made

    def __copy__(self) -> Model:
        return self.copy()

    def __deepcopy__(self, memo: dict[int, Any]) -> Model:
        return self.copy()

    def _ready(self) -> Model:
        """A copy that can be solved: a periodic cell has what goes without saying, as in a case file."""
        made = self.copy()
        made._core.complete_cell()
        return made

    # Views of the model's own memory, read-only.

    @property
    def x(self) -> Floats:
        """(n, 3), length: centres."""
        return self._core.x

    @property
    def radius(self) -> Floats:
        """(n,), length."""
        return self._core.radius

    @property
    def density(self) -> Floats:
        """(n,), mass / length^3; NaN where not given."""
        return self._core.density

    @property
    def ids(self) -> Ints:
        """(n,)"""
        return self._core.ids

    @property
    def bonds(self) -> Ints:
        """(m, 2): rows of x that are bonded; each from a to b."""
        return self._core.bonds

    @property
    def bond_ids(self) -> Ints:
        """(m,): from 1 on unless a file has them; not rows. What is asked with bond=.. takes them."""
        return self._core.bond_ids

    @property
    def branch(self) -> Floats:
        """(m, 3), length: from the centre of a to that of b, its image in a periodic cell."""
        return self._core.branch

    @property
    def block_of_bond(self) -> Ints:
        """(m,): which call of bond(), or which [[bonds]] block, the bond is of."""
        return self._core.block_of_bond

    @property
    def laws(self) -> list[str]:
        """Of each block of bonds."""
        return self._core.laws

    @property
    def load_cases(self) -> list[str]:
        """Names of the load cases; [""] where there is one without a name."""
        return self._core.load_cases

    @property
    def groups(self) -> dict[str, Ints]:
        """Rows of x by the name of their group."""
        return self._core.groups

    def __len__(self) -> int:
        return len(self._core.ids)

    def __repr__(self) -> str:
        return f"<bondstatic.Model: {len(self)} particles, {len(self.bond_ids)} bonds>"

    # What makes a model.

    def bond(self, law: str | None = None, *, gap: Quantity | None = None,
             contact_radius_factor: float | None = None, contact_point: str | float | Floats | None = None,
             between: str | Sequence[str] | None = None, existing: str | None = None,
             strength: Mapping[str, Any] | None = None, **parameters: Quantity | bool | Floats) -> int:
        """Bonds particles by a law (see laws()), and returns how many bonds that gave.

        Bonds form where spheres of contact_radius_factor times the radius touch, or within `gap`; where neither is
        given, the bonds that the model was made with get the law, or else touching spheres. `between`: a group, or two:
        one end in each. `existing`: what happens to a pair that is bonded already, "error", "skip" or "add".
        Parameters are the law's; of listed bonds, arrays (m,) in the order of the list give each its own.

        strength: when they break, for fracture(): dict(criterion="edem-v2", critical_normal_stress=5e6,
        critical_shear_stress=8e6), see strengths(); bonds without never do. Strengths are arrays likewise, or scatter:
        scatter="weibull", modulus=8 | "normal", variation=0.2 | "uniform", range=1e6, each with seed=1,
        together=False.
        """
        by_distance = gap is not None or (contact_radius_factor is not None and contact_point != "contact-radii")
        listed = self._core.listed_bonds is not None and not by_distance
        _need(not listed or self._core.listed_bonds != 0, "the model was made with an empty list of bonds",
              "leave bonds out, or give gap or contact_radius_factor, where they shall form by distance")
        given, columns = _arrays({"law": law, "gap": gap, "contact_radius_factor": contact_radius_factor,
                                  "contact_point": contact_point, "between": between, "existing": existing,
                                  **parameters})
        _need(listed or not columns, f"{', '.join(columns)}: an array, but no bonds are listed",
              "give one number for all, or make the model with bonds")
        strengths: dict[str, Floats] = {}
        if strength is not None:
            given["strength"], strengths = _strengths(strength)
            _need(listed or not strengths, f"strength: {', '.join(strengths)}: an array, but no bonds are listed",
                  "give one number for all and let it scatter, or make the model with bonds")
        added, said = self._core.bond(given, columns, strengths, listed)
        _warn(said)
        return added

    def fix(self, at: At = None, *, dofs: str | Sequence[str] | None = None,
            values: Mapping[str, Quantity] | None = None, case: str | None = None, **where: Quantity) -> None:
        """Holds degrees of freedom of the particles chosen by `at`, and by x_below, x_above, y_below, ... z_above.

        dofs    "all" (unless values are given), or some of "x", "y", "z", "rx", "ry", "rz"
        values  prescribed motions, {"z": -1e-4}: length, radians; those of dofs that are not named are zero
        case    the load case in which it holds; all of them unless named
        """
        if dofs is None and values is None:
            dofs = "all"
        table, positions = selector(self._core, at, where)
        _warn(self._core.fix({"at": table, "fix": dofs, "values": values, "case": case}, positions))

    def load(self, at: At = None, *, force: Sequence[Quantity] | Floats | None = None,
             moment: Sequence[Quantity] | Floats | None = None, total: bool = False,
             gravity: Sequence[Quantity] | Floats | None = None, strain: Mapping[str, float] | None = None,
             case: str | None = None, **where: Quantity) -> None:
        """Loads the particles chosen as in fix().

        force, moment  (3,), on each particle; total=True: in all, shared equally
        gravity        (3,), acceleration: on the chosen particles, or on all that have a density
        strain         of a periodic cell, tensor components: {"xx": 1e-3, "yz": 5e-4}
        case           name of the load case; a load without one is in all of them
        """
        table, positions = selector(self._core, at, where)
        prefix = "total_" if total else ""
        _warn(self._core.load({"at": table, prefix + "force": force, prefix + "moment": moment, "gravity": gravity,
                               "strain": strain, "case": case}, positions))

    def group(self, name: str, at: At = None, **where: Quantity) -> None:
        """Names particles chosen as in fix()."""
        table, positions = selector(self._core, at, where)
        self._core.group({"name": name, "at": table}, positions)

    def output(self, name: str, of: str, at: At = None, *, reduce: str | None = None, scale: float | None = None,
               case: str | None = None, bond: int | Sequence[int] | None = None, base: At = None, middle: At = None,
               axis: str | Sequence[float] | None = None, **where: Quantity) -> _core.Output:
        """Asks for a number, which Solution.outputs then tells.

        of      a column of particles ("uz", "reaction_fz"), of bonds ("normal_force"), "energy", "apparent_young", ...
        at      particles, as in fix(); `bond`: bonds, by ids (bond_ids, not rows)
        reduce  "value" of one, "sum", "mean" or "max" of several
        base, axis  of apparent_young and apparent_poisson: the platen that stands still, and from it to `at`
        middle      of apparent_poisson: where the sides are measured; the middle third unless given
        """
        made = self._output({"name": name, "of": of, "reduce": reduce, "scale": scale, "case": case, "axis": axis,
                             "bond": bond}, {"at": at, "base": base, "middle": middle}, where)
        self.outputs = [other for other in self.outputs if other.name != name] + [made]
        return made

    def _output(self, given: dict[str, Any], places: Mapping[str, At], where: Mapping[str, Any]) -> _core.Output:
        """`bond` and `where` say more of the place "at"."""
        bond = given.pop("bond", None)
        chosen = {key: selector(self._core, at, where if key == "at" else {}) for key, at in places.items()}
        tables: dict[str, Any] = {key: table for key, (table, _) in chosen.items()}
        if bond is not None:
            tables["at"] = {**(tables["at"] or {}), "bond": bond}
        return self._core.output({**given, **tables}, {key: positions for key, (_, positions) in chosen.items()})

    def set(self, *, block: int | None = None, **parameters: Quantity | Floats) -> None:
        """Changes parameters of the laws: of one block of bonds, or of all whose law takes them. Arrays give each bond
        of the block its own."""
        if block is not None and block < 0:
            raise IndexError(f"there is no block {block}, the model has {len(self.laws)}")
        given, columns = _arrays(parameters)
        self._core.set(given, columns, -1 if block is None else block)

    def parameters(self, block: int = 0) -> dict[str, Any]:
        """Parameters of a block of bonds by name; arrays where bonds have their own."""
        return self._core.parameters(block)


def _arrays(given: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, Floats]]:
    """What counts for all bonds, and values of single ones."""
    for_all, columns = {}, {}
    for name, value in given.items():
        array = None if value is None or isinstance(value, (str, bool, Mapping)) else np.asarray(value)
        if array is not None and array.ndim == 1 and array.dtype.kind in "iuf":
            columns[name] = array.astype(np.float64)
        else:
            for_all[name] = value.item() if isinstance(value, np.ndarray) and value.ndim == 0 else value
    return for_all, columns


def _strengths(given: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, Floats]]:
    """The same of a strength: single bonds have strengths of their own, but all scatter alike."""
    criterion = _core.strengths().get(given.get("criterion", ""))
    names = [parameter.name for parameter in criterion.parameters] if criterion else []
    columns = _arrays({name: value for name, value in given.items() if name in names})[1]
    return {name: value for name, value in given.items() if name not in columns}, columns


def _need(sound: bool, found: str, cure: str) -> None:
    if not sound:
        raise InputError(f"{found}\n    cure: {cure}")


def _of_each(values: npt.ArrayLike, name: str, count: int) -> Floats:
    array = np.asarray(values, dtype=np.float64)
    _need(array.shape in ((), (count,)), f"{name} of shape {array.shape} for {count} particles",
          "give one number for all, or one for each")
    return np.ascontiguousarray(np.broadcast_to(array, (count,)))


def _whole(values: npt.ArrayLike, name: str, shape: tuple[int, ...]) -> Ints:
    """Whole numbers of that shape, where -1 stands for any length; an empty list is one of none."""
    array = np.asarray(values)
    if array.size == 0:
        return np.empty([max(length, 0) for length in shape], dtype=np.int64)
    fits = array.ndim == len(shape) and all(n in (-1, m) for n, m in zip(shape, array.shape))
    _need(fits, f"{name} of shape {array.shape}", f"give them as {str(shape).replace('-1', 'm')}")
    _need(array.dtype.kind in "iu", f"{name} of type {array.dtype}", "give whole numbers")
    return np.ascontiguousarray(array, dtype=np.int64)


def _warn(said: Sequence[str]) -> None:
    for text in said:
        warnings.warn(text, BondstaticWarning, stacklevel=3)
