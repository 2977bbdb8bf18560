"""Sheets that strangers send: read, or refused in words, and the server goes on."""

import contextlib
import io
import random
import zipfile
from collections.abc import Iterator

import pytest
import xlsxwriter
from hypothesis import given, settings
from hypothesis import strategies as st

from app import registry
from app.core.parsing import Parsers
from app.sound_lists.errors import SheetUnreadable
from app.sound_lists.rules import read_label
from app.sound_lists.sheets.rules import MAX_ROWS, parse_bytes, parse_text
from audio_checks import ListedCue, NameIndex, head_of, read_cell
from tests.app.sound_lists.test_imports import cues, refused, send, workbook
from tests.support.server import World
from tests.support.steps import at_most

Fields = tuple[int | None, tuple[str, ...], list[tuple[int, list[str]]]]


@pytest.fixture(scope="module")
def parsers() -> Iterator[Parsers]:
    made = Parsers()
    made.connect(registry.PARSERS)
    yield made
    made.close()


def with_part(content: bytes, name: str = "xl/worksheets/sheet1.xml") -> bytes:
    """Return a workbook of one sheet with another text for one of its parts."""
    book = io.BytesIO()
    with (
        zipfile.ZipFile(io.BytesIO(workbook([["Name"], ["Door"]]))) as good,
        zipfile.ZipFile(book, "w", zipfile.ZIP_DEFLATED) as bad,
    ):
        for entry in good.infolist():
            bad.writestr(entry.filename, content if entry.filename == name else good.read(entry))
    return book.getvalue()


def sheet_of(data: str) -> bytes:
    head = '<?xml version="1.0"?><worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main">'
    return with_part(f"{head}<sheetData>{data}</sheetData></worksheet>".encode())


FAR = '<row r="{row}"><c r="{cell}" t="inlineStr"><is><t>x</t></is></c></row>'
NAMES = '<row r="1"><c r="A1" t="inlineStr"><is><t>Name</t></is></c></row>'
NAMES += '<row r="2"><c r="A2" t="inlineStr"><is><t>Door</t></is></c></row>'


@pytest.mark.slow
@pytest.mark.parametrize(
    ("data", "words"),
    [
        (FAR.format(row=1_048_576, cell="XFD1048576"), "a sheet may have 50,000 rows; this one has 1,048,576"),
        (FAR.format(row=999_999_999, cell="A999999999"), "this one has 999,999,999"),
        (FAR.format(row=2, cell="XFD2"), "a sheet may have 2,000 columns; this one has 16,384, up to cell XFD2"),
        (FAR.format(row=40_000, cell="A40000") + FAR.format(row=1, cell="ZZ1"), "5,000,000 cells"),
        (FAR.format(row=1, cell="ZZZZZZZZ1"), "columns"),
    ],
    ids=["far corner", "nine digits", "far right", "area", "letters"],
)
def test_a_small_workbook_that_asks_for_much_is_refused_with_numbers(parsers: Parsers, data: str, words: str):
    with pytest.raises(SheetUnreadable, match="a sheet may have") as refusal:
        parsers.call(parse_bytes, sheet_of(NAMES + data), refusal=SheetUnreadable)
    assert words in refusal.value.message


@pytest.mark.parametrize("name", ["xl/worksheets/sheet1.xml", "xl/workbook.xml"])
def test_a_megabyte_between_two_tags_is_refused_before_the_reader_keeps_it(parsers: Parsers, name: str):
    book = with_part(b"<worksheet>" + b" " * 3_000_000 + b"</worksheet>", name)
    with pytest.raises(SheetUnreadable, match="1 MiB without a cell or a tag"):
        parsers.call(parse_bytes, book, refusal=SheetUnreadable)


@pytest.mark.parametrize(
    "data",
    [
        '<row r="999999999"><c t="inlineStr"><is><t>x</t></is></c></row>',
        '<row r="4294967295"><c t="inlineStr"><is><t>x</t></is></c></row>',
        '<row r="3"><c r="&#88;FD1048576" t="inlineStr"><is><t>x</t></is></c></row>',
        "<row><c><v>" * 2_000,
    ],
    ids=["a far row without places", "the last of all rows", "a place in entities", "never closed"],
)
def test_what_hides_from_the_count_ends_its_child_and_no_more(parsers: Parsers, data: str):
    for _ in range(2):
        try:
            parsers.call(parse_bytes, sheet_of(NAMES + data), refusal=SheetUnreadable)
        except SheetUnreadable:
            continue
    assert parsers.call(parse_bytes, sheet_of(NAMES), refusal=SheetUnreadable)[2] == [(2, ["Door"])]


def test_the_web_process_outlives_two_of_them(world: World):
    for row in (999_999_999, 4_294_967_295):
        problem = refused(world, sheet_of(NAMES + f'<row r="{row}"><c t="inlineStr"><is><t>x</t></is></c></row>'))
        assert problem["code"] == "sheet-unreadable"
    assert send(world, sheet_of(NAMES))["added"] == 1
    assert [cue["name"] for cue in cues(world)] == ["Door"]


def test_formatted_empty_rows_to_the_end_of_the_sheet_do_not_count(parsers: Parsers):
    empty = "".join(f'<row r="{row}" s="1"><c r="A{row}" s="1"/></row>' for row in range(3, 60_003))
    empty += '<row r="1048576" s="1"><c r="XFD1048576" s="1"></c></row>'
    assert parsers.call(parse_bytes, sheet_of(NAMES + empty), refusal=SheetUnreadable)[2] == [(2, ["Door"])]


def test_formulas_merged_cells_and_gaps_are_read_as_they_are_shown(parsers: Parsers):
    out = io.BytesIO()
    book = xlsxwriter.Workbook(out, {"in_memory": True})
    sheet = book.add_worksheet()
    sheet.write_row(0, 0, ["Name", "Duration", "Use"])
    sheet.write_string(1, 0, "Door")
    sheet.write_formula(1, 1, "=0.5*3", None, 1.5)
    sheet.write_string(900, 0, "Bell")
    sheet.merge_range(900, 1, 901, 2, "hall")
    book.close()
    rows = parsers.call(parse_bytes, out.getvalue(), refusal=SheetUnreadable)[2]
    assert rows == [(2, ["Door", "1.5", ""]), (901, ["Bell", "hall", ""])]


LINES = "Name;Use\nTür;Öffnen\n"


@pytest.mark.parametrize(
    "data",
    [LINES.encode(each) for each in ("utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "cp1252", "latin-1")],
)
def test_encodings_of_spreadsheets_are_read(data: bytes):
    assert parse_bytes(data)[:3] == (1, ("Name", "Use"), [(2, ["Tür", "Öffnen"])])


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (LINES.encode() + "Bell;schön\nGlas;schön".encode() + b"\xff\n", "row 4: a character is damaged"),
        (LINES.encode("utf-16")[:-1], "row 2: a character is damaged or cut off; the file is UTF-16"),
        (b"Name,Use\nDoor,\0\n", "row 2: this is not text: it holds zero bytes"),
        (
            b"Name,Use\nDoor," + b"x" * 140_000 + b"\n",
            "row 2, column 2: a cell may have 10,000 characters; this one has 140,000",
        ),
        (b"Name,Use\n" + b"x," * 201 + b"\n", "row 2: a sheet may have 200 columns; this row has 201 filled cells"),
        (b"Name\n" + b"x\n" * 10_019, "a sheet may have 10,000 rows; this one has 10,020"),
        (b"Name\n" + b"x\n" * 1_048_575, "a sheet may have 10,000 rows; this one has 1,048,576"),
        (
            ("Name," + ",".join("abcdefghi") + "\n" + ("x," * 190 + "\n") * 5_000).encode(),
            "a sheet may have 400,000 filled cells",
        ),
    ],
    ids=["damaged UTF-8", "half a UTF-16", "zero byte", "long cell", "wide", "rows", "all rows", "cells"],
)
def test_what_cannot_be_kept_whole_is_refused_with_its_row(parsers: Parsers, data: bytes, words: str):
    with pytest.raises(SheetUnreadable) as refusal:
        parsers.call(parse_bytes, data, refusal=SheetUnreadable)
    assert words in refusal.value.message


def test_a_million_empty_rows_are_passed_over(parsers: Parsers):
    text = "Name,Use\n" + "\n" * 500_000 + "Door,hall\n" + ",\n" * 500_000
    assert parsers.call(parse_text, text, False, refusal=SheetUnreadable)[2] == [(500_002, ["Door", "hall"])]


@pytest.mark.slow
def test_10_000_cues_come_in_from_a_workbook(world: World):
    rows: list[list[object]] = [["Name", "File name", "Category", "Description", "Duration"]]
    rows += [[f"Cue {place}", f"cue_{place}.wav", "ui", "a click of the menu", 0.25] for place in range(MAX_ROWS)]
    reported = send(world, workbook(rows))
    assert (reported["added"], reported["errors"], reported["imported"]) == (MAX_ROWS, [], True)


LETTERS = ["a", "1", " ", "-", "_", ",", ".", "(", "[", "~", "x", "0", "A", "a1", "1a", "_v", "__alt", "0-", "aA", "1:"]


@pytest.mark.parametrize("letters", LETTERS)
@pytest.mark.parametrize("end", ["", "!", "1", "é"])
def test_no_long_cell_is_searched_through_again_and_again(letters: str, end: str):
    # An expression that takes the square of the longest cell, 10,000 characters, takes 4 s; of these it never ends.
    cell = (letters * 200_000)[: 200_000 - len(end)] + end
    head_of(cell)
    read_label("SW", cell)
    for field in ("duration_s", "frame_rate_fps", "variations", "playback_priority", "loop", "state", "reverb", "name"):
        with contextlib.suppress(ValueError):
            read_cell(field, cell)


@pytest.mark.slow
@pytest.mark.parametrize("letters", LETTERS)
def test_no_file_name_takes_guessing_long(letters: str):
    name = (letters * 255)[:251] + ".wav"
    others = [ListedCue(place, (letters * 200)[:199] + str(place), name) for place in range(200)]
    with at_most(12_000_000):  # the most that one takes is 5,800,000
        index = NameIndex(others)
        index.sure(name)
        index.guesses(f"{letters * 100}/{name}")
        index.shared_prefixes([name] * 10)


GOOD = [b"Name,Use\nDoor,hall\n", workbook([["Name", "Use"], ["Door", "hall"]]), LINES.encode("utf-16")]


@pytest.mark.slow
@settings(max_examples=40, deadline=None)
@given(st.sampled_from(GOOD), st.randoms(use_true_random=False), st.integers(1, 12))
def test_mutants_are_read_or_refused(parsers: Parsers, good: bytes, chance: random.Random, count: int):
    mutant = bytearray(good)
    for _ in range(count):
        place = chance.randrange(len(mutant))
        match chance.randrange(4):
            case 0:
                mutant[place] = chance.randrange(256)
            case 1:
                mutant[place:place] = chance.choice([b'"', b"\0", b",", b"\r", b"\xff", b"=", b"9" * 30, b"\n" * 30])
            case 2:
                del mutant[place : place + chance.randrange(9)]
            case _:
                mutant[place:place] = mutant[place : place + chance.randrange(200)]
        if not mutant:
            return
    with contextlib.suppress(SheetUnreadable):
        assert len(parsers.call(parse_bytes, bytes(mutant), refusal=SheetUnreadable)) == 4


@pytest.mark.slow
def test_mutants_over_http_never_answer_500(world: World):
    chance = random.Random(20)
    pieces = [
        "Name",
        "Use",
        ",",
        ";",
        "\t",
        "\n",
        "\r\n",
        '"',
        "'",
        "=1+1",
        "1e999",
        "²",
        "SW-1",
        "9" * 400,
        "\u202e",
        "é",
    ]
    pieces += ["Duration", "No", "1:99", "loop", "-", "Category", "sep=,\n", "x" * 300, "cut", "State", "\u202e", "|"]
    for _ in range(30):
        text = "Name,Duration,No\n" + "".join(chance.choices(pieces, k=40))
        answer = world.producer.post(
            f"/v1/projects/{world.project_id}/sound-list/import",
            json={"format": chance.choice(["csv", "paste"]), "text": text, "dry_run": chance.random() < 0.5},
        )
        assert answer.status_code in (200, 422), answer.text


def test_a_workbook_whose_packed_bytes_are_damaged_is_refused_in_words() -> None:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("xl/workbook.xml", bytes(range(256)) * 40)
    damaged = bytearray(packed.getvalue())
    damaged[60:90] = b"\xff" * 30
    with pytest.raises(SheetUnreadable, match="not a workbook that can be read"):
        parse_bytes(bytes(damaged))
