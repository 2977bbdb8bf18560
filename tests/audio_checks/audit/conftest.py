"""Approved sounds in a folder, a build beside it, and the command line run on both."""

import json

import numpy as np
import pytest

from audio_checks.cli import main
from benchmarks.faults.sounds import FAMILIES

RATE = 48_000


@pytest.fixture
def sound():
    """A sound of a family, at half of full scale."""

    def sound(family, seed=1, seconds=0.6):
        samples = FAMILIES[family](np.random.default_rng(seed), RATE, seconds)
        return samples / np.abs(samples).max() * 0.5

    return sound


@pytest.fixture
def folders(tmp_path, monkeypatch):
    """Two empty folders, and the place above them to work in."""
    monkeypatch.chdir(tmp_path)
    for name in ("approved", "build"):
        (tmp_path / name).mkdir()
    return tmp_path / "approved", tmp_path / "build"


@pytest.fixture
def run(capsys):
    """Run a command; return its exit code and what it printed."""

    def run(*arguments):
        code = main([str(argument) for argument in arguments])
        captured = capsys.readouterr()
        return code, captured.out, captured.err

    return run


@pytest.fixture
def audit(folders, run):
    """Write the manifest of `approved`, audit `build`; return the exit code and the entries by path."""

    def audit(*more):
        code, _, said = run("manifest", "approved", "--out", "approved.json")
        assert code == 0, said
        code, out, _ = run("audit", "--manifest", "approved.json", "--format", "json", *more, "build")
        document = json.loads(out)
        return code, {entry["path"]: entry for entry in document["files"]}, document

    return audit
