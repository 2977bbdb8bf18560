from datetime import timedelta
from uuid import uuid4

import pytest
from httpx import Response
from sqlalchemy import select

from app.accounts.authentication import sha256_of
from app.core import clock
from app.notifications.models import Mail
from app.projects.errors import InvitationNotFound
from app.projects.models import ProjectInvitation
from app.projects.service import invitation_by_secret
from tests.support.links import mailed_links, secret_for
from tests.support.server import RunningServer, World

PASSWORD = "correct horse battery"
NEWCOMER = {"name": "Sound designer", "password": PASSWORD}


def address() -> str:
    return f"designer-{uuid4().hex}@sounds.example"


def invitations_path(world: World) -> str:
    return f"/v1/projects/{world.project_id}/invitations"


def invite(world: World, email: str, **more: str) -> Response:
    return world.producer.post(invitations_path(world), json={"email": email} | more)


def is_good(server: RunningServer, secret: str) -> bool:
    with server.runtime.database.reading() as session:
        try:
            invitation = invitation_by_secret(session, secret)
        except InvitationNotFound:
            return False
        return bool(invitation.project.studio.name and invitation.inviter.name)


def test_the_mail_says_who_invites_to_what(server: RunningServer, world: World) -> None:
    email = address()
    answer = invite(world, email.upper(), kind="advisory", note="Palette first.")
    assert (answer.status_code, answer.json()["email"], answer.json()["kind"]) == (201, email, "advisory")
    (link,) = mailed_links(server, email)
    assert link.startswith("http://127.0.0.1:8000/invitation/")
    with server.runtime.database.reading() as session:
        mail = session.scalars(select(Mail).where(Mail.recipient == email)).one()
        assert mail.studio_id == world.studio_id
        assert mail.subject == "Producer invites you to make sounds for Shield Wing"
        assert "Palette first." in mail.lines[0]
        stored = session.scalars(select(ProjectInvitation).where(ProjectInvitation.email == email)).one()
        assert stored.secret_sha256 == sha256_of(link.rpartition("/")[2])


@pytest.mark.slow
def test_a_newcomer_is_engaged_and_signed_in_by_accepting(server: RunningServer, world: World) -> None:
    email = address()
    invite(world, email)
    secret = secret_for(server, email)
    browser = server.browser()
    assert browser.get(f"/v1/projects/{world.project_id}").status_code == 401
    path = f"/v1/invitations/{secret}/accept"
    assert browser.post(path, json={}).json()["code"] == "name-needed"
    assert browser.post(path, json={"name": "Sound designer"}).json()["code"] == "password-too-weak"
    accepted = browser.post(path, json=NEWCOMER).json()
    assert accepted["project_id"] == str(world.project_id)
    assert (accepted["person"]["email"], accepted["engagement"]["kind"]) == (email, "contract")
    project = browser.get(f"/v1/projects/{world.project_id}").json()
    assert project["mine"]["engagement_kind"] == "contract"
    assert browser.get("/v1/studios/" + project["studio"]["id"] + "/people").status_code == 404
    (listed,) = world.producer.get(invitations_path(world)).json()
    assert listed["accepted_at"] is not None


@pytest.mark.slow
def test_accepting_again_is_accepting_once(server: RunningServer, world: World) -> None:
    email = address()
    invite(world, email)
    path = f"/v1/invitations/{secret_for(server, email)}/accept"
    browser = server.browser()
    first = browser.post(path, json=NEWCOMER).json()
    browser.headers["X-CSRF-Token"] = browser.cookies["soundlist_csrf"]
    assert browser.post(path, json={}).json()["engagement"] == first["engagement"]
    elsewhere = server.browser()
    assert elsewhere.post(path, json={"password": "not the password"}).json()["code"] == "sign-in-needed"
    assert elsewhere.post(path, json={"password": PASSWORD}).json()["engagement"] == first["engagement"]
    assert elsewhere.get("/v1/me").json()["email"] == email


def test_a_link_in_other_hands_opens_no_account(server: RunningServer, world: World) -> None:
    email = f"{world.other_designer_id}@example.test"
    invite(world, email)
    path = f"/v1/invitations/{secret_for(server, email)}/accept"
    for browser in (server.browser(), world.stranger):
        assert browser.post(path, json=NEWCOMER).json()["code"] == "sign-in-needed"
    assert world.other_designer.post(path, json={}).status_code == 200
    assert world.other_designer.get(f"/v1/projects/{world.project_id}").status_code == 200


@pytest.mark.slow
def test_guessing_a_password_by_a_link_is_slowed_down(server: RunningServer, world: World) -> None:
    email = f"{world.other_designer_id}@example.test"
    invite(world, email)
    path = f"/v1/invitations/{secret_for(server, email)}/accept"
    tries = [server.browser().post(path, json={}) for _ in range(11)]
    assert [answer.status_code for answer in tries] == [403] * 10 + [429]
    assert int(tries[-1].headers["Retry-After"]) > 0


def test_who_invites(world: World) -> None:
    body = {"email": address()}
    assert world.approver.post(invitations_path(world), json=body).status_code == 201  # a liaison
    for browser in (world.reviewer, world.designer):
        assert browser.post(invitations_path(world), json=body).json()["code"] == "team-needed"
        assert browser.get(invitations_path(world)).status_code == 403
    for browser in (world.stranger, world.other_designer):
        assert browser.post(invitations_path(world), json=body).status_code == 404
    assert world.nobody.post(invitations_path(world), json=body).status_code == 401


def test_known_and_unknown_addresses_are_invited_alike(world: World) -> None:
    known = invite(world, f"{world.other_designer_id}@example.test")
    unknown = invite(world, address())
    assert known.status_code == unknown.status_code == 201
    assert known.json().keys() == unknown.json().keys()


def test_an_engaged_designer_is_not_invited_again(world: World) -> None:
    answer = invite(world, f"{world.designer_id}@example.test")
    assert (answer.status_code, answer.json()["code"]) == (409, "already-engaged")


@pytest.mark.parametrize(
    ("body", "where"),
    [
        ({"email": "no address"}, "email"),
        ({"email": "a@b.example\r\nBcc: c@d.example"}, "email"),
        ({"email": "a@b.example", "kind": "owner"}, "kind"),
        ({"email": "a@b.example", "note": "x" * 5_001}, "note"),
        ({"email": "a@b.example", "note": "a\x00b"}, "note"),
        ({}, "email"),
    ],
)
def test_what_is_wrong_with_an_invitation_is_reported_at_its_field(
    world: World, body: dict[str, str], where: str
) -> None:
    problem = world.producer.post(invitations_path(world), json=body).json()
    assert (problem["status"], problem["errors"][0]["where"]) == (422, where)


def test_a_second_invitation_replaces_the_first(server: RunningServer, world: World) -> None:
    email = address()
    invite(world, email)
    first = secret_for(server, email)  # jobs of two events have no order
    invite(world, email, kind="advisory")
    second = secret_for(server, email)
    assert not is_good(server, first)
    assert is_good(server, second)


@pytest.mark.slow
def test_a_withdrawn_or_old_link_shows_and_engages_nothing(server: RunningServer, world: World) -> None:
    email = address()
    invite(world, email)
    secret = secret_for(server, email)
    assert is_good(server, secret)
    (listed,) = world.producer.get(invitations_path(world)).json()
    another = World(server)
    assert another.producer.delete(f"{invitations_path(another)}/{listed['id']}").status_code == 404
    assert world.producer.delete(f"{invitations_path(world)}/{listed['id']}").status_code == 204
    assert not is_good(server, secret)
    answer = server.browser().post(f"/v1/invitations/{secret}/accept", json=NEWCOMER)
    assert answer.json()["code"] == "invitation-not-found"
    invite(world, email)
    secret = secret_for(server, email)
    with server.runtime.database.writing() as session:
        for invitation in session.scalars(select(ProjectInvitation).where(ProjectInvitation.email == email)):
            invitation.expires_at = clock.now() - timedelta(seconds=1)
    assert not is_good(server, secret)
    assert server.browser().post(f"/v1/invitations/{secret}/accept", json=NEWCOMER).status_code == 404


@pytest.mark.slow
def test_an_ended_engagement_is_not_taken_up_by_the_old_link(server: RunningServer, world: World) -> None:
    email = address()
    invite(world, email)
    secret = secret_for(server, email)
    browser = server.browser()
    engagement = browser.post(f"/v1/invitations/{secret}/accept", json=NEWCOMER).json()["engagement"]
    path = f"/v1/projects/{world.project_id}/engagements/{engagement['id']}"
    assert world.approver.patch(path, json={"ended": True}).json()["code"] == "producer-needed"
    assert world.producer.patch(path, json={"ended": True}).json()["ended_at"] is not None
    assert browser.get(f"/v1/projects/{world.project_id}").status_code == 404
    assert not is_good(server, secret)
    browser.headers["X-CSRF-Token"] = browser.cookies["soundlist_csrf"]
    assert browser.post(f"/v1/invitations/{secret}/accept", json={}).status_code == 404
    invite(world, email, kind="advisory")
    again = browser.post(f"/v1/invitations/{secret_for(server, email)}/accept", json={}).json()["engagement"]
    assert (again["id"], again["kind"], again["ended_at"]) == (engagement["id"], "advisory", None)


@pytest.mark.slow
def test_a_producer_changes_and_restores_a_tie(world: World) -> None:
    (engagement,) = world.producer.get(f"/v1/projects/{world.project_id}").json()["engagements"]
    path = f"/v1/projects/{world.project_id}/engagements/{engagement['id']}"
    assert world.producer.patch(path, json={"kind": "in-house"}).json()["kind"] == "in-house"
    assert world.producer.patch(path, json={"ended": True}).json()["kind"] == "in-house"
    assert world.producer.patch(path, json={"ended": False}).json()["ended_at"] is None
    assert world.designer.get(f"/v1/projects/{world.project_id}").status_code == 200
    another = World(world.server)
    assert another.producer.patch(path, json={"ended": True}).status_code == 404
    elsewhere = f"/v1/projects/{another.project_id}/engagements/{engagement['id']}"
    assert another.producer.patch(elsewhere, json={"ended": True}).json()["code"] == "engagement-not-found"
