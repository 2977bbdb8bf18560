"""The endpoints of this room."""

from datetime import datetime
from uuid import UUID

from fastapi import APIRouter, Request

from app.accounts.errors import ProducerNeeded, RecentSignInNeeded, StudioNotFound, TooManyAttempts
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows, ensure_recent_sign_in
from app.accounts.web.request_limits import ensure_webhook_message_allowed
from app.core import clock
from app.core.web.http import BadCursor, CurrentRuntime, DbSession, Page, cursor_of, problems, uuid_cursor
from app.projects.errors import ProjectNotFound
from app.webhooks import service
from app.webhooks.errors import (
    WebhookAddressRefused,
    WebhookCallNotFound,
    WebhookDisabled,
    WebhookNotFound,
    WebhooksFull,
)
from app.webhooks.models import Webhook
from app.webhooks.rules import OLD_SECRET_FOR, WebhookEvent, is_old_secret_valid, secret_text
from app.webhooks.schemas import (
    WebhookAdd,
    WebhookCallRead,
    WebhookChange,
    WebhookProject,
    WebhookRead,
    WebhookSecretRead,
    WebhooksRead,
)

router = APIRouter(prefix="/v1", tags=["webhooks"])
PRODUCER: Actor = allows(Audience.PRODUCER)
RECENTLY_SIGNED_IN_PRODUCER: Actor = allows(Audience.PRODUCER, recent_sign_in=True)
PAGE = 50


def _read(webhook: Webhook, now: datetime) -> WebhookRead:
    is_rotated = is_old_secret_valid(webhook.rotated_at, now)
    return WebhookRead(
        id=webhook.id,
        url=webhook.url,
        form=webhook.form,
        events=[WebhookEvent(event) for event in webhook.events],
        project=WebhookProject.model_validate(webhook.project) if webhook.project else None,
        created_at=webhook.created_at,
        failing_since=webhook.failing_since,
        disabled_at=webhook.disabled_at,
        old_secret_until=webhook.rotated_at + OLD_SECRET_FOR if is_rotated and webhook.rotated_at else None,
    )


def _read_with_secret(webhook: Webhook, runtime: CurrentRuntime) -> WebhookSecretRead:
    secret = service.secret_of(runtime.settings.secret_key.get_secret_value(), webhook)
    return WebhookSecretRead(**dict(_read(webhook, clock.now())), secret=secret_text(secret))


@router.get("/studios/{studio_id}/webhooks", responses=problems(StudioNotFound, ProducerNeeded))
def list_webhooks(
    studio_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = PRODUCER
) -> WebhooksRead:
    """Return a studio's webhooks, without their secrets."""
    webhooks = service.webhooks_of(session, actor, studio_id)
    return WebhooksRead(
        items=[_read(webhook, clock.now()) for webhook in webhooks],
        projects=[WebhookProject.model_validate(project) for project in service.projects_of(session, studio_id)],
        may_be_localhost=runtime.settings.webhook_localhost,
    )


@router.post(
    "/studios/{studio_id}/webhooks",
    status_code=201,
    responses=problems(
        StudioNotFound, ProducerNeeded, RecentSignInNeeded, ProjectNotFound, WebhookAddressRefused, WebhooksFull
    ),
)
def add_webhook(
    studio_id: UUID,
    body: WebhookAdd,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = RECENTLY_SIGNED_IN_PRODUCER,
) -> WebhookSecretRead:
    """Add an address that is called for events; its secret is shown this once."""
    webhook = service.add(
        session,
        actor,
        studio_id,
        url=body.url,
        form=body.form,
        events=body.events,
        project_id=body.project_id,
        may_be_localhost=runtime.settings.webhook_localhost,
    )
    return _read_with_secret(webhook, runtime)


@router.patch("/webhooks/{webhook_id}", responses=problems(WebhookNotFound, RecentSignInNeeded, WebhookAddressRefused))
def change_webhook(
    webhook_id: UUID,
    body: WebhookChange,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = PRODUCER,
) -> WebhookRead:
    """Change the address or the events of a webhook, disable it, or let it be called again."""
    if body.url is not None:
        ensure_recent_sign_in(request)
    webhook = service.change(
        session,
        actor,
        webhook_id,
        url=body.url,
        events=body.events,
        enabled=body.enabled,
        may_be_localhost=runtime.settings.webhook_localhost,
    )
    return _read(webhook, clock.now())


@router.delete("/webhooks/{webhook_id}", status_code=204, responses=problems(WebhookNotFound))
def delete_webhook(webhook_id: UUID, session: DbSession, actor: Actor = PRODUCER) -> None:
    """Delete a webhook with its log."""
    service.remove(session, actor, webhook_id)


@router.post("/webhooks/{webhook_id}/secret", responses=problems(WebhookNotFound, RecentSignInNeeded))
def rotate_webhook_secret(
    webhook_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = RECENTLY_SIGNED_IN_PRODUCER
) -> WebhookSecretRead:
    """Return a new secret, shown this once; messages are signed by the old one too for a day."""
    return _read_with_secret(service.rotate_secret(session, actor, webhook_id), runtime)


@router.post(
    "/webhooks/{webhook_id}/test",
    status_code=202,
    responses=problems(WebhookNotFound, WebhookDisabled, TooManyAttempts),
)
def send_webhook_test(
    webhook_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = PRODUCER
) -> WebhookCallRead:
    """Send a message that says that it is a test."""
    ensure_webhook_message_allowed(session, service.webhook_for(session, actor, webhook_id).studio_id)
    call = service.send_test(session, actor, webhook_id, runtime.settings.base_url)
    return WebhookCallRead.model_validate(call)


@router.get("/webhooks/{webhook_id}/calls", responses=problems(WebhookNotFound, BadCursor))
def list_webhook_calls(
    webhook_id: UUID, session: DbSession, cursor: str | None = None, actor: Actor = PRODUCER
) -> Page[WebhookCallRead]:
    """Return the messages to an address with what was answered, newest first; they are kept for 30 days."""
    calls = service.calls_of(session, actor, webhook_id, before=uuid_cursor(cursor), limit=PAGE + 1)
    shown = calls[:PAGE]
    following = cursor_of(shown[-1].id) if len(calls) > PAGE else None
    return Page(items=[WebhookCallRead.model_validate(call) for call in shown], next=following)


@router.post(
    "/webhook-calls/{webhook_call_id}/replay",
    status_code=202,
    responses=problems(WebhookCallNotFound, WebhookDisabled, TooManyAttempts),
)
def replay_webhook_call(webhook_call_id: UUID, session: DbSession, actor: Actor = PRODUCER) -> WebhookCallRead:
    """Send a message again, with the same body and id."""
    call = service.replay(session, actor, webhook_call_id)
    ensure_webhook_message_allowed(session, call.studio_id)
    return WebhookCallRead.model_validate(call)
