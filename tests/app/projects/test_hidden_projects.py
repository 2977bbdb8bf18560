"""Nothing of a project reaches a member who may not see it: tokens, webhooks, the security log, mails, contracts."""

from dataclasses import dataclass
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa
from fastapi.testclient import TestClient
from sqlalchemy.orm import Session

from app.accounts.security_log import service as security_log
from app.accounts.security_log.models import SecurityEvent
from app.accounts.security_log.rules import SecurityEventKind
from app.operations.erasure.service import erase_project
from app.webhooks import queries as webhook_queries
from app.webhooks import service as webhooks
from app.webhooks.bodies import Message
from app.webhooks.models import Webhook
from app.webhooks.rules import WebhookEvent
from tests.app.projects.test_members import add_producer, limit
from tests.app.reviews.making import refused
from tests.support.server import World

pytestmark = pytest.mark.both_databases


@dataclass
class Hidden:
    """A project of a second producer, which the first does not see, and a third producer in it."""

    world: World
    project_id: UUID
    owner_id: UUID
    owner: TestClient
    other_id: UUID
    other: TestClient

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

    def token(self) -> TestClient:
        """Return a build with a token that the owner makes."""
        made = self.owner.post(f"{self.path}/tokens", json={"name": "Hidden CI", "scopes": ["spec:read"]})
        assert made.status_code == 201, made.text
        build = self.world.server.browser()
        build.headers["Authorization"] = f"Bearer {made.json()['secret']}"
        assert self.may_build(build)
        return build

    def may_build(self, build: TestClient) -> bool:
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


def log_of(browser: TestClient, hidden: Hidden) -> list[str]:
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
