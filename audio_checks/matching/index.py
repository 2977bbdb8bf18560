"""The names of a sound list, in the order of their keys, and the cue that a file is for by its name.

A match is sure where the whole name is explained in one way only: the letters and numbers of one cue, the number of
its variation, and besides them only tokens without meaning for the sound. Everything else is a guess.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Hashable, Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from audio_checks.matching import reading
from audio_checks.matching.likeness import Likenesses
from audio_checks.matching.prefixes import is_ucs_name, may_be_shared, people_words, unexplained_before
from audio_checks.matching.reading import Reading, Token, key_of, plain, read_name, tokens_of
from audio_checks.matching.words import PREFIX_WORDS
from audio_checks.spec.sound_names import stems_of

GUESSES = 3
SHARED_BY = 0.8  # of a list's cues begin with a word that files may leave out
SHARED_FROM = 5  # cues at least


@dataclass(frozen=True)
class ListedCue:
    """The basis for matching a name: a cue's identity, its names and the number of its variations.

    Attributes
    ----------
    key : hashable
        What the caller knows it by.
    name, file_name, category : str
        As the list has them; without a file name the cue's files are named after its name.
    variations : int
        Files in its set; 1 for a single file.
    label : str
        Its short name, such as SW-014; may be empty.
    """

    key: Hashable
    name: str
    file_name: str = ""
    category: str = ""
    variations: int = 1
    label: str = ""


class SureMatch(NamedTuple):
    """The one cue and variation that a file is for, and which alternate it says it is."""

    cue: Hashable
    variation: int
    alternate: int | None


class Guess(NamedTuple):
    """A cue that a file may be for; without a variation where the name does not say which of the set."""

    cue: Hashable
    variation: int | None
    why: str


class _Entry(NamedTuple):
    """A name of a cue: its numbers as they are written there, each with whether it is attached to what is before."""

    cue: ListedCue
    numbers: tuple[tuple[str, bool], ...]


class _Hit(NamedTuple):
    """A cue whose name is in a file's name."""

    cue: ListedCue
    places: frozenset[int]
    last: int
    is_as_written: bool  # its numbers too: perc_bell2 for PercBell2, not for perc_bell_02


class _Slot(NamedTuple):
    hit: _Hit
    variation: int | None
    doubt: str  # empty: the whole name is explained


class NameIndex:
    """The names of one sound list; threads may share one.

    Parameters
    ----------
    cues : iterable of ListedCue
        Those that files may be for.
    own_words : iterable of str
        Names of the project and the studio: files may begin or end with their words or initials.
    """

    def __init__(self, cues: Iterable[ListedCue], own_words: Iterable[str] = ()) -> None:
        self._cues = list(cues)
        self._entries: dict[str, list[_Entry]] = defaultdict(list)
        self._labels: dict[tuple[str, str], ListedCue] = {}
        self._numbered: set[str] = set()  # keys that another key continues by a number
        self._vocabulary: set[str] = set()
        names = [_names_of(cue) for cue in self._cues]
        spelt = [(cue, tokens) for cue, of_cue in zip(self._cues, names, strict=True) for tokens in of_cue]
        shared = _shared_words(spelt)
        for cue, tokens in spelt:
            self._vocabulary.update(token.text for token in tokens if not token.is_number)
            self._add(cue, tokens)
            if len(tokens) > 1 and (tokens[0].text in shared or tokens[0].text in PREFIX_WORDS):
                self._add(cue, tokens[1:])
        for cue in self._cues:
            label = tokens_of(plain(cue.label))
            if len(label) > 1 and label[-1].is_number:
                self._labels[key_of(label[:-1]), label[-1].written] = cue
        self._longest = max(map(len, self._entries), default=0)
        self._own_words = people_words(own_words)
        self._likenesses = Likenesses(list(enumerate(names)))

    def _add(self, cue: ListedCue, tokens: Sequence[Token]) -> None:
        key = key_of(tokens)
        if sum(character.isalpha() for character in key) < 2:
            return
        entry = _Entry(cue, _numbers_of(tokens))
        if entry not in self._entries[key]:
            self._entries[key].append(entry)
        if tokens[-1].is_number:
            self._numbered.add(key_of(tokens[:-1]))

    def sure(self, path: str, people: Iterable[str] = (), prefixes: Collection[str] = ()) -> SureMatch | None:
        """Return the one cue and variation that a file is for; None in any doubt.

        Parameters
        ----------
        path : str
            The file's name, with the folders that it came in.
        people : iterable of str
            Names of those who send it: files may carry their words or initials.
        prefixes : collection of str
            Words that many files of the same delivery begin with; see `shared_prefixes`.
        """
        read = read_name(path)
        slots, _ = self._decided(read, people, prefixes)
        if len(slots) != 1 or slots[0].doubt or slots[0].variation is None:
            return None
        return SureMatch(slots[0].hit.cue.key, slots[0].variation, read.alternate)

    def guesses(self, path: str, people: Iterable[str] = (), prefixes: Collection[str] = ()) -> list[Guess]:
        """Return up to three cues that a file may be for, the likeliest first, each with why; see `sure`."""
        read = read_name(path)
        slots, others = self._decided(read, people, prefixes)
        slots.sort(key=lambda slot: (slot.doubt != "", -len(slot.hit.places)))
        guesses: dict[Hashable, Guess] = {}
        for slot in [*slots, *others]:
            why = slot.doubt or ("the name fits" if len(slots) == 1 else "the name fits more than one cue")
            guesses.setdefault(slot.hit.cue.key, Guess(slot.hit.cue.key, slot.variation, why))
        own_tokens = read.tokens[read.first :]
        words = [token for token_index, token in enumerate(own_tokens, read.first) if token_index not in read.markers]
        for index, why in self._likenesses.nearest(words or own_tokens, read.tokens[: read.first], GUESSES):
            cue = self._cues[index]
            guesses.setdefault(cue.key, Guess(cue.key, _last_number(words, cue), why))
        return list(guesses.values())[:GUESSES]

    def shared_prefixes(self, paths: Iterable[str]) -> frozenset[str]:
        """Return words that many files begin with, each followed by the name of another cue, and that no cue has."""
        followed: dict[str, set[Hashable]] = defaultdict(set)
        for path in paths:
            read = read_name(path)
            own_tokens = [token for index, token in enumerate(read.tokens) if index >= read.first]
            if (
                len(own_tokens) < 2
                or own_tokens[0].is_number
                or not may_be_shared(own_tokens[0].text, self._vocabulary)
            ):
                continue
            match = self.sure(path, prefixes=(own_tokens[0].text,))
            if match is not None:
                followed[own_tokens[0].text].add(match.cue)
        return frozenset(word for word, cues in followed.items() if len(cues) >= SHARED_FROM)

    def _decided(
        self, read: Reading, people: Iterable[str], prefixes: Collection[str]
    ) -> tuple[list[_Slot], list[_Slot]]:
        """Return the slots that explain the whole name, of which a single one without doubt is sure; and others."""
        hits = self._hits(read)
        known_words = self._own_words | people_words(people)
        labelled = self._labelled(read)
        slots = [self._slot(read, hit, known_words, frozenset(prefixes), labelled) for hit in hits]
        whole = [slot for slot in slots if not slot.doubt]
        if labelled and not whole and all(index in read.markers or index in labelled[1] for index in _own(read)):
            cue, places = labelled
            whole = [_Slot(_Hit(cue, places, max(places), True), 1 if cue.variations == 1 else None, "")]
        exact = [slot for slot in whole if self._is_own_stem(read, slot)]
        if len(exact) == 1:
            return exact, [slot for slot in slots if slot is not exact[0]]
        kept = [slot for slot in whole if not self._is_within_another(slot, whole)]
        rest = [slot for slot in slots if slot.doubt]
        if len({(slot.hit.cue.key, slot.variation) for slot in kept}) != 1:
            return kept, rest
        chosen = max(kept, key=lambda slot: len(slot.hit.places))
        doubt = self._doubt(read, chosen, whole, hits, labelled)
        return [chosen._replace(doubt=doubt)], [slot for slot in [*whole, *rest] if slot is not chosen]

    def _hits(self, read: Reading) -> list[_Hit]:
        """Return the cues whose names are in a name, in one piece but for markers between."""
        hits: dict[tuple[Hashable, frozenset[int]], _Hit] = {}
        every = range(len(read.tokens))
        unmarked = [index for index in every if index not in read.markers]
        for places in [list(every), unmarked] if read.markers else [list(every)]:
            for start in range(len(places)):
                key = ""
                for end in range(start, len(places)):
                    key += read.tokens[places[end]].key
                    if len(key) > self._longest:
                        break
                    if key not in self._entries or places[end] < read.first:
                        continue
                    taken = places[start : end + 1]
                    numbers = _numbers_of([read.tokens[index] for index in taken])
                    for entry in self._entries[key]:
                        hit_key = (entry.cue.key, frozenset(taken))
                        is_as_written = numbers == entry.numbers or (hit_key in hits and hits[hit_key].is_as_written)
                        hits[hit_key] = _Hit(entry.cue, frozenset(taken), taken[-1], is_as_written)
        return [*hits.values(), *self._hits_of_folders(read)]

    def _hits_of_folders(self, read: Reading) -> list[_Hit]:
        """Return the sets whose name is the end of the folders, where the file has only the number of a variation."""
        own_indices = [index for index in _own(read) if index not in read.markers]
        if len(own_indices) != 1 or not read.tokens[own_indices[0]].is_number:
            return []
        hits = []
        for start in range(read.first):
            places = range(start, read.first)
            named = self._entries.get(key_of([read.tokens[index] for index in places]), ())
            sets = [entry.cue for entry in named if entry.cue.variations > 1]
            hits += [_Hit(cue, frozenset(places), read.first - 1, True) for cue in sets]
        return hits

    def _labelled(self, read: Reading) -> tuple[ListedCue, frozenset[int]] | None:
        """Return the cue whose label, such as SW-014, is in the name, and where; None for none or two."""
        matches = []
        for index in _own(read):
            token = read.tokens[index]
            if not token.is_number:
                continue
            for start in range(max(read.first, index - 2), index):
                cue = self._labels.get((key_of(read.tokens[start:index]), token.written))
                if cue is not None:
                    matches.append((cue, frozenset(range(start, index + 1))))
        return matches[0] if len({cue.key for cue, _ in matches}) == 1 else None

    def _slot(
        self,
        read: Reading,
        hit: _Hit,
        known_words: frozenset[str],
        prefixes: frozenset[str],
        labelled: tuple[ListedCue, frozenset[int]] | None,
    ) -> _Slot:
        """Return a hit's variation, and the part of the name that it leaves unexplained."""
        aside = labelled[1] - hit.places if labelled and labelled[0].key == hit.cue.key else frozenset()
        cut_markers = {read.groups[index] for index in hit.places if index in read.groups}
        left = [
            index
            for index in _own(read)
            if index not in hit.places and index not in aside
            if index not in read.markers or read.groups[index] in cut_markers
        ]
        variation: int | None = 1
        after = hit.last + 1
        while after < len(read.tokens) and after not in left:
            after += 1
        number = read.tokens[after] if after in left and read.tokens[after].is_number else None
        if hit.cue.variations > 1:
            variation = None
            if number is not None and after not in read.after_marker and 1 <= int(number.text) <= hit.cue.variations:
                variation = int(number.text)
                left.remove(after)
        elif number is not None and self._is_of_marker(read, hit, after):
            left.remove(after)
        before = [index for index in left if index < min(hit.places)]
        behind = [index for index in left if index > min(hit.places)]
        unexplained = unexplained_before(
            read, hit.places, before, hit.cue.category, known_words, prefixes, self._vocabulary
        )
        if behind and not is_ucs_name(read, hit.places, behind, self._vocabulary):
            unexplained += [index for index in behind if read.tokens[index].text not in known_words - self._vocabulary]
        if unexplained:
            rest = " ".join(read.tokens[index].written for index in sorted(unexplained))
            return _Slot(hit, variation, f'it has the name, and "{rest}" in addition')
        if variation is None:
            return _Slot(hit, None, "the name does not say which variation")
        return _Slot(hit, variation, "")

    def _is_of_marker(self, read: Reading, hit: _Hit, index: int) -> bool:
        """Whether a number belongs to the marker before it, as in `FINAL 2`: no cue is named so with a number."""
        key = key_of([read.tokens[hit_index] for hit_index in sorted(hit.places)])
        return index in read.after_marker and key not in self._numbered

    def _is_within_another(self, slot: _Slot, whole: Sequence[_Slot]) -> bool:
        return any(slot.hit.places < other.hit.places for other in whole)

    def _doubt(
        self,
        read: Reading,
        chosen: _Slot,
        whole: Sequence[_Slot],
        hits: Sequence[_Hit],
        labelled: tuple[ListedCue, frozenset[int]] | None,
    ) -> str:
        """Return the doubt about the one slot that explains the name; empty where nothing is as near."""
        hit = chosen.hit
        if labelled and labelled[0].key != hit.cue.key:
            return f"the name fits, and it has the number {labelled[0].label} of another cue"
        for other in hits:
            if other.cue.key != hit.cue.key and other.places & hit.places and not other.places <= hit.places:
                return f'the name fits, and that of "{other.cue.name}" too'
        is_whole = hit.is_as_written and all(
            index in hit.places and read.markers.get(index) != "count" for index in _own(read)
        )
        for slot in whole:
            if slot.hit.cue.key == hit.cue.key or not slot.hit.places < hit.places:
                continue
            extra = hit.places - slot.hit.places
            if any(index < read.first for index in extra) or not (
                is_whole or (hit.is_as_written and not any(index in read.markers for index in extra))
            ):
                return f'the name fits, and that of "{slot.hit.cue.name}" too'
        tokens = [read.tokens[index] for index in sorted(hit.places)]
        if tokens[-1].is_number and not hit.is_as_written:
            shorter = self._others(key_of(tokens[:-1]), hit.cue)
            if shorter:
                return f'the name fits, and the number may be one of "{shorter[0].name}"'
        key = key_of(tokens)
        for count_index, kind in read.markers.items():
            if kind == "count" and count_index not in hit.places:
                longer = self._others(f"{key}{read.tokens[count_index].key}", hit.cue)
                if longer:
                    return f'the name fits, and "{longer[0].name}" with its number'
        if hit.cue.variations > 1:
            longer = self._others(f"{key}#{chosen.variation}", hit.cue)
            if longer:
                return f'the name fits, and that of "{longer[0].name}" too'
        return self._folder_doubt(read, hit)

    def _is_own_stem(self, read: Reading, slot: _Slot) -> bool:
        """Whether a name without folders is, letter for letter, what the list calls a cue's variation."""
        if read.first or slot.variation is None:
            return False
        cue = slot.hit.cue
        stems = stems_of(cue.name, cue.file_name, cue.variations)
        return bool(stems) and read.stem == stems[slot.variation - 1]

    def _folder_doubt(self, read: Reading, hit: _Hit) -> str:
        parts = {token.part for token in read.tokens[: read.first]}
        for part in parts:
            tokens = [token for token in read.tokens[: read.first] if token.part == part]
            key = key_of(tokens)
            others = self._others(key, hit.cue)
            own_key = key_of([read.tokens[index] for index in sorted(hit.places)])
            if others and all(entry.cue.key != hit.cue.key for entry in self._entries[key]) and key not in own_key:
                return f'the name fits, and its folder that of "{others[0].name}"'
        return ""

    def _others(self, key: str, cue: ListedCue) -> list[ListedCue]:
        return [entry.cue for entry in self._entries.get(key, ()) if entry.cue.key != cue.key]


def _own(read: Reading) -> range:
    return range(read.first, len(read.tokens))


def _numbers_of(tokens: Sequence[Token]) -> tuple[tuple[str, bool], ...]:
    return tuple((token.written, token.is_attached) for token in tokens if token.is_number)


def _names_of(cue: ListedCue) -> list[list[Token]]:
    """Return the tokens of a cue's file name and of its name; once where they are spelt alike."""
    stem = stems_of(cue.name, cue.file_name, 1)
    spelt = [tokens_of(plain(stem[0])[: reading.MOST_CHARS])] if stem else []
    by_name = tokens_of(plain(cue.name))
    if by_name and all(key_of(by_name) != key_of(tokens) for tokens in spelt):
        spelt.append(by_name)
    return [tokens for tokens in spelt if tokens]


def _shared_words(spelt: Sequence[tuple[ListedCue, list[Token]]]) -> set[str]:
    """Return the word that nearly all names of a list begin with."""
    counts: dict[str, int] = defaultdict(int)
    for _, tokens in spelt:
        counts[tokens[0].text] += 1
    return {word for word, count in counts.items() if count >= SHARED_FROM and count >= SHARED_BY * len(spelt)}


def _last_number(tokens: Sequence[Token], cue: ListedCue) -> int | None:
    if cue.variations == 1:
        return 1
    numbers = [int(token.text) for token in tokens if token.is_number]
    return numbers[-1] if numbers and 1 <= numbers[-1] <= cue.variations else None
