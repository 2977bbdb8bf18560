"""The list leaves as an XLSX workbook, which an import reads back without a difference; no cell is a formula."""

import io
from collections.abc import Sequence
from datetime import date
from enum import StrEnum
from typing import TYPE_CHECKING, Any

from app.sound_lists.models import Cue
from app.sound_lists.own_columns.rules import Column, ColumnKind, key_of
from app.sound_lists.people.rules import KnownPeople
from app.sound_lists.rules import PEOPLE, CueChannels, CueState, Need, Phase, Reverb, label, typed_text
from app.sound_lists.sheets.export import value_columns, values_by_key
from audio_checks import HEADS, is_broken_formula

if TYPE_CHECKING:
    from xlsxwriter.format import Format
    from xlsxwriter.worksheet import Worksheet

MEDIA_TYPE = "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet"
FIRST_DAY = date(1901, 1, 1)  # workbooks count days from 1900, and take that year for a leap year
LONGEST_LIST = 255  # characters of the choices that a cell offers, as Excel allows
ROOM_ROWS = 500  # below the list, where cells offer their choices too
WIDE = {"name": 24, "file_name": 24, "description": 48, "use": 32, "trigger": 24}
YES_NO = ("yes", "no")
OFFERED: dict[str, Sequence[str]] = {
    **dict.fromkeys(("length_locked", "loop", "placeholder", "palette"), YES_NO),
    "reverb": [*Reverb],
    "channels": [*CueChannels],
    "state": [*CueState],
    "need": [*Need],
    "phase": [*Phase],
}


def sound_list_workbook(cues: Sequence[Cue], columns: Sequence[Column], people: KnownPeople, cue_prefix: str) -> bytes:
    """Return the list as a workbook: every field that an import has, the project's own columns, then kept ones."""
    import xlsxwriter  # 15 MiB that a process without a workbook need not hold

    out = io.BytesIO()
    book = xlsxwriter.Workbook(out, {"in_memory": True})
    sheet = book.add_worksheet("Sound list")
    bold, day = book.add_format({"bold": True}), book.add_format({"num_format": "yyyy-mm-dd"})
    extras = value_columns(cues, columns)
    kinds = {key_of(column.name): column.kind for column in columns}
    heads = [*HEADS, *extras.values()]
    for column, head in enumerate(heads):
        sheet.write_string(0, column, _quoted(head), bold)
        sheet.set_column(column, column, WIDE.get(head, 14))
    for row, cue in enumerate(cues, start=1):
        values = values_by_key(cue)
        cells = [label(cue_prefix, cue.number), *(_value(cue, field, people) for field in HEADS if field != "number")]
        cells += [_typed(kinds.get(key, ColumnKind.TEXT), values.get(key, "")) for key in extras]
        for column, cell in enumerate(cells):
            _write(sheet, row, column, cell, day)
    _offer_choices(sheet, len(cues), heads, columns)
    sheet.freeze_panes(1, 2)
    sheet.autofilter(0, 0, len(cues), len(heads) - 1)
    book.close()
    return out.getvalue()


def _value(cue: Cue, field: str, people: KnownPeople) -> Any:
    return people.text_of(getattr(cue, PEOPLE[field])) if field in PEOPLE else getattr(cue, field)


def _typed(kind: ColumnKind, text: str) -> Any:
    if text and kind is ColumnKind.NUMBER:
        return float(text)
    return date.fromisoformat(text) if text and kind is ColumnKind.DATE else text


def _quoted(text: str) -> str:
    # An import takes such a quote away, and a broken formula for no text.
    return f"'{text}" if typed_text(text) != text or is_broken_formula(text) else text


def _write(sheet: "Worksheet", row: int, column: int, cell: Any, day: "Format") -> None:
    """Write one cell; what a workbook cannot keep exactly as a number or a day is text."""
    if cell is None or cell == "":
        return
    if isinstance(cell, bool):
        sheet.write_string(row, column, "yes" if cell else "no")
    elif isinstance(cell, (int, float)) and float(f"{cell:.16G}") == cell:
        sheet.write_number(row, column, cell)
    elif isinstance(cell, date) and cell >= FIRST_DAY:
        sheet.write_datetime(row, column, cell, day)
    elif isinstance(cell, str):
        sheet.write_string(row, column, _quoted(cell.value if isinstance(cell, StrEnum) else cell))
    else:
        sheet.write_string(row, column, repr(cell) if isinstance(cell, float) else str(cell))


def _offer_choices(sheet: "Worksheet", rows: int, heads: Sequence[str], columns: Sequence[Column]) -> None:
    offered = dict(OFFERED)
    for column in columns:
        choices = YES_NO if column.kind is ColumnKind.YES_NO else column.choices
        if choices and len(",".join(choices)) <= LONGEST_LIST and not any("," in choice for choice in choices):
            offered[column.name] = choices
    for head_index, head in enumerate(heads):
        if head in offered:
            rule = {"validate": "list", "source": [*offered[head]], "error_type": "warning"}
            sheet.data_validation(1, head_index, rows + ROOM_ROWS, head_index, rule)
