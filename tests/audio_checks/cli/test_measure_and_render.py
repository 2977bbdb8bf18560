"""The commands that measure files and that render game files."""

import json
import re

import pytest

from audio_checks import check_file, is_placeholder
from audio_checks.spec.delivery_spec import new_spec, parse_spec
from tests.audio_checks.cli.test_cli import GOOD
from tests.support.waves import placeholder_mark, silence, sine, write_wav

SPEC = ("--spec", "../spec.toml")


class TestMeasure:
    def test_figures_without_a_verdict(self, folder, run):
        write_wav(folder / "laser.wav", GOOD)
        (folder / "broken.wav").write_bytes(b"RIFF")
        code, out, err = run("measure", "--category", "weapon", "--format", "json", ".")
        broken, laser = json.loads(out)["files"]
        assert code == 1
        assert "broken.wav" in err
        assert broken["facts"] is None
        assert laser["category"] == "weapon"
        assert laser["measurements"]["sample_peak_dbfs"] == pytest.approx(-6.0, abs=0.01)
        assert "verdict" not in laser
        assert "findings" not in laser

    def test_as_text(self, folder, run):
        write_wav(folder / "laser.wav", silence(seconds=0.1))
        code, out, _ = run("measure", "laser.wav")
        assert code == 0
        assert re.search(r"true peak +-\n", out)


class TestRender:
    def test_masters_become_game_files(self, folder, run):
        (folder / "in" / "deep").mkdir(parents=True)
        write_wav(folder / "in" / "deep" / "laser__alt2.wav", GOOD, rate=48_000)
        code, out, _ = run("render", *SPEC, "--out", "out", "in")
        assert code == 0, out
        for target, rate in (("game", 44_100), ("handheld", 22_050)):
            entry = check_file(folder / "out" / target / "deep" / "laser.wav", parse_spec(new_spec()), target=target)
            assert (entry.verdict, entry.facts["sample_rate_hz"]) == ("conforming", rate)
            assert f"in/deep/laser__alt2.wav -> {target}:" in out

    def test_one_target_and_what_is_refused(self, folder, run):
        write_wav(folder / "low.wav", sine(hz=440, rate=22_050, seconds=0.2), rate=22_050)
        (folder / "broken.wav").write_bytes(b"RIFF")
        code, out, _ = run("render", *SPEC, "--target", "game", "--out", "out", "low.wav", "broken.wav")
        assert code == 1
        assert out.count("refused") == 2
        assert not list(folder.glob("out/**/*.wav"))

    def test_two_alternates_do_not_overwrite_each_other(self, folder, run):
        for name in ("laser__alt1.wav", "laser__alt2.wav"):
            write_wav(folder / name, GOOD)
        code, out, _ = run("render", *SPEC, "--target", "game", "--out", "out", ".")
        assert (code, out.count("refused")) == (1, 1)

    def test_a_render_never_replaces_an_earlier_one_unasked(self, folder, run):
        write_wav(folder / "laser.wav", GOOD)
        asked = ("render", *SPEC, "--target", "game", "--out", "out", "laser.wav")
        made = folder / "out" / "game" / "laser.wav"
        assert run(*asked)[0] == 0
        first, stamp = made.read_bytes(), made.stat().st_mtime_ns
        code, out, _ = run(*asked)
        assert (code, out.rstrip().endswith("; as before"), made.stat().st_mtime_ns) == (0, True, stamp)
        write_wav(folder / "laser.wav", 0.5 * GOOD)
        code, out, _ = run(*asked)
        assert (code, "is there already, and differs" in out, made.read_bytes() == first) == (1, True, True)
        assert run(*asked, "--replace")[0] == 0
        assert made.read_bytes() != first
        assert [path.name for path in made.parent.iterdir()] == ["laser.wav"]

    def test_a_placeholder_is_replaced(self, folder, run):
        write_wav(folder / "laser.wav", GOOD)
        (folder / "out" / "game").mkdir(parents=True)
        write_wav(folder / "out" / "game" / "laser.wav", 0.5 * GOOD, after=[placeholder_mark("SW-014")])
        assert run("render", *SPEC, "--target", "game", "--out", "out", "laser.wav")[0] == 0
        assert not is_placeholder(folder / "out" / "game" / "laser.wav")

    def test_the_loss_reports_as_json(self, folder, run):
        write_wav(folder / "laser.wav", GOOD)
        (folder / "broken.wav").write_bytes(b"RIFF")
        code, out, _ = run("render", *SPEC, "--format", "json", "--out", "out", "laser.wav", "broken.wav")
        game, handheld, *broken = json.loads(out)["renders"]
        assert code == 1
        assert (game["target"], game["path"], game["is_new"]) == ("game", "out/game/laser.wav", True)
        assert handheld["loss"]["above_nyquist_db"] is None or handheld["loss"]["above_nyquist_db"] < 0
        assert [one["refused"]["code"] for one in broken] == ["structure:truncated"] * 2

    def test_a_master_is_never_overwritten(self, folder, run):
        (folder / "game").mkdir()
        path = write_wav(folder / "game" / "laser.wav", GOOD)
        before = path.read_bytes()
        code, out, _ = run("render", *SPEC, "--target", "game", "--out", ".", "game/laser.wav")
        assert (code, "overwrite its master" in out) == (1, True)
        assert path.read_bytes() == before
