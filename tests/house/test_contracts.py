"""The import contracts hold, and each of them barks when it is broken."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BREAKS = [
    ("rooms", "app/projects/service.py", "from app.reviews import models as _broken"),
    ("rooms", "app/agreements/plan.py", "from app.money import rules as _broken"),
    ("rooms", "app/cellar/__init__.py", "DAMP = True"),  # a room that nobody listed
    ("inside-money", "app/money/loose.py", "LOOSE = True"),  # a module that has no layer
    ("inside-renders", "app/renders/spectrum.py", "from app.renders import queries as _broken"),
    ("inside-projects", "app/projects/rules.py", "from app.projects import queries as _broken"),
    ("front-door", "app/projects/service.py", "from audio_checks.spec.delivery_spec import DeliverySpec as _broken"),
    ("library-alone", "audio_checks/spec/delivery_spec.py", "import scipy as _broken"),
    ("library-rooms", "audio_checks/audio/hashes.py", "from audio_checks.judge import judge as _broken"),
    ("library-rooms", "audio_checks/cellar/__init__.py", "DAMP = True"),
    ("measures", "audio_checks/measure/levels.py", "from audio_checks import wav as _broken"),
    ("checks", "audio_checks/checks/true_peak.py", "from audio_checks.checks import sample_peak as _broken"),
    ("inside-client", "app/client/lock.py", "from app.client import why as _broken"),
    ("client-alone", "app/client/lock.py", "import typer as _broken"),
    ("rooms", "app/client/lock.py", "from app.kit import clock as _broken"),
    ("queue", "app/kit/events.py", "import dbos as _broken"),
    ("web", "app/projects/service.py", "import fastapi as _broken"),
    ("rules", "app/projects/rules.py", "import sqlalchemy as _broken"),
]


def lint(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [str(Path(sys.executable).parent / "lint-imports"), "--no-cache", *arguments],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": str(folder)},
        capture_output=True,
        text=True,
    )


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    for package in ("app", "audio_checks"):
        shutil.copytree(ROOT / package, tmp_path / package, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "pyproject.toml", tmp_path)
    return tmp_path


def test_every_contract_holds(copy: Path):
    result = lint(copy)
    assert result.returncode == 0, result.stdout


@pytest.mark.parametrize(("contract", "file", "line"), BREAKS, ids=[f"{b[0]}-{i}" for i, b in enumerate(BREAKS)])
def test_a_broken_import_contract_is_reported(copy: Path, contract: str, file: str, line: str):
    path = copy / file
    path.parent.mkdir(exist_ok=True)
    before = path.read_text() if path.exists() else ""
    path.write_text(f"{before}\n{line}\n")
    result = lint(copy, "--contract", contract)
    assert result.returncode == 1, result.stdout
    assert "BROKEN" in result.stdout
