"""Open points of a request for a sound: the facts that someone needs to make it, and cannot find in its words.

A request names a kind of sound (a splash, a step, an ambience), and each kind needs a few facts. A fact is there when a
word of its own says it, or when a thing is named that implies it: a coin is small and of metal, an object is not. What
no word decides is not asked, since a needless question costs the reader more than a missing one. The words are in
`clarity.toml`; `clarity_words.toml` has more, by what they are, from WordNet.
"""

import re
import tomllib
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass
from enum import StrEnum
from functools import cache, lru_cache
from importlib.resources import files
from itertools import pairwise
from typing import Any

MAX_QUESTIONS = 3
EVEN_IF_NAMED = "even if named"  # a thing does not say it
SHORTEST_THING = 4  # letters of a word that is not known; shorter ones abbreviate
ENOUGH_WORDS = 5  # that say something of their own: such a request is asked only for what its kind cannot do without
TERSE_WORDS = 3  # of a description; so few name a thing only where the lexicon knows it
LONG_WORDS = 7  # of a description; so many leave nothing open, unless they speak of "something"
SHORTEST_MISSPELT = 6  # letters of a word that is looked up in spite of a slip
MAX_CHARS = 4_000  # of one request; what follows is not read
CACHED = 20_000


class Fact(StrEnum):
    """A fact that a designer may need."""

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
    CATEGORY = "category"  # written into the cue's category, not into its description


@dataclass(frozen=True)
class Question:
    """A fact that is missing, the question for it, and answers to choose from."""

    fact: Fact
    question: str
    answers: tuple[str, ...]
    condition: str = ""  # "if vague": no thing is named; "if named": one is; "if open": no length is given; or this:


@dataclass(frozen=True)
class Kind:
    """A kind of sound: the words that speak of it, and what is needed to make one."""

    words: frozenset[str]
    of: frozenset[str]  # words, or lists with "@", one of which must be there too; empty: none
    classes: frozenset[str]  # lists whose words speak of it where few words speak of no kind
    says_intensity: frozenset[str]  # words that say how strong this kind is, and no other
    needs: tuple[Question, ...]
    categories: frozenset[str]  # whose cues are of this kind where their words speak of none
    filed_under: frozenset[str]  # categories of what is of this kind
    by_people: bool  # a person is its source
    loops: bool  # as a rule, whatever its length


@dataclass(frozen=True)
class Lexicon:
    """The words of `clarity.toml` and `clarity_words.toml`."""

    facts: dict[Fact, frozenset[str]]
    kinds: tuple[Kind, ...]
    pairs: frozenset[str]  # of two words, joined by "-"
    words: dict[str, frozenset[str]]  # by what they are: vague, verbs, things, ...
    every: frozenset[str]  # word that it knows
    near: dict[str, frozenset[str]]  # words of kinds by what is left of them without one letter


@dataclass(frozen=True)
class Word:
    """The lexicon's knowledge of one word, looked up once."""

    forms: frozenset[str]
    facts: frozenset[Fact]  # that it says
    kinds: frozenset[int]  # that it speaks of, by their places
    lists: frozenset[str]  # of the lexicon that it stands in
    partners: frozenset[str]  # its forms and its lists, as `of` of a kind names them


@cache
def lexicon() -> Lexicon:
    """Return the lexicon, which is read once."""
    read, more = (tomllib.loads(_text_of(name)) for name in ("clarity.toml", "clarity_words.toml"))
    own = {name: frozenset(text.split()) for name, text in read["words"].items()}
    known = own["vague"] | own["verbs"]
    facts = {Fact(name): frozenset(text.split()) for name, text in read["facts"].items()}
    for name, text in more["facts"].items():
        facts[Fact(name)] |= frozenset(text.split()) - known
    kinds = tuple(_kind(kind, read["questions"]) for kind in read["kinds"])
    words = dict(own)
    for name, text in more["words"].items():
        words[name] = own.get(name, frozenset()) | frozenset(text.split()) - known
    return Lexicon(
        facts,
        kinds,
        pairs=frozenset(word for kind in kinds for word in kind.words if "-" in word),
        words=words,
        every=frozenset[str]().union(*facts.values(), *words.values(), *(kind.words for kind in kinds)),
        near=_near(word for kind in kinds for word in kind.words),
    )


def _near(words: Iterable[str]) -> dict[str, frozenset[str]]:
    words_by_key: dict[str, set[str]] = defaultdict(set)
    for word in words:
        if len(word) >= SHORTEST_MISSPELT:
            for key in deletion_variants(word):
                words_by_key[key].add(word)
    return {key: frozenset(near) for key, near in words_by_key.items()}


def deletion_variants(word: str) -> set[str]:
    """Return a word and what is left of it without any letter but the first: words that share one differ by a slip."""
    return {word, *(word[:index] + word[index + 1 :] for index in range(1, len(word)))}


def _text_of(file_name: str) -> str:
    return (files("app.sound_lists.clarity") / file_name).read_text(encoding="utf-8")


def _kind(read: dict[str, Any], asked: dict[str, dict[str, Any]]) -> Kind:
    needs = []
    for need in read["needs"]:
        key, _, condition = need.partition(" ")
        needs.append(Question(Fact(key.partition(".")[0]), asked[key]["ask"], tuple(asked[key]["answers"]), condition))
    lists = {
        name: frozenset(read.get(name, "").split())
        for name in ("words", "of", "classes", "says_intensity", "categories", "filed_under")
    }
    return Kind(**lists, needs=tuple(needs), by_people=read.get("by_people", False), loops=read.get("loops", False))


NAMELESS = (Question(Fact.SOURCE, "Of what?", ("a tool", "a stone", "a person")),)  # of neither a kind nor a thing
VOICE_CATEGORIES = frozenset({"dialogue", "narration", "vo", "voice", "voice-over", "voiceover", "voices", "vox"})
VOICE_WORDS = frozenset({"vo", "voice", "voiceover", "vox"})  # that say of a cue only that it is a line
VOICE_LINE = (  # what is spoken needs these, and no size and no place
    Question(Fact.CHARACTER, "Who speaks?", ("the player", "a guard", "a narrator")),
    Question(Fact.WORDS, "What is said?", ("one word", "one sentence", "it is with the script")),
    Question(Fact.DIRECTION, "How is it spoken?", ("calmly", "shouted", "whispered")),
)
SCRIPTED = re.compile(r"\bwith the (voice lines|script)\b", re.IGNORECASE)  # the words, and all else of the line
SPOKEN = re.compile(r"[\"“„«][^\"”“»]{2,}[\"”“»]")  # words in quotation marks
THINGS = {  # lists of WordNet's words that name something whose source, size and material are known
    *("projectiles", "weapons", "vehicles", "instruments", "machines", "tools", "garments", "furniture"),
    *("containers", "jewels", "game_gear", "beasts", "spirits", "plants", "food"),
}
BY_KIND = set(Fact) - {Fact.INTENSITY}  # a word of the kind says none of these
ANY_SIZE = {"machines", "containers", "plants"}  # lists of things whose size their name leaves open
MANNER = {Fact.INTENSITY, Fact.MOOD}  # a sentence about a named thing says enough of these
ANSWER = re.compile(rf"\b({'|'.join(Fact)}): [^.]*\.?", re.IGNORECASE)
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
    """Return the open questions of a request, the most needed first: none where a designer can begin."""
    named, described = _words(name), _words(description)
    if category.lower() in VOICE_CATEGORIES and not any(
        word.kinds and not word.forms & VOICE_WORDS for word in (*named, *described)
    ):
        return _open_in_voice_line(description, described)
    own = ANSWER.sub(" ", description)  # without what was answered
    length = len(own.split())
    is_unsaid = any("unsaid" in word.lists for word in described)
    if length >= LONG_WORDS and not is_unsaid:
        return ()
    is_terse = 0 < length <= TERSE_WORDS
    kind_index = _place_of_kind(named, _words(own), category, may_class=length <= TERSE_WORDS)
    kind = None if kind_index is None else lexicon().kinds[kind_index]
    things = [] if is_unsaid else list(_things(named, described, kind_index, is_terse))
    if len({word.forms for word in (*named, *described) if _is_informative(word, kind_index)}) >= ENOUGH_WORDS:
        return ()
    loops = kind is not None and kind.loops
    if things and has_length and not described and not loops:  # a name alone that its writer takes for known
        return ()
    facts = _said_facts((*named, *described), kind_index) | {
        Fact(match[1].lower()) for match in STATED.finditer(description)
    }
    if loop or has_length:
        facts.add(Fact.LENGTH)
    if loop or (has_length and kind and not loops):
        facts.add(Fact.LOOP)
    if loops and things:  # a thing says which place it is, and several what it is like there
        facts |= (
            {Fact.PLACE, Fact.MOOD} if len({word.forms for word in things if word in described}) > 1 else {Fact.PLACE}
        )
    implied = _implied_facts(things, in_sentence=length > TERSE_WORDS and not loops)
    needs = kind.needs if kind else NAMELESS if is_terse or not (implied or facts) else ()
    needless = {"if vague" if things else "if named", "if open" if has_length else None}
    return tuple(
        need
        for need in needs
        if need.fact not in facts
        and (need.fact not in implied or need.condition == EVEN_IF_NAMED)
        and need.condition not in needless
    )[:MAX_QUESTIONS]


def _things(
    named: Collection[Word], described: Collection[Word], kind_index: int | None, is_terse: bool
) -> Iterator[Word]:
    """Yield the words that name something; in a few words only those that the lexicon knows."""
    yield from (word for word in described if _is_thing(word, kind_index) and not (is_terse and _is_unknown(word)))
    yield from (word for word in named if ("things" in word.lists or not described) and _is_thing(word, kind_index))


def _said_facts(words: Collection[Word], kind_index: int | None) -> set[Fact]:
    """Return the facts that words say by themselves."""
    facts = set[Fact]().union(
        *(word.facts - BY_KIND if _is_of_kind(word, kind_index) else word.facts for word in words)
    )
    if kind_index is not None and any(word.forms & lexicon().kinds[kind_index].says_intensity for word in words):
        facts.add(Fact.INTENSITY)
    return facts


def _implied_facts(things: Collection[Word], in_sentence: bool) -> set[Fact]:
    """Return the facts that the things which are named leave in no doubt."""
    implied = {Fact.SOURCE} if things else set()
    if any(_has_known_size(word) for word in things):
        implied.add(Fact.SIZE)
    if any("any_material" not in word.lists for word in things):
        implied.add(Fact.MATERIAL)
    return implied | MANNER if things and in_sentence else implied


def categories_spoken_of(text: str) -> frozenset[str]:
    """Return the categories of the kind of sound that a text speaks of; none where it speaks of no kind."""
    kind_index = _place_of_kind(_words(text), (), "")
    return frozenset() if kind_index is None else lexicon().kinds[kind_index].filed_under


@lru_cache(CACHED)
def words_in(text: str) -> frozenset[str]:
    """Return the words of a text in lower case, without numbers."""
    return frozenset(_found_words(text))


@lru_cache(CACHED)
def forms_in(text: str) -> frozenset[str]:
    """Return the words of a text in every form that a lexicon may have them in."""
    return frozenset[str]().union(*map(_forms, _found_words(text)))


def _open_in_voice_line(description: str, described: Collection[Word]) -> tuple[Question, ...]:
    """Return the open questions of a spoken line's request; the script says all of a line that stands in it."""
    if SCRIPTED.search(description):
        return ()
    facts = {Fact(match[1].lower()) for match in STATED.finditer(description)}
    if SPOKEN.search(description):
        facts.add(Fact.WORDS)
    if any("people" in word.lists or Fact.SOURCE in word.facts for word in described):
        facts.add(Fact.CHARACTER)
    if any(word.facts & {Fact.MOOD, Fact.INTENSITY} for word in described):
        facts.add(Fact.DIRECTION)
    return tuple(question for question in VOICE_LINE if question.fact not in facts)


def _place_of_kind(
    named: Collection[Word], described: Collection[Word], category: str, *, may_class: bool = False
) -> int | None:
    """Return the place of the first kind that the name speaks of, else the description, else the category."""
    kinds = lexicon().kinds
    every = (*named, *described)
    there = frozenset[str]().union(*(word.partners for word in every))
    if places := {index for word in every for index in word.kinds if kinds[index].of & there}:
        return min(places)
    for words in (named, described):
        if places := {index for word in words for index in word.kinds if not kinds[index].of}:
            return min(places)
    category = category.lower()
    by_category = (index for index, kind in enumerate(kinds) if category in kind.categories)
    by_class = (index for index, kind in enumerate(kinds) if may_class and kind.classes & _lists_of(every))
    return next(by_category, next(by_class, None))


def _lists_of(words: Collection[Word]) -> frozenset[str]:
    return frozenset[str]().union(*(word.lists for word in words))


def _is_thing(word: Word, kind_index: int | None) -> bool:
    """Whether a word names something of its own: no word of a fact, of the kind, or of nothing in particular."""
    if "people" in word.lists:
        return kind_index is not None and lexicon().kinds[kind_index].by_people
    if "named" in word.lists and not _is_partner(word, kind_index):
        return True
    if not word.kinds and not _is_partner(word, kind_index) and ("things" in word.lists or word.lists & THINGS):
        return True
    if _is_of_kind(word, kind_index) or word.lists & {"vague", "verbs"} or max(map(len, word.forms)) < SHORTEST_THING:
        return False
    if "any_size" in word.lists:
        return True
    if word.kinds and any("-" in form for form in word.forms):
        return False
    return not (word.facts or any(form.endswith(("ing", "ed")) for form in word.forms))


def _has_known_size(word: Word) -> bool:
    return "any_size" not in word.lists and ("things" in word.lists or not word.lists & ANY_SIZE)


def _is_of_kind(word: Word, kind_index: int | None) -> bool:
    """Whether a word speaks of a kind, by itself or as the partner that the kind asks for."""
    return kind_index in word.kinds or _is_partner(word, kind_index)


def _is_partner(word: Word, kind_index: int | None) -> bool:
    return kind_index is not None and bool(word.partners & lexicon().kinds[kind_index].of)


def _is_unknown(word: Word) -> bool:
    """Whether the lexicon knows nothing of a word, so that it may be what happens as well as a thing."""
    return not (word.lists or word.facts or word.kinds)


def _is_informative(word: Word, kind_index: int | None) -> bool:
    """Whether a word says anything of the sound beyond its kind."""
    return _is_thing(word, kind_index) or bool(word.facts and kind_index not in word.kinds)


def _words(text: str) -> list[Word]:
    words = list(_found_words(text))
    pairs = (f"{word}-{other}" for word, other in pairwise(words))
    return [*map(_word, words), *(_word(pair) for pair in pairs if pair in lexicon().pairs)]


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
    """Return the lexicon's knowledge of a word, under any form that it may have there."""
    known, forms = lexicon(), _forms(text)
    if not forms & known.every and len(text) >= SHORTEST_MISSPELT:
        forms |= {word for key in deletion_variants(text) for word in known.near.get(key, ())}
    lists = frozenset(name for name, words in known.words.items() if forms & words)
    return Word(
        forms,
        frozenset(fact for fact, words in known.facts.items() if forms & words),
        frozenset(index for index, kind in enumerate(known.kinds) if forms & kind.words),
        lists,
        partners=forms | {f"@{name}" for name in lists},
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
