"""The names of checks: those the spec's format knows, and those this version can run.

A name is part of the format from the first release, so that a spec written for a later version
is understood, and a misspelt name is distinguished from one of a later version.
"""

import pkgutil
from functools import cache
from pathlib import Path
from typing import Literal

from audio_checks import version

Severity = Literal["error", "warning"]
Level = Literal["error", "warning", "off"]

DEFAULT_SEVERITY: dict[str, Severity] = {
    "structure": "error",
    "container": "error",
    "encoding": "error",
    "sample-rate": "error",
    "bit-depth": "error",
    "channels": "error",
    "duration": "error",
    "naming": "error",
    "sample-peak": "error",
    "true-peak": "error",
    "loudness": "error",
    "dc-offset": "error",
    "silence": "error",
    "head-silence": "error",
    "tail-silence": "error",
    "noise-floor": "error",
    "clipping": "warning",
    "placeholder": "warning",  # an error when renders are judged
    "cut-start": "warning",
    "cut-tail": "warning",
    "click": "warning",
    "dropout": "warning",
    "hum": "warning",
    "false-stereo": "warning",
    "phase": "warning",
    "loop-points": "warning",
    "padded-bits": "warning",
    "metadata": "warning",
    "duplicate": "warning",
    "variation-set": "warning",
    "baked-reverb": "warning",
    "reversed": "warning",
    "upsampled": "warning",
    "lossy": "warning",
}

# What they find depends on what else was delivered, before and after: no file can be returned for it.
OVER_FILES = frozenset({"duplicate", "variation-set"})


@cache
def present() -> frozenset[str]:
    """Return the names of the checks in this version: one module of `checks` each, none of them imported here."""
    folder = Path(version.__file__).with_name("checks")
    return frozenset(module.name.replace("_", "-") for module in pkgutil.iter_modules([str(folder)]))
