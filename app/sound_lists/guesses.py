"""Which cue a badly named file may be for: likeness of names, length, category, and what still waits for sound."""

import re
import unicodedata
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from functools import lru_cache
from uuid import UUID

import audio_checks

GUESSES = 3
COMPARED_LETTER_BY_LETTER = 60  # of the candidates that share most words
COMPARED_LETTERS = 100  # to compare two names takes the square of their length
NAMES_REMEMBERED = 50_000  # some 300 bytes each: the same lists are looked through for file after file
HEAD_LETTERS = 4  # words that begin alike are taken for the same: step, steps, stepping
NOISE = frozenset(
    {"alt", "and", "bounce", "copy", "draft", "edit", "export", "final", "finished", "fix", "fixed", "for", "game"}
    | {"last", "latest", "loud", "master", "mastered", "mix", "mixed", "mono", "new", "of", "old", "ok", "processed"}
    | {"raw", "render", "rev", "rough", "sfx", "snd", "sound", "stereo", "take", "test", "the", "ver", "version"}
    | {"wav", "wip"}
)
MANY_CAPITALS = re.compile(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])")


@dataclass(frozen=True)
class Candidate:
    """What a guess knows of a cue."""

    key: UUID
    name: str
    stem: str
    category: str
    duration_s: float | None
    variations: int
    waits: bool  # nothing was delivered for it yet

    @property
    def stem_words(self) -> tuple[str, ...]:
        """The words of its file name."""
        return words_of(self.stem)

    @property
    def words(self) -> tuple[str, ...]:
        """The words of its file name and its name."""
        return words_of(f"{self.stem} {self.name}")


@dataclass(frozen=True)
class Likeness:
    """A candidate that a file may be for, and why."""

    key: UUID
    variation: int
    score: float
    reason: str


@lru_cache(NAMES_REMEMBERED)
def words_of(name: str) -> tuple[str, ...]:
    """Return the words of a name in lower case, without digits and without what people add to names of files."""
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode() or name
    words = re.findall(r"[^\W\d_]+", MANY_CAPITALS.sub(" ", plain))
    kept = [word.lower() for word in words if len(word) > 1 or not word.isascii()]
    return tuple(word for word in dict.fromkeys(kept) if word not in NOISE)


def likeliest(file_name: str, duration_s: float | None, candidates: Sequence[Candidate]) -> list[Likeness]:
    """Return three candidates, the likeliest first; where too few are alike, cues that still wait fill up."""
    stem = audio_checks.parse_file_name(file_name).stem
    words = words_of(stem)
    typed = "".join(words)[:COMPARED_LETTERS]
    heads = {word[:HEAD_LETTERS] for word in words if len(word) >= HEAD_LETTERS}
    ranked = sorted(
        ((_shared(words, heads, one.words), place) for place, one in enumerate(candidates)),
        key=lambda item: (-_weight(item[0], words), not candidates[item[1]].waits, item[1]),
    )
    near = {place for _, place in ranked[:COMPARED_LETTER_BY_LETTER]}
    found = [
        like
        for shared, place in ranked
        if (like := _likeness(candidates[place], words, typed, shared, duration_s, stem, closely=place in near))
    ]
    best = sorted(found, key=lambda like: -like.score)[:GUESSES]
    taken = {like.key for like in best}
    others = sorted((one for one in candidates if one.key not in taken), key=lambda one: not one.waits)
    return best + [_filler(one, stem) for one in others[: GUESSES - len(best)]]


def _filler(one: Candidate, stem: str) -> Likeness:
    reason = "not alike; nothing delivered yet" if one.waits else "not alike"
    return Likeness(one.key, _variation(stem, one.variations), 0.0, reason)


def _shared(words: Collection[str], heads: Collection[str], others: Iterable[str]) -> list[str]:
    """Return the words of the cue that the file's name has too, or that begin as one of its longer words."""
    return [other for other in others if other in words or other[:HEAD_LETTERS] in heads]


def _weight(shared: Sequence[str], words: Sequence[str]) -> float:
    return min(1.0, len(shared) / len(words)) if words else 0.0


def _likeness(
    one: Candidate,
    words: Sequence[str],
    typed: str,
    shared: Sequence[str],
    duration_s: float | None,
    stem: str,
    *,
    closely: bool,
) -> Likeness | None:
    reasons = []
    score = 0.0
    own = "".join(one.stem_words)[:COMPARED_LETTERS]
    spelling = SequenceMatcher(None, typed, own, autojunk=False).ratio() if closely and typed and own else 0.0
    if shared:
        score += 0.5 * _weight(shared, words) + 0.2 * len(shared) / max(1, len(one.stem_words))
        reasons.append("the name has " + " and ".join(f'"{word}"' for word in shared[:3]))
    elif spelling >= 0.6:
        reasons.append(f'the name reads like "{one.stem}"')
    score += 0.3 * spelling if shared or spelling >= 0.6 else 0.0
    if one.category and one.category in words:
        score += 0.1
        reasons.append(f"it says {one.category}")
    if duration_s is not None and one.duration_s is not None and abs(duration_s / one.duration_s - 1) <= 0.25:
        score += 0.15 * (1 - abs(duration_s / one.duration_s - 1))
        reasons.append(f"{_seconds(duration_s)} long, {_seconds(one.duration_s)} asked")
    if one.waits and (reasons or not words):
        score += 0.1
        reasons.append("nothing delivered yet")
    if not reasons:
        return None
    return Likeness(one.key, _variation(stem, one.variations), score, "; ".join(reasons))


def _seconds(value: float) -> str:
    return f"{value:.1f} s" if value >= 1 else f"{value * 1000:.0f} ms"


def _variation(stem: str, variations: int) -> int:
    """Return the variation that the last number in the name says, the first where it says none of the set's."""
    numbers = [int(digits) for digits in re.findall(r"[0-9]+", stem)]
    return numbers[-1] if numbers and 1 <= numbers[-1] <= variations else 1
