"""What an import guesses, skips and does not read: each is named in the answer, and can be undone."""

import io
from typing import Any

import pytest
import xlsxwriter

from tests.app.sound_lists.lists import add
from tests.app.sound_lists.test_imports import cues, refused, send
from tests.support.server import World


def book_of_tabs() -> bytes:
    """Return a workbook with a hidden tab, two lists, merged cells, a hidden row, a hidden column and a title."""
    out = io.BytesIO()
    book = xlsxwriter.Workbook(out, {"in_memory": True})
    old = book.add_worksheet("old & gone")
    old.write_row(0, 0, ["Name", "Category", "Duration", "Loop", "Cost"])
    old.write_row(1, 0, ["old_click", "ui", 1, "no", 5])
    sheet = book.add_worksheet("Weapons & UI")
    sheet.write_row(0, 0, ["Name", "Category", "Duration", "Cost"])
    sheet.merge_range(1, 0, 1, 3, "Everything that clicks")
    sheet.write_row(2, 0, ["a_one", "", 1, 100])
    sheet.merge_range(2, 1, 4, 1, "ui")
    for row, name in ((3, "a_two"), (4, "a_three")):
        sheet.write(row, 0, name)
        sheet.write(row, 2, 1)
    sheet.write_row(5, 0, ["a_dropped", "ui", 1, 100])
    sheet.write_formula(6, 0, "=A99", None, "#REF!")
    sheet.write(6, 1, "ui")
    sheet.set_row(5, None, None, {"hidden": True})
    sheet.set_column(3, 3, None, None, {"hidden": True})
    other = book.add_worksheet("Ambience")
    other.write_row(0, 0, ["Name", "Category"])
    other.write_row(1, 0, ["amb_rain", "ambience"])
    old.hide()
    sheet.activate()
    sheet.set_first_sheet()
    book.close()
    return out.getvalue()


def test_a_workbook_answers_its_tabs_filled_cells_hidden_and_broken_ones(world: World) -> None:
    book = book_of_tabs()
    read = send(world, book, format="xlsx", dry_run=True)
    assert [(tab["name"], tab["rows"], tab["is_hidden"], tab["is_read"]) for tab in read["tabs"]] == [
        ("old & gone", 2, True, False),
        ("Weapons & UI", 7, False, True),
        ("Ambience", 2, False, False),
    ]
    assert [(row["row"], row["kind"]) for row in read["skipped"]] == [(2, "section"), (6, "hidden")]
    assert [(guess["row"], guess["kind"], guess["value"]) for guess in read["guesses"]] == [
        (4, "filled_down", "ui"),
        (5, "filled_down", "ui"),
    ]
    assert [(column["name"], column["is_kept"]) for column in read["unread"]] == [("Cost", False)]
    assert [(fault["row"], "broken formula" in fault["message"]) for fault in read["errors"]] == [(7, True)]
    assert [(row["name"], row["category"]) for row in read["rows"]] == [
        ("a_one", "ui"), ("a_two", "ui"), ("a_three", "ui"),
    ]  # fmt: skip


def test_each_guess_about_a_workbook_can_be_undone(world: World) -> None:
    book = book_of_tabs()
    read = send(world, book, format="xlsx", dry_run=True, tab="Ambience")
    assert [row["name"] for row in read["rows"]] == ["amb_rain"]
    read = send(world, book, format="xlsx", dry_run=True, fill_down=False, keep_hidden=True, skip_rows=[3])
    assert [(row["name"], row["category"]) for row in read["rows"]] == [
        ("a_two", ""), ("a_three", ""), ("a_dropped", "ui"),
    ]  # fmt: skip
    assert [(row["row"], row["kind"]) for row in read["skipped"]] == [(2, "section"), (3, "asked")]
    assert "no tab" in refused(world, book, format="xlsx", tab="Music")["detail"]


SECTIONS = "Name,Category,Duration,Loop,Variations\nUI SOUNDS,,,,\nui_click,ui,1,no,1\nTOTAL,,1,,1\n"


def test_sections_and_totals_are_named_and_can_be_kept(world: World) -> None:
    read = send(world, SECTIONS + "ui_back,ui,1,no,1\n", dry_run=True)
    assert [(row["row"], row["kind"], row["text"]) for row in read["skipped"]] == [
        (2, "section", "UI SOUNDS"),
        (4, "total", "TOTAL, 1, 1"),
    ]
    assert read["added"] == 2
    assert send(world, SECTIONS + "ui_back,ui,1,no,1\n", dry_run=True, keep_rows=[2])["added"] == 3


def test_what_is_read_otherwise_than_it_is_written_is_marked_and_kept(world: World) -> None:
    text = "Asset,Length,Priority,Loopable?,# of variations,Due,Assignee\n"
    text += "laser.wav,1-2 s,High,checked,3-5,1-Dec-26,Jane\nUI_Click.ogg,<1s,Low,,2,46357,Jane\n"
    read = send(world, text)
    assert {(guess["row"], guess["column"], guess["value"]) for guess in read["guesses"]} == {
        (2, "Asset", "laser"), (2, "Length", "1 to 2 s"), (2, "Priority", "must"), (2, "# of variations", "5"),
        (3, "Asset", "UI_Click"), (3, "Length", "at most 1 s"), (3, "Priority", "wish"), (3, "Due", "2026-12-01"),
    }  # fmt: skip
    assert [(column["name"], column["cells"]) for column in read["unread"]] == [("Assignee", 2)]
    laser, click = cues(world)
    assert (laser["stems"][0], laser["duration_s"], laser["need"], laser["loop"]) == ("laser_01", 1.5, "must", True)
    assert (click["stems"], click["due_on"]) == (["UI_Click_01", "UI_Click_02"], "2026-12-01")
    assert (laser["duration_min_s"], laser["duration_max_s"]) == (1, 2)
    assert laser["extra"]["# of variations (as written)"] == "3-5"
    assert {column["name"]: bool(column["why"]) for column in read["columns"]}["Priority"] is True


def test_lengths_in_frames_ask_for_the_rate(world: World) -> None:
    text = "Name,Length (frames)\nhit_a,120\n"
    read = send(world, text, dry_run=True)
    assert (read["rows"][0]["duration_s"], read["unread"][0]["name"]) == (None, "Length (frames)")
    assert "say the frame rate" in read["unread"][0]["why"]
    assert send(world, text, dry_run=True, frame_rate_fps=60)["rows"][0]["duration_s"] == 2
    own = send(world, "Name,Length (frames),fps\nhit_a,120,30\n", dry_run=True)
    assert own["rows"][0]["duration_s"] == 4


def test_an_encoding_is_named_and_can_be_said(world: World) -> None:
    data = "Name,Description\nhit_a,効果音の説明\n".encode("cp932")
    read = send(world, data, dry_run=True)
    assert (read["encoding"]["name"], read["encoding"]["is_guess"]) == ("shift-jis", True)
    assert read["rows"][0]["description"] == "効果音の説明"
    assert send(world, data, dry_run=True, encoding="mac-roman")["rows"][0]["description"] != "効果音の説明"
    assert "wanted utf-8" in refused(world, data, encoding="ebcdic")["detail"]


def test_empty_cells_take_the_value_above_only_when_asked(world: World) -> None:
    text = "Name,Category,Loop\na_one,ui,no\na_two,,no\n"
    assert [row["category"] for row in send(world, text, dry_run=True)["rows"]] == ["ui", ""]
    read = send(world, text, dry_run=True, fill_down_columns=["Category"])
    assert [row["category"] for row in read["rows"]] == ["ui", "ui"]
    assert [(guess["row"], guess["column"], guess["kind"]) for guess in read["guesses"]] == [
        (3, "Category", "filled_down")
    ]


def refused_names(world: World) -> dict[str, Any]:
    answer = world.producer.get(f"/v1/projects/{world.project_id}/sound-list/refused-names")
    assert answer.status_code == 200, answer.text
    read: dict[str, Any] = answer.json()
    return read


@pytest.mark.slow
def test_names_that_the_spec_refuses_are_said_and_renamed(world: World) -> None:
    text = "Name,File name,Category\nButton click,UI_Button_Click,ui\nDoor,door,foley\n"
    read = send(world, text, dry_run=True)
    [name] = read["refused_names"]["names"]
    assert (name["row"], name["stem"], name["proposed"]) == (2, "UI_Button_Click", "ui_button_click")
    assert send(world, text, dry_run=True, use_proposed_names=True)["refused_names"]["names"] == []
    send(world, text)
    assert [cue["refused_name"] and cue["refused_name"]["rule"] for cue in cues(world)] == ["pattern", None]
    [said] = add(world, {"name": "Bell", "file_name": "BELL"})
    assert said["refused_name"]["proposed"] == "bell"
    assert [name["label"] for name in refused_names(world)["names"]] == ["SW-001", "SW-003"]
    url = f"/v1/projects/{world.project_id}/sound-list/refused-names/rename"
    assert world.designer.post(url, json={}).status_code == 403
    assert world.producer.post(url, json={}).json()["names"] == []
    assert [cue["stems"] for cue in cues(world)] == [["ui_button_click"], ["door"], ["bell"]]


@pytest.mark.slow
def test_or_the_pattern_admits_them(world: World) -> None:
    send(world, "Name,File name\nButton click,UI_Button_Click\nDoor,door\n")
    [offer] = refused_names(world)["patterns"]
    assert (offer["category"], offer["names"]) == (None, 1)
    url = f"/v1/projects/{world.project_id}/sound-list/refused-names"
    answer = world.producer.post(f"{url}/admit", json={"category": None})
    assert answer.json() == {"names": [], "patterns": []}
    spec = world.producer.get(f"/v1/projects/{world.project_id}/spec.toml").text
    assert offer["proposed"] in spec
    assert "# ASCII" in spec  # its comments stay
    strict = spec.replace(offer["proposed"], "[a-z]+")
    draft = world.producer.post(f"{url}/draft", json={"toml": strict}).json()
    assert [name["stem"] for name in draft["names"]] == ["UI_Button_Click"]
    assert refused_names(world)["names"] == []
    spec_url = f"/v1/projects/{world.project_id}/spec"
    saved = world.producer.put(spec_url, json={"toml": strict, "based_on_version": 2})
    assert saved.status_code == 200, saved.text
    assert [name["stem"] for name in saved.json()["refused_names"]["names"]] == ["UI_Button_Click"]
    form = {"tables": saved.json()["tables"], "based_on_version": 3}
    answer = world.producer.post(f"{spec_url}/form", json=form)
    assert answer.json()["refused_names"] == saved.json()["refused_names"]


def test_a_wrong_cell_is_repaired_in_place(world: World) -> None:
    text = "Name,Length\nhall_door,soon\nhall_bell,1.5\n"
    read = send(world, text, dry_run=True)
    assert [(fault["row"], fault["column"], fault["text"]) for fault in read["errors"]] == [(2, "Length", "soon")]
    repaired = [{"row": 2, "column": "Length", "text": " 0.4 "}]
    saved = send(world, text, edits=repaired)
    assert (saved["errors"], saved["added"]) == ([], 2)
    assert {cue["name"]: cue["duration_s"] for cue in cues(world)} == {"hall_door": 0.4, "hall_bell": 1.5}


@pytest.mark.parametrize(("row", "column", "words"), [(9, "Length", "no row 9"), (2, "Weight", 'no column "Weight"')])
def test_a_repair_of_a_cell_that_is_not_there_is_refused(world: World, row: int, column: str, words: str) -> None:
    edits = [{"row": row, "column": column, "text": "1"}]
    problem = refused(world, "Name,Length\nhall_door,soon\n", edits=edits)
    assert (problem["code"], words in problem["detail"]) == ("column-unknown", True)


def test_lengths_with_bounds_come_in_and_go_with_a_plain_length(world: World) -> None:
    text = "name,length\nRain,0.5–1 s\nHit,≤ 500 ms\nDoor,about 3 s\nHum,at least 20 s\n"
    assert send(world, text)["errors"] == []
    lengths = ("duration_s", "duration_min_s", "duration_max_s")
    assert {cue["name"]: [cue[length] for length in lengths] for cue in cues(world)} == {
        "Rain": [0.75, 0.5, 1],
        "Hit": [0.5, None, 0.5],
        "Door": [3, None, None],
        "Hum": [20, 20, None],
    }
    assert all(cue["extra"] == {} for cue in cues(world)), "nothing of the cell is left over"
    send(world, "name,length\nRain,2\n", match="name")
    assert [cues(world)[0][length] for length in lengths] == [2, None, None]
    (rain, *_) = cues(world)
    crossed = {"edition": rain["edition"], "duration_min_s": 3, "duration_max_s": 2}
    refused = world.producer.patch(f"/v1/cues/{rain['id']}", json=crossed)
    assert refused.status_code == 422
    assert "wanted the smaller one first" in refused.text


def test_lengths_in_samples_are_read_at_48_khz_and_it_is_said(world: World) -> None:
    text = "name,Length (samples)\nRain,96000\n"
    read = send(world, text, dry_run=True)
    assert (read["rows"][0]["duration_s"], read["columns"][1]["why"]) == (2, "a length in samples at 48,000 Hz")
    assert send(world, text, dry_run=True, sample_rate_hz=96_000)["rows"][0]["duration_s"] == 1
    cell = send(world, "name,length\nRain,24000 samples\n", dry_run=True)
    assert (cell["rows"][0]["duration_s"], cell["guesses"][0]["why"]) == (0.5, "at 48,000 Hz")


def test_a_dry_run_shows_the_sheet_as_it_is_read(world: World) -> None:
    text = "name,category\nUI SOUNDS,\nClick,ui\nHover,\n"
    read = send(world, text, dry_run=True)
    assert read["cells"] == [
        {"row": 2, "cells": ["UI SOUNDS", ""]},
        {"row": 3, "cells": ["Click", "ui"]},
        {"row": 4, "cells": ["Hover", "UI"]},
    ]
    assert [row["row"] for row in read["skipped"]] == [2]
    assert send(world, text)["cells"] == []


def test_several_files_of_a_row_are_its_variations(world: World) -> None:
    read = send(world, 'name,file name\nHit,"hit_01.wav, hit_02.wav"\nMix,"a.wav, b.wav"\n')
    assert [(error["row"], error["column"]) for error in read["errors"]] == [(3, "file name")]
    (hit,) = cues(world)
    assert (hit["stems"], hit["variations"]) == (["hit_01", "hit_02"], 2)


def test_the_title_of_a_section_is_the_category_of_its_rows(world: World) -> None:
    text = "name,category,length\nUI SOUNDS,,\nClick,,0.1\nHover,menu,0.1\nAMBIENCE,,\nRain,,20\nTOTAL,,3\n"
    read = send(world, text, dry_run=True)
    assert {row["name"]: row["category"] for row in read["rows"]} == {
        "Click": "ui",
        "Hover": "menu",
        "Rain": "ambience",
    }
    filled = [(guess["row"], guess["value"]) for guess in read["guesses"] if guess["kind"] == "filled_down"]
    assert filled == [(3, "UI"), (6, "AMBIENCE")]
    plain = send(world, text, dry_run=True, fill_down=False)
    assert [row["category"] for row in plain["rows"]] == ["", "menu", ""]
