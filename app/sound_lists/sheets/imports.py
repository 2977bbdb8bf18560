"""A spreadsheet becomes rows of the list: the rows without errors, each guess and each row left out named."""

import re
from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, field, replace
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core.plural import counted, verb
from app.projects.models import Project
from app.projects.service import project_access
from app.sound_lists import queries
from app.sound_lists.errors import ColumnUnknown
from app.sound_lists.models import Cue
from app.sound_lists.names import service as naming
from app.sound_lists.own_columns.rules import Column as OwnColumn
from app.sound_lists.own_columns.rules import by_key, kept_name, key_of, read_value
from app.sound_lists.people.rules import KnownPeople
from app.sound_lists.people.service import known_people
from app.sound_lists.rules import (
    LENGTHS,
    LINES,
    NEW_CUE,
    PEOPLE,
    CueState,
    Facts,
    label,
    read_label,
    tidy_text,
    typed_text,
)
from app.sound_lists.save_edits import Edit, RowFault, row_faults, save, whole_facts, with_fitted_values
from app.sound_lists.schemas import (
    CellEdit,
    CellGuess,
    FieldChange,
    ImportAsk,
    ImportColumn,
    ImportEncoding,
    ImportFault,
    ImportRead,
    ImportRow,
    ImportTab,
    SheetRow,
    SkippedRow,
    UnreadColumn,
)
from app.sound_lists.sheets.rules import Sheet
from audio_checks import (
    CellContext,
    ColumnGuess,
    guess_column,
    head_of,
    is_broken_formula,
    names_in_row,
    reading_of,
    rows_without_cue,
)

SAMPLES = 3
MISMAPPED = 3  # wrong cells of one column, from which on they are one fault
MAX_ROUNDS = 10  # of leaving out rows whose names depend on a row that was left out
SHOWN_HEADS = 8
SECTION_WORDS = re.compile(r"\s+(sounds?|sfx|sound effects|audio)$", re.IGNORECASE)
MAX_CELL_SHOWN = 200  # characters
KEPT: frozenset[str] = frozenset({"extra", "ignore"})
NAMES = frozenset({"name", "file_name", "number"})
OWN = "own:"  # before the name of a column of the project's own
AS_WRITTEN = "{} (as written)"  # the column that keeps a cell which says more than its field holds


@dataclass(frozen=True)
class Column:
    """A column of the sheet and how its cells are read."""

    place: int
    name: str
    samples: tuple[str, ...]
    guess: str | None
    field: str
    context: CellContext
    note: str  # what was guessed, or why the column is not read
    is_chosen: bool  # by the caller


@dataclass
class Plan:
    """The changes that a sheet would make to the list."""

    edits: list[Edit] = field(default_factory=list)
    faults: list[RowFault] = field(default_factory=list)
    guesses: list[CellGuess] = field(default_factory=list)


def import_sheet(session: Session, actor: Actor, project_id: UUID, sheet: Sheet, ask: ImportAsk) -> ImportRead:
    """Return the changes of a sheet, and apply those of its rows without errors if it is not a dry run."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    project = access.project
    queries.lock_list(session, project.id)
    cues = queries.cues_of(session, project.id)
    own = by_key(queries.own_columns(session, project.id))
    kept = {key_of(name) for cue in cues for name in cue.extra}
    people = known_people(session, access)
    _apply_edits(sheet, ask.edits)
    columns = _columns(sheet, _Known(project.cue_prefix, own, kept, people), ask)
    filled = _fill_down(sheet, ask.fill_down_columns)
    skipped = _skipped(sheet, columns, ask)
    filled += _fill_from_sections(sheet, columns, skipped) if ask.fill_down else []
    without = {row.row for row in skipped}
    read = replace(sheet, rows=[(row, cells) for row, cells in sheet.rows if row not in without])
    plan = _plan(cues, project, read, columns, ask.match, _Into(project.cue_prefix, own, people))
    plan.edits, unfit = with_fitted_values(session, project, plan.edits)
    plan.faults += unfit
    if ask.use_proposed_names:
        plan.edits = naming.with_proposals(session, project, plan.edits)
    plan.edits = _faultless(session, project, plan)
    failed = sorted({fault.row for fault in plan.faults})
    plan.faults = list(_by_column(plan.faults, columns, read))
    if not read.rows:
        plan.faults.append(RowFault(sheet.header_row or 1, None, "there are no rows below the header"))
    imports = not ask.dry_run and bool(plan.edits) and not (ask.atomic and plan.faults)
    rows = [_row_read(edit, project.cue_prefix, people) for edit in plan.edits]
    names = _names(read, columns)
    cells_by_row = dict(sheet.rows)
    refused = naming.refusals_of_edits(session, project, plan.edits)
    if imports:
        save(session, project, actor.person, plan.edits)
    return ImportRead(
        header_row=sheet.header_row,
        tabs=[ImportTab.model_validate(tab) for tab in sheet.notes["tabs"]],
        encoding=encoding_read(sheet),
        columns=[
            ImportColumn(
                name=column.name,
                samples=list(column.samples),
                guess=column.guess,
                field=column.field,
                why=column.note if column.field not in KEPT and not column.is_chosen else "",
            )
            for column in columns
        ],
        unread=_unread(columns, sheet),
        skipped=skipped,
        guesses=sorted([*filled, *plan.guesses], key=lambda guess: guess.row),
        cells=[
            SheetRow(row=row, cells=[cell[:MAX_CELL_SHOWN] for cell in cells])
            for row, cells in (sheet.rows if ask.dry_run else ())
        ],
        rows=rows,
        errors=[
            ImportFault(
                row=fault.row,
                name=names.get(fault.row, ""),
                column=_column_name(columns, fault.field),
                message=fault.message,
                text=_text_at(columns, cells_by_row.get(fault.row), fault.field),
            )
            for fault in sorted(plan.faults, key=lambda fault: fault.row)
        ],
        left_out=failed,
        refused_names=refused,
        added=sum(row.action == "add" for row in rows),
        changed=sum(row.action == "change" for row in rows),
        same=sum(row.action == "same" for row in rows),
        imported=imports,
        revision=queries.revision_number(session, project.id),
    )


def encoding_read(sheet: Sheet) -> ImportEncoding | None:
    """Return the encoding of a file as it is answered; None for a workbook."""
    notes = sheet.notes
    if not notes["encoding"]:
        return None
    return ImportEncoding(name=notes["encoding"], is_guess=notes["encoding_is_guess"], others=notes["other_encodings"])


def _unread(columns: Sequence[Column], sheet: Sheet) -> list[UnreadColumn]:
    return [
        UnreadColumn(
            name=column.name,
            is_kept=column.field == "extra",
            cells=sum(bool(cells[column.place]) for _, cells in sheet.rows),
            why=column.note,
        )
        for column in columns
        if column.field in KEPT and not column.is_chosen
    ]


def _skipped(sheet: Sheet, columns: Sequence[Column], ask: ImportAsk) -> list[SkippedRow]:
    """Return the rows that are not read: those that the caller skips, hidden ones, and those that are no cues."""
    fields = {column.place: column.field for column in columns if column.field not in KEPT}
    asked, kept = set(ask.skip_rows), set(ask.keep_rows)
    skipped = hidden_rows(sheet)
    skipped += [
        SkippedRow(row=row, kind="asked", text=", ".join(filter(None, cells))[:300], why="skipped as asked")
        for row, cells in sheet.rows
        if row in asked
    ]
    if sheet.header_row is not None:
        skipped += [
            SkippedRow(row=skipped_row.row, kind=skipped_row.kind, text=skipped_row.text, why=skipped_row.why)
            for skipped_row in rows_without_cue(sheet.rows, sheet.columns, fields, sheet.notes["merged_across"])
            if skipped_row.row not in asked | kept
        ]
    return sorted(skipped, key=lambda row: row.row)


def hidden_rows(sheet: Sheet) -> list[SkippedRow]:
    """Return the rows that the spreadsheet hides, which are not read."""
    return [
        SkippedRow(row=row, kind="hidden", text=text, why="the spreadsheet hides this row")
        for row, text in sheet.notes["hidden_rows"]
    ]


def filled_down(sheet: Sheet) -> list[CellGuess]:
    """Return the cells that took their value from a merged one above."""
    texts = dict(sheet.rows)
    return [
        _filled(row, sheet.columns[column], texts[row][column], "the cell above is merged over this row")
        for row, column in sheet.notes["filled_down"]
        if row in texts
    ]


def _apply_edits(sheet: Sheet, edits: Sequence[CellEdit]) -> None:
    """Put repaired texts into the cells of a sheet; raise ColumnUnknown for a cell that it does not have."""
    cells_by_row = dict(sheet.rows)
    for edit in edits:
        if edit.column not in sheet.columns:
            raise ColumnUnknown(f'the sheet has no column "{edit.column}"; it has {", ".join(sheet.columns)}')
        if edit.row not in cells_by_row:
            raise ColumnUnknown(f"the sheet has no row {edit.row} to repair", fix="read the sheet again")
        cells_by_row[edit.row][sheet.columns.index(edit.column)] = edit.text.strip()


def _text_at(columns: Sequence[Column], cells: Sequence[str] | None, field_name: str | None) -> str:
    place = next((column.place for column in columns if column.field == field_name), None)
    return "" if cells is None or place is None else cells[place]


def _fill_down(sheet: Sheet, names: Sequence[str]) -> list[CellGuess]:
    """Fill empty cells of columns from the cell above, as asked, and return these and those below merged cells."""
    if unknown := [name for name in names if name not in sheet.columns]:
        raise ColumnUnknown(f'the sheet has no column "{unknown[0]}"; it has {", ".join(sheet.columns)}')
    guesses = filled_down(sheet)
    for column in (sheet.columns.index(name) for name in dict.fromkeys(names)):
        above = ""
        for row, cells in sheet.rows:
            if not cells[column] and above and sum(map(bool, cells)) > 1:
                cells[column] = above
                guesses.append(_filled(row, sheet.columns[column], above, "filled from the cell above, as asked"))
            above = cells[column] or above
    return guesses


def _fill_from_sections(sheet: Sheet, columns: Sequence[Column], skipped: Sequence[SkippedRow]) -> list[CellGuess]:
    """Give the cues below the title of a section its category, where theirs is empty, and return these cells."""
    category = next((column.place for column in columns if column.field == "category"), None)
    if category is None:
        return []
    passed = {row.row: row for row in skipped}
    section, guesses = "", []
    for row, cells in sheet.rows:
        if row in passed:
            if passed[row].kind == "section":
                title = SECTION_WORDS.sub("", passed[row].text).strip()
                section = title if re.fullmatch(r"[^\W_][\w -]*", title) and len(title) <= LINES["category"] else ""
        elif section and not cells[category]:
            cells[category] = section
            guesses.append(_filled(row, sheet.columns[category], section, "from the title of the section above"))
    return guesses


def _filled(row: int, column: str, text: str, why: str) -> CellGuess:
    return CellGuess(row=row, column=column, kind="filled_down", text="", value=text[:200], why=why)


def _faultless(session: Session, project: Project, plan: Plan) -> list[Edit]:
    """Return the edits that can be saved together, and note the faults of the others."""
    failed = {fault.row for fault in plan.faults}
    edits = [edit for edit in plan.edits if edit.row not in failed]
    for _ in range(MAX_ROUNDS):
        faults = row_faults(session, project, edits)
        if not faults:
            return edits
        plan.faults += faults
        failed = {fault.row for fault in faults}  # a name that such a row gives up stays taken
        edits = [edit for edit in edits if edit.row not in failed]
    plan.faults += [RowFault(edit.row, None, "its name depends on a row that has an error") for edit in edits]
    return []


def _names(sheet: Sheet, columns: Sequence[Column]) -> dict[int, str]:
    name_column = next((column.place for column in columns if column.field == "name"), None)
    return {} if name_column is None else {row: cells[name_column] for row, cells in sheet.rows}


@dataclass(frozen=True)
class _Known:
    """Possible meanings of a sheet's columns, besides the fields."""

    cue_prefix: str
    own: Mapping[str, OwnColumn]
    kept: Set[str]  # names under which cues keep values, own columns or not
    people: KnownPeople


def _columns(sheet: Sheet, known: _Known, ask: ImportAsk) -> list[Column]:
    mapping = ask.mapping or {}
    if unknown := [name for name in mapping if name not in sheet.columns]:
        raise ColumnUnknown(f'the sheet has no column "{unknown[0]}"; it has {", ".join(sheet.columns)}')
    chosen = {wanted for wanted in mapping.values() if wanted not in KEPT}
    for wanted in sorted(chosen):
        if wanted.startswith(OWN) and key_of(wanted.removeprefix(OWN)) not in known.own:
            raise ColumnUnknown(f'the list has no column of its own called "{wanted.removeprefix(OWN)}"')
        if len(names := [name for name, given in mapping.items() if given == wanted]) > 1:
            raise ColumnUnknown(f"two columns are mapped to {wanted.removeprefix(OWN)}: {', '.join(names)}")
    rates = CellContext(frame_rate_fps=ask.frame_rate_fps, sample_rate_hz=ask.sample_rate_hz, day_first=ask.day_first)
    taken: dict[str, str] = {}
    columns = []
    for index, name in enumerate(sheet.columns):
        cells = [cells[index] for _, cells in sheet.rows]
        guess = _guessed(sheet, index, name, cells, known, rates)
        found, note = guess.field, guess.note
        if found and found in taken:
            note, found = f'{found} is read from the column "{taken[found]}" already', None
        if found:
            taken[found] = name
        free = found if found and found not in chosen else "extra"
        if found in chosen and name not in mapping:
            note = f"another column is mapped to {(found or '').removeprefix(OWN)}"
        if name in sheet.notes["hidden_columns"]:
            free, note = "ignore", "the spreadsheet hides this column"
        columns.append(
            Column(
                place=index,
                name=name,
                samples=tuple(dict.fromkeys(cell[:200] for cell in cells if cell))[:SAMPLES],
                guess=found,
                field=mapping.get(name, free),
                context=guess.context,
                note=note or ("" if found else "no field of the list is called so; it is kept as it is"),
                is_chosen=name in mapping,
            )
        )
    return columns


def _guessed(
    sheet: Sheet, index: int, name: str, cells: Sequence[str], known: _Known, rates: CellContext
) -> ColumnGuess:
    key = key_of(typed_text(name))
    typed = [typed_text(cell) for cell in cells]
    has_rate_column = any(head_of(column).field == "frame_rate_fps" for column in sheet.columns)
    guess = guess_column(name, typed, rates, has_rate_column=has_rate_column)
    if sheet.header_row is None:
        guess = guess_column("", typed, rates)
        return replace(guess, field=("name", "description")[index] if index < 2 else None)
    if guess.is_ours:
        return guess
    if key in known.own:
        return replace(guess, field=f"{OWN}{known.own[key].name}", note="")
    if key in known.kept:
        return replace(guess, field=None, note="cues of this list keep it as it is already")
    filled = [cell for cell in typed if cell]
    if guess.field == "number":
        labels = sum(read_label(known.cue_prefix, cell) is not None for cell in filled)
        if 2 * labels < len(filled):
            others = len(filled) - labels
            are = verb(others, "is no ID", "are no IDs")
            why = f"{others} of {counted(len(filled), 'cell')} {are} such as {label(known.cue_prefix, 14)}"
            return replace(guess, field=None, note=why)
    if guess.field in PEOPLE and filled and not any(_is_person(known.people, cell) for cell in filled):
        return replace(guess, field=None, note="no cell names a person of this project")
    return guess


def _is_person(people: KnownPeople, text: str) -> bool:
    try:
        return people.id_of(text) is not None
    except ValueError:
        return False


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
        faults = list(_read_row(columns, into, row, cells, given, plan.guesses))
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
    """Yield one fault for a column that is mapped to the wrong field, or for no names, and every other as it is."""
    nameless = [fault for fault in faults if fault.field == "name"]
    if nameless and not any(column.field in ("name", "file_name") for column in columns):
        rows = counted(len(nameless), "row")
        heads = ", ".join(column.name[:40] for column in columns[:SHOWN_HEADS])
        yield RowFault(
            nameless[0].row,
            "name",
            f"no column is read as the name, and {rows} {verb(len(nameless), 'has', 'have')} none; "
            f"choose the column of names: {heads}",
        )
        faults = [fault for fault in faults if fault.field != "name"]
    for column in columns:
        own = [fault for fault in faults if fault.field == column.field]
        filled = sum(bool(cells[column.place].strip()) for _, cells in sheet.rows)
        if column.field not in {*KEPT, "name"} and len(own) >= MISMAPPED and 2 * len(own) > filled:
            first = own[0]
            yield RowFault(
                first.row,
                first.field,
                f"{len(own)} of {counted(filled, 'cell')} in this column {verb(len(own), 'does', 'do')} not fit: "
                f"{first.message}; "
                "map the column to another field, or ignore it",
            )
            faults = [fault for fault in faults if fault.field != column.field]
    yield from faults


@dataclass(frozen=True)
class _Into:
    """The reference for the reading of cells."""

    cue_prefix: str
    own: Mapping[str, OwnColumn]
    people: KnownPeople


def _read_row(
    columns: Sequence[Column], into: _Into, row: int, cells: Sequence[str], given: Facts, guesses: list[CellGuess]
) -> Iterator[RowFault]:
    """Add a row's values to `given` and its guesses to `guesses`, and yield the cells that cannot be read."""
    extra: dict[str, str] = {}
    as_written: dict[str, str] = {}
    bounds: Facts = {}  # in columns of their own

    def note(column: Column, kind: str, text: str, value: object, why: str) -> None:
        guesses.append(
            CellGuess(row=row, column=column.name, kind=kind, text=text[:200], value=str(value)[:200], why=why)
        )

    rate = _rate_in_row(columns, cells)
    for column in columns:
        text = typed_text(cells[column.place])
        is_broken = is_broken_formula(cells[column.place])
        if column.field == "ignore":
            continue
        if column.field == "extra":
            if is_broken:
                note(column, "broken_formula", text, "", "a broken formula is not kept")
                text = ""
            extra[kept_name(typed_text(column.name))] = tidy_text(text)
        elif is_broken:
            yield RowFault(row, column.field, f'"{text[:40]}" is a broken formula; repair it in the spreadsheet')
        elif column.field.startswith(OWN):
            own = into.own[key_of(column.field.removeprefix(OWN))]
            try:
                extra[own.name] = read_value(own, text, column.context.day_first)
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
                    continue
                cell = cells[column.place] if is_broken_formula(text) else text  # its quote says that it is text
                reading = reading_of(
                    column.field, cell, replace(column.context, frame_rate_fps=rate) if rate else column.context
                )
            except ValueError as error:
                yield RowFault(row, column.field, str(error))
                continue
            value = text if cell != text and reading.value == cell else reading.value
            if column.field in LENGTHS[1:]:
                bounds[column.field] = value
                continue
            given[column.field] = value
            if column.field == "duration_s":
                given |= {"duration_min_s": reading.low, "duration_max_s": reading.high}
            if reading.note:
                is_bound = reading.low is not None or reading.high is not None
                shown = reading.note if is_bound else "" if reading.value is None else reading.value
                note(column, "reading", text, shown, "bounds of a length" if is_bound else reading.note)
            if reading.is_part:
                as_written[AS_WRITTEN.format(column.name)[:100]] = tidy_text(text)
    if "name" in given or "file_name" in given:
        try:
            names = names_in_row(given.get("name", ""), given.get("file_name", ""))
        except ValueError as error:
            yield RowFault(row, "file_name" if "file_name" in given else "name", str(error))
            return
        if names.variations is not None:
            given["variations"] = names.variations
        if names.note:
            column = next(column for column in columns if column.field in ("name", "file_name"))
            shown = given.get("name") or given.get("file_name", "")
            note(column, "name", shown, names.file_name or names.name, names.note)
        if "name" in given or names.name:
            given["name"] = names.name
        if "file_name" in given or names.file_name:
            given["file_name"] = names.file_name
    given |= {field: value for field, value in bounds.items() if value is not None or field not in given}
    given["extra"] = extra | as_written


def _rate_in_row(columns: Sequence[Column], cells: Sequence[str]) -> float | None:
    """Return the frame rate that a row gives itself, for its lengths in frames."""
    column = next((column for column in columns if column.field == "frame_rate_fps"), None)
    if column is None:
        return None
    try:
        rate: float | None = reading_of("frame_rate_fps", typed_text(cells[column.place])).value
    except ValueError:
        return None  # said when the column itself is read
    return rate


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
    texts = ("name", "file_name", "category", "description")
    shown = (*texts, *LENGTHS, "loop", "channels", "variations", "state", "due_on")
    return ImportRow(
        row=edit.row,
        action="add" if edit.cue is None else "change" if changes else "same",
        label=label(cue_prefix, number) if number else None,
        changes=changes,
        **{fact: edit.facts[fact] for fact in shown},
    )


def _shown(fact: str, value: Any, people: KnownPeople) -> Any:
    return people.text_of(value) if fact in PEOPLE.values() else value
