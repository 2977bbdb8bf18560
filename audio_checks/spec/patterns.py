"""Patterns that strangers write, matched in linear time: a finite automaton over Python's own pattern syntax.

A pattern is parsed by Python, so that it means what `re.fullmatch(pattern, text, re.ASCII)` means. It
is then run as a set of states that moves along the text once, in place of a search that can try
exponentially many ways. What needs such a search (references back, looking ahead) is refused.
Source: K. Thompson, Regular Expression Search Algorithm, CACM 11 (1968) 6; R. Cox, Regular Expression
Matching: the Virtual Machine Approach (2009).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache
from typing import Any

from audio_checks.spec.pattern_syntax import MAXREPEAT, parse

LONGEST_PATTERN = 1_000
LONGEST_TEXT = 4_096  # the longest path of Linux; longer names fit no pattern
MOST_STATES = 5_000
MOST_DEPTH = 50  # of groups within one another
MOST_REMEMBERED = 100_000  # states in the sets that were met, and steps between these

_GROUP_MARK = re.compile(r"\\.|[()]", re.DOTALL)
_FLAGS = re.IGNORECASE | re.MULTILINE | re.DOTALL
_LAST_LINE_END = "\n$"  # a line end that is the last character, which `$` matches before
_WORD = frozenset("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_")
_CATEGORIES: dict[str, Callable[[str], bool]] = {
    "DIGIT": frozenset("0123456789").__contains__,
    "SPACE": frozenset(" \t\n\r\f\v").__contains__,
    "WORD": _WORD.__contains__,
}
_UNSUPPORTED = {
    "GROUPREF": r"a reference back to a group, such as \1; write what may stand there once more",
    "GROUPREF_EXISTS": "a condition on a group, (?(1)...); write both forms with | between them",
    "ASSERT": "looking ahead or behind, (?=...) or (?<=...); write the whole name that is wanted",
    "ASSERT_NOT": "looking ahead or behind, (?!...) or (?<!...); write the names that are wanted",
    "ATOMIC_GROUP": "an atomic group, (?>...); write (?:...), which matches the same whole names or more",
    "POSSESSIVE_REPEAT": "a possessive repeat, such as *+; write it without the second +",
}

Test = Callable[[str], bool]  # of one character
Condition = Callable[[str, str], bool]  # of the character before and the one after; "" for none


class PatternUnsupported(ValueError):
    """The pattern is not a regular expression, or one that cannot be matched in linear time; says why."""


class Pattern:
    """A pattern as an automaton. Threads may share one."""

    def __init__(self, pattern: str, flags: int = re.ASCII) -> None:
        if len(pattern) > LONGEST_PATTERN:
            raise PatternUnsupported(f"a pattern of {len(pattern):,} characters; at most {LONGEST_PATTERN:,} are read")
        depth = 0
        for mark in _GROUP_MARK.findall(pattern):  # so that the verdict does not hang on how deep the caller is
            depth += 1 if mark == "(" else -1 if mark == ")" else 0
            if depth > MOST_DEPTH:
                raise PatternUnsupported(f"groups lie more than {MOST_DEPTH} deep in one another")
        try:
            parsed = parse(pattern, flags)
            self._automaton = _Automaton()
            first = self._automaton.add(parsed, parsed.state.flags, _Automaton.END)
        except (re.error, OverflowError, RecursionError) as error:
            raise PatternUnsupported(f"not a regular expression: {error}") from None
        self._first = frozenset({first})
        self._forget()

    def matches(self, text: str) -> bool:
        """Return whether the whole text matches."""
        if len(text) > LONGEST_TEXT:
            return False
        now = self._start
        last = len(text) - 1
        for index, character in enumerate(text):
            symbol = _LAST_LINE_END if character == "\n" and index == last else character
            now = now.following.get(symbol) or self._step(now, symbol)
            if not now.states:
                return False
        return _Automaton.END in self._automaton.closure(now.states, now.before, "")

    def _forget(self) -> None:
        self._met: dict[tuple[frozenset[int], str], _Met] = {}
        self._remembered = 0
        self._start = self._meet(self._first, "")

    def _meet(self, states: frozenset[int], before: str) -> _Met:
        """Return the cache entry of a set of states; of the character before, only what a condition asks."""
        kind = before if before in ("", "\n") else "a" if before in _WORD else " "
        met = self._met.get((states, kind))
        if met is None:
            met = self._met[states, kind] = _Met(states, kind)
            self._remembered += len(states) + 1
        return met

    def _step(self, now: _Met, symbol: str) -> _Met:
        automaton = self._automaton
        character = symbol[0]
        reached = automaton.closure(now.states, now.before, symbol)
        states = frozenset(
            automaton.targets[state] for state in reached if (test := automaton.tests[state]) and test(character)
        )
        if self._remembered > MOST_REMEMBERED:
            self._forget()
        following = self._meet(states, character)
        now.following[symbol] = following
        self._remembered += 1
        return following


class _Met:
    """A set of states that a text has led to, with the sets that characters lead to from there."""

    __slots__ = ("before", "following", "states")

    def __init__(self, states: frozenset[int], before: str) -> None:
        self.states = states
        self.before = before
        self.following: dict[str, _Met] = {}


class _Automaton:
    """States, each with a test of one character and its target, or with free moves, some on a condition."""

    END = 0

    def __init__(self) -> None:
        self.tests: list[Test | None] = [None]
        self.targets: list[int] = [0]
        self.moves: list[list[tuple[Condition | None, int]]] = [[]]

    def _state(self, test: Test | None = None, target: int = 0) -> int:
        if len(self.tests) >= MOST_STATES:
            raise PatternUnsupported(
                f"the pattern comes to more than {MOST_STATES:,} steps; write smaller counts in braces, or + or *"
            )
        self.tests.append(test)
        self.targets.append(target)
        self.moves.append([])
        return len(self.tests) - 1

    def add(self, sequence: Iterable[tuple[Any, Any]], flags: int, end: int) -> int:
        """Return the state from which a parsed sequence leads to `end`."""
        for operator, argument in reversed(list(sequence)):
            end = self._add_one(str(operator), argument, flags, end)
        return end

    def _add_one(self, operator: str, argument: Any, flags: int, end: int) -> int:
        if operator in _UNSUPPORTED:
            raise PatternUnsupported(f"a pattern may not have {_UNSUPPORTED[operator]}")
        if operator == "SUBPATTERN":
            _, added, removed, inner = argument
            if (added | removed) & ~(_FLAGS | re.ASCII | re.VERBOSE):
                raise PatternUnsupported("a pattern is of ASCII; leave out (?u:...)")
            return self.add(inner, (flags | added) & ~removed, end)
        if operator == "BRANCH":
            start = self._state()
            self.moves[start] = [(None, self.add(branch, flags, end)) for branch in argument[1]]
            return start
        if operator in ("MAX_REPEAT", "MIN_REPEAT"):  # greedy or not, the same whole texts match
            least, most, inner = argument
            return self._add_repeat(least, most, inner, flags, end)
        if operator == "AT":
            start = self._state()
            self.moves[start] = [(_condition(str(argument), flags), end)]
            return start
        return self._state(_test(operator, argument, flags), end)

    def _add_repeat(self, least: int, most: int, inner: Any, flags: int, end: int) -> int:
        if most == MAXREPEAT:
            loop = self._state()
            self.moves[loop] = [(None, self.add(inner, flags, loop)), (None, end)]
            end = loop
        else:
            after = end
            for _ in range(most - least):
                start = self._state()
                self.moves[start] = [(None, self.add(inner, flags, end)), (None, after)]
                end = start
        for _ in range(least):
            start = self._state()  # one at least a turn, so that turns of nothing count too
            self.moves[start] = [(None, self.add(inner, flags, end))]
            end = start
        return end

    def closure(self, states: Iterable[int], before: str, after: str) -> set[int]:
        """Return all states that can be reached without a character."""
        reached = set(states)
        waiting = list(reached)
        while waiting:
            for condition, target in self.moves[waiting.pop()]:
                if target not in reached and (condition is None or condition(before, after)):
                    reached.add(target)
                    waiting.append(target)
        return reached


def _test(operator: str, argument: Any, flags: int) -> Test:
    """Return the test of one character for an operator."""
    if operator == "ANY":
        return (lambda _: True) if flags & re.DOTALL else (lambda character: character != "\n")
    items = [("LITERAL", argument)] if operator in ("LITERAL", "NOT_LITERAL") else argument
    return _set_test([(str(kind), value) for kind, value in items], flags, negated=operator == "NOT_LITERAL")


def _set_test(items: Sequence[tuple[str, Any]], flags: int, *, negated: bool) -> Test:
    ranges: list[tuple[str, str]] = []
    others: list[tuple[Test, bool]] = []
    for kind, value in items:
        if kind == "NEGATE":
            negated = True
        elif kind == "LITERAL":
            ranges.append((chr(value), chr(value)))
        elif kind == "RANGE":
            ranges.append((chr(value[0]), chr(value[1])))
        else:
            name = str(value).removeprefix("CATEGORY_")
            others.append((_CATEGORIES[name.removeprefix("NOT_")], not name.startswith("NOT_")))

    def holds(character: str) -> bool:
        return any(low <= character <= high for low, high in ranges) or any(
            test(character) is expected for test, expected in others
        )

    if flags & re.IGNORECASE:
        return lambda character: (
            (holds(character) or (character.isascii() and (holds(character.lower()) or holds(character.upper()))))
            is not negated
        )
    return lambda character: holds(character) is not negated


def _condition(name: str, flags: int) -> Condition:
    """Return the condition of a place in the text: its begin, its end, a line's, or a word's."""
    if name == "AT_BEGINNING" and flags & re.MULTILINE:
        return lambda before, _: before in ("", "\n")
    if name in ("AT_BEGINNING", "AT_BEGINNING_STRING"):
        return lambda before, _: before == ""
    if name == "AT_END" and flags & re.MULTILINE:
        return lambda _, after: after[:1] in ("", "\n")
    if name == "AT_END":
        return lambda _, after: after in ("", _LAST_LINE_END)
    if name == "AT_END_STRING":
        return lambda _, after: after == ""
    is_wanted = name == "AT_BOUNDARY"
    return lambda before, after: ((before in _WORD) != (after in _WORD)) is is_wanted


@lru_cache(maxsize=256)
def compiled(pattern: str, flags: int = re.ASCII) -> Pattern:
    """Return the automaton of a pattern.

    Raises
    ------
    PatternUnsupported
        It is not a regular expression, has a construct that needs a search, or is too large; says which.
    """
    return Pattern(pattern, flags)
