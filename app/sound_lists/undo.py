"""Undo of an addition: cues that were added a moment ago leave the list again, with the revision that added them."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import delete
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.projects.service import project_access
from app.sound_lists import queries
from app.sound_lists.errors import AdditionInUse
from app.sound_lists.models import CueChange, Stem

FIRST_EDITION = 1


def undo_addition(session: Session, actor: Actor, project_id: UUID, cue_ids: Sequence[UUID]) -> None:
    """Remove the cues of the newest revision; raise AdditionInUse once the list or a cue has gone on."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    queries.lock_list(session, project_id)
    revision = queries.newest_revision(session, project_id)
    changes = queries.changes_of(session, revision.id) if revision else []
    if (
        revision is None
        or {change.cue_id for change in changes} != set(cue_ids)
        or any(change.before for change in changes)
    ):
        raise AdditionInUse("the list was changed since these cues were added", fix="cut the cues instead")
    cues = queries.cues_by_id(session, project_id, set(cue_ids))
    if any(cue.edition != FIRST_EDITION for cue in cues.values()):
        raise AdditionInUse("one of these cues was changed since", fix="cut the cues instead")
    try:
        with session.begin_nested():
            session.execute(delete(CueChange).where(CueChange.revision_id == revision.id))
            for start in range(0, len(cue_ids), queries.IDS_AT_ONCE):
                ids = cue_ids[start : start + queries.IDS_AT_ONCE]
                session.execute(delete(Stem).where(Stem.cue_id.in_(ids)))
            session.expire_all()
            for cue in queries.cues_by_id(session, project_id, set(cue_ids)).values():
                session.delete(cue)
            session.delete(revision)
    except IntegrityError:
        raise AdditionInUse("work or a question on one of these cues has begun", fix="cut the cues instead") from None
