"""A dry stem beside its sound, on the command line: `x__dry.wav` beside `x.wav`."""

import json

import pytest

from audio_checks.run.discovery import dry_stems
from audio_checks.spec.delivery_spec import new_spec
from audio_checks.spec.sound_list import read_sound_list
from audio_checks.spec.sound_names import dry_stem_name
from tests.support.rooms import hits, in_a_room
from tests.support.waves import write_wav

DRY = hits(seconds=1.0)
WET = in_a_room(DRY, rt60_s=0.8)
LIST = "number,name,file_name\nSW-1,Warp in,warp_in\n"


@pytest.fixture
def folder(folder):
    spec = new_spec(name="Shield Wing") + '\n[categories.sure]\nchecks.baked-reverb = "error"\n'
    (folder.parent / "spec.toml").write_text(spec, encoding="utf-8")
    return folder


@pytest.fixture
def check(folder, run):
    """Check the folder, and return the exit code and what is said of each file, by name."""

    def check(*options):
        code, out, _ = run(
            *("check", "--spec", "../spec.toml", "--category", "sure", "--format", "json", "--cache-dir", "../seen"),
            *options,
            ".",
        )
        return code, {load["path"].removeprefix("./"): load for load in json.loads(out)["files"]}

    return check


def codes(entry):
    return [one["code"] for one in entry["findings"]]


def test_a_stem_is_known_by_its_name():
    names = [
        "warp_in__dry.wav",
        "a/b\\warp_in__alt2__dry.flac",
        "warp_in_dry.wav",
        "__dry.wav",
        "dry.wav",
        "x__dry__alt2.wav",
    ]
    assert [dry_stem_name(name) for name in names] == ["warp_in", "warp_in__alt2", None, None, None, None]


def test_it_belongs_to_the_sound_of_its_folder():
    paths = ["a/x.wav", "a/x__dry.flac", "b/x__dry.wav", "b/y.wav"]
    assert dry_stems(paths) == {"a/x.wav": "a/x__dry.flac"}


def test_a_name_that_a_cue_owns_is_no_stem():
    owned = read_sound_list("number,name,file_name\n1,Shot,shot\n2,Dry shot,shot__dry\n")
    assert dry_stems(["shot.wav", "shot__dry.wav"], owned) == {}


@pytest.mark.slow
def test_what_was_added_is_found_and_named(folder, check):
    write_wav(folder / "warp_in.wav", WET)
    write_wav(folder / "warp_in__dry.wav", DRY)
    code, said = check()
    assert code == 1
    assert said["warp_in__dry.wav"]["verdict"] == "conforming"
    [finding] = [one for one in said["warp_in.wav"]["findings"] if one["code"] == "baked-reverb:heard"]
    assert finding["message"].startswith("reverb of about 0.8 s added to warp_in__dry.wav, score 0.99 of 1")


@pytest.mark.slow
def test_where_nothing_was_added_there_is_no_finding(folder, check):
    write_wav(folder / "warp_in.wav", WET)
    assert "baked-reverb:heard" in codes(check()[1]["warp_in.wav"])
    write_wav(folder / "warp_in__dry.wav", WET)  # its own decay, as the stem shows
    code, said = check()
    judged = said["warp_in.wav"]["judgements"]["reverb"]
    assert (code, judged["verdict"], judged["beside"]) == (0, "dry", "warp_in__dry.wav")
    write_wav(folder / "warp_in__dry.wav", DRY)  # a stem that changes counts, whatever is remembered of the sound
    assert "baked-reverb:heard" in codes(check()[1]["warp_in.wav"])


@pytest.mark.slow
def test_of_another_sound_the_judgement_without_it_stands(folder, check):
    write_wav(folder / "warp_in.wav", WET)
    alone = check()[1]["warp_in.wav"]
    write_wav(folder / "warp_in__dry.wav", hits(seconds=1.0, seed=9)[::-1])
    beside = check()[1]["warp_in.wav"]
    assert codes(beside) == codes(alone)
    stem = beside["judgements"]["reverb"].pop("stem")
    assert beside["judgements"]["reverb"] == alone["judgements"]["reverb"]
    assert (stem["verdict"], stem["why"]) == ("cannot tell", "the two are not the same sound")


def test_a_stem_of_another_rate_says_so(folder, check):
    write_wav(folder / "warp_in.wav", WET)
    write_wav(folder / "warp_in__dry.wav", DRY, rate=44_100)
    stem = check()[1]["warp_in.wav"]["judgements"]["reverb"]["stem"]
    assert stem["why"] == "the one has 48,000 Hz and the other 44,100 Hz"


def test_one_that_cannot_be_read_is_refused_by_its_rule_and_its_sound_judged_alone(folder, check):
    write_wav(folder / "warp_in.wav", WET)
    (folder / "warp_in__dry.wav").write_bytes(b"RIFF no sound")
    code, said = check()
    assert (code, said["warp_in__dry.wav"]["verdict"]) == (1, "unreadable")
    [finding] = said["warp_in__dry.wav"]["findings"]
    stem = said["warp_in.wav"]["judgements"]["reverb"]["stem"]
    assert stem["verdict"] == "unreadable"
    assert stem["why"] == f"{finding['message']}; {finding['fix']}"
    assert said["warp_in.wav"]["verdict"] == "rejected"
    assert "baked-reverb:heard" in codes(said["warp_in.wav"])


def test_the_list_misses_no_cue_for_a_stem(folder, check):
    (folder.parent / "sounds.csv").write_text(LIST, encoding="utf-8")
    write_wav(folder / "warp_in.wav", DRY)
    write_wav(folder / "warp_in__dry.wav", DRY)
    code, said = check("--list", "../sounds.csv")
    assert (code, codes(said["warp_in__dry.wav"])) == (0, [])
    (folder / "warp_in.wav").unlink()
    code, said = check("--list", "../sounds.csv")
    assert code == 1  # nothing that it could be the stem of
    assert "naming:unlisted" in codes(said["warp_in__dry.wav"])


def test_what_ships_has_no_stem(folder, run):
    (folder.parent / "spec.toml").write_text(new_spec(), encoding="utf-8")
    write_wav(folder / "warp_in.wav", DRY, rate=44_100, bits=16)
    write_wav(folder / "warp_in__dry.wav", DRY, rate=44_100, bits=16)
    code, out, _ = run("check", "--spec", "../spec.toml", "--target", "game", ".")
    assert code == 1
    assert "naming" in out


def test_no_game_file_is_made_of_a_stem(folder, run):
    (folder.parent / "spec.toml").write_text(new_spec(), encoding="utf-8")
    write_wav(folder / "warp_in.wav", DRY)
    write_wav(folder / "warp_in__dry.wav", DRY)
    code, out, _ = run("render", "--spec", "../spec.toml", "--target", "game", "--out", "../game", ".")
    assert (code, [path.name for path in (folder.parent / "game").rglob("*.wav")]) == (0, ["warp_in.wav"]), out


def test_a_sound_is_not_renamed_away_from_its_stem(folder, run):
    (folder.parent / "spec.toml").write_text(new_spec(), encoding="utf-8")
    write_wav(folder / "Warp In.wav", DRY)
    write_wav(folder / "Warp In__dry.wav", DRY)
    _, _, err = run("check", "--spec", "../spec.toml", "--fix", ".")
    assert "it would lose its dry stem Warp In__dry.wav; rename the two together" in err
    assert (folder / "Warp In.wav").exists()
