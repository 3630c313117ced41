"""The explicit run to rest."""
from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, Union

from . import _core
from .errors import InputError
from .model import Floats, Model, _warn
from .solution import States

#: Called now and then with load case, step, unbalanced force over loads, fastest speed.
RunProgress = Union[Callable[[str, int, float, float], object], None]
#: Called with the time, the state and the velocities of the particles (n, 3); state.name is the load case.
OnWay = Union[Callable[[float, _core.State, Floats], object], None]


class Relaxation(States):
    """Where an explicit run has ended."""

    def __init__(self, model: Model, relaxed: _core.Relaxed):
        names = relaxed.load_cases
        super().__init__(names, [relaxed.state(c) for c in range(len(names))])
        self._relaxed = relaxed
        #: As it was run.
        self.model = model
        #: Every load case is.
        self.at_rest: bool = relaxed.at_rest
        #: By load case: at_rest, steps, time, time_step, critical_time_step, predicted_steps, seconds, ...
        self.reports: dict[str, dict[str, Any]] = {name: relaxed.report(c) for c, name in enumerate(names)}

    def __repr__(self) -> str:
        return f"<bondstatic.Relaxation: {'' if self.at_rest else 'not '}at rest, load cases {list(self)}>"

    def history(self, load_case: str | None = None) -> dict[str, Floats]:
        """Columns over time: step, time, kinetic, strain, work, dissipated, unbalanced, ... of a load case, the only
        one unless named."""
        return self._relaxed.history(self._position(load_case))


def relax(model: Model, *, threads: int | None = None, load_factor: float = 1.0, progress: RunProgress = None,
          on_state: OnWay = None, **dynamics: Any) -> Relaxation:
    """The model through time to rest: explicit DEM. Every particle needs a density. Ctrl-C ends it.

    threads      at most; the answer does not depend on it
    load_factor  times all loads and prescribed motions
    on_state     called with the states on the way that save_interval=.. asks for, the first and the last among them
    dynamics     as in [dynamics] of a case file: kinematics="small", particle_damping=0.7, ramp_time=.., max_steps=..;
                 what is not given is as in the model's case
    """
    ready = model._ready()
    if not math.isfinite(load_factor):
        raise InputError(f"load_factor = {load_factor} must be finite\n    cure: write load_factor=1.0")
    if on_state is None and "save_interval" in dynamics:
        raise InputError("save_interval without on_state: nothing would hear of the states\n    cure: give on_state=..")
    options = ready._relax.with_(dynamics)
    solve = ready._solve.with_({"threads": threads})
    relaxation = Relaxation(ready, _core.relax(ready._core, options, solve, load_factor, progress, on_state))
    _warn(relaxation._relaxed.warnings)
    return relaxation
