"""Calibration: parameters of the bonds' laws that make outputs what was measured."""
from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Union

import numpy as np

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
              loss: str | None = None, most_evaluations: int | None = None,
              progress: CalibrationProgress = None) -> _core.Calibration:
    """Least squares with exact derivatives, in a handful of solves.

    what        a case file with [calibration]; or a model with outputs, or several tests by name
    parameters  of a model: {"young": (1e9, 1e12)}, {"bonds.0.poisson": {"min": 0, "max": 0.4, "start": 0.2,
                "scale": "linear"}}
    targets     of a model: {"stiffness": 35e9}, (35e9, 1e8) with its standard deviation, or
                {"wanted": .., "tolerance": .., "weight": .., "case": "name of the test"}
    set         of a case file: values of its keys
    loss        of a model: "squares" unless given, "huber" or "cauchy"
    most_evaluations  of a model: 50 unless given
    progress    called with the number of each evaluation and its cost

    Calibration.values are what was found; .reached, .reason, .unidentified say what it is worth.
    """
    if isinstance(what, (str, os.PathLike)):
        if any(given is not None for given in (parameters, targets, loss, most_evaluations)):
            raise InputError("parameters, targets, loss and most_evaluations stand in the case file\n"
                             "    cure: give a model instead of a file, or change the case by set")
        path = os.fspath(what)
        result = _core.calibrate_case(case_file(path) or path, overrides(set), progress)
    else:
        tests: Mapping[str, Model] = {"": what} if isinstance(what, Model) else what
        if set is not None:
            raise InputError("set changes keys of a case file, and a model was given\n    cure: use Model.set()")
        loss = "squares" if loss is None else loss
        if loss not in ("squares", "huber", "cauchy"):
            raise InputError(f'loss = "{loss}" is unknown\n    cure: write "squares", "huber" or "cauchy"')
        ready = [(name, test._ready()) for name, test in tests.items()]
        result = _core.calibrate_models([(name, test._core, test._solve, test.outputs) for name, test in ready],
                                        [_parameter(name, bounds) for name, bounds in (parameters or {}).items()],
                                        [_target(name, target) for name, target in (targets or {}).items()],
                                        _core.CalibrationOptions(loss, 50 if most_evaluations is None else most_evaluations),
                                        progress)
    _warn(result.warnings)
    return result


def _parameter(name: str, bounds: Bounds) -> _core.CalibrationParameter:
    given: Mapping[str, Any] = bounds if isinstance(bounds, Mapping) else _pair(bounds, ("min", "max"), name)
    _only(given, ("min", "max", "start", "scale"), name)
    lower, upper = _number(given, "min", name), _number(given, "max", name)
    scale = given.get("scale", "log" if lower > 0 else "linear")
    if scale not in ("log", "linear"):
        raise InputError(f'{name}: scale = "{scale}" is unknown\n    cure: write "log" or "linear"')
    return _core.CalibrationParameter(name, lower, upper, _number(given, "start", name), scale == "log")


def _target(output: str, target: Target) -> _core.CalibrationTarget:
    if isinstance(target, Mapping):
        given: Mapping[str, Any] = target
    elif np.ndim(target) > 0:
        given = _pair(target, ("wanted", "tolerance"), output)
    else:
        given = {"wanted": target}
    _only(given, ("output", "case", "wanted", "tolerance", "weight"), output)
    return _core.CalibrationTarget(given.get("output", output), given.get("case", ""), _number(given, "wanted", output),
                                   _number(given, "tolerance", output), _number({"weight": 1, **given}, "weight", output))


def _pair(values: Any, keys: tuple[str, str], name: str) -> dict[str, Any]:
    if len(values) != 2:
        raise InputError(f"{name}: {len(values)} numbers\n    cure: give {keys[0]} and {keys[1]}")
    return dict(zip(keys, values))


def _number(given: Mapping[str, Any], key: str, name: str) -> float:
    value = given.get(key, math.nan)
    try:
        return float(value)
    except (TypeError, ValueError):
        raise InputError(f"{name}: {key} = {value!r} is no number\n    cure: give a number, in the model's units") from None


def _only(given: Mapping[str, Any], allowed: Sequence[str], name: str) -> None:
    unknown = [key for key in given if key not in allowed]
    missing = [key for key in ("min", "max") if key in allowed and key not in given]
    missing += [key for key in ("wanted",) if key in allowed and key not in given]
    if unknown or missing:
        raise InputError(f"{name}: {'unknown ' + ', '.join(unknown) if unknown else 'no ' + ', '.join(missing)}\n"
                         f"    cure: give some of {', '.join(allowed)}")
