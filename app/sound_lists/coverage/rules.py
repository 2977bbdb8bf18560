"""Items that a brief names and a list lacks: scenes, categories and priority sounds, compared by their words."""

import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from app.sound_lists.rules import Need

AMBIENCE = "ambience"
_WORD = re.compile(r"[^\W_]+")
_NO_MEANING = frozenset(
    [
        *("a", "an", "and", "at", "by", "for", "from", "in", "into", "is", "it", "of", "on", "or", "the", "to"),
        *("when", "while", "with", "sound", "sounds", "effect", "effects"),
    ]
)


class ListedCue(NamedTuple):
    """The words of one cue that is not cut."""

    category: str
    name: str
    file_name: str
    description: str
    use: str
    trigger: str
    need: Need = Need.MUST


@dataclass(frozen=True)
class Coverage:
    """The brief's items that the list lacks."""

    scenes_without_ambience: Sequence[str]
    silent_scenes: Sequence[str]  # with neither ambience nor music in the brief
    categories_without_cue: Sequence[str]
    priority_without_cue: Sequence[str]
    priority_as_wish: Sequence[str]  # every cue for it is a wish


def words_of(text: str) -> frozenset[str]:
    """Return the words that carry meaning, folded, without plural."""
    plain = unicodedata.normalize("NFKD", text).casefold()
    folded = "".join(letter for letter in plain if not unicodedata.combining(letter))
    return frozenset(_singular(word) for word in _WORD.findall(folded) if word not in _NO_MEANING)


def _singular(word: str) -> str:
    return word[:-1] if len(word) > 3 and word.endswith("s") and not word.endswith("ss") else word


def coverage(answers: Mapping[str, Any], cues: Iterable[ListedCue]) -> Coverage:
    """Compare values of a brief, by question, with the cues of a list.

    A scene is covered by an ambience, a priority sound by any cue, that has all of its words.
    """
    listed = [(cue.category, words_of(" ".join(cue[1:-1])), cue.need) for cue in cues]
    everywhere = [words for _, words, _ in listed]
    needed = [words for _, words, need in listed if need is not Need.WISH]
    ambiences = [words for category, words, _ in listed if category == AMBIENCE]
    priority = answers.get("priority") or []
    scenes = answers.get("scenes") or []
    present = {category for category, _, _ in listed}
    return Coverage(
        scenes_without_ambience=[
            scene["scene"] for scene in scenes if scene["ambience"] and not _is_named(scene["scene"], ambiences)
        ],
        silent_scenes=[scene["scene"] for scene in scenes if not scene["ambience"] and not scene["music"]],
        categories_without_cue=[category for category in answers.get("categories") or [] if category not in present],
        priority_without_cue=[line for line in priority if not _is_named(line, everywhere)],
        priority_as_wish=[line for line in priority if _is_named(line, everywhere) and not _is_named(line, needed)],
    )


def _is_named(text: str, listed: Sequence[frozenset[str]]) -> bool:
    wanted = words_of(text)
    return not wanted or any(wanted <= words for words in listed)
