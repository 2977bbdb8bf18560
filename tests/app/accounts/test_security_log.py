"""The security log of a studio: who did what, when and from which network, for its producers alone."""

import csv
import io
from datetime import timedelta
from typing import Any

import pytest
import sqlalchemy as sa
from httpx2 import Client
from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import Role
from app.accounts.security_log import service as security_log
from app.accounts.security_log.models import SecurityEvent
from app.accounts.security_log.rules import KEPT_FOR, SecurityEventKind, csv_of, names_of_roles
from app.core import clock
from app.core.db import new_id
from app.operations.erasure.service import erase_person
from tests.app.accounts.test_email_changes import Change
from tests.app.accounts.test_passkeys import Account
from tests.app.accounts.test_sign_in import NEW_PASSWORD, PASSWORD, address, sign_in, sign_up, with_csrf
from tests.app.shares.making import made, sound
from tests.support.links import secret_for
from tests.support.server import RunningServer, World
from tests.support.smtp import mail_server

pytestmark = pytest.mark.both_databases
FIREFOX = "Mozilla/5.0 (X11; Linux x86_64; rv:145.0) Gecko/20100101 Firefox/145.0"


def log_of(browser: Client, studio_id: Any, **asked: str) -> list[dict[str, Any]]:
    answer = browser.get(f"/v1/studios/{studio_id}/security-events", params=asked)
    assert answer.status_code == 200, answer.text
    items: list[dict[str, Any]] = answer.json()["items"]
    return items


def lines(browser: Client, studio_id: Any, **asked: str) -> list[tuple[str, str]]:
    return [(line["kind"], line["summary"]) for line in log_of(browser, studio_id, **asked)]


def add_events(world: World, count: int, kind: SecurityEventKind = SecurityEventKind.TOKEN) -> None:
    def add(session: Session) -> None:
        for number in range(count):
            summary = f"made the build token {number}"
            studios = [world.studio_id]
            security_log.record(session, kind, summary, studio_ids=studios, person_id=world.producer_id)

    world.server.in_database(add)


def test_a_sign_in_and_a_new_password_are_in_the_log_of_each_studio_of_the_person(server: RunningServer) -> None:
    browser, email = server.browser(), address()
    assert sign_up(browser, email).status_code == 201
    browser = server.browser()
    assert browser.post(
        "/v1/sign-in", json={"email": email, "password": PASSWORD}, headers={"User-Agent": FIREFOX}
    ).is_success
    with_csrf(browser)
    studio_id = browser.get("/v1/me").json()["studios"][0]["id"]
    changed = browser.put("/v1/me/password", json={"current": PASSWORD, "new": NEW_PASSWORD})
    assert changed.is_success, changed.text
    log = log_of(browser, studio_id)
    assert [(line["kind"], line["summary"]) for line in log[:2]] == [
        ("password", "set a new password"),
        ("sign_in", "signed in with Firefox on Linux"),
    ]
    assert {line["person"]["id"] for line in log} == {browser.get("/v1/me").json()["person"]["id"]}
    assert {line["network"] for line in log} == {"testclient"}
    assert sign_in(server.browser(), email).status_code == 401  # the old password: nothing is recorded
    assert len(log_of(browser, studio_id)) == len(log)


def test_roles_joining_and_removal_name_who_did_it_and_about_whom(world: World) -> None:
    invited = address()
    body = {"email": invited, "roles": ["reviewer"]}
    assert world.producer.post(f"/v1/studios/{world.studio_id}/invitations", json=body).status_code == 201
    world.server.wait_for_jobs()
    accept = f"/v1/studio-invitations/{secret_for(world.server, invited)}/accept"
    joined = world.server.browser().post(accept, json={"name": "Composer", "password": PASSWORD})
    assert joined.is_success, joined.text
    person_id = joined.json()["person"]["id"]
    path = f"/v1/studios/{world.studio_id}/people/{person_id}"
    assert world.producer.put(path, json={"roles": ["implementer", "reviewer"]}).is_success
    assert world.producer.delete(path).is_success
    log = [line for line in log_of(world.producer, world.studio_id) if line["kind"] != "sign_in"]
    assert [(line["kind"], line["summary"], line["person"]["id"], (line["about"] or {}).get("id")) for line in log] == [
        ("removal", "removed from the studio", str(world.producer_id), person_id),
        ("roles", "changed the roles to Reviewer, Implementer", str(world.producer_id), person_id),
        ("roles", "joined with the roles Reviewer", person_id, None),
    ]


def test_tokens_are_recorded_when_made_and_once_when_revoked(world: World) -> None:
    path = f"/v1/projects/{world.project_id}/tokens"
    made = world.producer.post(path, json={"name": "Nightly", "scopes": ["spec:read"]})
    assert made.status_code == 201, made.text
    for _ in range(2):
        assert world.producer.delete(f"{path}/{made.json()['id']}").is_success
    desk_token = world.producer.post("/v1/me/desk-tokens", json={"name": "Laptop"})
    assert desk_token.status_code == 201
    assert lines(world.producer, world.studio_id, kind="token") == [
        ("token", "made a desk token"),
        ("token", "revoked the build token Nightly"),
        ("token", "made the build token Nightly"),
    ]


def studio_of(browser: Client) -> str:
    return str(browser.get("/v1/me").json()["studios"][0]["id"])


def test_passkeys_are_recorded_without_their_names(server: RunningServer) -> None:
    account = Account(server)
    assert account.browser.delete(f"/v1/me/passkeys/{account.added.json()['id']}").status_code == 204
    assert lines(account.browser, studio_of(account.browser), kind="second_factor") == [
        ("second_factor", "removed a passkey"),
        ("second_factor", "added a passkey"),
    ]


def test_a_changed_email_is_recorded_once_both_ends_have_confirmed(server: RunningServer) -> None:
    with mail_server(server) as mails:
        change = Change(server, mails)
        change.confirm(change.old)
        studio_id = studio_of(change.browser)
        assert lines(change.browser, studio_id, kind="email") == []
        assert change.confirm(change.new).json()["email"] == change.new
    assert lines(change.browser, studio_id, kind="email") == [("email", "changed the email of the account")]


def test_webhooks_are_recorded_by_host_alone(world: World) -> None:
    body = {"url": "https://hooks.example.com/services/T0/secret", "events": ["take.approved"]}
    added = world.producer.post(f"/v1/studios/{world.studio_id}/webhooks", json=body)
    assert added.status_code == 201, added.text
    path = f"/v1/webhooks/{added.json()['id']}"
    assert world.producer.patch(path, json={"url": "https://example.org/secret"}).is_success
    assert world.producer.patch(path, json={"enabled": False}).is_success
    assert world.producer.delete(path).status_code == 204
    assert lines(world.producer, world.studio_id, kind="webhook") == [
        ("webhook", "deleted the webhook to example.org"),
        ("webhook", "changed the address of a webhook to example.org"),
        ("webhook", "added a webhook to hooks.example.com"),
    ]


@pytest.mark.slow
def test_guest_links_are_recorded_when_made_and_once_when_revoked(world: World) -> None:
    cue_id, _ = sound(world)
    link, _ = made(world, cue_ids=[cue_id], title="For the press")
    for _ in range(2):
        assert world.producer.post(f"/v1/guest-links/{link['id']}/revoke").is_success
    assert lines(world.producer, world.studio_id, kind="guest_link") == [
        ("guest_link", "revoked the guest link For the press"),
        ("guest_link", "made the guest link For the press"),
    ]


def test_what_is_refused_is_not_recorded(world: World) -> None:
    path = f"/v1/studios/{world.studio_id}/people/{world.producer_id}"
    assert world.producer.delete(path).json()["code"] == "last-producer"
    assert log_of(world.producer, world.studio_id) == []


def test_the_log_comes_in_pages_by_kind_and_as_csv(world: World) -> None:
    add_events(world, 51)
    add_events(world, 1, SecurityEventKind.EXPORT)
    path = f"/v1/studios/{world.studio_id}/security-events"
    first = world.producer.get(path, params={"kind": "token"}).json()
    second = world.producer.get(path, params={"kind": "token", "cursor": first["next"]}).json()
    assert (len(first["items"]), len(second["items"]), second["next"]) == (50, 1, None)
    assert second["items"][0]["summary"] == "made the build token 0"
    answer = world.producer.get(f"{path}.csv", params={"kind": "export"})
    assert answer.headers["content-type"] == "text/csv; charset=utf-8"
    rows = list(csv.DictReader(io.StringIO(answer.text)))
    assert [(row["kind"], row["person"], row["network"]) for row in rows] == [("export", "Producer", "")]
    assert len(list(csv.DictReader(io.StringIO(world.producer.get(f"{path}.csv").text)))) == 52
    assert world.producer.get(path, params={"kind": "weather"}).status_code == 422


def test_producers_of_the_studio_alone_read_it(world: World) -> None:
    for name in ("security-events", "security-events.csv"):
        path = f"/v1/studios/{world.studio_id}/{name}"
        assert world.approver.get(path).json()["code"] == "producer-needed"
        assert world.stranger.get(path).status_code == world.designer.get(path).status_code == 404
        assert world.nobody.get(path).status_code == 401


def test_old_lines_are_deleted_and_younger_ones_stay(world: World) -> None:
    add_events(world, 2)

    def age(session: Session) -> None:
        oldest = session.scalars(
            sa.select(SecurityEvent).where(SecurityEvent.studio_id == world.studio_id).order_by(SecurityEvent.id)
        ).first()
        assert oldest is not None
        oldest.at = clock.now() - KEPT_FOR - timedelta(minutes=1)

    world.server.in_database(age)
    world.server.in_database(security_log.delete_old)
    assert lines(world.producer, world.studio_id) == [("token", "made the build token 1")]


def test_an_erased_person_leaves_lines_without_name_and_network(world: World) -> None:
    def act(session: Session) -> str:
        person = Person(id=new_id(), email=address(), name="Ada Lovelace")
        session.add(person)
        session.flush()
        session.add(
            SecurityEvent(
                studio_id=world.studio_id,
                kind=SecurityEventKind.SIGN_IN,
                summary="signed in with Firefox on Linux",
                person_id=person.id,
                network="203.0.113.7",
            )
        )
        session.flush()
        return person.email

    email = world.server.in_database(act)
    world.server.in_database(lambda session: erase_person(session, email))
    (line,) = log_of(world.producer, world.studio_id)
    assert line["person"]["name"].startswith("Former user")
    assert (line["summary"], line["network"]) == ("signed in with Firefox on Linux", "")


def test_rules_of_words_and_cells() -> None:
    assert names_of_roles([Role.REVIEWER, Role.PRODUCER]) == "Producer, Reviewer"
    assert csv_of([("=1+1", "a,b")]).splitlines()[1] == '\'=1+1,"a,b"'
