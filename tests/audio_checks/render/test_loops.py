"""Loops inside a file: seamless turn after turn, in place, and at most half a frame off their period."""

import itertools

import numpy as np
import pytest

from audio_checks import wav
from audio_checks.errors import RenderRefused
from audio_checks.render import loops
from audio_checks.render.loops import fitted_loop, part, with_turns
from audio_checks.render.render import render_master
from audio_checks.spec.delivery_spec import Target
from tests.support.waves import noise, sine, smpl, write_wav

FILM = Target("film", 48_000, 24)


def samples_of(path):
    with wav.open_regular(path) as file:
        return np.concatenate(list(wav.blocks(file, wav.read_layout(file))))


@pytest.mark.parametrize("start", [9_600, 9_601, 12_345])
def test_a_loop_of_whole_turns_is_the_tone_itself(tmp_path, start):
    # Attack, loop and what comes after are one tone, so the render must be it too, seams included.
    tone = sine(hz=500, dbfs=-6, seconds=1, rate=96_000)
    points = start, start + 96 * 192 - 1
    master = write_wav(tmp_path / "a.wav", tone, rate=96_000, before=[smpl([points], rate=96_000)])
    rendered = render_master(master, FILM, tmp_path / "game.wav")
    middle = slice(1_000, 47_000)  # the tone itself begins and ends within the filter's reach
    wanted = sine(hz=500, dbfs=-6, seconds=1, rate=48_000)
    assert np.abs(samples_of(tmp_path / "game.wav") - wanted)[middle].max() < 2.0 / 2**23
    assert rendered.loop_points == ((-(-start // 2), -(-start // 2) + 96 * 96 - 1),)


@pytest.mark.parametrize("to_hz", [48_000, 44_100, 22_050, 11_025])
@pytest.mark.parametrize("frames", [641, 9_601, 40_003])
def test_it_is_what_endless_turning_sounds_like(tmp_path, to_hz, frames):
    # The loop of the file against the loop alone, which is filtered in a circle: the same Fourier series.
    start = 9_600
    sound = noise(dbfs=-20, seconds=1, rate=96_000)
    master = write_wav(tmp_path / "a.wav", sound, rate=96_000, before=[smpl([(start, start + frames - 1)])])
    rendered = render_master(master, Target("t", to_hz, 64, encoding="float"), tmp_path / "game.wav")
    ((first, last),) = rendered.loop_points
    turn = samples_of(tmp_path / "game.wav")[first : last + 1, 0]
    heard = samples_of(master)[start : start + frames, 0]
    late = first * 96_000 / to_hz - start  # frames of the master
    wanted, got = np.fft.rfft(heard) / frames, np.fft.rfft(turn) / len(turn)
    passed = int(0.94 * len(turn) / 2)
    shifted = wanted[:passed] * np.exp(2j * np.pi * np.arange(passed) * late / frames)
    assert np.abs(shifted - got[:passed]).max() < 1e-9
    assert abs(rendered.loop_fit_frames) <= 0.5
    assert len(turn) - frames * to_hz / 96_000 == pytest.approx(rendered.loop_fit_frames)


def test_the_seam_is_measured_before_and_after(tmp_path):
    sound = np.concatenate([noise(dbfs=-60, seconds=0.1), sine(hz=100.5, dbfs=-6, seconds=0.5, phase=np.pi / 2)])
    master = write_wav(tmp_path / "a.wav", sound, before=[smpl([(4_800, 4_800 + 24_000 - 1)])])
    rendered = render_master(master, Target("t", 44_100, 16), tmp_path / "game.wav")
    assert rendered.seam_before.step_db > 20
    assert rendered.loss.seam_before == rendered.seam_before
    assert rendered.loss.seam_after == rendered.seam_after


def test_back_and_forth_is_no_circle(tmp_path):
    points = smpl([(4_800, 9_599)], rate=96_000)
    alternating = points[: 8 + 36 + 4] + (1).to_bytes(4, "little") + points[8 + 36 + 8 :]
    sound = noise(dbfs=-20, seconds=0.2, rate=96_000)
    for name, chunks in (("plain", []), ("turning", [alternating])):
        master = write_wav(tmp_path / f"{name}.wav", sound, rate=96_000, before=chunks)
        render_master(master, Target("t", 48_000, 64, encoding="float"), tmp_path / f"{name}_game.wav")
    assert np.array_equal(samples_of(tmp_path / "plain_game.wav"), samples_of(tmp_path / "turning_game.wav"))


@pytest.mark.parametrize(("start", "end"), [(0, 0), (5, 5), (0, 95_998), (95_999, 95_999), (95_990, 95_999)])
@pytest.mark.parametrize("to_hz", [44_100, 11_025])
def test_the_smallest_loops_stay_inside(tmp_path, start, end, to_hz):
    master = write_wav(tmp_path / "a.wav", noise(dbfs=-20, rate=96_000), rate=96_000)
    rendered = render_master(master, Target("t", to_hz, 16), tmp_path / "game.wav", loop_points=(start, end))
    ((first, last),) = rendered.loop_points
    assert 0 <= first <= last < rendered.frames == to_hz


@pytest.mark.parametrize("points", [(5, 4), (0, 96_000), (-1, 5)])
def test_points_outside_are_refused(tmp_path, points):
    master = write_wav(tmp_path / "a.wav", noise(dbfs=-20, rate=96_000), rate=96_000)
    with pytest.raises(RenderRefused) as refused:
        render_master(master, FILM, tmp_path / "game.wav", loop_points=points)
    assert refused.value.code == "render:loop-points"


def test_a_long_loop_is_read_again_and_not_held(tmp_path, monkeypatch):
    sound = noise(dbfs=-20, seconds=1, rate=96_000)
    master = write_wav(tmp_path / "a.wav", sound, rate=96_000, before=[smpl([(9_600, 49_602)], rate=96_000)])
    held = render_master(master, FILM, tmp_path / "held.wav")
    monkeypatch.setattr(loops, "HELD_SAMPLES", 100)
    assert render_master(master, FILM, tmp_path / "read.wav").sha256 == held.sha256


def test_two_loops_and_one_that_begins_inside_another():
    sound = noise(dbfs=-20, seconds=0.5, rate=96_000)
    fitted = [
        fitted_loop(*points, 24_000, 96_000, 48_000) for points in ((0, 9_599), (4_800, 14_399), (20_000, 29_999))
    ]
    rates = {"channels": 1, "sample_rate_hz": 96_000, "to_hz": 48_000, "shelf": 1.0}
    once = np.zeros((24_000, 1))
    cuts = [once[start : start + 777] for start in range(0, len(once), 777)]
    blocks = list(with_turns(cuts, lambda: [sound], fitted, **rates))
    turned = np.concatenate(blocks)[:, 0]
    assert turned[:4_800].any()
    assert not turned[4_800:10_000].any()
    assert turned[10_000:15_000].any()
    assert not turned[15_000:].any()


def test_a_part_of_a_stream_however_it_is_cut():
    whole = np.arange(100.0)[:, np.newaxis]
    for size in (1, 7, 100):
        blocks = [whole[at : at + size] for at in range(0, 100, size)]
        got = np.concatenate(list(part(lambda blocks=blocks: iter(blocks), 13, 50, 1)()))
        assert np.array_equal(got, whole[13:63])
    assert len(list(itertools.chain.from_iterable(part(lambda: [whole], 90, 50, 1)()))) == 10
