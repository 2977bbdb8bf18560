"""What a request for a sound leaves open: the facts that someone needs to make it, and cannot find in its words.

A request names a kind of sound (a splash, a step, an ambience), and each kind needs a few facts. A fact is there when a
word of its own says it, or when a thing is named that implies it: a coin is small and of metal, an object is not. What
no word decides is not asked, since a needless question costs the reader more than a missing one. The words are in
`clarity.toml`.
"""

import re
import tomllib
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from enum import StrEnum
from functools import cache, lru_cache
from importlib.resources import files
from itertools import pairwise

MAX_QUESTIONS = 3
SHORTEST_THING = 4  # letters of a word that is not known; shorter ones abbreviate
ENOUGH_WORDS = 5  # that say something of their own: such a request is asked only for what its kind cannot do without
MAX_CHARS = 4_000  # of one request; what follows is not read
CACHED = 20_000


class Fact(StrEnum):
    """What a designer may have to know."""

    SOURCE = "source"
    MATERIAL = "material"
    SIZE = "size"
    SURFACE = "surface"
    PLACE = "place"
    DISTANCE = "distance"
    INTENSITY = "intensity"
    MOOD = "mood"
    LOOP = "loop"
    LENGTH = "length"


@dataclass(frozen=True)
class Question:
    """A fact that is missing, the question for it, and answers to choose from."""

    fact: Fact
    question: str
    answers: tuple[str, ...]
    only_if: str = ""  # "vague": a named thing makes it needless; "named": nothing to ask it of before one is named


@dataclass(frozen=True)
class Kind:
    """A kind of sound: the words that speak of it, and what is needed to make one."""

    words: frozenset[str]
    needs: tuple[Question, ...]
    categories: frozenset[str]
    by_people: bool  # a person is its source
    loops: bool  # as a rule, whatever its length


@dataclass(frozen=True)
class Lexicon:
    """The words of `clarity.toml`."""

    facts: dict[Fact, frozenset[str]]
    kinds: tuple[Kind, ...]
    any_fact: frozenset[str]
    pairs: frozenset[str]  # of two words, joined by "-"
    vague: frozenset[str]
    verbs: frozenset[str]
    things: frozenset[str]
    people: frozenset[str]
    named: frozenset[str]
    unsaid: frozenset[str]
    any_material: frozenset[str]
    any_size: frozenset[str]


@cache
def lexicon() -> Lexicon:
    """Return the lexicon, which is read once."""
    read = tomllib.loads((files("app.sound_lists") / "clarity.toml").read_text(encoding="utf-8"))
    facts = {Fact(name): frozenset(text.split()) for name, text in read["facts"].items()}
    kinds = tuple(
        Kind(
            frozenset(kind["words"].split()),
            tuple(
                Question(Fact(need["fact"]), need["question"], tuple(need["answers"]), need.get("only_if", ""))
                for need in kind["needs"]
            ),
            frozenset(kind.get("categories", "").split()),
            kind.get("by_people", False),
            kind.get("loops", False),
        )
        for kind in read["kinds"]
    )
    return Lexicon(
        facts,
        kinds,
        any_fact=frozenset().union(*facts.values()),
        pairs=frozenset(word for kind in kinds for word in kind.words if "-" in word),
        **{name: frozenset(text.split()) for name, text in read["words"].items()},
    )


NAMELESS = (Question(Fact.SOURCE, "Of what?", ("a tool", "a stone", "a person")),)  # of neither a kind nor a thing
BY_KIND = {Fact.SIZE, Fact.MOOD, Fact.MATERIAL, Fact.DISTANCE}  # a word of the kind says none of these
STATED = re.compile(rf"\b({'|'.join(Fact)}): ", re.IGNORECASE)
WORD = re.compile(r"[^\W\d_]+(?:-[^\W\d_]+)*|\d+")
CAMEL = re.compile(r"(?<=[a-z])(?=[A-Z])")
ENDINGS = (
    ("s", ""),
    ("es", ""),
    ("ies", "y"),
    ("ing", ""),
    ("ing", "e"),
    ("ed", ""),
    ("ed", "e"),
    ("ly", ""),
    ("ily", "y"),
)


@lru_cache(CACHED)
def questions(name: str, category: str, description: str, loop: bool, has_length: bool) -> tuple[Question, ...]:
    """Return what a request leaves open, the most needed first: none where a designer can begin."""
    words = lexicon()
    named, said = _tokens(name), _tokens(description)
    kind = _kind_of(named, said, category)
    said_all = [*named, *said]
    is_unsaid = any(one & words.unsaid for one in said)
    things = [one for one in said if _is_thing(one, kind)]
    if not is_unsaid:
        things += [one for one in named if (one & words.things or not said) and _is_thing(one, kind)]
    found = {Fact(match[1].lower()) for match in STATED.finditer(description)}
    found |= {fact for fact, of_fact in words.facts.items() if _speaks_of(fact, of_fact, said_all, kind)}
    if things:
        found.add(Fact.SOURCE)
    if any(not one & words.any_size for one in things):
        found.add(Fact.SIZE)
    if any(not one & words.any_material for one in things):
        found.add(Fact.MATERIAL)
    if loop:
        found |= {Fact.LOOP, Fact.LENGTH}
    if has_length:
        found.add(Fact.LENGTH)
        if kind and not kind.loops:
            found.add(Fact.LOOP)
    if kind and kind.loops and things:  # a thing says which place it is, and several what it is like there
        found |= {Fact.PLACE, Fact.MOOD} if len(things) > 1 else {Fact.PLACE}
    if len({min(one) for one in said_all if _is_informative(one, kind)}) >= ENOUGH_WORDS:
        return ()
    needs = kind.needs if kind else () if things or found else NAMELESS
    needless = "vague" if things else "named"
    return tuple(one for one in needs if one.fact not in found and one.only_if != needless)[:MAX_QUESTIONS]


def _kind_of(named: Collection[frozenset[str]], said: Collection[frozenset[str]], category: str) -> Kind | None:
    kinds = lexicon().kinds
    for tokens in (named, said):
        for kind in kinds:
            if any(one & kind.words for one in tokens):
                return kind
    return next((kind for kind in kinds if category.lower() in kind.categories), None)


def _is_thing(token: frozenset[str], kind: Kind | None) -> bool:
    """Whether a word names something of its own: no word of a fact, of the kind, or of nothing in particular."""
    words = lexicon()
    if token & words.people:
        return bool(kind and kind.by_people)
    if token & (words.named | words.things):
        return True
    if max(map(len, token)) < SHORTEST_THING:
        return False
    if token & (words.vague | words.verbs) or (kind and token & kind.words and not token & words.any_size):
        return False
    return bool(token & words.any_size) or not (
        token & words.any_fact or any(one.endswith(("ing", "ed")) for one in token)
    )


def _is_informative(token: frozenset[str], kind: Kind | None) -> bool:
    """Whether a word says anything of the sound beyond its kind."""
    return _is_thing(token, kind) or bool(token & lexicon().any_fact and not (kind and token & kind.words))


def _speaks_of(fact: Fact, of_fact: frozenset[str], tokens: Collection[frozenset[str]], kind: Kind | None) -> bool:
    return any(one & of_fact and not (kind and fact in BY_KIND and one & kind.words) for one in tokens)


def _tokens(text: str) -> list[frozenset[str]]:
    """Return each word as the forms under which a list may have it."""
    found = list(_found_words(text))
    pairs = [frozenset({f"{one}-{other}"}) for one, other in pairwise(found)]
    return [*map(_forms, found), *(pair for pair in pairs if pair & lexicon().pairs)]


def _found_words(text: str) -> Iterator[str]:
    spaced = CAMEL.sub(" ", text[:MAX_CHARS]).replace("_", " ").replace("’", "'").lower()
    for match in WORD.finditer(spaced):
        word = match[0]
        if len(word) > 1 and not word.isdigit():
            yield word
            if "-" in word:
                yield from (part for part in word.split("-") if len(part) > 1)


@lru_cache(CACHED)
def _forms(word: str) -> frozenset[str]:
    forms = {word}
    for ending, instead in ENDINGS:
        if len(word) - len(ending) >= 3 and word.endswith(ending) and not word.endswith("ss"):
            forms.add(word.removesuffix(ending) + instead)
    for form in tuple(forms):
        if len(form) > 3 and form[-1] == form[-2]:
            forms.add(form[:-1])  # running, dropped
    return frozenset(forms)
