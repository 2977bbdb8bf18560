"""One key, one file: what decides the bytes changes the key, and nothing else does."""

from dataclasses import replace

import pytest

from audio_checks import render_key
from audio_checks.spec.delivery_spec import Target

PC = Target("pc", 44_100, 16)


def key(target=PC, master="a" * 64, **more):
    limits = {"sample_peak_limit_dbfs": -0.1, "true_peak_limit_dbtp": None, "tolerance_db": 0.05}
    return render_key(master, target, **{"loop": False, **limits, **more})


@pytest.mark.parametrize(
    "change",
    [
        {"sample_rate_hz": 22_050},
        {"bit_depth": 8},
        {"channels": 1},
        {"dither": "shaped"},
        {"over_peak": "refuse"},
        {"mono_gains": (0.7, 0.3)},
        {"chunks": "all"},
        {"shelf_db": 2.0},
        {"trim_below_dbfs": -60.0},
        {"fade_in_ms": 1.0},
        {"fade_out_ms": 1.0},
    ],
)
def test_what_changes_the_sound_changes_the_key(change):
    assert key(replace(PC, **change)) != key()


def test_a_codec_and_its_quality_change_the_key():
    vorbis = Target("pc", 44_100, 32, encoding="vorbis", dither="none", quality=0.5)
    keys = {key(), key(vorbis), key(replace(vorbis, quality=0.4)), key(replace(vorbis, encoding="opus"))}
    assert len(keys | {key(replace(PC, encoding="flac"))}) == 5


def test_keys_of_plain_files_stay_what_they_were():
    """Another key would render every file of every project again."""
    assert key() == "9f7c01c39bc2f1e04bd5e97c91a3d7b06feeec43bc9a0988b11ad2d1ce716622"


@pytest.mark.parametrize(
    "more",
    [
        {"master": "b" * 64},
        {"loop": True},
        {"loop_points": (0, 9)},
        {"sample_peak_limit_dbfs": None},
        {"tolerance_db": 0},
    ],
)
def test_so_does_what_it_is_made_from_and_held_to(more):
    assert key(**more) != key()


@pytest.mark.parametrize(
    "change",
    [
        {"name": "game"},
        {"budget_bytes": 1},
        {"codec_ratio": 4.0},
        {"streamed": True},
        {"stream_buffer_bytes": 1},
        {"folder": "Assets"},
    ],
)
def test_name_and_memory_make_no_other_file(change):
    assert key(replace(PC, **change)) == key()
