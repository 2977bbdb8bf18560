"""The formats of a report: one module each, found by being here.

A format has `judged(report, colour=…)`, which returns the whole output of `check` as text, and may
have `measured(report, colour=…)`, the output of `measure`. One whose lines are read by a machine out
of whatever stands around them says `BESIDE = True`, and may go to the same place as another format.
"""

import pkgutil
from functools import cache
from importlib import import_module
from types import ModuleType

from audio_checks.findings import Report


@cache
def formats() -> tuple[str, ...]:
    """Return the names of all formats."""
    return tuple(sorted(module.name for module in pkgutil.iter_modules(__path__)))


@cache
def measured_formats() -> tuple[str, ...]:
    """Return the names of the formats that `measure` can be shown in."""
    return tuple(name for name in formats() if hasattr(_module(name), "measured"))


def judged_as(name: str, report: Report, *, colour: bool = False) -> str:
    """Return a report in a format."""
    text: str = _module(name).judged(report, colour=colour)
    return text


def measured_as(name: str, report: Report, *, colour: bool = False) -> str:
    """Return figures in a format."""
    text: str = _module(name).measured(report, colour=colour)
    return text


def goes_beside(name: str) -> bool:
    """Tell whether a format may share its place with another."""
    return getattr(_module(name), "BESIDE", False)


def help_of(kind: str) -> str:
    """Return what `--format` says of itself for `judged` or `measured` reports."""
    names = formats() if kind == "judged" else measured_formats()
    return f"{', '.join(names)}; to a file if one is named; may be repeated"


def _module(name: str) -> ModuleType:
    return import_module(f"{__name__}.{name}")
