"""The project's own columns, set as a whole; cues keep their values by the columns' names."""

import hashlib
import json
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from uuid import UUID

from sqlalchemy import delete, insert
from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core.db import new_id
from app.projects.models import Project
from app.projects.service import project_access
from app.sound_lists import queries
from app.sound_lists.errors import ColumnsChanged, ColumnsInvalid
from app.sound_lists.models import Cue, OwnColumn
from app.sound_lists.own_columns.rules import Column, by_key, column_faults, fitted, key_of
from app.sound_lists.rules import label, tidy_line
from app.sound_lists.save_edits import Edit, facts_of, save

Fault = tuple[int, str, str]  # the place of a column from 1, the field, and the fault in words


def edition_of(columns: Sequence[Column]) -> str:
    """Return a mark that differs once a column does."""
    facts = [[str(column.id), column.name, column.kind.value, [*column.choices]] for column in columns]
    return hashlib.sha256(json.dumps(facts).encode()).hexdigest()[:16]


def set_columns(
    session: Session, actor: Actor, project_id: UUID, edition: str, wanted: Sequence[Column]
) -> list[Column]:
    """Set the columns of a list; raise ColumnsInvalid where a cue's value would not fit its column.

    A renamed column takes its values along, a removed one leaves them with the cues.
    """
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    queries.lock_list(session, project_id)
    before = queries.own_columns(session, project_id)
    known = {column.id for column in before}
    if edition_of(before) != edition or any(column.id and column.id not in known for column in wanted):
        raise ColumnsChanged("someone else changed the columns meanwhile", fix="read them again, then change them")
    after = [_tidied(column) for column in wanted]
    _raise_faults(list(column_faults(after)))
    edits, faults = _edits(access.project, queries.cues_of(session, project_id), before, after)
    _raise_faults(faults)
    save(session, access.project, actor.person, edits)
    _write(session, access.project, after)
    return queries.own_columns(session, project_id)


def _tidied(column: Column) -> Column:
    choices = [choice for choice in map(tidy_line, column.choices) if choice]
    return column._replace(
        name=tidy_line(column.name), choices=choices if column.kind == "choice" else [], id=column.id or new_id()
    )


def _raise_faults(faults: Sequence[Fault]) -> None:
    if faults:
        raise ColumnsInvalid(
            f"nothing was changed; column {faults[0][0]}: {faults[0][2]}",
            errors=[
                {"where": f"column {position}: {field}", "message": message} for position, field, message in faults
            ],
        )


@dataclass(frozen=True)
class _Misfit:
    """A value that does not fit its column."""

    cue: str
    text: str
    message: str


def _edits(
    project: Project, cues: Sequence[Cue], before: Sequence[Column], after: Sequence[Column]
) -> tuple[list[Edit], list[Fault]]:
    """Return the changes of cues that the columns bring about, and the columns that do not fit what cues have."""
    old = {column.id: column.name for column in before}
    renamed = {key_of(old[column.id]): column.name for column in after if column.id in old}
    columns = by_key(after)
    edits: list[Edit] = []
    misfits: dict[str, list[_Misfit]] = defaultdict(list)
    for row, cue in enumerate(cues, start=1):
        moved: dict[str, str] = {}
        for name, text in _with_names(cue.extra, renamed):
            if name in moved:
                message = f'it keeps "{moved[name][:40]}" and "{text[:40]}" under this name'
                misfits[name].append(_Misfit(label(project.cue_prefix, cue.number), text, message))
            moved[name] = text
        extra, wrong = fitted(columns, moved)
        for name, message in wrong:
            misfits[name].append(_Misfit(label(project.cue_prefix, cue.number), moved.get(name, ""), message))
        if extra != cue.extra:
            edits.append(Edit(row, {**facts_of(cue), "extra": extra}, cue))
    return edits, list(_in_words(after, misfits))


def _with_names(extra: Mapping[str, str], renamed: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    for name, text in extra.items():
        yield renamed.get(key_of(name), name), text


def _in_words(columns: Sequence[Column], misfits: Mapping[str, Sequence[_Misfit]]) -> Iterator[Fault]:
    for position, column in enumerate(columns, start=1):
        if column_misfits := misfits.get(column.name):
            others = (
                f"; so do {len(column_misfits) - 1} more"
                if len(column_misfits) > 2
                else "; so does one more"
                if column_misfits[1:]
                else ""
            )
            yield position, "kind", f"{column_misfits[0].cue} does not fit: {column_misfits[0].message}{others}"


def _write(session: Session, project: Project, columns: Sequence[Column]) -> None:
    session.execute(delete(OwnColumn).where(OwnColumn.project_id == project.id))
    rows = [
        {
            "id": column.id,
            "studio_id": project.studio_id,
            "project_id": project.id,
            "name": column.name,
            "folded": key_of(column.name),
            "kind": column.kind,
            "choices": [*column.choices],
            "position": position,
        }
        for position, column in enumerate(columns, start=1)
    ]
    if rows:
        session.execute(insert(OwnColumn), rows)
