"""Sums of the takes of cues, kept in the transaction that changes a take: for the team and for each designer.

It is worked out when the transaction ends, once for each cue, so that many takes of a cue cost no more than one.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import fields
from functools import cache
from typing import Any
from uuid import UUID

from sqlalchemy import Select, Table, bindparam, delete, event, insert, select, update
from sqlalchemy.orm import Session

from app.core.db import Base
from app.core.in_array import in_array
from app.deliveries.cue_counts.rules import Sums, TakeForSums, sums_of
from app.deliveries.models import Take, TakeCounts
from app.sound_lists.models import Cue

SUMS: Table = Base.metadata.tables[TakeCounts.__tablename__]
_ONE = (SUMS.c.cue_id == bindparam("of_cue"), SUMS.c.viewer_id == bindparam("viewer"))
_NEW, _GONE = insert(SUMS), delete(SUMS).where(*_ONE)
_CHANGED = update(SUMS).where(*_ONE).values({field.name: bindparam(field.name) for field in fields(Sums)})
TOUCHED = "cues whose takes changed"  # key in a session's info


def update_take_counts(session: Session, *cue_ids: UUID | None) -> None:
    """Have the sums of cues recomputed when the transaction ends; every change of a take calls this."""
    if TOUCHED not in session.info:
        session.info[TOUCHED] = set()
        event.listen(session, "before_commit", _recalculate, once=True)
    session.info[TOUCHED].update(cue_id for cue_id in cue_ids if cue_id is not None)


def views_of(studio_id: UUID, takes: Sequence[TakeForSums]) -> Iterator[tuple[UUID, Sums]]:
    """Yield the sums of a cue's takes for the team, under its studio's id, and for each of their designers."""
    yield studio_id, sums_of(takes)
    own: dict[UUID, list[TakeForSums]] = defaultdict(list)
    for take in takes:
        own[take.designer_id].append(take)
    for designer_id, theirs in own.items():
        yield designer_id, sums_of(theirs)


def _recalculate(session: Session) -> None:
    cue_ids = session.info.pop(TOUCHED)
    if not cue_ids:
        return
    # One transaction at a time for each cue: after the wait it reads what the others wrote.
    of_cues = {"cue_ids": cue_ids}
    cues = session.execute(_locked(), of_cues).all()
    takes: dict[UUID, list[TakeForSums]] = defaultdict(list)
    for take in session.execute(_summed(), of_cues):
        takes[take.cue_id].append(TakeForSums._make(take[1:]))
    kept = {(cue_id, viewer_id): Sums(*sums) for cue_id, viewer_id, *sums in session.execute(_kept(), of_cues)}
    new, changed = [], []
    for cue in cues:
        if not takes[cue.cue_id]:
            continue
        for viewer_id, sums in views_of(cue.studio_id, takes[cue.cue_id]):
            before = kept.pop((cue.cue_id, viewer_id), None)
            if before is None:
                new.append({**cue._mapping, "viewer_id": viewer_id, **vars(sums)})
            elif before != sums:
                changed.append({"of_cue": cue.cue_id, "viewer": viewer_id, **vars(sums)})
    if new:
        session.execute(_NEW, new)
    if changed:
        session.execute(_CHANGED, changed)
    if kept:  # their takes are for another cue now
        session.execute(_GONE, [{"of_cue": cue_id, "viewer": viewer} for cue_id, viewer in kept])


@cache
def _locked() -> Select[*tuple[Any, ...]]:
    facts = (Cue.id.label("cue_id"), Cue.studio_id, Cue.project_id, Cue.state, Cue.variations, Cue.placeholder)
    return select(*facts).where(in_array(Cue.id, "cue_ids")).order_by(Cue.id).with_for_update(key_share=True)


@cache
def _summed() -> Select[*tuple[Any, ...]]:
    facts = (getattr(Take, name) for name in TakeForSums._fields)
    return select(Take.cue_id, *facts).where(in_array(Take.cue_id, "cue_ids"))


@cache
def _kept() -> Select[*tuple[Any, ...]]:
    columns = (getattr(TakeCounts, field.name) for field in fields(Sums))
    return select(TakeCounts.cue_id, TakeCounts.viewer_id, *columns).where(in_array(TakeCounts.cue_id, "cue_ids"))
