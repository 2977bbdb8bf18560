"""Possible parts before or behind the name of a sound: project, designer, category, blocks of the UCS."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence

from audio_checks.matching.reading import Reading, plain, tokens_of
from audio_checks.matching.words import NO_INITIALS, PREFIX_WORDS, QUALITIES, UCS_CATEGORIES

MOST_INITIALS = 3
MOST_UCS_BLOCKS = 2  # behind the name: creator and source
_CAT_ID = re.compile(r"([A-Z]{2,6}?)[A-Z][a-z]{2,}")


def people_words(names: Iterable[str]) -> frozenset[str]:
    """Return the words of names, and how they are shortened: Star Whale is star, whale, starwhale and sw."""
    name_words: set[str] = set()
    for name in names:
        words = [token.text for token in tokens_of(plain(name))]
        name_words.update(word for word in words if len(word) > 1)
        if len(words) > 1:
            name_words.add("".join(words))
            name_words.add("".join(word[0] for word in words))
            name_words.add(words[0][0] + words[-1])
    return frozenset(name_words - QUALITIES)


def may_be_shared(word: str, vocabulary: Collection[str]) -> bool:
    """Whether a word may be the prefix of a whole delivery: no cue has it, and it describes no sound."""
    return word not in vocabulary and word not in QUALITIES


def unexplained_before(
    read: Reading,
    hit: Collection[int],
    before: Sequence[int],
    category: str,
    known_words: Collection[str],
    prefixes: Collection[str],
    vocabulary: Collection[str],
) -> list[int]:
    """Return the places before the name of a cue that nothing explains."""
    own_indices = [index for index in before if index >= read.first]
    after_id = _after_cat_id(read, hit)
    if after_id:
        own_indices = [index for index in own_indices if index >= after_id]
    of_category = {token.text for token in tokens_of(plain(category))}
    is_shouted = all(read.tokens[index].written.isupper() for index in hit if not read.tokens[index].is_number)
    unexplained = []
    for token_index in own_indices:
        word = read.tokens[token_index].text
        if word in PREFIX_WORDS or word in of_category or word in prefixes:
            continue
        if word in known_words and word not in vocabulary:
            continue
        is_first = token_index == read.first
        if (
            is_first
            and len(hit) > 1
            and word not in vocabulary
            and _are_initials(read, token_index, is_shouted=is_shouted)
        ):
            continue
        unexplained.append(token_index)
    return unexplained


def _are_initials(read: Reading, index: int, *, is_shouted: bool) -> bool:
    """Whether a first word can only be a person's initials: two or three consonants, set off from what follows."""
    token = read.tokens[index]
    if token.is_number or not 2 <= len(token.text) <= MOST_INITIALS or token.text in NO_INITIALS:
        return False
    is_set_off = read.stem[token.end : token.end + 1] in ("_", "-", " ", ".")
    is_cased = token.written.islower() or (token.written.isupper() and not is_shouted)
    return is_set_off and is_cased and not set(token.text) & set("aeiouy") and token.text.isascii()


def _after_cat_id(read: Reading, hit: Collection[int]) -> int | None:
    """Return the place after the UCS category that a name begins with: UIClick_, AMBForst-Night_."""
    if min(hit) <= read.first:
        return None
    begins = next(index for index in range(read.first, len(read.tokens)) if index not in read.markers)
    match = _CAT_ID.match(read.stem, read.tokens[begins].start)
    if match is None or not any(match[0].startswith(short) for short in UCS_CATEGORIES):
        return None
    end = match.end()
    if read.stem[end : end + 1] not in ("_", "-", " "):
        return None
    if read.stem[end] == "-":  # the user category goes to the end of the block
        end = read.stem.find("_", end)
    after = [index for index in range(read.first, len(read.tokens)) if read.tokens[index].start >= end]
    return after[0] if after and end >= 0 and after[0] <= min(hit) else None


def is_ucs_name(read: Reading, hit: Collection[int], behind: Sequence[int], vocabulary: Collection[str]) -> bool:
    """Whether what stands behind a name are the creator and the source of a UCS name: CatID_FXName_CREATOR_SOURCE."""
    if _after_cat_id(read, hit) is None or not 1 <= len(behind) <= MOST_UCS_BLOCKS:
        return False
    own_indices = [index for index in hit if index >= read.first]
    is_shouted = all(read.tokens[index].written.isupper() for index in own_indices if not read.tokens[index].is_number)
    if is_shouted and "_" in read.stem[read.tokens[min(own_indices)].start : read.tokens[max(own_indices)].end]:
        return False
    return all(
        read.tokens[index].written.isupper()
        and read.tokens[index].text not in vocabulary
        and read.stem[read.tokens[index].start - 1] == "_"
        for index in behind
    )
