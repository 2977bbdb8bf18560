"""`encoding`: integer or float samples."""

import pytest

from tests.support.waves import sine


@pytest.mark.parametrize(
    ("encoding", "bits", "accepted", "codes"),
    [
        ("pcm", 24, '["pcm"]', []),
        ("float", 32, '["pcm"]', ["encoding:not-accepted"]),
        ("float", 64, '["pcm", "float"]', []),
        ("pcm", 16, '["float"]', ["encoding:not-accepted"]),
        ("float", 32, '"any"', []),
    ],
)
@pytest.mark.parametrize("channels", [1, 2])
def test_encodings(codes_of, encoding, bits, accepted, codes, channels):
    tone = sine(hz=440, channels=channels)
    assert codes_of("encoding", tone, f"accept.encodings = {accepted}", encoding=encoding, bits=bits) == codes
