"""The list of what a designer may hear of the others, and the setting that decides it."""

from typing import Any
from uuid import UUID

import pytest
from httpx2 import Client
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.core import clock
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.projects.models import Engagement, Project
from app.projects.rules import EngagementKind
from app.renders.models import Picture
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState
from tests.app.reviews.making import Stage
from tests.support.server import World


@pytest.fixture
def stage(world: World) -> Stage:
    def engage(session: Session) -> None:
        of = {"studio_id": world.studio_id, "project_id": world.project_id}
        session.add(Engagement(**of, designer_id=world.other_designer_id, kind=EngagementKind.CONTRACT))

    world.server.in_database(engage)
    return Stage(world)


def sounds(stage: Stage, client: Client | None = None, **params: Any) -> list[dict[str, Any]]:
    answer = (client or stage.world.other_designer).get(
        f"/v1/projects/{stage.world.project_id}/other-sounds", params=params
    )
    assert answer.status_code == 200, answer.text
    items: list[dict[str, Any]] = answer.json()["items"]
    return items


def set_heard(stage: Stage, choice: str) -> None:
    answer = stage.world.producer.patch(f"/v1/projects/{stage.world.project_id}", json={"designers_hear": choice})
    assert (answer.status_code, answer.json()["designers_hear"]) == (200, choice)


def picture_of(stage: Stage, take_id: UUID) -> str:
    def read(session: Session) -> UUID:
        of_take = select(Picture.id).join(Take, Take.master_sha256 == Picture.sound_sha256)
        return session.scalars(of_take.where(Take.id == take_id)).one()

    return f"/v1/sounds/{stage.world.server.in_database(read)}/preview"


@pytest.mark.slow
def test_approved_sounds_are_opened_unless_the_studio_says_otherwise(stage: Stage) -> None:
    palette = stage.take(stage.cue("tone", palette=True, category="ui"), state=TakeState.APPROVED)
    plain = stage.take(stage.cue("bang", variations=2), 2, state=TakeState.APPROVED)
    waiting = stage.take(stage.cue("clank"))
    assert [sound["id"] for sound in sounds(stage)] == [str(plain), str(palette)]
    assert [sound["id"] for sound in sounds(stage, palette=True)] == [str(palette)]
    first = sounds(stage)[0]
    assert (first["cue"]["name"], first["variation"], first["variations"], first["is_approved"]) == ("bang", 2, 2, True)
    assert not {"file_name", "designer", "designer_id"} & first.keys()
    set_heard(stage, "waiting")
    assert [(sound["id"], sound["is_approved"]) for sound in sounds(stage)[:1]] == [(str(waiting), False)]
    set_heard(stage, "own")
    assert sounds(stage) == []


def test_ones_own_sounds_are_not_among_them(stage: Stage) -> None:
    stage.take(stage.cue("bang"), state=TakeState.APPROVED)
    assert sounds(stage, stage.world.designer) == []


def test_cut_cues_and_discarded_takes_stay_closed(stage: Stage) -> None:
    cut, discarded = stage.cue("cut"), stage.cue("discarded")
    of_cut = stage.take(cut, state=TakeState.APPROVED)
    thrown = stage.take(discarded, state=TakeState.APPROVED)

    def write(session: Session) -> None:
        cue = session.get_one(Cue, cut)
        cue.cut_at, cue.state = clock.now(), CueState.CUT
        session.get_one(Take, thrown).discarded_at = clock.now()

    stage.world.server.in_database(write)
    assert sounds(stage) == []
    for take_id in (of_cut, thrown):
        assert stage.world.other_designer.get(picture_of(stage, take_id)).status_code == 404


def test_an_nda_and_the_end_of_an_engagement_close_them(stage: Stage) -> None:
    preview = picture_of(stage, stage.take(stage.cue("bang"), state=TakeState.APPROVED))
    assert stage.world.other_designer.get(preview).json()["code"] == "not-drawn"  # in sight: its row has no file
    world = stage.world
    world.server.in_database(lambda session: setattr(session.get_one(Project, world.project_id), "nda_needed", True))
    assert world.other_designer.get(preview).status_code == 404

    def end(session: Session) -> None:
        session.get_one(Project, world.project_id).nda_needed = False
        mine = select(Engagement).where(Engagement.designer_id == world.other_designer_id)
        session.scalars(mine).one().ended_at = clock.now()

    world.server.in_database(end)
    assert world.other_designer.get(preview).status_code == 404
    assert world.other_designer.get(f"/v1/projects/{world.project_id}/other-sounds").status_code == 404


def test_only_producers_set_it_and_only_designers_ask(stage: Stage) -> None:
    world, address = stage.world, f"/v1/projects/{stage.world.project_id}"
    for client in (world.reviewer, world.approver, world.designer):
        assert client.patch(address, json={"designers_hear": "waiting"}).status_code == 403
    assert world.producer.patch(address, json={"designers_hear": "everything"}).status_code == 422
    assert world.producer.get(f"{address}/other-sounds").status_code == 403
