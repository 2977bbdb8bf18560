"""The form of a child's answer: bounded, plain, and of the types that the called function and its data classes declare.

A child whose decoder was taken over answers what it likes. Nothing of it is used before it has passed here.
"""

from __future__ import annotations

import dataclasses
import functools
import types
import typing
from collections.abc import Callable, Mapping
from typing import Any, Literal

from audio_checks.errors import SandboxCrashed

MOST_VALUES = 2_000_000
MOST_CHARACTERS = 4 << 20  # of one text
MOST_ITEMS = 50_000  # of one list of data classes: more findings than that no file has
MOST_NUMBERS = 100_000  # of one array: shapes and spectra have a few thousand points
DEEPEST = 64
NUMBERS = frozenset((int, float, bool, type(None)))
MISSING = object()


class UnexpectedAnswer(SandboxCrashed):
    """An answer that no honest child gives."""


def ensure_expected(answer: Any) -> None:
    """Raise UnexpectedAnswer for what is too long or too deep, or not what its data classes declare."""
    values = 0
    left = [(answer, 0)]
    while left:
        value, depth = left.pop()
        values += 1
        if values > MOST_VALUES or depth > DEEPEST:
            raise UnexpectedAnswer(f"more than {MOST_VALUES:,} values, or deeper than {DEEPEST}")
        inside: typing.Collection[Any] = ()
        if isinstance(value, str):
            if len(value) > MOST_CHARACTERS:
                raise UnexpectedAnswer(f"a text of {len(value):,} characters; {MOST_CHARACTERS:,} are allowed")
        elif isinstance(value, Mapping):
            inside = [*value.keys(), *value.values()]
        elif isinstance(value, list | tuple | set | frozenset):
            if len(value) > MOST_ITEMS and any(dataclasses.is_dataclass(element) for element in value):
                raise UnexpectedAnswer(f"a list of {len(value):,} entries; {MOST_ITEMS:,} are allowed")
            inside = value
        elif dataclasses.is_dataclass(value) and not isinstance(value, type):
            _ensure_declared(value)
            inside = [getattr(value, name) for name in _declared(type(value))]
        elif hasattr(value, "dtype"):
            if value.dtype.hasobject:
                raise UnexpectedAnswer("an array of objects; numbers are wanted")
            if value.size > MOST_NUMBERS:
                raise UnexpectedAnswer(f"an array of {value.size:,} numbers; {MOST_NUMBERS:,} are allowed")
        if values + len(left) + len(inside) > MOST_VALUES:
            raise UnexpectedAnswer(f"more than {MOST_VALUES:,} values, or deeper than {DEEPEST}")
        if set(map(type, inside)) <= NUMBERS:  # most of a report are points of curves: 3 ms for each take
            values += len(inside)
        else:
            left += [(member, depth + 1) for member in inside]


def ensure_declared(answer: Any, function: Callable[..., Any]) -> None:
    """Raise UnexpectedAnswer where an answer is not of the type that a function declares to return."""
    if misfit := _misfit(answer, returned_type(function), "the answer"):
        raise UnexpectedAnswer(misfit)


def returned_type(function: Callable[..., Any]) -> Any:
    """Return the type that a function declares to return, Any where it declares none."""
    try:
        return typing.get_type_hints(function).get("return", Any)
    except (NameError, TypeError):  # declared for type checkers only, or no function of Python
        return Any


def _ensure_declared(value: Any) -> None:
    declared = _declared(type(value))  # type: ignore[arg-type]
    for name, declared_type in declared.items():
        held = getattr(value, name, MISSING)
        if isinstance(held, tuple) and len(held) > MOST_ITEMS:
            raise UnexpectedAnswer(f"a list of {len(held):,} entries; {MOST_ITEMS:,} are allowed")
        if misfit := _misfit(held, declared_type, f"{type(value).__name__}.{name}"):
            raise UnexpectedAnswer(misfit)
    if extra := set(getattr(value, "__dict__", ())) - set(declared):
        raise UnexpectedAnswer(f"{type(value).__name__} has no {min(extra)}")


@functools.cache
def _declared(kind: type) -> dict[str, Any]:
    hints = _hints(kind)
    return {field.name: hints.get(field.name, Any) for field in dataclasses.fields(kind)}


@functools.cache
def _hints(kind: type) -> dict[str, Any]:
    try:
        return typing.get_type_hints(kind)
    except NameError:  # declared for type checkers only
        return {}


def _misfit(value: Any, declared_type: Any, where: str) -> str:
    """Return the place where a value is not of a declared type, "" if it is; anything not understood here fits."""
    if declared_type is Any:
        return f"{where} is missing" if value is MISSING else ""
    origin, arguments = typing.get_origin(declared_type), typing.get_args(declared_type)
    fits = True
    if origin is Literal:
        fits = isinstance(value, str | int | bool | None) and value in arguments
    elif origin in (typing.Union, types.UnionType):
        fits = any(not _misfit(value, argument, where) for argument in arguments)
    elif isinstance(origin, type):
        if isinstance(value, origin):
            return _misfit_inside(value, origin, arguments, where)
        fits = False
    elif hasattr(declared_type, "__required_keys__"):
        if isinstance(value, dict):
            return _misfit_of_keys(value, declared_type, where)
        fits = False
    elif declared_type in LEAVES:
        fits = _fits_leaf(value, declared_type)
    elif isinstance(declared_type, type):
        fits = isinstance(value, declared_type)
    return "" if fits else f"{where} is not {declared_type}"


# numpy's float64 is a float, and an enumeration of texts is a text; a bool is not a number.
LEAVES: dict[Any, tuple[type, ...]] = {
    int: (int,),
    float: (int, float),
    str: (str,),
    bytes: (bytes,),
    bool: (bool,),
    type(None): (type(None),),
    None: (type(None),),
}


def _fits_leaf(value: Any, declared_type: Any) -> bool:
    # -inf is the level of silence; what is not a number at all fits nowhere.
    return _is_leaf(type(value), declared_type) and value == value


def _is_leaf(kind: type, declared_type: Any) -> bool:
    return issubclass(kind, LEAVES[declared_type]) and (kind is not bool or declared_type is bool)


def _misfit_inside(value: Any, origin: type, arguments: tuple[Any, ...], where: str) -> str:
    if issubclass(origin, Mapping):
        return _misfit_of_all(value.keys(), arguments[0], f"a key of {where}") or _misfit_of_all(
            value.values(), arguments[1], f"a value of {where}"
        )
    if origin is tuple and (len(arguments) != 2 or arguments[1] is not Ellipsis):
        if len(value) != len(arguments):
            return f"{where} has {len(value)} values; {len(arguments)} are wanted"
        pairs = enumerate(zip(value, arguments, strict=True))
        misfits = (_misfit(element, declared_type, f"{where}[{index}]") for index, (element, declared_type) in pairs)
        return next(filter(None, misfits), "")
    if origin in (tuple, list, set, frozenset):
        return _misfit_of_all(value, arguments[0], f"an entry of {where}")
    return ""  # an array: its dtype says what it holds


def _misfit_of_all(values: typing.Collection[Any], declared_type: Any, where: str) -> str:
    if declared_type in LEAVES:  # a sheet has 400,000 cells
        kinds = set(map(type, values))
        if all(_is_leaf(kind, declared_type) for kind in kinds) and (
            declared_type is not float or all(value == value for value in values)
        ):
            return ""
        return f"{where} is not {declared_type}"
    return next(filter(None, (_misfit(value, declared_type, where) for value in values)), "")


def _misfit_of_keys(value: dict[Any, Any], declared_type: Any, where: str) -> str:
    hints = _hints(declared_type)
    if unknown := value.keys() - hints.keys():
        return f"{where} has no {min(map(str, unknown))}"
    if missing := declared_type.__required_keys__ - value.keys():
        return f"{where} lacks {min(missing)}"
    return next(filter(None, (_misfit(entry, hints[key], f"{where}.{key}") for key, entry in value.items())), "")
