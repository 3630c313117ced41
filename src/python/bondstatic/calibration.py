"""Calibration: parameters of the bonds' laws that make outputs what was measured."""
from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Union

from . import _core
from .errors import InputError
from .model import Model, _warn
from .reading import case_file, overrides

#: Called with the number of each evaluation and its cost.
CalibrationProgress = Union[Callable[[int, float], object], None]
#: Bounds, and where they are not the whole story: start, scale.
Bounds = Union[tuple[float, float], Mapping[str, Any]]
#: The value wanted, with its standard deviation, or all that [[calibration.targets]] takes.
Target = Union[float, tuple[float, float], Mapping[str, Any]]


def calibrate(what: str | os.PathLike[str] | Model | Mapping[str, Model],
              parameters: Mapping[str, Bounds] | None = None,
              targets: Mapping[str, Target] | None = None, *, set: Mapping[str, Any] | None = None,
              loss: str = "squares", most_evaluations: int = 50,
              progress: CalibrationProgress = None) -> _core.Calibration:
    """Least squares with exact derivatives, in a handful of solves.

    what        a case file with [calibration]; or a model with outputs, or several tests by name
    parameters  of a model: {"young": (1e9, 1e12)}, {"bonds.0.poisson": {"min": 0, "max": 0.4, "start": 0.2,
                "scale": "linear"}}
    targets     of a model: {"stiffness": 35e9}, (35e9, 1e8) with its standard deviation, or
                {"wanted": .., "tolerance": .., "weight": .., "case": "name of the test"}
    set         of a case file: values of its keys
    loss        "squares", "huber" or "cauchy"

    Calibration.values are what was found; .reached, .reason, .unidentified say what it is worth.
    """
    if isinstance(what, (str, os.PathLike)):
        if parameters is not None or targets is not None:
            raise InputError("parameters and targets stand in the case file\n    cure: give a model instead of a file, "
                             "or change the case by set")
        path = os.fspath(what)
        result = _core.calibrate_case(case_file(path) or path, overrides(set), progress)
    else:
        tests: Mapping[str, Model] = {"": what} if isinstance(what, Model) else what
        if loss not in ("squares", "huber", "cauchy"):
            raise InputError(f'loss = "{loss}" is unknown\n    cure: write "squares", "huber" or "cauchy"')
        ready = [(name, test._ready()) for name, test in tests.items()]
        result = _core.calibrate_models([(name, test._core, test._solve, test.outputs) for name, test in ready],
                                        [_parameter(name, bounds) for name, bounds in (parameters or {}).items()],
                                        [_target(name, target) for name, target in (targets or {}).items()],
                                        _core.CalibrationOptions(loss, most_evaluations), progress)
    _warn(result.warnings)
    return result


def _parameter(name: str, bounds: Bounds) -> _core.CalibrationParameter:
    given: Mapping[str, Any] = bounds if isinstance(bounds, Mapping) else {"min": bounds[0], "max": bounds[1]}
    _only(given, ("min", "max", "start", "scale"), name)
    lower, upper = float(given["min"]), float(given["max"])
    scale = given.get("scale", "log" if lower > 0 else "linear")
    return _core.CalibrationParameter(name, lower, upper, float(given.get("start", math.nan)), scale == "log")


def _target(output: str, target: Target) -> _core.CalibrationTarget:
    if isinstance(target, Mapping):
        given: Mapping[str, Any] = target
    elif isinstance(target, Sequence):
        given = {"wanted": target[0], "tolerance": target[1]}
    else:
        given = {"wanted": target}
    _only(given, ("output", "case", "wanted", "tolerance", "weight"), output)
    return _core.CalibrationTarget(given.get("output", output), given.get("case", ""), float(given["wanted"]),
                                   float(given.get("tolerance", math.nan)), float(given.get("weight", 1)))


def _only(given: Mapping[str, Any], allowed: Sequence[str], name: str) -> None:
    unknown = [key for key in given if key not in allowed]
    missing = [key for key in ("min", "max") if key in allowed and key not in given]
    missing += [key for key in ("wanted",) if key in allowed and key not in given]
    if unknown or missing:
        raise InputError(f"{name}: {'unknown ' + ', '.join(unknown) if unknown else 'no ' + ', '.join(missing)}\n"
                         f"    cure: give some of {', '.join(allowed)}")
