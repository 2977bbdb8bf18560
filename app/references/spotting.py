"""Spotting: the marks of a clip become cues, each with its part of the clip as a reference; and the undo of it."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import delete, insert
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core.db import new_id
from app.core.errors import FieldProblem
from app.projects.service import ProjectAccess
from app.references import queries
from app.references.errors import ReferenceInvalid
from app.references.models import Reference, ReferenceVersion
from app.references.rules import MAX_RANGE_S, PreviewState, ReferenceKind
from app.references.schemas import SpottedMark
from app.references.service import reference_to_change
from app.sound_lists.errors import AdditionInUse
from app.sound_lists.models import Cue
from app.sound_lists.service import add_cues
from app.sound_lists.undo import undo_addition

LENGTH_DECIMALS = 3


def add_spotted_cues(
    session: Session, actor: Actor, reference_id: UUID, marks: Sequence[SpottedMark]
) -> tuple[ProjectAccess, list[Cue]]:
    """Add a cue for each mark, and pin the marked part of the clip to it; all of them, or none."""
    access, clip = reference_to_change(session, actor, reference_id)
    _ensure_clip(clip)
    _ensure_ends(marks)
    rows = [{"name": mark.name, "category": mark.category, "duration_s": _length(mark)} for mark in marks]
    cues = add_cues(session, actor, clip.project_id, rows)
    references = [_part_of(clip, cue, mark, actor) for cue, mark in zip(cues, marks, strict=True)]
    session.execute(insert(Reference), references)
    session.execute(insert(ReferenceVersion), [_version_of(clip, reference["id"], actor) for reference in references])
    return access, cues


def move_parts(session: Session, actor: Actor, clip: ReferenceVersion) -> None:
    """Give the parts of a clip its new version, at the same times; one that shows another file keeps it."""
    before = queries.version_numbered(session, clip.reference_id, clip.number - 1)
    if before is None or clip.kind is not ReferenceKind.VIDEO:
        return
    versions = []
    for part in queries.parts_locked(session, clip.reference_id, before.sha256):
        part.newest_number += 1
        versions.append(_version_of(clip, part.id, actor) | {"number": part.newest_number})
    session.flush()
    if versions:
        session.execute(insert(ReferenceVersion), versions)


def undo_spotted_cues(session: Session, actor: Actor, reference_id: UUID, cue_ids: Sequence[UUID]) -> None:
    """Remove the cues of the marks and their references; raise AdditionInUse once a cue or its reference is in use."""
    _, clip = reference_to_change(session, actor, reference_id)
    made = queries.references_of_file(session, clip.project_id, clip.sha256, cue_ids)
    try:
        with session.begin_nested():
            session.execute(delete(ReferenceVersion).where(ReferenceVersion.reference_id.in_(made)))
            session.execute(delete(Reference).where(Reference.id.in_(made)))
    except IntegrityError:
        raise AdditionInUse("one of these cues had its part of the clip opened", fix="cut the cues instead") from None
    undo_addition(session, actor, clip.project_id, cue_ids)


def _ensure_clip(clip: ReferenceVersion) -> None:
    if clip.kind is not ReferenceKind.VIDEO:
        raise ReferenceInvalid(f"{clip.file_name} is not a clip", fix="mark a video that is on the board")


def _ensure_ends(marks: Sequence[SpottedMark]) -> None:
    for row, mark in enumerate(marks, start=1):
        if mark.start_s + (mark.duration_s or 0) > MAX_RANGE_S:
            message = f"a clip has at most {MAX_RANGE_S / 3600:g} hours; this part ends later"
            raise ReferenceInvalid(message, errors=[FieldProblem(where=f"row {row}: duration_s", message=message)])


def _length(mark: SpottedMark) -> float | None:
    return round(mark.duration_s, LENGTH_DECIMALS) or None if mark.duration_s else None


def _part_of(clip: ReferenceVersion, cue: Cue, mark: SpottedMark, actor: Actor) -> dict[str, object]:
    length = _length(mark)
    return {
        "id": new_id(),
        "studio_id": clip.studio_id,
        "project_id": clip.project_id,
        "cue_id": cue.id,
        "category": None,
        "caption": clip.reference.caption,
        "terms": clip.reference.terms,
        "start_s": mark.start_s,
        "end_s": mark.start_s + length if length else None,
        "newest_number": 1,
        "spotted_from_id": clip.reference_id,
        "added_by": actor.person,
    }


def _version_of(clip: ReferenceVersion, reference_id: object, actor: Actor) -> dict[str, object]:
    return {
        "id": new_id(),
        "studio_id": clip.studio_id,
        "project_id": clip.project_id,
        "reference_id": reference_id,
        "number": 1,
        "kind": clip.kind,
        "media_type": clip.media_type,
        "file_name": clip.file_name,
        "sha256": clip.sha256,
        "file_bytes": clip.file_bytes,
        "excerpt": "",
        "preview": PreviewState.NONE,
        "added_by": actor.person,
    }
