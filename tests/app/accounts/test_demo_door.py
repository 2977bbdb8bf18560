"""The demo needs no sign-in, from this machine, to this machine, directly; every other way meets 401."""

import dataclasses
from collections.abc import Callable, Iterator
from uuid import UUID

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient
from sqlalchemy import delete, update

from app.accounts.models import Membership, Person
from app.accounts.people import create_person
from app.accounts.rules import Role
from app.accounts.service import add_member, create_studio
from app.core.db import new_id
from app.main import create_app
from tests.support.server import RunningServer, World

Visitor = Callable[..., TestClient]


@pytest.fixture(scope="module")
def demo_application(server: RunningServer) -> Iterator[FastAPI]:
    """The same server as `soundlist demo` runs it, with a studio and its people."""
    demo_settings = server.runtime.settings.model_copy(update={"demo": True})
    with server.runtime.database.writing() as session:
        people = {
            part: create_person(session, email=f"{part}-{new_id()}@demo.example", name=part, demo_part=part)
            for part in ("producer", "approver", "designer")
        }
        studio = create_studio(session, "Demo studio", people["producer"], is_demo=True)
        add_member(session, studio.id, people["approver"].id, [Role.LIAISON])
    yield create_app(dataclasses.replace(server.runtime, settings=demo_settings))
    with server.runtime.database.writing() as session:
        session.execute(update(Person).where(Person.demo_part.is_not(None)).values(demo_part=None))


@pytest.fixture
def visitor(demo_application: FastAPI) -> Visitor:
    """Make a browser that comes from a place, to a host."""

    def credentials(*, host: str = "127.0.0.1:8000", client: str = "127.0.0.1", **headers: str) -> TestClient:
        browser = TestClient(
            demo_application,
            base_url="http://127.0.0.1:8000",
            client=(client, 50_000),
            headers={"Host": host} | {name.replace("_", "-"): value for name, value in headers.items()},
        )
        browser.cookies.clear()
        return browser

    return credentials


def name_of(browser: TestClient) -> str:
    return str(browser.get("/v1/me").json()["person"]["name"])


@pytest.mark.parametrize("host", ["127.0.0.1:8000", "localhost:8000", "LOCALHOST", "[::1]:8000", "[::1]", "127.0.0.1"])
def test_the_own_machine_is_let_in(visitor: Visitor, host: str) -> None:
    assert name_of(visitor(host=host)) == "approver"
    assert name_of(visitor(host=host, client="::1")) == "approver"


@pytest.mark.parametrize(
    "host",
    [
        "demo.example",
        "127.0.0.1.demo.example",
        "localhost.demo.example:8000",
        "10.0.0.7:8000",
        "0.0.0.0:8000",
        "user@127.0.0.1",
        "::1",
        "",
    ],
)
def test_a_foreign_host_is_not(visitor: Visitor, host: str) -> None:
    answer = visitor(host=host).get("/v1/me")
    assert (answer.status_code, answer.json()["code"]) == (401, "not-signed-in")
    assert visitor(host=host).get("/v1/session").json()["signed_in"] is False


@pytest.mark.parametrize(
    "header",
    ["X-Forwarded-For", "X-Forwarded-Host", "X-Forwarded-Proto", "X-Forwarded-Server", "Forwarded", "Via", "X-Real-IP"],
)
def test_what_came_through_a_proxy_is_not(visitor: Visitor, header: str) -> None:
    assert visitor(**{header: "127.0.0.1"}).get("/v1/me").status_code == 401
    assert visitor(**{header: ""}).get("/v1/me").status_code == 401


@pytest.mark.parametrize("client", ["192.0.2.7", "10.0.0.2", "::ffff:192.0.2.7", "testclient"])
def test_another_machine_is_not(visitor: Visitor, client: str) -> None:
    assert visitor(client=client).get("/v1/me").status_code == 401


def test_without_demo_mode_the_endpoint_does_not_exist(server: RunningServer) -> None:
    browser = TestClient(server.application, base_url="http://127.0.0.1:8000", client=("127.0.0.1", 50_000))
    assert browser.get("/v1/me").status_code == 401
    assert browser.put("/v1/demo/part/designer").status_code == 401


@pytest.mark.slow
def test_the_switch_changes_who_is_played(visitor: Visitor) -> None:
    browser = visitor()
    assert browser.get("/v1/session").json()["demo"] is True
    browser.headers["X-CSRF-Token"] = browser.cookies["soundlist_csrf"]
    for part in ("approver", "designer", "producer"):
        answer = browser.put(f"/v1/demo/part/{part}")
        assert answer.json() == {"part": part, "parts": ["approver", "producer", "designer"]}
        assert name_of(browser) == part
    assert browser.put("/v1/demo/part/owner").status_code == 404


def test_another_sites_page_writes_nothing_in_the_demo(visitor: Visitor) -> None:
    browser = visitor()
    assert browser.put("/v1/me", json={"name": "defaced"}).status_code == 403
    browser.get("/v1/session")
    token = {"X-CSRF-Token": browser.cookies["soundlist_csrf"]}
    answer = browser.put("/v1/me", json={"name": "defaced"}, headers=token | {"Origin": "https://evil.example"})
    assert answer.status_code == 403


def test_who_signed_in_is_not_in_the_demo(visitor: Visitor, world: World) -> None:
    browser = visitor()
    browser.cookies.update(world.reviewer.cookies)
    browser.headers.update({"X-CSRF-Token": world.reviewer.headers["X-CSRF-Token"]})
    assert name_of(browser) == "Composer"
    assert browser.get("/v1/session").json()["demo"] is False
    assert browser.put("/v1/demo/part/designer").status_code == 404


def test_the_demos_people_are_nobody_in_other_studios(visitor: Visitor, server: RunningServer, world: World) -> None:
    """A demo person who became a member elsewhere takes no right there through the open door."""
    producer_id = UUID(visitor().get("/v1/me").json()["person"]["id"])
    with server.runtime.database.writing() as session:
        add_member(session, world.studio_id, producer_id, [Role.PRODUCER])
    try:
        assert visitor().get(f"/v1/studios/{world.studio_id}/people").status_code == 404
        assert visitor().get(f"/v1/projects/{world.project_id}").status_code == 404
    finally:
        with server.runtime.database.writing() as session:
            session.execute(
                delete(Membership).where(Membership.studio_id == world.studio_id, Membership.person_id == producer_id)
            )


def test_the_demos_people_have_no_password_and_no_further_studio(visitor: Visitor) -> None:
    browser = visitor()
    browser.get("/v1/session")
    browser.headers["X-CSRF-Token"] = browser.cookies["soundlist_csrf"]
    body = {"current": "whatever it is", "new": "correct horse battery"}
    assert browser.put("/v1/me/password", json=body).json()["code"] == "not-in-demo"
    assert browser.post("/v1/studios", json={"name": "Another"}).json()["code"] == "not-in-demo"
