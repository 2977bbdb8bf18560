"""Every status, from real files by the command line."""

import json
from pathlib import Path

import jsonschema
import numpy as np
import pytest
import soundfile

from audio_checks.audit import manifest, report
from benchmarks.audits.changes import mp3, opus, to_rate, vorbis
from tests.support.flacs import flac_bytes
from tests.support.waves import chunk, noise, placeholder_mark, silence, sine, swelling, write_wav

RATE = 48_000
RNG = np.random.default_rng(1)


def only(entries, path="a.wav"):
    assert set(entries) == {path}
    return entries[path]


@pytest.mark.parametrize("name", ["a.wav", "a.flac"])
def test_the_same_samples(folders, sound, audit, name):
    approved, build = folders
    write_wav(approved / "a.wav", sound("bell"))
    if name == "a.flac":
        (build / name).write_bytes(flac_bytes(sound("bell")))
    else:
        write_wav(build / name, sound("bell"), before=[chunk(b"LIST", b"INFO")])
    code, entries, document = audit()
    entry = only(entries, name)
    assert (code, entry["status"], entry["gain_db"], entry["offset_s"]) == (0, "same", 0.0, 0.0)
    assert entry["matches"] == [{"cue": None, "take": None, "path": "a.wav", "score": 1.0}]
    assert document["summary"] == {"files": 1, **dict.fromkeys(report.STATUSES, 0), "same": 1}


@pytest.mark.parametrize("put_db", [-6.0, -0.2, 0.2, 4.0])
def test_gain(folders, sound, audit, put_db):
    approved, build = folders
    write_wav(approved / "a.wav", sound("footsteps"))
    write_wav(build / "a.wav", sound("footsteps") * 10 ** (put_db / 20))
    code, entries, _ = audit()
    entry = only(entries)
    assert (code, entry["status"]) == (1, "gain")
    assert entry["gain_db"] == pytest.approx(put_db, abs=0.05)
    assert "louder" in entry["message"] if put_db > 0 else "quieter" in entry["message"]


def test_trimmed(folders, sound, audit):
    approved, build = folders
    write_wav(approved / "a.wav", sound("voice"))
    write_wav(build / "a.wav", sound("voice")[4_800:-2_400] * 0.5)
    _, entries, _ = audit()
    entry = only(entries)
    assert entry["status"] == "trimmed"
    assert entry["offset_s"] == pytest.approx(0.1, abs=1e-3)
    assert entry["gain_db"] == pytest.approx(-6.0, abs=0.2)
    assert entry["message"] == "0.100 s cut off its start, 0.050 s cut off its end, 6.0 dB quieter"


def test_resampled(folders, sound, audit):
    approved, build = folders
    write_wav(approved / "a.wav", sound("rain"), bits=16)
    to_rate(22_050)(sound("rain"), RATE, RNG).write(build / "a")
    _, entries, _ = audit()
    entry = only(entries)
    assert (entry["status"], entry["message"]) == ("resampled", "22,050 Hz instead of 48,000 Hz")
    assert abs(entry["gain_db"]) < 0.2


@pytest.mark.parametrize("change", [vorbis, mp3, opus])
def test_coded(folders, sound, audit, change):
    approved, build = folders
    write_wav(approved / "a.wav", sound("footsteps"))
    made = change(sound("footsteps"), RATE, RNG)
    made.write(build / "a")
    code, entries, _ = audit()
    entry = only(entries, f"a{made.ending}")
    assert (code, entry["status"]) == (1, "re-encoded")
    assert "coded as" in entry["message"]
    assert audit("--allow", "re-encoded")[0] == 0


def test_louder_in_a_codec_is_gain(folders, sound, audit):
    approved, build = folders
    write_wav(approved / "a.wav", sound("footsteps"))
    vorbis(sound("footsteps") * 1.6, RATE, RNG).write(build / "a")
    code, entries, _ = audit("--allow", "re-encoded")
    entry = only(entries, "a.ogg")
    assert (code, entry["status"]) == (1, "gain")
    assert entry["gain_db"] == pytest.approx(4.1, abs=0.45)


def test_eight_bits_adpcm_and_an_equaliser(folders, sound, audit):
    approved, build = folders
    for name in ("a", "b", "c"):
        write_wav(approved / f"{name}.wav", sound("rain"), bits=16)
    write_wav(build / "a.wav", sound("rain"), bits=8)
    soundfile.write(build / "b.wav", sound("rain"), RATE, subtype="IMA_ADPCM")
    write_wav(build / "c.wav", np.diff(sound("rain"), axis=0, prepend=0) * 4, bits=16)
    _, entries, _ = audit()
    assert {path: entry["status"] for path, entry in entries.items()} == dict.fromkeys(
        ("a.wav", "b.wav", "c.wav"), "re-encoded"
    )
    assert entries["a.wav"]["message"] == "8 bits instead of 16"
    assert "IMA_ADPCM" in entries["b.wav"]["message"]
    assert "equaliser" in entries["c.wav"]["message"]


def test_changed_says_whose_sound_it_is(folders, sound, audit):
    approved, build = folders
    write_wav(approved / "a.wav", sound("footsteps", 1))
    write_wav(approved / "b.wav", sound("footsteps", 2))
    write_wav(build / "a.wav", sound("footsteps", 2))
    write_wav(build / "b.wav", sound("footsteps", 3))
    _, entries, _ = audit()
    assert (entries["a.wav"]["status"], entries["b.wav"]["status"]) == ("changed", "changed")
    assert [match["path"] for match in entries["a.wav"]["matches"]] == ["b.wav"]
    assert "it is that of b.wav" in entries["a.wav"]["message"]
    assert entries["b.wav"]["matches"] == []
    assert entries["b.wav"]["gain_db"] is None


def test_missing_unknown_and_renamed(folders, sound, audit):
    approved, build = folders
    write_wav(approved / "a.wav", sound("bell"))
    write_wav(approved / "gone.wav", sound("voice"))
    write_wav(build / "other name.wav", sound("bell"))
    write_wav(build / "stray.wav", sound("engine"))
    _, entries, _ = audit()
    assert {path: entry["status"] for path, entry in entries.items()} == {
        "other name.wav": "same",
        "stray.wav": "unknown",
        "gone.wav": "missing",
    }
    assert entries["other name.wav"]["approved"] == "a.wav"


def test_a_placeholder(folders, sound, audit):
    approved, build = folders
    write_wav(approved / "a.wav", sound("bell"))
    write_wav(build / "a.wav", sound("beep"), after=[placeholder_mark("7")])
    code, entries, _ = audit()
    assert (code, only(entries)["status"]) == (1, "placeholder")


def test_duplicates_in_the_build_and_in_the_library(folders, sound, audit):
    approved, build = folders
    for name in ("a", "twin"):
        write_wav(approved / f"{name}.wav", sound("bell"))
    write_wav(build / "a.wav", sound("bell") * 0.5)
    write_wav(build / "copy.wav", sound("bell"))
    write_wav(build / "copy2.wav", sound("bell") * 0.7)
    _, entries, _ = audit()
    assert {path: entry["status"] for path, entry in entries.items()} == {
        "a.wav": "gain",
        "copy.wav": "same",
        "copy2.wav": "duplicate",
    }
    assert all({match["path"] for match in entry["matches"]} == {"a.wav", "twin.wav"} for entry in entries.values())


def test_what_cannot_be_known_is_unknown_and_said_in_words(folders, audit):
    approved, build = folders
    for folder, length in ((approved, 1.0), (build, 0.5)):
        write_wav(folder / "silent.wav", silence(seconds=length))
        write_wav(folder / "whistle.wav", swelling(sine(hz=15_000, seconds=length)))
        write_wav(folder / "tick.wav", noise(seconds=0.02) + (1 - length) * 1.6 * noise(seconds=0.02, seed=2))
    (build / "broken.wav").write_bytes(b"RIFF\0\0")
    (build / "lfs.ogg").write_bytes(b"version https://git-lfs.github.com/spec/v1\n")
    (build / "torn.ogg").write_bytes(b"OggS" + bytes(200))
    _, entries, _ = audit()
    assert {entry["status"] for path, entry in entries.items()} == {"unknown"}
    assert "nothing but silence" in entries["silent.wav"]["message"]
    assert "60 Hz" in entries["whistle.wav"]["message"]
    assert "too short to compare" in entries["tick.wav"]["message"]
    assert "Git LFS" in entries["lfs.ogg"]["message"]
    assert "Ogg" in entries["torn.ogg"]["message"]


@pytest.mark.slow
def test_many_processes_say_the_same(folders, sound, audit):
    approved, build = folders
    for number, family in enumerate(("bell", "voice", "rain")):
        write_wav(approved / f"{family}.wav", sound(family))
        write_wav(build / f"{family}.wav", sound(family) * (1, 0.5, 0.5)[number])
    vorbis(sound("engine"), RATE, RNG).write(build / "engine")
    assert audit("-j", "2") == audit("-j", "1")


@pytest.mark.slow
def test_formats_and_schemas(folders, sound, audit, run):
    approved, build = folders
    write_wav(approved / "a.wav", sound("bell"))
    write_wav(build / "a.wav", sound("bell") * 0.5)
    _, _, document = audit()
    jsonschema.validate(document, json.loads(run("schema", "audit")[1]))
    jsonschema.validate(json.loads(Path("approved.json").read_text()), json.loads(run("schema", "manifest")[1]))
    assert manifest.schema()["properties"]["schema_version"] == {"const": 1}
    code, out, _ = run("audit", "--manifest", "approved.json", "--format", "text", "build")
    assert (code, out) == (1, "a.wav  gain (-6.0 dB): 6.0 dB quieter\n1 sound: 1 gain\n")
    assert 'type="audit:gain"' in run("audit", "--manifest", "approved.json", "--format", "junit", "build")[1]
    assert "::error file=a.wav" in run("audit", "--manifest", "approved.json", "--format", "github", "build")[1]


def test_the_approved_folder_must_be_the_manifests(folders, sound, audit, run):
    approved, build = folders
    write_wav(approved / "a.wav", sound("bell"))
    write_wav(build / "a.wav", sound("bell"))
    assert audit("--approved", "approved")[0] == 0
    write_wav(approved / "a.wav", sound("voice"))
    code, _, said = run("audit", "--manifest", "approved.json", "--approved", "approved", "build")
    assert code == 2
    assert "a.wav is not the file that approved.json lists" in said
    (approved / "a.wav").unlink()
    assert run("audit", "--manifest", "approved.json", "--approved", "approved", "build")[0] == 2


def test_a_manifest_names_cues_and_leaves_out_what_it_cannot_read(folders, sound, run):
    approved, _ = folders
    write_wav(approved / "door_01.wav", sound("bell"))
    (approved / "broken.wav").write_bytes(b"RIFF")
    (approved.parent / "sounds.csv").write_text("number,name,variations\n12,door,2\n")
    code, _, said = run("manifest", "approved", "--out", "m.json", "--list", "sounds.csv")
    assert code == 1
    assert "broken.wav: left out" in said
    (entry,) = json.loads(Path("m.json").read_text())["files"]
    assert (entry["path"], entry["cue"], entry["sample_rate_hz"]) == ("door_01.wav", "12", 48_000)


def test_approved_sounds_that_are_all_silent(folders, sound, audit):
    approved, build = folders
    write_wav(approved / "a.wav", silence())
    write_wav(build / "a.wav", silence())
    write_wav(build / "b.wav", sound("bell"))
    code, entries, _ = audit()
    assert (code, {path: entry["status"] for path, entry in entries.items()}) == (
        1,
        {"a.wav": "same", "b.wav": "unknown"},
    )
