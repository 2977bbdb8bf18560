"""A clause's Markdown after its lines were edited elsewhere: what was not edited stays as it is, byte for byte."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from app.agreements.clauses.rules import (
    VARIABLE,
    Terms,
    TermValue,
    known_terms,
    term_errors,
    variables_in,
    written_term,
)
from app.agreements.clauses.source import Letter, Piece, SourceLine, lines_with_places, pieces_of
from app.agreements.clauses.text import BlockKind
from app.agreements.drafts.differences import differences
from app.agreements.word.body import WordLine
from app.agreements.word.line_tokens import Glyph, letters_of_source, letters_of_word, likeness, line_key, tokens_of

ALIKE, NEAR = 0.4, 12  # as `comparison` pairs lines
_MARKUP = re.compile(r"([\\*|{}])")
_AS_OTHER_KIND = re.compile(r"(?=[#-])(?:#{1,3}|-)\s|\d+(?=\.\s)")  # how a heading or an item begins
_AS_RULE = re.compile(r"[\s·:]*(?=-)[\s·:-]+")  # a row that would be read as the line under a table's head


@dataclass(frozen=True)
class Edited:
    """A clause as it was edited: its Markdown, the terms that change, the variables whose values are text now."""

    source: str
    terms: Terms
    written_out: Sequence[str]
    is_changed: bool


class _Kept(NamedTuple):
    """A stretch of the text as it was sent."""

    begins: int
    ends: int


class _Value(NamedTuple):
    """A variable whose term has another value now."""

    name: str


_Part = _Kept | _Value | str  # a text is new


class _Glyph(NamedTuple):
    """A character of an edited line: the place of one that stood in it, a new one, or a variable."""

    said: int | str | _Value
    strong: bool
    emphatic: bool


def edited_clause(
    source: str,
    sent: str,
    lines: Sequence[SourceLine],
    word_lines: Sequence[WordLine],
    *,
    fill: Callable[[str], str],
    currency: str,
    terms: Terms,
    is_plain: bool,
) -> Edited:
    """Return a clause with the lines that a document has of it.

    `sent` is the clause as it was sent, `lines` are its lines. Where a value was edited and the new words are a value
    of its term, the term changes; `terms` are those that may. With `is_plain`, bold and italic words are not compared.
    """
    word_lines = [line for line in word_lines if line.text]
    if [line_key(letters_of_source(line), line.kind, is_plain) for line in lines] == [
        line_key(letters_of_word(line), line.kind, is_plain) for line in word_lines
    ]:
        return Edited(source, {}, (), is_changed=False)
    pieces = pieces_of(source, sent, fill)
    if pieces is None:
        pieces = [Piece(0, len(sent))]
    edited_lines = [(line.kind, line.text) for line in word_lines]
    named = variables_in(source)
    for changeable in (terms, {}):
        edit = _Edit(sent, lines, pieces, is_plain=is_plain, currency=currency, terms=changeable)
        text = edit.text(word_lines)
        written_out = tuple(name for name in named if name not in variables_in(text))
        if _read_back(text, sent, pieces, edit.changed, currency) == edited_lines:
            return Edited(text, edit.changed, written_out, is_changed=True)
    text = _Edit("", (), (), is_plain=is_plain, currency=currency, terms={}).text(word_lines)
    return Edited(text, {}, tuple(named), is_changed=True)


def _read_back(
    source: str, sent: str, pieces: Sequence[Piece], changed: Terms, currency: str
) -> list[tuple[BlockKind, str]]:
    """Return the text of an edited clause's lines with its values filled in."""
    texts = {piece.name: sent[piece.begins : piece.ends] for piece in pieces}
    texts |= {name: written_term(name, value, currency) for name, value in changed.items()}
    filled = VARIABLE.sub(lambda match: texts.get(match[1], match[0]), source).strip()
    return [(line.kind, line.text) for line in lines_with_places(filled)]


class _Edit:
    def __init__(
        self,
        sent: str,
        lines: Sequence[SourceLine],
        pieces: Sequence[Piece],
        *,
        is_plain: bool,
        currency: str,
        terms: Mapping[str, TermValue],
    ) -> None:
        self._sent, self._lines, self._pieces = sent, lines, pieces
        self._is_plain, self._currency, self._terms = is_plain, currency, terms
        self.changed: Terms = {}

    def text(self, word_lines: Sequence[WordLine]) -> str:
        parts: list[_Part] = []
        before: tuple[int | None, BlockKind] | None = None  # the line before: its place, and its kind
        for index, word_line in self._paired(word_lines):
            kind = self._lines[index].kind if index is not None else word_line.kind
            parts += self._between(before, index, kind)
            parts += self._line(index, word_line, number_after=self._number_of(before))
            before = (index, kind)
        if before is not None and before[0] is not None and before[0] == len(self._lines) - 1:
            parts.append(_Kept(self._lines[-1].ends, len(self._sent)))
        return "".join(self._written(parts))

    def _paired(self, word_lines: Sequence[WordLine]) -> Iterator[tuple[int | None, WordLine]]:
        """Yield the lines of the document, each with the place of the line that it was; None for a new one."""
        old = [line_key(letters_of_source(line), line.kind, self._is_plain) for line in self._lines]
        new = [line_key(letters_of_word(line), line.kind, self._is_plain) for line in word_lines]
        for is_same, a, b, c, d in differences(old, new):
            if is_same:
                yield from zip(range(a, b), word_lines[c:d], strict=True)
                continue
            at, is_single = a, b - a == d - c == 1
            for line in word_lines[c:d]:
                partner = next(
                    (
                        index
                        for index in range(at, min(at + NEAR, b))
                        if self._lines[index].kind == line.kind
                        and (is_single or likeness(self._lines[index].text, line.text) >= ALIKE)
                    ),
                    None,
                )
                yield partner, line
                if partner is not None:
                    at = partner + 1

    def _between(
        self, before: tuple[int | None, BlockKind] | None, index: int | None, kind: BlockKind
    ) -> Iterator[_Part]:
        if before is None:
            if index == 0:
                yield _Kept(0, self._lines[0].begins)
            return
        last, last_kind = before
        following = last + 1 if last is not None and last + 1 < len(self._lines) else None
        if last is not None and following is not None and self._lines[following].kind == kind:
            stretch = _Kept(self._lines[last].ends, self._lines[following].begins)
            yield stretch if index == following else self._sent[stretch.begins : stretch.ends]
        else:
            yield "\n" if last_kind == kind and kind in ("item", "table") else "\n\n"

    def _number_of(self, before: tuple[int | None, BlockKind] | None) -> str:
        """Return the beginning of an item that follows a line: a dash, or the next number."""
        if before is None or before[0] is None:
            return "- "
        line = self._lines[before[0]]
        number = re.match(r"(\d+)\.", self._sent[line.begins : line.starts])
        return f"{int(number[1]) + 1}. " if number and line.kind == "item" else "- "

    def _line(self, index: int | None, word_line: WordLine, *, number_after: str) -> Iterator[_Part]:
        new = letters_of_word(word_line)
        if index is None:
            begins = {"head": "### ", "item": number_after, "table": "| "}.get(word_line.kind, "")
            yield begins
            yield from self._composed([_Glyph(*each) for each in new], (), word_line.kind)
        else:
            line = self._lines[index]
            if line_key(letters_of_source(line), line.kind, self._is_plain) == line_key(
                new, word_line.kind, self._is_plain
            ):
                yield _Kept(line.begins, line.ends)
                return
            glyphs = self._with_values(line, self._compared(line, new))
            if line.kind == "table":
                yield "| "
            elif line.begins < line.starts:
                yield _Kept(line.begins, line.starts)
            yield from self._composed(glyphs, line.letters, line.kind)
        if word_line.kind == "table":
            yield " |"

    def _compared(self, line: SourceLine, new: Sequence[Glyph]) -> list[_Glyph]:
        """Return the characters of an edited line, those that stood in it by their places."""
        old = letters_of_source(line)
        is_plain = self._is_plain or line.kind == "head"
        old_tokens, new_tokens = tokens_of(old, is_plain), tokens_of(new, is_plain)
        glyphs: list[_Glyph] = []
        at_old = [0]
        for token in old_tokens:
            at_old.append(at_old[-1] + len(token[0]))
        at_new = [0]
        for token in new_tokens:
            at_new.append(at_new[-1] + len(token[0]))
        for is_same, a, b, c, d in differences(old_tokens, new_tokens):
            if is_same:
                glyphs += [_Glyph(at, old[at].strong, old[at].emphatic) for at in range(at_old[a], at_old[b])]
            else:
                glyphs += [_Glyph(*new[at]) for at in range(at_new[c], at_new[d])]
        return glyphs

    def _with_values(self, line: SourceLine, glyphs: list[_Glyph]) -> list[_Glyph]:
        """Return an edited line with the variables whose new words are a value of their term."""
        for piece in self._pieces:
            inside = [
                at
                for at, letter in enumerate(line.letters)
                if piece.begins <= letter.begins and letter.ends <= piece.ends
            ]
            if piece.name not in self._terms or not inside or not piece.begins < piece.ends:
                continue
            first, last = inside[0], inside[-1]
            begins = max((at + 1 for at, glyph in enumerate(glyphs) if _is_before(glyph, first)), default=0)
            ends = min((at for at, glyph in enumerate(glyphs) if _is_after(glyph, last)), default=len(glyphs))
            region = glyphs[begins:ends]
            if [glyph.said for glyph in region] == list(range(first, last + 1)):
                continue
            words = "".join(
                line.letters[glyph.said].letter if isinstance(glyph.said, int) else str(glyph.said) for glyph in region
            )
            looks = line.letters[first]
            if not self._is_plain and any(glyph[1:] != (looks.strong, looks.emphatic) for glyph in region):
                continue
            value = _value_in(piece.name, words, self._currency)
            if value is None or self.changed.get(piece.name, value) != value:
                continue
            self.changed[piece.name] = value
            glyphs = [
                *glyphs[:begins],
                _Glyph(_Value(piece.name), looks.strong, looks.emphatic),
                *glyphs[ends:],
            ]
        return glyphs

    def _composed(self, glyphs: Sequence[_Glyph], letters: Sequence[Letter], kind: BlockKind) -> Iterator[_Part]:
        """Yield the parts of a line, with the marks of bold and italic words where these begin and end."""
        strong = emphatic = False
        letters_written = [
            letters[written_glyph.said].letter if isinstance(written_glyph.said, int) else written_glyph.said
            for written_glyph in glyphs
        ]
        escaped = _place_to_escape(
            "".join(written_letter if isinstance(written_letter, str) else "x" for written_letter in letters_written),
            kind,
        )
        for at, glyph in enumerate(_with_spaces_between(glyphs, letters_written)):
            if kind != "head" and (strong, emphatic) != glyph[1:]:
                yield ("**" if strong != glyph.strong else "") + ("*" if emphatic != glyph.emphatic else "")
                strong, emphatic = glyph[1:]
            if at == escaped:
                yield "\\"
            letter = letters[glyph.said] if isinstance(glyph.said, int) else None
            if kind == "table" and self._is_bar(letters_written, at, letter):
                yield "|"
            elif letter is not None:
                yield _Kept(letter.begins, letter.ends) if letter.begins < letter.ends else letter.letter
            elif isinstance(glyph.said, str):
                yield _MARKUP.sub(r"\\\1", glyph.said)
            elif isinstance(glyph.said, _Value):
                yield glyph.said
        if strong or emphatic:
            yield ("**" if strong else "") + ("*" if emphatic else "")

    def _is_bar(self, written: Sequence[str | _Value], at: int, letter: Letter | None) -> bool:
        """Whether a character is the border of two cells."""
        if written[at] != "·":
            return False
        if letter:
            return self._sent[letter.begins] == "|"
        return 0 < at < len(written) - 1 and written[at - 1] == written[at + 1] == " "

    def _written(self, parts: Sequence[_Part]) -> Iterator[str]:
        """Yield parts as Markdown: a variable all of which is kept by its name, a part of its value as it was sent."""
        kept: list[_Part] = []
        for part in parts:
            last = kept[-1] if kept else None
            if isinstance(part, _Kept) and isinstance(last, _Kept) and last.ends == part.begins:
                kept[-1] = _Kept(last.begins, part.ends)
            elif part != "":
                kept.append(part)
        empty_written: set[int] = set()
        for part in kept:
            if isinstance(part, str):
                yield part
            elif isinstance(part, _Value):
                yield f"{{{part.name}}}"
            else:
                yield from self._source_of(part, empty_written)

    def _source_of(self, stretch: _Kept, empty_written: set[int]) -> Iterator[str]:
        for number, piece in enumerate(self._pieces):
            begins, ends = max(piece.begins, stretch.begins), min(piece.ends, stretch.ends)
            if piece.name and (begins, ends) == (piece.begins, piece.ends) and number not in empty_written:
                if begins == ends:
                    empty_written.add(number)
                yield f"{{{piece.name}}}"
            elif begins < ends:
                yield self._sent[begins:ends]


def _place_to_escape(text: str, kind: BlockKind) -> int | None:
    """Return the index of the character that needs a backslash, so that a line is read as one of its kind."""
    if kind == "text" and (match := _AS_OTHER_KIND.match(text)):
        return match.end() if text[0].isdigit() else 0
    return text.index("-") if kind == "table" and _AS_RULE.fullmatch(text) else None


def _with_spaces_between(glyphs: Sequence[_Glyph], written: Sequence[str | _Value]) -> Iterator[_Glyph]:
    """Yield characters; a space beside what is new is bold or italic where both its neighbours are."""
    for at, glyph in enumerate(glyphs):
        before, after = glyphs[at - 1] if at else None, glyphs[at + 1] if at + 1 < len(glyphs) else None
        letter = written[at]
        is_as_before = all(neighbour is None or isinstance(neighbour.said, int) for neighbour in (before, glyph, after))
        if not isinstance(letter, str) or not letter.isspace() or is_as_before:
            yield glyph
        elif before is None or after is None:
            yield _Glyph(glyph.said, strong=False, emphatic=False)
        else:
            yield _Glyph(glyph.said, before.strong and after.strong, before.emphatic and after.emphatic)


def _is_before(glyph: _Glyph, first: int) -> bool:
    return isinstance(glyph.said, int) and glyph.said < first


def _is_after(glyph: _Glyph, last: int) -> bool:
    return isinstance(glyph.said, int) and glyph.said > last


def _words(glyphs: Sequence[_Glyph], letters: Sequence[Letter]) -> str:
    texts = (letters[glyph.said].letter if isinstance(glyph.said, int) else glyph.said for glyph in glyphs)
    return "".join(letter for letter in texts if isinstance(letter, str))


def _value_in(name: str, words: str, currency: str) -> TermValue | None:
    """Return the value of a term that a text would write in these words; None where it is none."""
    term = known_terms().get(name)
    values: list[TermValue] = [choice.value for choice in term.choices] if term else []
    if not values:
        digits = "".join(re.findall(r"\d", words))
        numbers = [int(digits), int(digits) * 10, int(digits) * 100] if 0 < len(digits) < 16 else []
        values = [*numbers, _MARKUP.sub(r"\\\1", words)]
    for value in values:
        is_written = written_term(name, value, currency) == (
            words if not isinstance(value, str) or (term and term.choices) else _MARKUP.sub(r"\\\1", words)
        )
        if is_written and not any(term_errors(name, value)):
            return value
    return None
