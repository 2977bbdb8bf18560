"""A log of which rooms of which projects changed, read to keep open pages up to date.

Each transaction that writes rows of a studio adds one row for each project, in the same commit: the names of rooms, and
none of the data. Readers select new rows; a long transaction commits after rows with later ids, so
they look back over `LATE_S` and skip rows that they have seen.
"""

import time
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from datetime import timedelta
from typing import Any, NamedTuple
from uuid import UUID

import sqlalchemy as sa
from sqlalchemy import event
from sqlalchemy.orm import Mapped, ORMExecuteState, Session, UOWTransaction, mapped_column

from app.core.db import Base, Database, new_id

LATE_S = 5.0  # between the making of a row and its commit, and between the clocks of two machines
KEPT_FOR = timedelta(minutes=15)
CHANGED = "changed rooms"  # key in a session's info
OWN_ROOM = "core"  # uploads, saved answers, heartbeats: no page shows them


class ChangedRooms(Base):
    """The rooms that one transaction wrote in, for a project, or for a studio outside its projects."""

    __tablename__ = "core_changed_rooms"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)  # UUIDv7: in order of time
    studio_id: Mapped[UUID]
    project_id: Mapped[UUID | None]
    rooms: Mapped[list[str]]


class Scope(NamedTuple):
    """The scope of a change: a project, or a studio outside its projects."""

    studio_id: UUID
    project_id: UUID | None


class Change(NamedTuple):
    """One row of the log."""

    id: UUID
    scope: Scope
    rooms: frozenset[str]


def instant_id(at_s: float) -> UUID:
    """Return the id before every id that is made at this Unix time or later."""
    return UUID(int=max(0, int(at_s * 1000)) << 80)


def instant_of(id_: UUID) -> float:
    """Return the Unix time at which an id was made."""
    return (id_.int >> 80) / 1000


_ADD = sa.insert(ChangedRooms.__table__)  # type: ignore[arg-type]  # a Table, declared as a FromClause
_SINCE = (
    sa.select(ChangedRooms.id, ChangedRooms.studio_id, ChangedRooms.project_id, ChangedRooms.rooms)
    .where(ChangedRooms.id > sa.bindparam("since", type_=sa.Uuid()))
    .order_by(ChangedRooms.id)
)


def changes_since(database: Database, since: UUID) -> list[Change]:
    """Return the rows after an id, in order."""
    rows = database.read_autocommit(_SINCE, {"since": since})
    return [Change(row.id, Scope(row.studio_id, row.project_id), frozenset(row.rooms)) for row in rows]


def forget_old_changes(database: Database) -> None:
    """Delete rows that are no longer needed."""
    with database.writing() as session:
        oldest = instant_id(time.time() - KEPT_FOR.total_seconds())
        session.execute(sa.delete(ChangedRooms).where(ChangedRooms.id < oldest))


@event.listens_for(Session, "after_flush")
def _note_objects(session: Session, _context: UOWTransaction) -> None:
    for written in (
        *session.new,
        *session.deleted,
        *(changed for changed in session.dirty if session.is_modified(changed)),
    ):
        _note(session, type(written), written.__dict__.get("studio_id"), getattr(written, "project_id", None))


@event.listens_for(Session, "do_orm_execute")
def _note_inserted_rows(state: ORMExecuteState) -> None:
    """Record rows inserted by statements; statements that update or delete always come with objects of their room."""
    if not state.is_insert or not isinstance(state.statement, sa.Insert):
        return
    model = _models().get(state.statement.table.name)
    if model is None:
        return
    given: Mapping[str, Any] | Sequence[Mapping[str, Any]] = state.parameters or ()
    for row in (given,) if isinstance(given, Mapping) else given:
        _note(state.session, model, row.get("studio_id"), row.get("project_id"))


def _note(session: Session, model: type[Any], studio_id: UUID | None, project_id: UUID | None) -> None:
    room = model.__module__.split(".")[1]
    if studio_id is not None and room != OWN_ROOM:
        session.info.setdefault(CHANGED, defaultdict(set))[Scope(studio_id, project_id)].add(room)


@event.listens_for(Session, "before_commit")
def _write_down(session: Session) -> None:
    session.flush()
    changed: dict[Scope, set[str]] = session.info.pop(CHANGED, {})
    if changed:
        rows = [{"id": new_id(), **scope._asdict(), "rooms": sorted(rooms)} for scope, rooms in changed.items()]
        session.connection().execute(_ADD, rows)


@event.listens_for(Session, "after_rollback")
def _forget(session: Session) -> None:
    session.info.pop(CHANGED, None)


def _models() -> dict[str, type[Any]]:
    if not _by_table:
        _by_table.update({mapper.local_table.name: mapper.class_ for mapper in Base.registry.mappers})  # type: ignore[attr-defined]
    return _by_table


_by_table: dict[str, type[Any]] = {}


def merged(changes: Iterable[Change]) -> dict[Scope, set[str]]:
    """Return the rooms that changed, of each project."""
    rooms: dict[Scope, set[str]] = defaultdict(set)
    for change in changes:
        rooms[change.scope] |= change.rooms
    return rooms
