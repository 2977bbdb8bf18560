import numpy as np
import pytest

from audio_checks import fix_master, parse_spec, repair_spots
from tests.support.waves import join, silence, sine, write_wav

SPEC = parse_spec("format = 1\n[limits]\nsample_peak_dbfs = -1.0\nhead_silence_ms = 5\ntail_silence_ms = 5\n")


@pytest.fixture
def out(tmp_path):
    (tmp_path / "out").mkdir()
    return tmp_path / "out"


def spots(path, out):
    return {spot.kind: spot for spot in repair_spots(path, fix_master(path, SPEC, out))}


def test_each_repair_is_seen_where_it_is_on_one_axis(tmp_path, out):
    sound = join(silence(seconds=0.2), sine(hz=440, dbfs=0.0, seconds=1.0, phase=1.0), silence(seconds=0.3))
    found = spots(write_wav(tmp_path / "door.wav", sound), out)
    assert set(found) == {"head", "tail", "gain"}
    head, tail, gain = found["head"], found["tail"], found["gain"]
    assert (head.start_s, head.after_start_s) == (0.0, pytest.approx(0.195))
    assert head.end_s == head.after_end_s == pytest.approx(0.195 + 0.03, abs=1e-3)
    assert (tail.end_s, tail.after_end_s) == (pytest.approx(1.5), pytest.approx(1.205))
    assert gain.end_s - gain.start_s == pytest.approx(0.03, abs=1e-3)
    assert gain.before.highest.max() == pytest.approx(1.0, abs=1e-4)
    assert gain.after.highest.max() == pytest.approx(10 ** (-1 / 20), abs=1e-4)
    # The same places of the same sound, one factor apart.
    assert np.allclose(gain.after.highest, gain.before.highest * 10 ** (-1 / 20), atol=1e-4)


def test_what_is_left_has_points_in_proportion(tmp_path, out):
    sound = join(silence(seconds=0.2), sine(hz=440, dbfs=-6.0, seconds=1.0, phase=1.0))
    head = spots(write_wav(tmp_path / "door.wav", sound), out)["head"]
    share = (head.after_end_s - head.after_start_s) / (head.end_s - head.start_s)
    assert head.after.points / head.before.points == pytest.approx(share, abs=0.01)
    reported = head.to_dict()
    assert len(reported["before"]["min"]) == head.before.points == 480


def test_nothing_to_see_where_the_sound_is_the_same(tmp_path, out):
    assert spots(write_wav(tmp_path / "fine.wav", sine(hz=440)), out) == {}


def test_a_spot_ends_with_the_sound(tmp_path, out):
    gain = spots(write_wav(tmp_path / "tick.wav", sine(hz=12_000, dbfs=0.0, seconds=0.001, phase=np.pi / 2)), out)[
        "gain"
    ]
    assert (gain.start_s, gain.end_s, gain.before.points) == (0.0, pytest.approx(0.001), 48)
