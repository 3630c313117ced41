"""The static answer."""
from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any, Union

import numpy as np

from . import _core
from .errors import InputError
from .model import Floats, Model, Quantity, _warn
from .selection import At

OutputLike = Union[str, _core.Output]
#: Called with the name of each phase as it begins; what it raises ends the solve.
Progress = Union[Callable[[str], object], None]


class States:
    """The states of several load cases; with a single one, its fields are those of this object, too."""

    def __init__(self, names: Sequence[str], states: Sequence[_core.State]):
        #: States by the name of their load case.
        self.cases: dict[str, _core.State] = dict(zip(names, states))

    def __getitem__(self, load_case: str) -> _core.State:
        if load_case not in self.cases:
            raise KeyError(f'there is no load case "{load_case}"; there are: {", ".join(self.cases)}')
        return self.cases[load_case]

    def __iter__(self) -> Iterator[str]:
        return iter(self.cases)

    def __len__(self) -> int:
        return len(self.cases)

    def _only(self) -> _core.State:
        if len(self.cases) != 1:
            raise InputError(f"there are {len(self.cases)} load cases: {', '.join(self.cases)}\n"
                             '    cure: say which is meant: solution["NAME"].displacement')
        return next(iter(self.cases.values()))

    def _position(self, load_case: str | None) -> int:
        """Of a load case, the only one unless named."""
        if load_case is None:
            self._only()
            return 0
        self[load_case]
        return list(self.cases).index(load_case)

    @property
    def displacement(self) -> Floats:
        """(n, 6): ux, uy, uz in length, rx, ry, rz in radians; read-only view without a copy, NaN where left out."""
        return self._only().displacement

    @property
    def rotation(self) -> Floats:
        """(n, 3), radians: the last three columns of displacement."""
        return self._only().rotation

    @property
    def reaction(self) -> Floats:
        """(n, 6): what the support does to the particle, force and force x length; zero where free."""
        return self._only().reaction

    @property
    def bonds(self) -> _core.Bonds:
        """What the bonds carry: force, moment, normal_force, shear_force, ..., sigma, tau, energy."""
        return self._only().bonds

    @property
    def energy(self) -> float:
        """Strain energy, force x length."""
        return self._only().energy

    @property
    def work(self) -> float:
        """Of loads, moved supports and the cell's strain, through the whole motion."""
        return self._only().work

    @property
    def strain(self) -> Floats:
        """(3, 3): mean strain of a periodic cell, tensor components."""
        return self._only().strain

    @property
    def stress(self) -> Floats:
        """(3, 3), force / length^2: mean stress of a periodic cell, tension positive."""
        return self._only().stress


class Solution(States):
    """The static answer of a model, and what it depends on. It keeps the model that it is of, whatever becomes of
    the one that was solved."""

    def __init__(self, model: Model, solved: _core.Solved, analysis: _core.Analysis | None):
        names = solved.load_cases
        super().__init__(names, [solved.state(c) for c in range(len(names))])
        self._solved = solved
        self._analysis = analysis
        #: As it was solved.
        self.model = model
        #: Solver, threads, unknowns, seconds by phase, peak_bytes, dropped bodies (ids), warnings, ...
        self.report: dict[str, Any] = solved.report

    def __repr__(self) -> str:
        return (f"<bondstatic.Solution: {len(self.model)} particles, {len(self.model.bond_ids)} bonds, "
                f"load cases {list(self)}, by {self.report['solver']}>")

    @property
    def accuracy(self) -> dict[str, float]:
        """backward_error, forward_error (a bound on the largest displacement's relative error), balances."""
        return self._only().accuracy

    @property
    def effective(self) -> dict[str, Any] | None:
        """Of a periodic cell under six strains: stiffness (6, 6), young, poisson, misfit, voigt (6, 6), volume."""
        return self._solved.effective

    @property
    def outputs(self) -> dict[str, float]:
        """The model's outputs by name."""
        values = self._solved.evaluate(self.model.outputs)
        return {output.name: value for output, value in zip(self.model.outputs, values)}

    def value(self, of: str, at: At = None, *, reduce: str | None = None, case: str | None = None,
              bond: int | Sequence[int] | None = None, **where: Quantity) -> float:
        """A number that is no output of the model; arguments as in Model.output()."""
        return self._solved.evaluate([self._asked(of, at, reduce, case, bond, where)])[0]

    def sensitivity(self, output: OutputLike, parameters: str | Sequence[str], *, by: str = "global", at: At = None,
                    reduce: str | None = None, case: str | None = None, bond: int | Sequence[int] | None = None,
                    **where: Quantity) -> dict[str, Any]:
        """Exact derivatives of a number with respect to parameters of the bonds' laws, by the adjoint method.

        output      an Output, the name of one, or a quantity as in Model.output() with at, reduce, case and bond: with
                    any of them it is a quantity. "reaction_z" stands for the sum of all reactions, "reaction_fz"
        parameters  "young" of all blocks that give it, or "bonds.0.young" of one
        by          "global": one number each; "block": a dict by block, {"bonds.0.young": ..}; "bond": an array (m,),
                    with respect to each bond's own value, NaN for bonds without. Where bonds were given values of
                    their own, only "bond" counts these

        The first call after solve() factorises again; an Analysis has its factor at hand.
        """
        asked = self._chosen(output, at, reduce, case, bond, where)
        names = [parameters] if isinstance(parameters, str) else list(parameters)
        analysis = self._kept_analysis()
        if by == "bond":
            return {name: analysis.derivatives_by_bond(self._solved, [asked], name)[0] for name in names}
        if by == "block":
            keys = {name: _core.keys(self._solved, name) for name in names}
            flat = [key for of_name in keys.values() for key in of_name]
            values = dict(zip(flat, analysis.derivatives(self._solved, [asked], flat)[0]))
            return {name: {key: values[key] for key in keys[name]} for name in names}
        if by != "global":
            raise InputError(f'by = "{by}" is unknown\n    cure: write "global", "block" or "bond"')
        return dict(zip(names, analysis.derivatives(self._solved, [asked], names)[0]))

    def jacobian(self, outputs: OutputLike | Sequence[OutputLike], parameters: str | Sequence[str]) -> Floats:
        """(outputs, parameters): exact derivatives, all of them from one pass over the factor."""
        of = [outputs] if isinstance(outputs, (str, _core.Output)) else outputs
        asked = [self._chosen(output, None, None, None, None, {}) for output in of]
        names = [parameters] if isinstance(parameters, str) else list(parameters)
        values = self._kept_analysis().derivatives(self._solved, asked, names)
        return np.array(values).reshape(len(asked), len(names))

    def _kept_analysis(self) -> _core.Analysis:
        if self._analysis is None:
            self._analysis = _core.Analysis(self._solved.options)
        return self._analysis

    def _chosen(self, output: OutputLike, at: At, reduce: str | None, case: str | None,
                bond: int | Sequence[int] | None, where: dict[str, Quantity]) -> _core.Output:
        asks_itself = at is not None or bool(reduce or case or where) or bond is not None
        if isinstance(output, _core.Output):
            if asks_itself:
                raise InputError(f"{output!r} says itself which particles are meant\n    cure: leave out at, reduce, case, "
                                 "bond and places, or name the quantity in place of the Output")
            return output
        for known in self.model.outputs:
            if known.name == output and not asks_itself:
                return known
        return self._asked(output, at, reduce, case, bond, where)

    def _asked(self, of: str, at: At, reduce: str | None, case: str | None, bond: int | Sequence[int] | None,
               where: dict[str, Quantity]) -> _core.Output:
        if of in ("reaction_x", "reaction_y", "reaction_z"):
            of = "reaction_f" + of[-1]
            if at is None and not where:
                at, reduce = {"all": True}, reduce or "sum"
        given = {"name": of, "of": of, "reduce": reduce, "case": case, "bond": bond}
        return self.model._output(given, {"at": at}, where)


def solve(model: Model, *, solver: str | None = None, threads: int | None = None, tolerance: float | None = None,
          unsupported: str | None = None, memory_limit: float | str | None = None,
          backend_options: Sequence[str] | None = None, progress: Progress = None) -> Solution:
    """The static answer. Other threads run meanwhile, and Ctrl-C ends it.

    solver       one of solvers(), or "auto"
    threads      at most; 0: the cores at hand. The answer does not depend on it
    tolerance    on the backward error
    unsupported  "error" or "drop": what happens to bodies that no support touches
    memory_limit bytes, or "8 GB"
    progress     called with the name of each phase as it begins

    What is not given is as in the model's case file.
    """
    options = _options(model, solver, threads, tolerance, unsupported, memory_limit, backend_options)
    ready = model._ready()
    solution = Solution(ready, _core.solve(ready._core, options, progress), None)
    _warn(solution.report["warnings"])
    return solution


class Analysis:
    """Solves a model again and again on one analysis of its pattern: parameters of laws, loads and prescribed values
    may change in between. Its last solution has the factor at hand for sensitivities. Options as of solve()."""

    def __init__(self, model: Model, *, solver: str | None = None, threads: int | None = None,
                 tolerance: float | None = None, unsupported: str | None = None,
                 memory_limit: float | str | None = None, backend_options: Sequence[str] | None = None):
        #: To be changed between solves.
        self.model = model
        self._analysis = _core.Analysis(
            _options(model, solver, threads, tolerance, unsupported, memory_limit, backend_options))

    def solve(self, *, progress: Progress = None) -> Solution:
        """The answer for the model as it is now."""
        ready = self.model._ready()
        solution = Solution(ready, self._analysis.solve(ready._core, progress), self._analysis)
        _warn(solution.report["warnings"])
        return solution


def _options(model: Model, solver: str | None, threads: int | None, tolerance: float | None, unsupported: str | None,
             memory_limit: float | str | None, backend_options: Sequence[str] | None) -> _core.SolveOptions:
    return model._solve.with_({"solver": solver, "threads": threads, "tolerance": tolerance, "unsupported": unsupported,
                               "memory_limit": memory_limit, "backend_options": backend_options})
