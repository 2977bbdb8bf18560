"""The few forms that a contract is written in: heads, paragraphs, lists and tables, with bold and italic words."""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Literal

BlockKind = Literal["head", "text", "item", "table"]
_INLINE = re.compile(r"\\([\\*|#\-{}.])|(\*\*)|(\*)|\x00([a-z0-9_.]*)\x00")
_ITEM = re.compile(r"(?:-|\d+\.)\s+(.*)")
_HEAD = re.compile(r"(#{1,3})\s+(.*)")
_CELL = re.compile(r"(?<!\\)\|")
_RULE = re.compile(r"[\s|:-]+")


Marker = Callable[[str, str], str]  # the name of a figure and its words, to the words as a text has them


@dataclass(frozen=True)
class Span:
    """A run of letters of one weight; `field` names the figure that they are, in a text that marks its figures."""

    text: str
    strong: bool = False
    emphatic: bool = False
    field: str = ""


@dataclass(frozen=True)
class Block:
    """A head, a paragraph, one item of a list, or a table whose first row is its head."""

    kind: BlockKind
    spans: list[Span] = field(default_factory=list)
    level: int = 0  # of a head
    rows: list[list[list[Span]]] = field(default_factory=list)


def literal(text: str) -> str:
    """Return text that says itself, whatever characters it has: a name, a question, a cue."""
    return re.sub(r"([\\*|{}])", r"\\\1", " ".join(text.split()))


def unmarked(_name: str, words: str) -> str:
    """Return the words of a figure as every text has them."""
    return words


def marked(name: str, words: str) -> str:
    """Return the words of a figure between marks, which `spans_of` reads; no text that is kept has a NUL."""
    return words if "\x00" in words else f"\x00{name}\x00{words}\x00\x00"


def head(words: str, level: int) -> Block:
    """Return a head that says these words, whatever characters they have."""
    return Block("head", [Span(" ".join(words.split()))], level)


def spans_of(line: str) -> list[Span]:
    """Return the runs of a line."""
    spans: list[Span] = []
    strong = emphatic = False
    name = written = ""

    def close() -> None:
        nonlocal written
        if written or name:
            spans.append(Span(written, strong, emphatic, name))
        written = ""

    offset = 0
    for match in _INLINE.finditer(line):
        written += line[offset : match.start()]
        offset = match.end()
        if match[1]:
            written += match[1]
            continue
        close()
        if match[2]:
            strong = not strong
        elif match[3]:
            emphatic = not emphatic
        else:
            name = match[4]
    written += line[offset:]
    close()
    return spans


def blocks_of(markdown: str) -> list[Block]:
    """Return the blocks of a text, in order."""
    return [block for chunk in re.split(r"\n\s*\n", markdown) for block in _blocks_of_chunk(chunk.strip("\n"))]


def _blocks_of_chunk(chunk: str) -> Iterator[Block]:
    paragraph: list[str] = []
    kind: BlockKind = "text"
    rows: list[list[list[Span]]] = []

    def close() -> Iterator[Block]:
        nonlocal paragraph, kind, rows
        if paragraph:
            yield Block(kind, spans_of(" ".join(paragraph)))
        if rows:
            yield Block("table", rows=rows)
        paragraph, kind, rows = [], "text", []

    for line in (line.strip() for line in chunk.split("\n")):
        if not line:
            continue
        if line.startswith("|"):
            if paragraph:
                yield from close()
            if not _RULE.fullmatch(line):
                rows.append([spans_of(cell.strip()) for cell in _CELL.split(line.strip("|"))])
        elif head := _HEAD.fullmatch(line):
            yield from close()
            yield Block("head", spans_of(head[2]), level=len(head[1]))
        elif item := _ITEM.fullmatch(line):
            yield from close()
            kind, paragraph = "item", [item[1]]
        else:
            if rows:
                yield from close()
            paragraph.append(line)
    yield from close()


def plain(block: Block) -> list[str]:
    """Return the words of a block, without its looks: one line, or one for each row of a table."""
    if block.kind == "table":
        return [" · ".join("".join(span.text for span in cell) for cell in row) for row in block.rows]
    return ["".join(span.text for span in block.spans)]
