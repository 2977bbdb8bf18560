"""Spreadsheets with faults: each is named, and stops no other row."""

import io
import zipfile
from collections.abc import Callable

import pytest

from audio_checks import read_cell
from tests.app.sound_lists.lists import the_list
from tests.app.sound_lists.test_imports import cues, refused, send, workbook
from tests.support.server import World


def test_one_wrong_mapping_is_one_error(world: World) -> None:
    rows = "".join(f"sound{place},Mood {place}\n" for place in range(61))
    reported = send(world, f"name,Mood\n{rows}", mapping={"Mood": "duration_s"})
    (fault,) = reported["errors"]
    assert (fault["row"], fault["column"], reported["imported"]) == (2, "Mood", False)
    assert fault["message"] == (
        '61 of 61 cells in this column do not fit: wanted seconds such as 1.5, found "Mood 0"; '
        "map the column to another field, or ignore it"
    )


def test_a_sheet_without_a_column_of_names_says_which_columns_there_are(world: World) -> None:
    reported = send(world, "Klic,Category\nrain,amb\ndoor,foley\n", dry_run=True)
    (fault,) = reported["errors"]
    assert fault["message"] == (
        "no column is read as the name, and 2 rows have none; choose the column of names: Klic, Category"
    )
    assert send(world, "Klic,Category\nrain,amb\n", mapping={"Klic": "name"}, dry_run=True)["errors"] == []


def test_every_wrong_cell_is_named_by_its_row_and_stops_no_other(world: World) -> None:
    text = (
        "name,duration_s,loop,variations,state,reverb,category\n"
        "Fine,1.5,yes,2,locked,dry,ui\n"
        "Door,long,yes,2,locked,dry,ui\n"
        ",,,,,,ui\n"
        "Bell,1.5,perhaps,two,done,wet,ui\n"
        "fine,,,,,,\n"
        "Gong,-1,no,200,cut,,a b!\n"
    )
    assert send(world, text, atomic=True)["imported"] is False
    assert the_list(world) == {"revision": 0, "cues": []}
    reported = send(world, text)
    assert (reported["imported"], reported["left_out"]) == (True, [3, 5, 7])
    assert {(fault["row"], fault["column"]) for fault in reported["errors"]} == {
        (3, "duration_s"),
        (5, "loop"),
        (5, "state"),
        (5, "reverb"),
        (7, "duration_s"),
    }
    assert all(fault["message"] for fault in reported["errors"])
    assert {fault["name"] for fault in reported["errors"]} == {"Door", "Bell", "Gong"}
    assert [cue["name"] for cue in cues(world)] == ["Fine", "fine"]
    assert [(row["row"], row["text"]) for row in reported["skipped"]] == [(4, "ui")]


@pytest.mark.parametrize("length", ["0", "0 ms", "0:00", "00:00:00", "-1"])
def test_a_length_of_nothing_is_refused(length: str) -> None:
    with pytest.raises(ValueError, match=f'wanted a length above 0, found "{length}"'):
        read_cell("duration_s", length)


def test_faults_that_only_the_whole_row_shows(world: World) -> None:
    reported = send(world, "name,variations,category\nDoor,,\ndoor,,\nBell,200,a b!\n")
    assert [(fault["row"], fault["column"]) for fault in reported["errors"]] == [
        (3, "name"),
        (4, "category"),
        (4, "variations"),
    ]
    assert "belongs to row 2" in reported["errors"][0]["message"]
    assert [cue["name"] for cue in cues(world)] == ["Door"]


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        ("a,Laser\nb,laser\n", "in case only"),
        ("a,caf\u00e9\nb,cafe\u0301\n", "belongs to row 2"),
        ("a,hit.wav\nb,hit\n", "belongs to row 2"),
    ],
)
def test_twin_file_names(world: World, rows: str, words: str) -> None:
    reported = send(world, "name,file name\n" + rows)
    (fault,) = reported["errors"]
    assert (fault["row"], fault["column"]) == (3, "file name")
    assert words in fault["message"]
    assert [cue["name"] for cue in cues(world)] == ["a"]


def bomb() -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("xl/workbook.xml", "<workbook/>")
        archive.writestr("xl/worksheets/sheet1.xml", b"\0" * 200_000_000)
    return out.getvalue()


def far_cell() -> bytes:
    book = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(workbook([["Name"], ["Door"]]))) as good, zipfile.ZipFile(book, "w") as bad:
        for entry in good.infolist():
            content = good.read(entry)
            if entry.filename == "xl/worksheets/sheet1.xml":
                content = content.replace(b'r="A2"', b'r="XFD1048576"').replace(b'<row r="2"', b'<row r="1048576"')
            bad.writestr(entry.filename, content)
    return book.getvalue()


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "empty"),
        (b"\n\n,,\n", "empty"),
        (b"RIFF\x00\x00\x00\x00WAVE", "zero bytes"),
        (b"PK\x03\x04 and then nothing", "not a workbook"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + b"\0" * 600, "old .xls"),
        (b'Name,Use\nDoor,"hall\nBell,x\n', "never closed"),
        (b"name\n" + b"x" * 5_000_001, "a file may have 5,000,000 bytes; this one has 5,000,006"),
        (bomb, "may unpack to 100,000,000 bytes"),
        (far_cell, "a sheet may have 50,000 rows; this one has 1,048,576, up to cell XFD1048576"),
        ((",".join(f"c{number}" for number in range(201)) + "\n").encode(), "columns"),
    ],
    ids=["nothing", "blank", "a wave", "half a zip", "xls", "open quote", "large", "bomb", "far cell", "wide"],
)
def test_a_file_that_is_not_a_sheet_is_refused_with_a_reason(
    world: World, content: bytes | Callable[[], bytes], words: str
) -> None:
    problem = refused(world, content if isinstance(content, bytes) else content())
    assert problem["code"] == "sheet-unreadable"
    assert words in problem["detail"]


def test_a_head_alone_imports_nothing(world: World) -> None:
    reported = send(world, "name,use\n")
    assert (reported["imported"], len(reported["errors"])) == (False, 1)


def test_nothing_sent_and_no_base64(world: World) -> None:
    url = f"/v1/projects/{world.project_id}/sound-list/import"
    assert world.producer.post(url, json={"format": "csv", "dry_run": True}).status_code == 422
    bad = {"format": "csv", "dry_run": True, "content_base64": "%%%"}
    assert world.producer.post(url, json=bad).json()["code"] == "sheet-unreadable"
