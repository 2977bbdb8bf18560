"""`structure`: what the reader tolerates is a warning; the rest makes a file unreadable."""

import pytest

from audio_checks.runner import check_file
from tests.support.waves import silence, sine, wav_bytes


def codes_of(path):
    entry = check_file(path)
    return entry.verdict, [(finding.check, finding.severity) for finding in entry.findings]


@pytest.mark.parametrize("samples", [sine(hz=440), sine(hz=440, channels=2), silence(), silence(seconds=1 / 48_000)])
def test_a_right_file(tmp_path, samples):
    (tmp_path / "laser.wav").write_bytes(wav_bytes(samples))
    assert codes_of(tmp_path / "laser.wav") == ("conforming", [])


def test_a_size_that_is_off_by_eight_warns(tmp_path):
    content = bytearray(wav_bytes(sine(hz=440)))
    content[4:8] = len(content).to_bytes(4, "little")  # the size should not count the first 8 bytes
    (tmp_path / "laser.wav").write_bytes(content)
    assert codes_of(tmp_path / "laser.wav") == ("conforming", [("structure", "warning")])


def test_a_file_that_is_cut_short_cannot_be_read(tmp_path):
    (tmp_path / "laser.wav").write_bytes(wav_bytes(sine(hz=440))[:-1000])
    assert codes_of(tmp_path / "laser.wav") == ("unreadable", [("structure", "error")])
