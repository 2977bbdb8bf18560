"""Notices in the app: what is mailed to a person, kept for them whether or not they want the mail."""

from collections.abc import Sequence
from datetime import datetime, timedelta
from uuid import UUID

from sqlalchemy import ColumnElement, delete, or_, update
from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.kit import clock
from app.kit.db import insert_if_absent, new_id
from app.kit.in_array import in_array
from app.notifications import queries
from app.notifications.models import Notice
from app.notifications.preference_rules import news_of

COUNTED = 99  # more is shown as "99+"
READ_KEPT_FOR = timedelta(days=90)
MAX_TEXT_CHARS = 2_000  # what a list shows; the mail and the page have the whole text


def add(
    session: Session,
    *,
    event_id: str,
    studio_id: UUID,
    project_id: UUID | None,
    topic: str,
    recipient: str,
    subject: str,
    text: str,
    path: str,
) -> None:
    """Keep news for the person of an address, once for each event; an address without an account has no notices."""
    person_id = queries.person_id_at(session, recipient)
    if person_id is None:
        return
    facts = {
        "id": new_id(),
        "person_id": person_id,
        "studio_id": studio_id,
        "project_id": project_id,
        "topic": topic,
        "event_id": event_id,
        "news": news_of(topic),
        "subject": subject,
        "text": text if len(text) <= MAX_TEXT_CHARS else f"{text[: MAX_TEXT_CHARS - 1]}…",
        "path": path,
        "created_at": clock.now(),
        "read_at": None,
    }
    insert_if_absent(session, Notice, facts, unique=("person_id", "topic", "event_id"))


def page(session: Session, actor: Actor, *, before: UUID | None, limit: int) -> Sequence[Notice]:
    """Return the caller's notices, newest first."""
    return queries.notices_of(session, actor.person, before=before, limit=limit)


def unread(session: Session, actor: Actor) -> int:
    """Return how many notices the caller has not read; COUNTED + 1 for any number above."""
    return queries.unread_notices(session, actor.person, limit=COUNTED + 1)


def mark_read(session: Session, actor: Actor, *, ids: Sequence[UUID], up_to: UUID | None) -> None:
    """Mark the caller's notices of these ids as read, and all up to one; what came after it stays unread."""
    wanted: ColumnElement[bool] = in_array(Notice.id, ids)
    if up_to is not None:
        wanted = or_(wanted, Notice.id <= up_to)
    unread_ones = update(Notice).where(Notice.person_id == actor.person, Notice.read_at.is_(None), wanted)
    session.execute(unread_ones.values(read_at=clock.now()))


def delete_old(session: Session, now: datetime) -> None:
    """Delete notices that were read long ago."""
    session.execute(delete(Notice).where(Notice.read_at < now - READ_KEPT_FOR))
