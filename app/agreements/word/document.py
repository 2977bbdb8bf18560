"""A contract's text as a Word document (ECMA-376, WordprocessingML): the same text gives the same bytes.

Each clause's heading carries a bookmark by which its clause is found again. Two versions together are the later text
with tracked changes: accepting all of them gives it, rejecting all of them gives the earlier one.
"""

import io
import re
import zipfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from hashlib import sha256
from xml.sax.saxutils import escape, quoteattr

from app.agreements.clauses.text import Block, Span, blocks_of, plain
from app.agreements.drafts.comparison import Compared, compare

DOCX = "application/vnd.openxmlformats-officedocument.wordprocessingml.document"
MAX_BOOKMARK_CHARS = 40  # of a bookmark's name in Word
_NOT_IN_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_DECLARATION = '<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n'
_MAIN = "http://schemas.openxmlformats.org/wordprocessingml/2006/main"
_PACKAGE = "http://schemas.openxmlformats.org/package/2006"
_RELATIONS = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
_PART = "application/vnd.openxmlformats-officedocument.wordprocessingml"
_VALUES = "http://schemas.openxmlformats.org/officeDocument/2006"
_FORMAT = "{D5CDD505-2E9C-101B-9397-08002B2CF9AE}"  # of properties that a document is given
_CONTENT_TYPES = (
    f'{_DECLARATION}<Types xmlns="{_PACKAGE}/content-types">'
    '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
    f'<Override PartName="/word/document.xml" ContentType="{_PART}.document.main+xml"/>'
    f'<Override PartName="/word/styles.xml" ContentType="{_PART}.styles+xml"/>'
    f'<Override PartName="/word/numbering.xml" ContentType="{_PART}.numbering+xml"/>'
    '<Override PartName="/docProps/custom.xml" '
    'ContentType="application/vnd.openxmlformats-officedocument.custom-properties+xml"/></Types>'
)
_TOP_RELATIONS = (
    f'{_DECLARATION}<Relationships xmlns="{_PACKAGE}/relationships"><Relationship Id="rId1" '
    f'Type="{_RELATIONS}/officeDocument" Target="word/document.xml"/><Relationship Id="rId2" '
    f'Type="{_RELATIONS}/custom-properties" Target="docProps/custom.xml"/></Relationships>'
)
_DOCUMENT_RELATIONS = (
    f'{_DECLARATION}<Relationships xmlns="{_PACKAGE}/relationships"><Relationship Id="rId1" '
    f'Type="{_RELATIONS}/styles" Target="styles.xml"/><Relationship Id="rId2" '
    f'Type="{_RELATIONS}/numbering" Target="numbering.xml"/></Relationships>'
)
_NUMBERING = (
    f'{_DECLARATION}<w:numbering xmlns:w="{_MAIN}"><w:abstractNum w:abstractNumId="0"><w:lvl w:ilvl="0">'
    '<w:start w:val="1"/><w:numFmt w:val="bullet"/><w:lvlText w:val="•"/><w:lvlJc w:val="left"/>'
    '<w:pPr><w:ind w:left="360" w:hanging="360"/></w:pPr></w:lvl></w:abstractNum>'
    '<w:num w:numId="1"><w:abstractNumId w:val="0"/></w:num></w:numbering>'
)


def _style(name: str, label: str, properties: str, letters: str) -> str:
    return (
        f'<w:style w:type="paragraph" w:styleId="{name}"><w:name w:val="{label}"/><w:basedOn w:val="Normal"/>'
        f'<w:next w:val="Normal"/><w:qFormat/><w:pPr>{properties}</w:pPr><w:rPr>{letters}</w:rPr></w:style>'
    )


_STYLES = (
    f'{_DECLARATION}<w:styles xmlns:w="{_MAIN}"><w:style w:type="paragraph" w:default="1" w:styleId="Normal">'
    '<w:name w:val="Normal"/><w:pPr><w:spacing w:after="120"/></w:pPr><w:rPr><w:sz w:val="21"/></w:rPr></w:style>'
    + _style("Heading1", "heading 1", '<w:keepNext/><w:outlineLvl w:val="0"/>', '<w:b/><w:sz w:val="36"/>')
    + _style("Heading2", "heading 2", '<w:keepNext/><w:outlineLvl w:val="1"/>', '<w:b/><w:sz w:val="24"/>')
    + _style("ListBullet", "List Bullet", '<w:numPr><w:numId w:val="1"/></w:numPr>', "")
    + "</w:styles>"
)


@dataclass(frozen=True)
class Heading:
    """The key of a clause, and its heading as the text has it: "7. Rounds"."""

    key: str
    text: str


@dataclass(frozen=True)
class Earlier:
    """The version against which changes are tracked, and whose changes they are."""

    text: str
    author: str
    at: datetime


def bookmark_of(key: str) -> str:
    """Return the name of a clause's bookmark; Word allows 40 characters."""
    name = f"clause_{key}"
    return name if len(name) <= MAX_BOOKMARK_CHARS else f"clause_{sha256(key.encode()).hexdigest()[:32]}"


def word_document(
    text: str, headings: Sequence[Heading], earlier: Earlier | None = None, properties: Sequence[tuple[str, str]] = ()
) -> bytes:
    """Return a text as a DOCX file, with tracked changes against an earlier one; see `compare` for what is raised.

    Its properties are names and texts that Word keeps with it.
    """
    writer = _Writer(headings, earlier)
    body = writer.tracked(compare(earlier.text, text)) if earlier else writer.blocks(blocks_of(text))
    document = f'{_DECLARATION}<w:document xmlns:w="{_MAIN}"><w:body>{"".join(body)}</w:body></w:document>'
    parts = {
        "[Content_Types].xml": _CONTENT_TYPES,
        "_rels/.rels": _TOP_RELATIONS,
        "docProps/custom.xml": _custom_properties(properties),
        "word/_rels/document.xml.rels": _DOCUMENT_RELATIONS,
        "word/document.xml": document,
        "word/numbering.xml": _NUMBERING,
        "word/styles.xml": _STYLES,
    }
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        for name, content in parts.items():
            archive.writestr(zipfile.ZipInfo(name), content.encode(), zipfile.ZIP_DEFLATED)
    return file.getvalue()


def _custom_properties(properties: Sequence[tuple[str, str]]) -> str:
    named = "".join(
        f'<property fmtid="{_FORMAT}" pid="{number}" name={quoteattr(clean(name))}>'
        f"<vt:lpwstr>{escape(clean(text))}</vt:lpwstr></property>"
        for number, (name, text) in enumerate(properties, start=2)
    )
    spaces = f'xmlns="{_VALUES}/custom-properties" xmlns:vt="{_VALUES}/docPropsVTypes"'
    return f"{_DECLARATION}<Properties {spaces}>{named}</Properties>"


class _Writer:
    def __init__(self, headings: Sequence[Heading], earlier: Earlier | None) -> None:
        self._headings = list(headings)
        self._ids = 0
        if earlier:
            day = earlier.at.astimezone(UTC).strftime("%Y-%m-%dT%H:%M:%SZ")
            self._change = f'w:author={quoteattr(clean(earlier.author))} w:date="{day}"'

    def blocks(self, blocks: Sequence[Block]) -> Iterator[str]:
        """Yield the blocks of one version, in bold and italics as it has them."""
        for block in blocks:
            if block.kind == "table":
                yield self._table(block)
            else:
                runs = "".join(_run(span) for span in block.spans)
                yield self._paragraph(block.kind, plain(block)[0], runs)

    def tracked(self, lines: Sequence[Compared]) -> Iterator[str]:
        """Yield the lines of two versions; a row of a table is a line."""
        for line in lines:
            runs = "".join(self._tracked_run(run.is_in, run.text) for run in line.runs)
            later = "".join(run.text for run in line.runs if run.is_in != "earlier")
            mark = {"added": "ins", "removed": "del"}.get(line.change)
            yield self._paragraph(line.kind, later, runs, f"<w:rPr>{self._marked(mark)}</w:rPr>" if mark else "")

    def _tracked_run(self, is_in: str, text: str) -> str:
        match is_in:
            case "earlier":
                return f"{self._marked('del', is_open=True)}{_run(Span(text), 'delText')}</w:del>"
            case "later":
                return f"{self._marked('ins', is_open=True)}{_run(Span(text))}</w:ins>"
        return _run(Span(text))

    def _marked(self, tag: str, *, is_open: bool = False) -> str:
        self._ids += 1
        return f'<w:{tag} w:id="{self._ids}" {self._change}{"" if is_open else "/"}>'

    def _paragraph(self, kind: str, text: str, runs: str, mark: str = "") -> str:
        style = {"head": "Heading1", "item": "ListBullet"}.get(kind)
        if kind == "head" and self._headings and text == self._headings[0].text:
            style, runs = "Heading2", self._bookmarked(self._headings.pop(0).key, runs)
        named = f'<w:pStyle w:val="{style}"/>' if style else ""
        return f"<w:p><w:pPr>{named}{mark}</w:pPr>{runs}</w:p>"

    def _bookmarked(self, key: str, runs: str) -> str:
        self._ids += 1
        name = quoteattr(bookmark_of(key))
        return f'<w:bookmarkStart w:id="{self._ids}" w:name={name}/>{runs}<w:bookmarkEnd w:id="{self._ids}"/>'

    def _table(self, block: Block) -> str:
        columns = max(len(row) for row in block.rows)
        edges = "".join(
            f'<w:{edge} w:val="single" w:sz="4" w:space="0" w:color="auto"/>'
            for edge in ("top", "left", "bottom", "right", "insideH", "insideV")
        )
        rows = "".join(self._row([*row, *([[]] * (columns - len(row)))]) for row in block.rows)
        grid = "<w:gridCol/>" * columns
        return (
            f'<w:tbl><w:tblPr><w:tblW w:w="0" w:type="auto"/><w:tblBorders>{edges}</w:tblBorders></w:tblPr>'
            f"<w:tblGrid>{grid}</w:tblGrid>{rows}</w:tbl><w:p/>"
        )

    def _row(self, cells: Sequence[Sequence[Span]]) -> str:
        inside = "".join(f"<w:tc><w:p>{''.join(_run(span) for span in cell)}</w:p></w:tc>" for cell in cells)
        return f"<w:tr>{inside}</w:tr>"


def _run(span: Span, tag: str = "t") -> str:
    weight = f"{'<w:b/>' if span.strong else ''}{'<w:i/>' if span.emphatic else ''}"
    properties = f"<w:rPr>{weight}</w:rPr>" if weight else ""
    return f'<w:r>{properties}<w:{tag} xml:space="preserve">{escape(clean(span.text))}</w:{tag}></w:r>'


def clean(text: str) -> str:
    """Return a text with what XML cannot hold replaced."""
    return _NOT_IN_XML.sub("�", text)
