"""The body of a Word document (ECMA-376), read element by element, as it reads with all changes accepted."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import get_args

from app.agreements.clauses.text import BlockKind, Span
from app.agreements.word.elements import (
    MAX_CHARS,
    OutsideText,
    TooMuchInside,
    local_name,
    named_without_space,
)

MAX_LINES = 10_000
CLAUSE = "clause_"  # begins the name of a clause's bookmark
_OFF = frozenset(("0", "false", "off", "none"))
_GONE = frozenset(("del", "moveFrom"))  # what a reader that accepts all changes leaves out
_UNREAD = frozenset(
    ("instrText", "delInstrText", "sectPr", "pPrChange", "rPrChange", "tblPrChange", "trPrChange", "tcPrChange", "ruby")
)
_LETTERS = {"tab": " ", "br": " ", "cr": " ", "noBreakHyphen": "-", "ptab": " "}


@dataclass(frozen=True)
class WordLine:
    """A paragraph, a heading, an item of a list, or a row of a table whose cells are joined by a dot."""

    kind: BlockKind
    level: int  # of a heading; 0 for any other line
    spans: tuple[Span, ...]
    bookmarks: tuple[str, ...]  # of clauses
    comments: tuple[str, ...]

    @property
    def text(self) -> str:
        """The line without its looks."""
        return "".join(span.text for span in self.spans)


@dataclass
class _Paragraph:
    is_outside: bool
    style: str = ""
    is_item: bool = False
    is_mark_gone: bool = False  # its end was deleted, so it continues in the next
    spans: list[Span] = field(default_factory=list)
    bookmarks: list[str] = field(default_factory=list)
    comments: list[str] = field(default_factory=list)


class BodyReader:
    """Reads the lines of a document as they read once all tracked changes are accepted."""

    def __init__(self, styles: Mapping[str, str]) -> None:
        self.lines: list[WordLine] = []
        self.outside: list[OutsideText] = []
        self._styles = styles
        self._open: list[str] = []  # the elements that are open, those of other namespaces as ""
        self._unread = 0  # elements that are open and not read
        self._gone = 0
        self._boxes = 0
        self._paragraphs: list[_Paragraph] = []
        self._rest: _Paragraph | None = None  # what continues in the next paragraph
        self._bookmarks: list[str] = []  # between two paragraphs: they are the next one's
        self._comments: list[str] = []
        self._cells: list[list[Span]] = []  # of the row that is open
        self._tables = 0
        self._is_row_gone = False
        self._strong = self._emphatic = self._hidden = False
        self._chars_left = MAX_CHARS

    def start(self, tag: str, attributes: Mapping[str, str]) -> None:
        """Take the start of an element."""
        is_main, name = local_name(tag)
        element_name = name if is_main else f"other:{name}"
        self._open.append(element_name)
        if element_name in _UNREAD or element_name == "other:Fallback":
            self._unread += 1
        if self._unread:
            return
        parent = self._open[-2] if len(self._open) > 1 else ""
        if element_name in _GONE:
            self._start_gone(parent)
        elif parent == "rPr":
            self._start_letters(element_name, attributes)
        elif parent in ("pPr", "numPr"):
            self._start_paragraph_property(element_name, attributes)
        else:
            self._start_content(element_name, attributes)

    def _start_gone(self, parent: str) -> None:
        self._gone += 1
        if parent == "trPr":
            self._is_row_gone = True
        if parent == "rPr" and "pPr" in self._open[-3:] and self._paragraphs:
            self._paragraphs[-1].is_mark_gone = True

    def _start_letters(self, name: str, attributes: Mapping[str, str]) -> None:
        if self._open[-3] != "r":  # of a paragraph's mark
            return
        match name:
            case "b":
                self._strong = _is_on(attributes)
            case "i":
                self._emphatic = _is_on(attributes)
            case "vanish":
                self._hidden = _is_on(attributes)
            case "rStyle":
                style = named_without_space(attributes).get("val", "")
                self._strong |= self._styles.get(style, style.lower()) == "strong"
                self._emphatic |= self._styles.get(style, style.lower()) == "emphasis"

    def _start_paragraph_property(self, name: str, attributes: Mapping[str, str]) -> None:
        if not self._paragraphs:
            return
        value = named_without_space(attributes).get("val", "")
        if name == "pStyle":
            self._paragraphs[-1].style = self._styles.get(value, re.sub(r"(\d)$", r" \1", value.lower()))
        elif name == "numId":
            self._paragraphs[-1].is_item = value != "0"

    def _start_content(self, name: str, attributes: Mapping[str, str]) -> None:
        named = named_without_space(attributes)
        match name:
            case "p":
                self._paragraphs.append(_Paragraph(is_outside=self._boxes > 0))
            case "r":
                self._strong = self._emphatic = self._hidden = False
            case "tbl":
                self._tables += 1
            case "tr" if self._tables == 1:
                self._cells, self._is_row_gone = [], False
            case "tc" if self._tables == 1:
                self._cells.append([])
            case "txbxContent":
                self._boxes += 1
            case "bookmarkStart" if named.get("name", "").startswith(CLAUSE):
                (self._paragraphs[-1].bookmarks if self._paragraphs else self._bookmarks).append(named["name"])
            case "commentRangeStart" | "commentReference":
                comment_id = named.get("id", "")
                (self._paragraphs[-1].comments if self._paragraphs else self._comments).append(comment_id)
            case _ if name in _LETTERS and self._open[-2:-1] == ["r"]:
                self._write(_LETTERS[name])

    def characters(self, text: str) -> None:
        """Take characters between two tags."""
        if self._open[-1:] == ["t"] and not self._unread:
            self._write(re.sub("[\n\r\t]", " ", text))

    def _write(self, text: str) -> None:
        if self._gone or not self._paragraphs:
            return
        self._chars_left -= len(text)
        if self._chars_left < 0:
            raise TooMuchInside(f"{MAX_CHARS:,} characters")
        if self._hidden:
            self._note("hidden text", text)
            return
        self._paragraphs[-1].spans.append(Span(text, self._strong, self._emphatic))

    def end(self, _tag: str) -> None:
        """Take the end of an element."""
        name = self._open.pop()
        if self._unread:
            if name in _UNREAD or name == "other:Fallback":
                self._unread -= 1
            return
        if name in _GONE:
            self._gone -= 1
        match name:
            case "p" if self._paragraphs:
                self._end_paragraph(self._paragraphs.pop())
            case "tr" if self._tables == 1:
                self._end_row()
            case "tbl":
                self._tables -= 1
            case "txbxContent":
                self._boxes -= 1
            case "body" if self._rest is not None:
                rest, self._rest = self._rest, None
                self._add(rest)

    def _end_paragraph(self, paragraph: _Paragraph) -> None:
        text = "".join(span.text for span in paragraph.spans).strip()
        if paragraph.is_outside:
            if text:
                self._note("text box", text)
            return
        if self._rest is not None:
            for name in ("spans", "bookmarks", "comments"):
                setattr(paragraph, name, getattr(self._rest, name) + getattr(paragraph, name))
            self._rest = None
        if self._tables:
            self._write_in_cell(paragraph)
        elif paragraph.is_mark_gone and text:
            self._rest = paragraph
        else:
            self._add(paragraph)

    def _write_in_cell(self, paragraph: _Paragraph) -> None:
        self._bookmarks += paragraph.bookmarks
        self._comments += paragraph.comments
        if self._cells:
            cell = self._cells[-1]
            if cell and paragraph.spans:
                cell.append(Span(" "))
            cell += paragraph.spans

    def _end_row(self) -> None:
        spans = [part for cell in self._cells for part in (*trimmed(cell), Span(" · "))][:-1]
        self._cells = []
        if self._is_row_gone or not any(span.text.strip(" ·") for span in spans):
            return
        self._append(WordLine("table", 0, tuple(spans), self._taken_bookmarks(), self._taken_comments()))

    def _add(self, paragraph: _Paragraph) -> None:
        self._bookmarks += paragraph.bookmarks
        self._comments += paragraph.comments
        spans = trimmed(paragraph.spans)
        if not spans and not self._bookmarks:
            return
        kind, level = _kind_of(paragraph)
        self._append(WordLine(kind, level, spans, self._taken_bookmarks(), self._taken_comments()))

    def _append(self, line: WordLine) -> None:
        if len(self.lines) >= MAX_LINES:
            raise TooMuchInside(f"{MAX_LINES:,} paragraphs")
        self.lines.append(line)

    def _taken_bookmarks(self) -> tuple[str, ...]:
        taken, self._bookmarks = tuple(dict.fromkeys(self._bookmarks)), []
        return taken

    def _taken_comments(self) -> tuple[str, ...]:
        taken, self._comments = tuple(dict.fromkeys(self._comments)), []
        return taken

    def _note(self, label: str, text: str) -> None:
        if self.outside and self.outside[-1].place == label == "hidden text":
            self.outside[-1] = OutsideText(label, self.outside[-1].text + text)
        else:
            self.outside.append(OutsideText(label, text))


def block_kind(kind: str) -> BlockKind:
    """Return the kind of a line by its name; a name of no kind is that of a paragraph."""
    return next((block for block in get_args(BlockKind) if block == kind), "text")


def _kind_of(paragraph: _Paragraph) -> tuple[BlockKind, int]:
    match = re.fullmatch(r"heading ([1-9])", paragraph.style)
    if match:
        return "head", int(match[1])
    if paragraph.style == "title":
        return "head", 1
    return ("item", 0) if paragraph.is_item or paragraph.style.startswith("list") else ("text", 0)


def trimmed(spans: Sequence[Span]) -> tuple[Span, ...]:
    """Return spans without the space before and after them, those of one weight joined."""
    joined: list[Span] = []
    for span in spans:
        if joined and (joined[-1].strong, joined[-1].emphatic) == (span.strong, span.emphatic):
            joined[-1] = Span(joined[-1].text + span.text, span.strong, span.emphatic)
        else:
            joined.append(span)
    while joined and not joined[0].text.strip():
        joined.pop(0)
    while joined and not joined[-1].text.strip():
        joined.pop()
    if joined:
        first = joined[0]
        joined[0] = Span(first.text.lstrip(), first.strong, first.emphatic)
        last = joined[-1]
        joined[-1] = Span(last.text.rstrip(), last.strong, last.emphatic)
    return tuple(joined)


def _is_on(attributes: Mapping[str, str]) -> bool:
    return named_without_space(attributes).get("val", "1") not in _OFF
