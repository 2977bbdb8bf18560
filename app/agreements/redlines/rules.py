"""Redlines, stated without a database: what a designer proposes clause by clause, and what the studio answers."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import datetime
from enum import StrEnum
from typing import Any

from app.agreements.clauses.figures import figure_errors, with_fields
from app.agreements.clauses.rules import MAX_CLAUSES, Clause, Terms, clause_errors, names_in, term_errors
from app.agreements.rules import ContractKind
from app.core.plural import counted

PROPOSED, ANSWERED, SENT = "redlines_proposed", "redline_answered", "sent"  # kinds of entries of the record
RETURNS = ("change_requested", PROPOSED)  # entries by which a contract goes back to the studio
TURNS = (SENT, "taken_back", *RETURNS)  # entries after which the other party is next
_STEM_CHARS = 40
_INSERTED = "changes_"  # begins the key of a clause that is proposed and has none yet
Text = tuple[Sequence[Clause], Terms]  # clauses and terms of a version


class RedlineKind(StrEnum):
    """The kind of a proposal on a clause."""

    REPLACE = "replace"
    STRIKE = "strike"
    INSERT = "insert"


class RedlineAnswerKind(StrEnum):
    """The studio's kind of answer to a redline."""

    ACCEPTED = "accepted"
    REFUSED = "refused"
    COUNTERED = "countered"


@dataclass(frozen=True)
class Wording:
    """Title and text of a clause in Markdown, and the terms that it changes."""

    title: str = ""
    text: str = ""
    terms: Terms = field(default_factory=dict)

    def as_facts(self) -> dict[str, Any]:
        """Return the wording as the record keeps it."""
        return {"title": self.title, "text": self.text, "terms": dict(self.terms)}

    @classmethod
    def of(cls, facts: Mapping[str, Any]) -> "Wording":
        """Return a wording from how the record keeps it."""
        return cls(facts["title"], facts["text"], dict(facts["terms"]))


@dataclass(frozen=True)
class Change:
    """A change of one clause, as its designer writes it."""

    kind: RedlineKind
    clause_key: str | None  # None: a clause that is inserted
    after_key: str | None  # of an inserted clause: the one before it; None: it is the first
    wording: Wording
    comment: str = ""


@dataclass(frozen=True)
class Answer:
    """The studio's answer to a redline; a counter has its own wording."""

    kind: RedlineAnswerKind
    wording: Wording | None
    comment: str
    by: str
    at: datetime


@dataclass(frozen=True)
class Redline:
    """A change of one clause that was proposed, with the studio's last answer to it."""

    number: int  # counts in the contract
    kind: RedlineKind
    clause_key: str
    after_key: str | None
    wording: Wording  # empty for a clause that is struck
    comment: str
    answer: Answer | None = None

    @property
    def agreed_wording(self) -> Wording | None:
        """The wording that goes into the draft; None while it is open, and where it is refused."""
        match self.answer:
            case Answer(kind=RedlineAnswerKind.ACCEPTED):
                return self.wording
            case Answer(kind=RedlineAnswerKind.COUNTERED, wording=wording):
                return wording
        return None

    @property
    def current_wording(self) -> Wording | None:
        """The wording so far: as proposed while it is open; None where it is refused."""
        return self.agreed_wording if self.answer else self.wording

    def as_facts(self) -> dict[str, Any]:
        """Return the proposal as the record keeps it."""
        return {
            "number": self.number,
            "change": self.kind.value,
            "clause": self.clause_key,
            "after": self.after_key or "",
            **self.wording.as_facts(),
            "comment": self.comment,
        }

    @classmethod
    def of(cls, facts: Mapping[str, Any]) -> "Redline":
        """Return a redline, not answered, from how the record keeps it."""
        return cls(
            number=facts["number"],
            kind=RedlineKind(facts["change"]),
            clause_key=facts["clause"],
            after_key=facts["after"] or None,
            wording=Wording.of(facts),
            comment=facts["comment"],
        )


@dataclass(frozen=True)
class Round:
    """Redlines that were proposed together, of one version; closed by the version that was sent next."""

    number: int
    version: int
    note: str
    by: str
    at: datetime
    redlines: Sequence[Redline]
    sent_version: int | None = None

    @property
    def unanswered(self) -> list[Redline]:
        """The redlines that have no answer yet."""
        return [redline for redline in self.redlines if redline.answer is None]


def rounds_of(entries: Iterable[tuple[str, datetime, Mapping[str, Any]]]) -> list[Round]:
    """Return the rounds of a record, in order, from the kind, instant and payload of its entries."""
    rounds: list[Round] = []
    for kind, at, facts in entries:
        if kind == PROPOSED:
            redlines = [Redline.of(facts) for facts in facts["redlines"]]
            rounds.append(Round(len(rounds) + 1, facts["version"], facts["note"], facts["by"], at, redlines))
        elif rounds and rounds[-1].sent_version is None:
            if kind == SENT:
                rounds[-1] = replace(rounds[-1], sent_version=facts["version"])
            elif kind == ANSWERED:
                rounds[-1] = _answered(rounds[-1], at, facts)
    return rounds


def _answered(round_: Round, at: datetime, facts: Mapping[str, Any]) -> Round:
    kind = RedlineAnswerKind(facts["answer"])
    wording = Wording.of(facts) if kind is RedlineAnswerKind.COUNTERED else None
    answer = Answer(kind, wording, facts["comment"], facts["by"], at)
    redlines = [
        replace(redline, answer=answer) if redline.number == facts["redline"] else redline
        for redline in round_.redlines
    ]
    return replace(round_, redlines=redlines)


def numbered(changes: Sequence[Change], first: int) -> list[Redline]:
    """Return changes as redlines, numbered on; an inserted clause has a key of its own."""
    return [
        Redline(
            number=number,
            kind=change.kind,
            clause_key=change.clause_key or _key_of(change.wording.title, number),
            after_key=change.after_key if change.kind is RedlineKind.INSERT else None,
            wording=Wording() if change.kind is RedlineKind.STRIKE else change.wording,
            comment=change.comment,
        )
        for number, change in enumerate(changes, start=first)
    ]


def _key_of(title: str, number: int) -> str:
    stem = re.sub(r"[^a-z0-9]+", "_", title.lower()).strip("_")[:_STEM_CHARS].rstrip("_")
    return "_".join(part for part in ("own", stem, str(number)) if part)


def change_errors(changes: Sequence[Change], clauses: Sequence[Clause], terms: Terms) -> Iterator[tuple[str, str]]:
    """Yield the faults of proposed changes of a text: the place, as `changes.INDEX`, and the fault in words."""
    standing = {clause.key: clause for clause in clauses if clause.stands}
    seen: set[str] = set()
    of_terms: dict[str, int | str] = {}
    for index, change in enumerate(changes):
        where = f"changes.{index}"
        for name, value in change.wording.terms.items():
            if of_terms.setdefault(name, value) != value:
                yield where, f"{{{name}}} has another value in an earlier change"
        named = change.after_key if change.kind is RedlineKind.INSERT else change.clause_key or ""
        if named is not None and named not in standing:
            yield where, f"this version has no clause {named}" if named else "name the clause that is changed"
            continue
        if change.kind is not RedlineKind.INSERT and named:
            if named in seen:
                yield where, f"the clause {standing[named].title} is changed twice"
            seen.add(named)
        if change.kind is RedlineKind.STRIKE:
            continue
        yield from ((where, fault) for fault in wording_errors(change.wording, terms))
        if change.kind is RedlineKind.REPLACE and named and _is_as_before(change.wording, standing[named], terms):
            yield where, f"nothing of {standing[named].title} is changed"
    inserted = [change for change in changes if change.kind is RedlineKind.INSERT]
    struck = {change.clause_key for change in changes if change.kind is RedlineKind.STRIKE}
    if not standing.keys() - struck and not inserted:
        yield "changes", "no clause would be left; a contract needs at least one"
    if len(clauses) + len(inserted) > MAX_CLAUSES:
        yield "changes", f"{len(clauses) + len(inserted)} clauses; at most {MAX_CLAUSES} are kept"


def wording_errors(wording: Wording, terms: Terms) -> Iterator[str]:
    """Yield the faults of a clause's wording, by the rules of a draft."""
    clause = Clause("key", wording.title, wording.text)
    yield from clause_errors(clause, terms)
    named = names_in([clause])
    for name, value in wording.terms.items():
        if name not in terms or name not in named:
            yield f"the clause does not name {{{name}}}, so it cannot change it"
        else:
            yield from term_errors(name, value)


def proposed_text(changes: Sequence[Change], clauses: Sequence[Clause], terms: Terms) -> tuple[list[Clause], Terms]:
    """Return the text that proposed changes would make; each inserted clause has the key `changes_INDEX`."""
    of_clause = {change.clause_key: change for change in changes if change.kind is not RedlineKind.INSERT}
    inserted: dict[str | None, list[Clause]] = {}
    for index, change in enumerate(changes):
        if change.kind is RedlineKind.INSERT:
            clause = Clause(f"{_INSERTED}{index}", change.wording.title, change.wording.text)
            inserted.setdefault(change.after_key, []).append(clause)
    after = list(inserted.get(None, []))
    for clause in clauses:
        made = of_clause.get(clause.key)
        if made is not None and made.kind is RedlineKind.STRIKE:
            after.append(replace(clause, stands=False))
        else:
            after.append(replace(clause, title=made.wording.title, text=made.wording.text) if made else clause)
        after += inserted.get(clause.key, [])
    return after, dict(terms) | {name: value for change in changes for name, value in change.wording.terms.items()}


def proposed_figure_errors(
    changes: Sequence[Change], clauses: Sequence[Clause], terms: Terms, kind: ContractKind
) -> Iterator[tuple[str, str]]:
    """Yield the figures that proposed changes take out of a text, or type as a number: `changes.INDEX`, and the fault.

    What was wrong before is not the changes' fault.
    """
    before = set(figure_errors(clauses, terms, kind))
    index_of = {change.clause_key: index for index, change in enumerate(changes) if change.clause_key}
    by_struck = {
        name: index_of[clause.key] for clause in clauses if clause.key in index_of for name in names_in([clause])
    }
    for where, message in figure_errors(*proposed_text(changes, clauses, terms), kind):
        if (where, message) in before:
            continue
        part, _, name = where.partition(".")
        if name.startswith(_INSERTED):
            yield f"changes.{name.removeprefix(_INSERTED)}", message
        elif part == "terms":
            yield (f"changes.{by_struck[name]}" if name in by_struck else "changes"), f"{{{name}}}: {message}"
        else:
            yield (f"changes.{index_of[name]}" if name in index_of else "changes"), message


def with_fields_put_back(
    changes: Sequence[Change], clauses: Sequence[Clause], terms: Terms, currency: str
) -> list[Change]:
    """Return changes in which a number that was typed over a field is the new value of the field."""
    before = {clause.key: clause.text for clause in clauses}
    return [
        replace(change, wording=wording_with_fields(change.wording, before[change.clause_key], terms, currency))
        if change.kind is RedlineKind.REPLACE and change.clause_key in before
        else change
        for change in changes
    ]


def wording_with_fields(wording: Wording, before: str, terms: Terms, currency: str) -> Wording:
    """Return a wording in which a number that was typed over a field of the text before is its new value."""
    text, changed = with_fields(wording.text, before, terms, currency)
    return replace(wording, text=text, terms=wording.terms | changed)


def _is_as_before(wording: Wording, clause: Clause, terms: Terms) -> bool:
    same_terms = all(terms.get(name) == value for name, value in wording.terms.items())
    return (wording.title, wording.text) == (clause.title, clause.text) and same_terms


def keys_in_order(clauses: Sequence[Clause], redlines: Sequence[Redline]) -> list[str]:
    """Return the keys of a text's clauses in order, with those that redlines insert in their places."""
    inserted: dict[str | None, list[str]] = {}
    for redline in redlines:
        if redline.kind is RedlineKind.INSERT:
            inserted.setdefault(redline.after_key, []).append(redline.clause_key)
    keys = list(inserted.get(None, []))
    for clause in clauses:
        keys += [clause.key, *inserted.get(clause.key, [])]
    return keys


def answered_draft(draft: Text, base: Text, round_: Round, answered: Redline) -> tuple[list[Clause], Terms]:
    """Return a draft's clauses and terms after an answer; what an earlier answer to the same redline did is undone.

    `base` is the text that the round is about. A refusal leaves the clause as the draft has it.
    """
    clauses, terms = list(draft[0]), dict(draft[1])
    base_clauses = {clause.key: clause for clause in base[0]}
    before = next(redline for redline in round_.redlines if redline.number == answered.number)
    order = keys_in_order(base[0], round_.redlines)
    earlier = order[: order.index(answered.clause_key)]
    if (undone := before.agreed_wording) is not None:
        clauses = [clause for clause in clauses if clause.key != before.clause_key]
        if before.kind is not RedlineKind.INSERT:
            clauses = _with(clauses, base_clauses[before.clause_key], earlier)
        terms |= {name: base[1][name] for name in undone.terms}
    if (clause := agreed_clause(answered, base[0])) is not None and (wording := answered.agreed_wording) is not None:
        clauses = _with(clauses, clause, earlier)
        terms |= wording.terms
    return clauses, terms


def agreed_clause(redline: Redline, base: Sequence[Clause]) -> Clause | None:
    """Return a clause as an answered redline has it; None while it is open, and where it is refused."""
    wording = redline.agreed_wording
    if wording is None:
        return None
    if redline.kind is RedlineKind.STRIKE and wording == redline.wording:
        return next(replace(clause, stands=False) for clause in base if clause.key == redline.clause_key)
    return Clause(redline.clause_key, wording.title, wording.text)


def _with(clauses: Sequence[Clause], clause: Clause, earlier: Sequence[str]) -> list[Clause]:
    """Return clauses with one in its place: its own where it has one, else after the nearest that stands before it."""
    keys = [each.key for each in clauses]
    if clause.key in keys:
        return [clause if each.key == clause.key else each for each in clauses]
    index = next((keys.index(key) + 1 for key in reversed(earlier) if key in keys), 0)
    return [*clauses[:index], clause, *clauses[index:]]


def is_in(redline: Redline, text: Text, base: Sequence[Clause]) -> bool:
    """Whether a text has a redline as it was answered, word for word; True where there is nothing that it must have."""
    agreed, wording = agreed_clause(redline, base), redline.agreed_wording
    if agreed is None or wording is None:
        return True
    clauses, terms = text
    current = next((clause for clause in clauses if clause.key == agreed.key), None)
    if not agreed.stands:
        return current is None or not current.stands
    return current == agreed and all(terms.get(name) == value for name, value in wording.terms.items())


def faults_of_sent(rounds: Sequence[Round], texts: Mapping[int, Text]) -> Iterator[str]:
    """Yield, in words, where a text that was sent has not what was agreed about the one before."""
    for round_ in rounds:
        if round_.sent_version is None or {round_.version, round_.sent_version} - texts.keys():
            continue
        for redline in round_.unanswered:
            yield f"version {round_.sent_version} was sent, and redline {redline.number} has no answer"
        for redline in round_.redlines:
            if not is_in(redline, texts[round_.sent_version], texts[round_.version][0]):
                yield f"version {round_.sent_version} has not redline {redline.number} as it was agreed"


def named_in_words(redlines: Sequence[Redline], clauses: Sequence[Clause]) -> str:
    """Return the number of proposed changes, and their clauses: "2 proposed changes: Rounds, Credit"."""
    titles = {clause.key: clause.title for clause in clauses}
    names = [titles.get(redline.clause_key) or redline.wording.title for redline in redlines]
    return f"{counted(len(names), 'proposed change')}: {', '.join(names)}"
