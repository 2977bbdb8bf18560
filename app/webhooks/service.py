"""Webhooks of a studio: set by its producers, called for events."""

from collections.abc import Mapping, Sequence
from datetime import datetime
from typing import Any
from urllib.parse import urlsplit
from uuid import UUID

from sqlalchemy import delete
from sqlalchemy.orm import Session

from app.accounts.rules import AccessKind, Actor, MemberChange, Role
from app.accounts.security_log.rules import SecurityEventKind
from app.accounts.security_log.service import record
from app.accounts.service import ensure_producer_of
from app.core import clock
from app.core.db import bypass_row_policies, insert_if_absent, new_id
from app.core.jobs.queue import BULK, queue_of
from app.core.outgoing import AddressRefused, ensure_address
from app.core.server_keys import derived
from app.projects.members.queries import is_open_to
from app.projects.members.service import producer_of
from app.projects.models import Project
from app.projects.service import project_access
from app.webhooks import queries
from app.webhooks.bodies import Message, body_of
from app.webhooks.errors import (
    WebhookAddressRefused,
    WebhookCallNotFound,
    WebhookDisabled,
    WebhookNotFound,
    WebhooksFull,
)
from app.webhooks.models import Webhook, WebhookAttempt, WebhookCall
from app.webhooks.rules import (
    CALLS_KEPT_FOR,
    EVENTS,
    MAX_WEBHOOKS,
    CallState,
    WebhookEvent,
    WebhookForm,
    is_old_secret_valid,
)

SECRET_BYTES = 32
WRITE_CALLS, SEND_CALL = "webhooks.write_calls", "webhooks.send_call"


def secret_of(secret_key: str, webhook: Webhook, number: int | None = None) -> bytes:
    """Return the secret that a webhook's messages are signed by, or an earlier one by its number."""
    return derived(secret_key, f"webhook:{webhook.id}:{number or webhook.secret_number}", SECRET_BYTES)


def valid_secrets(secret_key: str, webhook: Webhook, now: datetime) -> list[bytes]:
    """Return the secrets that sign now: the newest, and for a day the one before."""
    secrets = [secret_of(secret_key, webhook)]
    if is_old_secret_valid(webhook.rotated_at, now):
        secrets.append(secret_of(secret_key, webhook, webhook.secret_number - 1))
    return secrets


def webhooks_of(session: Session, actor: Actor, studio_id: UUID) -> Sequence[Webhook]:
    """Return a studio's webhooks, for its producers."""
    ensure_producer_of(session, actor, studio_id)
    return [webhook for webhook in queries.webhooks_of(session, studio_id) if _is_seen(actor, webhook)]


def projects_of(session: Session, studio_id: UUID) -> Sequence[Project]:
    """Return the projects that a studio's webhooks can be called for."""
    return queries.projects_of(session, studio_id)


def add(
    session: Session,
    actor: Actor,
    studio_id: UUID,
    *,
    url: str,
    form: WebhookForm,
    events: Sequence[WebhookEvent],
    project_id: UUID | None,
    may_be_localhost: bool,
) -> Webhook:
    """Add a webhook, as a producer."""
    ensure_producer_of(session, actor, studio_id)
    _ensure_address(url, may_be_localhost=may_be_localhost)
    project = None
    if project_id is not None:
        project = project_access(session, actor, project_id).project
        ensure_producer_of(session, actor, project.studio_id)
    with bypass_row_policies(session):  # the limit counts those of projects that the producer is not in
        count = queries.webhooks_count(session, studio_id)
    if count >= MAX_WEBHOOKS:
        raise WebhooksFull(f"a studio has {MAX_WEBHOOKS} webhooks at most", fix="delete one that is not used")
    webhook = Webhook(
        studio_id=studio_id if project is None else project.studio_id,
        project_id=project_id,
        url=url,
        form=form,
        events=sorted(set(events)),
        created_by=actor.person,
    )
    session.add(webhook)
    session.flush()
    session.refresh(webhook, ["project"])
    _record(session, actor, webhook, "added a webhook to")
    return webhook


def change(
    session: Session,
    actor: Actor,
    webhook_id: UUID,
    *,
    url: str | None,
    events: Sequence[WebhookEvent] | None,
    enabled: bool | None,
    may_be_localhost: bool,
) -> Webhook:
    """Change a webhook's address or events, disable it, or let it be called again."""
    webhook = webhook_for(session, actor, webhook_id)
    if url is not None:
        _ensure_address(url, may_be_localhost=may_be_localhost)
        webhook.url = url
        _record(session, actor, webhook, "changed the address of a webhook to")
    if events is not None:
        webhook.events = sorted(set(events))
    if enabled is True:
        webhook.disabled_at = webhook.failing_since = None
    elif enabled is False:
        webhook.disabled_at = webhook.disabled_at or clock.now()
    session.flush()
    return webhook


def rotate_secret(session: Session, actor: Actor, webhook_id: UUID) -> Webhook:
    """Give a webhook a new secret; the one before signs beside it for a day."""
    webhook = webhook_for(session, actor, webhook_id)
    webhook.secret_number += 1
    webhook.rotated_at = clock.now()
    session.flush()
    return webhook


def remove(session: Session, actor: Actor, webhook_id: UUID) -> None:
    """Delete a webhook with its calls, once an attempt at one that is being recorded has ended."""
    webhook = webhook_for(session, actor, webhook_id, locked=True)
    with bypass_row_policies(session):  # it may have calls for projects that the producer is not in
        session.execute(delete(WebhookAttempt).where(queries.is_attempt_at(WebhookCall.webhook_id == webhook.id)))
        session.execute(delete(WebhookCall).where(WebhookCall.webhook_id == webhook.id))
        session.delete(webhook)
        session.flush()
    _record(session, actor, webhook, "deleted the webhook to")


def disable_webhooks_of_member(session: Session, payload: Mapping[str, Any]) -> None:
    """Disable the webhooks of who left the studio, or keep them in another name: a handler of `member.changed`."""
    change = MemberChange.of(payload)
    if not change.has_left:
        return
    for webhook in queries.enabled_webhooks_by(session, change.studio_id, change.person_id):
        webhook.created_by = _successor(session, webhook, change)
        if AccessKind.WEBHOOKS not in change.kept:
            webhook.disabled_at = clock.now()
    session.flush()


def _successor(session: Session, webhook: Webhook, change: MemberChange) -> UUID:
    """Return the next owner of a former member's webhook: the remover, or a producer of its project."""
    if webhook.project is None or is_open_to(session, webhook.project, change.changed_by):
        return change.changed_by
    return producer_of(session, webhook.project)


def send_test(session: Session, actor: Actor, webhook_id: UUID, base_url: str) -> WebhookCall:
    """Send a message that says that it is a test."""
    webhook = webhook_for(session, actor, webhook_id, locked=True)
    _ensure_enabled(webhook)
    text = "Soundlist: this is a test. Messages about your projects will arrive here."
    test = Message(WebhookEvent.TEST, text, base_url)
    write_call(session, webhook, str(new_id()), test, project_id=webhook.project_id)
    return queries.calls_of(session, webhook.id, before=None, limit=1)[0]


def calls_of(
    session: Session, actor: Actor, webhook_id: UUID, *, before: UUID | None, limit: int
) -> Sequence[WebhookCall]:
    """Return a webhook's calls, newest first."""
    webhook = webhook_for(session, actor, webhook_id)
    return queries.calls_of(session, webhook.id, before=before, limit=limit)


def replay(session: Session, actor: Actor, call_id: UUID) -> WebhookCall:
    """Send a call again at once, whatever happened to it; its attempts are counted from the start."""
    call = queries.call_in(session, _studios_run_by(actor), call_id)
    if call is None or not _is_seen(actor, call.webhook):
        raise WebhookCallNotFound(f"no call {call_id}")
    _ensure_enabled(call.webhook)
    call.state, call.tries = CallState.WAITING, 0
    schedule(session, call, delay_s=0)
    return call


def webhook_for(session: Session, actor: Actor, webhook_id: UUID, *, locked: bool = False) -> Webhook:
    """Return a webhook of a studio that the caller runs; raise WebhookNotFound."""
    webhook = queries.webhook_in(session, _studios_run_by(actor), webhook_id, locked=locked)
    if webhook is None or not _is_seen(actor, webhook):
        raise WebhookNotFound(f"no webhook {webhook_id}")
    return webhook


def _is_seen(actor: Actor, webhook: Webhook) -> bool:
    """Whether a producer sees a webhook: one of all projects is its maker's where producers see their own only."""
    is_limited = webhook.studio_id in actor.limited_studio_ids
    return not is_limited or webhook.project_id is not None or webhook.created_by == actor.person_id


def _studios_run_by(actor: Actor) -> list[UUID]:
    return [studio_id for studio_id, roles in actor.roles.items() if Role.PRODUCER in roles]


def _record(session: Session, actor: Actor, webhook: Webhook, act: str) -> None:
    summary = f"{act} {urlsplit(webhook.url).hostname}"  # the rest of an address may hold a secret
    record(
        session,
        SecurityEventKind.WEBHOOK,
        summary,
        studio_ids=[webhook.studio_id],
        project_id=webhook.project_id,
        person_id=actor.person,
    )


def _ensure_enabled(webhook: Webhook) -> None:
    if webhook.disabled_at is not None:
        raise WebhookDisabled("this webhook is disabled", fix="enable it first")


def _ensure_address(url: str, *, may_be_localhost: bool) -> None:
    try:
        ensure_address(url, may_be_localhost=may_be_localhost)
    except AddressRefused as error:
        raise WebhookAddressRefused(
            str(error), errors=[{"where": "url", "message": str(error)}], fix="give an https address of a public host"
        ) from None


def queue_event(session: Session, payload: Mapping[str, Any]) -> None:
    """Queue the messages of an event where a webhook of its studio is called for it: a handler of `publish`."""
    studio_id = UUID(payload["studio_id"])
    with bypass_row_policies(session):  # designers read no webhooks, and what they do is an event too
        webhooks = queries.enabled_webhooks(session, studio_id)
    if any(EVENTS[payload["event"]] in webhook.events for webhook in webhooks):
        key = f"{payload['event_id']}:{WRITE_CALLS}"
        queue_of(session).enqueue(session, WRITE_CALLS, dict(payload), key=key, studio_id=studio_id, priority=BULK)


def write_call(session: Session, webhook: Webhook, event_id: str, message: Message, *, project_id: UUID | None) -> None:
    """Write one message about a project for one address, once for each event, and have it sent."""
    now = clock.now()
    call_id = new_id()
    facts = {
        "id": call_id,
        "studio_id": webhook.studio_id,
        "webhook_id": webhook.id,
        "project_id": project_id,
        "event_id": event_id,
        "event": message.event,
        "body": body_of(webhook.form, message, now),
        "state": CallState.WAITING,
        "tries": 0,
        "answer": "",
        "problem": "",
        "created_at": now,
    }
    if insert_if_absent(session, WebhookCall, facts, unique=("webhook_id", "event_id")):
        schedule(session, session.get_one(WebhookCall, call_id), delay_s=0)


def schedule(session: Session, call: WebhookCall, *, delay_s: float) -> None:
    """Write the job of the next attempt at a call; earlier ones that still wait do nothing."""
    call.next_attempt = new_id()
    call.next_at = clock.now()
    session.flush()
    payload = {"call_id": str(call.id), "attempt": str(call.next_attempt)}
    key = f"{call.next_attempt}:{SEND_CALL}"
    queue_of(session).enqueue(
        session, SEND_CALL, payload, key=key, studio_id=call.studio_id, priority=BULK, delay_s=delay_s
    )


def delete_old_calls(session: Session, now: datetime) -> None:
    """Delete calls sent long ago from the log."""
    is_old = WebhookCall.created_at < now - CALLS_KEPT_FOR
    session.execute(delete(WebhookAttempt).where(queries.is_attempt_at(is_old)))
    session.execute(delete(WebhookCall).where(is_old))
