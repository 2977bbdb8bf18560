"""`container`: of a kind the spec lists."""

import struct

import pytest

from audio_checks.audio.audio_file import AudioFile
from audio_checks.checks import container
from audio_checks.spec.delivery_spec import parse_spec
from tests.support.waves import chunk, fmt, pcm_bytes, sine


def rf64(samples):
    """A right RF64 file, sizes in its ds64."""
    data = pcm_bytes(samples)
    body = chunk(b"fmt ", fmt(bits=24)) + b"data" + struct.pack("<I", 0xFFFFFFFF) + data
    ds64 = chunk(b"ds64", struct.pack("<QQQI", 4 + 36 + len(body), len(data), len(samples), 0))
    return b"RF64" + struct.pack("<I", 0xFFFFFFFF) + b"WAVE" + ds64 + body


@pytest.mark.parametrize(
    ("accepted", "codes"),
    [('["wav"]', ["container:not-accepted"]), ('["wav", "rf64"]', []), ('["rf64"]', [])],
)
def test_rf64_only_where_it_is_listed(tmp_path, accepted, codes):
    (tmp_path / "long.wav").write_bytes(rf64(sine(hz=440)))
    spec = parse_spec(f"format = 1\naccept.containers = {accepted}")
    with AudioFile(tmp_path / "long.wav") as file:
        assert [finding.code for finding in container.check(file, spec)] == codes


@pytest.mark.parametrize("channels", [1, 2])
def test_wav(codes_of, channels):
    tone = sine(hz=440, channels=channels)
    assert codes_of("container", tone, 'accept.containers = ["wav"]') == []
    assert codes_of("container", tone, 'accept.containers = ["rf64"]') == ["container:not-accepted"]
    assert codes_of("container", tone, 'accept.containers = "any"') == []
