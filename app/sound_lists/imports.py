"""A spreadsheet becomes rows of the list: all of them, or none."""

from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, field
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.projects.models import Project
from app.projects.service import project_access
from app.sound_lists import queries
from app.sound_lists.columns import Head, head_of, is_day_first, looks_like, read_cell, says_loop
from app.sound_lists.errors import ColumnUnknown
from app.sound_lists.models import Cue
from app.sound_lists.own_column_rules import Column as OwnColumn
from app.sound_lists.own_column_rules import by_key, kept_name, key_of, read_value
from app.sound_lists.people import known_people
from app.sound_lists.people_rules import KnownPeople
from app.sound_lists.rules import NEW_CUE, PEOPLE, CueState, Facts, label, read_label, tidy_text, typed_text
from app.sound_lists.save_edits import Edit, RowFault, row_faults, save, whole_facts, with_fitted_values
from app.sound_lists.schemas import FieldChange, ImportColumn, ImportFault, ImportRead, ImportRow
from app.sound_lists.sheets import Sheet

SAMPLES = 3
MISMAPPED = 3  # wrong cells of one column, from which on they are one fault
KEPT: frozenset[str] = frozenset({"extra", "ignore"})
OWN = "own:"  # before the name of a column of the project's own


@dataclass(frozen=True)
class Column:
    """A column of the sheet and how its cells are read."""

    place: int
    name: str
    samples: tuple[str, ...]
    guess: str | None
    field: str
    unit_s: float
    day_first: bool | None  # whether 4/5/2026 is in May; None where no cell of the column shows it


@dataclass
class Plan:
    """The changes that a sheet would make to the list."""

    edits: list[Edit] = field(default_factory=list)
    faults: list[RowFault] = field(default_factory=list)


def import_sheet(
    session: Session,
    actor: Actor,
    project_id: UUID,
    sheet: Sheet,
    *,
    mapping: Mapping[str, str] | None,
    match: str,
    dry_run: bool,
) -> ImportRead:
    """Return the changes of a sheet, and apply them if it has no errors and it is not a dry run."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    project = access.project
    queries.lock_list(session, project.id)
    cues = queries.cues_of(session, project.id)
    own = by_key(queries.own_columns(session, project.id))
    kept = {key_of(name) for cue in cues for name in cue.extra}
    people = known_people(session, access)
    columns = _columns(sheet, _Known(project.cue_prefix, own, kept), mapping or {})
    plan = _plan(cues, project, sheet, columns, match, _Into(project.cue_prefix, own, people))
    plan.edits, unfit = with_fitted_values(session, project, plan.edits)
    plan.faults += unfit
    failed = {fault.row for fault in plan.faults}
    plan.faults += row_faults(session, project, [edit for edit in plan.edits if edit.row not in failed])
    plan.faults = list(_by_column(plan.faults, columns, sheet))
    if not sheet.rows:
        plan.faults.append(RowFault(sheet.header_row or 1, None, "there are no rows below the header"))
    imports = not dry_run and not plan.faults
    rows = [_row_read(edit, project.cue_prefix, people) for edit in plan.edits]
    names = _names(sheet, columns)
    if imports:
        save(session, project, actor.person, plan.edits)
    return ImportRead(
        header_row=sheet.header_row,
        columns=[
            ImportColumn(name=one.name, samples=list(one.samples), guess=one.guess, field=one.field) for one in columns
        ],
        rows=rows,
        errors=[
            ImportFault(
                row=fault.row,
                name=names.get(fault.row, ""),
                column=_column_name(columns, fault.field),
                message=fault.message,
            )
            for fault in sorted(plan.faults, key=lambda fault: fault.row)
        ],
        added=sum(row.action == "add" for row in rows),
        changed=sum(row.action == "change" for row in rows),
        same=sum(row.action == "same" for row in rows),
        imported=imports,
        revision=queries.revision_number(session, project.id),
    )


def _names(sheet: Sheet, columns: Sequence[Column]) -> dict[int, str]:
    place = next((column.place for column in columns if column.field == "name"), None)
    return {} if place is None else {row: cells[place] for row, cells in sheet.rows}


@dataclass(frozen=True)
class _Known:
    """What the columns of a sheet may be, besides the fields."""

    cue_prefix: str
    own: Mapping[str, OwnColumn]
    kept: Set[str]  # names under which cues keep values, own columns or not


def _columns(sheet: Sheet, known: _Known, mapping: Mapping[str, str]) -> list[Column]:
    if unknown := [name for name in mapping if name not in sheet.columns]:
        raise ColumnUnknown(f'the sheet has no column "{unknown[0]}"; it has {", ".join(sheet.columns)}')
    chosen = {wanted for wanted in mapping.values() if wanted not in KEPT}
    for wanted in sorted(chosen):
        if wanted.startswith(OWN) and key_of(wanted.removeprefix(OWN)) not in known.own:
            raise ColumnUnknown(f'the list has no column of its own called "{wanted.removeprefix(OWN)}"')
        if len(names := [name for name, given in mapping.items() if given == wanted]) > 1:
            raise ColumnUnknown(f"two columns are mapped to {wanted.removeprefix(OWN)}: {', '.join(names)}")
    taken: set[str] = set()
    columns = []
    for place, name in enumerate(sheet.columns):
        cells = [cells[place] for _, cells in sheet.rows]
        guess, head = _guessed(sheet, place, name, cells, known, taken)
        if guess:
            taken.add(guess)
        free = guess if guess and guess not in chosen else "extra"
        columns.append(
            Column(
                place=place,
                name=name,
                samples=tuple(dict.fromkeys(cell[:200] for cell in cells if cell))[:SAMPLES],
                guess=guess,
                field=mapping.get(name, free),
                unit_s=head.unit_s,
                day_first=is_day_first(cells),
            )
        )
    return columns


def _guessed(
    sheet: Sheet, place: int, name: str, cells: Sequence[str], known: _Known, taken: set[str]
) -> tuple[str | None, Head]:
    guess: str | None
    head, key = head_of(name), key_of(typed_text(name))
    if sheet.header_row is None:
        head = Head(("name", "description")[place] if place < 2 else None)
    elif not head.is_ours and key in known.own:
        guess = f"{OWN}{known.own[key].name}"
        return (None if guess in taken else guess), head
    elif not head.is_ours and key in known.kept:
        return None, head
    guess = head.field
    if guess == "category" and says_loop(cells):
        guess = "loop"
    if guess is None or guess in taken:
        return None, head
    filled = [cell for cell in cells if cell]
    if guess == "number":
        fits = 2 * sum(read_label(known.cue_prefix, cell) is not None for cell in filled) >= len(filled)
    else:
        fits = looks_like(guess, cells, head.unit_s)
    return (guess if fits or head.is_ours else None), head


def _column_name(columns: Sequence[Column], field_name: str | None) -> str | None:
    return next((column.name for column in columns if column.field == field_name), field_name)


class _Finder:
    """Finds the cue that a row is about."""

    def __init__(self, cues: Sequence[Cue], cue_prefix: str, match: str) -> None:
        self._prefix = cue_prefix
        self._match = match
        self._by_number = {cue.number: cue for cue in cues}
        self._by_name: dict[str, list[Cue]] = {}
        for cue in sorted(cues, key=lambda cue: cue.state is CueState.CUT):
            namesakes = self._by_name.setdefault(cue.name.casefold(), [])
            if not namesakes or cue.state is not CueState.CUT:
                namesakes.append(cue)

    def cue_of(self, facts: Mapping[str, Any], number: int | None) -> Cue | None:
        """Return the cue that a row is about, None for a new one; raise ValueError where two could be meant."""
        if self._match == "number" and number is not None:
            return self._by_number.get(number)
        if self._match == "name":
            namesakes = self._by_name.get(str(facts.get("name", "")).casefold(), [])
            if len(namesakes) > 1:
                both = " and ".join(label(self._prefix, cue.number) for cue in namesakes[:2])
                raise ValueError(f"{both} have this name; match by ID")
            return namesakes[0] if namesakes else None
        return None


def _plan(
    cues: Sequence[Cue],
    project: Project,
    sheet: Sheet,
    columns: Sequence[Column],
    match: str,
    into: "_Into",
) -> Plan:
    plan = Plan()
    finder = _Finder(cues, project.cue_prefix, match)
    seen: dict[UUID, int] = {}
    for row, cells in sheet.rows:
        given: Facts = {}
        faults = list(_read_row(columns, into, row, cells, given))
        number = given.pop("number", None)
        if not faults:
            try:
                cue = finder.cue_of(given, number)
            except ValueError as error:
                faults.append(RowFault(row, "name", str(error)))
            else:
                edit, fault = _edit(project.cue_prefix, row, given, cue, number)
                if cue and seen.setdefault(cue.id, row) != row:
                    fault = RowFault(row, match, f"row {seen[cue.id]} is for the same cue")
                if fault:
                    faults.append(fault)
                plan.edits.append(edit)
        plan.faults += faults
    return plan


def _by_column(faults: Sequence[RowFault], columns: Sequence[Column], sheet: Sheet) -> Iterator[RowFault]:
    """Yield one fault for a column that is mapped to the wrong field, and every other fault as it is."""
    for column in columns:
        own = [fault for fault in faults if fault.field == column.field]
        filled = sum(bool(cells[column.place].strip()) for _, cells in sheet.rows)
        if column.field not in {*KEPT, "name"} and len(own) >= MISMAPPED and 2 * len(own) > filled:
            first = own[0]
            yield RowFault(
                first.row,
                first.field,
                f"{len(own)} of {filled} cells in this column do not fit: {first.message}; "
                "map the column to another field, or ignore it",
            )
            faults = [fault for fault in faults if fault.field != column.field]
    yield from faults


@dataclass(frozen=True)
class _Into:
    """What cells are read against."""

    cue_prefix: str
    own: Mapping[str, OwnColumn]
    people: KnownPeople


def _read_row(
    columns: Sequence[Column], into: _Into, row: int, cells: Sequence[str], given: Facts
) -> Iterator[RowFault]:
    """Add a row's values to `given`, and yield the cells that cannot be read."""
    extra: dict[str, str] = {}
    for column in columns:
        text = typed_text(cells[column.place])
        if column.field == "ignore":
            continue
        if column.field == "extra":
            extra[kept_name(typed_text(column.name))] = tidy_text(text)
        elif column.field.startswith(OWN):
            own = into.own[key_of(column.field.removeprefix(OWN))]
            try:
                extra[own.name] = read_value(own, text, column.day_first)
            except ValueError as error:
                yield RowFault(row, column.field, str(error))
        elif column.field == "number":
            given["number"] = read_label(into.cue_prefix, text) if text else None
            if text and given["number"] is None:
                yield RowFault(row, "number", f'wanted {label(into.cue_prefix, 14)} or 14, found "{text[:40]}"')
        else:
            try:
                if column.field in PEOPLE:
                    given[PEOPLE[column.field]] = into.people.id_of(text)
                else:
                    given[column.field] = read_cell(column.field, text, column.unit_s, column.day_first)
            except ValueError as error:
                yield RowFault(row, column.field, str(error))
    given["extra"] = extra


def _with_values(before: Mapping[str, str], given: Mapping[str, str]) -> dict[str, str]:
    """Return a cue's values by column after some were given, each under the spelling that the cue has already."""
    spelled = {key_of(name): name for name in before}
    merged = {**before, **{spelled.get(key_of(name), name): text for name, text in given.items()}}
    return {name: text for name, text in merged.items() if text}


def _edit(cue_prefix: str, row: int, given: Facts, cue: Cue | None, number: int | None) -> tuple[Edit, RowFault | None]:
    for fact in ("state", "need"):
        if given.get(fact, "") is None:  # an empty cell leaves it as it is
            del given[fact]
    before = {fact: getattr(cue, fact) for fact in NEW_CUE} if cue else NEW_CUE
    facts = whole_facts({**given, "extra": _with_values(before["extra"], given["extra"])}, before)
    edit = Edit(row, facts, cue, None if cue else number)
    if cue is None or facts == edit.before:
        return edit, None
    if cue.state is CueState.CUT:
        return edit, RowFault(row, None, f"{label(cue_prefix, cue.number)} is cut and can't be changed")
    if facts["state"] is CueState.CUT:
        return edit, RowFault(row, "state", f"cut {label(cue_prefix, cue.number)} on its own page with a reason")
    return edit, None


def _row_read(edit: Edit, cue_prefix: str, people: KnownPeople) -> ImportRow:
    before = edit.before
    changes = [
        FieldChange(field=fact, before=_shown(fact, before[fact], people), after=_shown(fact, value, people))
        for fact, value in edit.facts.items()
        if before and before[fact] != value
    ]
    number = edit.cue.number if edit.cue else edit.number
    shown = ("name", "file_name", "category", "description", "duration_s", "loop", "variations", "state", "due_on")
    return ImportRow(
        row=edit.row,
        action="add" if edit.cue is None else "change" if changes else "same",
        label=label(cue_prefix, number) if number else None,
        changes=changes,
        **{fact: edit.facts[fact] for fact in shown},
    )


def _shown(fact: str, value: Any, people: KnownPeople) -> Any:
    return people.text_of(value) if fact in PEOPLE.values() else value
