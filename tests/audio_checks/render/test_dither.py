"""Rounding with dither: its noise, its linearity below one step, its silence, and the same bytes again."""

import hashlib

import numpy as np
import pytest

from audio_checks.errors import RenderRefused
from audio_checks.render.dither import ensure_shapeable, quantised

SEED = hashlib.sha256(b"a master").digest()
RATE = 44_100
TIME = np.arange(10 * RATE) / RATE


def rounded(samples, bit_depth, dither="tpdf", seed=SEED, cut=None):
    blocks = [samples[at : at + cut] for at in range(0, len(samples), cut)] if cut else [samples]
    done = quantised(blocks, bit_depth=bit_depth, channels=samples.shape[1], dither=dither, seed=seed)
    return np.concatenate([np.empty((0, samples.shape[1]), dtype=np.int64), *done])


def sine(dbfs, hz=997.0):
    return (10 ** (dbfs / 20) * np.sin(2 * np.pi * hz * TIME))[:, np.newaxis]


def rms_db(values):
    return 10 * np.log10(np.mean(np.square(values)))


@pytest.mark.parametrize(("bit_depth", "theory"), [(16, -96.33), (8, -48.16)])
@pytest.mark.parametrize("dbfs", [-6.0, -40.0])
def test_the_noise_is_half_a_step(bit_depth, theory, dbfs):
    # Rounding gives 1/12, two even random numbers 1/12 each: together a quarter of a squared step.
    samples = sine(dbfs)
    error = rounded(samples, bit_depth) / 2.0 ** (bit_depth - 1) - samples
    assert rms_db(error) == pytest.approx(theory, abs=0.1)
    assert abs(error.mean()) < 0.01 / 2 ** (bit_depth - 1)


@pytest.mark.parametrize(("dbfs", "bit_depth"), [(-80.0, 16), (-100.0, 16), (-46.0, 8)])
def test_a_quiet_tone_keeps_its_level(dbfs, bit_depth):
    level = rounded(sine(dbfs), bit_depth)[:, 0] / 2.0 ** (bit_depth - 1)
    found = 2 * abs(np.mean(level * np.exp(-2j * np.pi * 997 * TIME)))
    assert 20 * np.log10(found) == pytest.approx(dbfs, abs=0.05 if dbfs < -90 else 0.01)


def test_without_dither_a_tone_below_half_a_step_is_lost():
    assert not rounded(sine(-100.0), 16, dither="none").any()


def test_the_error_does_not_follow_the_tone():
    # Undithered, a tone of three steps has harmonics a few dB below one step; dithered, none stands out.
    samples = sine(-80.0)

    def third_harmonic(dither):
        error = rounded(samples, 16, dither)[:, 0] / 32_768 - samples[:, 0]
        return 2 * abs(np.mean(error * np.exp(-2j * np.pi * 3 * 997 * TIME)))

    assert third_harmonic("none") > 20 * third_harmonic("tpdf")


def test_the_same_bytes_again_however_blocks_are_cut():
    noise = np.random.default_rng(1).uniform(-0.5, 0.5, (5_000, 2))
    noise[1_000:2_000] = 0.0
    once = rounded(noise, 16)
    assert all(np.array_equal(rounded(noise, 16, cut=cut), once) for cut in (1, 63, 64, 65, 127, 4_096))
    assert not np.array_equal(rounded(noise, 16, seed=hashlib.sha256(b"another").digest()), once)


@pytest.mark.parametrize("bit_depth", [8, 16])
@pytest.mark.parametrize("dither", ["tpdf", "shaped"])
def test_digital_silence_stays_silent(bit_depth, dither):
    samples = np.random.default_rng(2).uniform(-0.1, 0.1, (4_000, 2))
    samples[:500] = samples[1_000:1_064] = samples[3_500:] = 0.0
    samples[2_000:3_000, 1] = 0.0
    whole = rounded(samples, bit_depth, dither)
    for part in (whole[:500], whole[1_000:1_064], whole[3_500:], whole[2_000:3_000, 1:]):
        assert not part.any()
    assert whole[2_000:3_000, 0].any()


def test_channels_share_their_noise_where_they_are_equal():
    tone = sine(-30)[:RATE]
    half = np.concatenate([tone, tone, -tone], axis=1)
    half[RATE // 2 :, 1] *= 0.5
    steps = rounded(half, 16)
    assert (steps[: RATE // 2, 0] == steps[: RATE // 2, 1]).all()
    errors = steps / 2**15 - half
    later = errors[RATE // 2 :]
    assert abs(np.corrcoef(later[:, 0], later[:, 1])[0, 1]) < 0.03  # three deviations are 0.02
    assert abs(np.corrcoef(errors[:, 0], errors[:, 2])[0, 1]) < 0.02
    assert rms_db(errors[:, 1]) == pytest.approx(-96.33, abs=0.1)
    assert (rounded(half, 16, cut=777) == steps).all()


def test_a_few_zeros_are_no_silence():
    samples = np.full((300_000, 1), 0.25)
    samples[::2] = 0.0
    assert rounded(samples, 16)[::2].any()


@pytest.mark.parametrize("channels", [1, 2])
def test_one_frame_and_none(channels):
    assert rounded(np.zeros((1, channels)), 16).tolist() == [[0] * channels]
    assert rounded(np.zeros((0, channels)), 16).shape == (0, channels)


def test_whole_numbers_come_through_unchanged_without_dither():
    steps = np.arange(-32_768, 32_768)[:, np.newaxis]
    assert np.array_equal(rounded(steps / 32_768, 16, dither="none"), steps)


def test_beyond_full_scale_is_not_hidden():
    assert rounded(np.array([[1.5], [-1.5]]), 16, dither="none").tolist() == [[49_152], [-49_152]]


@pytest.mark.slow
def test_shaped_noise_follows_the_response_of_its_weights():
    samples = sine(-20.0)
    hz = np.fft.rfftfreq(len(samples), 1 / RATE)
    delays = np.exp(-2j * np.pi * np.outer(hz, np.arange(1, 6)) / RATE)
    wanted = np.abs(1 - delays @ [2.033, -2.165, 1.959, -1.590, 0.6149]) ** 2

    def density(dither):
        error = rounded(samples, 16, dither)[:, 0] / 32_768 - samples[:, 0]
        return np.abs(np.fft.rfft(error * np.hanning(len(error)))) ** 2

    plain, shaped = density("tpdf"), density("shaped")
    for low, high in [(50, 400), (3_000, 4_500), (8_000, 9_000), (17_000, 19_000)]:
        band = (hz > low) & (hz < high)
        change = shaped[band].mean() / plain[band].mean()
        assert 10 * np.log10(change) == pytest.approx(10 * np.log10(wanted[band].mean()), abs=0.5)
    heard = (hz > 3_000) & (hz < 4_500)
    assert shaped[heard].mean() < plain[heard].mean() / 30


def test_shaping_needs_room():
    with pytest.raises(RenderRefused) as refused:
        ensure_shapeable("shaped", 32_000)
    assert refused.value.code == "render:shaped-too-low"
    ensure_shapeable("shaped", 44_100)
    ensure_shapeable("tpdf", 8_000)
