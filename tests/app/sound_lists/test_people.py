"""Who puts a cue into the game and who records it: set, imported, exported, shown to those who may know, and due."""

import csv
import io
from typing import Any

import pytest

from app.core.db import new_id
from app.sound_lists.people.rules import KnownPeople, ProjectPerson
from tests.app.sound_lists.lists import add, the_list
from tests.app.sound_lists.test_imports import send
from tests.support.deliver import checked, deliver
from tests.support.server import World
from tests.support.waves import noise, wav_bytes

GOOD = wav_bytes(noise(dbfs=-20, seconds=0.2))


def people(world: World, by: str = "producer") -> dict[str, Any]:
    answer = getattr(world, by).get(f"/v1/projects/{world.project_id}/cue-people")
    assert answer.status_code == 200, answer.text
    return {person["name"]: person for person in answer.json()}


def step_kinds(world: World, by: str) -> dict[str, int]:
    steps = getattr(world, by).get(f"/v1/projects/{world.project_id}/next-steps").json()["steps"]
    return {step["kind"]: step["count"] for step in steps}


def test_members_and_designers_can_be_chosen_and_no_one_else(world: World) -> None:
    known = people(world)
    assert {name: one["is_designer"] for name, one in known.items()} == {
        "Audio director": False,
        "Composer": False,
        "Producer": False,
        "Sound designer": True,
    }
    (door,) = add(world, {"name": "Door", "implementer_id": known["Composer"]["id"]})
    assert door["implementer_id"] == known["Composer"]["id"]
    for stranger in (world.stranger_id, world.other_designer_id, new_id()):
        body = {"edition": 1, "recorder_id": str(stranger)}
        refused = world.producer.patch(f"/v1/cues/{door['id']}", json=body)
        assert refused.status_code == 422
        assert refused.json()["errors"][0]["where"] == "recorder_id"


def test_a_designer_learns_of_no_one_but_themselves(world: World) -> None:
    me = str(world.designer_id)
    add(
        world,
        {"name": "Door", "implementer_id": str(world.reviewer_id), "recorder_id": me},
        {"name": "Gate", "recorder_id": str(world.reviewer_id)},
    )
    assert list(people(world, "designer")) == ["Sound designer"]
    cues = world.designer.get(f"/v1/projects/{world.project_id}/sound-list").json()["cues"]
    assert [(cue["implementer_id"], cue["recorder_id"]) for cue in cues] == [(None, me), (None, None)]
    assert world.designer.get(f"/v1/cues/{cues[0]['id']}").json()["implementer_id"] is None
    exported = world.designer.get(f"/v1/projects/{world.project_id}/sound-list.csv").text
    assert "Composer" not in exported
    assert "Sound designer" in exported
    compared = world.designer.get(f"/v1/projects/{world.project_id}/sound-list/revisions/compare?from=0&to=1").json()
    assert "Composer" not in str(compared)
    assert str(world.reviewer_id) not in str(compared)


@pytest.mark.slow
def test_a_sheet_names_them_by_name_or_address(world: World) -> None:
    add(world, {"name": "Door"}, {"name": "Gate"})
    address = f"{world.designer_id}@example.test"
    sheet = f"number,Implemented by,Recorded by\n1,composer,{address.upper()}\n2,,sound designer\n"
    assert send(world, sheet)["changed"] == 2
    cues = the_list(world)["cues"]
    assert [(cue["implementer_id"], cue["recorder_id"]) for cue in cues] == [
        (str(world.reviewer_id), str(world.designer_id)),
        (None, str(world.designer_id)),
    ]
    exported = world.producer.get(f"/v1/projects/{world.project_id}/sound-list.csv").text
    rows = list(csv.DictReader(io.StringIO(exported)))
    assert [(row["implementer"], row["recorder"]) for row in rows] == [
        ("Composer", "Sound designer"),
        ("", "Sound designer"),
    ]
    assert send(world, exported)["same"] == 2
    (fault,) = send(world, "number,implementer\n1,Nobody Known\n")["errors"]
    assert 'found "Nobody Known"' in fault["message"]
    assert send(world, "number,implementer\n1,\n")["changed"] == 1
    assert the_list(world)["cues"][0]["implementer_id"] is None


def test_a_revision_names_them_in_words(world: World) -> None:
    (door,) = add(world, {"name": "Door"})
    body = {"edition": 1, "implementer_id": str(world.reviewer_id)}
    assert world.producer.patch(f"/v1/cues/{door['id']}", json=body).status_code == 200
    compared = world.producer.get(f"/v1/projects/{world.project_id}/sound-list/revisions/compare?from=1&to=2").json()
    assert compared["changed"][0]["changes"] == [{"field": "implementer_id", "before": None, "after": "Composer"}]


@pytest.mark.slow
def test_an_accepted_cue_waits_for_its_implementer_until_it_is_in_the_build(world: World) -> None:
    (door,) = add(world, {"name": "Door", "implementer_id": str(world.reviewer_id)})
    assert "implement" not in step_kinds(world, "reviewer")
    take = deliver(world, "Door.wav", GOOD)
    checked(world, take["id"])
    approved = world.approver.post(f"/v1/takes/{take['id']}/verdict", json={"kind": "approve"})
    assert approved.status_code in (200, 201), approved.text
    assert step_kinds(world, "reviewer")["implement"] == 1
    assert "implement" not in step_kinds(world, "producer")
    marked = world.producer.put(f"/v1/cues/{door['id']}/game-state", json={"mark": "in-build", "is_set": True})
    assert marked.status_code == 200, marked.text
    assert "implement" not in step_kinds(world, "reviewer")


@pytest.mark.slow
def test_a_cue_waits_for_the_person_who_records_it_until_a_take_comes(world: World) -> None:
    add(world, {"name": "Door", "recorder_id": str(world.designer_id)}, {"name": "Gate"})
    assert step_kinds(world, "designer")["record"] == 1
    deliver(world, "Door.wav", GOOD)
    assert "record" not in step_kinds(world, "designer")


PEOPLE = [
    ProjectPerson(new_id(), "Ada", "ada@example.test", is_designer=False),
    ProjectPerson(new_id(), "Kim", "kim@example.test", is_designer=True),
    ProjectPerson(new_id(), "KIM", "kim@example.com", is_designer=False),
    ProjectPerson(new_id(), "N/A", "na@example.test", is_designer=False),
]


def test_two_people_of_one_name_are_written_by_address() -> None:
    known = KnownPeople(PEOPLE)
    texts = [known.text_of(person.id) for person in PEOPLE]
    assert texts == ["Ada", "kim@example.test", "kim@example.com", "na@example.test"]
    assert [known.id_of(text) for text in texts] == [person.id for person in PEOPLE]
    assert known.text_of(new_id()) == known.text_of(None) == ""
    assert known.id_of(" – ") is None
    with pytest.raises(ValueError, match="2 people are called"):
        known.id_of("kim")
