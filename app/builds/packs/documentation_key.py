"""The sheet that goes with a pack: what each file is and what it is for."""

import csv
import io
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from datetime import datetime

from app.sound_lists.rules import spreadsheet_safe

Cell = str | int | float | None
MADE_AT = datetime(1980, 1, 1)  # noqa: DTZ001  XLSX knows no zone; fixed, so that the same key is the same bytes
WIDTHS = {
    "file": 32,
    "name": 28,
    "description": 60,
    "use": 40,
    "trigger": 30,
    "note": 40,
    "sources": 44,
    "originator": 24,
    "master": 36,
}


@dataclass(frozen=True)
class KeyRow:
    """One accepted sound; its file is empty where the target has none, and the note says why."""

    file: str
    cue: str
    name: str
    category: str
    variation: int
    variations: int
    description: str
    use: str
    trigger: str
    loop: str
    duration_s: float | None
    sample_rate_hz: int | None
    bit_depth: int | None
    channels: int | None
    attenuation_db: float | None
    version: int | None
    note: str
    sources: str  # what it was made from, as its designer states it
    originator: str  # its designer
    contract: str  # that ordered it, as in `SW contract 2`
    state: str
    master: str
    file_sha256: str
    master_sha256: str

    @property
    def cells(self) -> list[Cell]:
        """The row's cells, none of which a spreadsheet takes for a formula."""
        values = [getattr(self, column) for column in COLUMNS]
        return [spreadsheet_safe(value) if isinstance(value, str) else value for value in values]


COLUMNS = tuple(field.name for field in fields(KeyRow))


def key_csv(rows: Sequence[KeyRow]) -> bytes:
    """Return the key as CSV, marked as UTF-8 for spreadsheets."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\r\n")
    writer.writerow(COLUMNS)
    writer.writerows(["" if cell is None else cell for cell in row.cells] for row in rows)
    return out.getvalue().encode("utf-8-sig")


def key_xlsx(rows: Sequence[KeyRow]) -> bytes:
    """Return the key as a workbook."""
    return workbook_of("Documentation key", COLUMNS, [row.cells for row in rows], WIDTHS)


def workbook_of(title: str, columns: Sequence[str], rows: Sequence[Sequence[Cell]], widths: Mapping[str, int]) -> bytes:
    """Return rows as a workbook of one sheet, the same bytes for the same rows."""
    import xlsxwriter  # 15 MiB that a process without a workbook need not hold

    out = io.BytesIO()
    workbook = xlsxwriter.Workbook(
        out, {"in_memory": True, "strings_to_formulas": False, "strings_to_urls": False, "strings_to_numbers": False}
    )
    workbook.set_properties({"title": title, "created": MADE_AT})
    sheet = workbook.add_worksheet(title)
    head = workbook.add_format({"bold": True})
    wrapped = workbook.add_format({"text_wrap": True, "valign": "top"})
    for column_index, column in enumerate(columns):
        sheet.set_column(column_index, column_index, widths.get(column, 14), wrapped)
        sheet.write_string(0, column_index, column, head)
    for line, row in enumerate(rows, start=1):
        for column_index, cell in enumerate(row):
            if isinstance(cell, str):
                sheet.write_string(line, column_index, cell)
            elif cell is not None:
                sheet.write_number(line, column_index, cell)
    sheet.freeze_panes(1, 1)
    workbook.close()
    return out.getvalue()
