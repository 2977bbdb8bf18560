"""What was delivered against the text: stale takes, pick-ups with their reasons, and lengths."""

import csv
import io
import zipfile
from typing import Any

import pytest

from app.projects.models import Engagement, Project
from app.projects.rules import EngagementKind
from tests.support.deliver import deliver, open_delivery
from tests.support.server import World
from tests.support.voice import SHEET, decided, imported, lines, pick_ups, recorded


def change_text(world: World, key: str, text: str, language: str = "en", **more: Any) -> None:
    line = lines(world, language=language)[key]
    body = {"text": text, "text_version": line["text_version"]} | more
    answer = world.producer.put(f"/v1/voice-lines/{line['id']}/texts/{language}", json=body)
    assert answer.status_code == 204, answer.text


@pytest.mark.slow
def test_a_changed_text_makes_its_takes_stale_until_another_comes(world: World) -> None:
    imported(world)
    recorded(world, "en_captain_010.wav", approve=True)
    assert lines(world)["captain_010"]["state"] == "approved"
    change_text(world, "captain_010", "By the light of one sun.")
    line = lines(world)["captain_010"]
    assert (line["state"], line["recorded_text"]) == ("stale", "By the light of a hundred suns.")
    assert line["take"]["state"] == "approved", "the verdict and the money stay with the cue"
    assert line["reason"] == "the text changed; the take says: By the light of a hundred suns."
    assert lines(world, language="de")["captain_010"]["state"] == "no_take", "the other language has not changed"
    of_cue = world.designer.get(f"/v1/cues/{line['cue']['id']}/voice-line").json()
    assert (of_cue["state"], of_cue["text"]) == ("stale", "By the light of one sun.")
    recorded(world, "en_captain_010.wav", 1.05)
    assert lines(world)["captain_010"]["state"] == "in_review"


@pytest.mark.slow
def test_a_text_that_changes_back_has_its_takes_again(world: World) -> None:
    imported(world)
    recorded(world, "en_captain_020.wav", approve=True)
    imported(world, SHEET.replace("Hold the line.", "Hold it."))
    assert lines(world)["captain_020"]["state"] == "stale"
    imported(world)
    assert lines(world)["captain_020"]["state"] == "approved"


@pytest.mark.slow
def test_takes_can_be_said_to_fit(world: World) -> None:
    imported(world)
    recorded(world, "en_captain_020.wav", approve=True)
    change_text(world, "captain_020", "Hold the line!", takes_fit=True)
    assert lines(world)["captain_020"]["state"] == "approved"
    change_text(world, "captain_020", "Hold.")
    assert lines(world)["captain_020"]["state"] == "stale"
    change_text(world, "captain_020", "Hold.", takes_fit=True)
    assert lines(world)["captain_020"]["state"] == "approved"


@pytest.mark.slow
def test_two_people_who_change_a_text_notice_each_other(world: World) -> None:
    imported(world)
    line = lines(world)["captain_020"]
    url = f"/v1/voice-lines/{line['id']}/texts/en"
    assert world.producer.put(url, json={"text": "Hold!", "text_version": 1}).status_code == 204
    refused = world.approver.put(url, json={"text": "Halt!", "text_version": 1})
    assert (refused.status_code, refused.json()["code"]) == (409, "voice-text-changed")
    assert lines(world)["captain_020"]["text"] == "Hold!"
    assert (
        world.producer.put(f"/v1/voice-lines/{line['id']}/texts/fr", json={"text": "x", "text_version": 1}).status_code
        == 404
    )
    assert world.designer.put(url, json={"text": "x", "text_version": 2}).status_code == 403
    assert world.stranger.put(url, json={"text": "x", "text_version": 2}).status_code == 404
    blank = world.producer.put(url, json={"text": "\u200b", "text_version": 2})
    assert (blank.status_code, blank.json()["code"]) == (422, "voice-line-invalid")


@pytest.mark.slow
def test_the_pick_up_list_names_its_reasons(world: World) -> None:
    imported(world)
    assert set(pick_ups(world).values()) == {"no take yet"}
    recorded(world, "en_captain_010.wav", approve=True)
    asked = recorded(world, "en_captain_020.wav", 1.1)
    decided(world, asked, kind="request_change", note="Slower, please.")
    sent = world.approver.post(f"/v1/projects/{world.project_id}/feedback", json={"note": ""})
    assert sent.status_code in (200, 201), sent.text
    recorded(world, "de_captain_010.wav", 1.2, approve=True)
    change_text(world, "captain_010", "Beim Licht einer Sonne.", "de")
    deliver(world, "en_maya_010.wav", b"RIFF no sound at all", delivery_id=open_delivery(world))
    world.server.wait_for_jobs()
    found = pick_ups(world)
    assert found.pop(("en", "maya_010")).startswith("returned by the checks: ")
    assert found == {
        ("en", "captain_020"): "change requested: Slower, please.",
        ("de", "captain_010"): "the text changed; the take says: Beim Licht von hundert Sonnen.",
        ("de", "captain_020"): "no take yet",
        ("de", "maya_010"): "no take yet",
    }
    assert set(pick_ups(world, language="de")) == {key for key in found if key[0] == "de"}
    captain = lines(world)["captain_010"]["character"]["id"]
    assert {key for _, key in pick_ups(world, character=captain)} == {"captain_010", "captain_020"}


@pytest.mark.slow
def test_a_cut_line_is_not_recorded(world: World) -> None:
    imported(world)
    cue = lines(world)["maya_010"]["cue"]["id"]
    assert world.producer.post(f"/v1/cues/{cue}/cut", json={"reason": "The scene is gone."}).status_code in (200, 204)
    assert lines(world)["maya_010"]["state"] == "cut"
    assert ("en", "maya_010") not in pick_ups(world)
    assert ("de", "maya_010") in pick_ups(world)


def test_the_pick_up_list_as_sheets(world: World) -> None:
    imported(world)
    answer = world.designer.get(f"/v1/projects/{world.project_id}/pick-ups.csv", params={"language": "de"})
    rows = list(csv.DictReader(io.StringIO(answer.content.decode("utf-8-sig"))))
    assert [(row["line id"], row["character"], row["reason"], row["file"]) for row in rows] == [
        ("captain_010", "Captain", "no take yet", "de/captain_010"),
        ("captain_020", "Captain", "no take yet", "de/captain_020"),
        ("maya_010", "Maya", "no take yet", "de/maya_010"),
    ]
    assert rows[0]["after"] == "Captain: Hold the line."
    workbook = world.designer.get(f"/v1/projects/{world.project_id}/pick-ups.xlsx").content
    with zipfile.ZipFile(io.BytesIO(workbook)) as book:
        assert b"Beim Licht von hundert Sonnen." in book.read("xl/sharedStrings.xml")
        assert b'orientation="landscape"' in book.read("xl/worksheets/sheet1.xml")


@pytest.mark.slow
def test_a_length_is_held_against_the_originals_approved_take(world: World) -> None:
    imported(world)
    recorded(world, "de_captain_010.wav", 1.2)
    assert lines(world, language="de")["captain_010"]["length_percent"] is None, "no original is approved yet"
    recorded(world, "en_captain_010.wav", 1.0, approve=True)
    german = lines(world, language="de")["captain_010"]
    assert (german["original_duration_s"], german["length_percent"], german["length_is_off"]) == (1.0, 20.0, True)
    assert german["state"] == "in_review", "a length blocks nothing"
    assert lines(world)["captain_010"]["length_percent"] is None, "the original is not held against itself"
    url = f"/v1/projects/{world.project_id}/voice-settings"
    body = {"original_language": "en", "length_tolerance_percent": 25}
    assert world.producer.put(url, json=body).json()["length_tolerance_percent"] == 25
    assert lines(world, language="de")["captain_010"]["length_is_off"] is False
    assert world.designer.put(url, json=body).status_code == 403
    assert world.producer.put(url, json=body | {"original_language": "the moon"}).status_code == 422
    assert world.producer.put(url, json=body | {"length_tolerance_percent": 0}).status_code == 422


@pytest.mark.slow
def test_lines_are_filtered_by_state_character_and_words(world: World) -> None:
    imported(world)
    recorded(world, "en_captain_010.wav", approve=True)
    path = f"/v1/projects/{world.project_id}/voice-lines"
    page = world.producer.get(path).json()
    assert page["counts"] == [{"state": "no_take", "lines": 2}, {"state": "approved", "lines": 1}]
    assert set(lines(world, state="approved")) == {"captain_010"}
    assert set(lines(world, search="STILL maya")) == {"maya_010"}
    assert lines(world, start=3) == {}


def test_scene_and_direction_can_be_changed(world: World) -> None:
    imported(world)
    line = lines(world)["captain_020"]
    answer = world.approver.patch(f"/v1/voice-lines/{line['id']}", json={"direction": " to the crew\n"})
    assert answer.status_code == 204
    changed = lines(world)["captain_020"]
    assert (changed["direction"], changed["scene"]) == ("to the crew", "Bridge")


@pytest.mark.slow
@pytest.mark.both_databases
def test_each_designer_sees_the_takes_of_their_own(world: World) -> None:
    imported(world)
    recorded(world, "en_captain_010.wav", approve=True)
    assert lines(world, world.designer)["captain_010"]["state"] == "approved"
    project = world.server.in_database(lambda session: session.get(Project, world.project_id))
    engagement = Engagement(
        studio_id=project.studio_id,
        project_id=world.project_id,
        designer_id=world.other_designer_id,
        kind=EngagementKind.CONTRACT,
    )
    world.server.in_database(lambda session: session.add(engagement))
    other = lines(world, world.other_designer)["captain_010"]
    assert (other["state"], other["take"]) == ("no_take", None)


@pytest.mark.slow
def test_a_cue_without_a_line(world: World) -> None:
    imported(world)
    answer = world.producer.post(f"/v1/projects/{world.project_id}/cues", json={"cues": [{"name": "Door"}]})
    cue = answer.json()[0]["id"]
    assert world.producer.get(f"/v1/cues/{cue}/voice-line").json() is None
    assert world.stranger.get(f"/v1/cues/{cue}/voice-line").status_code == 404


def test_each_file_of_a_line_is_recorded_and_approved_by_itself(world: World) -> None:
    imported(world, "Line ID,Character,Variations,Text\ngrunt,Guard,2,Hngh!\n")
    assert pick_ups(world) == {("en", "grunt"): "no take yet (grunt_01, grunt_02)"}
    recorded(world, "en/grunt_01.wav", approve=True)
    line = lines(world)["grunt"]
    assert (line["state"], [file["state"] for file in line["files"]]) == ("no_take", ["approved", "no_take"])
    assert pick_ups(world) == {("en", "grunt"): "no take yet (grunt_02)"}
    sheet = world.producer.get(f"/v1/projects/{world.project_id}/pick-ups.csv").text
    assert next(csv.DictReader(io.StringIO(sheet.removeprefix("\ufeff"))))["file"] == "en/grunt_02"
    recorded(world, "en/grunt_02.wav", 1.1, approve=True)
    assert lines(world)["grunt"]["state"] == "approved"
    assert pick_ups(world) == {}
