"""Webhooks and their calls, read from the database."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import ColumnElement, func, not_, or_, select
from sqlalchemy.orm import Session, contains_eager, joinedload, selectinload

from app.projects.models import Project
from app.projects.visibility import is_closed_to
from app.webhooks.models import Webhook, WebhookAttempt, WebhookCall


def webhooks_of(session: Session, studio_id: UUID) -> Sequence[Webhook]:
    """Return a studio's webhooks with their projects, the oldest first."""
    of_it = select(Webhook).where(Webhook.studio_id == studio_id).options(joinedload(Webhook.project))
    return session.scalars(of_it.order_by(Webhook.id)).all()


def enabled_webhooks_by(session: Session, studio_id: UUID, person_id: UUID) -> Sequence[Webhook]:
    """Return the webhooks of a studio that a person added and that are called, with their projects."""
    return session.scalars(
        select(Webhook)
        .where(Webhook.studio_id == studio_id, Webhook.created_by == person_id, Webhook.disabled_at.is_(None))
        .options(joinedload(Webhook.project))
        .order_by(Webhook.id)
    ).all()


def webhooks_count(session: Session, studio_id: UUID) -> int:
    """Return the number of a studio's webhooks."""
    return session.scalar(select(func.count()).select_from(Webhook).where(Webhook.studio_id == studio_id)) or 0


def webhooks_called(session: Session, studio_id: UUID, project_id: UUID) -> Sequence[Webhook]:
    """Return the webhooks that are called for an event of a project: of it or all, by people who see it."""
    enabled = select(Webhook).where(
        Webhook.studio_id == studio_id,
        Webhook.disabled_at.is_(None),
        or_(Webhook.project_id.is_(None), Webhook.project_id == project_id),
        not_(is_closed_to(Webhook.created_by, studio_id=studio_id, project_id=project_id)),
    )
    return session.scalars(enabled.order_by(Webhook.id)).all()


def enabled_webhooks(session: Session, studio_id: UUID) -> Sequence[Webhook]:
    """Return the webhooks of a studio that are called for some event."""
    enabled = select(Webhook).where(Webhook.studio_id == studio_id, Webhook.disabled_at.is_(None))
    return session.scalars(enabled.order_by(Webhook.id)).all()


def webhook_in(
    session: Session, studio_ids: Collection[UUID], webhook_id: UUID, *, locked: bool = False
) -> Webhook | None:
    """Return a webhook of one of these studios, with its project; locked, it changes no more until the end."""
    webhook = select(Webhook).where(Webhook.id == webhook_id, Webhook.studio_id.in_(studio_ids))
    webhook = webhook.options(joinedload(Webhook.project))
    return session.scalar(webhook.with_for_update(of=Webhook) if locked else webhook)


def calls_of(session: Session, webhook_id: UUID, *, before: UUID | None, limit: int) -> Sequence[WebhookCall]:
    """Return a webhook's calls, newest first, with their attempts."""
    query = select(WebhookCall).where(WebhookCall.webhook_id == webhook_id).options(selectinload(WebhookCall.attempts))
    if before is not None:
        query = query.where(WebhookCall.id < before)
    return session.scalars(query.order_by(WebhookCall.id.desc()).limit(limit)).all()


def call_in(session: Session, studio_ids: Collection[UUID], call_id: UUID) -> WebhookCall | None:
    """Return a call of a webhook of one of these studios, with its webhook and its attempts."""
    query = select(WebhookCall).join(WebhookCall.webhook)
    query = query.where(WebhookCall.id == call_id, WebhookCall.studio_id.in_(studio_ids))
    return session.scalar(query.options(contains_eager(WebhookCall.webhook), selectinload(WebhookCall.attempts)))


def is_attempt_at(condition: ColumnElement[bool]) -> ColumnElement[bool]:
    """Whether an attempt is at one of the calls that a condition holds for."""
    return WebhookAttempt.call_id.in_(select(WebhookCall.id).where(condition))


def call_to_send(session: Session, call_id: UUID, attempt: UUID, *, locked: bool) -> WebhookCall | None:
    """Return a call with its webhook while this attempt at it is the one that is due, and the webhook is enabled."""
    due = select(WebhookCall).join(WebhookCall.webhook).options(contains_eager(WebhookCall.webhook))
    closed = is_closed_to(
        Webhook.created_by, studio_id=WebhookCall.studio_id, project_id=WebhookCall.project_id
    )  # to whoever has the webhook of a former member
    due = due.where(
        WebhookCall.id == call_id,
        WebhookCall.next_attempt == attempt,
        Webhook.disabled_at.is_(None),
        or_(WebhookCall.project_id.is_(None), not_(closed)),
    )
    return session.scalar(due.with_for_update(of=[WebhookCall, Webhook]) if locked else due)


def projects_of(session: Session, studio_id: UUID) -> Sequence[Project]:
    """Return the projects of a studio that are not archived, by name."""
    query = select(Project).where(Project.studio_id == studio_id, Project.archived_at.is_(None))
    return session.scalars(query.order_by(Project.name, Project.id)).all()
