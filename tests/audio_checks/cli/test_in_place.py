"""`check --fix` and `--diff`: what cannot harm the sound is put right in place, or left whole."""

import hashlib
import json
import os
import struct

import pytest

from audio_checks import check_file, wav
from audio_checks.fixing import in_place
from tests.support.waves import chunk, fmt, pcm_bytes, riff, sine, wav_bytes, write_wav

GOOD = sine(hz=1_000, dbfs=-6, seconds=0.1)
WHOLE = wav_bytes(GOOD)
SPEC = ("--spec", "../spec.toml")
OPEN = b"\xff\xff\xff\xff"

HEADERS = {
    "padded": WHOLE + bytes(512),
    "riff-size": WHOLE[:4] + struct.pack("<I", 77) + WHOLE[8:],
    "riff-size-zero": WHOLE[:4] + bytes(4) + WHOLE[8:],
    "eight-too-many": WHOLE[:4] + struct.pack("<I", len(WHOLE)) + WHOLE[8:],
    "stream": WHOLE[:4] + OPEN + WHOLE[8:40] + OPEN + WHOLE[44:],
    "byte-rate": riff(chunk(b"fmt ", fmt(bits=24, byte_rate=1)), chunk(b"data", pcm_bytes(GOOD))),
    "pad-byte": riff(chunk(b"fmt ", fmt(bits=24)), chunk(b"data", pcm_bytes(GOOD)[:-3], pad=False)),
    "pad-byte-amid": riff(
        chunk(b"fmt ", fmt(bits=24)), chunk(b"data", pcm_bytes(GOOD)[:-3], pad=False), chunk(b"LIST", b"INFO")
    ),
}
LOST = {
    "cut-short": WHOLE[:-100],
    "trailing": WHOLE + b"not zero",
    "no-fmt": riff(chunk(b"data", pcm_bytes(GOOD))),
    "text": b"hello",
}


def sound_of(path):
    """The samples' bytes, wherever they are."""
    raw = path.read_bytes()
    return hashlib.sha256(raw[raw.index(b"data") + 8 :][: len(pcm_bytes(GOOD)) - 3]).hexdigest()


def files(folder):
    return sorted(path.name for path in folder.iterdir())


class TestHeaders:
    @pytest.mark.parametrize("kind", HEADERS)
    def test_a_wrong_header_is_put_right(self, folder, run, kind):
        path = folder / "laser.wav"
        path.write_bytes(HEADERS[kind])
        path.chmod(0o640)
        before = sound_of(path)
        code, out, err = run("check", *SPEC, "--fix", ".")
        assert code == 0, out + err
        with path.open("rb") as file:
            assert wav.read_layout(file).warnings == ()
        assert sound_of(path) == before
        assert path.stat().st_mode & 0o777 == 0o640
        assert files(folder) == ["laser.wav"]
        assert "1 conforming; 0 errors, 0 warnings" in out

    @pytest.mark.parametrize("kind", LOST)
    def test_what_is_lost_or_unknown_is_left_alone(self, folder, run, kind):
        path = folder / "laser.wav"
        path.write_bytes(LOST[kind])
        code, _, _ = run("check", *SPEC, "--fix", ".")
        assert code == 1
        assert path.read_bytes() == LOST[kind]
        assert files(folder) == ["laser.wav"]

    def test_a_failure_half_way_leaves_the_file_as_it_was(self, folder, run, monkeypatch):
        path = folder / "laser.wav"
        path.write_bytes(HEADERS["padded"])

        def full(*_):
            raise OSError(28, "No space left on device")

        monkeypatch.setattr(in_place.os, "replace", full)
        code, _, err = run("check", *SPEC, "--fix", ".")
        assert (code, "No space left on device" in err) == (1, True)
        assert path.read_bytes() == HEADERS["padded"]
        assert files(folder) == ["laser.wav"]


class TestNames:
    def test_a_name_becomes_valid(self, folder, run):
        write_wav(folder / "Laser Fire.WAV", GOOD)
        (folder / "Laser Fire.WAV.meta").write_text("guid: 1")
        code, out, err = run("check", *SPEC, "--fix", "--format", "json", ".")
        (entry,) = json.loads(out)["files"]
        assert (code, entry["path"], entry["verdict"]) == (0, "./laser_fire.wav", "conforming")
        assert files(folder) == ["laser_fire.wav", "laser_fire.wav.meta"]
        assert "Laser Fire.WAV: renamed to laser_fire.wav" in err

    def test_the_sound_list_knows_it_better(self, folder, run):
        (folder / "spec.toml").write_text("format = 1\nnaming.extension = '.wav'\n")
        (folder / "sounds.csv").write_text("number,file_name,variations\n1,SFX_Laser,2\n2,Door,1\n")
        for name in ("sfx laser 01.wav", "sfx_laser_02__alt2.wav", "Door.wav", "nobody.wav"):
            write_wav(folder / name, GOOD)
        code, out, _ = run("check", "--spec", "spec.toml", "--list", "sounds.csv", "--fix", "--format", "json", ".")
        found = {entry["path"]: [one["code"] for one in entry["findings"]] for entry in json.loads(out)["files"]}
        assert code == 0
        assert set(found) == {"./SFX_Laser_01.wav", "./SFX_Laser_02__alt2.wav", "./Door.wav", "./nobody.wav"}
        assert "naming:unlisted" in found["./nobody.wav"]
        assert "naming:unlisted" not in found["./SFX_Laser_01.wav"]

    def test_the_list_owns_a_name_however_its_words_are_joined(self, folder, run):
        (folder / "sounds.csv").write_text("number,file_name,variations\n1,door_wood_close,2\n2,UIClick,1\n")
        for name in ("DoorWoodClose-1.wav", "doorWoodClose 02_48k24.wav", "ui_click.wav"):
            write_wav(folder / name, GOOD)
        run("check", *SPEC, "--list", "sounds.csv", "--fix", ".")
        assert files(folder) == ["door_wood_close_01.wav", "door_wood_close_02.wav", "sounds.csv", "ui_click.wav"]

    def test_nothing_is_ever_overwritten(self, folder, run):
        write_wav(folder / "Door.wav", GOOD)
        other = write_wav(folder / "door.wav", sine(hz=440, dbfs=-12))
        before = other.read_bytes()
        code, _, err = run("check", *SPEC, "--fix", ".")
        assert (code, "there is such a file already" in err) == (1, True)
        assert files(folder) == ["Door.wav", "door.wav"]
        assert other.read_bytes() == before

    def test_nor_are_two_files_given_one_name(self, folder, run):
        for name in ("Door 1.wav", "DOOR_1.wav"):
            write_wav(folder / name, GOOD)
        code, _, err = run("check", *SPEC, "--fix", ".")
        assert (code, "another file is given the name door_1.wav" in err) == (1, True)
        assert len(files(folder)) == 2
        assert "door_1.wav" in files(folder)

    def test_one_who_came_meanwhile_keeps_his_place(self, folder, monkeypatch):
        write_wav(folder / "a.wav", GOOD)
        (folder / "b.wav").write_text("came meanwhile")
        with pytest.raises(in_place.CannotFixInPlace, match="there is a file b"):
            in_place.fix_in_place(in_place.Change("a.wav", "b.wav"))
        monkeypatch.setattr(in_place.os, "link", lambda *_: (_ for _ in ()).throw(OSError("no links on this disk")))
        with pytest.raises(in_place.CannotFixInPlace, match="there is a file b"):
            in_place.fix_in_place(in_place.Change("a.wav", "b.wav"))
        in_place.fix_in_place(in_place.Change("a.wav", "c.wav"))
        assert files(folder) == ["b.wav", "c.wav"]
        assert (folder / "b.wav").read_text() == "came meanwhile"

    def test_an_alternate_of_what_ships_is_not_renamed(self, folder, run):
        write_wav(folder / "laser__alt2.wav", sine(hz=997, rate=44_100, dbfs=-6), rate=44_100, bits=16)
        code, _, _ = run("check", *SPEC, "--target", "game", "--fix", ".")
        assert (code, files(folder)) == (1, ["laser__alt2.wav"])

    def test_what_is_waived_is_not_touched(self, folder, run):
        path = write_wav(folder / "Door.wav", GOOD)
        waived = {"pcm_sha256": check_file(path).pcm_sha256, "codes": ["naming:pattern"]}
        (folder / "baseline.json").write_text(json.dumps({"format": 1, "waived": [waived]}))
        assert run("check", *SPEC, "--baseline", "baseline.json", "--fix", ".")[0] == 0
        assert "Door.wav" in files(folder)


class TestLeftAlone:
    def test_read_only_files(self, folder, run):
        path = folder / "Laser.wav"
        path.write_bytes(HEADERS["padded"])
        path.chmod(0o444)
        code, _, err = run("check", *SPEC, "--fix", ".")
        assert (code, "read-only; make it writable first (with Perforce: p4 edit)" in err) == (1, True)
        assert path.read_bytes() == HEADERS["padded"]

    def test_links(self, folder, run):
        (folder.parent / "elsewhere.wav").write_bytes(HEADERS["padded"])
        (folder / "Laser.wav").symlink_to("../elsewhere.wav")
        code, _, err = run("check", *SPEC, "--fix", ".")
        assert (code, "it is a link" in err) == (1, True)
        assert (folder / "Laser.wav").is_symlink()
        assert (folder.parent / "elsewhere.wav").read_bytes() == HEADERS["padded"]

    def test_without_being_asked(self, folder, run):
        (folder / "Laser.wav").write_bytes(HEADERS["padded"])
        run("check", *SPEC, ".")
        assert (folder / "Laser.wav").read_bytes() == HEADERS["padded"]


class TestDiff:
    def test_it_shows_everything_and_changes_nothing(self, folder, run):
        (folder / "Laser Fire.WAV").write_bytes(HEADERS["padded"])
        (folder / "Laser Fire.WAV.meta").touch()
        write_wav(folder / "good.wav", GOOD)
        before = {path.name: (path.read_bytes(), path.stat().st_mtime_ns) for path in folder.iterdir()}
        for arguments in (["--diff"], ["--fix", "--diff"]):
            code, out, _ = run("check", *SPEC, *arguments, ".")
            assert code == 1
            assert out == (
                "./Laser Fire.WAV\n"
                "  - name: Laser Fire.WAV\n"
                "  + name: laser_fire.wav\n"
                "  - name: Laser Fire.WAV.meta\n"
                "  + name: laser_fire.wav.meta\n"
                "  + 512 bytes after the sound's file cut off\n"
                "1 file would be put right; nothing was changed\n"
            )
        assert {path.name: (path.read_bytes(), path.stat().st_mtime_ns) for path in folder.iterdir()} == before

    def test_nothing_to_do(self, folder, run):
        write_wav(folder / "good.wav", GOOD)
        assert run("check", *SPEC, "--diff", ".")[:2] == (0, "nothing to put right\n")

    def test_it_takes_the_place_of_a_report(self, folder, run):
        write_wav(folder / "good.wav", GOOD)
        code, _, err = run("check", *SPEC, "--diff", "--format", "json", ".")
        assert (code, "leave --format out" in err) == (2, True)

    def test_hostile_names_are_shown_escaped(self, folder, run):
        write_wav(folder / "a\x1b[31m\nb.wav", GOOD)
        code, out, err = run("check", *SPEC, "--diff", ".")
        assert code == 1
        assert all(one.isprintable() or one == "\n" for one in out + err)


def test_a_disk_that_takes_capitals_for_the_same(folder, monkeypatch):
    """As on Windows and macOS: the name with other letters is the file itself, and may be given to it."""
    write_wav(folder / "Door.wav", GOOD)
    renamed = []
    monkeypatch.setattr(in_place.os.path, "samefile", lambda old, new: old.casefold() == new.casefold())
    monkeypatch.setattr(in_place.os, "rename", lambda old, new: renamed.append((old, new)))
    in_place.fix_in_place(in_place.Change("Door.wav", "door.wav"))
    assert renamed == [("Door.wav", "door.wav")]
    assert os.path.exists("Door.wav")
