"""Spreadsheets as people send them: all of it comes in, or nothing."""

import base64
import csv
import io
import zipfile
from datetime import date
from datetime import time as time_of_day
from typing import Any

import pytest
import xlsxwriter
from fastapi.testclient import TestClient

import audio_checks
from app.sound_lists.columns import read_cell
from tests.app.sound_lists.lists import add, cut, the_list
from tests.support.server import World

HEAD = "number,name,file_name,category,description,use,trigger,duration_s,length_locked,frame_rate_fps,loop,reverb,"
HEAD += "variations,state"


def send(world: World, content: bytes | str, by: TestClient | None = None, **more: object) -> dict[str, Any]:
    body: dict[str, object] = {"format": "csv", "dry_run": False}
    if isinstance(content, bytes):
        body["content_base64"] = base64.b64encode(content).decode()
    else:
        body["text"] = content
    answer = (by or world.producer).post(f"/v1/projects/{world.project_id}/sound-list/import", json=body | more)
    assert answer.status_code == 200, answer.text
    reported: dict[str, Any] = answer.json()
    return reported


def refused(world: World, content: bytes | str, **more: object) -> dict[str, Any]:
    body: dict[str, object] = {"format": "csv", "dry_run": False}
    key, value = (
        ("content_base64", base64.b64encode(content).decode()) if isinstance(content, bytes) else ("text", content)
    )
    answer = world.producer.post(f"/v1/projects/{world.project_id}/sound-list/import", json=body | {key: value} | more)
    assert answer.status_code == 422, answer.text
    problem: dict[str, Any] = answer.json()
    return problem


def cues(world: World) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = the_list(world)["cues"]
    return found


def workbook(*sheets: list[list[object]]) -> bytes:
    out = io.BytesIO()
    book = xlsxwriter.Workbook(out, {"in_memory": True})
    day = book.add_format({"num_format": "yyyy-mm-dd"})
    clock = book.add_format({"num_format": "hh:mm:ss"})
    for rows in sheets:
        sheet = book.add_worksheet()
        for line, row in enumerate(rows):
            for place, cell in enumerate(row):
                if isinstance(cell, date):
                    sheet.write_datetime(line, place, cell, day)
                elif isinstance(cell, time_of_day):
                    sheet.write_datetime(line, place, cell, clock)
                elif cell is not None:
                    sheet.write(line, place, cell)
    book.close()
    return out.getvalue()


def test_german_csv_of_excel(world: World) -> None:
    text = "Nr;Bezeichnung;Dateiname;Kategorie;Dauer (s);Schleife;Varianten\r\n"
    text += "7;Tür öffnet;tuer_auf.wav;Foley;1,5;nein;2\r\n"
    reported = send(world, text.encode("cp1252"))
    assert (reported["imported"], reported["added"], reported["errors"]) == (True, 1, [])
    assert [column["guess"] for column in reported["columns"]] == [
        "number", "name", "file_name", "category", "duration_s", "loop", "variations",
    ]  # fmt: skip
    (cue,) = cues(world)
    assert (cue["label"], cue["name"], cue["category"]) == ("SW-007", "Tür öffnet", "foley")
    assert (cue["duration_s"], cue["loop"], cue["stems"]) == (1.5, False, ["tuer_auf_01", "tuer_auf_02"])


@pytest.mark.parametrize(
    "content",
    [
        "\ufeffName,Length (s)\nDoor,1.5\n".encode(),
        b"Name;Length (s)\nDoor;1,5\n",
        b"Name\tLength (s)\r\nDoor\t1.5 s\r\n",
        b"sep=;\r\nName;Length (s)\r\nDoor;1,5\r\n",
        b"Name|Duration\nDoor|1.5\n",
        b"Name,Length (ms)\nDoor,1500\n",
        b"Name,Length\nDoor,1500 ms\n",
        b"Name,Length\nDoor,0:01.5\n",
        b"Sound name,Seconds\nDoor,~1.50\n",
        "Name,Duration [sec]\nDoor,1.5\n".encode("utf-16"),
        b"\n\nSound list of Shield Wing,\n,\nName,Dauer\n,\nDoor,1.5\n,\n",
        workbook([["Name", "Length (s)"], ["Door", 1.5]]),
        workbook([["Sound list"], [None], ["Name", "Length"], [None, None], ["Door", time_of_day(0, 0, 1, 500_000)]]),
        workbook([["Read me", "first"]], [["Name", "Dauer"], ["Door", "1,5"]]),
    ],
)
def test_dialects(world: World, content: bytes) -> None:
    reported = send(world, content)
    assert reported["imported"], reported
    assert [(cue["name"], cue["duration_s"]) for cue in cues(world)] == [("Door", 1.5)]


def test_a_cell_may_hold_lines_separators_and_quotes(world: World) -> None:
    reported = send(world, 'Name,Description\nDoor,"heavy, ""old""\r\nand slow"\nBell,x\n')
    assert [row["row"] for row in reported["rows"]] == [2, 3]
    assert cues(world)[0]["description"] == 'heavy, "old"\nand slow'


def test_columns_without_a_field_are_kept(world: World) -> None:
    reported = send(
        world,
        workbook(
            [
                ["Name", "Mood", "Approved on", "Done", "Mood", None],
                ["Door", "grim", date(2026, 3, 1), True, "dark", "note"],
            ]
        ),
    )
    assert [column["name"] for column in reported["columns"]] == [
        "Name",
        "Mood",
        "Approved on",
        "Done",
        "Mood (2)",
        "Column 6",
    ]
    assert cues(world)[0]["extra"] == {
        "Mood": "grim", "Approved on": "2026-03-01", "Done": "yes", "Mood (2)": "dark", "Column 6": "note",
    }  # fmt: skip


def test_a_column_that_only_sounds_like_a_field_is_kept_as_it_is(world: World) -> None:
    reported = send(world, "Name,Status,ID\nDoor,in progress,AMB-X\nBell,done,AMB-Y\n")
    assert [column["guess"] for column in reported["columns"]] == ["name", None, None]
    assert cues(world)[0]["extra"] == {"Status": "in progress", "ID": "AMB-X"}


def test_mapping_says_otherwise(world: World) -> None:
    mapping = {"Sonido": "name", "Notas": "description", "Basura": "ignore", "Name": "extra"}
    reported = send(world, "Sonido,Notas,Basura,Name\nPuerta,pesada,x,y\n", mapping=mapping)
    assert reported["imported"], reported
    (cue,) = cues(world)
    assert (cue["name"], cue["description"], cue["extra"]) == ("Puerta", "pesada", {"Name (own)": "y"})


def test_a_mapping_that_does_not_fit_is_refused(world: World) -> None:
    assert refused(world, "Name\nx\n", mapping={"Nme": "name"})["code"] == "column-unknown"
    assert refused(world, "A,B\nx,y\n", mapping={"A": "name", "B": "name"})["code"] == "column-unknown"


@pytest.mark.parametrize(
    ("head", "cells", "field", "read"),
    [
        ("Prio", ["high", "low"], "playback_priority", [750, 250]),
        ("Prio", ["hoch", "mittel"], "playback_priority", [750, 500]),
        ("Wichtigkeit", ["3", ""], "playback_priority", [3, None]),
        ("Kind", ["weapon", "ui"], "category", ["weapon", "ui"]),
        ("Kind", ["loop", "one-shot"], "loop", [True, False]),
        ("Typ", ["Loop", "Oneshot"], "loop", [True, False]),
        ("Typ", ["Waffe", "UI"], "category", ["waffe", "ui"]),
        ("Laufzeit (s)", ["1,5", "2"], "duration_s", [1.5, 2]),
        ("Anz.", ["3", "1"], "variations", [3, 1]),
        ("Szene", ["Brücke", "Hangar"], "use", ["Brücke", "Hangar"]),
    ],
)
def test_common_spellings_of_heads(world: World, head: str, cells: list[str], field: str, read: list[object]) -> None:
    rows = "".join(f"sound{place}\t{cell}\n" for place, cell in enumerate(cells))
    reported = send(world, f"name\t{head}\n{rows}", format="paste")
    assert (reported["columns"][1]["guess"], reported["errors"]) == (field, [])
    assert [cue[field] for cue in cues(world)] == read


@pytest.mark.parametrize(
    ("head", "cells", "days"),
    [
        ("Due date", ["2026-12-04", ""], ["2026-12-04", None]),
        ("Fällig am", ["4.12.2026", "04.12.26"], ["2026-12-04", "2026-12-04"]),
        ("Deadline", ["31/5/2026", "4/5/2026"], ["2026-05-31", "2026-05-04"]),  # the first shows the order of all
        ("Needed by", ["5/31/2026", "5/4/2026"], ["2026-05-31", "2026-05-04"]),
        ("Due", ["Dec 4, 2026", "4 December 2026"], ["2026-12-04", "2026-12-04"]),
        ("Liefertermin", ["4. März 2027", "tbd"], ["2027-03-04", None]),
    ],
)
def test_due_dates_as_people_write_them(world: World, head: str, cells: list[str], days: list[str | None]) -> None:
    rows = "\n".join(f"cue_{place}\t{cell}" for place, cell in enumerate(cells))
    read = send(world, f"Name\t{head}\n{rows}", format="paste")
    assert read["columns"][1]["field"] == "due_on"
    assert [cue["due_on"] for cue in cues(world)] == days


def test_a_day_that_could_be_two_is_asked_for(world: World) -> None:
    read = send(world, "Name\tDue\ndoor\t4/5/2026", format="paste")
    [error] = read["errors"]
    assert error["message"] == '"4/5/2026" could be 04 May or 05 April; write 2026-05-04'
    assert not read["imported"]


def test_days_in_a_workbook_come_in_and_go_out(world: World) -> None:
    send(world, workbook([["Name", "Due date"], ["door", date(2026, 12, 4)]]), format="xlsx")
    assert [cue["due_on"] for cue in cues(world)] == ["2026-12-04"]
    exported = world.producer.get(f"/v1/projects/{world.project_id}/sound-list.csv").text
    assert "due_on" in exported.splitlines()[0]
    assert "2026-12-04" in exported.splitlines()[1]


def test_a_due_date_is_changed_and_the_change_is_kept(world: World) -> None:
    send(world, "Name\tDue\ndoor\t2026-12-04", format="paste")
    [cue] = cues(world)
    answer = world.producer.patch(f"/v1/cues/{cue['id']}", json={"edition": cue["edition"], "due_on": "2026-12-11"})
    assert answer.status_code == 200, answer.text
    address = f"/v1/projects/{world.project_id}/sound-list/revisions/compare"
    [change] = world.producer.get(address, params={"from": 1, "to": 2}).json()["changed"][0]["changes"]
    assert (change["field"], change["before"], change["after"]) == ("due_on", "2026-12-04", "2026-12-11")


def test_one_wrong_mapping_is_one_error(world: World) -> None:
    rows = "".join(f"sound{place},Mood {place}\n" for place in range(61))
    reported = send(world, f"name,Mood\n{rows}", mapping={"Mood": "duration_s"})
    (fault,) = reported["errors"]
    assert (fault["row"], fault["column"], reported["imported"]) == (2, "Mood", False)
    assert fault["message"] == (
        '61 of 61 cells in this column do not fit: wanted seconds such as 1.5, found "Mood 0"; '
        "map the column to another field, or ignore it"
    )


def test_every_wrong_cell_is_named_by_its_row_and_nothing_comes_in(world: World) -> None:
    reported = send(
        world,
        "name,duration_s,loop,variations,state,reverb,category\n"
        "Fine,1.5,yes,2,locked,dry,ui\n"
        "Door,long,yes,2,locked,dry,ui\n"
        ",,,,,,ui\n"
        "Bell,1.5,perhaps,two,done,wet,ui\n"
        "fine,,,,,,\n"
        "Gong,-1,no,200,cut,,a b!\n",
    )
    assert not reported["imported"]
    assert {(fault["row"], fault["column"]) for fault in reported["errors"]} == {
        (3, "duration_s"),
        (4, "name"),
        (5, "loop"),
        (5, "variations"),
        (5, "state"),
        (5, "reverb"),
        (7, "duration_s"),
    }
    assert all(fault["message"] for fault in reported["errors"])
    assert {fault["name"] for fault in reported["errors"]} == {"Door", "", "Bell", "Gong"}
    assert the_list(world) == {"revision": 0, "cues": []}


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
    assert cues(world) == []


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
    assert cues(world) == []


def test_a_dry_run_says_all_and_does_nothing(world: World) -> None:
    add(world, {"name": "Door"}, {"name": "Bell"})
    text = "number,name,description\nSW-001,Door,heavy\n2,Bell,\n,Gong,new\nSW-009,Horn,\n"
    reported = send(world, text, dry_run=True)
    assert (reported["imported"], reported["added"], reported["changed"], reported["same"]) == (False, 2, 1, 1)
    assert [(row["action"], row["label"]) for row in reported["rows"]] == [
        ("change", "SW-001"),
        ("same", "SW-002"),
        ("add", None),
        ("add", "SW-009"),
    ]
    assert reported["rows"][0]["changes"] == [{"field": "description", "before": "", "after": "heavy"}]
    assert len(cues(world)) == 2
    reported = send(world, text)
    assert (reported["imported"], reported["revision"]) == (True, 2)
    assert [(cue["label"], cue["description"]) for cue in cues(world)] == [
        ("SW-001", "heavy"),
        ("SW-002", ""),
        ("SW-010", "new"),
        ("SW-009", ""),
    ]


def test_matching_by_name(world: World) -> None:
    add(world, {"name": "Door"}, {"name": "Bell", "file_name": "bell_a"}, {"name": "Bell", "file_name": "bell_b"})
    reported = send(world, "name,use\nDOOR,hall\n", match="name")
    assert [row["action"] for row in reported["rows"]] == ["change"]
    reported = send(world, "name,use\nBell,hall\nDoor,x\ndoor,y\n", match="name")
    assert not reported["imported"]
    assert [fault["row"] for fault in reported["errors"]] == [2, 4]
    assert "SW-002 and SW-003" in reported["errors"][0]["message"]
    assert "row 3" in reported["errors"][1]["message"]


def test_adding_never_changes(world: World) -> None:
    add(world, {"name": "Door"})
    reported = send(world, "number,name\nSW-001,Gate\n", match="add")
    assert [(fault["row"], fault["column"]) for fault in reported["errors"]] == [(2, "number")]
    reported = send(world, "number,name\n5,Gate\n5,Horn\n", match="add")
    assert [(fault["row"], fault["column"]) for fault in reported["errors"]] == [(3, "number")]
    assert send(world, "name\nGate\n", match="add")["imported"]


def test_an_import_can_swap_two_names(world: World) -> None:
    add(world, {"name": "One"}, {"name": "Two"})
    assert send(world, "number,name\n1,Two\n2,One\n")["imported"]
    assert [cue["stems"] for cue in cues(world)] == [["two"], ["one"]]


def test_a_cut_cue_stays_as_it_is(world: World) -> None:
    one, _ = add(world, {"name": "Door"}, {"name": "Bell"})
    cut(world, one["id"], "no doors")
    reported = send(world, "number,name,state\nSW-001,Gate,cut\nSW-002,Bell,cut\n")
    assert [(fault["row"], fault["column"]) for fault in reported["errors"]] == [(2, None), (3, "state")]


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("Door\nBell, big\nGong\n", ["Door", "Bell, big", "Gong"]),
        ("Door\theavy\r\nBell\tbig\r\n", ["Door", "Bell"]),
        ("Name\tLoop\nDoor\tx\n", ["Door"]),
    ],
)
def test_pasted_rows_need_no_head(world: World, text: str, names: list[str]) -> None:
    assert send(world, text, format="paste")["imported"]
    assert [cue["name"] for cue in cues(world)] == names


def wild_rows() -> list[dict[str, Any]]:
    return [
        {"name": "+10 bonus", "file_name": "bonus", "description": "=1+1\nsecond, \"line\"",
         "use": "@home", "trigger": "-x"},
        {"name": "'quoted'", "file_name": "quoted", "extra": {"Mood": "=cmd|' /C calc'!A0", "mood of all": "'tis"}},
        {"name": "Tür", "file_name": "tür.wav", "category": "foley", "duration_s": 0.1, "length_locked": True,
         "frame_rate_fps": 29.97, "loop": True, "reverb": "designed-tail", "variations": 12, "state": "locked",
         "playback_priority": 3, "placeholder": True, "palette": True},
        {"name": "Plain", "duration_s": 3, "state": "concept", "reverb": "dry"},
    ]  # fmt: skip


def test_the_export_comes_back_as_it_went(world: World, server: Any) -> None:
    (*_, plain) = add(world, *wild_rows())
    cut(world, plain["id"], "not needed")
    url = f"/v1/projects/{world.project_id}/sound-list.csv"
    text = world.designer.get(url).text
    assert text.splitlines()[0].startswith(HEAD)
    before = cues(world)
    for match in ("number", "name"):
        reported = send(world, text, match=match)
        assert (reported["errors"], reported["same"], reported["added"], reported["changed"]) == ([], 4, 0, 0)
    assert cues(world) == before
    elsewhere = World(server)
    assert send(elsewhere, text.encode())["imported"]
    kept = ("label", "name", "file_name", "stems", "description", "use", "trigger", "duration_s", "length_locked",
            "frame_rate_fps", "loop", "reverb", "variations", "state", "playback_priority", "placeholder", "palette",
            "extra", "category")  # fmt: skip
    assert [[cue[key] for key in kept] for cue in cues(elsewhere)] == [[cue[key] for key in kept] for cue in before]


def test_the_command_line_reads_the_export_as_the_server_does(world: World) -> None:
    add(world, *wild_rows())
    read = audio_checks.read_sound_list(world.designer.get(f"/v1/projects/{world.project_id}/sound-list.csv").text)
    for cue, facts in zip(cues(world), read.cues, strict=True):
        assert facts.number == cue["label"]
        for key in (
            "file_name",
            "duration_s",
            "length_locked",
            "frame_rate_fps",
            "loop",
            "reverb",
            "variations",
            "state",
        ):
            assert getattr(facts, key) == cue[key], key
        assert (facts.category or "") == cue["category"]
        for variation, stem in enumerate(cue["stems"], start=1):
            slot = read.slot(stem)
            assert slot is not None
            assert (slot[0].number, slot[1]) == (cue["label"], variation)


def test_no_cell_of_the_export_is_a_formula(world: World) -> None:
    add(world, *wild_rows())
    text = world.designer.get(f"/v1/projects/{world.project_id}/sound-list.csv").text
    cells = [cell for row in csv.reader(io.StringIO(text)) for cell in row]
    assert not [cell for cell in cells if cell.startswith(("=", "+", "-", "@", "\t", "\r"))]


@pytest.mark.slow
def test_ten_thousand_rows(world: World) -> None:
    rows = "".join(
        f"Sound {number},{number % 50 / 10 + 0.1:.1f},ui,Words about sound {number}\n" for number in range(10_000)
    )
    reported = send(world, "name,duration,category,description\n" + rows)
    assert reported["imported"], reported["errors"][:3]
    assert reported["added"] == 10_000
    assert send(world, "name,duration,category,description\n" + rows, match="name")["same"] == 10_000
    assert len(cues(world)) == 10_000
    assert "rows" in refused(world, "name\n" + "".join(f"x{number}\n" for number in range(10_001)))["detail"]


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
        (bomb(), "may unpack to 100,000,000 bytes"),
        (far_cell(), "a sheet may have 50,000 rows; this one has 1,048,576, up to cell XFD1048576"),
        ((",".join(f"c{number}" for number in range(201)) + "\n").encode(), "columns"),
    ],
    ids=["nothing", "blank", "a wave", "half a zip", "xls", "open quote", "large", "bomb", "far cell", "wide"],
)
def test_a_file_that_is_not_a_sheet_is_refused_with_a_reason(world: World, content: bytes, words: str) -> None:
    problem = refused(world, content)
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
