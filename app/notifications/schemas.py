"""Answers of this room."""

from datetime import datetime
from uuid import UUID

from app.kit.http import Schema


class MailRead(Schema):
    """One mail of the studio's outbox."""

    id: UUID
    recipient: str
    subject: str
    text: str
    link: str | None
    created_at: datetime
    sent_at: datetime | None
    failure: str | None


class OutboxRead(Schema):
    """The studio's mails, and whether a server takes them."""

    can_send: bool
    mails: list[MailRead]
