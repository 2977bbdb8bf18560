"""The clearance sheet of a pack: who made each sound, from what, and by which right the studio has it."""

import json
import re
from collections.abc import Sequence
from dataclasses import dataclass, fields
from datetime import date

from app.builds.packs.documentation_key import Cell, workbook_of
from app.core.plural import counted, day_in_words, verb
from app.core.typesetting import typeset
from app.sound_lists.rules import spreadsheet_safe

TITLE = "Clearance sheet"
WIDTHS = {
    "file": 32,
    "name": 28,
    "agreement": 32,
    "libraries": 44,
    "generated": 36,
    "performers": 36,
    "note": 30,
    "open_points": 44,
    "same_file_in": 24,
    "same_sound_in": 44,
    "same_in_libraries": 44,
    "master": 36,
    "master_sha256": 30,
}


@dataclass(frozen=True)
class ClearanceRow:
    """One game file: its maker, its sources, and what is still open."""

    file: str
    cue: str
    name: str
    variation: int
    version: int | None
    designer: str
    agreement: str  # title and day of the contract, or that the designer belongs to the studio
    paid: str
    from_scratch: str
    own_recordings: str
    libraries: str
    generated: str
    performers: str
    note: str
    open_points: str
    same_file_in: str  # other projects of the studio
    same_sound_in: str  # approved versions of other projects, and how this one differs from them
    same_in_libraries: str  # files of registered libraries, and whether the sources name them
    delivered_on: str
    approved_on: str
    approved_by: str
    master: str
    master_sha256: str

    @property
    def cells(self) -> list[Cell]:
        """The row's cells, none of which a spreadsheet takes for a formula."""
        values = [getattr(self, column) for column in COLUMNS]
        return [spreadsheet_safe(value) if isinstance(value, str) else value for value in values]


COLUMNS = tuple(field.name for field in fields(ClearanceRow))
LOOK = """
#let sheet = json(bytes(sys.inputs.sheet))
#set document(title: "Clearance sheet: " + sheet.title, date: none)
#set page(
  paper: "a4", flipped: true, margin: (x: 14mm, y: 14mm),
  footer: context text(8pt, fill: luma(90))[#sheet.title #h(1fr) #counter(page).display("1 of 1", both: true)],
)
#set text(font: serif, size: 9pt)
#set par(leading: 0.5em)
#text(16pt)[Clearance sheet]
#linebreak()
#text(10pt)[#sheet.title]
#v(2mm)
#text(9pt, fill: luma(70))[#sheet.sums]
#v(3mm)
#table(
  columns: (46mm, 34mm, 48mm, 1fr, 46mm),
  stroke: (x, y) => (bottom: if y == 0 { 0.7pt } else { 0.25pt + luma(170) }),
  inset: (x: 1.2mm, y: 1.1mm),
  table.header[*File*][*Sound*][*Made by, and under*][*Made from*][*Open*],
  ..for row in sheet.rows {
    (
      text(font: mono, size: 7.5pt, row.file),
      ..for lines in (row.sound, row.by, row.sources, row.open) {
        (lines.filter(line => line != "").map(line => [#line]).join(linebreak()),)
      },
    )
  },
)
"""


def clearance_xlsx(rows: Sequence[ClearanceRow]) -> bytes:
    """Return the sheet as a workbook."""
    return workbook_of(TITLE, COLUMNS, [row.cells for row in rows], WIDTHS)


def clearance_pdf(rows: Sequence[ClearanceRow], *, title: str) -> bytes:
    """Return the sheet as a PDF, the same bytes for the same rows; see `typeset` for what is raised."""
    content = {"title": title, "sums": sums_of(rows), "rows": [_entry(row) for row in rows]}
    return typeset(LOOK, {"sheet": json.dumps(content, ensure_ascii=False)})


def sums_of(rows: Sequence[ClearanceRow]) -> str:
    """Return a sentence with the number of clear sounds."""
    still_open = sum(bool(row.open_points) for row in rows)
    unpaid = sum(row.paid == "no" for row in rows)
    return (
        f"{counted(len(rows), 'sound')}; points are open on {still_open}; "
        f"{unpaid} {verb(unpaid, 'is', 'are')} not paid in full."
    )


def _approval(row: ClearanceRow) -> str:
    if not row.approved_on:
        return ""
    return f"approved {day_in_words(date.fromisoformat(row.approved_on))}, {row.approved_by}"


def _entry(row: ClearanceRow) -> dict[str, object]:
    yes = {"made from scratch": row.from_scratch, "own recordings": row.own_recordings}
    listed = {"Libraries": row.libraries, "Generated": row.generated, "Performers": row.performers, "Note": row.note}
    return {
        "file": re.sub(r"([_/])", "\\1\u200b", row.file),  # long names break after these
        "sound": [f"{row.cue} {row.name}", f"version {row.version}" if row.version else "", row.master_sha256[:16]],
        "by": [
            row.designer,
            row.agreement,
            {"yes": "paid in full", "no": "not paid in full"}.get(row.paid, ""),
            _approval(row),
        ],
        "sources": [
            ", ".join(words for words, stated in yes.items() if stated == "yes"),
            *(f"{word}: {stated}" for word, stated in listed.items() if stated),
        ],
        "open": [
            row.open_points,
            f"the same file in {row.same_file_in}" if row.same_file_in else "",
            f"found in {row.same_sound_in}" if row.same_sound_in else "",
            f"equals {row.same_in_libraries}" if row.same_in_libraries else "",
        ],
    }
