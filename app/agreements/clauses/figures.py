"""Figures that the software counts by: each is a field of the text, and no clause types another number beside it.

A text that says three rounds while two are counted misleads both parties. So a text whose figure is missing, or typed
as a number, is named here, and it can be neither sent nor signed. Stated without a database.
"""

import difflib
import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import Any

from app.agreements.clauses.rules import (
    FACTS,
    Clause,
    Terms,
    TermValue,
    filler,
    known_terms,
    library,
    names_in,
    validation_errors,
    variables_in,
    written_term,
)
from app.agreements.rules import ORDERS, ContractKind
from app.core.money import minor_digits

# Facts that the server counts: a clause of the library keeps them where it has them.
COUNTED_FACTS = (
    "total",
    "milestones",
    "joint_work",
    "deposit_sentence",
    "holdback_sentence",
    "release_sentence",
    "currency",
    "cues",
    "cue_count",
    "file_count",
    "list_revision",
    "spec_version",
)
_FACT_SAMPLES = dict.fromkeys(FACTS, "") | {
    "currency": "USD",
    "list_revision": "1",
    "spec_version": "1",
    "cue_count": "1",
    "file_count": "1",
    "total": "USD 1.00",
}
_FIELD_MARK = "\ufffc"  # stands for the field that is looked at

_SMALL = (
    *("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"),
    *("thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"),
)
_TENS = ("twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety")
_WORD_VALUES = {word: value for value, word in enumerate(_SMALL)}
_WORD_VALUES |= {word: 10 * value for value, word in enumerate(_TENS, start=2)}
_WORD_VALUES |= {"hundred": 100, "dozen": 12}
_WORD = rf"(?:{'|'.join(_WORD_VALUES)})"
_DIGITS = r"\d+(?:[.,'’]\d+)*"
_BARE_NUMBER = rf"(?:\b{_WORD}(?:[\s-]+(?:and\s+)?{_WORD})*\b|{_DIGITS})"
_NUMBER = rf"{_BARE_NUMBER}(?:\s*\(\s*{_BARE_NUMBER}\s*\))?"  # "three (3)"
_PARTS = r"\bhalf\b|\ba\s+(?:third|quarter)\s+of|\b(?:three\s+quarters|two\s+thirds)\b"
_PERCENT = rf"{_NUMBER}\s*(?:%|percent\b|per\s+cent\b|pct\b)|{_PARTS}"
_DAYS = r"(?:(?:working|business|calendar|full|further)[\s*]+)*(?:days?|weeks?|months?|fortnights?)\b"
_TIME = rf"(?:{_NUMBER}|\ban?)[\s*]+{_DAYS}"
_MARK = r"(?:(?-i:\b[A-Z]{3}\b)|[€$£¥])"
_MONEY = rf"(?:{_MARK}[\s*]*{_DIGITS}|{_NUMBER}[\s*]*(?:{_MARK}|(?:euros?|dollars?|pounds?|cents?)\b))"
_MONTH = (
    r"(?:Jan(?:uary)?|Feb(?:ruary)?|Mar(?:ch)?|Apr(?:il)?|May|June?|July?|Aug(?:ust)?|Sept?(?:ember)?|Oct(?:ober)?"
    r"|Nov(?:ember)?|Dec(?:ember)?)"
)
_DATE = (
    rf"(?:\b\d{{4}}-\d{{2}}-\d{{2}}\b|\b\d{{1,2}}(?:st|nd|rd|th|\.)?\s+(?:of\s+)?{_MONTH}\.?,?\s+\d{{4}}\b"
    rf"|\b{_MONTH}\.?\s+\d{{1,2}}(?:st|nd|rd|th)?,?\s+\d{{4}}\b|\b\d{{1,2}}[./]\d{{1,2}}[./]\d{{2,4}}\b)"
)
_MACROS = {"number": _NUMBER, "percent": _PERCENT, "time": _TIME, "money": _MONEY, "date": _DATE}
_MACRO = re.compile(r"<(number|percent|time|money|date)>")
_CODES = "AUD|BRL|CAD|CHF|CNY|CZK|DKK|EUR|GBP|HKD|HUF|INR|JPY|KRW|MXN|NOK|NZD|PLN|RON|SEK|SGD|TRY|UAH|USD|ZAR"
_TYPED_FACTS: Mapping[str, Sequence[str]] = {
    "total": (
        r"\bthe price(?: of the work)?(?: in all)? (?:is|of) <money>",
        r"\b(?:total|overall|whole)\b.*<money>",
        r"<money>.*\bin (?:all|total)\b",
    ),
    "deposit_sentence": (r"\bdeposit\b.*(?:<money>|<percent>)", r"(?:<money>|<percent>).*\bdeposit\b"),
    "holdback_sentence": (
        r"\b(?:held back|holds? ?back|retained|retention)\b.*(?:<money>|<percent>)",
        r"(?:<money>|<percent>).*\b(?:held back|holds? ?back|retained|retention)\b",
    ),
    "milestones": (
        r"\b(?:due|deliver\w*|milestones?|deadline|finished|completed?)\b.*<date>",
        r"<date>.*\b(?:due|deliver\w*|milestones?|deadline)\b",
    ),
    "currency": (rf"\bin (?-i:{_CODES})\b", r"\bin (?:euros|(?:us )?dollars|pounds)\b"),
}
_AMOUNT = re.compile(_MONEY, re.IGNORECASE)
_SENTENCE_END = re.compile(r"(?<=[.;!?])[\s*]+|\n\s*\n|\n\s*(?=[-|#]|\d+\.\s)")
_TELLING = re.compile(
    rf"\d|\b(?:{'|'.join(_WORD_VALUES)}|half|third|quarters?|unlimited|number of|as many|euros|dollars|pounds"
    rf"|an? (?:day|week|month|fortnight)|(?-i:{_CODES}))\b",
    re.IGNORECASE,
)
_MAX_QUOTED_CHARS = 80
_FIELD_OR_WORD = re.compile(r"(?<!\\)\{[^{}\n]*\}|\w+|[^\w\s]")

Fault = tuple[str, str]  # where, as `clauses.KEY` or `terms.NAME`, and what is wrong in words


def text_errors(
    clauses: Sequence[Clause], terms: Mapping[str, Any], kind: ContractKind, *, is_template: bool = False
) -> Iterator[Fault]:
    """Yield the faults of a text of a kind, its figures included; a template may lack parts that a contract needs."""
    yield from validation_errors(clauses, terms)
    yield from figure_errors(clauses, terms, kind, is_template=is_template)


def figure_errors(
    clauses: Sequence[Clause], terms: Mapping[str, Any], kind: ContractKind, *, is_template: bool = False
) -> Iterator[Fault]:
    """Yield the figures that a text lacks, and the numbers that it types where a figure belongs."""
    if len({clause.key for clause in clauses}) < len(clauses):
        return  # the fault is the key that two clauses have
    in_force = [clause for clause in clauses if clause.stands]
    named = names_in(in_force)
    missing = _fields_missing(in_force, named)
    for name, clause in missing.items():
        yield f"clauses.{clause.key}", _words_for_missing(name, clause, terms)
    yield from _typed_over_others(in_force, named, terms)
    if not is_template:
        yield from _values_missing(named | missing.keys(), terms, kind)
    for clause in in_force:
        for name, words in typed_figures(f"{clause.title}.\n\n{clause.text}", terms):
            if missing.get(name) is not clause:
                yield f"clauses.{clause.key}", _words_for_typed(name, words, terms)
        yield from ((f"clauses.{clause.key}", words) for words in _other_choices(clause, terms))


def plan_errors(
    clauses: Sequence[Clause],
    kind: ContractKind,
    *,
    has_amounts: bool,
    has_deposit: bool,
    has_holdback: bool,
    is_joint: bool = False,
) -> Iterator[Fault]:
    """Yield the gaps of an order's text on its plan: price, milestones, deposit, the amount held back."""
    if kind not in ORDERS:
        return
    in_force = [clause for clause in clauses if clause.stands]
    named = names_in(in_force) | _fields_missing(in_force, names_in(in_force)).keys()
    needed = {
        "total": has_amounts,
        "milestones": has_amounts,
        "release_sentence": has_amounts,
        "deposit_sentence": has_deposit,
        "holdback_sentence": has_holdback,
        "joint_work": is_joint,
    }
    for name, is_needed in needed.items():
        if is_needed and name not in named:
            yield "clauses", f"no clause in force says {{{name}}}, {FACTS[name]}; put it into one"
    for clause in in_force:
        if not is_joint and "joint_work" in variables_in(clause.text):
            yield f"clauses.{clause.key}", "this contract has one designer; remove the clause on joint work"


def typed_figures(text: str, terms: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Yield the figures that a text types as a number, with the words that do: ("rounds_included", "3 rounds")."""
    filled = _filled(text, terms)
    telling = _telling_sentences(filled)
    fields = names_in([Clause("text", "", text)])
    for name, patterns in _patterns().items():
        if name in fields:  # the field itself is no number that was typed
            marked = _filled(text, terms, marked=name)
            words = _first_hit(patterns, marked, _telling_sentences(marked))
        else:
            words = _first_hit(patterns, filled, telling)
        if words:
            yield name, _quoted(words)


def _first_hit(patterns: Sequence[re.Pattern[str]], text: str, sentences: Sequence[tuple[int, int]]) -> str:
    for begins, ends in sentences:
        for pattern in patterns:
            if hit := pattern.search(text[begins:ends]):
                return hit[0]
    return ""


def _telling_sentences(text: str) -> list[tuple[int, int]]:
    """Return the sentences that may type a figure: those with a number, a currency, or a word that stands for one."""
    return [(begins, ends) for begins, ends in _sentences(text) if _TELLING.search(text, begins, ends)]


def prose_errors(text: str, terms: Mapping[str, Any]) -> Iterator[str]:
    """Yield the terms that the words of a change order type as numbers, which change nothing by themselves."""
    for name, words in typed_figures(text, terms):
        if name not in FACTS:
            yield (
                f"“{words}” is typed, and no change of this order sets it: the contract counts "
                f"{written_term(name, terms[name], '').strip() if name in terms else 'nothing'} for "
                f"“{known_terms()[name].label}”; leave the number out"
            )


def other_amounts(text: str, amount_minor: int, currency: str) -> list[str]:
    """Return the amounts that a text types and that are not the one given."""
    amounts = [match[0] for match in _AMOUNT.finditer(text)]
    return [words for words in amounts if _minor(words, currency) != amount_minor]


def with_fields(text: str, before: str, terms: Mapping[str, Any], currency: str) -> tuple[str, Terms]:
    """Return a text that was edited with the fields that were typed over put back, and the values that were typed.

    `before` is the text as it was. A number that replaces a field is the new value of its term; what is no value of it,
    or replaces more than one field, stays as it was typed.
    """
    changed: Terms = {}
    for name in variables_in(before):
        if name in FACTS or name not in terms or name in variables_in(text):
            continue
        typed = _typed_over(name, text, before, currency) or _typed_as_usual(name, text, terms, currency)
        if typed is not None:
            begins, ends, value = typed
            text = f"{text[:begins]}{{{name}}}{text[ends:]}"
            changed[name] = value
    return text, changed


def number_in(words: str) -> int | None:
    """Return the whole number that words name: 3, three, twenty-five, three (3); None where they name none."""
    bare = re.sub(r"\s*\(.*\)$", "", words.strip().lower())
    if re.fullmatch(r"\d{1,3}(?:[,'’]\d{3})*|\d+", bare):
        return int(re.sub(r"\D", "", bare))
    parts = [part for part in re.split(r"[\s-]+", bare) if part != "and"]
    if not parts or any(part not in _WORD_VALUES for part in parts):
        return None
    total = 0
    for part in parts:
        value = _WORD_VALUES[part]
        total = (total or 1) * value if part in ("hundred", "dozen") else total + value
    return total


def _fields_missing(in_force: Sequence[Clause], named: set[str]) -> dict[str, Clause]:
    """Return the counted fields that a clause of the library has lost and that no clause in force names."""
    lost: dict[str, Clause] = {}
    own_fields = _own_fields()
    for clause in in_force:
        for name in own_fields.get(clause.key, ()):
            if name not in named:
                lost[name] = clause
    return lost


@cache
def _own_fields() -> Mapping[str, Sequence[str]]:
    """Return by key the counted fields in the text of each clause of the library."""
    counted = {name for name, term in known_terms().items() if term.counted} | set(COUNTED_FACTS)
    return {each.clause.key: [name for name in variables_in(each.clause.text) if name in counted] for each in library()}


def _values_missing(named: set[str], terms: Mapping[str, Any], kind: ContractKind) -> Iterator[Fault]:
    for each in library():
        for term in each.terms if kind in each.kinds else ():
            if term.needed and term.name not in terms:
                yield f"terms.{term.name}", f"no value, and the software counts by it; wanted as in {term.default}"
            elif term.needed and term.name not in named:
                value = written_term(term.name, terms[term.name], "")
                yield (
                    f"terms.{term.name}",
                    f"{value}, and no clause in force says so; let one say {{{term.name}}}, "
                    f"as “{each.clause.title}” does",
                )


def _typed_over_others(in_force: Sequence[Clause], named: set[str], terms: Mapping[str, Any]) -> Iterator[Fault]:
    """Yield the numbers that stand exactly where a clause of the library has a value that the parties keep."""
    texts = {each.clause.key: each.clause.text for each in library()}
    for clause in in_force:
        for name in variables_in(texts.get(clause.key, "")):
            term = known_terms().get(name)
            if term is None or term.counted or not isinstance(term.default, int) or name in named or name not in terms:
                continue
            if over := _typed_over(name, clause.text, texts[clause.key], "USD"):
                words = _quoted(clause.text[over[0] : over[1]])
                value = written_term(name, terms[name], "").strip()
                yield (
                    f"clauses.{clause.key}",
                    f"“{words}” is typed, and {{{name}}} is {value}; write {{{name}}} there, and change its value",
                )


def _words_for_missing(name: str, clause: Clause, terms: Mapping[str, Any]) -> str:
    typed = next((words for figure, words in typed_figures(clause.text, terms) if figure == name), "")
    if typed:
        return _words_for_typed(name, typed, terms)
    what = FACTS.get(name) or known_terms()[name].label
    return (
        f"“{clause.title}” does not say {{{name}}} ({what}){_counted_now(name, terms)}; "
        f"put {{{name}}} back, and change its value instead of the text"
    )


def _words_for_typed(name: str, words: str, terms: Mapping[str, Any]) -> str:
    if name in FACTS:
        return f"“{words}” is typed; {FACTS[name]} comes from the plan. Write {{{name}}} there"
    return f"“{words}” is typed{_counted_now(name, terms)}; write {{{name}}} there, and change its value"


def _counted_now(name: str, terms: Mapping[str, Any]) -> str:
    if name not in terms or known_terms()[name].choices:
        return ""
    return f", and the software counts by {{{name}}}, which is {written_term(name, terms[name], '').strip() or 'empty'}"


def _other_choices(clause: Clause, terms: Mapping[str, Any]) -> Iterator[str]:
    """Yield the choices that a clause states although the terms hold another."""
    read = _plain(clause.text)
    for name, term in known_terms().items():
        for choice in term.choices if term.counted else ():
            if choice.value != terms.get(name, term.default) and _plain(choice.words) in read:
                yield f"“{_quoted(choice.words)}” is typed, and {{{name}}} is another choice; write {{{name}}} there"


def _plain(text: str) -> str:
    return " ".join(text.replace("*", "").split())


@cache
def _patterns() -> Mapping[str, Sequence[re.Pattern[str]]]:
    """Return the patterns of each figure typed as a number: those of the library, and those of the plan's facts."""
    sources = {**{name: term.typed for name, term in known_terms().items() if term.typed}, **_TYPED_FACTS}
    return {name: [_compiled(pattern) for pattern in patterns] for name, patterns in sources.items()}


def _compiled(pattern: str) -> re.Pattern[str]:
    spaced = pattern.replace(" ?", r"[\s*]*").replace(" ", r"[\s*]+")
    return re.compile(_MACRO.sub(lambda macro: f"({_MACROS[macro[1]]})", spaced), re.IGNORECASE | re.DOTALL)


def _filled(text: str, terms: Mapping[str, Any], marked: str = "") -> str:
    """Return a text with its values filled in; the fields of one figure are marked instead."""
    used = names_in([Clause("text", "", text)]) - {marked}
    values = {name: term.default for name, term in known_terms().items() if name in used}
    values |= {name: value for name, value in terms.items() if name in used}
    return filler(values, _FACT_SAMPLES | ({marked: _FIELD_MARK} if marked else {}), "USD")(text)


def _sentences(text: str) -> Iterator[tuple[int, int]]:
    begins = 0
    for match in _SENTENCE_END.finditer(text):
        yield begins, match.start()
        begins = match.end()
    yield begins, len(text)


def _quoted(words: str) -> str:
    plain = " ".join(words.replace(_FIELD_MARK, "…").replace("*", "").split())
    return plain if len(plain) <= _MAX_QUOTED_CHARS else plain[: _MAX_QUOTED_CHARS - 1] + "…"


def _typed_over(name: str, text: str, before: str, currency: str) -> tuple[int, int, TermValue] | None:
    """Return the place and the value of what stands exactly where a field stood."""
    old, new = list(_FIELD_OR_WORD.finditer(before)), list(_FIELD_OR_WORD.finditer(text))
    matcher = difflib.SequenceMatcher(None, [each[0] for each in old], [each[0] for each in new], autojunk=False)
    for change, a, b, c, d in matcher.get_opcodes():
        if change == "replace" and b - a == 1 and old[a][0] == f"{{{name}}}":
            typed = new[c:d]
            while len(typed) > 2 and typed[0][0] == typed[-1][0] == "*":  # it was made bold or italic
                typed = typed[1:-1]
            begins, ends = typed[0].start(), typed[-1].end()
            value = _value_of(name, text[begins:ends], currency)
            return None if value is None else (begins, ends, value)
    return None


def _typed_as_usual(name: str, text: str, terms: Mapping[str, Any], currency: str) -> tuple[int, int, TermValue] | None:
    """Return the place and the value of the one number in a text that says a figure as texts usually do."""
    hits: set[tuple[int, int]] = set()
    for begins, ends in _sentences(text):
        for pattern in _patterns().get(name, ()):
            if match := pattern.search(text[begins:ends]):
                group = max((each for each in range(1, pattern.groups + 1) if match[each]), default=0)
                if group:
                    hits.add((begins + match.start(group), begins + match.end(group)))
    if len(hits) != 1:
        return None
    ((begins, ends),) = hits
    words = text[begins:ends]
    if unit := re.search(r"[\s*]+(?:(?:working|business|calendar)\s+)*days?$", words):
        words, ends = words[: unit.start()], begins + unit.start()
    value = _value_of(name, words, currency)
    return None if value is None or name not in terms else (begins, ends, value)


def _value_of(name: str, words: str, currency: str) -> TermValue | None:
    """Return the value of a term that is typed as these words; None where they are none."""
    term = known_terms().get(name)
    if term is not None and term.choices:
        return next((choice.value for choice in term.choices if _plain(choice.words) == _plain(words)), None)
    if term is not None and isinstance(term.default, str):
        return words if words and not re.search(r"[{}\n]", words) else None
    if name.endswith("_bp"):
        return _basis_points(words)
    if name.endswith("_minor"):
        return _minor(words, currency)
    return number_in(words)


def _basis_points(words: str) -> int | None:
    bare = re.sub(r"\s*(?:%|percent|per\s+cent|pct)$", "", words.strip(), flags=re.IGNORECASE)
    if bare == words.strip():
        return None
    if match := re.fullmatch(r"(\d+)(?:[.,](\d{1,2}))?", bare):
        return int(match[1]) * 100 + int((match[2] or "0").ljust(2, "0"))
    whole = number_in(bare)
    return None if whole is None else whole * 100


def _minor(words: str, currency: str) -> int | None:
    match = re.fullmatch(r"(?:([A-Z]{3})\s*)?(\d{1,3}(?:,\d{3})*|\d+)(?:\.(\d+))?(?:\s*([A-Z]{3}))?", words.strip())
    if not match or (match[1] or match[4] or currency) != currency:
        return None
    digits, cents = minor_digits(currency), match[3] or ""
    if len(cents) > digits:
        return None
    return int(match[2].replace(",", "") + cents.ljust(digits, "0"))
