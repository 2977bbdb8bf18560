"""Mails about what gives access: sent to whom it concerns, whatever they wish of other mails."""

from datetime import UTC, datetime, timedelta
from uuid import UUID

import pytest
import sqlalchemy as sa
from httpx2 import Client
from sqlalchemy.orm import Session

from app.accounts.models import DeskToken, Person, Token
from app.accounts.rules import is_end_near
from app.core import clock
from app.core.jobs.queue import Payload
from app.core.plural import day_in_words
from app.notifications.models import Mail, Notice
from app.notifications.security_jobs import warn_of_token_ends
from tests.app.accounts.test_sign_in import NEW_PASSWORD, PASSWORD, address, sign_in, sign_up, with_csrf
from tests.support.links import secret_for
from tests.support.server import RunningServer, World


def mails_to(server: RunningServer, email: str) -> list[str]:
    """Return the subjects of all mails to an address, in order."""
    server.wait_for_jobs()

    def subjects(session: Session) -> list[str]:
        return list(session.scalars(sa.select(Mail.subject).where(Mail.recipient == email).order_by(Mail.id)))

    found: list[str] = server.in_database(subjects)
    return found


def email_of(world: World, person_id: UUID) -> str:
    email: str = world.server.in_database(lambda session: session.get_one(Person, person_id).email)
    return email


def age_account(server: RunningServer, email: str) -> None:
    """Let an account be a day old."""
    aged = sa.update(Person).where(Person.email == email).values(created_at=clock.now() - timedelta(days=1))
    server.in_database(lambda session: session.execute(aged))


def build(world: World, secret: str) -> Client:
    client = world.server.browser()
    client.headers["Authorization"] = f"Bearer {secret}"
    return client


def test_a_changed_password_and_a_first_sign_in_are_mailed_to_the_person(server: RunningServer) -> None:
    browser, email = server.browser(), address()
    assert sign_up(browser, email).status_code == 201
    with_csrf(browser)
    assert sign_in(browser, email).status_code == 200  # the browser that opened the account is known
    with_csrf(browser)
    assert mails_to(server, email) == []
    age_account(server, email)
    elsewhere = server.browser()
    for _ in range(2):
        assert sign_in(elsewhere, email).status_code == 200
    assert mails_to(server, email) == ["A new browser signed in to your account"]
    change = {"current": PASSWORD, "new": NEW_PASSWORD}
    assert browser.put("/v1/me/password", json=change).status_code == 204
    assert mails_to(server, email)[1:] == ["Your password was changed"]
    assert browser.put("/v1/me/password", json=change).status_code == 403  # the old one is wrong now
    assert len(mails_to(server, email)) == 2


def test_the_first_sign_in_by_an_invitation_is_mailed_too(world: World) -> None:
    server, email = world.server, address()
    assert sign_up(server.browser(), email).status_code == 201
    age_account(server, email)
    invited = {"email": email, "roles": ["reviewer"]}
    assert world.producer.post(f"/v1/studios/{world.studio_id}/invitations", json=invited).status_code == 201
    secret = secret_for(server, email)
    accepted = server.browser().post(f"/v1/studio-invitations/{secret}/accept", json={"password": PASSWORD})
    assert accepted.status_code == 200, accepted.text
    assert mails_to(server, email)[-1] == "A new browser signed in to your account"


def test_a_new_token_and_a_new_producer_are_mailed_to_the_producers(world: World) -> None:
    wishes = {"cadences": {"list": "never"}, "time_zone": "UTC", "daily_at": "08:00"}
    assert world.producer.put("/v1/me/mail-preferences", json=wishes).is_success
    tokens = f"/v1/projects/{world.project_id}/tokens"
    assert world.producer.post(tokens, json={"name": "CI", "scopes": ["spec:read"], "days": 30}).status_code == 201
    world.server.wait_for_jobs()  # who becomes a producer later is told nothing of it
    reviewer = f"/v1/studios/{world.studio_id}/people/{world.reviewer_id}"
    for _ in range(2):  # who is a producer already becomes none
        assert world.producer.put(reviewer, json={"roles": ["producer"]}).status_code == 200
    producer, reviewed = email_of(world, world.producer_id), email_of(world, world.reviewer_id)
    assert mails_to(world.server, producer) == ["Shield Wing: a new token for builds", "Test studio: a new producer"]
    assert mails_to(world.server, reviewed) == []
    shown = world.producer.get("/v1/me/notices").json()["items"]
    assert [notice["subject"] for notice in shown] == mails_to(world.server, producer)[::-1]
    assert shown[-1]["path"] == f"/projects/{world.project_id}/tokens"


def test_a_new_desk_token_is_mailed_to_its_person(world: World) -> None:
    assert world.designer.post("/v1/me/desk-tokens", json={"name": "Laptop"}).status_code == 201
    assert mails_to(world.server, email_of(world, world.designer_id)) == ["A new desk token of your account"]


NOW = datetime(2026, 5, 20, tzinfo=UTC)


@pytest.mark.parametrize(
    ("lives_days", "left_days", "is_near"),
    [(365, 15, False), (365, 14, True), (365, 0, True), (10, 6, False), (10, 5, True)],
)
def test_an_end_is_near_for_two_weeks_or_half_of_a_short_life(lives_days: int, left_days: int, is_near: bool) -> None:
    end = NOW + timedelta(days=left_days)
    assert is_end_near(end - timedelta(days=lives_days), end, NOW) is is_near


def test_tokens_end_on_their_day_are_announced_once_and_refused_with_the_reason_after(world: World) -> None:
    tokens = f"/v1/projects/{world.project_id}/tokens"
    for days in (0, 366):
        assert world.producer.post(tokens, json={"name": "CI", "scopes": ["spec:read"], "days": days}).is_client_error
    made = world.producer.post(tokens, json={"name": "CI", "scopes": ["spec:read"], "days": 90}).json()
    begun, end = (datetime.fromisoformat(made[name]) for name in ("created_at", "expires_at"))
    assert round((end - begun) / timedelta(days=1)) == 90
    desk = world.designer.post("/v1/me/desk-tokens", json={"name": "Laptop"}).json()
    spec = f"/v1/projects/{world.project_id}/spec"
    assert build(world, made["secret"]).get(spec).status_code == 200

    def end_in(delta: timedelta) -> None:
        for table, token_id in ((Token, made["id"]), (DeskToken, desk["id"])):
            ends = {"created_at": clock.now() - timedelta(days=80), "expires_at": clock.now() + delta}
            moved = sa.update(table).where(table.id == UUID(token_id)).values(**ends)
            world.server.in_database(lambda session, moved=moved: session.execute(moved))

    producer, designer = email_of(world, world.producer_id), email_of(world, world.designer_id)
    before = len(mails_to(world.server, producer)), len(mails_to(world.server, designer))
    for _ in range(2):
        warn_of_token_ends(world.server.runtime, Payload())
    assert (len(mails_to(world.server, producer)), len(mails_to(world.server, designer))) == before
    end_in(timedelta(days=3))
    for _ in range(2):
        warn_of_token_ends(world.server.runtime, Payload())
    assert "a token for builds ends on" in mails_to(world.server, producer)[before[0] :].pop()
    assert ["A desk token ends on" in subject for subject in mails_to(world.server, designer)[before[1] :]] == [True]
    notices = sa.select(sa.func.count()).where(Notice.person_id == world.producer_id, Notice.topic.like("%token-end%"))
    assert world.server.in_database(lambda session: session.scalar(notices)) == 1
    assert build(world, made["secret"]).get(spec).status_code == 200
    end_in(-timedelta(days=1))
    day = day_in_words(clock.now() - timedelta(days=1))
    for secret in (made["secret"], desk["secret"]):
        refused = build(world, secret).get(spec)
        assert (refused.status_code, refused.json()["code"]) == (401, "not-signed-in")
        assert f"ended on {day}" in refused.json()["detail"]
