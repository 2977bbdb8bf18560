"""What a child's answer may be: bounded, plain, and of the types that its data classes declare.

A child whose decoder was taken over answers what it likes. Nothing of it is used before it has passed here.
"""

from __future__ import annotations

import dataclasses
import functools
import types
import typing
from collections.abc import Mapping
from typing import Any, Literal

MOST_VALUES = 2_000_000
MOST_CHARACTERS = 4 << 20  # of one text
MOST_ITEMS = 50_000  # of one list of data classes: more findings than that no file has
DEEPEST = 64


class UnlikelyAnswer(Exception):
    """An answer that no honest child gives."""


def ensure_likely(answer: Any) -> None:
    """Raise UnlikelyAnswer for what is too long or too deep, or not what its data classes declare."""
    values = 0
    left = [(answer, 0)]
    while left:
        value, depth = left.pop()
        values += 1
        if values > MOST_VALUES or depth > DEEPEST:
            raise UnlikelyAnswer(f"more than {MOST_VALUES:,} values, or deeper than {DEEPEST}")
        inside: typing.Collection[Any] = ()
        if isinstance(value, str):
            if len(value) > MOST_CHARACTERS:
                raise UnlikelyAnswer(f"a text of {len(value):,} characters; {MOST_CHARACTERS:,} are allowed")
        elif isinstance(value, Mapping):
            inside = [*value.keys(), *value.values()]
        elif isinstance(value, list | tuple | set | frozenset):
            if len(value) > MOST_ITEMS and any(dataclasses.is_dataclass(one) for one in value):
                raise UnlikelyAnswer(f"a list of {len(value):,} entries; {MOST_ITEMS:,} are allowed")
            inside = value
        elif dataclasses.is_dataclass(value) and not isinstance(value, type):
            _ensure_declared(value)
            inside = [getattr(value, name) for name in _declared(type(value))]
        elif hasattr(value, "dtype") and value.dtype.hasobject:
            raise UnlikelyAnswer("an array of objects; numbers are wanted")
        if values + len(left) + len(inside) > MOST_VALUES:
            raise UnlikelyAnswer(f"more than {MOST_VALUES:,} values, or deeper than {DEEPEST}")
        left += [(one, depth + 1) for one in inside]


def _ensure_declared(value: Any) -> None:
    declared = _declared(type(value))  # type: ignore[arg-type]
    for name, wanted in declared.items():
        held = getattr(value, name, None)
        if isinstance(held, tuple) and len(held) > MOST_ITEMS:
            raise UnlikelyAnswer(f"a list of {len(held):,} entries; {MOST_ITEMS:,} are allowed")
        if not hasattr(value, name) or not _fits(getattr(value, name), wanted):
            raise UnlikelyAnswer(f"{type(value).__name__}.{name} is not {wanted}")
    if extra := set(getattr(value, "__dict__", ())) - set(declared):
        raise UnlikelyAnswer(f"{type(value).__name__} has no {min(extra)}")


@functools.cache
def _declared(kind: type) -> dict[str, Any]:
    try:
        hints = typing.get_type_hints(kind)
    except NameError:  # declared for type checkers only
        hints = {}
    return {field.name: hints.get(field.name, Any) for field in dataclasses.fields(kind)}


def _fits(value: Any, wanted: Any) -> bool:
    """Tell whether a value is of a declared type; what is not understood here fits."""
    origin = typing.get_origin(wanted)
    if origin is Literal:
        return isinstance(value, str | int | bool | None) and value in typing.get_args(wanted)
    if origin in (typing.Union, types.UnionType):
        return any(_fits(value, one) for one in typing.get_args(wanted))
    if origin in (tuple, list, dict, set, frozenset):
        if not isinstance(value, origin):
            return False
        arguments = typing.get_args(wanted)
        if origin is tuple and len(arguments) == 2 and arguments[1] is Ellipsis:
            return all(_fits(one, arguments[0]) for one in value)
        return True
    if wanted is float:
        # -inf is the level of silence; what is no number at all fits nowhere.
        return isinstance(value, int | float) and not isinstance(value, bool) and value == value
    if wanted is int:
        return isinstance(value, int) and not isinstance(value, bool)
    if wanted in (str, bytes, bool):
        return isinstance(value, wanted)
    if wanted is type(None):
        return value is None
    return not isinstance(wanted, type) or not dataclasses.is_dataclass(wanted) or isinstance(value, wanted)
