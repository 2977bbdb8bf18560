"""What browsers play and draw: formats within their reach, turned round where asked."""

import os
import stat
from functools import partial

import numpy as np
import pytest

from audio_checks import wav
from audio_checks.render.preview import is_preview, playable_rate_hz, preview, wave_shapes
from audio_checks.render.render import render_master
from audio_checks.spec.delivery_spec import Target
from tests.support import waves


def read(path):
    with wav.open_regular(path) as file:
        layout = wav.read_layout(file)
        return layout, np.concatenate(list(wav.blocks(file, layout)))


@pytest.mark.parametrize("make", [preview, partial(render_master, target=Target("game", 48_000, 16))])
def test_a_file_reaches_the_disk_where_it_must_last_and_is_the_same_where_not(tmp_path, monkeypatch, make):
    synced = []
    monkeypatch.setattr(os, "fsync", lambda descriptor: synced.append(os.fstat(descriptor).st_mode))
    master = waves.write_wav(tmp_path / "a.wav", waves.sine(hz=441, dbfs=-6, channels=2), bits=24)
    synced.clear()
    make(master, out_path=tmp_path / "passing.wav", durable=False)
    assert synced == []
    make(master, out_path=tmp_path / "lasting.wav")
    assert [stat.S_ISDIR(mode) for mode in synced] == [False, True]
    assert (tmp_path / "passing.wav").read_bytes() == (tmp_path / "lasting.wav").read_bytes()


@pytest.mark.parametrize(
    ("rate", "wanted"),
    [(8_000, 8_000), (44_100, 44_100), (48_000, 48_000), (88_200, 44_100), (96_000, 48_000), (176_400, 44_100),
     (192_000, 48_000), (64_000, 48_000)],
)  # fmt: skip
def test_rates_that_browsers_play(rate, wanted):
    assert playable_rate_hz(rate) == wanted


@pytest.mark.parametrize(("channels", "wanted"), [(1, 1), (2, 2), (6, 1)])
@pytest.mark.parametrize(
    ("rate", "bits", "encoding"), [(96_000, 24, "pcm"), (44_100, 16, "pcm"), (48_000, 32, "float")]
)
def test_a_preview_is_plain(tmp_path, channels, wanted, rate, bits, encoding):
    sound = waves.sine(hz=441, dbfs=-6, seconds=0.5, rate=rate, channels=channels)
    master = waves.write_wav(tmp_path / "a.wav", sound, rate=rate, bits=bits, encoding=encoding)
    preview(master, tmp_path / "preview.wav")
    layout, samples = read(tmp_path / "preview.wav")
    assert (layout.bit_depth, layout.channels, layout.extensible) == (16, wanted, False)
    assert layout.sample_rate_hz <= 48_000
    assert layout.frames == pytest.approx(0.5 * layout.sample_rate_hz, abs=1)
    middle = samples[len(samples) // 4 : 3 * len(samples) // 4, 0]
    assert 20 * np.log10(np.abs(middle).max()) == pytest.approx(-6, abs=0.05)


def test_backwards_is_the_same_sound_turned_round(tmp_path):
    master = waves.write_wav(tmp_path / "a.wav", waves.noise(seconds=3, channels=2), rate=96_000)
    preview(master, tmp_path / "forwards.wav")
    preview(master, tmp_path / "backwards.wav", backwards=True)
    assert np.array_equal(read(tmp_path / "forwards.wav")[1][::-1], read(tmp_path / "backwards.wav")[1])


def test_a_float_master_over_full_scale_is_lowered_not_clipped(tmp_path):
    tone = waves.sine(hz=441, dbfs=6, seconds=0.5)
    master = waves.write_wav(tmp_path / "a.wav", tone, bits=32, encoding="float")
    assert preview(master, tmp_path / "p.wav").attenuation_db == pytest.approx(6, abs=0.01)
    samples = read(tmp_path / "p.wav")[1]
    assert np.abs(samples - 10 ** (-6 / 20) * tone).max() < 1e-3


def test_shapes_small_and_large(tmp_path):
    master = waves.write_wav(tmp_path / "a.wav", waves.click(at_s=0.75, dbfs=-6, seconds=1))
    small, large = wave_shapes(master)
    assert (small.points, large.points) == (240, 4_096)
    assert np.argmax(small.highest) == 180
    assert np.argmax(large.highest) == 3_072
    assert small.highest.max() == pytest.approx(10 ** (-6 / 20), abs=1e-6)


def test_the_shape_of_a_very_short_sound_has_a_point_a_frame(tmp_path):
    master = waves.write_wav(tmp_path / "a.wav", np.array([0.25, -0.5, 0.125]))
    assert [shape.highest.tolist() for shape in wave_shapes(master)] == [[0.25, -0.5, 0.125]] * 2


@pytest.mark.parametrize(("master_rate", "rate"), [(48_000, 48_000), (96_000, 48_000), (44_100, 44_100)])
@pytest.mark.parametrize("loop", [False, True])
def test_a_game_file_that_plays_as_the_preview_is_the_preview(tmp_path, master_rate, rate, loop):
    sound = waves.noise(seconds=0.3, rate=master_rate, channels=2)
    master = waves.write_wav(tmp_path / "a.wav", sound, rate=master_rate, bits=24)
    target = Target("game", rate, 16, over_peak="refuse", folder="sfx", mono_gains=(1.0, 0.0))
    rendered = render_master(master, target, tmp_path / "game.wav", loop=loop, true_peak_limit_dbtp=-1.0)
    assert is_preview(rendered, target, master_rate)
    preview(master, tmp_path / "preview.wav", loop=loop)
    assert (tmp_path / "game.wav").read_bytes() == (tmp_path / "preview.wav").read_bytes()


@pytest.mark.parametrize(
    "other",
    [
        {"sample_rate_hz": 44_100},
        {"bit_depth": 8},
        {"bit_depth": 32, "encoding": "float"},
        {"channels": 1},
        {"dither": "shaped"},
        {"dither": "none"},
        {"trim_below_dbfs": -30.0},
        {"fade_in_ms": 5.0},
        {"fade_out_ms": 5.0},
        {"sample_peak_limit_dbfs": -9.0},
    ],
    ids=lambda other: next(iter(other)),
)
def test_a_game_file_that_differs_from_the_preview_is_distinguished(tmp_path, other):
    limit_dbfs = other.pop("sample_peak_limit_dbfs", None)
    sound = waves.noise(seconds=0.3, channels=2) * np.linspace(1, 0, 14_400)[:, np.newaxis]
    master = waves.write_wav(tmp_path / "a.wav", sound, bits=24)
    target = Target(**{"name": "game", "sample_rate_hz": 48_000, "bit_depth": 16} | other)
    rendered = render_master(master, target, tmp_path / "game.wav", sample_peak_limit_dbfs=limit_dbfs)
    assert not is_preview(rendered, target, 48_000)
    preview(master, tmp_path / "preview.wav")
    assert (tmp_path / "game.wav").read_bytes() != (tmp_path / "preview.wav").read_bytes()


def test_a_game_file_of_more_than_two_channels_is_no_preview(tmp_path):
    master = waves.write_wav(tmp_path / "a.wav", waves.noise(seconds=0.1, channels=6), bits=24)
    target = Target("game", 48_000, 16)
    assert not is_preview(render_master(master, target, tmp_path / "game.wav"), target, 48_000)
