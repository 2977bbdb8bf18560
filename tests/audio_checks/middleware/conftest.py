"""Folders with files of a project, written as texts."""

import pytest


@pytest.fixture
def put(tmp_path):
    """Write a file below the project's root; return the root."""

    def put(path, text):
        place = tmp_path / path
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text, encoding="utf-8")
        return tmp_path

    return put
