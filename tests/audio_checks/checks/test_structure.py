"""`structure`: what the reader tolerates is a warning; the rest makes a file unreadable."""

import numpy as np
import pytest

from audio_checks.run.runner import check_file
from tests.support.waves import chunk, extensible, noise, pcm_bytes, riff, silence, sine, wav_bytes


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


@pytest.mark.parametrize(("used", "found"), [(24, []), (32, [("structure", "warning")])])
def test_bits_beyond_those_that_count_warn(tmp_path, used, found):
    coarse = np.round(noise(seconds=0.1) * 2 ** (used - 1)) / 2 ** (used - 1)
    header = chunk(b"fmt ", extensible(container_bits=32, valid_bits=24))
    (tmp_path / "laser.wav").write_bytes(riff(header, chunk(b"data", pcm_bytes(coarse, 32))))
    assert codes_of(tmp_path / "laser.wav") == ("conforming", found)


def test_real_recordings_are_whole(recordings):
    assert all(codes_of(path) == ("conforming", []) for path in recordings[::12])
