"""Names made of tokens: what each part between separators may be."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

from audio_checks.spec import patterns

Case = Literal["lower", "upper", "capital", "any"]

CASES = {"lower": "[a-z0-9]+", "upper": "[A-Z0-9]+", "capital": "[A-Z0-9][A-Za-z0-9]*", "any": "[A-Za-z0-9]+"}
CASE_WORDS = {
    "lower": "lower-case letters and digits",
    "upper": "capitals and digits",
    "capital": "letters and digits with a capital first",
    "any": "letters and digits",
}


@dataclass(frozen=True)
class Token:
    """One part of a name.

    Attributes
    ----------
    name : str
        What it is called in a sentence.
    one_of : tuple of str
        The only words it may be; empty for any.
    pattern : str or None
        A pattern that the whole part must match; see `audio_checks.spec.patterns`.
    digits : int or None
        It is a number of so many digits.
    case : {"lower", "upper", "capital", "any"}
        Letters and digits in this case, where nothing above is said.
    optional, repeats : bool
        Whether it may be left out, and whether more of its kind may follow.
    """

    name: str
    one_of: tuple[str, ...] = ()
    pattern: str | None = None
    digits: int | None = None
    case: Case = "any"
    optional: bool = False
    repeats: bool = False

    @cached_property
    def wanted(self) -> str:
        """Return its options, for a sentence."""
        if self.one_of:
            return " or ".join(self.one_of)
        if self.digits is not None:
            return f"{self.digits} digit{'' if self.digits == 1 else 's'}"
        return CASE_WORDS[self.case] if self.pattern is None else self.pattern

    def fits(self, part: str) -> bool:
        """Return whether a part of a name is such a token."""
        if self.one_of:
            return part in self.one_of
        if self.digits is not None:
            return len(part) == self.digits and part.isascii() and part.isdigit()
        return patterns.compiled(CASES[self.case] if self.pattern is None else self.pattern).matches(part)


def misfit(stem: str, tokens: Sequence[Token], separator: str) -> str | None:
    """Return the misfit of a name to its tokens, in words; None for a right name.

    Parameters
    ----------
    stem : str
        The name without its ending.
    tokens : sequence of Token
        In their order.
    separator : str
        What stands between two parts.
    """
    parts = stem.split(separator)
    places = [(0, 0)]  # (parts read, tokens done) that the name can be read to
    place_set = set(places)
    stuck: dict[int, set[int]] = {}  # tokens that do not fit, by the part they were tried on
    for read, done in places:
        if (read, done) == (len(parts), len(tokens)):
            return None
        steps = []
        if done < len(tokens):
            token = tokens[done]
            if token.optional:
                steps.append((read, done + 1))
            if read < len(parts) and token.fits(parts[read]):
                steps += [(read + 1, done + 1), *([(read + 1, done)] if token.repeats else [])]
            else:
                stuck.setdefault(read, set()).add(done)
        else:
            stuck.setdefault(read, set())
        new = [step for step in dict.fromkeys(steps) if step not in place_set]
        place_set.update(new)
        places += new
    reached = max(stuck)
    expected = " or ".join(f"{tokens[done].name} ({tokens[done].wanted})" for done in sorted(stuck[reached]))
    if reached == len(parts):
        return f"{expected} is missing at the end"
    return f'part {reached + 1} is "{parts[reached]}", wanted {expected or "no more parts"}'
