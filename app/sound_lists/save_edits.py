"""Saves rows as revisions of a list: reserves names, records changes, publishes events."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import date
from typing import Any
from uuid import UUID

from sqlalchemy import delete, insert
from sqlalchemy.orm import Session

import audio_checks
from app.accounts.quotas.service import QuotaKind, ensure_quota
from app.core import clock
from app.core.db import new_id
from app.core.events import publish
from app.core.plural import counted
from app.projects.models import Project
from app.sound_lists import queries
from app.sound_lists.models import Cue, CueChange, Revision, Stem
from app.sound_lists.own_columns.rules import by_key, fitted
from app.sound_lists.people.service import people_in
from app.sound_lists.rules import (
    CHECKED_FACTS,
    NAMING_FACTS,
    NEW_CUE,
    PEOPLE,
    CueChannels,
    CueState,
    Facts,
    Need,
    Phase,
    Reverb,
    folded,
    label,
    tidy,
    validation_errors,
)


@dataclass(frozen=True)
class Edit:
    """One row to save: the new facts of a cue."""

    row: int
    facts: Facts  # all of them
    cue: Cue | None = None  # None: a new cue
    number: int | None = None  # of a new cue; None: the next one

    @property
    def before(self) -> Facts:
        """The current facts in the list; empty for a new cue."""
        return facts_of(self.cue) if self.cue else {}

    @property
    def renames(self) -> bool:
        """Whether the cue gets new stems."""
        return self.cue is None or any(self.facts[fact] != getattr(self.cue, fact) for fact in NAMING_FACTS)

    @property
    def stems(self) -> list[str]:
        """The stems the cue shall own; a cut cue owns none."""
        if self.facts["state"] == CueState.CUT:
            return []
        return audio_checks.stems_of(self.facts["name"], self.facts["file_name"], self.facts["variations"])


@dataclass(frozen=True)
class RowFault:
    """The error in one field of one row."""

    row: int
    field: str | None
    message: str


def facts_of(cue: Cue) -> Facts:
    """Return the facts of a cue in the list."""
    return {fact: getattr(cue, fact) for fact in NEW_CUE}


def whole_facts(given: Mapping[str, Any], before: Mapping[str, Any] = NEW_CUE) -> Facts:
    """Return all facts of a cue after some were given, tidied."""
    facts = {**before, **tidy(given)}
    facts["state"] = CueState(facts["state"])
    facts["need"] = Need(facts["need"])
    facts["phase"] = Phase(facts["phase"]) if facts["phase"] else None
    facts["reverb"] = Reverb(facts["reverb"]) if facts["reverb"] else None
    facts["channels"] = CueChannels(facts["channels"]) if facts["channels"] else None
    facts["extra"] = dict(facts["extra"])
    return tidy(facts)


def with_fitted_values(session: Session, project: Project, edits: Sequence[Edit]) -> tuple[list[Edit], list[RowFault]]:
    """Return rows with their values as the project's own columns keep them, and the values that do not fit."""
    columns = by_key(queries.own_columns(session, project.id))
    kept, faults = [], []
    for edit in edits:
        extra, wrong = fitted(columns, edit.facts["extra"])
        kept.append(replace(edit, facts={**edit.facts, "extra": extra}))
        faults += [RowFault(edit.row, column, message) for column, message in wrong]
    return kept, faults


def row_faults(session: Session, project: Project, edits: Sequence[Edit]) -> list[RowFault]:
    """Return the faults of rows, by themselves, with each other and with the rest of the list."""
    faults = [RowFault(edit.row, field, message) for edit in edits for field, message in validation_errors(edit.facts)]
    wrong = {fault.row for fault in faults}
    sound = [edit for edit in edits if edit.row not in wrong]
    faults += _people_faults(session, project, sound)
    faults += _number_faults(session, project, sound)
    faults += _stem_faults(session, project, sound)
    return sorted(faults, key=lambda fault: fault.row)


def _people_faults(session: Session, project: Project, edits: Sequence[Edit]) -> Iterator[RowFault]:
    named = [
        (edit, column, edit.facts[fact])
        for edit in edits
        for column, fact in PEOPLE.items()
        if edit.facts[fact] not in (None, edit.before.get(fact))
    ]
    known = {person.id for person in people_in(session, project)} if named else set()
    for edit, column, person_id in named:
        if person_id not in known:
            yield RowFault(edit.row, PEOPLE[column], "choose a member of the studio or a designer of the project")


def _number_faults(session: Session, project: Project, edits: Sequence[Edit]) -> Iterator[RowFault]:
    numbered = [edit for edit in edits if edit.cue is None and edit.number is not None]
    taken = queries.numbers_taken(session, project.id) if numbered else {}
    rows: dict[int, int] = {}
    for edit in numbered:
        number = edit.number or 0
        name = label(project.cue_prefix, number)
        if number in taken:
            message = f"{name} is in the list already; match by ID to change it, or ignore the column"
            yield RowFault(edit.row, "number", message)
        elif rows.setdefault(number, edit.row) != edit.row:
            yield RowFault(edit.row, "number", f"{name} is also in row {rows[number]}")


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
    return f'the file name "{stem}" differs from "{other}" of {owner} in case only, and some disks cannot hold both'


def save(session: Session, project: Project, person_id: UUID, edits: Sequence[Edit]) -> list[Cue]:
    """Save faultless rows as one revision of the locked list, and return the cues that changed, in order."""
    edits = [edit for edit in edits if edit.facts != edit.before]
    if not edits:
        return []
    added = sum(edit.cue is None for edit in edits)
    ensure_quota(session, project.studio_id, QuotaKind.CUES, queries.cues_count, added=added)
    before = [edit.before for edit in edits]
    renaming = [edit for edit in edits if edit.renames]
    _free_stems(session, [edit.cue for edit in renaming if edit.cue])
    cues = _write_cues(session, project, edits)
    session.flush()
    ids = {edit.row: cue.id for edit, cue in zip(edits, cues, strict=True)}
    owned = [
        {"studio_id": project.studio_id, "project_id": project.id, "cue_id": ids[edit.row], "variation": variation}
        | {"stem": stem}
        for edit in renaming
        for variation, stem in enumerate(edit.stems, start=1)
    ]
    if owned:
        session.execute(insert(Stem), owned)
    changed = len(edits) - added
    revision = _new_revision(session, project, person_id, _in_words(added, changed))
    unlike, records = [], []
    for cue, old in zip(cues, before, strict=True):
        new = facts_of(cue)
        differing = [fact for fact in new if not old or old[fact] != new[fact]]
        earlier = {fact: old[fact] for fact in differing} if old else {}
        later = {fact: new[fact] for fact in differing}
        records.append(_record(revision, cue, _as_json(earlier), _as_json(later)))
        if old and CHECKED_FACTS.intersection(differing):
            unlike.append(str(cue.id))
    session.execute(insert(CueChange), records)
    if unlike:
        publish(
            session,
            "cue.changed",
            studio_id=project.studio_id,
            project_id=project.id,
            person_id=person_id,
            cue_ids=unlike,
        )
    if any(old and old["palette"] != cue.palette for old, cue in zip(before, cues, strict=True)):
        publish(session, "palette.changed", studio_id=project.studio_id, project_id=project.id)
    _publish(session, revision, person_id, added=added, changed=changed, cut=0)
    return cues


def _as_json(facts: Facts) -> Facts:
    return {fact: str(value) if isinstance(value, (date, UUID)) else value for fact, value in facts.items()}


def cut(session: Session, project: Project, person_id: UUID, cue: Cue, reason: str) -> None:
    """Save as one revision of the locked list that a cue is cut; its names are free again."""
    before = {"state": cue.state.value}
    cue.state, cue.cut_reason, cue.cut_at = CueState.CUT, reason, clock.now()
    cue.edition += 1
    _free_stems(session, [cue])
    revision = _new_revision(session, project, person_id, f"{label(project.cue_prefix, cue.number)} cut")
    after = {"state": CueState.CUT.value, "cut_reason": reason}
    session.execute(insert(CueChange), [_record(revision, cue, before, after)])
    _publish(session, revision, person_id, added=0, changed=0, cut=1)


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


def _publish(session: Session, revision: Revision, actor_id: UUID, *, added: int, changed: int, cut: int) -> None:
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
        parts.append(f"{counted(added, 'cue')} added")
    if changed:
        parts.append(f"{counted(changed, 'cue')} changed" if not added else f"{changed} changed")
    return ", ".join(parts)
