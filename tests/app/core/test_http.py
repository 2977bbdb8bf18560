"""Answers: idempotent writes, problem details, health, and pages that are not the API's."""

from uuid import uuid4

import sqlalchemy as sa
from fastapi import APIRouter, FastAPI
from fastapi.testclient import TestClient

from app.accounts.models import Membership
from app.accounts.rules import Role
from app.core.web import error_responses
from app.core.web.http import DbSession
from tests.support.server import RunningServer, World


def create_project(world: World, key: str, name: str = "Twin"):
    body = {"studio_id": str(world.studio_id), "name": name, "cue_prefix": "TW", "preset": "48k"}
    return world.producer.post("/v1/projects", json=body, headers={"Idempotency-Key": key})


def test_the_same_key_does_the_work_once_and_answers_alike(world: World):
    key = str(uuid4())
    first, second = create_project(world, key), create_project(world, key)
    assert first.status_code == second.status_code == 201
    assert first.json() == second.json()
    assert second.headers["Idempotent-Replayed"] == "true"
    projects = world.producer.get("/v1/projects").json()
    assert [project["name"] for project in projects["items"]].count("Twin") == 1


def test_a_key_belongs_to_one_request(world: World):
    key = str(uuid4())
    create_project(world, key)
    other = create_project(world, key, name="Another")
    assert (other.status_code, other.json()["code"]) == (409, "idempotency-key-reused")


def test_a_key_belongs_to_one_caller(world: World):
    key = str(uuid4())
    create_project(world, key)
    body = {"studio_id": str(world.studio_id), "name": "Twin", "cue_prefix": "TW", "preset": "48k"}
    assert world.stranger.post("/v1/projects", json=body, headers={"Idempotency-Key": key}).status_code == 404


def test_a_refused_request_may_come_again_fixed(world: World):
    key = str(uuid4())
    refused = create_project(world, key, name="")
    assert refused.status_code == 422
    assert refused.json()["errors"] == [{"where": "name", "message": "this must not be empty"}]
    assert create_project(world, key).status_code == 201


def test_a_refusal_is_a_problem_that_names_every_field(world: World):
    answer = world.producer.post("/v1/projects", json={"name": 3})
    assert answer.headers["content-type"] == "application/problem+json"
    problem = answer.json()
    assert problem["code"] == "invalid-request"
    reported = {error["where"]: error["message"] for error in problem["errors"]}
    assert reported["studio_id"] == "this is required"
    assert "name" in reported
    assert problem["request_id"] == answer.headers["x-request-id"]


def test_what_is_not_there_is_a_problem_too(world: World):
    for path in ("/v1/nothing", f"/v1/projects/{uuid4()}"):
        answer = world.producer.get(path)
        assert answer.status_code == 404
        assert answer.json()["status"] == 404


def test_health(server: RunningServer):
    browser = server.browser()
    assert browser.get("/healthz").json() == {"status": "alive"}
    ready = browser.get("/readyz")
    assert (ready.status_code, ready.json()["worker"]) == (200, "ok")


def test_a_page_cannot_be_framed_and_loads_nothing_from_elsewhere(server: RunningServer):
    headers = server.browser().get("/").headers
    assert "default-src 'self'" in headers["content-security-policy"]
    assert "frame-ancestors 'none'" in headers["content-security-policy"]
    assert headers["x-content-type-options"] == "nosniff"


def test_a_page_address_never_leaves_its_folder(server: RunningServer):
    answer = server.browser().get("/..%2f..%2fpyproject.toml")
    assert "build-system" not in answer.text


def test_a_stranger_does_not_learn_what_is_wrong_with_what_they_sent(world: World):
    assert world.producer.post("/v1/projects", json={"name": 3}).status_code == 422
    answer = world.server.browser().post("/v1/projects", json={"name": 3})
    assert (answer.status_code, answer.json()["code"]) == (401, "not-signed-in")


def test_a_commit_that_fails_has_not_answered_201(server: RunningServer):
    router = APIRouter()

    @router.post("/orphans", status_code=201)
    def add_orphan(session: DbSession) -> dict[str, bool]:
        session.execute(sa.text("PRAGMA defer_foreign_keys=ON"))  # so that the commit fails, and nothing before
        session.add(Membership(studio_id=uuid4(), person_id=uuid4(), roles=[Role.PRODUCER]))
        session.flush()
        return {"added": True}

    app = FastAPI()
    app.state.runtime = server.runtime
    app.include_router(router)
    error_responses.install(app, credential_cookies=())
    with TestClient(app, raise_server_exceptions=False) as client:
        answer = client.post("/orphans")
    assert (answer.status_code, answer.json()["code"]) == (500, "our-fault")
