"""A sheet of designers becomes entries of the roster: all of its rows, or none."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.hiring.errors import RosterInvalid
from app.hiring.models import RosterEntry
from app.hiring.roster import queries as roster_queries
from app.hiring.roster.columns import MAX_CELL_CHARS, RosterField, field_of, read_cell
from app.hiring.roster.rules import MAX_ENTRIES
from app.hiring.roster.schemas import RosterImportColumn, RosterImportFault, RosterImportRead, RosterImportRow
from app.hiring.roster.service import RosterAccess, ensure_links, put_facts, roster_access
from app.sound_lists.errors import ColumnUnknown
from app.sound_lists.sheets.rules import Sheet

SAMPLES = 3
TOGETHER = (RosterField.NOTES, RosterField.IGNORE)  # fields that several columns can be read as
NEW_ENTRY: Mapping[str, Any] = {"specialities": [], "services": [], "languages": [], "links": []}


@dataclass(frozen=True)
class Column:
    """A column of the sheet and what its cells are read as."""

    place: int
    name: str
    field: RosterField


@dataclass
class PlannedRow:
    """A row's content, its person, and its faults."""

    row: int
    facts: dict[str, Any]
    faults: list[RosterImportFault] = field(default_factory=list)
    entry: RosterEntry | None = None  # None: a new one

    @property
    def changed(self) -> list[RosterField]:
        """The fields that differ from what is on file."""
        if self.entry is None:
            return []
        names = [name for name, value in self.facts.items() if getattr(self.entry, name) != value]
        return list(dict.fromkeys(RosterField("rate" if name.startswith("rate_") else name) for name in names))


def import_roster(
    session: Session,
    actor: Actor,
    studio_id: UUID,
    sheet: Sheet,
    *,
    mapping: Mapping[str, RosterField],
    dry_run: bool,
) -> RosterImportRead:
    """Return the additions and changes of a sheet, and do them where it has no errors and is not a dry run."""
    access = roster_access(session, actor, studio_id)
    roster_queries.lock_roster(session, studio_id)
    columns = _columns(sheet, mapping)
    rows = [_read_row(columns, row, cells) for row, cells in sheet.rows]
    faults = _sheet_faults(sheet, columns, access)
    if not faults:
        _find_entries(session, studio_id, rows)
        faults = _room_faults(session, studio_id, rows)
    faults += [fault for row in rows for fault in row.faults]
    imports = not dry_run and not faults
    answer = RosterImportRead(
        header_row=sheet.header_row,
        columns=[
            RosterImportColumn(name=column.name, samples=_samples(sheet, column.place), field=column.field)
            for column in columns
        ],
        rows=[_row_read(row) for row in rows if not row.faults],
        errors=sorted(faults, key=lambda fault: fault.row),
        added=sum(row.entry is None for row in rows if not row.faults),
        changed=sum(bool(row.changed) for row in rows if not row.faults),
        same=sum(row.entry is not None and not row.changed for row in rows if not row.faults),
        imported=imports,
    )
    if imports:
        _save(session, actor, studio_id, rows)
    return answer


def _columns(sheet: Sheet, mapping: Mapping[str, RosterField]) -> list[Column]:
    if unknown := [name for name in mapping if name not in sheet.columns]:
        raise ColumnUnknown(f'the sheet has no column "{unknown[0]}"; it has {", ".join(sheet.columns)}')
    chosen = [wanted for wanted in mapping.values() if wanted not in TOGETHER]
    for wanted in chosen:
        if chosen.count(wanted) > 1:
            names = [name for name, given in mapping.items() if given == wanted]
            raise ColumnUnknown(f"two columns are mapped to {wanted}: {', '.join(names)}")
    taken = set(chosen)
    columns = []
    for index, name in enumerate(sheet.columns):
        guess = mapping.get(name) or field_of(name) or RosterField.IGNORE
        if name not in mapping and guess in taken and guess not in TOGETHER:
            guess = RosterField.IGNORE
        taken.add(guess)
        columns.append(Column(index, name, guess))
    return columns


def _samples(sheet: Sheet, index: int) -> list[str]:
    return list(dict.fromkeys(cells[index][:200] for _, cells in sheet.rows if cells[index]))[:SAMPLES]


def _sheet_faults(sheet: Sheet, columns: Sequence[Column], access: RosterAccess) -> list[RosterImportFault]:
    head = sheet.header_row or 1
    if not sheet.rows:
        return [RosterImportFault(row=head, column=None, message="there are no rows below the header")]
    faults = [
        RosterImportFault(
            row=head,
            column=None,
            message=f"wanted a column with the {wanted.value}, found {', '.join(sheet.columns)[:200]}",
        )
        for wanted in (RosterField.NAME, RosterField.EMAIL)
        if all(column.field is not wanted for column in columns)
    ]
    rate = next((column for column in columns if column.field is RosterField.RATE), None)
    if rate and not access.is_producer:
        message = "only a producer of the studio imports rates; ignore this column"
        faults.append(RosterImportFault(row=head, column=rate.name, message=message))
    return faults


def _read_row(columns: Sequence[Column], row: int, cells: Sequence[str]) -> PlannedRow:
    """Read the filled cells of a row; an empty cell leaves what is on file."""
    planned = PlannedRow(row, {})
    notes = [(column, cells[column.place].strip()) for column in columns if column.field is RosterField.NOTES]
    filled = [(column, text) for column, text in notes if text]
    if filled:
        lines = [text if len(notes) == 1 else f"{column.name}: {text}" for column, text in filled]
        planned.facts["notes"] = "\n".join(lines)[:MAX_CELL_CHARS]
    for column in columns:
        text = cells[column.place].replace("\0", "").strip()
        is_needed = column.field in (RosterField.NAME, RosterField.EMAIL)
        if column.field in TOGETHER or not (text or is_needed):
            continue
        try:
            if not text:
                raise ValueError(f"wanted the {column.field.value}, found an empty cell")
            value = read_cell(column.field, text)
        except ValueError as error:
            planned.faults.append(RosterImportFault(row=row, column=column.name, message=str(error)))
            continue
        planned.facts |= value if column.field is RosterField.RATE else {column.field.value: value}
    return planned


def _find_entries(session: Session, studio_id: UUID, rows: Sequence[PlannedRow]) -> None:
    """Find the person of each row by address; a second row for one address is a fault."""
    known = {entry.email: entry for entry in roster_queries.entries_of(session, studio_id)}
    first: dict[str, int] = {}
    for planned in rows:
        email = planned.facts.get("email")
        if email is None:
            continue
        planned.entry = known.get(email)
        if first.setdefault(email, planned.row) != planned.row:
            message = f"row {first[email]} has the same address"
            planned.faults.append(RosterImportFault(row=planned.row, column="email", message=message))
        try:
            ensure_links(planned.facts.get("links", []))
        except RosterInvalid as error:
            planned.faults.append(RosterImportFault(row=planned.row, column="links", message=error.message))


def _room_faults(session: Session, studio_id: UUID, rows: Sequence[PlannedRow]) -> list[RosterImportFault]:
    after = roster_queries.entries_count(session, studio_id) + sum(row.entry is None for row in rows)
    if after <= MAX_ENTRIES:
        return []
    message = f"a roster has {MAX_ENTRIES:,} people at most; this sheet would make it {after:,}"
    return [RosterImportFault(row=rows[0].row, column=None, message=message)]


def _row_read(planned: PlannedRow) -> RosterImportRow:
    return RosterImportRow(
        row=planned.row,
        action="add" if planned.entry is None else "change" if planned.changed else "same",
        name=planned.facts.get("name", ""),
        email=planned.facts.get("email", ""),
        changed=planned.changed,
    )


def _save(session: Session, actor: Actor, studio_id: UUID, rows: Sequence[PlannedRow]) -> None:
    for planned in rows:
        if planned.entry is None:
            entry = RosterEntry(studio_id=studio_id, added_by=actor.person, revision=1)
            put_facts(entry, {**NEW_ENTRY, **planned.facts})
            session.add(entry)
        elif planned.changed:
            put_facts(planned.entry, planned.facts)
    session.flush()
