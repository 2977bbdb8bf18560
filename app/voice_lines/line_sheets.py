"""The script and the pick-up list as sheets; no cell is a formula."""

import csv
import io
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from datetime import datetime
from uuid import UUID

from app.sound_lists.rules import spreadsheet_safe
from app.voice_lines.rules import PICK_UPS
from app.voice_lines.schemas import VoiceLineRead

PICK_UP_COLUMNS = (
    *("language", "character", "performer", "directed by", "scene", "line id", "before", "text", "after", "direction"),
    *("reason", "file"),
)
WIDTHS = (10, 18, 18, 18, 24, 16, 36, 48, 36, 28, 40, 28)
MADE_AT = datetime(2000, 1, 1)  # noqa: DTZ001  a workbook has no zone; the same bytes for the same rows


def script_csv(lines: Mapping[str, Sequence[VoiceLineRead]]) -> str:
    """Return the script as CSV that our own import reads: a column for each language."""
    first = next(iter(lines.values()), ())
    most_files = Counter[UUID]()
    for line in (line for reads in lines.values() for line in reads):
        most_files[line.id] = max(most_files[line.id], len(line.files))
    texts = {language: {line.id: line.text or "" for line in reads} for language, reads in lines.items()}
    head = ("key", "character", "scene", "direction", "file_name", "variations", *lines)
    rows = (
        (
            *(
                line.key,
                line.character.name,
                line.scene,
                line.direction,
                line.path.partition("/")[2],
                str(most_files[line.id]),
            ),
            *(texts[language].get(line.id, "") for language in lines),
        )
        for line in first
    )
    return _csv([head, *rows])


def pick_up_csv(lines: Sequence[VoiceLineRead]) -> str:
    """Return the pick-up list as CSV."""
    return _csv([PICK_UP_COLUMNS, *map(_pick_up, lines)])


def pick_up_xlsx(lines: Sequence[VoiceLineRead]) -> bytes:
    """Return the pick-up list as a workbook that prints on landscape paper, the head on each page."""
    import xlsxwriter  # 15 MiB that a process without a workbook need not hold

    out = io.BytesIO()
    plain = dict.fromkeys(("strings_to_formulas", "strings_to_urls", "strings_to_numbers"), False)
    workbook = xlsxwriter.Workbook(out, {"in_memory": True, **plain})
    workbook.set_properties({"title": "Pick-ups", "created": MADE_AT})
    sheet = workbook.add_worksheet("Pick-ups")
    head = workbook.add_format({"bold": True})
    wrapped = workbook.add_format({"text_wrap": True, "valign": "top"})
    for index, (column, width) in enumerate(zip(PICK_UP_COLUMNS, WIDTHS, strict=True)):
        sheet.set_column(index, index, width, wrapped)
        sheet.write_string(0, index, column, head)
    for row, line in enumerate(lines, start=1):
        for index, cell in enumerate(_pick_up(line)):
            sheet.write_string(row, index, spreadsheet_safe(cell))
    sheet.freeze_panes(1, 0)
    sheet.repeat_rows(0)
    sheet.set_landscape()
    sheet.fit_to_pages(1, 0)
    workbook.close()
    return out.getvalue()


def _pick_up(line: VoiceLineRead) -> tuple[str, ...]:
    before, after = (
        f"{neighbour.character}: {neighbour.text}" if neighbour else "" for neighbour in (line.before, line.after)
    )
    who = (line.language, line.character.name, line.performer or "", line.directed_by, line.scene, line.key)
    files = ", ".join(file.path for file in line.files if file.state in PICK_UPS)
    return (*who, before, line.text or "", after, line.direction, line.reason, files)


def _csv(rows: Iterable[Sequence[str]]) -> str:
    out = io.StringIO()
    out.write("\ufeff")  # without it Excel takes UTF-8 for the code page of its machine
    csv.writer(out).writerows([spreadsheet_safe(cell) for cell in row] for row in rows)
    return out.getvalue()
