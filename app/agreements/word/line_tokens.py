"""The lines of a text and of a document as words, spaces and signs with their looks, so that both can be compared."""

import re
from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

from app.agreements.clauses.source import SourceLine
from app.agreements.clauses.text import BlockKind, Span
from app.agreements.word.body import WordLine

_TOKEN = re.compile(r" · |\w+|\s+|[^\w\s]")


class Glyph(NamedTuple):
    """A character as it is read."""

    letter: str
    strong: bool
    emphatic: bool


def letters_of_word(line: WordLine) -> list[Glyph]:
    """Return the characters of a line in a document."""
    return [Glyph(letter, *_looks(span)) for span in line.spans for letter in span.text]


def _looks(span: Span) -> tuple[bool, bool]:
    return span.strong, span.emphatic


def letters_of_source(line: SourceLine) -> list[Glyph]:
    """Return the characters of a line that was sent."""
    return [Glyph(letter.letter, letter.strong, letter.emphatic) for letter in line.letters]


def line_key(shown: Sequence[Glyph], kind: BlockKind, is_plain: bool) -> tuple[object, ...]:
    """Return the key that two equal lines share."""
    return (kind, *tokens_of(shown, is_plain or kind == "head"))


def tokens_of(shown: Sequence[Glyph], is_plain: bool) -> list[tuple[str, bool, bool]]:
    """Return words, spaces and signs with their looks; a space has none, and a word of two looks is two."""
    tokens: list[tuple[str, bool, bool]] = []
    for match in _TOKEN.finditer("".join(glyph.letter for glyph in shown)):
        if is_plain or not match[0].strip(" ·"):
            tokens.append((match[0], False, False))
            continue
        begins = match.start()
        for at in range(match.start() + 1, match.end() + 1):
            if at == match.end() or shown[at][1:] != shown[begins][1:]:
                letters = "".join(glyph.letter for glyph in shown[begins:at])
                tokens.append((letters, shown[begins].strong, shown[begins].emphatic))
                begins = at
    return tokens


def likeness(line: str, other: str) -> float:
    """Return the share of words that two lines have in common."""
    bag, other_bag = Counter(line.split()), Counter(other.split())
    whole = bag.total() + other_bag.total()
    return 2 * (bag & other_bag).total() / whole if whole else 1.0
