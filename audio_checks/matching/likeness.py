"""Cues that a name is like, where it is none's: words that both have, and letters in threes for mistakes in typing."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence

from audio_checks.matching.reading import Token

MOST_POSTINGS = 150  # of a word or three letters: what more names have says little
COMPARED = 20  # names that share most
LEAST = 0.15  # a name less like is not a guess


_IRREGULAR = {
    "calves": "calf",
    "children": "child",
    "elves": "elf",
    "feet": "foot",
    "geese": "goose",
    "hooves": "hoof",
    "knives": "knife",
    "leaves": "leaf",
    "men": "man",
    "mice": "mouse",
    "shelves": "shelf",
    "teeth": "tooth",
    "wolves": "wolf",
    "women": "woman",
}


def likeness_key(token: Token) -> str:
    """Return the common key of a word's singular and plural: door and doors, fly and flies, box and boxes."""
    if token.is_number:
        return token.key
    word = _IRREGULAR.get(token.text, token.text)
    if len(word) > 3 and word.endswith("s") and not word.endswith(("ss", "us", "is")):
        word = word[:-1]
    if len(word) > 3 and word.endswith("e"):
        word = word[:-1]
    return f"{word[:-1]}i" if len(word) > 2 and word.endswith("y") else word


class Likenesses:
    """The words and threes of letters of a list's names.

    Parameters
    ----------
    names : sequence of (int, list of list of Token)
        What the caller knows a cue by, with its names.
    """

    def __init__(self, names: Sequence[tuple[int, Sequence[Sequence[Token]]]]) -> None:
        self._words: dict[str, list[int]] = defaultdict(list)
        self._threes: dict[str, list[int]] = defaultdict(list)
        self._own: dict[int, tuple[frozenset[str], frozenset[str]]] = {}
        self._spelt: dict[int, dict[str, str]] = {}  # how a cue writes its words
        for index, spelt in names:
            self._spelt[index] = {likeness_key(token): token.text for tokens in spelt for token in tokens}
            words = frozenset(self._spelt[index])
            threes = frozenset(three for tokens in spelt for three in threes_of(tokens))
            self._own[index] = (words, threes)
            for word in words:
                self._words[word].append(index)
            for three in threes:
                self._threes[three].append(index)

    def nearest(self, tokens: Sequence[Token], folders: Sequence[Token], most: int) -> list[tuple[int, str]]:
        """Return the names that are most alike, the likeliest first, each with why; fewer where few are alike."""
        words = frozenset(key for key in map(likeness_key, tokens) if not key.startswith("#") or key in self._words)
        beside = frozenset(map(likeness_key, folders))
        threes = threes_of(tokens if any(not token.is_number for token in tokens) else folders)
        counts: dict[int, float] = defaultdict(float)
        for postings, keys, weight in ((self._words, words | beside, 3.0), (self._threes, threes, 1.0)):
            posting_lists = sorted((postings[key] for key in keys if key in postings), key=len)
            for index, of_key in enumerate(posting_lists):
                if len(of_key) > MOST_POSTINGS and index:
                    break
                for cue in of_key[:MOST_POSTINGS]:
                    counts[cue] += weight
        near = sorted(counts, key=lambda cue: (-counts[cue], cue))[:COMPARED]
        scored = [(self._score(cue, words, beside, threes), cue) for cue in near]
        scored.sort(key=lambda item: (-item[0], item[1]))
        return [(cue, self._why(cue, words, beside)) for score, cue in scored[:most] if score >= LEAST]

    def _score(self, cue: int, words: frozenset[str], beside: frozenset[str], threes: frozenset[str]) -> float:
        own_words, own_threes = self._own[cue]
        shared = math.fsum(self._weight(word) for word in own_words & (words | beside))
        every = math.fsum(self._weight(word) for word in own_words | words)
        spelling = 2 * len(threes & own_threes) / (len(threes) + len(own_threes)) if threes and own_threes else 0.0
        return 0.5 * shared / every + 0.5 * spelling if every else spelling

    def _weight(self, word: str) -> float:
        return 1.0 / (1.0 + math.log1p(len(self._words.get(word, ()))))

    def _why(self, cue: int, words: frozenset[str], beside: frozenset[str]) -> str:
        spelt = self._spelt[cue]
        of_name = [spelt[word] for word in spelt if word in words and not word.startswith("#")]
        of_folders = [spelt[word] for word in spelt if word in beside and not word.startswith("#")]
        if not (of_name or of_folders):
            return "the name is spelt nearly alike"
        holder = "the name has" if of_name else "the folders have" if len(of_folders) > 1 else "the folder has"
        *most, last = [f'"{word}"' for word in dict.fromkeys([*of_name, *of_folders])][:3]
        return f"{holder} {', '.join(most)} and {last}" if most else f"{holder} {last}"


def threes_of(tokens: Sequence[Token]) -> frozenset[str]:
    """Return the threes of letters in a name, its beginning and its end included."""
    letters = f"  {''.join(token.text for token in tokens)} "
    return frozenset(letters[start : start + 3] for start in range(len(letters) - 2))
