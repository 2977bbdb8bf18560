"""A designer's own page: credit, people and playlists of each project, while they are engaged on it."""

from typing import Any
from uuid import UUID

import pytest
from httpx2 import Client
from sqlalchemy import update
from sqlalchemy.orm import Session

from app.core import clock
from app.projects.models import Engagement, Project
from tests.app.deliveries.test_handoffs import Handed
from tests.app.money.agreed import Agreed, milestone
from tests.app.reviews.making import body_of
from tests.support.server import World


def own(by: Client) -> list[dict[str, Any]]:
    answer = by.get("/v1/me/own-projects")
    assert answer.status_code == 200, answer.text
    return list(answer.json())


@pytest.fixture
def accepted(world: World) -> tuple[World, UUID]:
    """A project with an approved sound under a contract that names credit and reel."""
    agreed = Agreed(world, terms={"credit_line": "Sounds by {designer}", "reel_from": "1 May 2027"})
    cue = agreed.cue()
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000))
    take = agreed.take(cue)
    agreed.approve(take)
    return world, take


def test_credit_people_and_playlists_stand_by_project(accepted: tuple[World, UUID]) -> None:
    world, take = accepted
    body_of(world.designer.put(f"/v1/projects/{world.project_id}/credits/me", json={"name": "Quay Sound"}))
    playlist = {"name": "Trailer", "take_ids": [str(take)]}
    made = world.producer.post(f"/v1/projects/{world.project_id}/playlists", json=playlist)
    assert made.status_code == 201, made.text
    (project,) = own(world.designer)
    assert (project["project_name"], project["studio_name"]) == ("Shield Wing", "Test studio")
    assert (project["credit_name"], project["credit_roles"]) == ("Quay Sound", ["Sound design"])
    assert (project["agreed_line"], project["shown_from"]) == ("Sounds by Sound designer", "1 May 2027")
    assert [(member["person"]["name"], member["role"]) for member in project["people"]] == [
        ("Audio director", "Audio direction")
    ]
    assert [playlist["name"] for playlist in project["playlists"]] == ["Trailer"]


def test_makers_of_a_hand_off_are_among_the_people(world: World) -> None:
    handed = Handed(world)
    assert "A second sound designer" not in str(own(world.designer)), "no designer sees the others as such"
    body_of(handed.name(handed.hand_off().json()))
    assert "A second sound designer" in str(own(world.designer)[0]["people"])
    assert "Sound designer" in [member["person"]["name"] for member in own(handed.second)[0]["people"]]


def test_what_is_over_or_behind_an_nda_is_not_shown(accepted: tuple[World, UUID]) -> None:
    world, _ = accepted
    assert own(world.producer) == own(world.stranger) == []

    def need_nda(session: Session) -> None:
        session.get_one(Project, world.project_id).nda_needed = True

    def end(session: Session) -> None:
        session.get_one(Project, world.project_id).nda_needed = False
        session.execute(update(Engagement).values(ended_at=clock.now()))

    assert len(own(world.designer)) == 1
    world.server.in_database(need_nda)
    assert own(world.designer) == []
    world.server.in_database(end)
    assert own(world.designer) == []
