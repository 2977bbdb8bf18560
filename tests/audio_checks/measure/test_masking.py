import numpy as np
import pytest

from audio_checks.measure.masking import BANDS, BLOCK_S, CENTRES_HZ, Excitation, masking
from tests.support.waves import noise, silence, sine, swelling


def excitation(samples, rate=48_000, block=None):
    found = Excitation(rate, samples.shape[1])
    for start in range(0, len(samples), block or max(1, len(samples))):
        found.add(samples[start : start + (block or len(samples))])
    return found.power()


def band_of(hz):
    return int(np.argmin(np.abs(np.log(CENTRES_HZ / hz))))


def steady_db(samples, rate=48_000):
    """The excitation in the middle of a steady sound, in dB by band."""
    power = excitation(samples, rate)
    return 10 * np.log10(power[len(power) // 2] + 1e-20)


def narrow_noise(low_hz, high_hz, dbfs=-20.0, seconds=2.0, rate=48_000):
    """Noise with nothing outside a band, at an RMS within it."""
    spectrum = np.fft.rfft(noise(seconds=seconds, rate=rate)[:, 0])
    hz = np.fft.rfftfreq(round(seconds * rate), 1 / rate)
    spectrum[(hz < low_hz) | (hz > high_hz)] = 0
    samples = np.fft.irfft(spectrum)
    return (samples * 10 ** (dbfs / 20) / np.sqrt(np.mean(samples**2)))[:, np.newaxis]


@pytest.mark.parametrize("rate", [22_050, 44_100, 48_000, 96_000])
@pytest.mark.parametrize("band", [8, 15, 25])
def test_a_tone_excites_its_own_band_by_its_mean_square(rate, band):
    found = steady_db(sine(hz=CENTRES_HZ[band], dbfs=-6.0, rate=rate), rate)
    assert int(np.argmax(found)) == band
    assert found[band] == pytest.approx(-6.0 - 3.01, abs=0.3)  # a window of 80 ms blurs the tip of the filter


def test_white_noise_rises_with_the_width_of_the_bands():
    # A filter lets through its equivalent rectangular bandwidth, and more where its lower slope is flatter.
    power = excitation(noise(dbfs=-20.0, seconds=8.0))[2:-2].mean(axis=0)
    bandwidths = 24.7 * (4.37 * CENTRES_HZ / 1_000 + 1)
    flatter = (1 + 1 / (1 - 0.35 * 19 / 30.16)) / 2
    expected = 0.01 * bandwidths * flatter / 24_000
    within = slice(band_of(300), band_of(10_000))
    assert 10 * np.log10(power[within] / expected[within]) == pytest.approx(0.0, abs=0.5)


def test_the_blocks_do_not_depend_on_how_the_sound_comes_in():
    sound = noise(seconds=0.7, channels=2)
    whole = excitation(sound)
    assert excitation(sound, block=997) == pytest.approx(whole)
    assert whole.shape == (int(np.ceil(0.7 / BLOCK_S)), BANDS)


def test_channels_are_averaged_as_powers():
    tone = sine(hz=1_000, channels=2)
    turned = tone * [1, -1]
    assert excitation(turned) == pytest.approx(excitation(tone))


@pytest.mark.parametrize("frames", [1, 100, 1_920, 1_921])
def test_every_frame_is_in_a_block(frames):
    assert len(excitation(np.full((frames, 1), 0.5))) == int(np.ceil(frames / 1_920))


@pytest.mark.parametrize(("above_db", "is_heard"), [(6.0, True), (0.0, True), (-6.0, False), (-12.0, False)])
def test_a_tone_over_and_under_a_narrow_noise(above_db, is_heard):
    # One ERB of noise around the tone: inside the filter both have their whole power, but for its rounded top.
    band = band_of(1_000)
    centre = CENTRES_HZ[band]
    half = 24.7 * (4.37 * centre / 1_000 + 1) / 2
    covering = narrow_noise(centre - half, centre + half, dbfs=-30.0)
    tone = sine(hz=centre, dbfs=-30.0 + 3.01 + above_db, seconds=2.0)
    found = masking(excitation(tone), [excitation(covering)])
    assert bool(found.is_heard[band]) is is_heard
    assert found.margin_db[band] == pytest.approx(above_db + 3.0, abs=2.0)


@pytest.mark.slow
def test_a_notch_around_the_tone_uncovers_it():
    tone = excitation(sine(hz=1_000, dbfs=-40.0, seconds=2.0))
    margins = []
    for notch in (0.0, 0.1, 0.2, 0.4):
        around = narrow_noise(200, 1_000 * (1 - notch)) + narrow_noise(1_000 * (1 + notch), 1_800)
        margins.append(masking(tone, [excitation(around)]).margin_db[band_of(1_000)])
    assert margins == sorted(margins)
    assert margins[-1] - margins[0] > 25  # as thresholds in notched noise fall with the width of the notch


def test_masking_reaches_further_up_than_down():
    covering = [excitation(narrow_noise(950, 1_050, dbfs=-20.0))]
    above = masking(excitation(sine(hz=1_400, dbfs=-50.0, seconds=2.0)), covering).margin_db[band_of(1_400)]
    below = masking(excitation(sine(hz=1_000**2 / 1_400, dbfs=-50.0, seconds=2.0)), covering).margin_db[band_of(714)]
    assert below > above + 3


def test_bands_far_away_are_not_touched():
    tone = excitation(sine(hz=8_000, dbfs=-50.0, seconds=2.0))
    # Faded: an abrupt start has energy in every band.
    found = masking(tone, [excitation(swelling(narrow_noise(100, 400, dbfs=-10.0), 9_600))])
    assert found.is_heard[band_of(8_000)]
    assert found.margin_db[band_of(8_000)] > 30


def test_equal_sounds_stand_at_the_ratio_of_the_threshold():
    sound = excitation(noise(dbfs=-20.0))
    found = masking(sound, [sound])
    assert found.margin_db == pytest.approx(3.0, abs=0.01)
    assert (found.energy_share, found.time_share) == (1.0, 1.0)


@pytest.mark.parametrize("gain_db", [-40.0, -6.0, 12.0])
def test_all_levels_moved_alike_give_the_same_figure(gain_db):
    sound, cover = excitation(noise(dbfs=-30.0)), excitation(narrow_noise(200, 900, seconds=1.0))
    gain = 10 ** (gain_db / 10)
    one, other = masking(sound, [cover]), masking(sound * gain, [cover * gain])
    assert one.margin_db == pytest.approx(other.margin_db, abs=1e-6)
    assert (one.energy_share, one.covers.tolist()) == (pytest.approx(other.energy_share), other.covers.tolist())


def test_it_says_what_covers_where():
    sound = excitation(noise(dbfs=-60.0, seconds=2.0))
    engine, laser = excitation(narrow_noise(60, 300)), excitation(narrow_noise(3_000, 6_000))
    found = masking(sound, [engine, laser])
    assert found.covers[band_of(150)] == 0
    assert found.covers[band_of(4_000)] == 1
    assert not found.is_heard[band_of(150)]
    assert not found.is_heard[band_of(4_000)]
    assert 0 < found.energy_share < 1


def test_half_of_the_time_covered():
    sound = excitation(noise(dbfs=-40.0, seconds=2.0))
    cover = excitation(noise(dbfs=-10.0, seconds=1.0, seed=2))
    covered = np.zeros_like(sound)
    covered[: len(cover)] = cover
    assert masking(sound, [covered]).time_share == pytest.approx(0.5, abs=0.04)


def test_alone_all_of_it_is_heard():
    found = masking(excitation(noise()), [])
    assert (found.energy_share, found.time_share) == (1.0, 1.0)
    assert found.is_heard.all()
    assert np.isposinf(found.margin_db).all()
    assert (found.covers == -1).all()


@pytest.mark.parametrize("samples", [silence(), silence(seconds=0.0), silence(channels=2)])
def test_silence_is_never_heard(samples):
    sound = excitation(samples)
    found = masking(sound, [sound])
    assert (found.energy_share, found.time_share) == (0.0, 0.0)
    assert not found.is_part.any()
    assert not found.is_heard.any()


def test_silence_covers_nothing():
    found = masking(excitation(noise()), [excitation(silence())])
    assert found.is_heard.all()
    assert (found.covers == -1).all()
