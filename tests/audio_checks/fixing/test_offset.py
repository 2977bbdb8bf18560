"""A DC offset taken out of a copy: exactly where the sound stands on it, from zero at the edges, or not at all."""

import numpy as np
import pytest

from audio_checks import fix_master, parse_spec, repair_spots, wav
from audio_checks.fixing.offset import LOOPED, UNEVEN
from tests.support.waves import join, noise, silence, sine, smpl, swelling, write_wav

SPEC = """
format = 1
[accept]
bit_depths = [16, 24, 32]
[checks]
click = "off"
cut-start = "off"
cut-tail = "off"
[limits]
dc_offset_percent = 1.0
"""
RATE = 48_000


@pytest.fixture
def fixed(tmp_path):
    """Fix samples, or a whole file, by the spec with more limits."""
    (tmp_path / "out").mkdir()

    def fix(sound, more="", **how):
        path = tmp_path / "laser.wav"
        write_wav(path, sound, **how)
        return path, fix_master(path, parse_spec(SPEC + more), tmp_path / "out")

    return fix


def samples_of(path):
    with wav.open_regular(path) as file:
        return np.concatenate(list(wav.blocks(file, wav.read_layout(file))))


def tone(seconds=1.0, dbfs=-12.0, hz=997):
    return sine(hz=hz, dbfs=dbfs, seconds=seconds)


def kinds(made):
    return [repair.kind for repair in made.repairs]


@pytest.mark.parametrize("depth", [16, 24])
def test_a_constant_goes_and_every_sample_moves_by_the_same_steps(fixed, depth):
    path, made = fixed(tone(dbfs=-40.0) + 0.03, bits=depth)  # it begins and ends close to its offset
    moved = samples_of(path) - samples_of(made.path)
    step = 2.0 ** (1 - depth)
    assert kinds(made) == ["offset"]
    assert made.conforms
    assert np.ptp(moved) == 0.0
    assert moved[0, 0] == pytest.approx(0.03, abs=step)
    assert abs(samples_of(made.path).mean()) <= step
    assert made.repairs[0].words == "DC offset of 3.00 % taken out"


def test_each_channel_has_its_own(fixed):
    sound = np.hstack([tone() + 0.04, tone() - 0.02])
    _, made = fixed(sound)
    assert samples_of(made.path).mean(axis=0) == pytest.approx([0.0, 0.0], abs=1e-6)


def test_a_sound_that_begins_and_ends_at_zero_still_does(fixed):
    path, made = fixed(swelling(tone(hz=1000) + 0.05), bits=24)
    copy = samples_of(made.path)
    assert made.conforms
    assert np.abs(copy[[0, -1]]).max() <= np.abs(samples_of(path)[[0, -1]]).max()
    assert abs(copy.mean()) < 1e-6
    # Nowhere does the constant come or go faster than a raised cosine of 10 ms does.
    moved = (samples_of(path) - copy)[:, 0]
    assert np.abs(np.diff(moved)).max() < 0.055 * np.pi / 2 / 480 + 2.0**-22
    assert "from zero at the edges" in made.repairs[0].words


@pytest.mark.parametrize(
    "sound",
    [
        pytest.param(join(tone() + 0.06, silence()), id="silence after it"),
        pytest.param(join(tone(), tone() + 0.06), id="in the second half alone"),
        pytest.param(
            (tone(2.0) + 0.2) * np.exp(-np.arange(2 * RATE) / (RATE / 4))[:, np.newaxis], id="dies away with the sound"
        ),
    ],
)
def test_an_offset_that_is_not_the_same_throughout_stays(fixed, sound):
    _, made = fixed(sound)
    assert made.path is None
    assert [(one.finding.code, one.why) for one in made.left] == [("dc-offset:over", UNEVEN)]


def test_a_low_tone_is_no_uneven_offset(fixed):
    _, made = fixed(tone(3.0, dbfs=-3.0, hz=23) * 0.9 + 0.03)
    assert made.conforms


def test_loop_points_where_the_edges_are_at_zero(fixed):
    loop = [smpl([(1000, 40_000)])]
    sound = swelling(tone() + 0.05)
    _, made = fixed(sound, after=loop)
    assert (made.path, made.left[0].why) == (None, LOOPED)
    _, made = fixed(tone(dbfs=-40.0) + 0.05, after=loop)
    assert made.conforms


def test_a_peak_that_would_leave_full_scale_is_lowered_with_the_rest(fixed):
    _, made = fixed(np.clip(tone(dbfs=-0.2) - 0.04, -1.0, 1.0), "sample_peak_dbfs = -0.1\ntrue_peak_dbtp = -0.1\n")
    copy = samples_of(made.path)
    assert np.abs(copy).max() <= 10 ** (-0.1 / 20) + 1e-6
    assert made.after.measurements["true_peak_dbtp"] <= -0.05
    assert made.conforms


def test_full_scale_holds_without_a_limit_of_the_spec(fixed):
    peaks = np.full((RATE, 1), -0.05)
    peaks[RATE // 2] = 1.0 - 2.0**-23  # the constant of -5 % out of it would be 1.05
    _, made = fixed(peaks, bits=24)
    copy = samples_of(made.path)
    assert copy.max() == pytest.approx(1.0, abs=1e-4)
    assert abs(copy.mean()) < 1e-6
    assert kinds(made) == ["offset", "gain"]


def test_silence_that_the_offset_hid_is_trimmed_too(fixed):
    hidden = join(silence(seconds=0.1), tone()) + 0.02
    _, made = fixed(hidden, "head_silence_ms = 5\n")
    assert kinds(made) == ["head", "offset"]
    assert made.conforms
    assert len(samples_of(made.path)) == pytest.approx(len(hidden) - RATE // 10 + 240, abs=3)


def test_what_would_bring_another_fault_is_left(fixed):
    quiet = join(silence(seconds=0.5), tone(seconds=0.1), silence(seconds=0.5)) + 0.02
    _, made = fixed(quiet, "", bits=24)
    assert made.conforms  # without limits on silence the sound is only centred
    _, made = fixed(quiet, "silence_below_dbfs = -11.7\n")  # with its offset it reached -11.4 dBFS
    assert made.path is None
    assert "Without its offset it would be returned for silence:file." in [one.why for one in made.left]


def test_other_repairs_are_made_where_the_offset_stays(fixed):
    _, made = fixed(join(tone(), tone() + 0.06), "sample_peak_dbfs = -12.0\n")
    assert kinds(made) == ["gain"]
    assert [(one.finding.code, one.why) for one in made.left] == [("dc-offset:over", UNEVEN)]


def test_float_samples_and_noise(fixed):
    _, made = fixed(noise(seconds=2.0, dbfs=-20.0) + 0.015, bits=32, encoding="float")
    assert made.conforms
    assert abs(samples_of(made.path).mean()) < 1e-7


def test_one_frame_has_nothing_but_its_offset(fixed):
    _, made = fixed(np.full(1, 0.5))
    assert made.path is None or samples_of(made.path)[0, 0] == 0.0


def test_the_start_is_shown_before_and_after(fixed):
    path, made = fixed(tone() + 0.03)
    (spot,) = repair_spots(path, made)
    assert (spot.kind, spot.start_s) == ("offset", 0.0)
    assert spot.before.to_dict() != spot.after.to_dict()


def test_the_same_master_gives_the_same_bytes(fixed):
    path, made = fixed(swelling(tone() + 0.05), bits=16)
    once = made.path.read_bytes()
    assert fix_master(path, parse_spec(SPEC), made.path.parent).path.read_bytes() == once
