"""`true-peak`: the level of the curve between the samples."""

import numpy as np
import pytest

from tests.support.waves import silence, sine

LIMIT = "limits.true_peak_dbtp = -1.0"


@pytest.mark.parametrize(
    ("dbfs", "codes"), [(-0.5, ["true-peak:over"]), (-0.8, ["true-peak:over"]), (-0.97, []), (-1.2, [])]
)
@pytest.mark.parametrize("channels", [1, 2])
def test_limit_and_tolerance(codes_of, dbfs, codes, channels):
    assert codes_of("true-peak", sine(hz=997, dbfs=dbfs, channels=channels), LIMIT) == codes


def test_the_curve_counts_and_not_the_samples(found_by):
    # At a quarter of the sample rate and 45 degrees every sample sits 3.01 dB below the crest.
    tone = sine(hz=12_000, dbfs=-0.5, phase=np.pi / 4)
    (finding,) = found_by("true-peak", tone, LIMIT)
    assert finding.measured == pytest.approx(-0.5, abs=0.15)
    assert finding.limit == -1.0
    assert found_by("sample-peak", tone, "limits.sample_peak_dbfs = -1.0") == []


def test_a_wider_tolerance(codes_of):
    tone = sine(hz=997, dbfs=-0.5)
    assert codes_of("true-peak", tone, f"{LIMIT}\nlimits.tolerance_db = 0.6") == []
    assert codes_of("true-peak", tone, f"{LIMIT}\nlimits.tolerance_db = 0.4") == ["true-peak:over"]


def test_silence_has_no_peak(codes_of):
    assert codes_of("true-peak", silence(), LIMIT) == []
