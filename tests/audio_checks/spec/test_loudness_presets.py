"""Whole mixes beside their presets: information, by every format, and no finding."""

import json
import math

import pytest

from audio_checks import measure_file
from audio_checks.cli import main
from audio_checks.spec.loudness_presets import PRESETS, in_words
from tests.support.waves import silence, sine, write_wav


def stands(name, loudness_lufs, true_peak_dbtp=-3.0):
    return PRESETS[name].against({"integrated_lufs": loudness_lufs, "true_peak_dbtp": true_peak_dbtp})


@pytest.mark.parametrize(
    ("name", "loudness_lufs", "true_peak_dbtp", "within"),
    [
        ("ebu-r128", -23.5, -1.0, True),
        ("ebu-r128", -22.4, -3.0, False),
        ("ebu-r128", -23.0, -0.9, False),
        ("aswg-home", -26.0, -1.0, True),
        ("aswg-home", -21.9, -1.0, False),
        ("aswg-portable", -16.0, -1.0, True),
        ("aswg-portable", -24.0, -1.0, False),
        ("aswg-home", -math.inf, -math.inf, None),
        ("aswg-home", None, -1.0, None),
    ],
)
def test_within(name, loudness_lufs, true_peak_dbtp, within):
    assert stands(name, loudness_lufs, true_peak_dbtp)["within"] is within


def test_in_words():
    assert in_words("ebu-r128", stands("ebu-r128", -18.3)) == (
        "ebu-r128: 4.7 LU over -23 LUFS (±0.5), true peak within"
    )
    assert in_words("aswg-home", stands("aswg-home", -30.0, 0.2)) == (
        "aswg-home: 6.0 LU under -24 LUFS (±2), true peak 1.2 dB over -1 dBTP"
    )
    assert "too short" in in_words("aswg-home", stands("aswg-home", None))


@pytest.mark.slow
def test_a_mix_is_set_beside_them(tmp_path, capsys):
    # A 997 Hz sine in both channels reads the RMS of one plus 3.01 dB.
    path = write_wav(tmp_path / "trailer.wav", sine(hz=997, dbfs=-20.0, seconds=5, channels=2))
    entry = measure_file(path, presets=["ebu-r128", "aswg-portable"])
    assert entry.loudness_presets["ebu-r128"]["loudness_off_lu"] == pytest.approx(3.0, abs=0.05)
    assert main(["measure", "--preset", "ebu-r128", str(path)]) == 0
    assert "ebu-r128: 3.0 LU over -23 LUFS" in capsys.readouterr().out
    assert main(["measure", "--preset", "ebu-r128", "--format", "json", str(path)]) == 0
    (reported,) = json.loads(capsys.readouterr().out)["files"]
    assert reported["loudness_presets"]["ebu-r128"]["within"] is False


def test_without_being_asked_nothing_is_reported(tmp_path):
    path = write_wav(tmp_path / "effect.wav", sine(hz=997, seconds=0.2))
    assert "loudness_presets" not in measure_file(path).to_measured()
    assert measure_file(path, presets=["ebu-r128"]).loudness_presets["ebu-r128"]["within"] is None
    assert measure_file(write_wav(tmp_path / "none.wav", silence()), presets=PRESETS).findings == ()


def test_an_unknown_preset_is_a_usage_error(tmp_path, capsys):
    path = write_wav(tmp_path / "a.wav", silence())
    assert main(["measure", "--preset", "cinema", str(path)]) == 2
    assert "aswg-home" in capsys.readouterr().err
