"""A saved answer is repeated for a while to the caller who may still ask for it, and to no one else."""

from datetime import timedelta
from uuid import uuid4

import pytest
import sqlalchemy as sa
from httpx2 import Client
from sqlalchemy.orm import Session

from app.accounts.models import Membership, SignIn, Token
from app.accounts.rules import Role, Scope
from app.core import clock
from app.core.web import idempotency
from app.core.web.idempotency import SavedResponse, delete_expired_responses
from app.projects.models import Engagement
from tests.support.deliver import open_delivery
from tests.support.server import World


def create_project(client: Client, world: World, key: str) -> tuple[int, str]:
    body = {"studio_id": str(world.studio_id), "name": "Secret", "cue_prefix": "SE", "preset": "48k"}
    answer = client.post("/v1/projects", json=body, headers={"Idempotency-Key": key})
    return answer.status_code, answer.json().get("code", answer.headers.get("idempotent-replayed", "new"))


@pytest.fixture
def key() -> str:
    return str(uuid4())


def test_those_who_signed_out_are_asked_to_sign_in(world: World, key: str):
    client = world.signed_in(world.producer_id)
    assert create_project(client, world, key) == (201, "new")
    assert create_project(client, world, key) == (201, "true")
    end = sa.update(SignIn).where(SignIn.person_id == world.producer_id)
    world.server.in_database(lambda session: session.execute(end.values(expires_at=clock.now() - timedelta(days=1))))
    assert create_project(client, world, key) == (401, "not-signed-in")


def test_who_left_the_studio_sees_nothing_there(world: World, key: str):
    assert create_project(world.producer, world, key) == (201, "new")
    left = sa.delete(Membership).where(Membership.person_id == world.producer_id)
    world.server.in_database(lambda session: session.execute(left))
    assert create_project(world.producer, world, key) == (404, "no-longer-exists")


def test_who_lost_a_role_may_not_ask_again(world: World, key: str):
    assert create_project(world.producer, world, key) == (201, "new")

    def demote(session: Session) -> None:
        session.get_one(Membership, (world.studio_id, world.producer_id)).roles = [Role.REVIEWER]

    world.server.in_database(demote)
    assert create_project(world.producer, world, key) == (403, "no-longer-allowed")


def test_who_was_given_more_still_may(world: World, key: str):
    assert create_project(world.producer, world, key) == (201, "new")

    def promote(session: Session) -> None:
        session.get_one(Membership, (world.studio_id, world.producer_id)).roles = [Role.PRODUCER, Role.LIAISON]

    world.server.in_database(promote)
    assert create_project(world.producer, world, key) == (201, "true")


def test_whose_engagement_ended_sees_nothing_there(world: World, key: str):
    path = f"/v1/deliveries/{open_delivery(world)}/close"
    first = world.designer.post(path, headers={"Idempotency-Key": key})
    assert first.status_code == 200, first.text
    assert world.designer.post(path, headers={"Idempotency-Key": key}).headers["idempotent-replayed"] == "true"
    ended = sa.update(Engagement).where(Engagement.designer_id == world.designer_id).values(ended_at=clock.now())
    world.server.in_database(lambda session: session.execute(ended))
    again = world.designer.post(path, headers={"Idempotency-Key": key})
    assert (again.status_code, again.json()["code"]) == (404, "no-longer-exists")


def test_a_revoked_token_learns_nothing(world: World, key: str):
    path = f"/v1/projects/{world.project_id}/tokens"
    made = world.producer.post(path, json={"name": "CI", "scopes": [Scope.CHECKS_WRITE]}).json()
    client = world.server.browser()
    client.headers["Authorization"] = f"Bearer {made['secret']}"
    report = {"schema_version": 1, "tool": {"name": "x", "version": "1"}, "spec": None, "files": [], "summary": {}}
    body = {"label": "1", "report": report}
    builds = f"/v1/projects/{world.project_id}/builds"
    assert client.post(builds, json=body, headers={"Idempotency-Key": key}).status_code == 201
    assert client.post(builds, json=body, headers={"Idempotency-Key": key}).headers["idempotent-replayed"] == "true"
    revoke = sa.update(Token).where(Token.project_id == world.project_id).values(revoked_at=clock.now())
    world.server.in_database(lambda session: session.execute(revoke))
    assert client.post(builds, json=body, headers={"Idempotency-Key": key}).status_code == 401


def test_a_long_answer_is_not_kept(world: World, key: str, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(idempotency, "MAX_SAVED_BYTES", 10)
    assert create_project(world.producer, world, key) == (201, "new")
    assert create_project(world.producer, world, key) == (409, "already-processed")


def test_old_answers_are_forgotten(world: World):
    def add(session: Session) -> None:
        for age in (timedelta(days=1), timedelta(days=3)):
            saved = SavedResponse(key=f"{age.days} {world.studio_id}", request_sha256="", created_at=clock.now() - age)
            session.add(saved)

    world.server.in_database(add)
    delete_expired_responses(world.server.runtime.database)
    of_this = sa.select(SavedResponse.key).where(SavedResponse.key.endswith(str(world.studio_id)))
    assert world.server.in_database(lambda session: list(session.scalars(of_this))) == [f"1 {world.studio_id}"]
