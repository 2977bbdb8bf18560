"""The category that the words of a name speak of."""

from collections import Counter
from collections.abc import Iterable

from app.sound_lists.clarity.rules import categories_spoken_of, words_in

USUAL = ("ambience", "foley", "ui", "weapon", "impact", "creature", "vehicle", "music", "vo", "water", "weather")
SHORTEST = 3  # letters of a word that two names may share: "of" says no category


def category_of_name(name: str, listed: Iterable[tuple[str, str]]) -> str:
    """Return the category of the listed cues whose names share most words with a name, else that of its kind of sound.

    `listed` has the name and the category of each cue of the list. Empty where no word says a category.
    """
    own = {word for word in words_in(name) if len(word) >= SHORTEST}
    shared: Counter[str] = Counter()
    categories = set[str]()
    for other, category in listed:
        categories.add(category)
        common = len(own & words_in(other)) if category else 0
        shared[category] += common * common  # two words in one name say more than one word in two names
    if (category := max(shared, key=lambda candidate: shared[candidate], default="")) and shared[category]:
        return category
    spoken_of = categories_spoken_of(name)
    known = sorted(spoken_of & categories) or [usual for usual in USUAL if usual in spoken_of] or sorted(spoken_of)
    return known[0] if known else ""
