"""Recordings that `lossy` is tried on: how each came, and the bit rate of those in Ogg Vorbis."""

import csv

import pytest
import soundfile

from tests.support.waves import noise, write_wav
from training.lossy import by_recording, recordings_as_they_came

pytestmark = pytest.mark.slow


@pytest.fixture
def folder(tmp_path, monkeypatch):
    with (tmp_path / "FILES.csv").open("w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["file", "rate", "subtype"])
        for name, rate in (("ir/hall.wav", 44_100), ("game/hit.wav", 44_100), ("dry/low.wav", 22_050)):
            (tmp_path / name).parent.mkdir(exist_ok=True)
            write_wav(tmp_path / name, noise(rate=rate), rate=rate, bits=16)
            rows.writerow([name, rate, "PCM_16"])
        for name, level, channels in (("game/best.ogg", 0.0, 2), ("game/usual.ogg", 0.5, 1)):  # quality 10 and 5
            samples = noise(rate=44_100, channels=channels)
            soundfile.write(tmp_path / name, samples, 44_100, format="OGG", subtype="VORBIS", compression_level=level)
            rows.writerow([name, 44_100, "VORBIS"])
    monkeypatch.setenv("RECORDED_DIR", str(tmp_path))


@pytest.mark.usefixtures("folder")
def test_recordings_by_how_they_came():
    recordings = list(recordings_as_they_came())
    assert [(recording.way, recording.kbit_s) for recording in recordings] == [
        ("game", None),
        ("Vorbis", 500),
        ("Vorbis", 192),
    ]
    counts = [line.split(" | ")[1] for line in by_recording(recordings).splitlines()[2:]]
    assert counts == ["0", "1", "1", "1"]


def test_without_a_folder_there_are_none(monkeypatch):
    monkeypatch.delenv("RECORDED_DIR", raising=False)
    assert list(recordings_as_they_came()) == []
