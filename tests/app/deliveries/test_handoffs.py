"""A cue goes from one maker to the next: what is done, what is missing, the versions and their source banks."""

import json
from typing import Any
from uuid import UUID

import pytest
from httpx2 import Client
from sqlalchemy.orm import Session

from app.agreements.queries import events_of
from app.projects.models import Engagement
from app.projects.rules import EngagementKind
from tests.app.deliveries.test_source_banks import RECIPE, SESSION, give
from tests.app.money.agreed import Agreed, milestone
from tests.app.reviews.making import Stage, body_of, refused
from tests.support.deliver import deliver, open_delivery
from tests.support.server import World

UNFINISHED = {"done_percent": 75, "missing": "The tail, and a duller clank."}
FILE = b"RIFF, three quarters of a laser"


class Handed(Stage):
    """A cue with one file of its maker, and a second designer of the project."""

    def __init__(self, world: World) -> None:
        super().__init__(world)
        self.cue_id = self.cue("laser")
        self.take_id = UUID(
            deliver(world, "laser.wav", FILE, delivery_id=open_delivery(world), cue_id=str(self.cue_id))["id"]
        )
        self.second_id, self.second = second_designer(world)
        self.path = f"/v1/cues/{self.cue_id}/handoffs"

    def hand_off(self, by: Client | None = None, **more: Any) -> Any:
        return (by or self.world.designer).post(self.path, json=UNFINISHED | more)

    def name(self, handoff: dict[str, Any], by: Client | None = None, to: UUID | None = None) -> Any:
        body = {"designer_id": str(to or self.second_id)}
        return (by or self.world.producer).put(f"/v1/handoffs/{handoff['id']}/next-maker", json=body)


def second_designer(world: World) -> tuple[UUID, Client]:
    """Engage a second designer on the project."""

    def engage(session: Session) -> UUID:
        person_id: UUID = world._person(session, "A second sound designer")
        of = {"studio_id": world.studio_id, "project_id": world.project_id}
        session.add(Engagement(**of, designer_id=person_id, kind=EngagementKind.CONTRACT))
        return person_id

    person_id = world.server.in_database(engage)
    return person_id, world.signed_in(person_id)


@pytest.fixture
def handed(world: World) -> Handed:
    return Handed(world)


def test_the_next_maker_sees_what_is_missing_the_versions_and_the_source_bank(handed: Handed) -> None:
    world, second = handed.world, handed.second
    file = give(world, handed.take_id)
    made = handed.hand_off()
    assert made.status_code == 201, made.text
    handoff = made.json()
    assert (handoff["maker"]["name"], handoff["next_maker"]) == ("Sound designer", None)
    assert body_of_list(second.get(handed.path)) == [], "nobody continues it yet"
    body_of(handed.name(handoff))
    (seen,) = body_of_list(second.get(handed.path))
    assert (seen["done_percent"], seen["missing"]) == (75, UNFINISHED["missing"])
    assert seen["created_at"] is not None
    (version,) = seen["takes"]
    assert (version["file_name"], version["number"]) == ("laser.wav", 1)
    assert [file["file_name"] for file in version["source_files"]] == ["laser.rpp"]
    at = f"/v1/handoffs/{handoff['id']}"
    assert second.get(f"{at}/takes/{handed.take_id}/master").content == FILE
    assert second.get(f"{at}/source-files/{file['id']}").content == SESSION
    assert second.get(f"/v1/takes/{handed.take_id}").status_code == 404, "the hand-off shows no more than itself"


def body_of_list(answer: Any) -> list[dict[str, Any]]:
    assert answer.status_code == 200, answer.text
    return list(answer.json())


def test_whom_it_is_not_for_sees_none_of_it(handed: Handed) -> None:
    handoff = handed.hand_off().json()
    at = f"/v1/handoffs/{handoff['id']}/takes/{handed.take_id}/master"
    for by in (handed.second, handed.world.stranger):
        assert refused(by.get(at)) == (404, "handoff-not-found")
    assert refused(handed.name(handoff, by=handed.second))[0] == 404
    assert refused(handed.name(handoff, by=handed.world.designer)) == (403, "producer-needed")
    body_of(handed.name(handoff))
    _, third = second_designer(handed.world)
    assert refused(third.get(at)) == (404, "handoff-not-found")


def test_only_another_designer_of_the_project_continues_it(handed: Handed) -> None:
    handoff = handed.hand_off().json()
    for person in (handed.world.designer_id, handed.world.stranger_id, handed.world.reviewer_id):
        assert refused(handed.name(handoff, to=person)) == (422, "next-maker-unknown")


def test_a_producer_hands_off_for_a_maker_without_the_source_bank(handed: Handed) -> None:
    world = handed.world
    file = give(world, handed.take_id)
    assert refused(handed.hand_off(world.reviewer, from_id=str(world.designer_id))) == (403, "producer-needed")
    handoff = handed.hand_off(world.producer, from_id=str(world.designer_id)).json()
    body_of(handed.name(handoff))
    (seen,) = body_of_list(handed.second.get(handed.path))
    assert [version["source_files"] for version in seen["takes"]] == [[]], "the maker did not give it"
    asked = handed.second.get(f"/v1/handoffs/{handoff['id']}/source-files/{file['id']}")
    assert refused(asked) == (404, "source-file-not-found")


@pytest.mark.slow
def test_a_longer_list_costs_no_more_statements(handed: Handed) -> None:
    world, cue_id = handed.world, handed.cue("door", variations=4)
    path = f"/v1/cues/{cue_id}/handoffs"

    def hand_off_with_a_take(variation: int) -> None:
        take_id = handed.take(cue_id, variation)
        handed.approve(take_id)
        give(world, take_id)
        body_of(world.designer.put(f"/v1/takes/{take_id}/source-bank", json=RECIPE))
        made = world.designer.post(path, json=UNFINISHED)
        assert made.status_code == 201, made.text
        body_of(handed.name(made.json()))

    def statements() -> int:
        with world.server.counted_selects() as selects:
            body_of_list(world.producer.get(path))
        assert any("deliveries_source_files" in text for text in selects)
        return len(selects)

    hand_off_with_a_take(1)
    for_one = statements()
    for variation in (2, 3, 4):
        hand_off_with_a_take(variation)
    assert [len(handoff["takes"]) for handoff in body_of_list(world.producer.get(path))] == [4, 4, 4, 4]
    assert statements() == for_one


def test_who_made_nothing_hands_off_nothing(handed: Handed) -> None:
    assert refused(handed.hand_off(handed.second)) == (409, "nothing-to-hand-off")


def test_the_record_says_who_made_what_and_unpaid_files_stay_closed(world: World) -> None:
    agreed = Agreed(world, terms={"downloads_open": "when_paid"})
    cue = agreed.cue()
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000))
    take = agreed.take(cue)
    second_id, second = second_designer(world)
    made = world.designer.post(f"/v1/cues/{cue}/handoffs", json=UNFINISHED)
    assert made.status_code == 201, made.text
    body = {"designer_id": str(second_id)}
    body_of(world.producer.put(f"/v1/handoffs/{made.json()['id']}/next-maker", json=body))

    def read(session: Session) -> dict[str, dict[str, Any]]:
        return {event.kind: json.loads(event.payload) for event in events_of(session, agreed.contract_id)}

    recorded = world.server.in_database(read)
    assert (recorded["handed_off"]["done_percent"], recorded["handed_off"]["missing"]) == (75, UNFINISHED["missing"])
    assert recorded["continued_by"]["by_maker"] == "A second sound designer"
    asked = second.get(f"/v1/handoffs/{made.json()['id']}/takes/{take}/master")
    assert refused(asked) == (403, "download-unpaid")
