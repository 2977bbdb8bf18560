"""The list as people see and change it: pages of cues, rows typed, changed, ordered and cut, cues found by name."""

import unicodedata
from collections.abc import Collection, Mapping, Sequence
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

import audio_checks
from app.accounts.rules import Actor
from app.core.web.http import cursor_of, numbers_cursor
from app.projects.errors import ProjectNotFound
from app.projects.models import Project
from app.projects.service import ProjectAccess, project_access
from app.sound_lists import queries, save_edits
from app.sound_lists.errors import CueChanged, CueIsCut, CueNotFound, OrderInvalid, RowsInvalid
from app.sound_lists.models import Cue
from app.sound_lists.rules import LENGTHS, NO_PLAYBACK_PRIORITY, CueOrdering, CueState, facts_seen, label
from app.sound_lists.save_edits import Edit, facts_of, whole_facts
from app.sound_lists.schemas import CueRead, PreviewCue


def cue_read(access: ProjectAccess, cue: Cue, open_questions: int = 0) -> CueRead:
    """Return a cue, loaded with its stems, as it is answered."""
    stems = [stem.stem for stem in sorted(cue.stems, key=lambda stem: stem.variation)]
    return _cue_read(access, cue, stems, open_questions)


def _cue_read(access: ProjectAccess, cue: Cue, stems: list[str], open_questions: int) -> CueRead:
    return CueRead(
        **facts_seen(facts_of(cue), access.only_designer_id),
        id=cue.id,
        number=cue.number,
        label=label(access.project.cue_prefix, cue.number),
        position=cue.position,
        stems=stems,
        edition=cue.edition,
        cut_reason=cue.cut_reason,
        cut_at=cue.cut_at,
        open_questions=open_questions,
    )


def page_of(
    session: Session, project_id: UUID, order: CueOrdering, *, cursor: str | None, limit: int
) -> tuple[Sequence[Cue], str | None]:
    """Return one page of the list in an order, and the cursor of the following page."""
    after = numbers_cursor(cursor, count=2 if order == "list" else 3)
    cues = queries.cue_page(session, project_id, order, after=after, limit=limit + 1)
    page = cues[:limit]
    if len(cues) <= limit:
        return page, None
    last = page[-1]
    priority = NO_PLAYBACK_PRIORITY if last.playback_priority is None else last.playback_priority
    sort_key = (last.position, last.number)
    return page, cursor_of(*(sort_key if order == "list" else (priority, *sort_key)))


def cues_read(session: Session, access: ProjectAccess, cues: Sequence[Cue]) -> list[CueRead]:
    """Return a page of the list as it is answered."""
    stems = queries.stems_by_cue(session, [cue.id for cue in cues])
    open_questions = queries.open_question_counts(session, access.project.id)
    return [_cue_read(access, cue, [stem for _, stem in stems[cue.id]], open_questions.get(cue.id, 0)) for cue in cues]


def preview_cues(cues: Sequence[Cue], cue_prefix: str) -> list[PreviewCue]:
    """Return the cues that are still wanted, as an invited designer sees them before having an account."""
    texts = ("number", "name", "file_name", "category", "description", "use")
    shown = (*texts, *LENGTHS, "loop", "channels", "variations")
    return [
        PreviewCue(label=label(cue_prefix, cue.number), state=cue.state, **{fact: getattr(cue, fact) for fact in shown})
        for cue in cues
        if cue.state is not CueState.CUT
    ]


def cue_facts(cue: Cue) -> audio_checks.CueFacts:
    """Return the facts of a cue that checks and renders need."""
    return audio_checks.CueFacts(
        number=str(cue.number),
        name=cue.name,
        file_name=cue.file_name,
        category=cue.category or None,
        duration_s=cue.duration_s,
        duration_min_s=cue.duration_min_s,
        duration_max_s=cue.duration_max_s,
        length_locked=cue.length_locked,
        frame_rate_fps=cue.frame_rate_fps,
        loop=cue.loop,
        reverb=cue.reverb.value if cue.reverb else None,
        channels=cue.channels.value if cue.channels else None,
        variations=cue.variations,
        state=cue.state.value,
    )


def cue_for(session: Session, access: ProjectAccess, cue_id: UUID) -> Cue:
    """Return a cue of the project that the caller is in, with its stems; raise CueNotFound for any other."""
    cue = queries.cue_by_id(session, cue_id)
    if cue is None or cue.project_id != access.project.id:
        raise CueNotFound(f"no cue {cue_id}")
    return cue


def visible_cue(session: Session, actor: Actor, cue_id: UUID) -> tuple[ProjectAccess, Cue]:
    """Return a cue with its stems and what the caller is in its project; raise CueNotFound without sight of it."""
    cue = queries.cue_by_id(session, cue_id)
    if cue is None:
        raise CueNotFound(f"no cue {cue_id}")
    try:
        return project_access(session, actor, cue.project_id), cue
    except ProjectNotFound:
        raise CueNotFound(f"no cue {cue_id}") from None


def slot_by_stem(session: Session, project_id: UUID, stem: str) -> tuple[Cue, int] | None:
    """Return the cue and the variation that own a stem, exactly after NFC."""
    return queries.slot_of_stem(session, project_id, unicodedata.normalize("NFC", stem))


def stems_by_cue(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, list[tuple[int, str]]]:
    """Return the stems that cues own, each with its variation, in order."""
    return queries.stems_by_cue(session, cue_ids)


def add_cues(session: Session, actor: Actor, project_id: UUID, rows: Sequence[Mapping[str, Any]]) -> list[Cue]:
    """Add typed rows at the end of the list; raise RowsInvalid, naming rows and fields, when one of them is wrong."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    edits = [Edit(row, whole_facts(facts)) for row, facts in enumerate(rows, start=1)]
    return _save_or_raise(session, access, edits)


def change_cue(session: Session, actor: Actor, cue_id: UUID, edition: int | None, changes: Mapping[str, Any]) -> Cue:
    """Change facts of a cue; raise CueChanged when `edition` is no longer the newest."""
    access, _ = visible_cue(session, actor, cue_id)
    access.ensure_may_speak()
    queries.lock_list(session, access.project.id)
    cue = cue_for(session, access, cue_id)  # the current row, even if it changes at the same moment
    if edition is not None and edition != cue.edition:
        raise CueChanged("someone else changed this cue meanwhile", fix="read it again, then change it")
    if cue.state is CueState.CUT:
        raise CueIsCut(f"{label(access.project.cue_prefix, cue.number)} is cut and can't be changed")
    _save_or_raise(session, access, [Edit(1, whole_facts(changes, facts_of(cue)), cue)])
    return cue_for(session, access, cue_id)


def order_cues(session: Session, actor: Actor, project_id: UUID, cue_ids: Sequence[UUID]) -> None:
    """Let the named cues share out the places they hold, in the order given."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    cues = queries.cues_by_id(session, project_id, set(cue_ids))
    if len(set(cue_ids)) != len(cue_ids):
        raise OrderInvalid("the order names a cue twice")
    if strangers := [cue_id for cue_id in cue_ids if cue_id not in cues]:
        raise OrderInvalid(f"the list has no cue {strangers[0]}")
    places = sorted((cue.position, cue.number) for cue in cues.values())
    for cue_id, (position, _) in zip(cue_ids, places, strict=True):
        cues[cue_id].position = position


def cut_cue(session: Session, actor: Actor, cue: Cue, reason: str) -> None:
    """Mark a cue as cut, with the reason; its names are free again. Reviews decide who may."""
    if cue.state is CueState.CUT:
        raise CueIsCut("this cue is already cut")
    project = session.get_one(Project, cue.project_id)
    queries.lock_list(session, project.id)
    save_edits.cut(session, project, actor.person, cue, reason)


def _save_or_raise(session: Session, access: ProjectAccess, edits: Sequence[Edit]) -> list[Cue]:
    queries.lock_list(session, access.project.id)
    edits, unfit = save_edits.with_fitted_values(session, access.project, edits)
    if faults := unfit or save_edits.row_faults(session, access.project, edits):
        places = [
            f"row {fault.row}: {fault.field}" if len(edits) > 1 or not edits[0].cue else str(fault.field)
            for fault in faults
        ]
        raise RowsInvalid(
            f"nothing was saved; {places[0]}: {faults[0].message}",
            errors=[{"where": where, "message": fault.message} for where, fault in zip(places, faults, strict=True)],
        )
    return save_edits.save(session, access.project, access.actor.person, edits)
