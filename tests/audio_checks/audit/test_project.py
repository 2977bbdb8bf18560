"""Audits of a game with its project: the level at which it plays each sound, by the command line."""

import json
import subprocess
from datetime import UTC, datetime

import jsonschema
import pytest

from audio_checks.audit import report
from audio_checks.audit.changelists import lines_of
from audio_checks.middleware.by_path import sounds_by_path
from audio_checks.middleware.values import PlayedSound, Project
from benchmarks.audits.projects import KINDS
from tests.support.waves import placeholder_mark, write_wav

P4 = """#!/bin/sh
case "$1 $2 $3" in
"annotate -c -q") awk '{ print (/volume_db = 6/ ? "48211" : "47000") ": " $0 }' "$4" ;;
"changes -m 1") [ "$4" = "@48211,48211" ] && echo "Change 48211 on 2026/12/04 by someone@game 'Raise the footsteps'" ;;
*) exit 1 ;;
esac
"""
GIT = ("git", "-c", "user.name=x", "-c", "user.email=x@example.com", "-c", "commit.gpgsign=false")


@pytest.fixture
def game(folders, sound, run):
    """A game of four sounds of one engine: its files, its project, and its manifest with the levels of now."""
    approved, _ = folders
    root = approved.parent / "game"

    class Game:
        def __init__(self):
            self.engine, self.gains = "wwise", {}

        def write(self, engine="wwise", gains=None, *, manifest=True, with_levels=True):
            self.engine, self.gains = engine, gains or {}
            kind = KINDS[engine]
            for number in range(4):
                file = root / kind.file.format(number)
                file.parent.mkdir(parents=True, exist_ok=True)
                write_wav(file, sound("footsteps", number + 1))
                write_wav(approved / file.name, sound("footsteps", number + 1))
            self.path = kind.write(root, 4, self.gains)
            if manifest:
                levels = ("--project", self.path) if with_levels else ()
                code, _, said = run("manifest", "approved", "--out", "approved.json", *levels)
                assert code == 0, said
            return self

        def change(self, gains):
            KINDS[self.engine].write(root, 4, {**self.gains, **gains})

        def audit(self, *more):
            code, out, err = run(
                "audit", "--manifest", "approved.json", "--project", self.path, "--format", "json", *more
            )
            document = json.loads(out) if out else {}
            return code, {one["path"].rpartition("/")[2]: one for one in document.get("files", ())}, document, err

    game = Game()
    game.root = root
    return game


@pytest.mark.parametrize("engine", KINDS)
def test_the_level_of_approval_is_the_same(game, engine):
    code, entries, document, _ = game.write(engine, {(level, 0): -2.0 for level in KINDS[engine].levels}).audit()
    assert {entry["status"] for entry in entries.values()} == {"same"}
    assert code == 0
    assert document["project"]["engine"] == engine
    jsonschema.validate(document, report.schema())


@pytest.mark.parametrize(("engine", "level"), [(name, level) for name, kind in KINDS.items() for level in kind.levels])
def test_a_raised_gain_is_found_where_it_is_set(game, engine, level):
    game.write(engine, {("instance", 0): 0.5} if "instance" in KINDS[engine].levels else {})
    game.change({(level, 0): 6.0 if level != "instance" else 6.5})
    code, entries, document, _ = game.audit()
    reached = {KINDS[engine].file.format(one).rpartition("/")[2] for one in KINDS[engine].reached((level, 0), 4)}
    assert {name for name, one in entries.items() if one["status"] == "gain"} == reached
    assert {entry["status"] for entry in entries.values()} <= {"gain", "same"}
    for name in reached:
        assert entries[name]["gain_db"] == pytest.approx(6.0, abs=0.02)
        assert "6.0 dB louder" in entries[name]["message"]
        moved = [part for play in entries[name]["plays"] for part in play["moved"] if part["gain_db"] >= 6]
        assert moved
        assert moved[0]["object"] in entries[name]["message"]
    assert code == 1
    jsonschema.validate(document, report.schema())


def test_without_levels_in_the_manifest_a_sound_was_approved_as_its_file_is(game):
    code, entries, _, _ = game.write("wwise", {("container", 0): -4.0}, with_levels=False).audit()
    assert (code, {entry["status"] for entry in entries.values()}) == (1, {"gain"})
    assert entries["snd_0000.wav"]["plays"][0]["approved_db"] == 0.0


def test_a_file_and_a_property_are_both_named(game, sound):
    game.write()
    write_wav(game.root / KINDS["wwise"].file.format(0), sound("footsteps", 1) * 10 ** (-6 / 20))
    game.change({("sound", 0): 6.0})
    _, entries, _, _ = game.audit()
    entry = entries["snd_0000.wav"]
    assert entry["status"] == "gain"
    assert entry["gain_db"] == pytest.approx(0.0, abs=0.1)
    assert "6.0 dB quieter" in entry["message"]
    assert "6.0 dB louder" in entry["message"]


def test_what_is_used_but_not_approved_and_what_is_in_no_event(game, sound):
    game.write()
    write_wav(game.root / "Originals/SFX/steps/new.wav", sound("voice"))
    unit = next((game.root / "Actor-Mixer Hierarchy" / "More").glob("*.wwu"))
    unit.write_text(unit.read_text().replace("steps\\snd_0003.wav", "steps\\new.wav"))
    code, entries, _, _ = game.audit()
    assert (code, entries["new.wav"]["status"], entries["snd_0003.wav"]["status"]) == (1, "unapproved", "unused")
    assert "Play_box_0 plays it" in entries["new.wav"]["message"]
    assert game.audit("--allow", "unapproved", "--allow", "unused")[0] == 0


def test_a_placeholder_in_the_project(game, sound):
    game.write()
    write_wav(game.root / KINDS["wwise"].file.format(1), sound("beep"), after=[placeholder_mark("7")])
    code, entries, _, _ = game.audit()
    assert (code, entries["snd_0001.wav"]["status"]) == (1, "placeholder")


def test_a_level_that_depends_on_the_game_is_not_called_the_same(game):
    game.write()
    unit = next((game.root / "Actor-Mixer Hierarchy" / "More").glob("*.wwu"))
    rtpc = (
        '<PropertyList><Property Name="Volume" Type="Real64"><RTPCList><RTPC Name=""><ReferenceList><Reference '
        'Name="ControlInput"><ObjectRef Name="RPM"/></Reference>'
        "</ReferenceList></RTPC></RTPCList></Property></PropertyList>"
    )
    text = unit.read_text()
    begin = text.index("<RandomSequenceContainer")
    end = text.index(">", begin) + 1
    unit.write_text(text[:end] + rtpc + text[end:])
    code, entries, _, _ = game.audit()
    assert (code, {entry["status"] for entry in entries.values()}) == (0, {"depends"})
    assert 'depends on game parameter "RPM"' in entries["snd_0000.wav"]["message"]


@pytest.mark.slow
def test_an_import_setting_that_changes_the_level(game):
    game.write("unity")
    meta = game.root / (KINDS["unity"].file.format(2) + ".meta")
    meta.write_text(meta.read_text().replace("forceToMono: 0", "forceToMono: 1"))
    code, entries, _, _ = game.audit()
    assert (code, entries["snd_0002.wav"]["status"]) == (1, "converted")
    assert "raised to full scale" in entries["snd_0002.wav"]["message"]
    assert game.audit("--allow", "converted")[0] == 0


def test_a_part_of_the_project_that_cannot_be_read_is_named_and_the_rest_is_compared(game):
    game.write()
    (game.root / "Actor-Mixer Hierarchy" / "Broken.wwu").write_text("<WwiseDocument>\n<AudioObjects>\n")
    code, entries, document, _ = game.audit()
    assert (code, {entry["status"] for entry in entries.values()}) == (1, {"same"})
    (unread,) = document["project"]["unread"]
    assert (unread["file"], unread["line"]) == ("Actor-Mixer Hierarchy/Broken.wwu", 3)
    assert game.audit("--allow", "unread")[0] == 0


def test_text_and_annotations_name_object_and_file(game, run):
    game.write()
    game.change({("container", 0): 6.0})
    (game.root / "Actor-Mixer Hierarchy" / "Broken.wwu").write_text("<WwiseDocument>\n<AudioObjects>\n")
    command = ("audit", "--manifest", "approved.json", "--project", game.path)
    code, out, _ = run(*command)
    assert code == 1
    assert r"\mixer_0\box_0 Volume +0.0 to +6.0 dB" in out
    assert "Broken.wwu:3  unread" in out
    assert "4 sounds: 4 gain" in out
    _, out, _ = run(*command, "--format", "github")
    assert out.count("audit%3Again") == 4
    assert "audit%3Aunread" in out


class TestAccepted:
    @pytest.mark.slow
    def test_drift_is_let_through_with_its_reason_and_no_further(self, game):
        game.write()
        game.change({("sound", 0): 6.0})
        assert game.audit("--add-baseline")[0] == 2
        code, entries, _, err = game.audit(
            "--add-baseline", "--reason", "quiet under the music", "--baseline", "b.json"
        )
        assert (code, entries["snd_0000.wav"]["status"]) == (0, "gain")
        assert "1 drifts let through" in err
        code, entries, document, _ = game.audit("--baseline", "b.json")
        assert code == 0
        assert entries["snd_0000.wav"]["accepted"].startswith("quiet under the music (20")
        jsonschema.validate(document, report.schema())
        game.change({("sound", 0): 7.0})
        assert game.audit("--baseline", "b.json")[0] == 1

    @pytest.mark.slow
    def test_the_file_is_a_baseline_of_check_too(self, game, run):
        game.write()
        game.change({("sound", 0): 6.0})
        game.audit("--add-baseline", "--reason", "why not", "--baseline", "b.json")
        assert run("check", "--baseline", "b.json", "approved")[0] in (0, 1)

    @pytest.mark.parametrize(
        "accepted",
        [
            5,
            [5],
            [{}],
            [{"path": "a", "status": "gain", "played_status": "gain", "reason": " ", "on": "x", "gain_db": 1}],
        ],
    )
    def test_an_invalid_acceptance_is_refused(self, game, accepted):
        game.write()
        (game.root.parent / "b.json").write_text(json.dumps({"format": 1, "waived": [], "accepted": accepted}))
        code, _, _, err = game.audit("--baseline", "b.json")
        assert (code, "accepted" in err) == (2, True)


class TestChangelists:
    @pytest.mark.slow
    @pytest.mark.parametrize(
        ("engine", "level"),
        [
            ("wwise", "container"),
            ("fmod", "bus"),
            ("unity", "group"),
            ("unity", "source"),
            ("godot", "bus"),
            ("godot", "player"),
        ],
    )
    def test_the_commit_that_turned_it_is_named(self, game, engine, level):
        game.write(engine)
        for number, change in enumerate(({}, {(level, 0): 6.0}, {(level, 0): 6.0, ("master", 0): 0.0})):
            game.change(change)
            (game.root / "note.txt").write_text(str(number))
            for command in (["init", "-q"], ["add", "."], ["commit", "-qm", f"Change {number}"]):
                subprocess.run([*GIT, *command], cwd=game.root, check=True, capture_output=True)
        _, entries, _, _ = game.audit()
        (part,) = entries["snd_0000.wav"]["plays"][0]["moved"]
        assert part["changelist"]["subject"] == "Change 1"
        assert part["changelist"]["on"] == datetime.now(UTC).date().isoformat()
        assert part["changelist"]["id"] in entries["snd_0000.wav"]["message"]

    def test_perforce_names_the_changelist(self, game, monkeypatch, tmp_path):
        """By a substitute for `p4` that answers two documented commands; no Perforce server was asked."""
        game.write("godot")
        game.change({("player", 0): 6.0})
        place = tmp_path / "bin"
        place.mkdir()
        program = place / "p4"
        program.write_text(P4)
        program.chmod(0o755)
        monkeypatch.setenv("PATH", f"{place}:/usr/bin:/bin")
        monkeypatch.setenv("P4CLIENT", "game")
        _, entries, _, _ = game.audit()
        (part,) = entries["snd_0000.wav"]["plays"][0]["moved"]
        assert part["changelist"] == {"id": "48211", "on": "2026-12-04", "subject": ""}
        assert "(48211 of 2026-12-04)" in entries["snd_0000.wav"]["message"]
        monkeypatch.delenv("P4CLIENT")
        _, entries, _, _ = game.audit()
        assert entries["snd_0000.wav"]["plays"][0]["moved"][0]["changelist"] is None

    @pytest.mark.slow
    def test_what_is_not_committed_is_reported(self, game):
        game.write("godot")
        for command in (["init", "-q"], ["add", "."], ["commit", "-qm", "Begin"]):
            subprocess.run([*GIT, *command], cwd=game.root, check=True, capture_output=True)
        game.change({("player", 0): 6.0})
        _, entries, _, _ = game.audit()
        assert "(not committed)" in entries["snd_0000.wav"]["message"]

    def test_lines(self):
        assert lines_of("a\nb: 3\n", "b:", "m_Volume") == (2, 1)
        assert lines_of('<x ID="{1}">\n<P Name="Volume">\n<ValueList>\n<Value>6</Value>', 'ID="{1}"', "Volume") == (
            2,
            3,
        )
        assert lines_of('<P id="{1}">\n<p name="volume">\n<value>6</value>', 'id="{1}"', "volume") == (2, 2)
        assert lines_of("x", "y", "z") == (0, 0)


@pytest.mark.parametrize(
    ("file", "paths", "found"),
    [
        ("Originals/SFX/ui/click.wav", ["ui/click.wav", "menu/click.wav"], "ui/click.wav"),
        ("Originals/SFX/UI/Click.WAV", ["ui/click.ogg"], "ui/click.ogg"),
        ("Originals/SFX/click.wav", ["ui/click.wav"], "ui/click.wav"),
        ("Originals/SFX/other/click.wav", ["ui/click.wav", "menu/click.wav"], None),
        ("Originals/SFX/click.wav", ["click.wav", "ui/click.wav"], "click.wav"),
        ("Originals/SFX/clack.wav", ["click.wav"], None),
    ],
)
def test_the_path_of_a_file_of_the_project(file, paths, found):
    project = Project("wwise", "", "", (PlayedSound(file, "x"),))
    assert list(sounds_by_path(project, paths)) == ([found] if found else [])


def test_another_sound_at_the_end_of_an_approved_path_is_changed(game, sound):
    game.write()
    write_wav(game.root / KINDS["wwise"].file.format(1), sound("voice"))
    _, entries, _, _ = game.audit()
    assert entries["snd_0001.wav"]["status"] == "changed"
    assert entries["snd_0001.wav"]["approved"] == "snd_0001.wav"


def test_an_end_that_two_files_have_names_neither(game, sound):
    game.write()
    for folder in ("a", "b"):
        place = game.root / "Originals" / "SFX" / folder / "snd_0001.wav"
        place.parent.mkdir()
        write_wav(place, sound("voice", 5))
    _, _, document, _ = game.audit()
    found = {one["path"]: one["status"] for one in document["files"]}
    assert found["SFX/a/snd_0001.wav"] == found["SFX/b/snd_0001.wav"] == "unknown"
    assert found["SFX/steps/snd_0001.wav"] == "same"
