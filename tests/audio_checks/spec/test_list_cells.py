"""Cells and heads of people's sound lists: what they are read as, and what is said of a guess."""

from datetime import date

import pytest

from audio_checks.spec.list_cells import CellContext, is_broken_formula, reading_of
from audio_checks.spec.list_columns import guess_column, names_in_row
from audio_checks.spec.list_heads import head_of

PLAIN = CellContext()


@pytest.mark.parametrize(
    ("text", "seconds", "note"),
    [
        ("1.5", 1.5, ""),
        ("2 sec", 2, ""),
        ("1:30", 90, ""),
        ("1m30s", 90, ""),
        ("1'30\"", 90, ""),
        ("1,500 ms", 1.5, ""),
        ("２．５秒", 2.5, ""),
        ("~3", 3, "about 3 s"),
        ("約2秒", 2, "about 2 s"),
        ("1-2 s", 1.5, "1 to 2 s"),
        ("2–4 sec", 3, "2 to 4 s"),
        ("1.5 to 2", 1.75, "1.5 to 2 s"),
        ("500-800 ms", 0.65, "0.5 to 0.8 s"),
        ("1〜2秒", 1.5, "1 to 2 s"),
        ("<1s", 1, "at most 1 s"),
        ("max 3s", 3, "at most 3 s"),
        ("at least 1 s", 1, "at least 1 s"),
        ("3+", 3, "at least 3 s"),
        ("01:30:00", 5400, "1 h 30 min; if 1 min 30 s was meant, write 0:1:30"),
        ("varies", None, "no length is set"),
    ],
)
def test_lengths(text, seconds, note):
    reading = reading_of("duration_s", text)
    assert (reading.value, reading.note) == (seconds, note)


@pytest.mark.parametrize(
    ("text", "low", "high"),
    [("0.5–1 s", 0.5, 1), ("max 2 s", None, 2), ("about 3 s", None, None), ("≤ 500 ms", None, 0.5), ("3+", 3, None),
     ("between 1 and 2 min", 60, 120), ("2 s", None, None), ("~1-2 s", 1, 2)],
)  # fmt: skip
def test_bounds_of_lengths(text, low, high):
    reading = reading_of("duration_s", text)
    assert (reading.low, reading.high, reading.is_part) == (low, high, False)


@pytest.mark.parametrize("text", ["-1", "0", "5-1", "short", "1/2", "120 frames", "00:00:02:12"])
def test_what_is_no_length_is_refused(text):
    with pytest.raises(ValueError, match=r"seconds|above 0"):
        reading_of("duration_s", text)


@pytest.mark.parametrize(
    ("text", "channels"),
    [("mono", "mono"), ("Stereo", "stereo"), ("1", "mono"), ("2 ch", "stereo"), ("M", "mono"), ("", None)],
)
def test_channels(text, channels):
    assert reading_of("channels", text).value == channels


def test_more_channels_than_two_are_the_specs():
    with pytest.raises(ValueError, match=r"wanted mono, stereo, .* found \"5\.1\""):
        reading_of("channels", "5.1")
    assert head_of("Mono/Stereo").field == head_of("Channels").field == "channels"


def test_frames_and_samples_are_a_length_at_a_rate():
    assert reading_of("duration_s", "120", CellContext(counted="frames", frame_rate_fps=60)).value == 2
    assert reading_of("duration_s", "48000 samples", CellContext(sample_rate_hz=48_000)).value == 1
    assert reading_of("duration_s", "00:00:02:15", CellContext(frame_rate_fps=30)).value == 2.5


@pytest.mark.parametrize(
    "text",
    ["1-Dec-26", "1 Dec 2026", "Dec 1, 2026", "Tuesday, December 1, 2026", "Tue 1 Dec 2026", "2026年12月1日",
     "1. Dezember 2026", "1er décembre 2026", "1 de diciembre de 2026", "2026-12-01T09:30:00Z", "20261201",
     "December 1, 2026 3:00 PM", "1.12.26", "2026/12/1", "Dec 1 '26", "1st of December 2026", "46357"],
)  # fmt: skip
def test_days_as_spreadsheets_write_them(text):
    assert reading_of("due_on", text).value == date(2026, 12, 1)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("Dec 1", "has no year"),
        ("12月1日", "has no year"),
        ("4/5/2026", "could be 04 May or 05 April"),
        ("31-Nov-26", "wanted a day"),
        ("soon", "wanted a day"),
    ],
)
def test_what_is_no_day_is_refused(text, words):
    with pytest.raises(ValueError, match=words):
        reading_of("due_on", text)


def test_the_order_of_day_and_month_can_be_said():
    reading = reading_of("due_on", "4/5/2026", CellContext(day_first=False))
    assert (reading.value, reading.note) == (date(2026, 4, 5), "05 April 2026: the month comes first")


@pytest.mark.parametrize(
    "text", ["checked", "TRUE", "Yes", "✅", "☑️", "x", "[x]", "はい", "oui", "да", "Sim", "네", "循环", "Yes, seamless"]
)
def test_check_boxes_that_are_set(text):
    assert reading_of("loop", text).value is True


@pytest.mark.parametrize("text", ["", "unchecked", "FALSE", "No", "❌", "×", "[ ]", "one-shot", "いいえ", "нет", "não"])
def test_check_boxes_that_are_not(text):
    assert reading_of("loop", text).value is False


@pytest.mark.parametrize(
    ("text", "need"),
    [("High", "must"), ("🔴 High", "must"), ("P1", "must"), ("Medium", "should"), ("2 - Medium", "should"),
     ("Low", "wish"), ("Could have", "wish"), ("Must", "must"), ("hoch", "must"), ("中", "should")],
)  # fmt: skip
def test_ranks_are_needs(text, need):
    assert reading_of("need", text).value == need


@pytest.mark.parametrize(
    ("text", "count"), [("3", 3), ("x3", 3), ("3 variations", 3), ("three", 3), ("3-5", 5), ("4+", 4), ("~5", 5)]
)
def test_counts(text, count):
    assert reading_of("variations", text).value == count


@pytest.mark.parametrize("text", ["#REF!", "#NAME?", "#N/A", "#VALUE!", "#DIV/0!", "#BEZUG!", "Err:502"])
@pytest.mark.parametrize("field", ["name", "duration_s", "description"])
def test_a_broken_formula_is_no_value(text, field):
    assert is_broken_formula(text)
    with pytest.raises(ValueError, match="broken formula"):
        reading_of(field, text)


@pytest.mark.parametrize(
    ("head", "field"),
    [("Loopable?", "loop"), ("Is Looping?", "loop"), ("# of variations", "variations"), ("No. of Vars", "variations"),
     ("Anzahl der Varianten", "variations"), ("fileName", "file_name"), ("File name", "file_name"),
     ("Durée (s)", "duration_s"), ("Max length (s)", "duration_s"), ("長さ（秒）", "duration_s"), ("ループ", "loop"),
     ("ファイル名", "file_name"), ("カテゴリー", "category"), ("締切", "due_on"), ("Needed by (date)", "due_on"),
     ("名称", "name"), ("时长", "duration_s"), ("是否循环", "loop"), ("截止日期", "due_on"), ("이름", "name"),
     ("길이 (초)", "duration_s"), ("마감일", "due_on"), ("Название", "name"), ("Длительность, сек", "duration_s"),
     ("Вариации", "variations"), ("Nazwa pliku", "file_name"), ("Czas trwania (s)", "duration_s"),
     ("Nome do som", "name"), ("Duração", "duration_s"), ("Prazo", "due_on"), ("Durata", "duration_s"),
     ("Length (KB)", None), ("Length (bars)", None), ("Assignee", None)],
)  # fmt: skip
def test_heads_in_many_wordings(head, field):
    assert head_of(head).field == field


@pytest.mark.parametrize(
    ("head", "unit_s"), [("Length (ms)", 0.001), ("DurationMs", 0.001), ("Dauer in Minuten", 60), ("Length", 1)]
)
def test_units_of_heads(head, unit_s):
    assert head_of(head).unit_s == unit_s


@pytest.mark.parametrize(
    ("head", "cells", "why"),
    [
        ("Length (frames)", ["120"], "a length in frames; say the frame rate to read it"),
        ("Length (bars)", ["4"], '"bars" is musical time, which is no length in seconds'),
        ("Status", ["in progress", "done", "locked"], "2 of 3 cells are not concept, prototype, locked or cut"),
    ],
)
def test_a_column_that_is_not_read_says_why(head, cells, why):
    guess = guess_column(head, cells, PLAIN)
    assert guess.field is None
    assert why in guess.note


def test_a_column_of_broken_formulas_keeps_its_field_and_each_cell_is_a_fault():
    assert guess_column("Name", ["#REF!", "#REF!", "#N/A", "ui_click"], PLAIN).field == "name"
    assert guess_column("Length", ["#VALUE!", "#VALUE!", "2 s"], PLAIN).field == "duration_s"


def test_a_priority_in_words_is_a_need_and_in_numbers_the_engines():
    assert guess_column("Priority", ["High", "Low"], PLAIN).field == "need"
    assert guess_column("Priority", ["500", "10"], PLAIN).field == "playback_priority"


@pytest.mark.parametrize(
    ("given", "names"),
    [
        (("laser.wav", ""), ("laser", "")),
        (("Laser.WAV", ""), ("Laser", "Laser")),
        (("UI_Click.ogg", ""), ("UI_Click", "UI_Click")),
        (("Click", "Audio/UI/click.wav"), ("Click", "click.wav")),
        (("ver 2.0", ""), ("ver 2.0", "")),
        (("Bang.uasset", ""), ("Bang", "Bang")),
        (("Bang", "SFX/bang.wem"), ("Bang", "bang")),
    ],
)
def test_names_without_endings_and_folders(given, names):
    read = names_in_row(*given)
    assert (read.name, read.file_name) == names
    assert bool(read.note) == (given != names)


def test_several_files_of_a_row_are_one_numbered_set():
    read = names_in_row("Hit", "sfx/hit_01.wav, hit_02.wav; hit_03.WAV")
    assert (read.name, read.file_name, read.variations) == ("Hit", "hit", 3)
    assert read.note == "3 files are the variations of hit"
    assert names_in_row("Hit, soft", "hit.wav").variations is None


@pytest.mark.parametrize("files", ["hit.wav, splash.wav", "hit_02.wav, hit_03.wav", "hit_1.wav, hit_2.wav"])
def test_several_files_that_are_no_set_are_refused(files):
    with pytest.raises(ValueError, match="2 files and no set such as hit_01"):
        names_in_row("Hit", files)
