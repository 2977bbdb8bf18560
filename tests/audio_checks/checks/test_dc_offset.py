"""`dc-offset`: the mean of the worst channel."""

import pytest

from tests.support.waves import silence, sine

LIMIT = "limits.dc_offset_percent = 1.0"


@pytest.mark.parametrize(
    ("offset", "codes"), [(0.0101, ["dc-offset:over"]), (-0.0101, ["dc-offset:over"]), (0.0099, [])]
)
@pytest.mark.parametrize("channels", [1, 2])
def test_percent_of_full_scale_either_way(codes_of, offset, codes, channels):
    tone = sine(hz=1000, dbfs=-12, channels=channels)  # whole periods: its own mean is zero
    tone[:, -1] += offset
    assert codes_of("dc-offset", tone, LIMIT) == codes


def test_silence_is_centred(codes_of):
    assert codes_of("dc-offset", silence(), LIMIT) == []


def test_one_frame_is_all_offset(found_by):
    (finding,) = found_by("dc-offset", silence(seconds=1 / 48_000) + 0.5, LIMIT)
    assert finding.measured == pytest.approx(50.0)
