"""The examples of the documents give what they say."""

import doctest
import re
from pathlib import Path

import pytest

import audio_checks

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.slow
def test_the_examples_of_the_python_api(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    document = ROOT / "docs" / "reference" / "python-api.md"
    found = doctest.testfile(str(document), module_relative=False)
    assert found.attempted > 20
    assert found.failed == 0


def test_every_public_name_that_the_document_uses_is_one():
    text = (ROOT / "docs" / "reference" / "python-api.md").read_text()
    named = set(re.findall(r"audio_checks\.([A-Za-z_]+)", text)) - {"errors"}
    assert named <= set(audio_checks.__all__)
    assert {"check_file", "check_files", "measure_file", "render_master", "parse_spec", "AudioFile"} <= named
