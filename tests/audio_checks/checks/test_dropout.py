"""`dropout`: holes and repeated buffers in a sound that goes on."""

import numpy as np
import pytest

from tests.support.waves import join, noise, silence, sine

AT = 24_000


def hole(samples, frames, *, held=False, channels=slice(None)):
    samples = samples.copy()
    samples[AT : AT + frames, channels] = samples[AT - 1, channels] if held else 0.0
    return samples


@pytest.mark.parametrize("channels", [1, 2])
@pytest.mark.parametrize("held", [False, True], ids=["zeros", "held"])
def test_a_hole_is_found_where_it_is(found_by, channels, held):
    (finding,) = found_by("dropout", hole(noise(channels=channels), 960, held=held))
    assert (finding.code, finding.measured) == ("dropout:hole", channels)
    assert finding.start_s == pytest.approx(0.5, abs=0.001)
    assert finding.end_s == pytest.approx(0.52, abs=0.001)


def replaced(frames, stretch, *, seed=3):
    """Noise in which a stretch stands instead of its own samples."""
    samples = noise(dbfs=-12, seed=seed)
    samples[AT : AT + frames] = stretch
    return samples


@pytest.mark.parametrize("tau_s", [0.0003, 0.001, 0.003])
@pytest.mark.parametrize(("frames", "bits"), [(96, 24), (960, 24), (2_880, 24), (480, 16)])
def test_a_last_value_that_leaks_away_is_a_hole(found_by, tau_s, frames, bits):
    samples = noise(dbfs=-12, seed=3)
    last = AT - 20 + int(np.abs(samples[AT - 20 : AT, 0]).argmax())
    leak = np.exp(-np.arange(1, frames + 1) / (tau_s * 48_000))
    samples[last + 1 : last + 1 + frames, 0] = samples[last, 0] * leak
    (finding,) = found_by("dropout", samples, bits=bits)
    assert (finding.code, finding.measured) == ("dropout:hole", 1)
    assert finding.start_s == pytest.approx(last / 48_000, abs=0.001)
    assert finding.end_s == pytest.approx((last + frames) / 48_000, abs=0.001)


def test_a_straight_line_across_is_a_hole(codes_of):
    assert codes_of("dropout", replaced(240, np.linspace(0.2, -0.3, 240)[:, np.newaxis])) == ["dropout:hole"]


def test_a_smooth_stretch_of_another_shape_is_no_hole(codes_of):
    for shape in (np.cos(np.linspace(0, 1.5, 240)), np.hanning(480)[240:], np.sin(np.linspace(0, 40, 240))):
        assert codes_of("dropout", replaced(240, 0.5 * shape[:, np.newaxis])) == []
    times = np.arange(48_000)[:, np.newaxis] / 48_000
    assert codes_of("dropout", sine(hz=60) * np.exp(-(times % 0.1) / 0.003)) == []


@pytest.mark.parametrize("frames", [96, 480, 5_760])
@pytest.mark.parametrize("dbfs", [-45, -60])
def test_hiss_instead_of_the_sound_is_a_hole(found_by, frames, dbfs):
    hiss = noise(dbfs=dbfs, seconds=frames / 48_000, seed=5)
    for sound in (noise(dbfs=-12, seed=3), sine(hz=70, dbfs=-6) + sine(hz=550, dbfs=-20)):
        samples = sound.copy()
        samples[AT : AT + frames] = hiss
        (finding,) = found_by("dropout", samples)
        assert (finding.code, finding.measured) == ("dropout:hole", 1)
        assert finding.start_s == pytest.approx(0.5, abs=0.001)
        assert finding.end_s == pytest.approx(0.5 + frames / 48_000, abs=0.001)


def test_a_quieter_stretch_is_a_hole_only_where_it_is_cut_out_and_level(codes_of):
    hiss = noise(dbfs=-50, seconds=0.05, seed=5)
    fall = 10 ** (np.linspace(0, -1, 2_400) / 2)[:, np.newaxis]
    assert codes_of("dropout", replaced(2_400, hiss)) == ["dropout:hole"]
    assert codes_of("dropout", replaced(2_400, 10 * hiss)) == []  # no more than 18 dB down
    assert codes_of("dropout", replaced(2_400, hiss * fall)) == []  # a pause in which something dies away
    faded = replaced(2_400, hiss)
    faded[AT - 480 : AT] *= np.linspace(1, 0.01, 480)[:, np.newaxis]
    assert codes_of("dropout", faded) == []


def test_a_rhythm_of_hiss_is_meant(codes_of):
    gate = np.tile(np.concatenate((np.ones((4_800, 1)), np.full((2_400, 1), 0.01))), (6, 1))
    assert codes_of("dropout", join(noise(seconds=0.9) * gate, noise(seconds=0.1))) == []


def test_beats_of_low_tones_have_no_holes(codes_of):
    times = np.arange(48_000)[:, np.newaxis] / 48_000
    growl = sine(hz=90, dbfs=-6) * np.sin(np.pi * 45 * times) ** 8
    assert codes_of("dropout", growl + noise(dbfs=-60)) == []
    assert codes_of("dropout", sine(hz=31, dbfs=-6) + noise(dbfs=-60)) == []


@pytest.mark.parametrize("between", [(200,), (250, 350), (250, 700, 450)])
@pytest.mark.parametrize("frames", [96, 960])
def test_several_holes_in_a_row(found_by, between, frames):
    samples, at = noise(), AT
    for pause in (*between, 0):
        samples[at : at + frames] = 0.0
        at += frames + pause
    (finding,) = found_by("dropout", samples)
    assert (finding.code, finding.measured >= 2) == ("dropout:hole", True)  # the first and the last at least
    assert 0.499 < finding.start_s < finding.end_s < at / 48_000 + 0.001


def test_a_value_that_is_held_shows_in_a_sound_that_moves_little(codes_of):
    samples = sine(hz=100, dbfs=-36, phase=0.3) + sine(hz=170, dbfs=-40)
    assert codes_of("dropout", samples) == []
    assert codes_of("dropout", hole(samples, 240, held=True)) == ["dropout:hole"]


def test_one_channel_is_enough(codes_of):
    assert codes_of("dropout", hole(noise(channels=2), 480, channels=1)) == ["dropout:hole"]


# Two cells of 24 frames must stand still from end to end.
@pytest.mark.parametrize(("frames", "codes"), [(72, ["dropout:hole"]), (47, [])])
def test_shorter_than_a_millisecond_is_none(codes_of, frames, codes):
    assert codes_of("dropout", hole(noise(), frames)) == codes


# Up to 500 cells of half a millisecond.
@pytest.mark.parametrize(("seconds", "codes"), [(0.2495, ["dropout:hole"]), (0.26, [])])
def test_longer_than_a_quarter_of_a_second_is_a_pause(codes_of, seconds, codes):
    assert codes_of("dropout", hole(noise(seconds=2), round(seconds * 48_000))) == codes


def test_dither_in_the_hole_does_not_hide_it(codes_of):
    samples = hole(noise(), 960)
    samples[AT : AT + 960] = np.random.default_rng(1).integers(-2, 3, (960, 1)) / 32_768
    assert codes_of("dropout", samples, bits=16) == ["dropout:hole"]


def test_a_sound_that_fades_or_stops_has_no_hole(codes_of):
    fade = np.linspace(1, 0, 240)[:, np.newaxis]
    gate = np.concatenate((np.ones((4_800, 1)), fade, np.zeros((2_400, 1)), fade[::-1]))
    assert codes_of("dropout", noise() * np.tile(gate, (7, 1))[:48_000]) == []
    assert codes_of("dropout", join(noise(seconds=0.5), silence(seconds=0.5))) == []


def test_a_rhythm_of_holes_is_meant(codes_of):
    gate = np.tile(np.concatenate((np.ones((4_800, 1)), np.zeros((2_400, 1)))), (6, 1))
    assert codes_of("dropout", join(noise(seconds=0.9) * gate, noise(seconds=0.1))) == []


@pytest.mark.parametrize("hz", [30, 100, 400])
def test_square_waves_and_clipped_crests_stand_still_by_nature(codes_of, hz):
    assert codes_of("dropout", np.sign(sine(hz=hz, phase=0.1)) * 0.5) == []
    assert codes_of("dropout", np.clip(sine(hz=hz, dbfs=12) + noise(dbfs=-30), -1, 1 - 2**-15)) == []


@pytest.mark.parametrize("frames", [128, 512, 2_048])
@pytest.mark.parametrize("channels", [1, 2])
def test_a_buffer_that_plays_again(found_by, frames, channels):
    samples = noise(channels=channels)
    samples[AT : AT + frames] = samples[AT - frames : AT]
    (finding,) = found_by("dropout", samples)
    assert (finding.code, finding.measured) == ("dropout:repeat", 1.0)
    assert finding.start_s == pytest.approx(0.5)
    assert finding.end_s == pytest.approx(0.5 + frames / 48_000)


@pytest.mark.parametrize("frames", [192, 1_920])
@pytest.mark.parametrize("channels", [1, 2])
def test_an_older_buffer_of_a_ring_that_plays_again(found_by, frames, channels):
    samples = noise(channels=channels)
    samples[AT : AT + frames] = samples[AT - 3 * frames : AT - 2 * frames]
    (finding,) = found_by("dropout", samples)
    assert (finding.code, finding.measured) == ("dropout:repeat", 1.0)
    assert finding.start_s == pytest.approx(0.5, abs=1e-4)
    assert finding.end_s == pytest.approx(0.5 + frames / 48_000, abs=1e-4)


def test_strokes_and_loops_that_are_meant_to_come_again_are_no_older_buffers(codes_of):
    stroke, rest, other = (noise(seconds=0.02, seed=seed) for seed in (2, 3, 4))
    assert codes_of("dropout", join(noise(seconds=0.2), *[stroke, rest] * 6, noise(seconds=0.2))) == []
    assert codes_of("dropout", join(silence(seconds=0.2), stroke, rest, other, stroke, noise(seconds=0.2))) == []


@pytest.mark.parametrize("periods", [2, 3, 4])
def test_a_tone_that_starts_late_is_no_repeat(codes_of, periods):
    tone = sine(hz=100, dbfs=-6, seconds=periods / 100)
    assert codes_of("dropout", join(silence(seconds=0.3), tone, noise(seconds=0.3))) == []
    assert codes_of("dropout", join(noise(seconds=0.3), silence(seconds=0.3), tone, noise(seconds=0.3))) == []


def test_periods_and_stutters_that_are_meant_are_no_repeats(codes_of):
    assert codes_of("dropout", sine(hz=100, dbfs=-6)) == []
    assert codes_of("dropout", join(noise(seconds=0.2), *[noise(seconds=0.03, seed=2)] * 8, noise(seconds=0.2))) == []


@pytest.mark.parametrize("samples", [silence(), silence(seconds=1 / 48_000) + 0.5, sine(hz=50), noise(channels=2)])
def test_whole_sounds_pass(codes_of, samples):
    assert codes_of("dropout", samples) == []
