import numpy as np
import pytest

from audio_checks.measure.average_spectrum import AverageSpectrum
from tests.support.waves import noise, silence, sine


def levels(samples, rate=48_000, block=None):
    spectrum = AverageSpectrum(rate, samples.shape[1], len(samples))
    for start in range(0, len(samples), block or max(1, len(samples))):
        spectrum.add(samples[start : start + (block or len(samples))])
    return spectrum.result()


def rms_dbfs(found):
    return 10 * np.log10(np.sum(10 ** (found.levels_dbfs / 10)))


@pytest.mark.parametrize("hz", [100, 1_000, 15_000])
def test_a_tone_stands_in_its_band_at_its_rms(hz):
    found = levels(sine(hz=hz, dbfs=0.0))
    loudest = int(np.argmax(found.levels_dbfs))
    ratio = found.centres_hz[loudest] / hz
    assert 2 ** (-1 / 12) <= ratio <= 2 ** (1 / 12)
    assert rms_dbfs(found) == pytest.approx(-3.01, abs=0.01)


@pytest.mark.parametrize("seconds", [0.01, 0.17, 1.0])
@pytest.mark.parametrize("channels", [1, 2])
def test_the_bands_hold_all_of_the_energy(seconds, channels):
    sound = noise(dbfs=-20.0, seconds=seconds, channels=channels)
    exact = 10 * np.log10(np.mean(sound**2))
    # What lies below 20 Hz is in no band: of white noise one part in 1200.
    assert rms_dbfs(levels(sound)) == pytest.approx(exact, abs=0.05)


def test_white_noise_rises_3_db_an_octave():
    found = levels(noise(dbfs=-20.0, seconds=4.0))
    octave = dict(zip(np.round(found.centres_hz), found.levels_dbfs, strict=True))
    hz = np.array(list(octave))
    low, high = hz[np.argmin(abs(hz - 1_000))], hz[np.argmin(abs(hz - 8_000))]
    assert octave[high] - octave[low] == pytest.approx(10 * np.log10(high / low), abs=0.6)


def test_blocks_do_not_show():
    sound = noise(seconds=0.5, channels=2)
    whole, cut = levels(sound), levels(sound, block=1_001)
    assert np.allclose(whole.levels_dbfs, cut.levels_dbfs, atol=1e-9)


@pytest.mark.parametrize("rate", [8_000, 44_100, 192_000])
def test_bands_reach_half_the_sample_rate(rate):
    found = levels(noise(seconds=0.1, rate=rate), rate=rate)
    assert 20 < found.centres_hz[0] < 24
    assert rate / 2 / 2 ** (1 / 6) < found.centres_hz[-1] < rate / 2


def test_silence_and_nothing():
    assert (levels(silence(seconds=0.1)).levels_dbfs == -np.inf).all()
    assert (levels(silence(seconds=0.0)).levels_dbfs == -np.inf).all()
