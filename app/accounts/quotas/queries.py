"""Studios' use of limited things, and the limits that are their own."""

from collections import defaultdict
from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy import BindParameter, ColumnElement, Select, bindparam, func, select, union_all
from sqlalchemy.orm import InstrumentedAttribute, Session

from app.accounts.models import Membership, Person, Quota, Studio, Token
from app.core import clock


class Usage:
    """The amount of one limited resource: rows, or bytes of files, where the same bytes count once for each studio."""

    def __init__(
        self,
        studio_id: InstrumentedAttribute[UUID],
        *conditions: ColumnElement[bool],
        sha256: InstrumentedAttribute[Any] | None = None,
        size_bytes: InstrumentedAttribute[Any] | None = None,
        also: "Usage | None" = None,
    ) -> None:
        self._studio_id = studio_id
        self._conditions = conditions
        self._sha256: Any = sha256
        self._size_bytes: Any = size_bytes
        self._also = also  # files of another table that count too

    def __call__(self, session: Session, studio_id: UUID) -> int:
        """Return the amount that one studio has."""
        return dict(self._rows(session, studio_id)).get(studio_id, 0)

    def by_studio(self, session: Session) -> dict[UUID, int]:
        """Return the amount of each studio that has any, by one statement."""
        return dict(self._rows(session))

    def _rows(self, session: Session, studio_id: UUID | None = None) -> list[tuple[UUID, int]]:
        return [(owner_id, int(amount or 0)) for owner_id, amount in session.execute(self._statement(studio_id))]

    def _statement(self, studio_id: UUID | None) -> Select[UUID, Any]:
        if self._sha256 is None:
            return select(self._studio_id, func.count()).where(*self._of(studio_id)).group_by(self._studio_id)
        files = self._files(studio_id)
        if self._also is not None:
            both = union_all(files, self._also._files(studio_id)).subquery()
            size = func.max(both.c.size_bytes).label("size_bytes")
            files = select(both.c.studio_id, both.c.sha256, size).group_by(both.c.studio_id, both.c.sha256)
        file = files.subquery()
        return select(file.c.studio_id, func.sum(file.c.size_bytes)).group_by(file.c.studio_id)

    def _files(self, studio_id: UUID | None) -> Select[Any, Any, Any]:
        size = func.max(self._size_bytes).label("size_bytes")
        files = select(self._studio_id.label("studio_id"), self._sha256.label("sha256"), size)
        return files.where(*self._of(studio_id)).group_by(self._studio_id, self._sha256)

    def _of(self, studio_id: UUID | None) -> list[ColumnElement[bool]]:
        return [*self._conditions, *([] if studio_id is None else [self._studio_id == studio_id])]


def studios_opened_by(session: Session, person_id: UUID) -> int:
    """Return the number of studios that a person has opened, with the person locked until this transaction ends."""
    session.execute(select(Person.id).where(Person.id == person_id).with_for_update())
    return session.scalar(select(func.count()).where(Studio.opened_by == person_id)) or 0


people_in = Usage(Membership.studio_id)
_NOW: BindParameter[datetime] = bindparam("now", callable_=clock.now)  # of each execution
tokens_of = Usage(Token.studio_id, Token.revoked_at.is_(None), Token.expires_at > _NOW)  # those that work


def own_limits(session: Session, studio_id: UUID | None = None) -> dict[UUID, dict[str, int]]:
    """Return the limits that are not the defaults, by studio and kind; those of one studio if given."""
    rows = select(Quota.studio_id, Quota.kind, Quota.maximum)
    if studio_id is not None:
        rows = rows.where(Quota.studio_id == studio_id)
    limits: dict[UUID, dict[str, int]] = defaultdict(dict)
    for owner_id, kind, maximum in session.execute(rows):
        limits[owner_id][kind] = maximum
    return limits
