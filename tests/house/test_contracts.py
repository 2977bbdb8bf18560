"""Each import contract names what breaks it; that all hold is said by lint-imports itself, in `make check`."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.lint
ROOT = Path(__file__).resolve().parents[2]
BREAKS = [
    (
        "app/projects/service.py",
        "from app.reviews import models as _broken",
        "app.projects.service -> app.reviews.models",
    ),
    (
        "app/agreements/plan/service.py",
        "from app.money.ledger import rules as _broken",
        "app.agreements.plan.service -> app.money.ledger.rules",
    ),
    ("app/cellar/__init__.py", "DAMP = True", "- app.cellar"),  # a room that nobody listed
    (
        "app/projects/service.py",
        "from audio_checks.spec.delivery_spec import DeliverySpec as _broken",
        "app.projects.service -> audio_checks.spec.delivery_spec",
    ),
    ("audio_checks/spec/delivery_spec.py", "import scipy as _broken", "audio_checks.spec.delivery_spec -> scipy"),
    (
        "audio_checks/audio/hashes.py",
        "from audio_checks.judge import judge as _broken",
        "audio_checks.audio.hashes -> audio_checks.judge",
    ),
    ("audio_checks/cellar/__init__.py", "DAMP = True", "- audio_checks.cellar"),
    (
        "audio_checks/measure/levels.py",
        "from audio_checks import wav as _broken",
        "audio_checks.measure.levels -> audio_checks.wav",
    ),
    (
        "audio_checks/checks/true_peak.py",
        "from audio_checks.checks import sample_peak as _broken",
        "audio_checks.checks.true_peak -> audio_checks.checks.sample_peak",
    ),
    ("app/client/lock.py", "from app.client import why as _broken", "app.client.lock -> app.client.why"),
    ("app/client/lock.py", "import typer as _broken", "app.client.lock -> typer"),
    ("app/client/lock.py", "from app.core import clock as _broken", "app.client.lock -> app.core.clock"),
    ("app/core/events.py", "import dbos as _broken", "app.core.events -> dbos"),
]


def test_every_broken_import_contract_is_reported(tmp_path: Path):
    for package in ("app", "audio_checks"):
        shutil.copytree(ROOT / package, tmp_path / package, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "pyproject.toml", tmp_path)
    for file, line, _ in BREAKS:
        path = tmp_path / file
        path.parent.mkdir(exist_ok=True)
        before = path.read_text() if path.exists() else ""
        path.write_text(f"{before}\n{line}\n")
    result = subprocess.run(
        [str(Path(sys.executable).parent / "lint-imports"), "--no-cache"],
        cwd=tmp_path, env=os.environ | {"PYTHONPATH": str(tmp_path)}, capture_output=True, text=True,
    )  # fmt: skip
    assert result.returncode == 1
    lines = [line.strip().removeprefix("- ").lstrip().partition(" (l.")[0] for line in result.stdout.splitlines()]
    assert [reported for _, _, reported in BREAKS if reported.removeprefix("- ") not in lines] == []
