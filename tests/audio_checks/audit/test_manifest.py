"""A manifest is a stranger's file: what is not just so is refused, and the place named."""

import copy
import json

import pytest

from audio_checks import FingerprintedFile, SpecError, read_manifest, write_manifest
from audio_checks.audit.fingerprint import fingerprint
from audio_checks.cli import main
from tests.support.waves import noise

SOUND = FingerprintedFile(
    "a/b.wav", "0" * 64, 48_000, 16, 1, 4_800, None, -3.0, -20.0, fingerprint([noise(seconds=0.1)], 48_000)
)


@pytest.fixture
def document(tmp_path):
    write_manifest(tmp_path / "m.json", [SOUND])
    return json.loads((tmp_path / "m.json").read_text())


def refused(tmp_path, document):
    (tmp_path / "m.json").write_text(json.dumps(document))
    with pytest.raises(SpecError) as reported:
        read_manifest(tmp_path / "m.json")
    return str(reported.value)


def test_what_was_written_is_read(tmp_path, document):
    assert read_manifest(tmp_path / "m.json") == [SOUND]


@pytest.mark.parametrize(
    ("key", "value", "said"),
    [
        ("path", "../a.wav", "path must be"),
        ("path", "/etc/passwd", "path must be"),
        ("path", "a\x1b[2J.wav", "path must be"),
        ("path", "", "path must be"),
        ("path", 7, "path must be"),
        ("pcm_sha256", "A" * 64, "64 lower-case"),
        ("sample_rate_hz", 0, "sample_rate_hz must be"),
        ("sample_rate_hz", True, "sample_rate_hz must be"),
        ("sample_rate_hz", 48_000.0, "sample_rate_hz must be"),
        ("frames", -1, "frames must be"),
        ("frames", 10**30, "frames must be"),
        ("channels", 0, "channels must be"),
        ("bit_depth", 0, "bit_depth must be"),
        ("rms_dbfs", float("nan"), "rms_dbfs must be"),
        ("sample_peak_dbfs", "loud", "sample_peak_dbfs must be"),
        ("fingerprint", "????", "fingerprint is none of ours"),
        ("fingerprint", "AAAA" * 7, "fingerprint is not as long"),
        ("fingerprint", [], "fingerprint must be"),
        ("cue", "x" * 2_000, "cue must be"),
        ("more", 1, 'no such key: "more"'),
    ],
)
def test_entries_that_are_not_so(tmp_path, document, key, value, said):
    document["files"][0][key] = value
    assert said in refused(tmp_path, document)


def test_what_is_missing_or_twice(tmp_path, document):
    short = copy.deepcopy(document)
    del short["files"][0]["frames"]
    assert refused(tmp_path, short) == "frames is missing"
    document["files"] *= 2
    assert refused(tmp_path, document) == '"a/b.wav" is listed twice'


@pytest.mark.parametrize("key", ["schema_version", "fingerprint_version"])
@pytest.mark.parametrize("value", [2, True, None])
def test_other_versions(tmp_path, document, key, value):
    document[key] = value
    assert key in refused(tmp_path, document)


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"schema_version": 1, "files": 3}', "[" * 100_000, "\0"])
def test_what_is_no_manifest(tmp_path, text, capsys):
    (tmp_path / "m.json").write_text(text)
    with pytest.raises(SpecError):
        read_manifest(tmp_path / "m.json")
    assert main(["audit", "--manifest", str(tmp_path / "m.json"), str(tmp_path)]) == 2
    assert "m.json" in capsys.readouterr().err


def test_what_is_not_there(tmp_path):
    with pytest.raises(SpecError, match="cannot be read"):
        read_manifest(tmp_path / "m.json")
