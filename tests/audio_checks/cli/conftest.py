"""A folder to work in, and the command line run in it."""

import pytest

from audio_checks.cli import main
from audio_checks.spec.delivery_spec import new_spec


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder to work in, with a spec beside the sounds that is found only when it is named."""
    work = tmp_path / "work"
    work.mkdir()
    monkeypatch.chdir(work)
    for variable in ("GITHUB_WORKSPACE", "GITHUB_STEP_SUMMARY", "FORCE_COLOR"):
        monkeypatch.delenv(variable, raising=False)
    (tmp_path / "spec.toml").write_text(new_spec(name="Shield Wing"), encoding="utf-8")
    return work


@pytest.fixture
def run(capsys):
    """Run a command; return its exit code and what it printed to stdout and stderr."""

    def run(*arguments):
        code = main([str(argument) for argument in arguments])
        captured = capsys.readouterr()
        lines = captured.err.splitlines(keepends=True)
        # A server of earlier tests may still run in this process; its log is JSON.
        return code, captured.out, "".join(line for line in lines if not line.startswith('{"'))

    return run
