from datetime import timedelta
from uuid import UUID, uuid4

import pytest
from sqlalchemy import delete, select
from sqlalchemy.orm import Session

from app.accounts.authentication import CSRF_COOKIE, CSRF_HEADER
from app.accounts.models import Membership, Person, StudioInvitation
from app.core import clock
from tests.support.links import mailed_links, secret_for
from tests.support.server import RunningServer, World

PASSWORD = "correct horse battery"


def address() -> str:
    return f"composer-{uuid4().hex}@studio.example"


def invite(world: World, email: str, *roles: str) -> None:
    body = {"email": email, "roles": list(roles or ("reviewer",))}
    assert world.producer.post(f"/v1/studios/{world.studio_id}/invitations", json=body).status_code == 201


def person_path(world: World, person_id: UUID) -> str:
    return f"/v1/studios/{world.studio_id}/people/{person_id}"


def test_members_see_each_other(world: World) -> None:
    people = world.reviewer.get(f"/v1/studios/{world.studio_id}/people").json()
    assert [(person["person"]["name"], person["roles"]) for person in people] == [
        ("Producer", ["producer"]),
        ("Audio director", ["liaison"]),
        ("Composer", ["reviewer"]),
    ]


def test_strangers_and_designers_do_not_see_the_studio(world: World) -> None:
    for browser in (world.stranger, world.designer, world.other_designer):
        assert browser.get(f"/v1/studios/{world.studio_id}/people").status_code == 404
    assert world.nobody.get(f"/v1/studios/{world.studio_id}/people").status_code == 401


def test_only_producers_change_roles(world: World) -> None:
    path = person_path(world, world.reviewer_id)
    body = {"roles": ["reviewer", "implementer", "reviewer"]}
    assert world.approver.put(path, json=body).json()["code"] == "producer-needed"
    assert world.stranger.put(path, json=body).json()["code"] == "studio-not-found"
    assert world.producer.put(path, json=body).json()["roles"] == ["implementer", "reviewer"]
    assert world.producer.put(path, json={"roles": []}).status_code == 422
    assert world.producer.put(path, json={"roles": ["owner"]}).status_code == 422
    elsewhere = person_path(world, world.stranger_id)
    assert world.producer.put(elsewhere, json=body).json()["code"] == "member-not-found"


def test_the_last_producer_stays(world: World) -> None:
    own = person_path(world, world.producer_id)
    assert world.producer.put(own, json={"roles": ["reviewer"]}).json()["code"] == "last-producer"
    assert world.producer.delete(own).json()["code"] == "last-producer"
    assert world.producer.put(person_path(world, world.approver_id), json={"roles": ["producer"]}).status_code == 200
    assert world.producer.delete(own).status_code == 204
    assert world.producer.get(f"/v1/studios/{world.studio_id}/people").status_code == 404


def test_who_leaves_sees_nothing_more(world: World) -> None:
    assert world.reviewer.get(f"/v1/projects/{world.project_id}").status_code == 200
    assert world.producer.delete(person_path(world, world.reviewer_id)).status_code == 204
    assert world.reviewer.get(f"/v1/projects/{world.project_id}").status_code == 404


@pytest.mark.slow
def test_a_newcomer_joins_by_the_link(server: RunningServer, world: World) -> None:
    email = address()
    invite(world, email.upper(), "liaison", "reviewer")
    secret = secret_for(server, email)
    browser = server.browser()
    shown = browser.get(f"/v1/studio-invitations/{secret}").json()
    assert (shown["studio_name"], shown["email"], shown["roles"]) == ("Test studio", email, ["liaison", "reviewer"])
    assert (shown["has_account"], shown["invited_by_name"]) == (False, "Producer")
    path = f"/v1/studio-invitations/{secret}/accept"
    assert browser.post(path, json={}).json()["errors"][0]["where"] == "name"
    assert browser.post(path, json={"name": "Composer", "password": "short"}).json()["code"] == "password-too-weak"
    joined = browser.post(path, json={"name": "Composer", "password": PASSWORD})
    assert joined.json()["studio"] == {"id": str(world.studio_id), "name": "Test studio"}
    assert browser.get(f"/v1/studios/{world.studio_id}/people").status_code == 200
    assert browser.post(path, json={"name": "Composer", "password": PASSWORD}).status_code == 404  # once
    assert world.producer.get(f"/v1/studios/{world.studio_id}/invitations").json() == []


@pytest.mark.slow
def test_the_account_of_an_address_is_its_holders(server: RunningServer, world: World) -> None:
    """A link that reached the wrong hands does not open an account that exists."""
    email = address()
    owner = server.browser()
    body = {"email": email, "name": "Composer", "password": PASSWORD, "studio_name": "Elsewhere"}
    assert owner.post("/v1/sign-up", json=body).status_code == 201
    invite(world, email)
    secret = secret_for(server, email)
    path = f"/v1/studio-invitations/{secret}/accept"
    finder = server.browser()
    assert finder.get(f"/v1/studio-invitations/{secret}").json()["has_account"] is True
    assert finder.post(path, json={"name": "Thief", "password": "not the password"}).json()["code"] == "sign-in-needed"
    assert world.stranger.post(path, json={}).json()["code"] == "sign-in-needed"
    assert finder.get("/v1/me").status_code == 401
    owner.headers["X-CSRF-Token"] = owner.cookies["soundlist_csrf"]
    assert owner.post(path, json={}).status_code == 200
    assert len(owner.get("/v1/me").json()["studios"]) == 2


def test_an_account_joins_with_its_password_too(server: RunningServer, world: World) -> None:
    email = address()
    body = {"email": email, "name": "Composer", "password": PASSWORD, "studio_name": "Elsewhere"}
    assert server.browser().post("/v1/sign-up", json=body).status_code == 201
    invite(world, email)
    browser = server.browser()
    answer = browser.post(f"/v1/studio-invitations/{secret_for(server, email)}/accept", json={"password": PASSWORD})
    assert answer.status_code == 200
    assert browser.get("/v1/me").json()["email"] == email


def test_known_and_unknown_addresses_are_invited_alike(server: RunningServer, world: World) -> None:
    known, unknown = f"{world.stranger_id}@example.test", address()
    path = f"/v1/studios/{world.studio_id}/invitations"
    answers = [
        world.producer.post(path, json={"email": email, "roles": ["reviewer"]}).json() for email in (known, unknown)
    ]
    assert answers[0].keys() == answers[1].keys()
    assert {answer["email"] for answer in answers} == {known, unknown}
    assert all("secret" not in key and "link" not in key for key in answers[0])


def test_a_member_is_not_invited_again(world: World) -> None:
    body = {"email": f"{world.reviewer_id}@example.test", "roles": ["producer"]}
    answer = world.producer.post(f"/v1/studios/{world.studio_id}/invitations", json=body)
    assert (answer.status_code, answer.json()["code"]) == (409, "already-member")


def test_a_second_invitation_replaces_the_first(server: RunningServer, world: World) -> None:
    email = address()
    invite(world, email)
    (first,) = (link.rpartition("/")[2] for link in mailed_links(server, email))  # jobs of two events have no order
    invite(world, email, "implementer")
    second = secret_for(server, email)
    assert server.browser().get(f"/v1/studio-invitations/{first}").status_code == 404
    assert server.browser().get(f"/v1/studio-invitations/{second}").json()["roles"] == ["implementer"]
    assert len(world.producer.get(f"/v1/studios/{world.studio_id}/invitations").json()) == 1


@pytest.mark.slow
def test_a_withdrawn_or_old_invitation_is_worth_nothing(server: RunningServer, world: World) -> None:
    email = address()
    invite(world, email)
    secret = secret_for(server, email)
    path = f"/v1/studios/{world.studio_id}/invitations"
    (listed,) = world.producer.get(path).json()
    assert world.reviewer.delete(f"{path}/{listed['id']}").status_code == 403
    assert world.producer.delete(f"{path}/{listed['id']}").status_code == 204
    assert world.producer.delete(f"{path}/{listed['id']}").status_code == 404
    assert server.browser().get(f"/v1/studio-invitations/{secret}").status_code == 404
    invite(world, email)
    secret = secret_for(server, email)
    with server.runtime.database.writing() as session:
        for invitation in session.scalars(select(StudioInvitation).where(StudioInvitation.email == email)):
            invitation.expires_at = clock.now() - timedelta(seconds=1)
    body = {"name": "Composer", "password": PASSWORD}
    assert server.browser().post(f"/v1/studio-invitations/{secret}/accept", json=body).status_code == 404


def test_joining_adds_to_the_roles_held(server: RunningServer, world: World) -> None:
    """A person who was made a member in the meantime loses nothing by an older link."""
    email = f"{world.other_designer_id}@example.test"
    invite(world, email, "reviewer")
    with server.runtime.database.writing() as session:
        session.add(Membership(studio_id=world.studio_id, person_id=world.other_designer_id, roles=["implementer"]))
    path = f"/v1/studio-invitations/{secret_for(server, email)}/accept"
    assert world.other_designer.post(path, json={}).status_code == 200
    roles = {
        one["person"]["id"]: one["roles"] for one in world.producer.get(f"/v1/studios/{world.studio_id}/people").json()
    }
    assert roles[str(world.other_designer_id)] == ["implementer", "reviewer"]


@pytest.mark.slow
def test_nobody_mails_the_whole_world(world: World) -> None:
    path = f"/v1/studios/{world.studio_id}/invitations"
    codes = [
        world.producer.post(path, json={"email": f"name{number}@studio.example", "roles": ["reviewer"]}).status_code
        for number in range(61)
    ]
    assert codes == [201] * 60 + [429]


@pytest.mark.parametrize(
    ("secret", "status"), [("unknown", 404), ("x" * 500, 404), ("%00", 400), ("%F0%9F%94%8A", 404)]
)
def test_made_up_links_lead_nowhere(server: RunningServer, secret: str, status: int) -> None:
    assert server.browser().get(f"/v1/studio-invitations/{secret}").status_code == status


def test_a_person_opens_a_further_studio(world: World) -> None:
    answer = world.designer.post("/v1/studios", json={"name": "Own studio"})
    assert answer.status_code == 201
    assert world.designer.get(f"/v1/studios/{answer.json()['id']}/people").json()[0]["roles"] == ["producer"]


def test_one_account_opens_a_bounded_number_of_studios_also_after_leaving_some(server: RunningServer) -> None:
    owner, email = server.browser(), address()
    body = {"email": email, "name": "Owner", "password": PASSWORD, "studio_name": "Night Studio"}
    assert owner.post("/v1/sign-up", json=body).status_code == 201
    owner.headers[CSRF_HEADER] = owner.cookies[CSRF_COOKIE]
    most = server.runtime.settings.studios_per_account
    for number in range(most - 1):
        assert owner.post("/v1/studios", json={"name": f"Studio {number}"}).status_code == 201

    def leave_all(session: Session) -> None:
        person_id = session.scalars(select(Person.id).where(Person.email == email)).one()
        session.execute(delete(Membership).where(Membership.person_id == person_id))

    server.in_database(leave_all)
    refused = owner.post("/v1/studios", json={"name": "One more"})
    assert (refused.status_code, refused.json()["code"]) == (409, "too-many-studios")
    assert f"{most} studios" in refused.json()["detail"]
    assert "SOUNDLIST_STUDIOS_PER_ACCOUNT" in refused.json()["fix"]


def test_a_producer_renames_the_studio(world: World) -> None:
    path = f"/v1/studios/{world.studio_id}"
    assert world.producer.put(path, json={"name": " Blue Hull "}).json() == {
        "id": str(world.studio_id),
        "name": "Blue Hull",
    }
    assert world.producer.get("/v1/me").json()["studios"][0]["name"] == "Blue Hull"
    assert world.producer.put(path, json={"name": "   "}).json()["errors"][0]["where"] == "name"
    assert world.approver.put(path, json={"name": "Ours"}).json()["code"] == "producer-needed"
    assert world.stranger.put(path, json={"name": "Ours"}).status_code == 404


@pytest.mark.parametrize(("name", "studio"), [("Ada", "Ada’s studio"), ("x" * 120, "x" * 100 + "’s studio")])
def test_an_account_without_a_studio_name_names_the_studio_after_its_person(
    server: RunningServer, name: str, studio: str
) -> None:
    browser = server.browser()
    body = {"email": address(), "name": name, "password": PASSWORD}
    assert browser.post("/v1/sign-up", json=body).status_code == 201
    assert [each["name"] for each in browser.get("/v1/me").json()["studios"]] == [studio]
