"""Spreadsheets as people send them."""

import base64
import csv
import io
from datetime import date
from datetime import time as time_of_day
from typing import Any

import pytest
import xlsxwriter
from httpx2 import Client

import audio_checks
from tests.app.sound_lists.lists import add, cut, the_list
from tests.support.server import World

HEAD = "number,name,file_name,category,description,use,trigger,duration_s,duration_min_s,duration_max_s,"


HEAD += "length_locked,frame_rate_fps,loop,reverb,channels,variations,state"


def send(world: World, content: bytes | str, by: Client | None = None, **more: object) -> dict[str, Any]:
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
        ("Prio", ["high", "low"], "need", ["must", "wish"]),
        ("Prio", ["hoch", "mittel"], "need", ["must", "should"]),
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


@pytest.mark.slow
def test_matching_by_name(world: World) -> None:
    add(world, {"name": "Door"}, {"name": "Bell", "file_name": "bell_a"}, {"name": "Bell", "file_name": "bell_b"})
    reported = send(world, "name,use\nDOOR,hall\n", match="name")
    assert [row["action"] for row in reported["rows"]] == ["change"]
    reported = send(world, "name,use\nBell,hall\nDoor,x\ndoor,y\n", match="name", atomic=True)
    assert not reported["imported"]
    assert [fault["row"] for fault in reported["errors"]] == [2, 4]
    assert "SW-002 and SW-003" in reported["errors"][0]["message"]
    assert "row 3" in reported["errors"][1]["message"]


@pytest.mark.slow
def test_adding_never_changes(world: World) -> None:
    add(world, {"name": "Door"})
    reported = send(world, "number,name\nSW-001,Gate\n", match="add")
    assert [(fault["row"], fault["column"]) for fault in reported["errors"]] == [(2, "number")]
    reported = send(world, "number,name\n5,Gate\n5,Horn\n", match="add")
    assert [(fault["row"], fault["column"]) for fault in reported["errors"]] == [(3, "number")]
    assert [cue["label"] for cue in cues(world)] == ["SW-001", "SW-005"]
    assert send(world, "name\nBridge\n", match="add")["imported"]


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
         "frame_rate_fps": 29.97, "loop": True, "reverb": "designed-tail", "channels": "stereo", "variations": 12,
         "state": "locked", "playback_priority": 3, "placeholder": True, "palette": True},
        {"name": "＝1＋1", "file_name": "wide", "description": "＋2", "use": "－3", "trigger": "＠home",
         "extra": {"Mood": "＝HYPERLINK(\"https://elsewhere.example\")", "＠mood": "calm"}},  # full-width
        {"name": "Plain", "duration_s": 3, "duration_min_s": 2.5, "duration_max_s": 4, "state": "concept",
         "reverb": "dry"},
    ]  # fmt: skip


@pytest.mark.slow
def test_the_export_comes_back_as_it_went(world: World, server: Any) -> None:
    (*_, plain) = add(world, *wild_rows())
    cut(world, plain["id"], "not needed")
    url = f"/v1/projects/{world.project_id}/sound-list.csv"
    text = world.designer.get(url).text
    assert text.splitlines()[0].startswith(HEAD)
    before = cues(world)
    for match in ("number", "name"):
        reported = send(world, text, match=match)
        assert (reported["errors"], reported["same"], reported["added"], reported["changed"]) == ([], 5, 0, 0)
    assert cues(world) == before
    elsewhere = World(server)
    assert send(elsewhere, text.encode())["imported"]
    kept = ("label", "name", "file_name", "stems", "description", "use", "trigger", "duration_s", "duration_min_s",
            "duration_max_s", "length_locked", "frame_rate_fps", "loop", "reverb", "channels", "variations",
            "state", "playback_priority", "placeholder", "palette", "extra", "category")  # fmt: skip
    assert [[cue[key] for key in kept] for cue in cues(elsewhere)] == [[cue[key] for key in kept] for cue in before]


def test_the_command_line_reads_the_export_as_the_server_does(world: World) -> None:
    add(world, *wild_rows())
    read = audio_checks.read_sound_list(world.designer.get(f"/v1/projects/{world.project_id}/sound-list.csv").text)
    for cue, facts in zip(cues(world), read.cues, strict=True):
        assert facts.number == cue["label"]
        for key in (
            "file_name",
            "duration_s",
            "duration_min_s",
            "duration_max_s",
            "length_locked",
            "frame_rate_fps",
            "loop",
            "reverb",
            "channels",
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
    assert not [cell for cell in cells if cell.startswith(tuple("=+-@\t\r\n＝＋－＠"))]


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
