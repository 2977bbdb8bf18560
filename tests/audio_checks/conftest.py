"""Every test has its own memory of verdicts: one test's files are never another's."""

import pytest

from audio_checks.checks import all_checks
from audio_checks.spec import check_names


@pytest.fixture(autouse=True)
def verdicts_of_this_test_only(tmp_path_factory, monkeypatch):
    monkeypatch.setenv("AUDIO_CHECKS_CACHE_DIR", str(tmp_path_factory.mktemp("verdicts", numbered=True)))


@pytest.fixture
def without_lossy(monkeypatch):
    """A version of the time when `lossy` was only a reserved name."""
    there = check_names.present() - {"lossy"}
    monkeypatch.setattr(check_names, "present", lambda: there)
    all_checks.cache_clear()
    yield
    all_checks.cache_clear()
