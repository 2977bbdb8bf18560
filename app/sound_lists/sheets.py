"""Spreadsheets as people send them: bytes or pasted text in, a head and numbered rows of text out."""

import csv
import io
import re
import zipfile
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from datetime import date, datetime, time, timedelta
from typing import IO

import python_calamine

from app.sound_lists.columns import known_heads_in
from app.sound_lists.errors import SheetUnreadable

MAX_BYTES = 5_000_000
MAX_ROWS = 10_000
MAX_COLUMNS = 200
MAX_UNPACKED_BYTES = 100_000_000
HEAD_WITHIN_ROWS = 12
SEPARATORS = ",;\t|"
READ_BYTES = 1 << 20
CELL_PLACE = re.compile(rb"""\br\s*=\s*["']([A-Za-z]{0,4})([0-9]{1,8})["']""")
Rows = list[tuple[int, list[str]]]


@dataclass(frozen=True)
class Sheet:
    """A head and the rows below it, with the numbers that the spreadsheet shows."""

    header_row: int | None  # None: the columns have no names of their own
    columns: tuple[str, ...]
    rows: Rows


def read_bytes(data: bytes) -> Sheet:
    """Return the sheet in a CSV or XLSX file, by its bytes whatever its name."""
    if len(data) > MAX_BYTES:
        raise SheetUnreadable(f"the file has {len(data):,} bytes; at most {MAX_BYTES:,} are read")
    if data.startswith(b"PK\x03\x04"):
        return _headed(_workbook_rows(data), must_have_head=True)
    if data.startswith(b"\xd0\xcf\x11\xe0"):
        raise SheetUnreadable("this is an old .xls file, or one with a password; save it as .xlsx or CSV")
    return read_text(_decoded(data), pasted=False)


def read_text(text: str, *, pasted: bool) -> Sheet:
    """Return the sheet in CSV text, or in what was pasted from a spreadsheet, which may have no head."""
    if len(text) > MAX_BYTES:
        raise SheetUnreadable(f"the text has {len(text):,} characters; at most {MAX_BYTES:,} are read")
    text = text.removeprefix("\ufeff")
    if "\0" in text:
        raise SheetUnreadable("this is not text: it holds zero bytes; save it as CSV or XLSX")
    first = 1
    if found := re.match(r"sep=(.)\r?\n", text):  # Excel's own way to name the separator
        text, first, separator = text[found.end() :], 2, found[1]
    else:
        separator = _separator(text, pasted=pasted)
    return _headed(list(enumerate(_records(text, separator), start=first)), must_have_head=not pasted)


def _decoded(data: bytes) -> str:
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return data.decode("utf-16", errors="replace")
    for encoding in ("utf-8-sig", "cp1252"):
        try:
            return data.decode(encoding)
        except UnicodeDecodeError:
            continue
    return data.decode("latin-1")


def _separator(text: str, *, pasted: bool) -> str:
    """Return what stands between cells: what gives most known heads, then most cells in most rows."""
    if pasted and "\t" in text:
        return "\t"
    start = "\n".join(text.splitlines()[:60])

    def promise(separator: str) -> tuple[int, int]:
        rows = [row for row in csv.reader(io.StringIO(start, newline=""), delimiter=separator) if row][:30]
        widths = sorted(len(row) for row in rows)
        heads = max((known_heads_in(row) for row in rows[:HEAD_WITHIN_ROWS]), default=0)
        return heads, widths[len(widths) // 2] if widths else 0

    promises = {separator: promise(separator) for separator in SEPARATORS}
    best = max(SEPARATORS, key=promises.__getitem__)
    if pasted and promises[best][0] < 2:
        return "\t"  # one column: a comma in a pasted name is part of the name
    return best


def _records(text: str, separator: str) -> list[list[str]]:
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=separator)
    try:
        records = list(reader)
    except csv.Error as error:
        raise SheetUnreadable(f"line {reader.line_num}: {error}; a quote may be opened and never closed") from None
    if text.count('"') % 2:  # only then can a quote be open at the end
        try:
            list(csv.reader(io.StringIO(text, newline=""), delimiter=separator, strict=True))
        except csv.Error as error:
            if "end of data" in str(error):
                row = len(records)
                raise SheetUnreadable(f"row {row}: a quote is opened and never closed") from None
    return records


def _workbook_rows(data: bytes) -> Rows:
    _ensure_small(data)
    try:
        workbook = python_calamine.CalamineWorkbook.from_filelike(io.BytesIO(data))
        sheets = [
            [(place, [_text_of(cell) for cell in cells]) for place, cells in enumerate(sheet, start=1)]
            for name in workbook.sheet_names
            if (sheet := workbook.get_sheet_by_name(name).to_python(skip_empty_area=False))
        ]
    except python_calamine.PasswordError:
        raise SheetUnreadable("the workbook has a password; save it without one") from None
    except (python_calamine.CalamineError, ValueError) as error:
        raise SheetUnreadable(f"this is no workbook that can be read: {error}") from None
    return max(sheets, key=_heads_in, default=[])


def _heads_in(rows: Rows) -> int:
    filled = [cells for _, cells in rows if any(cells)]
    return max((known_heads_in(cells) for cells in filled[:HEAD_WITHIN_ROWS]), default=-1)


def _ensure_small(data: bytes) -> None:
    """Raise SheetUnreadable for a workbook that would unpack to more than a list can need."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            entries = archive.infolist()
            if sum(entry.file_size for entry in entries) > MAX_UNPACKED_BYTES or len(entries) > 2000:
                raise SheetUnreadable(f"the workbook unpacks to more than {MAX_UNPACKED_BYTES:,} bytes")
            if "xl/workbook.xml" not in archive.namelist():
                raise SheetUnreadable("this is a ZIP file, and no XLSX workbook")
            for entry in entries:
                with archive.open(entry) as part:  # reading checks that the sizes told are true
                    _ensure_few_cells(part, is_sheet=entry.filename.lower().startswith("xl/worksheets/"))
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, EOFError, OSError) as error:
        raise SheetUnreadable(f"this is no workbook that can be read: {error}") from None


def _ensure_few_cells(part: IO[bytes], *, is_sheet: bool) -> None:
    tail = b""
    while block := part.read(READ_BYTES):
        if is_sheet:  # a cell far out makes the reader build all the empty ones before it
            for column, row in CELL_PLACE.findall(tail + block):
                if _column_number(column) > MAX_COLUMNS * 4 or int(row) > MAX_ROWS * 4:
                    place = (column + row).decode()
                    raise SheetUnreadable(f"cell {place} lies far outside a list; delete what stands there")
            tail = block[-64:]


def _column_number(letters: bytes) -> int:
    number = 0
    for letter in letters.upper():
        number = number * 26 + letter - 64
    return number


def _text_of(cell: object) -> str:
    if isinstance(cell, bool):
        return "yes" if cell else "no"
    if isinstance(cell, float):
        return str(int(cell)) if cell.is_integer() and abs(cell) < 1e15 else repr(cell)
    if isinstance(cell, datetime):
        return cell.date().isoformat() if cell.time() == time() else cell.isoformat(" ")
    if isinstance(cell, (date, time)):
        return cell.isoformat()
    if isinstance(cell, timedelta):
        minutes, seconds = divmod(cell.total_seconds(), 60)
        return f"{int(minutes // 60)}:{int(minutes % 60):02d}:{seconds:06.3f}"
    return str(cell)


def _headed(rows: Iterable[tuple[int, Sequence[str]]], *, must_have_head: bool) -> Sheet:
    filled = [(row, [cell.strip() for cell in cells]) for row, cells in rows]
    filled = [(row, cells) for row, cells in filled if any(cells)]
    if not filled:
        raise SheetUnreadable("the sheet is empty")
    if len(filled) > MAX_ROWS + HEAD_WITHIN_ROWS:
        raise SheetUnreadable(f"the sheet has {len(filled):,} rows; at most {MAX_ROWS:,} are read at once")
    width = max(len(cells) for _, cells in filled)
    heads = max(range(min(HEAD_WITHIN_ROWS, len(filled))), key=lambda place: known_heads_in(filled[place][1]))
    has_head = must_have_head or known_heads_in(filled[heads][1]) > 0
    if not has_head:
        named = [f"Column {place}" for place in range(1, width + 1)]
        return _sheet(None, named, filled)
    header_row, names = filled[heads]
    return _sheet(header_row, names, filled[heads + 1 :])


def _sheet(header_row: int | None, names: Sequence[str], rows: Rows) -> Sheet:
    if len(rows) > MAX_ROWS:
        raise SheetUnreadable(f"the sheet has {len(rows):,} rows; at most {MAX_ROWS:,} are read at once")
    width = max([len(names), *(len(cells) for _, cells in rows)])
    used = [
        place
        for place in range(width)
        if (place < len(names) and names[place]) or any(place < len(cells) and cells[place] for _, cells in rows)
    ]
    if len(used) > MAX_COLUMNS:
        raise SheetUnreadable(f"the sheet has {len(used)} columns; at most {MAX_COLUMNS} are read")
    columns = tuple(_distinct((names[place] if place < len(names) else "", place) for place in used))
    return Sheet(
        header_row,
        columns,
        [(row, [cells[place] if place < len(cells) else "" for place in used]) for row, cells in rows],
    )


def _distinct(names: Iterable[tuple[str, int]]) -> Iterator[str]:
    """Yield column names of which no two are alike in lower case; a column without a name gets its place."""
    seen: set[str] = set()
    for name, place in names:
        plain = " ".join(name.split())[:100] or f"Column {place + 1}"
        again = 2
        unique = plain
        while unique.lower() in seen:
            unique = f"{plain} ({again})"
            again += 1
        seen.add(unique.lower())
        yield unique
