"""The formats of a report: one module each, found by being here.

A format has `judged(report, style)`, which returns the whole output of `check` as text, and may have
`measured(report, style)`, the output of `measure`. One whose lines are read by a machine out of
other text has `SHARES_OUTPUT = True`, and may go to the same place as another format.
"""

import pkgutil
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from types import ModuleType

from audio_checks.report.findings import Report
from audio_checks.spec.check_names import Severity


@dataclass(frozen=True)
class Style:
    """The look of a report: coloured or not, the mildest severity that fails, line breaks for people, summed up.

    Without `columns` no line is wrapped, so that a search in a log finds whole sentences.
    """

    colour: bool = False
    fail_level: Severity = "error"
    columns: int | None = None
    summary: bool = True

    @property
    def failing(self) -> tuple[Severity, ...]:
        """The severities that fail."""
        return ("error", "warning") if self.fail_level == "warning" else ("error",)


@cache
def formats() -> tuple[str, ...]:
    """Return the names of all formats."""
    return tuple(sorted(module.name for module in pkgutil.iter_modules(__path__)))


@cache
def measured_formats() -> tuple[str, ...]:
    """Return the names of the formats that `measure` can be shown in."""
    return tuple(name for name in formats() if hasattr(_module(name), "measured"))


def judged_as(name: str, report: Report, style: Style) -> str:
    """Return a report in a format."""
    text: str = _module(name).judged(report, style)
    return text


def measured_as(name: str, report: Report, style: Style) -> str:
    """Return figures in a format."""
    text: str = _module(name).measured(report, style)
    return text


def goes_beside(name: str) -> bool:
    """Return whether a format may share its place with another."""
    return getattr(_module(name), "SHARES_OUTPUT", False)


def _module(name: str) -> ModuleType:
    return import_module(f"{__name__}.{name}")
