"""Every test has its own memory of verdicts: one test's files are never another's."""

import pytest


@pytest.fixture(autouse=True)
def verdicts_of_this_test_only(tmp_path_factory, monkeypatch):
    monkeypatch.setenv("AUDIO_CHECKS_CACHE_DIR", str(tmp_path_factory.mktemp("verdicts", numbered=True)))
