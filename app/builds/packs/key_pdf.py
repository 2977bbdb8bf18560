"""The documentation key as a PDF: one entry a file, to be read, printed, and signed off."""

import json
import re
from collections.abc import Sequence

from app.builds.packs.documentation_key import KeyRow
from app.core.plural import counted, verb
from app.core.typesetting import typeset

# What people wrote comes in as data and is never read as markup.
LOOK = """
#let key = json(bytes(sys.inputs.key))
#set document(title: "Documentation key: " + key.title, date: none)
#set page(
  paper: "a4", flipped: true, margin: (x: 14mm, y: 14mm),
  footer: context text(8pt, fill: luma(90))[#key.title #h(1fr) #counter(page).display("1 of 1", both: true)],
)
#set text(font: serif, size: 9pt)
#set par(leading: 0.5em)
#text(16pt)[Documentation key]
#linebreak()
#text(10pt)[#key.title]
#v(2mm)
#text(9pt, fill: luma(70))[#key.sums]
#v(3mm)
#table(
  columns: (50mm, 20mm, 36mm, 1fr, 34mm, 34mm),
  stroke: (x, y) => (bottom: if y == 0 { 0.7pt } else { 0.25pt + luma(170) }),
  inset: (x: 1.2mm, y: 1.1mm),
  table.header[*File*][*Cue*][*Name*][*What it is and what it is for*][*Format*][*Note*],
  ..for row in key.rows {
    (
      text(font: mono, size: 7.5pt, row.file), row.cue, row.name,
      row.what.filter(line => line != "").map(line => [#line]).join(linebreak()),
      row.format, row.note,
    )
  },
)
"""


def key_pdf(rows: Sequence[KeyRow], *, title: str) -> bytes:
    """Return the key as a PDF, the same bytes for the same rows; see `typeset` for what is raised."""
    files = sum(bool(row.file) for row in rows)
    content = {
        "title": title,
        "sums": sums_of(files, len(rows)),
        "rows": [_entry(row) for row in rows],
    }
    inputs = {"key": json.dumps(content, ensure_ascii=False)}
    return typeset(LOOK, inputs)


def sums_of(files: int, sounds: int) -> str:
    """Return a sentence with the number of accepted sounds that have a file."""
    have = verb(files, "has", "have")
    return f"{files} of {counted(sounds, 'accepted sound')} {have} a file; SHA256SUMS has their sums."


def _entry(row: KeyRow) -> dict[str, object]:
    named = {"Use": row.use, "Trigger": row.trigger, "Sources": row.sources}
    return {
        "file": re.sub(r"([_/])", "\\1\u200b", row.file) or "none",  # long names break after these
        "cue": row.cue + (f" {row.variation}/{row.variations}" if row.variations > 1 else ""),
        "name": row.name,
        "what": [row.description, *(f"{word}: {text}" for word, text in named.items() if text)],
        "format": _format(row),
        "note": row.note,
    }


def _format(row: KeyRow) -> str:
    facts = [
        row.category,
        "loop" if row.loop == "yes" else "",
        f"{row.duration_s:.2f} s" if row.duration_s is not None else "",
        f"{row.sample_rate_hz:,} Hz" if row.sample_rate_hz else "",
        f"{row.bit_depth} bit" if row.bit_depth else "",
        {1: "mono", 2: "stereo"}.get(row.channels or 0, ""),
    ]
    return ", ".join(fact for fact in facts if fact)
