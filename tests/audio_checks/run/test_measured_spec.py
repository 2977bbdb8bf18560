"""A spec measured from a folder: nothing fails by it on the first day, and the unusual files are warned of."""

import numpy as np
import pytest
import soundfile

from audio_checks.cli import main
from audio_checks.run.measured_spec import spec_from
from audio_checks.spec.delivery_spec import parse_spec
from tests.support.waves import sine, write_wav

SOUND = sine(hz=997, dbfs=-6.0, seconds=0.5)
SOUND *= np.interp(np.arange(len(SOUND)), [0, 200, len(SOUND) - 5_000, len(SOUND)], [0, 1, 1, 0])[:, None]


@pytest.fixture
def tree(tmp_path):
    """A game of many Ogg files, one at another rate, one WAV."""
    folder = tmp_path / "sound"
    folder.mkdir()
    for number in range(60):
        soundfile.write(folder / f"a{number}.ogg", SOUND * (1 - number / 100), 44_100, format="OGG", subtype="VORBIS")
    soundfile.write(folder / "odd.ogg", SOUND, 22_050, format="OGG", subtype="VORBIS")
    write_wav(folder / "plain.wav", SOUND, rate=44_100)
    return folder


@pytest.mark.slow
def test_no_error_on_the_first_day_and_the_odd_ones_are_named(tree, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["new-spec", "--from", str(tree)]) == 0
    said = capsys.readouterr()
    assert "62 files measured; by this spec none has an error" in said.err
    spec = parse_spec(said.out)
    assert (spec.name, spec.accept.containers, spec.accept.sample_rates_hz) == ("sound", ("ogg",), (44_100,))
    (tmp_path / "audio-checks.toml").write_text(said.out)
    assert main(["check", "--no-cache", str(tree)]) == 0
    out = capsys.readouterr().out
    assert "sample-rate:not-accepted" in out
    assert "container:not-accepted" in out
    assert "62 files: 62 conforming" in out


@pytest.mark.slow
def test_what_is_new_and_differs_is_warned_of_or_refused(tree):
    made = spec_from([str(one) for one in sorted(tree.iterdir())], name="x")
    assert made.unreadable == ()
    assert made.warned == 2
    assert 'sample-rate = "warning"' in made.text


@pytest.mark.slow
def test_what_cannot_be_read_is_reported(tree, capsys):
    (tree / "broken.ogg").write_bytes(b"OggS nothing")
    assert main(["new-spec", "--from", str(tree)]) == 0
    assert "broken.ogg: cannot be read, and is not measured" in capsys.readouterr().err


@pytest.mark.parametrize("arguments", [["--from", "nowhere"], ["--from", ".", "--preset", "48k"], ["--from", "."]])
def test_usage_errors(tmp_path, monkeypatch, arguments):
    monkeypatch.chdir(tmp_path)
    assert main(["new-spec", *arguments]) == 2
