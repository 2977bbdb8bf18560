"""Every test has its own memory of verdicts: one test's files are never another's."""

import itertools

import pytest

from audio_checks.checks import all_checks
from audio_checks.spec import check_names


@pytest.fixture(scope="session")
def verdict_folders(tmp_path_factory):
    """Names of folders that are not there yet; pytest's own numbering reads all that there are, for each test."""
    folder = tmp_path_factory.mktemp("verdicts")
    return (folder / str(number) for number in itertools.count())


@pytest.fixture(autouse=True)
def verdicts_of_this_test_only(verdict_folders, monkeypatch):
    monkeypatch.setenv("AUDIO_CHECKS_CACHE_DIR", str(next(verdict_folders)))


@pytest.fixture
def without_lossy(monkeypatch):
    """A version of the time when `lossy` was only a reserved name."""
    there = check_names.present() - {"lossy"}
    monkeypatch.setattr(check_names, "present", lambda: there)
    all_checks.cache_clear()
    yield
    all_checks.cache_clear()
