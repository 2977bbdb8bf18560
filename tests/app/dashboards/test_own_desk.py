"""What a designer owes in all projects: what is due soonest first, with what was said last."""

from datetime import date
from uuid import UUID

import pytest
import sqlalchemy as sa

from app.accounts.models import DeskToken
from app.core import clock
from app.dashboards.desk import own_desk
from app.deliveries.rules import TakeState
from app.projects.models import Engagement
from app.projects.rules import EngagementKind
from app.sound_lists.models import Cue
from tests.app.reviews.making import Stage
from tests.support.server import World


def set_due(world: World, cue_id: object, day: date) -> None:
    due = sa.update(Cue).where(Cue.id == UUID(str(cue_id))).values(due_on=day)
    world.server.in_database(lambda session: session.execute(due))


def names(world: World, **query: str) -> list[str]:
    return [one["cue"]["name"] for one in world.designer.get("/v1/me/desk", params=query).json()["items"]]


def test_it_lists_what_waits_for_the_designer_by_day(world: World):
    stage = Stage(world)
    late, sent, accepted = stage.cue("late"), stage.cue("sent"), stage.cue("accepted")
    back, new = stage.cue("back"), stage.cue("new")
    for cue_id, state in (
        (sent, TakeState.CONFORMING),
        (accepted, TakeState.APPROVED),
        (back, TakeState.CHANGE_REQUESTED),
    ):
        stage.take(cue_id, state=state)
    set_due(world, new, date(2026, 12, 1))
    set_due(world, late, date(2026, 11, 1))
    answer = world.designer.get("/v1/me/desk").json()
    found = [(one["cue"]["name"], one["status"], one["due_on"]) for one in answer["items"]]
    assert found == [
        ("late", "to_make", "2026-11-01"),
        ("new", "to_make", "2026-12-01"),
        ("back", "change_requested", None),
    ]
    assert {(one["project_name"], one["studio_name"]) for one in answer["items"]} == {("Shield Wing", "Test studio")}
    assert (answer["person"]["name"], answer["projects"], answer["next"]) == ("Sound designer", 1, None)


def test_what_was_said_last_is_named_with_who_said_it(world: World):
    stage = Stage(world)
    cue_id = stage.cue("laser")
    take_id = stage.take(cue_id, state=TakeState.CHANGE_REQUESTED)
    for text in ("Too long.", "Shorter, please."):
        said = world.reviewer.post(f"/v1/takes/{take_id}/comments", json={"text": text})
        assert said.status_code == 201, said.text
    (one,) = world.designer.get("/v1/me/desk").json()["items"]
    assert (one["latest_comment"]["text"], one["latest_comment"]["by"]) == ("Shorter, please.", "Composer")


def test_pages_hold_each_cue_once(world: World, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(own_desk, "CUES", 2)
    stage = Stage(world)
    for place in range(4):
        cue_id = stage.cue(f"sound_{place}")
        if place > 1:
            set_due(world, cue_id, date(2026, 12, place))
    found, query = [], {}
    while True:
        answer = world.designer.get("/v1/me/desk", params=query).json()
        assert answer["items"], "a page is empty"
        found += [one["cue"]["name"] for one in answer["items"]]
        if answer["next"] is None:
            break
        query = {"cursor": answer["next"]}
    assert found == ["sound_2", "sound_3", "sound_0", "sound_1"]
    assert world.designer.get("/v1/me/desk", params={"cursor": "soon"}).json()["code"] == "bad-cursor"


def test_only_running_engagements_count_and_the_team_owes_nothing(world: World):
    Stage(world).cue("laser")
    assert names(world) == ["laser"]
    assert world.producer.get("/v1/me/desk").json()["items"] == []
    assert world.other_designer.get("/v1/me/desk").json()["projects"] == 0
    ended = sa.update(Engagement).where(Engagement.designer_id == world.designer_id).values(ended_at=clock.now())
    world.server.in_database(lambda session: session.execute(ended))
    assert names(world) == []


def test_another_designers_takes_and_words_do_not_show(world: World):
    stage = Stage(world)
    cue_id = stage.cue("laser")
    stage.take(cue_id, state=TakeState.CHANGE_REQUESTED)
    engagement = Engagement(
        studio_id=world.studio_id,
        project_id=world.project_id,
        designer_id=world.other_designer_id,
        kind=EngagementKind.CONTRACT,
    )
    world.server.in_database(lambda session: session.add(engagement))
    (one,) = world.other_designer.get("/v1/me/desk").json()["items"]
    assert (one["status"], one["latest_comment"]) == ("to_make", None)


def make_token(world: World) -> tuple[str, str]:
    made = world.designer.post("/v1/me/desk-tokens", json={"name": "Laptop"})
    assert made.status_code == 201, made.text
    return made.json()["id"], made.json()["secret"]


def ask_with(world: World, secret: str) -> int:
    return world.nobody.get("/v1/me/desk", headers={"Authorization": f"Bearer {secret}"}).status_code


def test_a_token_reads_the_desk_until_it_is_revoked(world: World):
    token_id, secret = make_token(world)
    assert (ask_with(world, secret), ask_with(world, secret + "x")) == (200, 401)
    (listed,) = world.designer.get("/v1/me/desk-tokens").json()
    assert (listed["name"], "secret" in listed, listed["last_used_at"] is None) == ("Laptop", False, False)
    assert world.producer.delete(f"/v1/me/desk-tokens/{token_id}").status_code == 404
    assert world.designer.delete(f"/v1/me/desk-tokens/{token_id}").status_code == 204
    assert ask_with(world, secret) == 401


def test_a_token_ends_after_a_year_and_is_kept_as_a_hash(world: World):
    token_id, secret = make_token(world)
    row = world.server.in_database(lambda session: session.get_one(DeskToken, UUID(token_id)).secret_sha256)
    assert secret not in row
    over = sa.update(DeskToken).where(DeskToken.id == UUID(token_id)).values(expires_at=clock.now())
    world.server.in_database(lambda session: session.execute(over))
    assert ask_with(world, secret) == 401


@pytest.mark.slow
def test_a_person_has_twenty_tokens_at_most(world: World):
    for _ in range(20):
        make_token(world)
    refused = world.designer.post("/v1/me/desk-tokens", json={"name": "One more"})
    assert (refused.status_code, refused.json()["code"]) == (409, "too-many-desk-tokens")
