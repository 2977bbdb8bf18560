"""The checks that the format of a spec knows, read from the checks' own files, none of which is imported here.

A check states beside its functions what others need of it: `SEVERITY` by default; `OVER_FILES` where it judges files
together; `LIMITS`, keys of the table `limits` that it holds files to, each with the least and greatest value and, where
it is not that of the check, its label.
"""

import ast
import pkgutil
import re
from functools import cache
from pathlib import Path
from typing import Any, Literal

from audio_checks import version

Severity = Literal["error", "warning", "information"]
GRAVITY: dict[Severity, int] = {"error": 0, "warning": 1, "information": 2}  # the gravest first
Level = Literal["error", "warning", "off"]

CHECKS = Path(version.__file__).with_name("checks")
# The order of lists and reports. A check that is not among them comes after them, by its name; a name without a file
# is kept for a later version, so that a spec written for one is understood.
ORDER: tuple[str, ...] = (
    "structure", "container", "encoding", "sample-rate", "bit-depth", "channels", "duration", "naming", "sample-peak",
    "true-peak", "loudness", "dc-offset", "silence", "low-level", "head-silence", "tail-silence", "internal-silence",
    "noise-floor", "clipping", "placeholder", "cut-start", "cut-tail", "click", "dropout", "hum", "false-stereo",
    "phase", "loop-points", "padded-bits", "metadata", "duplicate", "variation-set", "baked-reverb", "reversed",
    "upsampled", "lossy",
)  # fmt: skip
STATED = re.compile(r"^(SEVERITY|OVER_FILES|LIMITS) = (.+?)(?:  #.*)?$", re.MULTILINE)  # each on one line


@cache
def _stated() -> dict[str, dict[str, Any]]:
    """Return each `checks` module's statements, by the name of its check; a module without a severity is none."""
    by_name: dict[str, dict[str, Any]] = {}
    for module in pkgutil.iter_modules([str(CHECKS)]):
        source = (CHECKS / f"{module.name}.py").read_text(encoding="utf-8")
        stated = {name: ast.literal_eval(value) for name, value in STATED.findall(source)}
        if "SEVERITY" in stated:
            by_name[module.name.replace("_", "-")] = stated
    return by_name


@cache
def present() -> frozenset[str]:
    """Return the names of the checks in this version: one module of `checks` each."""
    return frozenset(_stated())


DEFAULT_SEVERITY: dict[str, Severity] = {
    name: _stated().get(name, {}).get("SEVERITY", "error") for name in [*ORDER, *sorted(present() - set(ORDER))]
}
# What they find depends on what else was delivered, before and after: no file can be returned for it.
OVER_FILES = frozenset(name for name, stated in _stated().items() if stated.get("OVER_FILES"))
LIMITS_OF_CHECKS: dict[str, tuple[float, float]] = {
    key: (bounds[0], bounds[1])
    for name in DEFAULT_SEVERITY
    for key, bounds in _stated().get(name, {}).get("LIMITS", {}).items()
}
