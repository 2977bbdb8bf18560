"""Categories of the Universal Category System that the words of a request may mean."""

import tomllib
from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, lru_cache
from importlib.resources import files

from app.sound_lists.clarity.rules import CACHED, LONG_WORDS, forms_in

MOST_OFFERED = 6  # more candidates say that the words are too general to choose
REST = ("Misc", "General")  # what fits no other subcategory
ONLY_IF_NAMED = ("CARTOON", "FARTS")
# Words of subcategories that say nothing of a sound by themselves.
GENERAL = frozenset(
    {
        *("&", "air", "by", "designed", "field", "general", "generic", "hard", "high", "large", "loop", "misc"),
        *("mechanism", "of", "place", "power", "public", "real", "small", "source", "speed", "track", "water"),
    }
)


@dataclass(frozen=True)
class UcsCategory:
    """A subcategory of the system."""

    cat_id: str
    category: str
    name: str

    @property
    def label(self) -> str:
        """Return the category as a person reads it: "Water: splash"."""
        return f"{self.category.capitalize()}: {self.name.lower()}"


@cache
def ucs_categories() -> Mapping[str, UcsCategory]:
    """Return every subcategory by its id."""
    read = tomllib.loads((files("app.sound_lists.categories") / "ucs.toml").read_text(encoding="utf-8"))
    entries = [(category, *entry.rsplit(" ", 1)) for category, text in read.items() for entry in text.split(", ")]
    return {cat_id: UcsCategory(cat_id, category, name) for category, name, cat_id in entries}


@cache
def _named() -> Mapping[str, frozenset[str]]:
    """Return the ids that a word names: by subcategory, or by category without what fits no other subcategory."""
    ids: dict[str, set[str]] = defaultdict(set)
    for entry in ucs_categories().values():
        if entry.category in ONLY_IF_NAMED:
            continue
        words = entry.name if entry.name in REST else f"{entry.name} {entry.category}"
        for word in words.lower().split():
            for form in forms_in(word) if word not in GENERAL else ():
                ids[form].add(entry.cat_id)
    return {word: frozenset(of_word) for word, of_word in ids.items()}


@cache
def _meant() -> Mapping[str, frozenset[str]]:
    """Return the ids that a word may mean, of our own words."""
    read = tomllib.loads((files("app.sound_lists.categories") / "ucs_words.toml").read_text(encoding="utf-8"))
    return {word: frozenset(text.split()) for word, text in read.items()}


@lru_cache(CACHED)
def ucs_candidates(name: str, description: str) -> tuple[UcsCategory, ...]:
    """Return the categories that a request may mean: those that most of its words speak of, in the system's order.

    Where no two words speak of one category, the ids that our own words mean count first. Empty where a long
    description leaves nothing open.
    """
    if len(description.split()) >= LONG_WORDS:
        return ()
    counts: dict[str, int] = defaultdict(int)
    meant, read = set[str](), set[str]()
    for word in f"{name} {description}".replace("_", " ").split():
        forms = forms_in(word)
        if forms & read:  # the name says it already
            continue
        read |= forms
        of_word = frozenset[str]().union(*(_meant().get(form, ()) for form in forms))
        meant |= of_word
        for cat_id in of_word.union(*(_named().get(form, ()) for form in forms)):
            counts[cat_id] += 1
    most = max(counts.values(), default=0)
    spoken_of = {cat_id for cat_id, count in counts.items() if count == most}
    if most == 1 and meant:
        spoken_of &= meant
    return tuple(entry for cat_id, entry in ucs_categories().items() if cat_id in spoken_of)


def is_ucs(category: str) -> bool:
    """Whether a category is one of the system: an id, or the name of a whole category, also as the list keeps it."""
    folded = category.casefold().replace("-", " ")
    return any(folded in (entry.cat_id.casefold(), entry.category.casefold()) for entry in ucs_categories().values())


def cat_id_of(text: str) -> str:
    """Return the id of a category that is written as it is offered; any other text as it is."""
    return next((entry.cat_id for entry in ucs_categories().values() if entry.label == text), text)
