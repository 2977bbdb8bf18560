"""`cut-tail`: sounds that end in mid-wave."""

import numpy as np
import pytest
from scipy.signal import butter, sosfilt

from audio_checks.render.resample import resample
from audio_checks.spec.delivery_spec import CueFacts
from tests.support.waves import join, noise, silence, sine, smpl

MID_WAVE = ["cut-tail:mid-wave"]


def ending(share, hz=50, channels=1):
    """A second whose last sample is a share of the crest, on its way down."""
    return sine(hz=hz, phase=np.pi - np.arcsin(share), channels=channels)[::-1]


@pytest.mark.parametrize("channels", [1, 2])
def test_the_crest_of_a_wave_is_no_end(found_by, channels):
    (finding,) = found_by("cut-tail", ending(1.0, channels=channels))
    assert finding.code == "cut-tail:mid-wave"
    assert finding.measured == pytest.approx(-6.0, abs=0.01)
    assert (finding.start_s, finding.end_s) == (pytest.approx(0.99), 1.0)


@pytest.mark.parametrize(("share", "codes"), [(0.21, MID_WAVE), (0.19, [])])
def test_a_fifth_of_what_came(codes_of, share, codes):
    assert codes_of("cut-tail", ending(share)) == codes


def test_a_tail_that_is_cut_and_one_that_fades_out(codes_of):
    cut = noise(seed=3)
    assert codes_of("cut-tail", cut) == MID_WAVE
    cut[-48:] *= np.linspace(1, 0, 48)[:, np.newaxis]
    assert codes_of("cut-tail", cut) == []


def test_silence_after_it_does_not_hide_it(found_by):
    (finding,) = found_by("cut-tail", join(ending(1.0), silence(seconds=0.25)))
    assert finding.end_s == pytest.approx(1.0)


@pytest.mark.parametrize(("dbfs", "codes"), [(-41.0, MID_WAVE), (-43.0, [])])
def test_what_is_quiet_does_not_matter(codes_of, dbfs, codes):
    quiet = sine(hz=300, dbfs=dbfs, phase=np.pi / 2, seconds=0.1)
    assert codes_of("cut-tail", join(sine(hz=300), quiet[::-1])) == codes


def test_loops_end_in_mid_wave(codes_of):
    assert codes_of("cut-tail", ending(1.0), cue=CueFacts("SW-001", loop=True)) == []
    assert codes_of("cut-tail", ending(1.0), after=[smpl([(0, 47_999)])]) == []
    once = CueFacts("SW-001", loop=False)
    assert codes_of("cut-tail", ending(1.0), after=[smpl([(0, 47_999)])], cue=once) == ["cut-tail:mid-wave"]


@pytest.mark.parametrize(("samples", "codes"), [(silence(), []), (silence(seconds=1 / 48_000) + 0.5, MID_WAVE)])
def test_silence_and_one_frame(codes_of, samples, codes):
    assert codes_of("cut-tail", samples) == codes


# What a converter of sample rates makes of an edge rings after it, and is sharp no more.
@pytest.mark.parametrize("rung", ["left", "right"])
def test_a_converter_of_sample_rates_does_not_hide_it(found_by, rung):
    cut = resample(join(ending(0.8, hz=300), silence(seconds=0.1)), 48_000, 44_100)
    other = np.zeros_like(cut)
    pair = np.hstack((cut, other) if rung == "left" else (other, cut))
    (finding,) = found_by("cut-tail", pair, rate=44_100)
    assert finding.end_s == pytest.approx(1.0, abs=0.005)


def test_a_cut_that_is_converted_and_quiet_does_not_matter(codes_of):
    quiet = join(sine(hz=300), 0.008 * ending(0.8, hz=300), silence(seconds=0.1))
    assert codes_of("cut-tail", resample(quiet, 48_000, 44_100), rate=44_100) == []
    loud = join(sine(hz=300), 0.03 * ending(0.8, hz=300), silence(seconds=0.1))
    assert codes_of("cut-tail", resample(loud, 48_000, 44_100), rate=44_100) == MID_WAVE


def equalised(samples, hz, order=1, rate=48_000):
    """Through a low cut, and highs that fall from 12 kHz on, as a channel strip has them."""
    low_cut = butter(order, hz, "high", fs=rate, output="sos")
    return sosfilt(np.vstack((low_cut, butter(1, 12_000, fs=rate, output="sos"))), samples, axis=0)


def ramped(samples, frames):
    samples[-frames:] *= (np.arange(frames)[::-1] / frames)[:, np.newaxis]
    return samples


# What a low cut makes of an edge goes on for 10 ms and more, slowly, until it is silent or the file ends.
@pytest.mark.parametrize(("hz", "order"), [(20, 1), (60, 1), (40, 2)])
@pytest.mark.parametrize("pause_s", [0.005, 0.2])
def test_a_low_cut_that_answers_does_not_hide_it(found_by, hz, order, pause_s):
    for sound in (ending(0.8, hz=300), noise(seed=3)):
        (finding,) = found_by("cut-tail", equalised(join(sound, silence(seconds=pause_s)), hz, order))
        assert finding.code == "cut-tail:mid-wave"
        assert finding.end_s == pytest.approx(1.0, abs=0.001)


def test_what_fades_out_before_a_low_cut_is_no_cut(codes_of):
    for sound in (noise(seed=3), sine(hz=100), sine(hz=3_000)):
        faded = ramped(sound, 96)
        assert codes_of("cut-tail", equalised(join(faded, silence(seconds=0.1)), 40)) == []


def test_a_low_tone_that_dies_away_after_a_hit_is_no_answer(codes_of):
    times = np.arange(48_000)[:, np.newaxis] / 48_000
    kick = 0.3 * np.sin(2 * np.pi * 50 * times) * np.exp(-times / 0.03)
    kick[:480] += noise(seed=3, seconds=0.01)
    assert codes_of("cut-tail", join(silence(seconds=0.1), ramped(kick, 480))) == []


@pytest.mark.parametrize(("rate", "frames"), [(44_100, 2), (48_000, 6), (96_000, 14)])
@pytest.mark.parametrize("pause_s", [0.0, 0.1])
def test_a_fade_that_is_too_short_does_not_hide_it(found_by, rate, frames, pause_s):
    for sound in (sine(hz=300, phase=-1.2, rate=rate), noise(seed=4, rate=rate)):
        (finding,) = found_by("cut-tail", join(ramped(sound, frames), silence(seconds=pause_s, rate=rate)), rate=rate)
        assert finding.end_s == pytest.approx(1.0, abs=0.0003)


def test_a_fade_of_a_millisecond_is_an_end(codes_of):
    for sound in (sine(hz=300, phase=1.2), sine(hz=3_000, phase=1.2), noise(seed=4)):
        assert codes_of("cut-tail", ramped(sound, 48)) == []


@pytest.mark.parametrize("dbfs", [-48.0, -52.0, -59.6])
@pytest.mark.parametrize("fade_s", [0.1, 0.3])
def test_a_quiet_sound_that_fades_out_is_not_cut(codes_of, dbfs, fade_s):
    for sound in (sine(hz=700, dbfs=dbfs), noise(dbfs=dbfs - 12, seed=5)):
        fade = np.minimum(1.0, np.arange(len(sound)) / (fade_s * 48_000))
        assert codes_of("cut-tail", sound * np.square(fade[::-1])[:, np.newaxis]) == []


def test_a_quiet_sound_in_mid_wave_is_cut_where_it_can_be_heard(codes_of):
    assert codes_of("cut-tail", 10 ** (-46 / 20) * ending(1.0)) == MID_WAVE  # at -52 dBFS
    assert codes_of("cut-tail", 10 ** (-56 / 20) * ending(1.0)) == []  # at -62 dBFS
