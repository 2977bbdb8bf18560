"""Spreadsheets as people send them: bytes or pasted text in, a head and numbered rows of text out.

All of it runs in a child process (`app.kit.parsing`): a workbook of a kilobyte can make its reader allocate terabytes.
"""

import csv
import io
import re
import zipfile
import zlib
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from datetime import date, datetime, time, timedelta
from typing import IO

import python_calamine

from app.sound_lists.columns import known_heads_in, number_text
from app.sound_lists.errors import SheetUnreadable

MAX_BYTES = 5_000_000
MAX_ROWS = 10_000  # with something in them
MAX_COLUMNS = 200  # with something in them
MAX_FILLED_CELLS = 400_000
MAX_CELL_CHARACTERS = 10_000  # as many as the longest text of a cue
MAX_CHARACTERS = 10_000_000
MAX_SHEETS = 50
MAX_PARTS = 2_000
MAX_UNPACKED_BYTES = 100_000_000
# How far down and to the right a workbook may have values: its reader makes all the empty cells before them.
LAST_ROW, LAST_COLUMN, MAX_AREA = 50_000, 2_000, 5_000_000
HEAD_WITHIN_ROWS = 12
SEPARATORS = ",;\t|"
FAR_OUT = "delete what stands far below the list, or far to its right"
SAVE_AGAIN = "open it in your spreadsheet and save it again"
IN_PARTS = "import it in several parts"
READ_BYTES = 1 << 20
MAX_TAG_BYTES = 400
# A cell that is neither empty by itself nor closed at once. No piece can be matched in two ways.
CELL = re.compile(rb"<(?:[A-Za-z0-9]{1,20}:)?c\s([^<>]{0,300}+)>(?!</)")
CELL_PLACE = re.compile(rb"""(?:^|\s)r\s{0,9}=\s{0,9}["']([A-Za-z]{1,9})([0-9]{1,20})["']""")
Rows = list[tuple[int, list[str]]]
HeadsIn = Callable[[Sequence[str]], int]  # how many cells of a row are heads that the reader of the sheet knows


@dataclass(frozen=True)
class Sheet:
    """A head and the rows below it, with the numbers that the spreadsheet shows."""

    header_row: int | None  # None: the columns have no names
    columns: tuple[str, ...]
    rows: Rows


def parse_bytes(data: bytes, heads_in: HeadsIn = known_heads_in) -> tuple[int | None, tuple[str, ...], Rows]:
    """Return the fields of the sheet in a CSV or XLSX file, by its bytes whatever its name."""
    if len(data) > MAX_BYTES:
        raise SheetUnreadable(f"a file may have {MAX_BYTES:,} bytes; this one has {len(data):,}")
    if data.startswith(b"PK\x03\x04"):
        return _headed(iter(_workbook_rows(data, heads_in)), heads_in, must_have_head=True)
    if data.startswith(b"\xd0\xcf\x11\xe0"):
        raise SheetUnreadable("this is an old .xls file, or one with a password; save it as .xlsx or CSV")
    return parse_text(decoded(data), pasted=False, heads_in=heads_in)


def parse_text(text: str, pasted: bool, heads_in: HeadsIn = known_heads_in) -> tuple[int | None, tuple[str, ...], Rows]:
    """Return the fields of the sheet in CSV text, or in what was pasted from a spreadsheet, which may have no head."""
    if len(text) > MAX_BYTES:
        raise SheetUnreadable(f"a text may have {MAX_BYTES:,} characters; this one has {len(text):,}")
    text = text.removeprefix("\ufeff")
    if (place := text.find("\0")) >= 0:
        raise SheetUnreadable(
            f"row {_row_at(text, place)}: this is not text: it holds zero bytes; save it as CSV or XLSX"
        )
    csv.field_size_limit(MAX_BYTES)  # of this process; what is too long for us is refused with its row and column
    first = 1
    if found := re.match(rf"sep=([{SEPARATORS}:])\r?\n", text):  # Excel's own way to name the separator
        text, first, separator = text[found.end() :], 2, found[1]
    else:
        separator = _separator(text, heads_in, pasted=pasted)
    return _headed(enumerate(_records(text, separator), start=first), heads_in, must_have_head=not pasted)


def _row_at(text: str, place: int) -> int:
    return text.count("\n", 0, place) + 1


def decoded(data: bytes) -> str:
    """Return the text of bytes in UTF-8, UTF-16 or Windows-1252; raise SheetUnreadable for a damaged character."""
    if wide := _wide_encoding(data):
        return _strictly(data, wide, "UTF-16")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        guess = data.decode("utf-8", "replace")
    damaged = guess.count("\ufffd")
    if sum(not letter.isascii() for letter in guess) >= 2 * damaged:  # the rest of it is UTF-8
        return _strictly(data, "utf-8-sig", "UTF-8")
    try:
        return data.decode("cp1252")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def _wide_encoding(data: bytes) -> str | None:
    """Return which UTF-16 the bytes are in, by their mark or by their zero bytes; None for another encoding."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return "utf-16"
    start = data[:400]
    for encoding, zeros, others in (("utf-16-le", start[1::2], start[::2]), ("utf-16-be", start[::2], start[1::2])):
        if len(zeros) > 1 and 2 * zeros.count(0) > len(zeros) and others.count(0) == 0:
            return encoding
    return None


def _strictly(data: bytes, encoding: str, name: str) -> str:
    try:
        return data.decode(encoding)
    except UnicodeDecodeError as error:
        row = _row_at(data[: error.start].decode(encoding, "ignore"), len(data))
        raise SheetUnreadable(f"row {row}: a character is damaged or cut off; the file is {name} otherwise") from None


def _separator(text: str, heads_in: HeadsIn, *, pasted: bool) -> str:
    """Return what stands between cells: what gives most known heads, then most cells in most rows."""
    if pasted and "\t" in text:
        return "\t"
    start = "\n".join(text[:200_000].splitlines()[:60])

    def promise(separator: str) -> tuple[int, int]:
        rows = [row for row in csv.reader(io.StringIO(start, newline=""), delimiter=separator) if row][:30]
        widths = sorted(len(row) for row in rows)
        heads = max((heads_in(row[:LAST_COLUMN]) for row in rows[:HEAD_WITHIN_ROWS]), default=0)
        return heads, widths[len(widths) // 2] if widths else 0

    promises = {separator: promise(separator) for separator in SEPARATORS}
    best = max(SEPARATORS, key=promises.__getitem__)
    if pasted and promises[best][0] < 2:
        return "\t"  # one column: a comma in a pasted name is part of the name
    return best


def _records(text: str, separator: str) -> Iterator[list[str]]:
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=separator)
    row = 0
    try:
        for record in reader:
            row += 1
            yield record
    except csv.Error as error:
        raise SheetUnreadable(f"line {reader.line_num}: {error}; a quote may be opened and never closed") from None
    if text.count('"') % 2:  # only then can a quote be open at the end
        try:
            for _ in csv.reader(io.StringIO(text, newline=""), delimiter=separator, strict=True):
                pass
        except csv.Error as error:
            if "end of data" in str(error):
                raise SheetUnreadable(f"row {row}: a quote is opened and never closed") from None


def _workbook_rows(data: bytes, heads_in: HeadsIn) -> Rows:
    _ensure_small(data)
    try:
        workbook = python_calamine.CalamineWorkbook.from_filelike(io.BytesIO(data))
        if len(workbook.sheet_names) > MAX_SHEETS:
            raise SheetUnreadable(f"a workbook may have {MAX_SHEETS} sheets; this one has {len(workbook.sheet_names)}")
        sheets = [list(_filled_rows(workbook.get_sheet_by_name(name))) for name in workbook.sheet_names]
    except python_calamine.PasswordError:
        raise SheetUnreadable("the workbook has a password; save it without one") from None
    except (python_calamine.CalamineError, ValueError) as error:
        raise SheetUnreadable(f"this is not a workbook that can be read: {error}") from None
    return max(sheets, key=lambda rows: _most_heads(rows, heads_in), default=[])


def _filled_rows(sheet: python_calamine.CalamineSheet) -> Iterator[tuple[int, list[str]]]:
    for place, cells in enumerate(sheet.to_python(skip_empty_area=False), start=1):
        texts = [cell if isinstance(cell, str) else _text_of(cell) for cell in cells]
        if any(texts):
            yield place, texts


def _most_heads(rows: Rows, heads_in: HeadsIn) -> int:
    return max((heads_in(cells) for _, cells in rows[:HEAD_WITHIN_ROWS]), default=-1)


def _ensure_small(data: bytes) -> None:
    """Raise SheetUnreadable for a workbook that would unpack to more than a list can need."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            entries = archive.infolist()
            unpacked = sum(entry.file_size for entry in entries)
            if unpacked > MAX_UNPACKED_BYTES:
                raise SheetUnreadable(
                    f"a workbook may unpack to {MAX_UNPACKED_BYTES:,} bytes; this one to {unpacked:,}"
                )
            if len(entries) > MAX_PARTS:
                raise SheetUnreadable(f"a workbook may have {MAX_PARTS:,} parts; this one has {len(entries):,}")
            if "xl/workbook.xml" not in archive.namelist():
                raise SheetUnreadable("this is a ZIP file, and no XLSX workbook")
            for entry in entries:
                with archive.open(entry) as part:  # reading checks the announced sizes
                    name = entry.filename.lower()
                    is_xml = name.endswith((".xml", ".rels"))
                    _ensure_small_area(part, is_xml=is_xml, is_sheet=name.startswith("xl/worksheets/"))
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, EOFError, OSError, zlib.error) as error:
        raise SheetUnreadable(f"this is not a workbook that can be read: {error}") from None


def _ensure_small_area(part: IO[bytes], *, is_xml: bool, is_sheet: bool) -> None:
    # The workbook's reader keeps what stands between two tags as a whole, where 99 MB take 190 MiB.
    tail = b""
    last_row = last_column = 0
    while block := part.read(READ_BYTES):
        if is_xml and len(block) == READ_BYTES and b"<" not in block:
            raise SheetUnreadable("a part of the workbook has 1 MiB without a cell or a tag", fix=SAVE_AGAIN)
        if not is_sheet:
            continue
        for cell in CELL.finditer(tail + block):
            place = CELL_PLACE.search(cell[1])
            if place is None or cell[1].endswith(b"/"):
                continue
            row, column = int(place[2]), _column_number(place[1])
            last_row, last_column = max(last_row, row), max(last_column, column)
            for count, most, what in ((row, LAST_ROW, "rows"), (column, LAST_COLUMN, "columns")):
                if count > most:
                    last = f"{place[1].decode()}{row}"
                    raise SheetUnreadable(
                        f"a sheet may have {most:,} {what}; this one has {count:,}, up to cell {last}", fix=FAR_OUT
                    )
        tail = block[-MAX_TAG_BYTES:]
    if last_row * last_column > MAX_AREA:
        raise SheetUnreadable(
            f"a sheet may have {MAX_AREA:,} cells, the empty ones too; this one has {last_row:,} rows and "
            f"{last_column:,} columns",
            fix=FAR_OUT,
        )


def _column_number(letters: bytes) -> int:
    number = 0
    for letter in letters.upper():
        number = number * 26 + letter - 64
    return number


def _text_of(cell: object) -> str:
    if isinstance(cell, bool):
        return "yes" if cell else "no"
    if isinstance(cell, float):
        return number_text(cell)
    if isinstance(cell, datetime):
        return cell.date().isoformat() if cell.time() == time() else cell.isoformat(" ")
    if isinstance(cell, (date, time)):
        return cell.isoformat()
    if isinstance(cell, timedelta):
        minutes, seconds = divmod(cell.total_seconds(), 60)
        return f"{int(minutes // 60)}:{int(minutes % 60):02d}:{seconds:06.3f}"
    return str(cell)


def _headed(
    rows: Iterator[tuple[int, list[str]]], heads_in: HeadsIn, *, must_have_head: bool
) -> tuple[int | None, tuple[str, ...], Rows]:
    filled = list(_bounded(rows))
    if not filled:
        raise SheetUnreadable("the sheet is empty")
    heads = max(range(min(HEAD_WITHIN_ROWS, len(filled))), key=lambda place: heads_in(filled[place][1]))
    has_head = must_have_head or heads_in(filled[heads][1]) > 0
    header_row, names = filled[heads] if has_head else (None, [])
    return _with_columns(header_row, names, filled[heads + 1 :] if has_head else filled)


def _bounded(rows: Iterator[tuple[int, list[str]]]) -> Iterator[tuple[int, list[str]]]:
    """Yield the rows that have something in them; raise SheetUnreadable where they are too many, or too large."""
    filled_rows = filled_cells = characters = 0
    for row, cells in rows:
        filled = [(place, text) for place, cell in enumerate(cells) if (text := cell.strip())]
        if not filled:
            continue
        filled_rows += 1
        if filled_rows > MAX_ROWS + HEAD_WITHIN_ROWS:
            raise _too_many_rows(filled_rows + sum(any(map(str.strip, cells)) for _, cells in rows))
        filled_cells += len(filled)
        characters += sum(len(text) for _, text in filled)
        for place, text in filled:
            if len(text) > MAX_CELL_CHARACTERS:
                raise SheetUnreadable(
                    f"row {row}, column {place + 1}: a cell may have {MAX_CELL_CHARACTERS:,} characters; "
                    f"this one has {len(text):,}"
                )
        if len(filled) > MAX_COLUMNS:
            raise SheetUnreadable(
                f"row {row}: a sheet may have {MAX_COLUMNS} columns; this row has {len(filled):,} filled cells"
            )
        for count, most, what in (
            (filled_cells, MAX_FILLED_CELLS, "filled cells"),
            (characters, MAX_CHARACTERS, "characters in its cells"),
        ):
            if count > most:
                raise SheetUnreadable(f"row {row}: a sheet may have {most:,} {what}; this one has more", fix=IN_PARTS)
        texts = [""] * (filled[-1][0] + 1)
        for place, text in filled:
            texts[place] = text
        yield row, texts


def _too_many_rows(count: int) -> SheetUnreadable:
    return SheetUnreadable(f"a sheet may have {MAX_ROWS:,} rows; this one has {count:,}", fix=IN_PARTS)


def _with_columns(header_row: int | None, names: Sequence[str], rows: Rows) -> tuple[int | None, tuple[str, ...], Rows]:
    if len(rows) > MAX_ROWS:
        raise _too_many_rows(len(rows))
    used = sorted(
        {place for cells in (names, *(cells for _, cells in rows)) for place, cell in enumerate(cells) if cell}
    )
    if len(used) > MAX_COLUMNS:
        raise SheetUnreadable(f"a sheet may have {MAX_COLUMNS} columns; this one has {len(used):,}")
    if header_row is None:
        names = [f"Column {place + 1}" for place in range(used[-1] + 1)]
    columns = tuple(_distinct((names[place] if place < len(names) else "", place) for place in used))
    return (
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
