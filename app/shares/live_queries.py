"""Sessions of playlists, read from and reported to the database; callers have checked access."""

from collections.abc import Sequence
from datetime import datetime
from uuid import UUID

from sqlalchemy import ColumnElement, and_, delete, select, update
from sqlalchemy.orm import Session, joinedload

from app.shares.models import LiveListener, LiveSession


def live_session(session: Session, playlist_id: UUID, *, locked: bool = False) -> LiveSession | None:
    """Return the session of a playlist, if it ever had one."""
    query = select(LiveSession).where(LiveSession.playlist_id == playlist_id)
    if locked:
        query = query.with_for_update().execution_options(populate_existing=True)
    return session.scalar(query)


def listeners_of(session: Session, playlist_id: UUID) -> Sequence[LiveListener]:
    """Return the people ever in the session of a playlist who did not leave it, in order of their names."""
    query = select(LiveListener).where(LiveListener.playlist_id == playlist_id).options(joinedload(LiveListener.person))
    return sorted(
        session.scalars(query.execution_options(populate_existing=True)), key=lambda listener: listener.person.name
    )


def listener(session: Session, playlist_id: UUID, person_id: UUID) -> LiveListener | None:
    """Return a person's place in a session, locked."""
    query = select(LiveListener).where(_is_place_of(playlist_id, person_id))
    return session.scalar(query.with_for_update().execution_options(populate_existing=True))


def report(session: Session, playlist_id: UUID, person_id: UUID, page_id: UUID | None, now: datetime) -> None:
    """Note that the page of a person that plays is open.

    A statement, not an object: a report changes nothing that other pages show, so they are not notified.
    """
    noted = update(LiveListener).where(_is_place_of(playlist_id, person_id))
    session.execute(noted.values(seen_at=now, page_id=page_id))


def leave(session: Session, playlist_id: UUID, person_id: UUID) -> None:
    """Forget that a person is in a session."""
    session.execute(delete(LiveListener).where(_is_place_of(playlist_id, person_id)))


def _is_place_of(playlist_id: UUID, person_id: UUID) -> ColumnElement[bool]:
    return and_(LiveListener.playlist_id == playlist_id, LiveListener.person_id == person_id)
