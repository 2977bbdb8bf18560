"""Clauses and what they leave open, without a database; the library is one clause a file, found by being there."""

import difflib
import re
import tomllib
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import date
from functools import cache
from pathlib import Path
from typing import Any, TypedDict

from app.agreements.clauses.text import Marker, literal, unmarked
from app.agreements.rules import ContractKind
from app.core.money import money, percent
from app.core.plural import counted

LIBRARY = Path(__file__).parent / "library"
VARIABLE = re.compile(r"(?<!\\)\{([^{}\n]*)\}")
DAY = re.compile(r"2\d{3}-\d{2}-\d{2}")
KEY = re.compile(r"[a-z][a-z0-9_]{0,60}")
MAX_CLAUSES = 80
MAX_TEXT_CHARS = 20_000
MAX_TITLE_CHARS = 120
MAX_TERM_CHARS = 500
MISTYPED = 0.9  # a name this like one of the library is taken for it
LARGEST = 2**53  # beyond it JavaScript rounds whole numbers

BY_DAY = "day_rate"  # a value of the term price_mode

TermValue = int | str
Terms = dict[str, TermValue]


class ClauseRow(TypedDict):
    """A clause as versions and templates keep it."""

    key: str
    title: str
    text: str
    stands: bool


# What the server fills in from project, list and milestones.
FACTS: Mapping[str, str] = {
    "studio": "name of the studio",
    "designer": "name of the designer",
    "project": "name of the project",
    "approver": "who approves sounds",
    "currency": "currency of the contract",
    "list_revision": "number of the sound list's newest revision",
    "spec_version": "number of the delivery spec's newest version",
    "cue_count": "how many cues the contract covers",
    "file_count": "how many files these cues have, with their variations",
    "cues": "a table of the cues",
    "brief_answers": "what the brief answers on platforms, playback, the game's own effects and references",
    "open_questions": "a list of the questions on cues that are not answered",
    "milestones": "a table of the milestones with dates and amounts",
    "total": "the price of all milestones and the deposit",
    "joint_work": "a table of the two designers of joint work: what each makes, the price and the share",
    "deposit_sentence": "what is paid at signing",
    "holdback_sentence": "what is held back until the end",
    "release_sentence": "when an accepted cue's share is due",
    "framework_title": "title of the framework agreement",
    "framework_agreed_on": "day on which the framework was agreed",
}


@dataclass(frozen=True)
class Clause:
    """One clause of a contract: its text has variables in braces."""

    key: str
    title: str
    text: str
    stands: bool = True

    def as_row(self) -> ClauseRow:
        """Return the clause as versions and templates keep it."""
        return {"key": self.key, "title": self.title, "text": self.text, "stands": self.stands}

    @classmethod
    def of(cls, row: Mapping[str, Any]) -> "Clause":
        """Return a clause from how it is kept."""
        return cls(row["key"], row["title"], row["text"], row["stands"])


@dataclass(frozen=True)
class Choice:
    """One of the values that a term may have: what a form calls it, and what the text says then."""

    value: TermValue
    label: str
    words: str


@dataclass(frozen=True)
class Term:
    """Something that a clause leaves open: `_bp` ends a part of the whole, `_minor` an amount of money."""

    name: str
    default: TermValue
    label: str
    min: int | None = None
    max: int | None = None
    choices: Sequence[Choice] = field(default_factory=tuple)
    struck: TermValue | None = None  # what holds where no clause in force names it; None: what was written
    said: bool = False  # the software goes by it, so it is the default or some clause in force says otherwise
    counted: bool = False  # the software goes by it, so a text says it as a field and as nothing else
    needed: bool = False  # nothing else holds where no clause names it, so a text of its kinds has it
    typed: Sequence[str] = field(default_factory=tuple)  # how a text says it as a number; `figures` reads them


@dataclass(frozen=True)
class LibraryClause:
    """A clause of the library: for which kinds it is meant, why, and what it leaves open."""

    clause: Clause
    order: int
    kinds: frozenset[ContractKind]
    why: str
    music: bool = False
    instead_of: str | None = None
    terms: Sequence[Term] = field(default_factory=tuple)


@cache
def library() -> tuple[LibraryClause, ...]:
    """Return every clause of the library, in the order of contracts."""
    return tuple(sorted((_read(path) for path in LIBRARY.glob("*.md")), key=lambda each: each.order))


def _read(path: Path) -> LibraryClause:
    _, head, text = path.read_text(encoding="utf-8").split("+++\n", 2)
    head_facts = tomllib.loads(head)
    music = head_facts.get("music", False)
    return LibraryClause(
        clause=Clause(path.stem, head_facts["title"], text.strip(), head_facts.get("stands", True)),
        order=head_facts["order"],
        kinds=frozenset(ContractKind(kind) for kind in head_facts["kinds"]),
        why=head_facts["why"],
        music=music,
        instead_of=head_facts.get("instead_of"),
        terms=tuple(_term(name, facts) for name, facts in head_facts.get("terms", {}).items()),
    )


def _term(name: str, facts: dict[str, Any]) -> Term:
    choices = tuple(Choice(**choice) for choice in facts.pop("choices", ()))
    return Term(name, **facts, choices=choices)


@cache
def known_terms() -> Mapping[str, Term]:
    """Return the terms that the library's clauses leave open, by name."""
    return {term.name: term for each in library() for term in each.terms}


def default_clauses(kind: ContractKind, *, with_music: bool = False) -> tuple[list[Clause], Terms]:
    """Return the clauses of a kind as the library has them; those on music stand only when asked for."""
    chosen = [each for each in library() if kind in each.kinds]
    clauses = [
        Clause(each.clause.key, each.clause.title, each.clause.text, with_music if each.music else each.clause.stands)
        for each in chosen
    ]
    return clauses, {term.name: term.default for each in chosen for term in each.terms}


def terms_in_force(clauses: Sequence[Clause], terms: Mapping[str, Any]) -> Terms:
    """Return the terms in effect: one that only a struck clause names holds as if nothing had been agreed on it."""
    named = names_in([clause for clause in clauses if clause.stands])
    struck = {name: term.struck for name, term in known_terms().items() if term.struck is not None}
    return {name: value if name in named else struck.get(name, value) for name, value in terms.items()}


def names_in(clauses: Sequence[Clause]) -> set[str]:
    """Return the variables of some clauses, those in the words of their choices included."""
    named = {name for clause in clauses for name in variables_in(clause.text)}
    chosen = [choice for name in named & known_terms().keys() for choice in known_terms()[name].choices]
    return named | {name for choice in chosen for name in variables_in(choice.words)}


def variables_in(text: str) -> list[str]:
    """Return the variables that a text uses, each once, in order."""
    return list(dict.fromkeys(VARIABLE.findall(text)))


def validation_errors(clauses: Sequence[Clause], terms: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Yield the faults of a draft: the place, as `clauses.KEY` or `terms.NAME`, and the fault in words."""
    if not any(clause.stands for clause in clauses):
        yield "clauses", "no clause is included; a contract needs at least one"
    if len(clauses) > MAX_CLAUSES:
        yield "clauses", f"{len(clauses)} clauses; at most {MAX_CLAUSES} are kept"
    seen: set[str] = set()
    for clause in clauses:
        where = f"clauses.{clause.key}"
        if clause.key in seen:
            yield where, f"the key {clause.key} stands twice"
        seen.add(clause.key)
        yield from ((where, fault) for fault in clause_errors(clause, terms))
    access = {clause.key for clause in clauses if clause.stands}
    for each in library():
        if each.instead_of and {each.clause.key, each.instead_of} <= access:
            yield (
                f"clauses.{each.clause.key}",
                f"this replaces the clause {each.instead_of}; remove one of them",
            )
    named, written = names_in(clauses), names_in([clause for clause in clauses if clause.stands])
    for name, value in terms.items():
        where = f"terms.{name}"
        yield from ((where, fault) for fault in term_errors(name, value))
        term = known_terms().get(name)
        if value == "" and name in written:
            yield where, f"{{{name}}} is empty; fill it in, or remove its clause"
        elif term and term.said and value != term.default and name not in written:
            yield where, f"{_shown(name, value)}, and no clause in force says so; let one say {{{name}}}"
        elif not term and name not in named and (near := difflib.get_close_matches(name, known_terms(), 1, MISTYPED)):
            yield where, f"no clause names {{{name}}}; is it {{{near[0]}}}?"
    days, reminder_days = terms.get("silence_days"), terms.get("silence_reminder_days")
    if "silence_days" in written and isinstance(days, int) and isinstance(reminder_days, int) and reminder_days >= days:
        yield (
            "terms.silence_reminder_days",
            f"{reminder_days}; wanted less than the {counted(days, 'day')} that silence may last",
        )
    if terms.get("price_mode") == BY_DAY:
        for name in ("day_rate_minor", "days_cap"):
            if not terms.get(name):
                yield f"terms.{name}", "none; a price by the day wants a rate, and the most days that are paid"


def clause_errors(clause: Clause, terms: Mapping[str, Any]) -> Iterator[str]:
    """Yield the faults of one clause, in words."""
    if not KEY.fullmatch(clause.key):
        yield f'"{clause.key}" is not a key; wanted a small letter, then small letters, digits and _'
    if not clause.title.strip():
        yield "enter a title for the clause"
    if len(clause.title) > MAX_TITLE_CHARS:
        yield f"a title of {len(clause.title)} characters; at most {MAX_TITLE_CHARS} are kept"
    if clause.stands and not clause.text.strip():
        yield "the clause is empty; write its text, or remove it"
    if len(clause.text) > MAX_TEXT_CHARS:
        yield f"{len(clause.text)} characters; at most {MAX_TEXT_CHARS} are kept"
    for name in variables_in(clause.text):
        if name not in FACTS and name not in terms:
            yield f"there is no variable {{{name}}}{_nearest(name, [*FACTS, *terms])}"


def _nearest(name: str, known_names: Collection[str]) -> str:
    near = difflib.get_close_matches(name, list(known_names), n=1)
    return f"; is it {{{near[0]}}}?" if near else "; write \\{ for a brace that is meant as one"


def term_errors(name: str, value: Any) -> Iterator[str]:
    """Yield the faults of a term's value, in words."""
    if not KEY.fullmatch(name) or name in FACTS:
        yield f'"{name}" is not a name for a term; wanted small letters, digits and _, and none of the server\'s own'
        return
    term = known_terms().get(name)
    is_number = isinstance(value, int) and not isinstance(value, bool)
    if term and term.choices:
        choices = [choice.value for choice in term.choices]
        if value not in choices:
            near = difflib.get_close_matches(str(value), [str(each) for each in choices], n=1)
            yield f"{value!r}; wanted {' or '.join(map(str, choices))}" + (f"; is it {near[0]}?" if near else "")
    elif not is_number and (name.endswith(("_bp", "_minor")) or (term and isinstance(term.default, int))):
        yield f"{value!r}; wanted a whole number"
    elif is_number and term and isinstance(term.default, str):
        yield f"{value}; wanted a text"
    elif is_number and term and term.min is not None and term.max is not None:
        if not term.min <= value <= term.max:
            yield f"{_shown(name, value)}; wanted {_shown(name, term.min)} to {_shown(name, term.max)}"
    elif is_number and not 0 <= value <= LARGEST:
        yield f"{value}; wanted 0 or more"
    elif isinstance(value, str) and len(value) > MAX_TERM_CHARS:
        yield f"{len(value)} characters; at most {MAX_TERM_CHARS} are kept"
    elif value and term and name.endswith("_on") and day_of_term(value) is None:
        yield f'"{value}" is not a day; wanted it as in 2027-12-31'


def day_of_term(value: Any) -> date | None:
    """Return the day that a term names as in 2027-12-31; None for any other value."""
    try:
        return date.fromisoformat(value) if isinstance(value, str) and DAY.fullmatch(value) else None
    except ValueError:
        return None


def _shown(name: str, value: TermValue) -> str:
    return percent(value) if name.endswith("_bp") and isinstance(value, int) else str(value)


def written_term(name: str, value: TermValue, currency: str) -> str:
    """Return a term as the text says it."""
    term = known_terms().get(name)
    for choice in term.choices if term else ():
        if choice.value == value:
            return choice.words
    if isinstance(value, str):
        return value
    if name.endswith("_minor"):
        return money(value, currency)
    return percent(value) if name.endswith("_bp") else f"{value:,}"


def filler(terms: Terms, facts: Mapping[str, str], currency: str, mark: Marker = unmarked) -> Callable[[str], str]:
    """Return a filler of a text's variables; a term may name a fact, so values are filled in once more."""
    filled = {**facts, **{name: written_term(name, value, currency) for name, value in terms.items()}}

    def fill(text: str, depth: int = 2) -> str:
        if not depth:
            return text
        return VARIABLE.sub(lambda match: _value(match[0], match[1], depth - 1), text)

    def _value(variable: str, name: str, depth: int) -> str:
        if name in facts or name not in filled:
            return filled.get(name, variable)
        return mark(name, fill(filled[name], depth))

    return fill


def render(title: str, clauses: Sequence[Clause], terms: Terms, facts: Mapping[str, str], currency: str) -> str:
    """Return the text of a contract in Markdown: the clauses that stand, numbered, with every variable filled in."""
    fill = filler(terms, facts, currency)
    parts = [f"# {literal(title)}"]
    for number, clause in numbered(clauses):
        parts += [f"## {number}. {literal(clause.title)}", fill(clause.text).strip()]
    return "\n\n".join(parts) + "\n"


def numbered(clauses: Sequence[Clause]) -> Iterator[tuple[int, Clause]]:
    """Yield the clauses that stand, with their numbers in the text."""
    yield from enumerate((clause for clause in clauses if clause.stands), start=1)
