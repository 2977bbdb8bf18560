"""Where files of voice lines stand, and how a check finds their cues there."""

import pytest

from audio_checks import check_files, game_path, make_placeholders, parse_spec, read_sound_list, stem_in_language
from audio_checks.cli import main
from tests.support.waves import sine, write_wav

LIST = """number,name,file_name,category,loop,variations,language,state
1,en_captain_010,en_captain_010,vo,no,1,en,locked
2,pt-BR_captain_010,pt-BR_captain_010,vo,no,2,pt-BR,locked
3,de captain,captain_010,vo,no,1,de,locked
4,Click,ui_click,ui,no,1,,locked
"""
SPEC = """format = 1
[naming]
pattern = "(en|pt-BR)_[a-z0-9_]+|ui_[a-z]+|captain_010"
extension = ".wav"
[targets.game]
sample_rate_hz = 48000
bit_depth = 16
folder = "Audio/{category}"
"""


@pytest.mark.parametrize(
    ("language", "path", "placed"),
    [
        ("de", "de_captain_010.wav", "de/captain_010.wav"),
        ("pt-BR", "Audio/vo/pt-BR_captain_010_01.ogg", "Audio/vo/pt-BR/captain_010_01.ogg"),
        ("de", "captain_010.wav", "captain_010.wav"),  # renamed: no language to take off
        ("de", "en_captain_010.wav", "en_captain_010.wav"),
        ("de", "vo/de_", "vo/de_"),
        (None, "de_captain_010.wav", "de_captain_010.wav"),
    ],
)
def test_the_language_of_a_line_is_its_folder(language, path, placed):
    assert game_path(language, path) == placed


@pytest.mark.parametrize(
    ("path", "number"),
    [
        ("en/captain_010.wav", "1"),
        ("Audio/vo/EN/captain_010.wav", "1"),
        ("Audio\\vo\\en\\captain_010.wav", "1"),
        ("Audio/vo/pt-BR/captain_010_02.wav", "2"),
        ("en_captain_010.wav", "1"),  # as it was delivered
        ("captain_010.wav", "3"),
        ("de/captain_010.wav", "3"),
        ("fr/captain_010.wav", "3"),  # no language of the list, so the folder says nothing
        ("ui/click.wav", None),
        ("en/click.wav", None),
        ("pt-BR/captain_010.wav", "3"),
    ],
)
def test_a_check_finds_the_line_of_a_path(path, number):
    slot = read_sound_list(LIST).slot_of_file(path)
    assert (slot and slot[0].number) == number


def test_names_are_judged_as_the_list_has_them(tmp_path):
    paths = []
    for place, name in enumerate(("en/captain_010.wav", "pt-BR/captain_010_01.wav", "en/stray.wav")):
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        paths.append(write_wav(path, sine(hz=300 + place, dbfs=-6, seconds=0.1), bits=16))
    report = check_files(paths, parse_spec(SPEC), target="game", sound_list=read_sound_list(LIST))
    found = [[finding.code for finding in entry.findings if finding.check == "naming"] for entry in report.files]
    assert found == [[], [], ["naming:pattern", "naming:unlisted"]]


def test_placeholders_stand_where_the_pack_has_the_sound(tmp_path):
    sounds, spec = read_sound_list(LIST), parse_spec(SPEC)
    made = list(make_placeholders(sounds, spec, tmp_path, target="game", voice=False))
    assert [one.path.relative_to(tmp_path).as_posix() for one in made] == [
        "Audio/vo/en/captain_010.wav",
        "Audio/vo/pt-BR/captain_010_01.wav",
        "Audio/vo/pt-BR/captain_010_02.wav",
        "Audio/vo/captain_010.wav",
        "Audio/ui/ui_click.wav",
    ]
    assert all(sounds.slot_of_file(str(one.path)) for one in made)


def test_a_take_in_the_folder_of_its_language_needs_no_placeholder(tmp_path, capsys):
    (tmp_path / "en").mkdir()
    write_wav(tmp_path / "en" / "captain_010.wav", sine(hz=300, dbfs=-6, seconds=0.1))
    (tmp_path / "sounds.csv").write_text(LIST)
    (tmp_path / "spec.toml").write_text(SPEC)
    given = ["--list", tmp_path / "sounds.csv", "--spec", tmp_path / "spec.toml", "--out", tmp_path / "out"]
    assert main([str(one) for one in ("placeholders", *given, tmp_path / "en")]) == 0
    assert "en_captain_010" not in capsys.readouterr().out


def test_a_fix_of_a_name_leaves_the_folder_of_the_language(tmp_path, capsys):
    (tmp_path / "en").mkdir()
    write_wav(tmp_path / "en" / "captain_010.WAV", sine(hz=300, dbfs=-6, seconds=0.1), bits=16)
    (tmp_path / "sounds.csv").write_text(LIST)
    (tmp_path / "spec.toml").write_text(SPEC)
    given = ["--list", tmp_path / "sounds.csv", "--spec", tmp_path / "spec.toml", "--target", "game", "--no-cache"]
    assert main([str(one) for one in ("check", "--fix", *given, tmp_path)]) == 0, capsys.readouterr()
    assert (tmp_path / "en" / "captain_010.wav").exists()


def test_the_rule_is_one():
    assert game_path("en", stem_in_language("en", "captain_010")) == "en/captain_010"
