"""A copy of the library with one check more, as a change of one file adds it."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import audio_checks

ROOT = Path(__file__).resolve().parents[2]
CHECK = '''"""`long-crest`: the crest factor stays under the limit of the spec.

Why: a sound with tall peaks is quiet for its peak level.
How to fix: use a limiter.
Source: the delivery spec, `[limits] crest_db`.
"""

from audio_checks.report.findings import Finding

SEVERITY = "warning"
LABEL = "Tall peaks"
LIMITS = {"crest_db": (0.0, 60.0, "Crest factor")}
NOT_FIXED = "How tall its peaks are is its designer's choice."
FIGURES = ("crest_db",)


def applies(spec, cue):
    return "crest_db" in spec.limits.others


def check(file, spec):
    limit = spec.limits.others["crest_db"]
    crest = file.measurements.crest_db
    if crest > limit:
        yield Finding(
            code="long-crest:over", message=f"crest factor {crest:.1f} dB, limit {limit:g} dB", fix="use a limiter",
            measured=crest, limit=limit, unit="dB",
        )
'''


def copy_of_library(folder: Path) -> Path:
    """Copy the package into a folder; return the folder."""
    shutil.copytree(
        Path(audio_checks.__file__).parent, folder / "audio_checks", ignore=shutil.ignore_patterns("__pycache__")
    )
    return folder


def copy_with_check(folder: Path) -> Path:
    """Copy the package into a folder, with the check among the others; return the folder."""
    copy_of_library(folder)
    (folder / "audio_checks" / "checks" / "long_crest.py").write_text(CHECK)
    return folder


def run(folder: Path, *command: str) -> subprocess.CompletedProcess[str]:
    """Run Python with the copy of the library, and the server's code beside it."""
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([str(folder), str(ROOT)])}
    return subprocess.run(
        [sys.executable, "-P", *command], cwd=folder, env=environment, capture_output=True, text=True, timeout=300
    )
