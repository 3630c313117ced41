"""Results as one HTML file to look at."""
from __future__ import annotations

import os
from collections.abc import Iterable

from . import _core
from .errors import InputError


def report(folders: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
           file: str | os.PathLike[str] = "report.html") -> _core.Report:
    """Shows what commands wrote into one folder or several, side by side, in one HTML file for any browser.

    folders  of results: --out of any command
    file     is replaced where it is a report, and appears whole or not at all; any other file is left alone

    Report.notes says what it leaves out; webbrowser.open(os.path.abspath(report)) opens it.
    """
    paths = [folders] if isinstance(folders, (str, os.PathLike)) else folders
    names = [os.fspath(path) for path in paths]
    if not names:
        raise InputError("there are no folders to report of\n    cure: name the folder that --out gave to a command")
    return _core.report(names, os.fspath(file))
