"""Nothing of a project reaches a member who may not see it: tokens, webhooks, the security log, mails, contracts."""

from dataclasses import dataclass
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa
from httpx2 import Client
from sqlalchemy.orm import Session

from app.accounts.models import Membership
from app.accounts.rules import Role
from app.accounts.security_log import service as security_log
from app.accounts.security_log.models import SecurityEvent
from app.accounts.security_log.rules import SecurityEventKind
from app.core.db import new_id
from app.notifications import mail_jobs
from app.notifications import queries as notification_queries
from app.notifications import service as notifications
from app.notifications.models import Mail
from app.operations.erasure.service import erase_project
from app.projects.models import Project, ProjectMember
from app.webhooks import queries as webhook_queries
from app.webhooks import service as webhooks
from app.webhooks.bodies import Message
from app.webhooks.models import Webhook
from app.webhooks.rules import WebhookEvent
from tests.app.agreements.conftest import Contracts
from tests.app.projects.test_members import add_producer, limit
from tests.app.reviews.making import refused
from tests.support.server import World
from tests.support.smtp import mail_server

pytestmark = pytest.mark.both_databases


@dataclass
class Hidden:
    """A project of a second producer, which the first does not see, and a third producer in it."""

    world: World
    project_id: UUID
    owner_id: UUID
    owner: Client
    other_id: UUID
    other: Client

    @property
    def path(self) -> str:
        return f"/v1/projects/{self.project_id}"

    @property
    def studio(self) -> str:
        return f"/v1/studios/{self.world.studio_id}"

    def remove_owner(self, **query: Any) -> None:
        """Remove the owner from the studio, as the producer who does not see the project."""
        query |= {"hand_over_to": str(self.other_id)}
        answer = self.world.producer.delete(f"{self.studio}/people/{self.owner_id}", params=query)
        assert answer.status_code == 204, answer.text
        assert self.world.producer.get(self.path).status_code == 404

    def token(self) -> Client:
        """Return a build with a token that the owner makes."""
        made = self.owner.post(f"{self.path}/tokens", json={"name": "Hidden CI", "scopes": ["spec:read"]})
        assert made.status_code == 201, made.text
        build = self.world.server.browser()
        build.headers["Authorization"] = f"Bearer {made.json()['secret']}"
        assert self.may_build(build)
        return build

    def may_build(self, build: Client) -> bool:
        return build.get(f"{self.path}/spec.toml").status_code == 200

    def webhook(self, project_id: UUID | None) -> dict[str, Any]:
        """Return a webhook of the owner, called once for the hidden project."""
        body = {"url": "https://hooks.example/in", "events": ["list.revised"]}
        body["project_id"] = str(project_id) if project_id else None
        answer = self.owner.post(f"{self.studio}/webhooks", json=body)
        assert answer.status_code == 201, answer.text

        def call(session: Session) -> None:
            webhook = session.get_one(Webhook, UUID(answer.json()["id"]))
            message = Message(WebhookEvent.LIST_REVISED, "Hidden Game: 3 sounds", "https://s.example/p")
            webhooks.write_call(session, webhook, "an event", message, project_id=self.project_id)

        self.world.server.in_database(call)
        return dict(answer.json())


@pytest.fixture
def hidden(world: World) -> Hidden:
    owner_id, owner = add_producer(world, "Owner")
    other_id, other = add_producer(world, "Third")
    limit(world)
    body = {"studio_id": str(world.studio_id), "name": "Hidden Game", "cue_prefix": "HG"}
    opened = owner.post("/v1/projects", json=body)
    assert opened.status_code == 201, opened.text
    added = owner.put(f"/v1/projects/{opened.json()['id']}/members/{other_id}")
    assert added.status_code == 204, added.text
    return Hidden(world, UUID(opened.json()["id"]), owner_id, owner, other_id, other)


def test_build_tokens_end_with_the_membership_of_their_maker(hidden: Hidden) -> None:
    build = hidden.token()
    hidden.remove_owner()
    assert not hidden.may_build(build)


def test_kept_build_tokens_are_in_the_name_of_a_producer_of_the_project(hidden: Hidden) -> None:
    build = hidden.token()
    hidden.remove_owner(keep=["tokens"])
    assert hidden.may_build(build)
    (token,) = hidden.other.get(f"{hidden.path}/tokens").json()
    assert token["creator"]["name"] == "Third"


def test_who_leaves_by_themselves_keeps_no_token(hidden: Hidden) -> None:
    build = hidden.token()
    query = {"hand_over_to": str(hidden.other_id), "keep": ["tokens", "webhooks"]}
    webhook = hidden.webhook(None)
    left = hidden.owner.delete(f"{hidden.studio}/people/{hidden.owner_id}", params=query)
    assert left.status_code == 204, left.text
    assert not hidden.may_build(build)
    with hidden.world.server.runtime.database.reading() as session:
        assert session.get_one(Webhook, UUID(webhook["id"])).disabled_at is not None


def test_a_kept_webhook_shows_no_message_about_it(hidden: Hidden) -> None:
    webhook = hidden.webhook(None)
    calls = f"/v1/webhooks/{webhook['id']}/calls"
    (call,) = hidden.owner.get(calls).json()["items"]
    hidden.remove_owner(keep=["webhooks"])
    answer = hidden.world.producer.get(calls)
    assert (answer.status_code, answer.json()["items"]) == (200, [])
    assert refused(hidden.world.producer.post(f"/v1/webhook-calls/{call['id']}/replay"))[0] == 404
    assert hidden.world.producer.delete(f"/v1/webhooks/{webhook['id']}").status_code == 204


def test_a_kept_webhook_of_the_project_goes_to_a_producer_in_it(hidden: Hidden) -> None:
    webhook = hidden.webhook(hidden.project_id)
    hidden.remove_owner(keep=["webhooks"])
    with hidden.world.server.runtime.database.reading() as session:
        kept = session.get_one(Webhook, UUID(webhook["id"]))
        assert (kept.created_by, kept.disabled_at) == (hidden.other_id, None)
    assert hidden.world.producer.get(f"/v1/webhooks/{webhook['id']}/calls").status_code == 404


def test_a_message_that_waits_is_not_sent_for_who_may_not_see_it(hidden: Hidden) -> None:
    webhook = hidden.webhook(None)

    def due(session: Session) -> bool:
        (call,) = webhook_queries.calls_of(session, UUID(webhook["id"]), before=None, limit=9)
        assert call.next_attempt is not None
        return webhook_queries.call_to_send(session, call.id, call.next_attempt, locked=True) is not None

    assert hidden.world.server.in_database(due)
    hidden.remove_owner(keep=["webhooks"])
    assert not hidden.world.server.in_database(due)


def log_of(browser: Client, hidden: Hidden) -> list[str]:
    answer = browser.get(f"{hidden.studio}/security-events")
    assert answer.status_code == 200, answer.text
    return [line["summary"] for line in answer.json()["items"]]


def test_the_security_log_shows_lines_of_projects_that_the_reader_sees(hidden: Hidden) -> None:
    hidden.token()
    hidden.webhook(hidden.project_id)
    (token,) = hidden.owner.get(f"{hidden.path}/tokens").json()
    assert hidden.owner.delete(f"{hidden.path}/tokens/{token['id']}").status_code == 204
    of_project = [
        "revoked the build token Hidden CI",
        "added a webhook to hooks.example",
        "made the build token Hidden CI",
    ]
    assert log_of(hidden.owner, hidden)[:3] == of_project
    assert not set(of_project) & set(log_of(hidden.world.producer, hidden))
    assert "Hidden CI" not in hidden.world.producer.get(f"{hidden.studio}/security-events.csv").text


def test_the_security_log_outlives_the_project(hidden: Hidden) -> None:
    def act(session: Session) -> UUID:
        of = {"studio_ids": [hidden.world.studio_id], "project_id": hidden.project_id, "person_id": hidden.owner_id}
        security_log.record(session, SecurityEventKind.EXPORT, "downloaded a file", **of)
        erase_project(session, hidden.project_id)
        return hidden.project_id

    hidden.world.server.in_database(act)
    assert "downloaded a file" in log_of(hidden.owner, hidden)
    with hidden.world.server.runtime.database.reading() as session:
        of_project = sa.select(SecurityEvent.id).where(SecurityEvent.project_id == hidden.project_id)
        assert session.scalars(of_project).all() == []


def address(person_id: UUID) -> str:
    return f"{person_id}@example.test"


def write_news(hidden: Hidden, person_id: UUID, *project_ids: UUID) -> None:
    """Write news of projects to a person, to be sent later."""

    def write(session: Session) -> None:
        for project_id in project_ids:
            notifications.write_news(
                session,
                event_id=str(new_id()),
                studio_id=hidden.world.studio_id,
                project_id=project_id,
                topic=f"list:{project_id}",
                recipient=address(person_id),
                subject=f"news of {project_id}",
                lines=["A line."],
                base_url="https://s.example",
                path="/desk",
                delay_s=3600,
            )

    hidden.world.server.in_database(write)


def send_all(hidden: Hidden, person_id: UUID) -> None:
    """Send the mails of a person that wait, as if their time had come."""
    with hidden.world.server.runtime.database.reading() as session:
        waiting = sa.select(Mail.id).where(Mail.recipient == address(person_id), Mail.sent_at.is_(None))
        mail_ids = session.scalars(waiting).all()
    for mail_id in mail_ids:
        mail_jobs.send_mail(hidden.world.server.runtime, {"mail_id": str(mail_id)})


def test_mails_that_wait_are_not_sent_to_who_was_removed_meanwhile(hidden: Hidden) -> None:
    with mail_server(hidden.world.server) as mails:
        write_news(hidden, hidden.other_id, hidden.project_id)
        assert hidden.owner.delete(f"{hidden.path}/members/{hidden.other_id}").status_code == 204
        send_all(hidden, hidden.other_id)
        assert mails.texts_for(address(hidden.other_id)) == []


def test_a_digest_leaves_out_the_lines_of_projects_that_its_reader_lost(hidden: Hidden) -> None:
    wishes = {"cadences": {"list": "daily"}, "time_zone": "UTC", "daily_at": "08:00"}
    assert hidden.other.put("/v1/me/mail-preferences", json=wishes).status_code == 200
    page = f"/v1/projects/{hidden.world.project_id}/members/{hidden.other_id}"
    assert hidden.world.producer.put(page).status_code == 204
    with mail_server(hidden.world.server) as mails:
        write_news(hidden, hidden.other_id, hidden.project_id, hidden.world.project_id)
        assert hidden.owner.delete(f"{hidden.path}/members/{hidden.other_id}").status_code == 204
        send_all(hidden, hidden.other_id)
        (text,) = mails.texts_for(address(hidden.other_id))
    assert f"news of {hidden.world.project_id}" in text
    assert f"news of {hidden.project_id}" not in text


def test_a_digest_of_several_projects_is_sent_again_by_nobody_who_sees_some_only(hidden: Hidden) -> None:
    wishes = {"cadences": {"list": "daily"}, "time_zone": "UTC", "daily_at": "08:00"}
    assert hidden.other.put("/v1/me/mail-preferences", json=wishes).status_code == 200
    write_news(hidden, hidden.other_id, hidden.project_id)
    with hidden.world.server.runtime.database.reading() as session:
        mail_id = session.scalars(sa.select(Mail.id).where(Mail.recipient == address(hidden.other_id))).one()
    assert refused(hidden.world.producer.post(f"/v1/mails/{mail_id}/send"))[0] == 404


def test_an_erasure_is_announced_to_who_sees_the_project(hidden: Hidden) -> None:
    asked = hidden.owner.post(f"{hidden.path}/erasure", json={"confirmation": "Hidden Game"})
    assert asked.status_code == 200, asked.text
    assert hidden.owner.delete(f"{hidden.path}/erasure").status_code == 204
    with hidden.world.server.runtime.database.reading() as session:
        about = sa.select(Mail.recipient).where(Mail.subject.contains("Hidden Game"))
        about = about.where(Mail.studio_id == hidden.world.studio_id)
        assert set(session.scalars(about)) == {address(hidden.owner_id), address(hidden.other_id)}
    assert "Hidden Game" not in hidden.world.producer.get(f"{hidden.studio}/outbox").text


def test_producers_and_implementers_who_are_written_to_see_the_project(hidden: Hidden) -> None:
    add_producer(hidden.world, "An implementer", Role.IMPLEMENTER)
    with hidden.world.server.runtime.database.reading() as session:
        project = session.get_one(Project, hidden.project_id)
        assert notification_queries.implementer_addresses(session, project) == {
            address(hidden.owner_id),
            address(hidden.other_id),
        }


def test_a_candidates_news_are_in_the_outbox_of_who_sees_the_project(hidden: Hidden) -> None:
    cue = {"name": "Door", "file_name": "door"}
    assert hidden.owner.post(f"{hidden.path}/cues", json={"cues": [cue]}).is_success
    posting = hidden.owner.post(f"{hidden.path}/postings", json={"title": "Hidden effects"}).json()
    assert hidden.owner.post(f"/v1/postings/{posting['id']}/open").status_code == 200
    secret = hidden.owner.post(f"/v1/postings/{posting['id']}/link").json()["url"].rpartition("/")[2]
    stranger = hidden.world.stranger
    assert stranger.post(f"/v1/posting-links/{secret}/join").is_success
    asked = stranger.post(f"/v1/postings/{posting['id']}/questions", json={"text": "How long?"})
    assert asked.is_success, asked.text
    (question,) = asked.json()["questions"]
    answer = {"text": "Two weeks.", "is_for_all": True}
    answered = hidden.owner.post(f"/v1/posting-questions/{question['id']}/answer", json=answer)
    assert answered.is_success, answered.text
    hidden.world.server.wait_for_jobs()
    assert "Hidden effects: a question" in hidden.owner.get(f"{hidden.studio}/outbox").text
    assert "Hidden effects" not in hidden.world.producer.get(f"{hidden.studio}/outbox").text


def contract_signed_by(world: World, person_id: UUID, *, sent: bool = False) -> dict[str, Any]:
    """Return a contract of the visible project that a producer is named to sign."""
    contracts = Contracts(world)
    draft = contracts.begin()
    answer = world.producer.put(f"/v1/contracts/{draft['id']}/signers", json={"person_ids": [str(person_id)]})
    assert answer.status_code == 200, answer.text
    return contracts.send(draft) if sent else draft


def test_a_signer_is_in_the_project_and_stays_until_another_is_named(hidden: Hidden) -> None:
    world = hidden.world
    page = f"/v1/projects/{world.project_id}"
    assert hidden.other.get(page).status_code == 404
    draft = contract_signed_by(world, hidden.other_id)
    assert hidden.other.get(page).status_code == 200
    kept = world.producer.delete(f"{page}/members/{hidden.other_id}")
    assert refused(kept) == (409, "member-needed")
    assert "named to sign a contract" in kept.json()["detail"]
    assert world.producer.put(f"/v1/contracts/{draft['id']}/signers", json={"person_ids": []}).status_code == 200
    assert world.producer.delete(f"{page}/members/{hidden.other_id}").status_code == 204


def test_signers_are_in_their_projects_when_the_setting_is_turned_on(world: World) -> None:
    signer_id, signer = add_producer(world)
    contract_signed_by(world, signer_id)

    def leave(session: Session) -> None:
        session.execute(sa.delete(ProjectMember).where(ProjectMember.person_id == signer_id))

    world.server.in_database(leave)
    limit(world)
    assert signer.get(f"/v1/projects/{world.project_id}").status_code == 200


def test_a_contract_that_waits_is_not_named_to_who_does_not_see_its_project(hidden: Hidden) -> None:
    world = hidden.world
    contract = contract_signed_by(world, hidden.other_id, sent=True)
    query = {"hand_over_to": str(hidden.owner_id)}
    removed = hidden.owner.delete(f"{hidden.studio}/people/{hidden.other_id}", params=query)
    assert refused(removed) == (409, "hand-over-needed")
    assert removed.json()["detail"] == "they are named to sign 1 contract in a project that you are not in"
    assert removed.json()["errors"] == []
    assert contract["title"] in world.producer.delete(f"{hidden.studio}/people/{hidden.other_id}").json()["detail"]


def test_an_engaged_member_works_on_their_project(hidden: Hidden) -> None:
    world = hidden.world

    def join(session: Session) -> None:
        session.add(Membership(studio_id=world.studio_id, person_id=world.designer_id, roles=[Role.PRODUCER]))

    world.server.in_database(join)
    page = f"/v1/projects/{world.project_id}"
    assert world.designer.get(page).status_code == 200
    made = world.designer.post(f"{page}/postings", json={"title": "Effects"})
    assert made.status_code == 201, made.text
    assert world.designer.get(f"{page}/members").status_code == 200
