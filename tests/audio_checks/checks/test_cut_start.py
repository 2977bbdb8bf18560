"""`cut-start`: sounds that start in mid-wave."""

import numpy as np
import pytest
from scipy.signal import butter, sosfilt

from audio_checks.render.resample import resample
from audio_checks.spec.delivery_spec import CueFacts
from tests.support.waves import join, noise, silence, sine, smpl

MID_WAVE = ["cut-start:mid-wave"]


@pytest.mark.parametrize("channels", [1, 2])
def test_the_crest_of_a_wave_is_no_start(found_by, channels):
    (finding,) = found_by("cut-start", sine(hz=300, dbfs=-6, channels=channels, phase=np.pi / 2))
    assert finding.code == "cut-start:mid-wave"
    assert finding.measured == pytest.approx(-6.0, abs=0.01)
    assert (finding.start_s, finding.end_s) == (0.0, 0.01)


# The first sample is sin(phase) of the crest: a fifth of it is where the limit lies.
@pytest.mark.parametrize(("share", "codes"), [(0.21, MID_WAVE), (0.19, [])])
def test_a_fifth_of_what_comes(codes_of, share, codes):
    assert codes_of("cut-start", sine(hz=50, phase=np.pi - np.arcsin(share))) == codes


@pytest.mark.parametrize("hz", [100, 997, 3_000, 4_000])
def test_a_zero_crossing_is_a_start(codes_of, hz):
    assert codes_of("cut-start", sine(hz=hz)) == []
    assert codes_of("cut-start", sine(hz=hz)[1:]) == []


def test_noise_that_is_cut_and_noise_that_fades_in(codes_of):
    cut = noise(seed=3)
    assert codes_of("cut-start", cut) == MID_WAVE
    cut[:48] *= np.linspace(0, 1, 48)[:, np.newaxis]
    assert codes_of("cut-start", cut) == []


def test_silence_before_it_does_not_hide_it(found_by):
    (finding,) = found_by("cut-start", join(silence(seconds=0.25), sine(hz=300, phase=1.0)))
    assert finding.start_s == pytest.approx(0.25)


# 40 dB under the peak of -6 dBFS.
@pytest.mark.parametrize(("dbfs", "codes"), [(-41.0, MID_WAVE), (-43.0, [])])
def test_what_is_quiet_does_not_matter(codes_of, dbfs, codes):
    quiet = sine(hz=300, dbfs=dbfs, phase=np.pi / 2, seconds=0.1)
    assert codes_of("cut-start", join(quiet, sine(hz=300))) == codes


def test_loops_start_in_mid_wave(codes_of):
    cut = sine(hz=300, phase=1.0)
    assert codes_of("cut-start", cut, cue=CueFacts("SW-001", loop=True)) == []
    assert codes_of("cut-start", cut, after=[smpl([(0, 47_999)])]) == []
    once = CueFacts("SW-001", loop=False)
    assert codes_of("cut-start", cut, after=[smpl([(0, 47_999)])], cue=once) == ["cut-start:mid-wave"]


@pytest.mark.parametrize(("samples", "codes"), [(silence(), []), (silence(seconds=1 / 48_000) + 0.5, MID_WAVE)])
def test_silence_and_one_frame(codes_of, samples, codes):
    assert codes_of("cut-start", samples) == codes


# What a converter of sample rates makes of an edge rings before it, and is sharp no more.
@pytest.mark.parametrize(("rate", "to_hz"), [(48_000, 44_100), (96_000, 48_000), (192_000, 96_000)])
@pytest.mark.parametrize("channels", [1, 2])
def test_a_converter_of_sample_rates_does_not_hide_it(found_by, rate, to_hz, channels):
    cut = join(
        silence(seconds=0.1, rate=rate, channels=channels), sine(hz=300, phase=1.0, rate=rate, channels=channels)
    )
    (finding,) = found_by("cut-start", resample(cut, rate, to_hz), rate=to_hz)
    assert finding.start_s == pytest.approx(0.1, abs=0.005)
    assert finding.measured == pytest.approx(-7.0, abs=1.5)


def test_what_fades_in_before_it_was_converted_is_no_cut(codes_of):
    for fade, sound in ((48, noise(seed=3)), (24, noise(seed=5)), (24, sine(hz=9_000))):
        sound[:fade] *= np.linspace(0, 1, fade)[:, np.newaxis]
        assert codes_of("cut-start", resample(join(silence(seconds=0.1), sound), 48_000, 44_100), rate=44_100) == []


@pytest.mark.parametrize("hz", [100, 500, 997])
@pytest.mark.parametrize(("rate", "to_hz"), [(48_000, 44_100), (96_000, 44_100), (192_000, 96_000)])
def test_a_zero_crossing_is_a_start_after_a_converter_too(codes_of, hz, rate, to_hz):
    whole = join(silence(seconds=0.1, rate=rate), sine(hz=hz, rate=rate))
    assert codes_of("cut-start", resample(whole, rate, to_hz), rate=to_hz) == []


def equalised(samples, rate=48_000):
    """Through a low cut at 40 Hz and highs that fall from 12 kHz on, as a channel strip has them."""
    low_cut = butter(1, 40, "high", fs=rate, output="sos")
    return sosfilt(np.vstack((low_cut, butter(1, 12_000, fs=rate, output="sos"))), samples, axis=0)


def ramped(samples, frames):
    samples[:frames] *= (np.arange(frames) / frames)[:, np.newaxis]
    return samples


@pytest.mark.parametrize("rate", [44_100, 96_000])
def test_an_equaliser_does_not_hide_it(codes_of, rate):
    cut = join(silence(seconds=0.1, rate=rate), sine(hz=300, phase=0.4, rate=rate))
    assert codes_of("cut-start", equalised(cut, rate), rate=rate) == MID_WAVE


@pytest.mark.parametrize("hz", [100, 500, 997, 2_000])
def test_a_zero_crossing_is_a_start_after_an_equaliser_too(codes_of, hz):
    assert codes_of("cut-start", equalised(join(silence(seconds=0.1), sine(hz=hz)))) == []


# A twentieth of a millisecond to a seventh, where a fade ought to be ten times as long.
@pytest.mark.parametrize(("rate", "frames"), [(44_100, 2), (48_000, 6), (96_000, 14)])
def test_a_fade_that_is_too_short_does_not_hide_it(found_by, rate, frames):
    for sound in (sine(hz=300, phase=1.2, rate=rate), noise(seed=4, rate=rate)):
        (finding,) = found_by("cut-start", join(silence(seconds=0.1, rate=rate), ramped(sound, frames)), rate=rate)
        assert finding.code == "cut-start:mid-wave"
        assert finding.start_s == pytest.approx(0.1, abs=0.0003)


def test_a_fade_of_a_millisecond_is_a_start(codes_of):
    for sound in (sine(hz=300, phase=1.2), sine(hz=3_000, phase=1.2), noise(seed=4)):
        assert codes_of("cut-start", ramped(sound, 48)) == []


def test_an_attack_is_no_cut(codes_of):
    times = np.arange(48_000)[:, np.newaxis] / 48_000
    assert codes_of("cut-start", ramped(noise(seed=4) * np.exp(-times / 0.015), 6)) == []
    kick = np.sin(2 * np.pi * 60 * times) * np.exp(-times / 0.2)
    assert codes_of("cut-start", ramped(0.3 * kick + noise(seed=4) * np.exp(-times / 0.003), 6)) == []


@pytest.mark.parametrize("dbfs", [-48.0, -52.0, -59.6])
@pytest.mark.parametrize("fade_s", [0.1, 0.3])
def test_a_quiet_sound_that_fades_in_is_not_cut(codes_of, dbfs, fade_s):
    for sound in (sine(hz=700, dbfs=dbfs), noise(dbfs=dbfs - 12, seed=5)):
        fade = np.minimum(1.0, np.arange(len(sound)) / (fade_s * 48_000))
        assert codes_of("cut-start", sound * np.square(fade)[:, np.newaxis]) == []


def test_a_quiet_sound_in_mid_wave_is_cut_where_it_can_be_heard(codes_of):
    assert codes_of("cut-start", sine(hz=50, dbfs=-52, phase=np.pi / 2)) == MID_WAVE
    assert codes_of("cut-start", sine(hz=50, dbfs=-62, phase=np.pi / 2)) == []
