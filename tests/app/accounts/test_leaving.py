"""Who leaves a studio, or has a lower role there, keeps nothing that the membership gave.

Every kind of row that names a person, or that works for one without their sign-in, and what becomes of it:

| row | on leaving | on a role that does not allow it |
|---|---|---|
| approver of a project, also by having opened it | handed over, or refused | handed over, or refused |
| approver of a category | back to the project's approver | the same |
| audio lead of a project | ended | ended |
| deputy, and who has one | withdrawn | withdrawn |
| signer of a contract that was sent | refused | refused |
| signer of a draft | ended | ended |
| invitations that they sent, or that wait at their address | revoked | those that the role does not allow |
| build tokens, guest links, links of postings | revoked, or kept in another name | kept |
| webhooks | disabled, or kept in another name | kept |
| calendar links | revoked, but of projects that engage them | kept; they show what the role sees |
| unsent news, notices | deleted, but of projects that engage them | kept |
"""

from collections.abc import Callable
from dataclasses import dataclass
from datetime import timedelta
from typing import Any
from uuid import UUID

import pytest
from httpx2 import Client
from sqlalchemy import delete, func, select
from sqlalchemy.orm import Session

from app.accounts.authentication import sha256_of
from app.accounts.models import Membership
from app.agreements.models import Contract, ContractSigner
from app.agreements.rules import ContractState
from app.core import clock
from app.notifications.models import Mail, Notice
from app.projects.models import ApproverChange, CategoryApprover, Deputy, Liaison
from app.shares.models import GuestLink
from app.webhooks.models import Webhook
from tests.app.reviews.making import Stage, body_of, refused
from tests.support.calendars import calendar_of
from tests.support.links import mailed_links, secret_for
from tests.support.server import RunningServer, World

GUEST_SECRET = "the secret of a guest link"
WHY = {"reason": "They know the music."}


@dataclass
class Leaver:
    """A producer and audio lead with every kind of row, as the people who hold their secrets see them."""

    world: World
    stage: Stage
    email: str
    build: Client
    posting_secret: str
    calendar: str
    opened_project_id: str  # approved by who opened it
    guest_secret: str

    @property
    def path(self) -> str:
        return f"/v1/studios/{self.world.studio_id}/people/{self.world.approver_id}"

    def leave(self, **query: Any) -> Any:
        return self.world.producer.delete(self.path, params=query)

    def reaches(self) -> dict[str, bool]:
        """Return what works still without a sign-in."""
        nobody, world = self.world.nobody, self.world
        with world.server.runtime.database.reading() as session:
            enabled = session.scalar(
                select(func.count()).where(Webhook.studio_id == world.studio_id, Webhook.disabled_at.is_(None))
            )
        return {
            "token": self.build.get(f"/v1/projects/{world.project_id}/spec").status_code == 200,
            "guest link": nobody.get(f"/v1/guest-access/{self.guest_secret}").status_code == 200,
            "posting link": nobody.get(f"/v1/posting-links/{self.posting_secret}").status_code == 200,
            "calendar": nobody.get(self.calendar).status_code == 200,
            "webhook": bool(enabled),
        }


@pytest.fixture
def leaver(server: RunningServer, world: World) -> Leaver:
    """The audio director, who is a producer too, with everything that names a person."""
    stage = Stage(world)
    stage.cue("laser")
    project = f"/v1/projects/{world.project_id}"
    studio = f"/v1/studios/{world.studio_id}"
    roles = {"roles": ["producer", "liaison"]}
    assert world.producer.put(f"{studio}/people/{world.approver_id}", json=roles).status_code == 200
    body = {"category": "ui", "person_id": str(world.approver_id)}
    assert world.producer.put(f"{project}/category-approvers", json=body).status_code == 200
    today = clock.now().date()
    days = {"from_on": str(today - timedelta(days=2)), "until_on": str(today + timedelta(days=20))}
    for person_id, deputy_id in ((world.producer_id, world.approver_id), (world.approver_id, world.producer_id)):
        pair = {"person_id": str(person_id), "deputy_id": str(deputy_id)}
        assert world.producer.post(f"{project}/deputies", json=pair | days).status_code == 201
    opened = world.approver.post(
        "/v1/projects", json={"studio_id": str(world.studio_id), "name": "Two", "cue_prefix": "T"}
    )
    made = world.approver.post(f"{project}/tokens", json={"name": "CI", "scopes": ["spec:read"]}).json()
    build = server.browser()
    build.headers["Authorization"] = f"Bearer {made['secret']}"
    posting = world.approver.post(f"{project}/postings", json={"title": "Effects for Alpha"}).json()
    assert world.approver.post(f"/v1/postings/{posting['id']}/open").status_code == 200
    link = world.approver.post(f"/v1/postings/{posting['id']}/link").json()["url"]
    guest_secret = f"{GUEST_SECRET} {world.project_id}"

    def add(session: Session) -> None:
        of = {"studio_id": world.studio_id, "project_id": world.project_id}
        shared = {"kind": "cues", "title": "For the composer", "may_comment": False, "has_beeps": False}
        session.add(GuestLink(**of, **shared, secret_sha256=sha256_of(guest_secret), made_by=world.approver_id))
        hook = {"url": "https://hooks.example/in", "form": "json", "events": ["take.received"]}
        session.add(Webhook(studio_id=world.studio_id, **hook, created_by=world.approver_id))

    server.in_database(add)
    return Leaver(
        world=world,
        stage=stage,
        email=f"{world.approver_id}@example.test",
        build=build,
        posting_secret=link.rpartition("/")[2],
        calendar=calendar_of(world, world.approver),
        opened_project_id=opened.json()["id"],
        guest_secret=guest_secret,
    )


def ask(world: World, cue_id: UUID, text: str) -> None:
    """Ask about a sound: the audio leads are mailed of it."""
    assert world.designer.post(f"/v1/cues/{cue_id}/questions", json={"text": text}).status_code == 201


def news_for(server: RunningServer, person_id: UUID) -> tuple[list[str], int]:
    """Return the subjects of the news mailed to a person, and how many notices they have."""
    server.wait_for_jobs()
    with server.runtime.database.reading() as session:
        mails = select(Mail.subject).where(Mail.recipient == f"{person_id}@example.test", Mail.news.is_not(None))
        notices = select(func.count()).where(Notice.person_id == person_id)
        return list(session.scalars(mails)), session.scalar(notices) or 0


def rejoin(server: RunningServer, world: World, email: str, *roles: str) -> None:
    """Invite a person who left, and accept as them."""
    body = {"email": email, "roles": list(roles)}
    assert world.producer.post(f"/v1/studios/{world.studio_id}/invitations", json=body).status_code == 201
    secret = secret_for(server, email)
    assert world.approver.post(f"/v1/studio-invitations/{secret}/accept", json={}).status_code == 200


def only_advises(world: World, stage: Stage, person: Client) -> None:
    """Check that a member has the rights of a reviewer and no more."""
    path = f"/v1/projects/{world.project_id}"
    mine = body_of(person.get(path))["mine"]
    assert (mine["is_team"], mine["is_producer"], mine["is_liaison"], mine["is_approver"]) == (
        True,
        False,
        False,
        False,
    )
    (listed,) = [one for one in body_of(person.get("/v1/me"))["projects"] if one["id"] == str(world.project_id)]
    assert (listed["is_liaison"], listed["is_approver"]) == (False, False)
    for category in ("", "ui"):
        take_id = stage.take(stage.cue(f"cue_{category}", category=category))
        answer = person.post(f"/v1/takes/{take_id}/verdict", json={"kind": "approve"})
        assert refused(answer) == (403, "approver-needed")
    added = person.post(f"{path}/cues", json={"cues": [{"name": "Door", "file_name": "door"}]})
    assert refused(added) == (403, "team-needed")
    for closed in ("guest-links", "contracts", "money", "invitations", "tokens"):
        answer = person.get(f"{path}/{closed}")
        assert answer.status_code == 403 or answer.json().get("items") == [], (closed, answer.text)
    assert person.get(f"/v1/studios/{world.studio_id}/webhooks").status_code == 403


def test_who_approves_hands_over_first(server: RunningServer, leaver: Leaver) -> None:
    world = leaver.world
    for answer in (leaver.leave(), world.producer.put(leaver.path, json={"roles": ["reviewer"]})):
        assert refused(answer) == (409, "hand-over-needed")
        assert {problem["message"] for problem in answer.json()["errors"]} == {
            "the approver of Shield Wing",
            "the approver of Two",
        }
    for unfit in (world.reviewer_id, world.approver_id, world.stranger_id):
        answer = leaver.leave(hand_over_to=str(unfit))
        assert (*refused(answer), answer.json()["errors"][0]["where"]) == (422, "cannot-take-over", "hand_over_to")
    assert all(leaver.reaches().values())  # what is refused ends nothing
    shown = [(item["kind"], item["name"]) for item in world.producer.get(f"{leaver.path}/departure").json()]
    assert shown == [
        ("approver", "Shield Wing"),
        ("approver", "Two"),
        ("liaison", "Shield Wing"),
        ("category_approver", "ui"),
        ("deputy", "Producer"),
        ("deputy", "Producer"),
        ("token", "CI"),
        ("guest_link", "For the composer"),
        ("posting_link", "Effects for Alpha"),
        ("webhook", "https://hooks.example/in"),
    ]
    assert world.reviewer.get(f"{leaver.path}/departure").status_code == 403
    assert leaver.leave(hand_over_to=str(world.producer_id)).status_code == 204
    for project_id in (str(world.project_id), leaver.opened_project_id):
        project = body_of(world.producer.get(f"/v1/projects/{project_id}"))
        assert (project["approver"]["name"], project["category_approvers"], project["liaisons"]) == ("Producer", [], [])
    history = world.producer.get(f"/v1/projects/{world.project_id}/approver-history").json()
    assert history[0]["reason"] == "takes over from Audio director, who left the studio"
    assert body_of(world.producer.get(f"/v1/projects/{world.project_id}/deputies"))["deputies"] == []


def test_who_left_is_out_and_comes_back_with_the_new_role_alone(server: RunningServer, leaver: Leaver) -> None:
    world, stage = leaver.world, leaver.stage
    cue_id = stage.cue("door")
    ask(world, cue_id, "A drop, a tool, a person?")
    subjects, notices = news_for(server, world.approver_id)
    assert subjects
    assert notices
    assert all(leaver.reaches().values())
    assert leaver.leave(hand_over_to=str(world.producer_id)).status_code == 204
    assert not any(leaver.reaches().values())
    assert news_for(server, world.approver_id) == ([], 0)  # what was not sent is not sent any more
    ask(world, cue_id, "And how long?")
    assert news_for(server, world.approver_id) == ([], 0)
    assert world.approver.get(f"/v1/projects/{world.project_id}").status_code == 404
    assert world.approver.get("/v1/me/notices").json()["items"] == []
    rejoin(server, world, leaver.email, "reviewer")
    only_advises(world, stage, world.approver)
    assert not any(leaver.reaches().values())
    ask(world, cue_id, "Inside or outside?")
    assert news_for(server, world.approver_id) == ([], 0)


def test_a_lower_role_ends_what_it_does_not_allow(server: RunningServer, leaver: Leaver) -> None:
    world = leaver.world
    body = {"roles": ["reviewer"], "hand_over_to": str(world.producer_id)}
    before = news_for(server, world.approver_id)  # of the token that the studio made while they were a producer
    assert body_of(world.producer.put(leaver.path, json=body))["roles"] == ["reviewer"]
    only_advises(world, leaver.stage, world.approver)
    ask(world, leaver.stage.cue("door"), "A drop, a tool, a person?")
    assert news_for(server, world.approver_id) == before


def test_an_audio_lead_who_is_no_producer_any_more_goes_on_where_they_lead(leaver: Leaver) -> None:
    world = leaver.world
    answer = world.producer.put(leaver.path, json={"roles": ["liaison"]})
    assert refused(answer) == (409, "hand-over-needed")  # of the project that they opened, and do not lead
    assert [problem["message"] for problem in answer.json()["errors"]] == ["the approver of Two"]
    body = {"roles": ["liaison"], "hand_over_to": str(world.producer_id)}
    assert world.producer.put(leaver.path, json=body).status_code == 200
    assert body_of(world.approver.get(f"/v1/projects/{world.project_id}"))["mine"]["is_approver"] is True


def test_what_is_kept_goes_on_in_the_name_of_who_keeps_it(leaver: Leaver) -> None:
    world = leaver.world
    kept = {"keep": ["tokens", "guest_links", "posting_links", "webhooks"]}
    assert leaver.leave(hand_over_to=str(world.producer_id), **kept).status_code == 204
    reaches = leaver.reaches()
    assert reaches.pop("calendar") is False
    assert all(reaches.values()), reaches
    (token,) = world.producer.get(f"/v1/projects/{world.project_id}/tokens").json()
    assert token["creator"]["name"] == "Producer"
    (link,) = world.producer.get(f"/v1/projects/{world.project_id}/guest-links").json()["items"]
    assert link["made_by"]["name"] == "Producer"


def leave_rows_behind(world: World) -> Callable[[Session], None]:
    """Return what writes rows that name the reviewer, as no request would."""

    def add(session: Session) -> None:
        of = {"studio_id": world.studio_id, "project_id": world.project_id}
        session.add(Liaison(**of, person_id=world.reviewer_id))
        session.add(ApproverChange(**of, person_id=world.reviewer_id, reason="x", changed_by=world.producer_id))
        session.add(CategoryApprover(**of, category="ui", person_id=world.reviewer_id, named_by=world.producer_id))
        today = clock.now().date()
        days = {"from_on": today - timedelta(days=2), "until_on": today + timedelta(days=2)}
        pair = {"person_id": world.producer_id, "deputy_id": world.reviewer_id}
        session.add(Deputy(**of, **pair, **days, named_by=world.producer_id))

    return add


@pytest.mark.parametrize("is_member", [True, False])
def test_a_row_left_behind_gives_no_right_and_no_address(server: RunningServer, world: World, is_member: bool) -> None:
    """Rights and addresses follow the membership, whatever a row says; the first producer approves meanwhile."""
    stage = Stage(world)
    server.in_database(leave_rows_behind(world))
    if not is_member:
        gone = delete(Membership).where(Membership.person_id == world.reviewer_id)
        server.in_database(lambda session: session.execute(gone))
    else:
        only_advises(world, stage, world.reviewer)
    project = body_of(world.designer.get(f"/v1/projects/{world.project_id}"))
    assert (project["approver"]["name"], project["category_approvers"]) == ("Producer", [])
    assert [person["name"] for person in project["liaisons"]] == ["Audio director"]
    ask(world, stage.cue("laser"), "A drop, a tool, a person?")
    assert news_for(server, world.reviewer_id) == ([], 0)
    assert news_for(server, world.producer_id)[0] != []


def test_what_they_invited_and_what_waits_for_them_is_revoked(server: RunningServer, leaver: Leaver) -> None:
    world = leaver.world
    invitations = f"/v1/studios/{world.studio_id}/invitations"
    body = {"email": f"second-{world.studio_id}@studio.example", "roles": ["producer"]}
    assert world.approver.post(invitations, json=body).status_code == 201
    designer = {"email": f"third-{world.studio_id}@studio.example", "kind": "contract"}
    assert world.approver.post(f"/v1/projects/{world.project_id}/invitations", json=designer).status_code == 201
    secrets = [secret_for(server, str(one["email"])) for one in (body, designer)]
    assert leaver.leave(hand_over_to=str(world.producer_id)).status_code == 204
    assert world.nobody.get(f"/v1/studio-invitations/{secrets[0]}").status_code == 404
    assert world.nobody.get(f"/v1/invitations/{secrets[1]}").status_code == 404
    assert world.producer.get(invitations).json() == []
    assert mailed_links(server, leaver.email) == []


def test_who_is_to_sign_a_contract_that_was_sent_stays_until_it_is_recalled(
    server: RunningServer, leaver: Leaver
) -> None:
    world = leaver.world
    (engagement,) = body_of(world.producer.get(f"/v1/projects/{world.project_id}"))["engagements"]
    begun = {"engagement_id": engagement["id"], "kind": "nda", "title": "Secrecy"}
    contract = world.producer.post(f"/v1/projects/{world.project_id}/contracts", json=begun).json()
    body = {"person_ids": [str(world.approver_id)], "first": None}
    assert world.producer.put(f"/v1/contracts/{contract['id']}/signers", json=body).status_code == 200
    contract_id = UUID(contract["id"])

    def become(state: ContractState) -> Callable[[Session], None]:
        def write(session: Session) -> None:
            session.get_one(Contract, contract_id).state = state

        return write

    server.in_database(become(ContractState.SENT))
    answer = leaver.leave(hand_over_to=str(world.producer_id))
    assert refused(answer) == (409, "hand-over-needed")
    assert [problem["message"] for problem in answer.json()["errors"]] == [
        "signs Secrecy of Shield Wing for the studio"
    ]
    server.in_database(become(ContractState.DRAFT))
    assert leaver.leave(hand_over_to=str(world.producer_id)).status_code == 204
    named = select(ContractSigner.person_id).where(ContractSigner.contract_id == contract_id)
    assert server.in_database(lambda session: session.scalars(named).all()) == []
