"""Recordings by repository: which are reserved, which count as dry, and that rooms lose their direct sound."""

import csv

import numpy as np
import pytest

from tests.support.waves import write_wav
from training import recorded
from training.dataset import RATE

pytestmark = pytest.mark.slow


def dying(rt60_s, seconds=1.0, seed=1):
    times_s = np.arange(int(seconds * RATE)) / RATE
    return (
        np.random.default_rng(seed).normal(0, 0.2, len(times_s))[:, np.newaxis]
        * 10 ** (-3 * times_s / rt60_s)[:, np.newaxis]
    )


@pytest.fixture
def folder(tmp_path, monkeypatch):
    files = {
        "game/a/short.wav": dying(0.2),
        "game/a/long.wav": dying(2.0),
        "pairs/muldjordkit/close/1.wav": dying(1.5),
        "pairs/muldjordkit/ambience_L/1.wav": dying(0.2),
    }
    with (tmp_path / "FILES.csv").open("w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["file", "repository"])
        for name, samples in files.items():
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            write_wav(tmp_path / name, samples, rate=RATE)
            rows.writerow([name, f"someone/{name.split('/')[1]}"])
    monkeypatch.setenv("RECORDED_DIR", str(tmp_path))


def test_the_hash_of_its_name_reserves_a_repository():
    assert recorded.is_reserved("openclonk/openclonk")
    assert not recorded.is_reserved("ValveSoftware/steamvr_unity_plugin")


@pytest.mark.usefixtures("folder")
def test_dry_is_what_is_stated_so_or_falls_fast():
    found = {recording.folder: recording for recording in recorded.recordings()}
    assert set(found) == {"game/a", "pairs/muldjordkit/close"}
    np.testing.assert_allclose(found["game/a"].samples, dying(0.2), atol=1e-6)
    assert {one.folder: one.kind for one in found.values()} == {
        "game/a": "event",
        "pairs/muldjordkit/close": "natural-decay",
    }


@pytest.mark.usefixtures("folder")
def test_room_microphones_are_apart():
    assert [recording.folder for recording in recorded.recordings(in_a_room=True)] == ["pairs/muldjordkit/ambience_L"]


def test_a_measured_room_loses_its_direct_sound_and_keeps_its_decay_time(tmp_path, monkeypatch):
    response = np.repeat(dying(0.9, seconds=1.5), 2, axis=1) * 0.1
    response[0] = 1.0
    (tmp_path / "ir").mkdir()
    write_wav(tmp_path / "ir" / "medium_hall.flac", response, rate=RATE)
    monkeypatch.setenv("RECORDED_DIR", str(tmp_path))
    own, *damped = recorded.rooms(to_learn=True)
    assert np.abs(own.samples).max() < 0.5
    assert own.rt60_s == pytest.approx(0.9, rel=0.1)
    assert [one.rt60_s for one in damped] == pytest.approx([0.35, 0.6], rel=0.15)
    assert recorded.rooms(to_learn=False) == []


def test_nothing_is_there_without_a_folder(monkeypatch):
    monkeypatch.delenv("RECORDED_DIR", raising=False)
    assert recorded.recordings() == []
    assert recorded.rooms(to_learn=True) == []
