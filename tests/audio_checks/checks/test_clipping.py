"""`clipping`: runs of flat tops, which warn."""

import numpy as np
import pytest

from audio_checks.spec.check_names import DEFAULT_SEVERITY
from tests.support.waves import silence, sine


def driven(gain_db, channels=1):
    """A tone pushed past full scale and cut off there."""
    return np.clip(sine(hz=200, dbfs=gain_db, channels=channels, phase=np.pi / 2), -1, 1 - 2**-23)


@pytest.mark.parametrize("channels", [1, 2])
def test_flat_tops_are_found_and_placed(found_by, channels):
    (finding,) = found_by("clipping", driven(6.0, channels))
    assert finding.code == "clipping:flat-tops"
    # 200 periods a second with two tops each, in each channel; the file starts in the middle of one.
    assert finding.measured == pytest.approx(400 * channels, abs=channels)
    assert finding.start_s == pytest.approx(0.0)
    # The first top ends where cos falls below 1/2 (6 dB down): a sixth of a period.
    assert finding.end_s == pytest.approx(1 / 200 / 6, abs=1e-4)


@pytest.mark.parametrize("samples", [silence(), sine(hz=997, dbfs=-0.1), sine(hz=997, dbfs=-3.0, channels=2)])
def test_round_tops_pass(codes_of, samples):
    assert codes_of("clipping", samples) == []


@pytest.mark.parametrize("hz", [30, 200, 997])
@pytest.mark.parametrize("dbfs", [0.0, 1.6, 6.0])
def test_round_crests_at_and_over_full_scale_are_not_clipped(codes_of, hz, dbfs):
    assert codes_of("clipping", sine(hz=hz, dbfs=dbfs), bits=32, encoding="float") == []


@pytest.mark.parametrize("bits", [16, 24])
def test_a_slow_wave_normalized_to_full_scale_is_not_clipped(codes_of, bits):
    assert codes_of("clipping", sine(hz=30, dbfs=0.0) * (1 - 2.0 ** (1 - bits)), bits=bits) == []


def test_tops_cut_off_over_full_scale_are_found(found_by):
    (finding,) = found_by("clipping", np.clip(sine(hz=200, dbfs=6.0), -1.2, 1.2), bits=32, encoding="float")
    assert finding.code == "clipping:flat-tops"
    assert finding.measured == pytest.approx(400, abs=1)


def test_one_frame_is_no_run(codes_of):
    assert codes_of("clipping", np.full((1, 1), 1.0)) == []


def faded(samples):
    """Swelling and falling by a third, so that no two crests are as high."""
    return samples * (0.6 - 0.2 * np.cos(np.linspace(0, 2 * np.pi, len(samples))))[:, np.newaxis]


def test_tops_of_many_heights_are_found_and_round_ones_pass(found_by, codes_of):
    (finding,) = found_by("clipping", faded(driven(6.0)))
    assert finding.code == "clipping:flat-tops"
    assert 390 <= finding.measured <= 400
    assert codes_of("clipping", faded(sine(hz=200, dbfs=-1.0))) == []


def test_it_warns_because_flat_tops_can_be_style():
    assert DEFAULT_SEVERITY["clipping"] == "warning"
