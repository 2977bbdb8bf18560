"""The list as it is kept: rows added and changed, names owned, revisions saved, cues cut and found by name."""

import unicodedata
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any
from uuid import UUID

from sqlalchemy import delete, insert
from sqlalchemy.orm import Session

import audio_checks
from app.accounts.rules import Actor
from app.kit import clock
from app.kit.db import new_id
from app.kit.events import publish
from app.kit.http import BadCursor, cursor_of
from app.projects.errors import ProjectNotFound
from app.projects.models import Project
from app.projects.service import Standing, standing_in
from app.sound_lists import guesses, queries
from app.sound_lists.errors import CueEditedMeanwhile, CueIsCut, CueNotFound, OrderInvalid, RowsInvalid
from app.sound_lists.models import Cue, CueChange, Revision, Stem
from app.sound_lists.rules import (
    CHECKED_FACTS,
    NAMING_FACTS,
    NEW_CUE,
    CueState,
    Facts,
    Reverb,
    faults_of,
    folded,
    label,
    spreadsheet_safe,
    tidy,
)
from app.sound_lists.schemas import CueRead, PreviewCue

CURSOR_DIGITS = 10  # what a database column of whole numbers holds
OWN_COLUMNS = ("playback_priority", "placeholder", "palette")  # in the export beside those every tool knows


@dataclass(frozen=True)
class Edit:
    """One row to save: what the list shall say of a cue."""

    row: int
    facts: Facts  # all of them
    cue: Cue | None = None  # None: a new cue
    number: int | None = None  # of a new cue; None: the next one

    @property
    def before(self) -> Facts:
        """What the list says now; nothing of a new cue."""
        return facts_of(self.cue) if self.cue else {}

    @property
    def renames(self) -> bool:
        """Whether the cue's stems come anew."""
        return self.cue is None or any(self.facts[fact] != getattr(self.cue, fact) for fact in NAMING_FACTS)

    @property
    def stems(self) -> list[str]:
        """The stems the cue shall own; a cut cue owns none."""
        if self.facts["state"] == CueState.CUT:
            return []
        return audio_checks.stems_of(self.facts["name"], self.facts["file_name"], self.facts["variations"])


@dataclass(frozen=True)
class RowFault:
    """What is wrong with one field of one row."""

    row: int
    field: str | None
    message: str


@dataclass(frozen=True)
class Guess:
    """A cue that a file without a match may be for, and why."""

    cue_id: UUID
    label: str
    name: str
    variation: int
    reason: str


def facts_of(cue: Cue) -> Facts:
    """Return what the list says of a cue."""
    return {fact: getattr(cue, fact) for fact in NEW_CUE}


def cue_read(cue: Cue, cue_prefix: str, open_questions: int = 0) -> CueRead:
    """Return a cue, loaded with its stems, as it is answered."""
    stems = [stem.stem for stem in sorted(cue.stems, key=lambda stem: stem.variation)]
    return _cue_read(cue, cue_prefix, stems, open_questions)


def _cue_read(cue: Cue, cue_prefix: str, stems: list[str], open_questions: int) -> CueRead:
    return CueRead(
        **facts_of(cue),
        id=cue.id,
        number=cue.number,
        label=label(cue_prefix, cue.number),
        position=cue.position,
        stems=stems,
        edition=cue.edition,
        cut_reason=cue.cut_reason,
        cut_at=cue.cut_at,
        open_questions=open_questions,
    )


def page_of(session: Session, project_id: UUID, *, cursor: str | None, limit: int) -> tuple[Sequence[Cue], str | None]:
    """Return one page of the list, and the cursor of the following page."""
    after = place_in(cursor)
    found = queries.cue_page(session, project_id, after=after, limit=limit + 1)
    page = found[:limit]
    return page, cursor_of(page[-1].position, page[-1].number) if len(found) > limit else None


def cues_read(session: Session, project: Project, cues: Sequence[Cue]) -> list[CueRead]:
    """Return a page of the list as it is answered."""
    stems = queries.stems_by_cue(session, [cue.id for cue in cues])
    open_questions = queries.open_question_counts(session, project.id)
    return [
        _cue_read(cue, project.cue_prefix, [stem for _, stem in stems[cue.id]], open_questions.get(cue.id, 0))
        for cue in cues
    ]


def place_in(cursor: str | None) -> tuple[int, int] | None:
    """Return the position and number in the list that a cursor of it means."""
    if cursor is None:
        return None
    position, _, number = cursor.partition(".")
    if not (position.isdecimal() and number.isdecimal() and max(len(position), len(number)) < CURSOR_DIGITS):
        raise BadCursor(f"{cursor!r} is no page cursor; use the `next` of the page before")
    return int(position), int(number)


def preview_cues(cues: Sequence[Cue], cue_prefix: str) -> list[PreviewCue]:
    """Return the cues that are still wanted, as an invited designer sees them before having an account."""
    shown = ("number", "name", "file_name", "category", "description", "use", "duration_s", "loop", "variations")
    return [
        PreviewCue(label=label(cue_prefix, cue.number), state=cue.state, **{fact: getattr(cue, fact) for fact in shown})
        for cue in cues
        if cue.state is not CueState.CUT
    ]


def cue_facts(cue: Cue) -> audio_checks.CueFacts:
    """Return what checks and renders need to know of a cue."""
    return audio_checks.CueFacts(
        number=str(cue.number),
        name=cue.name,
        file_name=cue.file_name,
        category=cue.category or None,
        duration_s=cue.duration_s,
        length_locked=cue.length_locked,
        frame_rate_fps=cue.frame_rate_fps,
        loop=cue.loop,
        reverb=cue.reverb.value if cue.reverb else None,
        variations=cue.variations,
        state=cue.state.value,
    )


def cue_for(session: Session, standing: Standing, cue_id: UUID) -> Cue:
    """Return a cue of the project that the caller stands in, with its stems; raise CueNotFound for any other."""
    cue = queries.cue_by_id(session, cue_id)
    if cue is None or cue.project_id != standing.project.id:
        raise CueNotFound(f"no cue {cue_id}")
    return cue


def cue_in_sight(session: Session, actor: Actor, cue_id: UUID) -> tuple[Standing, Cue]:
    """Return a cue with its stems and what the caller is in its project; raise CueNotFound without sight of it."""
    cue = queries.cue_by_id(session, cue_id)
    if cue is None:
        raise CueNotFound(f"no cue {cue_id}")
    try:
        return standing_in(session, actor, cue.project_id), cue
    except ProjectNotFound:
        raise CueNotFound(f"no cue {cue_id}") from None


def slot_by_stem(session: Session, project_id: UUID, stem: str) -> tuple[Cue, int] | None:
    """Return the cue and the variation that own a stem, exactly after NFC."""
    return queries.slot_of_stem(session, project_id, unicodedata.normalize("NFC", stem))


def guesses_for(
    session: Session,
    project_id: UUID,
    files: Sequence[tuple[str, float | None]],
    *,
    favour: Collection[UUID] = (),
) -> list[list[Guess]]:
    """Return up to three cues that each file may be for, the likeliest first; files come as name and length.

    `favour` names the cues that still wait for a sound.
    """
    if not files:
        return []
    project = session.get_one(Project, project_id)
    rows = {row.id: row for row in queries.guessable_cues(session, project_id)}
    candidates = [
        guesses.Candidate(
            key=row.id,
            name=row.name,
            stem=audio_checks.stems_of(row.name, row.file_name, 1)[0],
            category=row.category,
            duration_s=row.duration_s,
            variations=row.variations,
            waits=row.id in favour,
        )
        for row in rows.values()
    ]
    return [
        [
            Guess(
                cue_id=like.key,
                label=label(project.cue_prefix, rows[like.key].number),
                name=rows[like.key].name,
                variation=like.variation,
                reason=like.reason,
            )
            for like in guesses.likeliest(file_name, duration_s, candidates)
        ]
        for file_name, duration_s in files
    ]


def add_cues(session: Session, actor: Actor, project_id: UUID, rows: Sequence[Mapping[str, Any]]) -> list[Cue]:
    """Add typed rows at the end of the list; raise RowsInvalid, naming rows and fields, when one of them is wrong."""
    standing = standing_in(session, actor, project_id)
    standing.ensure_speaks()
    edits = [Edit(row, whole_facts(facts)) for row, facts in enumerate(rows, start=1)]
    return _save_or_raise(session, standing, edits)


def change_cue(session: Session, actor: Actor, cue_id: UUID, edition: int | None, changes: Mapping[str, Any]) -> Cue:
    """Change facts of a cue; raise CueEditedMeanwhile when `edition` is no longer the newest."""
    standing, _ = cue_in_sight(session, actor, cue_id)
    standing.ensure_speaks()
    queries.lock_list(session, standing.project.id)
    cue = cue_for(session, standing, cue_id)  # as it stands now, whoever else changes it at the same moment
    if edition is not None and edition != cue.edition:
        raise CueEditedMeanwhile("somebody else changed this cue meanwhile", fix="read it again, then change it")
    if cue.state is CueState.CUT:
        raise CueIsCut(f"{label(standing.project.cue_prefix, cue.number)} was cut and is kept as it was")
    _save_or_raise(session, standing, [Edit(1, whole_facts(changes, facts_of(cue)), cue)])
    return cue_for(session, standing, cue_id)


def order_cues(session: Session, actor: Actor, project_id: UUID, cue_ids: Sequence[UUID]) -> None:
    """Let the named cues share out the places they hold, in the order given."""
    standing = standing_in(session, actor, project_id)
    standing.ensure_speaks()
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
        raise CueIsCut("this cue was cut already")
    project = session.get_one(Project, cue.project_id)
    queries.lock_list(session, project.id)
    before = {"state": cue.state.value}
    cue.state, cue.cut_reason, cue.cut_at = CueState.CUT, reason, clock.now()
    cue.edition += 1
    _free_stems(session, [cue])
    revision = _new_revision(session, project, actor.person, f"{label(project.cue_prefix, cue.number)} cut")
    after = {"state": CueState.CUT.value, "cut_reason": reason}
    session.execute(insert(CueChange), [_record(revision, cue, before, after)])
    _tell(session, revision, actor.person, added=0, changed=0, cut=1)


def whole_facts(given: Mapping[str, Any], before: Mapping[str, Any] = NEW_CUE) -> Facts:
    """Return all facts of a cue after some were given, tidied."""
    facts = {**before, **tidy(given)}
    facts["state"] = CueState(facts["state"])
    facts["reverb"] = Reverb(facts["reverb"]) if facts["reverb"] else None
    facts["extra"] = dict(facts["extra"])
    return tidy(facts)


def row_faults(session: Session, project: Project, edits: Sequence[Edit]) -> list[RowFault]:
    """Return what is wrong with rows, by themselves, among themselves and beside the rest of the list."""
    faults = [RowFault(edit.row, field, message) for edit in edits for field, message in faults_of(edit.facts)]
    wrong = {fault.row for fault in faults}
    sound = [edit for edit in edits if edit.row not in wrong]
    faults += _number_faults(session, project, sound)
    faults += _stem_faults(session, project, sound)
    return sorted(faults, key=lambda fault: fault.row)


def _number_faults(session: Session, project: Project, edits: Sequence[Edit]) -> Iterator[RowFault]:
    numbered = [edit for edit in edits if edit.cue is None and edit.number is not None]
    taken = queries.numbers_taken(session, project.id) if numbered else {}
    rows: dict[int, int] = {}
    for edit in numbered:
        number = edit.number or 0
        name = label(project.cue_prefix, number)
        if number in taken:
            message = f"{name} is in the list already; match by number to change it, or leave the column out"
            yield RowFault(edit.row, "number", message)
        elif rows.setdefault(number, edit.row) != edit.row:
            yield RowFault(edit.row, "number", f"{name} stands in row {rows[number]} as well")


def _stem_faults(session: Session, project: Project, edits: Sequence[Edit]) -> Iterator[RowFault]:
    renaming = [(edit, edit.stems) for edit in edits if edit.renames]
    freed = {edit.cue.id for edit, _ in renaming if edit.cue}
    wanted = {folded(stem) for _, stems in renaming for stem in stems}
    owners = {
        key: (stem, label(project.cue_prefix, number))
        for key, (cue_id, number, stem) in queries.stem_owners(session, project.id, wanted).items()
        if cue_id not in freed
    }
    for edit, stems in renaming:
        for stem in stems:
            key = folded(stem)
            if key in owners:
                yield RowFault(edit.row, "file_name" if edit.facts["file_name"] else "name", _twin(stem, *owners[key]))
                break
        else:
            owners |= {folded(stem): (stem, f"row {edit.row}") for stem in stems}


def _twin(stem: str, other: str, owner: str) -> str:
    if stem == other:
        return f'the file name "{stem}" belongs to {owner} already'
    return f'the file name "{stem}" differs from "{other}" of {owner} in capitals only; not every disk holds both'


def _save_or_raise(session: Session, standing: Standing, edits: Sequence[Edit]) -> list[Cue]:
    queries.lock_list(session, standing.project.id)
    if faults := row_faults(session, standing.project, edits):
        places = [
            f"row {fault.row}: {fault.field}" if len(edits) > 1 or not edits[0].cue else str(fault.field)
            for fault in faults
        ]
        raise RowsInvalid(
            f"nothing was saved; {places[0]}: {faults[0].message}",
            errors=[{"where": place, "message": fault.message} for place, fault in zip(places, faults, strict=True)],
        )
    return save(session, standing.project, standing.actor.person, edits)


def save(session: Session, project: Project, person_id: UUID, edits: Sequence[Edit]) -> list[Cue]:
    """Save faultless rows as one revision of the locked list, and return the cues that changed, in order."""
    edits = [edit for edit in edits if edit.facts != edit.before]
    if not edits:
        return []
    before = [edit.before for edit in edits]
    renaming = [edit for edit in edits if edit.renames]
    _free_stems(session, [edit.cue for edit in renaming if edit.cue])
    cues = _write_cues(session, project, edits)
    session.flush()
    ids = {edit.row: cue.id for edit, cue in zip(edits, cues, strict=True)}
    owned = [
        {"studio_id": project.studio_id, "project_id": project.id, "cue_id": ids[edit.row], "variation": place}
        | {"stem": stem}
        for edit in renaming
        for place, stem in enumerate(edit.stems, start=1)
    ]
    if owned:
        session.execute(insert(Stem), owned)
    added = sum(edit.cue is None for edit in edits)
    changed = len(edits) - added
    revision = _new_revision(session, project, person_id, _in_words(added, changed))
    unlike, records = [], []
    for cue, old in zip(cues, before, strict=True):
        new = facts_of(cue)
        differing = [fact for fact in new if not old or old[fact] != new[fact]]
        earlier = {fact: old[fact] for fact in differing} if old else {}
        records.append(_record(revision, cue, earlier, {fact: new[fact] for fact in differing}))
        if old and CHECKED_FACTS.intersection(differing):
            unlike.append(str(cue.id))
    session.execute(insert(CueChange), records)
    if unlike:
        publish(session, "cue.changed", studio_id=project.studio_id, project_id=project.id, cue_ids=unlike)
    if any(old and old["palette"] != cue.palette for old, cue in zip(before, cues, strict=True)):
        publish(session, "palette.changed", studio_id=project.studio_id, project_id=project.id)
    _tell(session, revision, person_id, added=added, changed=changed, cut=0)
    return cues


def _write_cues(session: Session, project: Project, edits: Sequence[Edit]) -> list[Cue]:
    number, position = queries.last_numbers(session, project.id)
    number = max([number, *(edit.number or 0 for edit in edits)])
    cues = []
    for edit in edits:
        cue = edit.cue
        if cue is None:
            position += 1
            number += edit.number is None
            cue = Cue(
                id=new_id(),
                studio_id=project.studio_id,
                project_id=project.id,
                number=edit.number or number,
                position=position,
                edition=0,
            )
            session.add(cue)
        for fact, value in edit.facts.items():
            setattr(cue, fact, value)
        if cue.state is CueState.CUT and cue.cut_at is None:
            cue.cut_at, cue.cut_reason = clock.now(), "cut before it came into this list"
        cue.edition += 1
        cues.append(cue)
    return cues


def _free_stems(session: Session, cues: Sequence[Cue]) -> None:
    ids = [cue.id for cue in cues]
    for cue in cues:
        session.expire(cue, ["stems"])
    for start in range(0, len(ids), queries.IDS_AT_ONCE):
        session.execute(delete(Stem).where(Stem.cue_id.in_(ids[start : start + queries.IDS_AT_ONCE])))


def _new_revision(session: Session, project: Project, person_id: UUID, summary: str) -> Revision:
    revision = Revision(
        id=new_id(),
        studio_id=project.studio_id,
        project_id=project.id,
        number=queries.revision_number(session, project.id) + 1,
        summary=summary,
        changed_by=person_id,
    )
    session.add(revision)
    session.flush()
    return revision


def _record(revision: Revision, cue: Cue, before: Facts, after: Facts) -> dict[str, Any]:
    return {
        "revision_id": revision.id,
        "cue_id": cue.id,
        "studio_id": revision.studio_id,
        "before": before,
        "after": after,
    }


def _tell(session: Session, revision: Revision, actor_id: UUID, *, added: int, changed: int, cut: int) -> None:
    publish(
        session,
        "list.revised",
        studio_id=revision.studio_id,
        project_id=revision.project_id,
        revision=revision.number,
        actor_id=actor_id,
        added=added,
        changed=changed,
        cut=cut,
    )


def _in_words(added: int, changed: int) -> str:
    parts = []
    if added:
        parts.append(f"{added} {'cue' if added == 1 else 'cues'} added")
    if changed:
        parts.append(f"{changed} {'cue' if changed == 1 else 'cues'} changed" if not added else f"{changed} changed")
    return ", ".join(parts)


def sound_list_csv(cues: Sequence[Cue], cue_prefix: str) -> str:
    """Return the list as the CSV that spreadsheets, CI and our own import read; no cell is a formula."""
    own = [column for column in OWN_COLUMNS if any(getattr(cue, column) for cue in cues)]
    extras: dict[str, str] = {}  # the first spelling of a column, by the one that readers compare
    for column in (column for cue in cues for column in cue.extra):
        extras.setdefault(column.lower(), column)
    return audio_checks.write_sound_list(_exported(cue, cue_prefix, own, extras) for cue in cues)


def _exported(cue: Cue, cue_prefix: str, own: Sequence[str], extras: Mapping[str, str]) -> audio_checks.CueFacts:
    more = {"description": cue.description, "use": cue.use, "trigger": cue.trigger}
    more |= {column: _plain(getattr(cue, column)) for column in own}
    values = {column.lower(): text for column, text in cue.extra.items()}
    more |= {column: values.get(key, "") for key, column in extras.items()}
    return replace(
        cue_facts(cue),
        number=label(cue_prefix, cue.number),
        name=spreadsheet_safe(cue.name),
        more={spreadsheet_safe(column): spreadsheet_safe(text) for column, text in more.items()},
    )


def _plain(value: bool | int | None) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return "" if value is None else str(value)
