"""Which bond breaks first, at what load, and what follows: quasi-static fracture without time."""
from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping
from typing import Any, Union

from . import _core
from .errors import InputError
from .model import Floats, Ints, Model, Quantity, _warn
from .reading import case_file, model_of
from .solution import _options

#: Called after every event with the numbers of events and of broken bonds, factor, load, displacement.
FractureProgress = Union[Callable[[int, int, float, float, float], object], None]
#: Called with the number of events so far, the state, and the event of each bond as in Fracture.break_event.
OnState = Union[Callable[[int, _core.State, Ints], object], None]


class Fracture:
    """What broke, when, and what is left. It keeps the model that it is of."""

    def __init__(self, model: Model, fractured: _core.Fractured):
        #: As it was broken.
        self.model = model
        #: One row an event: factor, load, displacement, load_after, ..., released, dissipated, avalanche.
        self.events: _core.FractureEvents = fractured.events
        #: One row a broken bond: event, row, id, mode, utilisation.
        self.broken: _core.BrokenBonds = fractured.broken
        #: (m,): row of the event in which a bond broke; -1: it is whole.
        self.break_event: Ints = fractured.break_event
        #: Bodies that hung on nothing any more, and since when.
        self.separated: list[_core.SeparatedBody] = fractured.separated
        #: What ended it: "breaks", "factor", "displacement", "load drop", "separated", "unbreakable", "mechanism" or
        #: "interrupted".
        self.end: str = fractured.end
        #: One sentence.
        self.reason: str = fractured.reason
        #: After the last event; broken bonds carry zero. last.bonds.utilisation says what comes next.
        self.last: _core.State = fractured.last
        #: The model's outputs by name, just before each event.
        self.outputs: dict[str, Floats] = fractured.outputs
        #: solver, threads, factorisations, backward_error, forward_error, energy_balance, seconds, dropped, ...
        self.report: dict[str, Any] = fractured.report

    def __repr__(self) -> str:
        return f"<bondstatic.Fracture: {len(self.broken)} bonds in {len(self.events)} events, {self.end}: {self.reason}>"


def fracture(what: Model | str | os.PathLike[str], *, pattern: str | None = None, preload: str | None = None,
             control: str | None = None, max_breaks: int | None = None, max_factor: float | None = None,
             max_displacement: Quantity | None = None, load_drop: float | None = None, tie: float | None = None,
             save_every: int | None = None, set: Mapping[str, Any] | None = None, solver: str | None = None,
             threads: int | None = None, tolerance: float | None = None, unsupported: str | None = None,
             memory_limit: float | str | None = None, progress: FractureProgress = None, on_state: OnState = None,
             checkpoint: str | os.PathLike[str] | None = None, checkpoint_every: float = 60.0,
             resume: bool = False) -> Fracture:
    """Scales a load case until a bond breaks, takes that bond out, solves again, and so on: bonds need a `strength`
    (Model.bond()). Between two breaks the state is linear, so each factor has one exact value.

    what      a model, or a case file with `set`: values of its keys
    pattern   load case that scales; the only one, or the only one beside the preload, unless named
    preload   load case that stays
    control   what never falls: "event" (nothing: the factor is always what brings the next bond to its strength, so the
              curve shows snap-back), "load" (dead weights) or "displacement" (a stiff machine)
    max_breaks, max_factor, max_displacement, load_drop   where it ends; load_drop is a part of the largest load, 1: none
    tie       bonds break together whose utilisations differ by no more than this part: 1e-9
    solver, threads, tolerance, unsupported, memory_limit   as of solve(); the answer does not depend on threads
    progress  called after every event; where it returns False the run ends with what was found
    on_state  called with the state at the first event, while all is whole, after every `save_every` breaks, and the last
    checkpoint, checkpoint_every, resume   a file that keeps the run, renewed every so many seconds and when it is
              stopped; with resume=True a run goes on from there, to the same bits. Gone when the run has come to its end

    What is not given is as in [fracture] of the model's case file, whose limits math.inf takes away. Other threads run
    meanwhile. Once a bond has broken, Ctrl-C ends the run with what was found (end == "interrupted", and a warning); a
    second Ctrl-C raises KeyboardInterrupt.
    """
    asked = {"pattern": pattern, "preload": preload, "control": control, "max_breaks": max_breaks,
             "max_factor": max_factor, "max_displacement": max_displacement, "load_drop": load_drop, "tie": tie,
             "save_every": save_every}
    if not (isinstance(checkpoint_every, (int, float)) and checkpoint_every >= 0):
        raise InputError(f"checkpoint_every = {checkpoint_every!r} must not be negative\n    cure: give seconds")
    if isinstance(what, Model):
        if set is not None:
            raise InputError("set changes keys of a case file, and a model was given\n    cure: use Model.set()")
        model = what
    else:
        path = os.fspath(what)
        finite = {f"fracture.{key}": value for key, value in asked.items() if value is not None and value != math.inf}
        model = model_of(case_file(path) or path, {**(set or {}), **finite}, for_fracture=True)
    ready = model._ready()
    fractured = _core.fracture(ready._core, ready._fracture.with_(asked),
                               _options(ready, solver, threads, tolerance, unsupported, memory_limit, None),
                               ready.outputs, progress, on_state, os.fspath(checkpoint or ""), checkpoint_every, resume)
    _warn(fractured.warnings)
    return Fracture(ready, fractured)
