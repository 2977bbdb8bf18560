"""A text with redlines as both parties read it: each clause filled in, and what is struck and inserted marked."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from app.agreements.clauses.rules import Clause, Terms, filler
from app.agreements.clauses.text import literal
from app.agreements.drafts.comparison import MAX_CHARS, Compared, Run, compare, lines_of
from app.agreements.redlines.rules import Redline, RedlineKind, Text, agreed_clause, keys_in_order


@dataclass(frozen=True)
class MarkedClause:
    """A clause of a text, with what is proposed of it as marks."""

    key: str
    number: int | None  # in the text that was sent; None for an inserted clause
    lines: Sequence[Compared]
    counter_lines: Sequence[Compared]  # the studio's counter against the text that was sent
    redline: Redline | None


def marked_clauses(
    base: Text, redlines: Sequence[Redline], facts: Mapping[str, str], currency: str, sent_text: str
) -> list[MarkedClause]:
    """Return the clauses of a text that stand, with those that are proposed in their places.

    A clause that nothing changes reads as it was sent; one that is changed is filled in with the facts of today before
    and after, so that what differs is the change alone.
    """
    return _Marking(base, redlines, facts, currency, sent_text).clauses()


def clauses_as_sent(text: str, clauses: Sequence[Clause]) -> dict[str, str]:
    """Return the wording of each clause in force by its key, without its heading."""
    texts_by_key: dict[str, str] = {}
    offset, key = 0, None
    for number, clause in enumerate((clause for clause in clauses if clause.stands), start=1):
        heading = f"\n\n## {number}. {literal(clause.title)}\n\n"
        begins = text.find(heading, max(offset - 2, 0))  # an empty clause shares its blank line
        if begins < 0:
            continue
        if key is not None:
            texts_by_key[key] = text[offset:begins]
        offset, key = begins + len(heading), clause.key
    if key is not None:
        texts_by_key[key] = text[offset:]
    return texts_by_key


class _Marking:
    def __init__(
        self, base: Text, redlines: Sequence[Redline], facts: Mapping[str, str], currency: str, sent_text: str
    ) -> None:
        self._clauses, self._terms = base
        self._redlines, self._facts, self._currency = redlines, facts, currency
        self._as_sent = clauses_as_sent(sent_text, self._clauses)
        self._chars_left = MAX_CHARS

    def clauses(self) -> list[MarkedClause]:
        standing = {clause.key: clause for clause in self._clauses if clause.stands}
        numbers = {key: number for number, key in enumerate(standing, start=1)}
        of_clause = {redline.clause_key: redline for redline in self._redlines}
        after = dict(self._terms)
        for redline in self._redlines:
            after |= redline.current_wording.terms if redline.current_wording else {}
        return [
            self._marked(key, numbers.get(key), standing.get(key), of_clause.get(key), after)
            for key in keys_in_order(self._clauses, self._redlines)
            if key in standing or key in of_clause
        ]

    def _marked(
        self, key: str, number: int | None, clause: Clause | None, redline: Redline | None, after: Terms
    ) -> MarkedClause:
        if redline is None:  # its terms may be changed in another clause
            lines = self._compared(clause, clause, after)
            if clause and key in self._as_sent and all(line.change == "same" for line in lines):
                sent = _markdown(Clause(key, clause.title, self._as_sent[key]))
                lines = [Compared(line.kind, "same", [Run("both", line.text)]) for line in lines_of(sent)]
            return MarkedClause(key, number, lines, (), None)
        proposed = None
        if redline.kind is not RedlineKind.STRIKE:
            proposed = Clause(key, redline.wording.title, redline.wording.text)
        lines = self._compared(clause, proposed, self._terms | redline.wording.terms)
        counter_lines: Sequence[Compared] = ()
        if redline.agreed_wording not in (None, redline.wording):
            counter = agreed_clause(redline, self._clauses)
            counter_lines = self._compared(clause, counter, self._terms | redline.agreed_wording.terms)
        return MarkedClause(key, number, lines, counter_lines, redline)

    def _compared(self, earlier: Clause | None, later: Clause | None, after: Terms) -> list[Compared]:
        old, new = self._filled(earlier, self._terms), self._filled(later, after)
        if old == new and earlier != later:  # a variable became its value: the sources differ, and not what is read
            old, new = _markdown(earlier), _markdown(later)
        if old == new:
            return [Compared(line.kind, "same", [Run("both", line.text)]) for line in lines_of(new)]
        self._chars_left -= len(old) + len(new)
        if self._chars_left >= 0:
            return compare(old, new)
        gone = [Compared(line.kind, "removed", [Run("earlier", line.text)]) for line in lines_of(old)]
        return [*gone, *(Compared(line.kind, "added", [Run("later", line.text)]) for line in lines_of(new))]

    def _filled(self, clause: Clause | None, terms: Terms) -> str:
        fill = filler(terms, self._facts, self._currency)
        return _markdown(clause and Clause(clause.key, clause.title, fill(clause.text)))


def _markdown(clause: Clause | None) -> str:
    return f"## {literal(clause.title)}\n\n{clause.text.strip()}\n" if clause else ""
