"""Rows of a list that are no cues, code pages, and the list as the command line reads it."""

import pytest

from audio_checks.errors import SpecError
from audio_checks.spec.list_table import rows_without_cue
from audio_checks.spec.sound_list import read_sound_list
from audio_checks.system.text_encoding import CODE_PAGES, GUESSED_FOR_ZIP, TextDamaged, decode_text

FIELDS = {0: "name", 1: "category", 2: "duration_s"}
COLUMNS = ("Name", "Category", "Length")


def kinds(*rows):
    numbered = [(number, list(cells)) for number, cells in enumerate(rows, start=2)]
    return [(found.row, found.kind) for found in rows_without_cue(numbered, COLUMNS, FIELDS)]


CUES = [("ui_click", "ui", "1"), ("amb_rain", "ambience", "30")]


@pytest.mark.parametrize(
    ("row", "kind"),
    [
        (("UI SOUNDS", "", ""), "section"),
        (("Ambience", "", ""), "section"),
        (("— Weapons —", "", ""), "section"),
        (("Weapon sounds", "", ""), "section"),
        (("TOTAL", "", "31"), "total"),
        (("Summe:", "", "0:31"), "total"),
        (("Grand total", "", "31 s"), "total"),
        (("Name", "Category", "Length"), "head"),
        (("Note: all files 48 kHz", "", ""), "note"),
    ],
)
def test_a_row_that_is_no_cue(row, kind):
    assert kinds(row, *CUES, ("ui_back", "ui", "1")) == [(2, kind)]


@pytest.mark.parametrize(
    "row",
    [
        ("door", "", ""),
        ("total_recall", "voice", "3"),
        ("Total recall", "voice", "3"),
        ("UI", "ui", ""),
        ("#REF!", "", ""),
    ],
)
def test_a_cue_with_little_beside_it_stays_a_cue(row):
    assert kinds(row, *CUES, ("ui_back", "ui", "1")) == []


@pytest.mark.parametrize("title", ["SECTION: Steps", "Group - Doors", "Kapitel: Hafen"])
def test_a_title_that_says_so_is_a_section_among_names_in_any_spelling(title):
    assert kinds(("Laser Shot", "weapon", "1"), (title, "", ""), ("DoorWood", "doors", "3")) == [(3, "section")]


def test_a_list_of_names_alone_has_no_sections():
    assert rows_without_cue([(2, ["DOOR"]), (3, ["BELL"]), (4, ["gong"])], ("Name",), {0: "name"}) == []


@pytest.mark.parametrize(
    ("text", "encoding"),
    [
        ("効果音の説明", "shift-jis"),
        ("扉がゆっくり開く", "shift-jis"),
        ("按钮点击的声音", "gb18030"),
        ("Tür größer schön", "mac-roman"),
        ("Tür größer schön", "windows-1252"),
        ("Crème brûlée, très lent", "mac-roman"),
        ("don’t stop", "windows-1252"),
        ("Größe des Tores, à côté, niño, öffnen", "windows-1252"),
        ("ÄRGER IN ÖL", "windows-1252"),
        ("Zażółć gęślą jaźń", "windows-1250"),
        ("Звук удара по дереву", "windows-1251"),
        ("Звук удара по дереву", "koi8-r"),
        ("ήχος ξύλου", "windows-1253"),
        ("Ήχος από βήματα σε χαλίκι", "windows-1253"),
        ("Двери открываются, ШАГИ", "windows-1251"),
        ("木を叩く音です", "euc-jp"),
        ("나무를 치는 소리", "euc-kr"),
        ("敲打木頭的聲音", "big5"),
    ],
)
def test_a_code_page_is_guessed_by_its_letters_and_said(text, encoding):
    codec = CODE_PAGES[encoding]
    decoded = decode_text(f"Name,Description\nhit,{text}\n".encode(codec))
    assert (decoded.encoding, decoded.is_guess) == (encoding, True)
    assert text in decoded.text


def test_an_encoding_can_be_said_and_utf_8_is_none_of_the_guesses():
    assert decode_text("Tür".encode()).is_guess is False
    assert decode_text(b"T\x9fr", "mac-roman").text == "Tür"
    with pytest.raises(TextDamaged):
        decode_text(b"T\x9fr", "utf-8")


@pytest.mark.parametrize(
    ("name", "codec"), [("ドア_開く.wav", "cp932"), ("tür_auf.wav", "cp437"), ("tür_auf.wav", "cp1252")]
)
def test_names_in_zips(name, codec):
    assert decode_text(name.encode(codec), guessed=GUESSED_FOR_ZIP).text == name


def test_the_command_line_reads_what_an_import_reads():
    sounds = read_sound_list(
        "Sound list of the demo\n\nName;File name;Loopable?;# of Vars;Length (ms)\nUI SOUNDS;;;;\n"
        "Button click;button_click_soft;no;2;500\nlaser.wav;;checked;;1000-2000\nTOTAL;;;3;\n"
    )
    click, laser = sounds.cues
    assert (click.file_name, click.loop, click.variations, click.duration_s) == ("button_click_soft", False, 2, 0.5)
    assert (laser.name, laser.loop, laser.duration_s) == ("laser", True, 1.5)
    assert (laser.duration_min_s, laser.duration_max_s, click.duration_max_s) == (1, 2, None)
    assert sounds.slot_of_file("laser.wav")[0] is laser
    said = " ".join(sounds.notes)
    for part in ('"UI SOUNDS" is no cue', '"TOTAL, 3" is no cue', '"laser.wav" is read as laser', "1 to 2 s"):
        assert part in said


def test_the_command_line_names_a_broken_formula_and_a_workbook(tmp_path):
    with pytest.raises(SpecError, match="row 2: name: a broken formula"):
        read_sound_list("Name,Category\n#REF!,ui\nclick,ui\n")
    (tmp_path / "list.xlsx").write_bytes(b"PK\x03\x04rest")
    with pytest.raises(SpecError, match="save it as CSV UTF-8"):
        read_sound_list(tmp_path / "list.xlsx")
