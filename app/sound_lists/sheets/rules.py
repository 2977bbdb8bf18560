"""Spreadsheets as people send them: bytes or pasted text in, a head and numbered rows of text out.

All of it runs in a child process (`app.core.parsing`): a workbook of a kilobyte can make its reader allocate terabytes.
What was guessed or left out on the way is answered beside the rows, as `SheetNotes`.
"""

import csv
import html
import io
import posixpath
import re
import zipfile
import zlib
from bisect import bisect_left
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from datetime import date, datetime, time, timedelta
from typing import IO, Any, NamedTuple, TypedDict

import python_calamine

from app.sound_lists.errors import SheetUnreadable
from audio_checks import (
    CODE_PAGES,
    TableUnreadable,
    TextDamaged,
    decode_text,
    headed,
    known_heads_in,
    number_text,
    records,
)

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
MAX_HEADS_SHOWN = 12  # of a tab
FAR_OUT = "delete what stands far below the list, or far to its right"
SAVE_AGAIN = "open it in your spreadsheet and save it again"
IN_PARTS = "import it in several parts"
READ_BYTES = 1 << 20
MAX_TAG_BYTES = 9_000  # of a cell with a broken formula; of any other, the attributes alone count
# A cell that is neither empty by itself nor closed at once. No piece can be matched in two ways.
CELL = re.compile(rb"<(?:[A-Za-z0-9]{1,20}:)?c\s([^<>]{0,300}+)>(?!</)")
CELL_PLACE = re.compile(rb"""(?:^|\s)r\s{0,9}=\s{0,9}["']([A-Za-z]{1,9})([0-9]{1,20})["']""")
# A cell whose formula has no result, which the workbook's reader takes for an empty one.
BROKEN_CELL = re.compile(
    rb"<(?:[A-Za-z0-9]{1,20}:)?c\s([^<>]{0,300}+)>"
    rb"(?:<(?:[A-Za-z0-9]{1,20}:)?f(?:\s[^<>]{0,300}+)?>[^<>]{0,8200}+</(?:[A-Za-z0-9]{1,20}:)?f>)?"
    rb"<(?:[A-Za-z0-9]{1,20}:)?v>(#[^<>]{1,20}+)</"
)
HIDDEN_TAG = re.compile(rb"<(?:[A-Za-z0-9]{1,20}:)?(row|col)\s([^<>]{0,300}+)>")
ATTRIBUTE = re.compile(r"""(?:^|\s)([A-Za-z:]{1,20})\s{0,9}=\s{0,9}["']([^"'<>]{0,400})["']""")
TAB_TAG = re.compile(r"<(?:[A-Za-z0-9]{1,20}:)?sheet\s([^<>]{1,2000}+)>")
RELATION_TAG = re.compile(r"<(?:[A-Za-z0-9]{1,20}:)?Relationship\s([^<>]{1,2000}+)>")
Rows = list[tuple[int, list[str]]]
HeadsIn = Callable[[Sequence[str]], int]  # how many cells of a row are heads that the reader of the sheet knows


class Tab(TypedDict):
    """A tab of a workbook."""

    name: str
    rows: int  # with something in them, the head too
    heads: list[str]
    is_hidden: bool
    is_read: bool


class SheetNotes(TypedDict):
    """Guesses and omissions on the way from a file to rows."""

    tabs: list[Tab]  # none for a text
    encoding: str  # empty for a workbook, and for a text that came as text
    encoding_is_guess: bool
    other_encodings: list[str]
    filled_down: list[tuple[int, int]]  # the row and the column from 0 of cells filled from a merged one above
    hidden_rows: list[tuple[int, str]]  # left out: the row, and its cells as one text
    hidden_columns: list[str]
    merged_across: list[int]  # rows with a cell that is merged over several columns


ParsedSheet = tuple[int | None, tuple[str, ...], Rows, SheetNotes]


class SheetOptions(NamedTuple):
    """Facts of a file that a caller gives and the file does not."""

    tab: str | None = None
    encoding: str | None = None
    fill_down: bool = True
    keep_hidden: bool = False


AS_FOUND = SheetOptions()


def no_notes() -> SheetNotes:
    """Return the notes of a sheet about which nothing was guessed."""
    return SheetNotes(
        tabs=[],
        encoding="",
        encoding_is_guess=False,
        other_encodings=[],
        filled_down=[],
        hidden_rows=[],
        hidden_columns=[],
        merged_across=[],
    )


@dataclass(frozen=True)
class Sheet:
    """A head and the rows below it, with the numbers that the spreadsheet shows."""

    header_row: int | None  # None: the columns have no names
    columns: tuple[str, ...]
    rows: Rows
    notes: SheetNotes = field(default_factory=no_notes)


def parse_bytes(data: bytes, heads_in: HeadsIn = known_heads_in, options: SheetOptions = AS_FOUND) -> ParsedSheet:
    """Return the fields of the sheet in a CSV or XLSX file, by its bytes whatever its name."""
    if len(data) > MAX_BYTES:
        raise SheetUnreadable(f"a file may have {MAX_BYTES:,} bytes; this one has {len(data):,}")
    if data.startswith(b"PK\x03\x04"):
        return _parse_workbook(data, heads_in, options)
    if data.startswith(b"\xd0\xcf\x11\xe0"):
        raise SheetUnreadable("this is an old .xls file, or one with a password; save it as .xlsx or CSV")
    if options.tab is not None:
        raise SheetUnreadable("this is a text file, which has no tabs", fix="leave out the tab")
    text, notes = decoded(data, options.encoding)
    return (*parse_text(text, pasted=False, heads_in=heads_in)[:3], notes)


def parse_text(text: str, pasted: bool, heads_in: HeadsIn = known_heads_in) -> ParsedSheet:
    """Return the fields of the sheet in CSV text, or in what was pasted from a spreadsheet, which may have no head."""
    if len(text) > MAX_BYTES:
        raise SheetUnreadable(f"a text may have {MAX_BYTES:,} characters; this one has {len(text):,}")
    text = text.removeprefix("\ufeff")
    if (offset := text.find("\0")) >= 0:
        raise SheetUnreadable(
            f"row {_row_at(text, offset)}: this is not text: it holds zero bytes; save it as CSV or XLSX"
        )
    csv.field_size_limit(MAX_BYTES)  # of this process; what is too long for us is refused with its row and column
    try:
        rows = list(_bounded(records(text, heads_in, pasted=pasted)))
    except TableUnreadable as error:
        raise SheetUnreadable(str(error)) from None
    header_row, columns, _, below = _headed(rows, heads_in, must_have_head=not pasted)
    return header_row, columns, below, no_notes()


def _row_at(text: str, offset: int) -> int:
    return text.count("\n", 0, offset) + 1


def decoded(data: bytes, encoding: str | None = None) -> tuple[str, SheetNotes]:
    """Return the text of bytes, and how its encoding became known; raise SheetUnreadable for a damaged character."""
    if encoding is not None and encoding not in CODE_PAGES:
        raise SheetUnreadable(f'no encoding "{encoding[:40]}"; wanted {", ".join(CODE_PAGES)}')
    try:
        decoded_text = decode_text(data, encoding)
    except TextDamaged as error:
        fix = "name another encoding" if encoding else None
        raise SheetUnreadable(f"row {_row_at(error.before, len(error.before))}: {error}", fix=fix) from None
    notes = no_notes()
    notes["encoding"], notes["encoding_is_guess"] = decoded_text.encoding, decoded_text.is_guess
    notes["other_encodings"] = list(decoded_text.others)
    return decoded_text.text, notes


@dataclass
class _Hidden:
    """Hidden parts of a tab, and cells with broken formulas; rows and columns count from 1."""

    rows: set[int] = field(default_factory=set)
    columns: set[int] = field(default_factory=set)
    broken: dict[tuple[int, int], str] = field(default_factory=dict)


def _parse_workbook(data: bytes, heads_in: HeadsIn, options: SheetOptions) -> ParsedSheet:
    hidden_by_part, parts = _ensure_small(data)
    notes = no_notes()
    try:
        workbook = python_calamine.CalamineWorkbook.from_filelike(io.BytesIO(data))
        if len(workbook.sheet_names) > MAX_SHEETS:
            raise SheetUnreadable(f"a workbook may have {MAX_SHEETS} sheets; this one has {len(workbook.sheet_names)}")
        visible = {
            tab.name: tab.visible == python_calamine.SheetVisibleEnum.Visible for tab in workbook.sheets_metadata
        }
        tabs: dict[str, Rows] = {}
        for name in workbook.sheet_names:
            tabs[name] = list(_filled_rows(workbook.get_sheet_by_name(name)))
        chosen = _chosen_tab(tabs, visible, heads_in, options.tab)
        merged = workbook.get_sheet_by_name(chosen).merged_cell_ranges or [] if chosen else []
    except python_calamine.PasswordError:
        raise SheetUnreadable("the workbook has a password; save it without one") from None
    except (python_calamine.CalamineError, ValueError) as error:
        raise SheetUnreadable(f"this is not a workbook that can be read: {error}") from None
    for name, rows in tabs.items():
        heads = max((cells for _, cells in rows[:HEAD_WITHIN_ROWS]), key=heads_in, default=[])
        notes["tabs"].append(
            Tab(
                name=name,
                rows=len(rows),
                heads=[cell[:100] for cell in heads if cell][:MAX_HEADS_SHOWN],
                is_hidden=not visible.get(name, True),
                is_read=name == chosen,
            )
        )
    hidden = hidden_by_part.get(parts.get(chosen, ""), _Hidden())
    rows = _with_broken(tabs.get(chosen, []), hidden.broken)
    if options.keep_hidden:
        hidden = _Hidden()
    header_row, columns, places, below = _headed(list(_bounded(iter(rows))), heads_in, must_have_head=True)
    if options.fill_down:
        notes["filled_down"] = _fill_down(below, places, merged)
    notes["merged_across"] = sorted(
        {first_row + 1 for (first_row, first), (_, last) in merged if last > first} & {row for row, _ in below}
    )
    notes["hidden_rows"] = [(row, ", ".join(filter(None, cells))[:300]) for row, cells in below if row in hidden.rows]
    notes["hidden_columns"] = [name for name, index in zip(columns, places, strict=True) if index + 1 in hidden.columns]
    return header_row, columns, [(row, cells) for row, cells in below if row not in hidden.rows], notes


def _with_broken(rows: Rows, broken: dict[tuple[int, int], str]) -> Rows:
    """Return rows with what the spreadsheet shows for broken formulas."""
    if not broken:
        return rows
    by_row = dict(rows)
    for (row, column), text in broken.items():
        cells = by_row.setdefault(row, [])
        cells += [""] * (column - len(cells))
        cells[column - 1] = cells[column - 1] or text
    return sorted(by_row.items())


def _chosen_tab(tabs: dict[str, Rows], visible: dict[str, bool], heads_in: HeadsIn, wanted: str | None) -> str:
    """Return the name of the tab to read: the one that is wanted, or the visible one with the most known heads."""
    if wanted is not None:
        if wanted not in tabs:
            raise SheetUnreadable(f'the workbook has no tab "{wanted[:60]}"; it has {", ".join(tabs)[:300]}')
        return wanted

    def promise(name: str) -> tuple[bool, bool, int]:
        return bool(tabs[name]), visible.get(name, True), _most_heads(tabs[name], heads_in)

    return max(tabs, key=promise, default="")


def _fill_down(rows: Rows, places: Sequence[int], merged: Sequence[Any]) -> list[tuple[int, int]]:
    """Fill the cells below the first one of each merged block, and return them by row and column."""
    numbers = [row for row, _ in rows]
    filled: list[tuple[int, int]] = []
    for (first_row, first_column), (last_row, _) in merged:
        if last_row == first_row or first_column not in places:
            continue
        column = places.index(first_column)
        start = bisect_left(numbers, first_row + 1)
        if start == len(rows) or numbers[start] != first_row + 1:
            continue
        text = rows[start][1][column]
        for row, cells in rows[start + 1 : bisect_left(numbers, last_row + 2)]:
            if text and not cells[column] and any(cells):
                cells[column] = text
                filled.append((row, column))
            if len(filled) > MAX_FILLED_CELLS:
                raise SheetUnreadable(f"merged cells fill more than {MAX_FILLED_CELLS:,} cells", fix=IN_PARTS)
    return sorted(filled)


def _filled_rows(sheet: python_calamine.CalamineSheet) -> Iterator[tuple[int, list[str]]]:
    for row, cells in enumerate(sheet.to_python(skip_empty_area=False), start=1):
        texts = [cell if isinstance(cell, str) else _text_of(cell) for cell in cells]
        if any(texts):
            yield row, texts


def _most_heads(rows: Rows, heads_in: HeadsIn) -> int:
    return max((heads_in(cells) for _, cells in rows[:HEAD_WITHIN_ROWS]), default=-1)


def _ensure_small(data: bytes) -> tuple[dict[str, _Hidden], dict[str, str]]:
    """Return the hidden content of a workbook's parts, and the part of each tab.

    Raise SheetUnreadable for a workbook that would unpack to more than a list can need.
    """
    hidden: dict[str, _Hidden] = {}
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
                    hidden[name] = _ensure_small_area(part, is_xml=is_xml, is_sheet=name.startswith("xl/worksheets/"))
            return hidden, _parts_of_tabs(archive)
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, EOFError, OSError, zlib.error) as error:
        raise SheetUnreadable(f"this is not a workbook that can be read: {error}") from None


def _parts_of_tabs(archive: zipfile.ZipFile) -> dict[str, str]:
    """Return the part of a workbook that each tab is in, by the tab's name."""
    names = {entry.filename.lower(): entry.filename for entry in archive.infolist()}
    relations = names.get("xl/_rels/workbook.xml.rels")
    if relations is None:
        return {}
    with archive.open(relations) as part:
        text = part.read(READ_BYTES).decode("utf-8", "replace")
    targets = {}
    for tag in RELATION_TAG.finditer(text):
        values = dict(ATTRIBUTE.findall(tag[1]))
        targets[values.get("Id", "")] = posixpath.normpath(posixpath.join("/xl", values.get("Target", ""))).lstrip("/")
    with archive.open(names["xl/workbook.xml"]) as part:
        text = part.read(READ_BYTES).decode("utf-8", "replace")
    parts = {}
    for tag in TAB_TAG.finditer(text):
        values = {key.rpartition(":")[2]: value for key, value in ATTRIBUTE.findall(tag[1])}
        parts[html.unescape(values.get("name", ""))] = targets.get(values.get("id", ""), "").lower()
    return parts


def _note_hidden(block: bytes, hidden: _Hidden) -> None:
    """Note the rows and columns that a piece of a sheet hides, and broken formulas; an outline hides nothing."""
    for cell in BROKEN_CELL.finditer(block):
        match = CELL_PLACE.search(cell[1])
        if match and len(hidden.broken) < MAX_FILLED_CELLS and len(match[1]) < 4 and len(match[2]) < 6:
            row, column = int(match[2]), _column_number(match[1])
            if row <= LAST_ROW and column <= LAST_COLUMN:
                hidden.broken[row, column] = cell[2].decode("ascii", "replace")
    for tag in HIDDEN_TAG.finditer(block):
        if b"hidden" not in tag[2]:
            continue
        values = dict(ATTRIBUTE.findall(tag[2].decode("ascii", "replace")))
        if values.get("hidden") not in ("1", "true") or values.get("outlineLevel", "0") != "0":
            continue
        if tag[1] == b"row":
            row = values.get("r", "")
            if row.isdecimal() and len(row) < 8 and int(row) <= LAST_ROW:
                hidden.rows.add(int(row))
        else:
            first, last = values.get("min", ""), values.get("max", "")
            if first.isdecimal() and last.isdecimal() and len(first + last) < 16:
                hidden.columns.update(range(int(first), min(int(last), LAST_COLUMN) + 1))


def _ensure_small_area(part: IO[bytes], *, is_xml: bool, is_sheet: bool) -> _Hidden:
    # The workbook's reader keeps what stands between two tags as a whole, where 99 MB take 190 MiB.
    tail = b""
    last_row = last_column = 0
    hidden = _Hidden()
    while block := part.read(READ_BYTES):
        if is_xml and len(block) == READ_BYTES and b"<" not in block:
            raise SheetUnreadable("a part of the workbook has 1 MiB without a cell or a tag", fix=SAVE_AGAIN)
        if not is_sheet:
            continue
        _note_hidden(tail + block, hidden)
        for cell in CELL.finditer(tail + block):
            match = CELL_PLACE.search(cell[1])
            if match is None or cell[1].endswith(b"/"):
                continue
            row, column = int(match[2]), _column_number(match[1])
            last_row, last_column = max(last_row, row), max(last_column, column)
            for count, most, what in ((row, LAST_ROW, "rows"), (column, LAST_COLUMN, "columns")):
                if count > most:
                    last = f"{match[1].decode()}{row}"
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
    return hidden


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
    rows: Rows, heads_in: HeadsIn, *, must_have_head: bool
) -> tuple[int | None, tuple[str, ...], list[int], Rows]:
    if not rows:
        raise SheetUnreadable("the sheet is empty")
    header_row, columns, places, below = headed(rows, heads_in, must_have_head=must_have_head)
    if len(below) > MAX_ROWS:
        raise _too_many_rows(len(below))
    if len(columns) > MAX_COLUMNS:
        raise SheetUnreadable(f"a sheet may have {MAX_COLUMNS} columns; this one has {len(columns):,}")
    return header_row, columns, places, below


def _bounded(rows: Iterator[tuple[int, list[str]]]) -> Iterator[tuple[int, list[str]]]:
    """Yield the rows that have something in them; raise SheetUnreadable where they are too many, or too large."""
    filled_rows = filled_cells = characters = 0
    for row, cells in rows:
        filled = [(index, text) for index, cell in enumerate(cells) if (text := cell.strip())]
        if not filled:
            continue
        filled_rows += 1
        if filled_rows > MAX_ROWS + HEAD_WITHIN_ROWS:
            raise _too_many_rows(filled_rows + sum(any(map(str.strip, cells)) for _, cells in rows))
        filled_cells += len(filled)
        characters += sum(len(text) for _, text in filled)
        for column, text in filled:
            if len(text) > MAX_CELL_CHARACTERS:
                raise SheetUnreadable(
                    f"row {row}, column {column + 1}: a cell may have {MAX_CELL_CHARACTERS:,} characters; "
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
        for column, text in filled:
            texts[column] = text
        yield row, texts


def _too_many_rows(count: int) -> SheetUnreadable:
    return SheetUnreadable(f"a sheet may have {MAX_ROWS:,} rows; this one has {count:,}", fix=IN_PARTS)
