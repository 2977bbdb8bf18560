"""The text of a contract as PDF: the same text gives the same bytes, on any machine."""

import hashlib
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import date
from typing import Self

from app.agreements.clauses.text import Block, Span, blocks_of
from app.core.typesetting import typeset, undrawn_scripts

PDF = "application/pdf"
_LOOK = """
#set document(title: {title}, date: {date}, keywords: {keywords})
#set text(font: serif, size: 10.5pt, lang: "en")
#set par(leading: 0.62em, spacing: 0.9em)
#set heading(numbering: none)
#show heading.where(level: 1): it => block(below: 1.2em, text(size: 18pt, weight: 500, it.body))
#show heading.where(level: 2): it => {{
  block(above: 1.4em, below: 0.6em, sticky: true, text(size: 11.5pt, weight: 600, it.body))
}}
#set table(stroke: 0.4pt + luma(70%), inset: 5pt)
#set page(paper: "a4", margin: (x: 24mm, y: 24mm), footer: context {{
  set text(size: 8pt, fill: luma(35%), dir: ltr)
  let hash = text(font: mono, size: 6.5pt, {sha256})
  grid(columns: (1fr, auto), hash, counter(page).display("1 of 1", both: true))
  {missing}
}})
"""


@dataclass(frozen=True)
class TextPdf:
    """The PDF of a text, with the hash by which the text is known."""

    text_sha256: str
    content: bytes

    @classmethod
    def of(cls, title: str, markdown: str, signatures: Sequence["CertificatePart"] = ()) -> Self:
        """Typeset a text with its page of signatures; see `typeset` for what is raised."""
        return cls(sha256_of(markdown), pdf_of(title, markdown, signatures))


def sha256_of(text: str) -> str:
    """Return the hash by which a text is known."""
    return hashlib.sha256(text.encode()).hexdigest()


def pdf_of(title: str, markdown: str, signatures: Sequence["CertificatePart"] = ()) -> bytes:
    """Return the text and its signatures as PDF, with its hash on every page; see `typeset` for what is raised."""
    return typeset("\n".join([_source(title, markdown), *_after_the_text(signatures)]))


def archival_pdf_of(title: str, markdown: str, *, dated: date) -> bytes:
    """Return the text as archival PDF; see `typeset` for what is raised."""
    return typeset(_source(title, markdown, day=_day(dated)), is_archival=True)


@dataclass(frozen=True)
class CertificatePart:
    """A part of the certificate of signing: its text, and the drawing that stands below it."""

    markdown: str
    drawing_svg: str | None = None  # made by us; it is the child that reads it


def signed_pdf_of(
    title: str, markdown: str, certificate: Sequence[CertificatePart], *, agreed_on: date, mark: str
) -> bytes:
    """Return the text as archival PDF, with its hash on every page and the certificate of its signatures after it."""
    text = _source(title, markdown, day=_day(agreed_on), keywords=f"({_string(mark)},)")
    return typeset("\n".join([text, *_after_the_text(certificate)]), is_archival=True)


def _after_the_text(parts: Sequence[CertificatePart]) -> list[str]:
    return ["#pagebreak()", *map(_certificate_part, parts)] if parts else []


def _certificate_part(part: CertificatePart) -> str:
    blocks = _blocks(part.markdown)
    if part.drawing_svg is None:
        return blocks
    drawing = f'#image(bytes({_string(part.drawing_svg)}), format: "svg", width: 60mm, alt: "The name as it was drawn")'
    return f"{blocks}\n#block(stroke: (bottom: 0.4pt + luma(70%)), {drawing[1:]})"


def _day(day: date) -> str:
    return f"datetime(year: {day.year}, month: {day.month}, day: {day.day})"


def _source(title: str, markdown: str, *, day: str = "none", keywords: str = "()") -> str:
    sha256 = _string(f"SHA-256 of the text {sha256_of(markdown)}")
    scripts = ", ".join(undrawn_scripts(markdown))
    missing = f"This PDF has no font made for {scripts}: such letters may show as boxes." if scripts else ""
    look = _LOOK.format(title=_string(title), sha256=sha256, date=day, keywords=keywords, missing=_string(missing))
    return look + _blocks(markdown)


def _blocks(markdown: str) -> str:
    return "\n".join(_typst(block) for block in blocks_of(markdown))


def _typst(block: Block) -> str:
    match block.kind:
        case "head":
            return _directed(block.spans, f"#heading(level: {block.level}, {_content(block.spans)})")
        case "item":
            return _directed(block.spans, f"#list({_content(block.spans)})")
        case "table":
            head, *rows = block.rows
            columns = max(len(row) for row in block.rows)
            cells = [_content(cell) for row in rows for cell in _wide(row, columns)]
            heads = ", ".join(f"strong({_content(cell)})" for cell in _wide(head, columns))
            return f"#table(columns: {columns}, table.header({heads}), {', '.join(cells)})"
        case "text":
            return _directed(block.spans, f"#par({_content(block.spans)})")


def _directed(spans: Sequence[Span], source: str) -> str:
    """Return a block that runs as its first letter with a direction does, as Unicode sets a paragraph."""
    directions = map(unicodedata.bidirectional, "".join(span.text for span in spans))
    first = next((direction for direction in directions if direction in ("L", "R", "AL")), "L")
    return source if first == "L" else f"#[#set text(dir: rtl)\n{source}]"


def _wide(row: Sequence[list[Span]], columns: int) -> list[list[Span]]:
    return [*row, *([Span("")] for _ in range(columns - len(row)))]


def _content(spans: Sequence[Span]) -> str:
    """Return spans as code that joins to content; all text is in string literals, so none of it is executed."""
    return f"[{''.join(map(_span, spans))}]"


def _span(span: Span) -> str:
    text = f"text({_string(span.text)}{_language(span.text)})"
    return f"#{'strong' if span.strong else 'emph'}({text});" if span.strong or span.emphatic else f"#{text};"


def _language(text: str) -> str:
    """Return the argument that gives Chinese characters the forms of the language that the text around them is in."""
    scripts = {unicodedata.name(letter, "").split(" ")[0] for letter in text}
    if not scripts & {"CJK", "HIRAGANA", "KATAKANA", "HANGUL"}:
        return ""
    if scripts & {"HIRAGANA", "KATAKANA"}:
        return ', lang: "ja"'
    return ', lang: "ko"' if "HANGUL" in scripts else ', lang: "zh"'


def _string(text: str) -> str:
    shown = "".join(letter if letter >= " " else " " for letter in text)
    return '"' + shown.replace("\\", "\\\\").replace('"', '\\"') + '"'
