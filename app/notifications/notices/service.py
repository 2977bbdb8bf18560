"""Notices in the app: what is mailed to a person, kept for them whether or not they want the mail."""

from collections.abc import Sequence
from datetime import datetime, timedelta
from typing import Any
from uuid import UUID

from sqlalchemy import ColumnElement, delete, literal_column, or_, update
from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.core.db import insert_if_absent, new_id
from app.core.in_array import in_array
from app.notifications import queries
from app.notifications.kinds import news_of
from app.notifications.models import Notice
from app.notifications.rules import Fold, folded_text

COUNTED = 99  # more is shown as "99+"
READ_KEPT_FOR = timedelta(days=90)
FOLDED_WITHIN = timedelta(hours=1)  # of the event before: a longer pause ends a review
IS_OPEN: ColumnElement[bool] = literal_column("is_open")  # the condition of their unique index
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
    facts = _facts(
        event_id=event_id,
        studio_id=studio_id,
        project_id=project_id,
        topic=topic,
        person_id=person_id,
        subject=subject,
        text=text,
        path=path,
    )
    insert_if_absent(session, Notice, facts, unique=("person_id", "topic", "event_id"))


def fold(
    session: Session,
    *,
    event_id: str,
    studio_id: UUID,
    project_id: UUID | None,
    topic: str,
    recipient: str,
    subject: Fold,
    lines: Sequence[str],
    path: str,
) -> None:
    """Add news to the person's unread notice of its topic, or begin one that further news is folded into."""
    person_id = queries.person_id_at(session, recipient)
    if person_id is None or queries.has_notice(session, person_id, topic, event_id):
        return
    now = clock.now()
    facts = _facts(
        event_id=event_id,
        studio_id=studio_id,
        project_id=project_id,
        topic=topic,
        person_id=person_id,
        subject=subject.subject(len(lines)),
        text=folded_text("", 0, lines),
        path=path,
    ) | {"event_ids": [event_id], "count": len(lines), "is_open": True}
    # What another job has just begun is joined; one whose review is over is closed, and another follows it.
    while (notice := queries.open_notice(session, person_id, topic)) is None or now - notice.created_at > FOLDED_WITHIN:
        if notice is not None:
            notice.is_open = False
            session.flush()
        if insert_if_absent(session, Notice, facts, unique=("person_id", "topic"), where=IS_OPEN):
            return
    notice.text = _cut(folded_text(notice.text, notice.count, lines))
    notice.count += len(lines)
    notice.subject = subject.subject(notice.count)
    notice.event_ids = [*notice.event_ids, event_id]
    notice.created_at = now


def _facts(*, topic: str, text: str, **facts: Any) -> dict[str, Any]:
    return facts | {
        "id": new_id(),
        "topic": topic,
        "event_ids": [],
        "count": 1,
        "is_open": False,
        "news": news_of(topic),
        "text": _cut(text),
        "created_at": clock.now(),
        "read_at": None,
    }


def _cut(text: str) -> str:
    return text if len(text) <= MAX_TEXT_CHARS else f"{text[: MAX_TEXT_CHARS - 1]}…"


def page(session: Session, actor: Actor, *, before: UUID | None, limit: int) -> Sequence[Notice]:
    """Return the caller's notices, newest first."""
    return queries.notices_of(session, actor.person, before=before, limit=limit)


def unread(session: Session, actor: Actor) -> int:
    """Return the number of the caller's unread notices; COUNTED + 1 for any number above."""
    return queries.unread_notices(session, actor.person, limit=COUNTED + 1)


def mark_read(session: Session, actor: Actor, *, ids: Sequence[UUID], up_to: UUID | None) -> None:
    """Mark the caller's notices of these ids as read, and all up to one; what came after it stays unread."""
    is_named: ColumnElement[bool] = in_array(Notice.id, ids)
    if up_to is not None:
        is_named = or_(is_named, Notice.id <= up_to)
    unread_ones = update(Notice).where(Notice.person_id == actor.person, Notice.read_at.is_(None), is_named)
    session.execute(unread_ones.values(read_at=clock.now(), is_open=False))


def delete_old(session: Session, now: datetime) -> None:
    """Delete notices that were read long ago."""
    session.execute(delete(Notice).where(Notice.read_at < now - READ_KEPT_FOR))
