"""Targets in a codec by the command line: rendered, checked, audited, and held by placeholders too."""

import json

import pytest

from audio_checks.cli import main
from tests.support.waves import noise, sine, write_wav

SPEC = """
format = 1
[accept]
channels = [1, 2]
[limits]
true_peak_dbtp = -1.0
[naming]
extension = ".wav"
[targets.game]
sample_rate_hz = 48000
encoding = "opus"
quality = 0.2
codec_ratio = 1.0
[targets.archive]
sample_rate_hz = 44100
bit_depth = 24
encoding = "flac"
[categories.music]
targets.game = { encoding = "vorbis" }
[files]
"**/music/*" = "music"
"""
LIST = "number,name,file_name,category,duration_s\n1,click,click,,0.5\n2,tune,tune,music,0.5\n"


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "spec.toml").write_text(SPEC, encoding="utf-8")
    (tmp_path / "sounds.csv").write_text(LIST, encoding="utf-8")
    (tmp_path / "masters" / "music").mkdir(parents=True)
    write_wav(tmp_path / "masters" / "click.wav", sine(hz=997, dbfs=-0.5, seconds=0.3, rate=96_000), rate=96_000)
    write_wav(tmp_path / "masters" / "music" / "tune.wav", noise(seconds=0.5, channels=2, rate=96_000), rate=96_000)
    return tmp_path


@pytest.fixture
def run(capsys):
    def run(*arguments):
        try:
            code = main([*arguments, "--no-progress"])
        except SystemExit as stopped:
            code = stopped.code
        return code, *capsys.readouterr()

    return run


@pytest.mark.slow
def test_what_is_rendered_passes_its_check_and_is_made_once(folder, run):
    code, out, _ = run("render", "--spec", "spec.toml", "--out", "game", "masters")
    assert code == 0
    made = sorted(path.relative_to(folder / "game").as_posix() for path in (folder / "game").rglob("*.*"))
    assert made == ["archive/click.flac", "archive/music/tune.flac", "game/click.opus", "game/music/tune.ogg"]
    assert "48000 Hz, Opus, mono, 0.300 s" in out
    assert "48000 Hz, Ogg Vorbis, stereo" in out
    assert "44100 Hz, 24-bit FLAC, mono" in out
    for target in ("game", "archive"):
        assert run("check", "--no-cache", "--spec", "spec.toml", "--target", target, f"game/{target}")[0] == 0
    code, out, _ = run("render", "--spec", "spec.toml", "--out", "game", "masters")
    assert (code, out.count("as before")) == (0, 4)
    code, out, _ = run("check", "--no-cache", "--spec", "spec.toml", "--target", "game", "game/archive", "masters")
    assert code == 1
    assert "container FLAC, accepted OGG" in out


@pytest.mark.slow
def test_an_audit_recognises_a_coded_file_and_one_encoded_again(folder, run):
    run("render", "--spec", "spec.toml", "--target", "game", "--out", "game", "masters")
    assert run("manifest", "game/game", "--out", "approved.json")[0] == 0
    code, out, _ = run("audit", "--manifest", "approved.json", "--format", "json", "game/game")
    assert (code, {load["status"] for load in json.loads(out)["files"]}) == (0, {"same"})
    (folder / "spec.toml").write_text(SPEC.replace('"vorbis" }', '"vorbis", quality = 0.0 }'), encoding="utf-8")
    run("render", "--replace", "--spec", "spec.toml", "--target", "game", "--out", "game", "masters")
    code, out, _ = run("audit", "--manifest", "approved.json", "--format", "json", "game/game")
    found = {load["path"]: load["status"] for load in json.loads(out)["files"]}
    assert code == 1
    assert found["click.opus"] == "same"
    assert found["music/tune.ogg"] != "same"


def test_placeholders_are_in_the_codec_and_refused_among_game_files(folder, run):
    arguments = ("placeholders", "--spec", "spec.toml", "--list", "sounds.csv", "--no-voice", "--out", "stand-ins")
    code, _, _ = run(*arguments, "--target", "game", "masters/music")
    assert (code, [path.name for path in (folder / "stand-ins" / "game").iterdir()]) == (0, ["click.opus"])
    content = (folder / "stand-ins" / "game" / "click.opus").read_bytes()
    run(*arguments, "--target", "game", "masters/music")
    assert (folder / "stand-ins" / "game" / "click.opus").read_bytes() == content
    code, out, _ = run("check", "--no-cache", "--spec", "spec.toml", "--target", "game", "stand-ins/game")
    assert code == 1
    assert "this is a placeholder for cue 1" in out
    run("manifest", "stand-ins/game", "--out", "approved.json")
    _, out, _ = run("audit", "--manifest", "approved.json", "--format", "json", "stand-ins/game")
    assert [load["status"] for load in json.loads(out)["files"]] == ["placeholder"]
