"""The tables of this room."""

from datetime import datetime
from uuid import UUID

from sqlalchemy import ForeignKey, Index, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.core import clock
from app.core.columns import Dated, StudioOwned
from app.core.db import Base, new_id
from app.projects.models import Project
from app.webhooks.rules import CallState, WebhookForm


class Webhook(StudioOwned, Dated, Base):
    """An address that is called when something happens in a project, or in any project of the studio.

    Its secret follows from the server's secret key, its id and `secret_number`, so that no table holds it.
    """

    __tablename__ = "webhooks_webhooks"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID | None] = mapped_column(ForeignKey("projects_projects.id"), index=True)  # None: all
    url: Mapped[str]
    form: Mapped[WebhookForm]
    events: Mapped[list[str]]
    secret_number: Mapped[int] = mapped_column(default=1)
    rotated_at: Mapped[datetime | None]
    failing_since: Mapped[datetime | None]  # the first failure since the last success
    disabled_at: Mapped[datetime | None]
    created_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    project: Mapped[Project | None] = relationship(lazy="raise")


class WebhookCall(StudioOwned, Base):
    """One message to one address, with what was answered last."""

    __tablename__ = "webhooks_calls"
    __table_args__ = (
        UniqueConstraint("webhook_id", "event_id"),  # an event is one call, however often its job runs
        Index("ix_webhooks_calls_log", "webhook_id", "id"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    webhook_id: Mapped[UUID] = mapped_column(ForeignKey("webhooks_webhooks.id"))
    project_id: Mapped[UUID | None] = mapped_column(ForeignKey("projects_projects.id"), index=True)  # None: a test
    event_id: Mapped[str]
    event: Mapped[str]
    body: Mapped[str]
    state: Mapped[CallState] = mapped_column(default=CallState.WAITING)
    tries: Mapped[int] = mapped_column(default=0)
    next_attempt: Mapped[UUID | None]  # which job may send it; None: none is due
    next_at: Mapped[datetime | None]
    tried_at: Mapped[datetime | None]
    took_ms: Mapped[int | None]
    status: Mapped[int | None]
    answer: Mapped[str] = mapped_column(default="")  # the beginning of the body that came back
    problem: Mapped[str] = mapped_column(default="")  # why it failed
    created_at: Mapped[datetime] = mapped_column(default=clock.now, index=True)
    webhook: Mapped[Webhook] = relationship(lazy="raise")
    attempts: Mapped[list["WebhookAttempt"]] = relationship(lazy="raise", order_by="WebhookAttempt.id")


class WebhookAttempt(StudioOwned, Base):
    """One sending of a message, with what was answered."""

    __tablename__ = "webhooks_attempts"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    call_id: Mapped[UUID] = mapped_column(ForeignKey("webhooks_calls.id"), index=True)
    tried_at: Mapped[datetime]
    took_ms: Mapped[int]
    status: Mapped[int | None]  # None: nothing was answered
    answer: Mapped[str]  # the beginning of the body that came back
    problem: Mapped[str]  # why it failed
