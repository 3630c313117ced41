"""What goes wrong, as exceptions with the text that the command line prints."""
from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Fault:
    """One thing that is wrong with the input; line and column count from 1, 0 where there is none."""

    file: str
    line: int
    column: int
    message: str
    cure: str


@dataclass(frozen=True)
class Mechanism:
    """Particles that can move without energy."""

    kind: str  # "isolated", "floating", "underconstrained" or "internal"
    particles: list[int]  # rows of Model.x
    motions: int  # independent ones


class Error(Exception):
    """Any error of bondstatic; `exit_code` is what the command line ends with."""

    def __init__(self, message: str, exit_code: int = 1):
        super().__init__(message)
        self.exit_code = exit_code


class InputError(Error, ValueError):
    """The input is invalid; `faults` lists everything that is wrong with it, where it could be told."""

    def __init__(self, message: str, exit_code: int = 2):
        super().__init__(message, exit_code)
        self.faults: list[Fault] = []


class MechanismError(Error):
    """The model can move without energy; `mechanisms` says which particles."""

    def __init__(self, message: str, exit_code: int = 3):
        super().__init__(message, exit_code)
        self.mechanisms: list[Mechanism] = []


class AccuracyError(Error, ArithmeticError):
    """The asked accuracy was not reached, or a run blew up."""


class OutOfMemoryError(Error, MemoryError):
    """It would not fit in memory; said before anything large is allocated."""


class BondstaticWarning(UserWarning):
    """What the command line says as a warning."""
