"""Credits: who worked on a project by role, each named as they say, and without those who want to be left out."""

import csv
import io
from typing import Any

import pytest

from app.dashboards.credits.rules import Credit, csv_of, in_order, text_of
from tests.app.money.agreed import Agreed, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.server import World


@pytest.fixture
def worked(world: World) -> World:
    """A project of which one sound is approved."""
    agreed = Agreed(world, terms={"credit_line": "Sound design by {designer}, for {project}"})
    cue = agreed.cue("radar_ping")
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000))
    agreed.approve(agreed.take(cue))
    return world


def credits_of(world: World) -> str:
    return f"/v1/projects/{world.project_id}/credits"


def read(world: World, by: Any) -> list[tuple[str, str]]:
    """Return role and name of each credit that a person sees."""
    return [(one["role"], one["name"]) for one in body_of(by.get(credits_of(world)))["credits"]]


@pytest.mark.slow
def test_people_are_listed_by_role(worked: World) -> None:
    listed = read(worked, worked.producer)
    assert listed == [
        ("Sound design", "Sound designer"),
        ("Audio direction", "Audio director"),
        ("Production", "Producer"),
    ]
    assert read(worked, worked.reviewer) == listed
    assert read(worked, worked.designer) == [("Sound design", "Sound designer")]
    assert refused(worked.stranger.get(credits_of(worked))) == (404, "project-not-found")


def test_without_an_approved_sound_a_designer_is_not_listed(world: World) -> None:
    assert all(role != "Sound design" for role, _ in read(world, world.producer))


@pytest.mark.slow
def test_each_person_is_named_as_they_say(worked: World) -> None:
    mine = body_of(worked.designer.put(f"{credits_of(worked)}/me", json={"name": "Quay Sound"}))
    assert (mine["my_name"], mine["my_account_name"]) == ("Quay Sound", "Sound designer")
    assert ("Sound design", "Quay Sound") in read(worked, worked.producer)
    body_of(worked.designer.put(f"{credits_of(worked)}/me", json={"name": "", "is_left_out": True}))
    assert read(worked, worked.designer) == []
    seen = body_of(worked.producer.get(credits_of(worked)))
    assert seen["left_out"] == 1
    assert "Sound designer" not in str(seen["credits"])
    assert "Sound design by" not in worked.producer.get(f"{credits_of(worked)}.txt").text


@pytest.mark.slow
def test_a_producer_adds_performers_by_hand(worked: World) -> None:
    body = {"role": "Voice", "name": "=A. Performer"}
    added = worked.producer.post(credits_of(worked), json=body)
    assert added.status_code == 201, added.text
    line = added.json()["credits"][-1]
    assert (line["role"], line["person_id"]) == ("Voice", None)
    table = list(csv.reader(io.StringIO(worked.producer.get(f"{credits_of(worked)}.csv").text)))
    assert table[0] == ["role", "name", "agreed_line"]
    assert table[-1] == ["Voice", "'=A. Performer", ""]
    address = f"/v1/credit-lines/{line['line_id']}"
    assert refused(worked.reviewer.post(credits_of(worked), json=body)) == (403, "producer-needed")
    assert refused(worked.reviewer.delete(address)) == (403, "producer-needed")
    assert refused(worked.designer.delete(address)) == (404, "credit-line-not-found")
    assert refused(worked.stranger.delete(address)) == (404, "credit-line-not-found")
    assert worked.producer.delete(address).status_code == 204
    assert ("Voice", "=A. Performer") not in read(worked, worked.producer)


@pytest.mark.slow
def test_the_text_has_the_lines_of_contracts_to_the_letter(worked: World) -> None:
    project = body_of(worked.producer.get(f"/v1/projects/{worked.project_id}"))["name"]
    text = worked.producer.get(f"{credits_of(worked)}.txt").text
    assert text.startswith("Sound design\nSound designer\n\nAudio direction\n")
    assert text.endswith(f"Lines agreed in contracts\nSound design by Sound designer, for {project}\n")
    assert refused(worked.designer.get(f"{credits_of(worked)}.txt")) == (403, "team-needed")


def test_roles_by_hand_come_last_and_names_in_order() -> None:
    listed = [Credit("Voice", "B"), Credit("Production", "C"), Credit("Foley", "a"), Credit("Sound design", "é")]
    assert [one.role for one in in_order([*listed, Credit("Sound design", "D")])] == [
        *("Sound design", "Sound design", "Production", "Foley", "Voice")
    ]
    assert text_of([]) == ""
    assert csv_of([]) == "role,name,agreed_line\r\n"
