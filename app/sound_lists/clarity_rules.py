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
TERSE_WORDS = 3  # of a description; so few name a thing only where the lexicon knows it
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
    CHARACTER = "character"
    WORDS = "words"
    DIRECTION = "direction"


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
    pairs: frozenset[str]  # of two words, joined by "-"
    words: dict[str, frozenset[str]]  # by what they are: vague, verbs, things, ...


@dataclass(frozen=True)
class Word:
    """What the lexicon knows of one word, looked up once."""

    forms: frozenset[str]
    facts: frozenset[Fact]  # that it says
    kinds: frozenset[int]  # that it speaks of, by their places
    lists: frozenset[str]  # of the lexicon that it stands in


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
        pairs=frozenset(word for kind in kinds for word in kind.words if "-" in word),
        words={name: frozenset(text.split()) for name, text in read["words"].items()},
    )


NAMELESS = (Question(Fact.SOURCE, "Of what?", ("a tool", "a stone", "a person")),)  # of neither a kind nor a thing
TERSE = (  # a few words, none of which speaks of a kind
    *NAMELESS,
    Question(Fact.SIZE, "How big?", ("small", "as big as a person", "huge"), "vague"),
    Question(Fact.INTENSITY, "How hard?", ("gently", "firmly", "with full force"), "vague"),
)
VOICE_CATEGORIES = frozenset({"dialogue", "narration", "vo", "voice", "voice-over", "voiceover", "voices", "vox"})
VOICE_WORDS = frozenset({"vo", "voice", "voiceover", "vox"})  # that say of a cue only that it is a line
VOICE_LINE = (  # what is spoken needs these, and no size and no place
    Question(Fact.CHARACTER, "Who speaks?", ("the player", "a guard", "a narrator")),
    Question(Fact.WORDS, "What is said?", ("one word", "one sentence", "it is with the script")),
    Question(Fact.DIRECTION, "How is it spoken?", ("calmly", "shouted", "whispered")),
)
SCRIPTED = re.compile(r"\bwith the (voice lines|script)\b", re.IGNORECASE)  # the words, and all else of the line
SPOKEN = re.compile(r"[\"“„«][^\"”“»]{2,}[\"”“»]")  # words in quotation marks
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
    named, said = _words(name), _words(description)
    if category.lower() in VOICE_CATEGORIES and not any(
        word.kinds and not word.forms & VOICE_WORDS for word in (*named, *said)
    ):
        return _open_in_voice_line(description, said)
    place = _place_of_kind(named, said, category)
    kind = None if place is None else lexicon().kinds[place]
    every = [*named, *said]
    is_terse = 0 < len(WORD.findall(description)) <= TERSE_WORDS
    things = [word for word in said if _is_thing(word, place) and not (is_terse and _is_unknown(word))]
    if not any("unsaid" in word.lists for word in said):
        things += [word for word in named if ("things" in word.lists or not said) and _is_thing(word, place)]
    found = {Fact(match[1].lower()) for match in STATED.finditer(description)}
    for word in every:
        found |= word.facts - BY_KIND if place in word.kinds else word.facts
    if things:
        found.add(Fact.SOURCE)
    if any("any_size" not in word.lists for word in things):
        found.add(Fact.SIZE)
    if any("any_material" not in word.lists for word in things):
        found.add(Fact.MATERIAL)
    if loop:
        found |= {Fact.LOOP, Fact.LENGTH}
    if has_length:
        found.add(Fact.LENGTH)
        if kind and not kind.loops:
            found.add(Fact.LOOP)
    if kind and kind.loops and things:  # a thing says which place it is, and several what it is like there
        found |= {Fact.PLACE, Fact.MOOD} if len(things) > 1 else {Fact.PLACE}
    if len({word.forms for word in every if _is_informative(word, place)}) >= ENOUGH_WORDS:
        return ()
    needs = kind.needs if kind else TERSE if is_terse else () if things or found else NAMELESS
    needless = "vague" if things else "named"
    return tuple(one for one in needs if one.fact not in found and one.only_if != needless)[:MAX_QUESTIONS]


def categories_spoken_of(text: str) -> frozenset[str]:
    """Return the categories of the kind of sound that a text speaks of; none where it speaks of no kind."""
    place = _place_of_kind(_words(text), (), "")
    return frozenset() if place is None else lexicon().kinds[place].categories


@lru_cache(CACHED)
def words_in(text: str) -> frozenset[str]:
    """Return the words of a text in lower case, without numbers."""
    return frozenset(_found_words(text))


def _open_in_voice_line(description: str, said: Collection[Word]) -> tuple[Question, ...]:
    """Return what the request for a spoken line leaves open; the script says all of a line that stands in it."""
    if SCRIPTED.search(description):
        return ()
    found = {Fact(match[1].lower()) for match in STATED.finditer(description)}
    if SPOKEN.search(description):
        found.add(Fact.WORDS)
    if any("people" in word.lists or Fact.SOURCE in word.facts for word in said):
        found.add(Fact.CHARACTER)
    if any(word.facts & {Fact.MOOD, Fact.INTENSITY} for word in said):
        found.add(Fact.DIRECTION)
    return tuple(one for one in VOICE_LINE if one.fact not in found)


def _place_of_kind(named: Collection[Word], said: Collection[Word], category: str) -> int | None:
    """Return the place of the first kind that the name speaks of, else the description, else the category."""
    for words in (named, said):
        if places := frozenset[int]().union(*(word.kinds for word in words)):
            return min(places)
    category = category.lower()
    return next((place for place, kind in enumerate(lexicon().kinds) if category in kind.categories), None)


def _is_thing(word: Word, place: int | None) -> bool:
    """Whether a word names something of its own: no word of a fact, of the kind, or of nothing in particular."""
    if "people" in word.lists:
        return place is not None and lexicon().kinds[place].by_people
    if word.lists & {"named", "things"}:
        return True
    if word.lists & {"vague", "verbs"} or max(map(len, word.forms)) < SHORTEST_THING:
        return False
    if "any_size" in word.lists:
        return True
    return not (place in word.kinds or word.facts or any(form.endswith(("ing", "ed")) for form in word.forms))


def _is_unknown(word: Word) -> bool:
    """Whether the lexicon knows nothing of a word, so that it may be what happens as well as a thing."""
    return not (word.lists or word.facts or word.kinds)


def _is_informative(word: Word, place: int | None) -> bool:
    """Whether a word says anything of the sound beyond its kind."""
    return _is_thing(word, place) or bool(word.facts and place not in word.kinds)


def _words(text: str) -> list[Word]:
    found = list(_found_words(text))
    pairs = (f"{one}-{other}" for one, other in pairwise(found))
    return [*map(_word, found), *(_word(pair) for pair in pairs if pair in lexicon().pairs)]


def _found_words(text: str) -> Iterator[str]:
    spaced = CAMEL.sub(" ", text[:MAX_CHARS]).replace("_", " ").replace("’", "'").lower()
    for match in WORD.finditer(spaced):
        word = match[0]
        if len(word) > 1 and not word.isdigit():
            yield word
            if "-" in word:
                yield from (part for part in word.split("-") if len(part) > 1)


@lru_cache(CACHED)
def _word(text: str) -> Word:
    """Return what the lexicon knows of a word, under any form that it may have there."""
    known, forms = lexicon(), _forms(text)
    return Word(
        forms,
        frozenset(fact for fact, words in known.facts.items() if forms & words),
        frozenset(place for place, kind in enumerate(known.kinds) if forms & kind.words),
        frozenset(name for name, words in known.words.items() if forms & words),
    )


def _forms(word: str) -> frozenset[str]:
    forms = {word}
    for ending, instead in ENDINGS:
        if len(word) - len(ending) >= 3 and word.endswith(ending) and not word.endswith("ss"):
            forms.add(word.removesuffix(ending) + instead)
    for form in tuple(forms):
        if len(form) > 3 and form[-1] == form[-2]:
            forms.add(form[:-1])  # running, dropped
    return frozenset(forms)
