"""An answer's way from child to caller: as data, so that reading it builds values and runs nothing.

JSON, followed by the bytes that it names. In the JSON every value that is not a text, number, true, false or null is a
list that begins with its kind. A data class, enumeration or error is named by module and name, and is looked up among
those of audio_checks that the caller has loaded: nothing is imported, and nothing of the class is called. The values
of a data class follow in the order of its fields.
"""

from __future__ import annotations

import dataclasses
import enum
import json
import re
import struct
import sys
from itertools import islice
from pathlib import Path, PurePath
from typing import Any

import numpy as np

from audio_checks.errors import AudioChecksError

LENGTH = struct.Struct("<Q")
MOST_VALUES = 2_000_000
DEEPEST = 64
NUMBERS = frozenset("biufc")  # kinds of dtypes
COUNTED_FROM = 4 << 20  # shorter JSON cannot name enough values to matter
TOKEN = re.compile(rb'"[^"\\]*(?:\\.[^"\\]*)*"?|[,[{]', re.DOTALL)  # a text, or what begins or parts values
LEAVES = frozenset((str, int, float, bool, type(None)))


class NotPlain(ValueError):
    """A value that no answer may have, or an answer that cannot be read."""


def encode(value: Any) -> bytes:
    """Return a value as bytes; raise NotPlain for what is neither plain nor of a data class of audio_checks."""
    blobs: list[bytes] = []
    text = json.dumps(_written(value, blobs, 0), separators=(",", ":")).encode()
    return b"".join((LENGTH.pack(len(text)), text, *blobs))


def decode(content: bytes) -> Any:
    """Return the value that `encode` wrote; raise ValueError or RecursionError for any other bytes."""
    if len(content) < LENGTH.size:
        raise NotPlain("the answer is cut short")
    (length,) = LENGTH.unpack_from(content)
    begin = LENGTH.size + length
    if begin > len(content):
        raise NotPlain("the answer is cut short")
    text = content[LENGTH.size : begin]
    _ensure_few_values(text)
    return _Reader(memoryview(content)[begin:]).read(json.loads(text.decode("ascii")), 0)


def _ensure_few_values(text: bytes) -> None:
    """Raise NotPlain before so many values are made that they fill the caller's memory."""
    if len(text) > COUNTED_FROM and sum(1 for _ in islice(TOKEN.finditer(text), MOST_VALUES + 1)) > MOST_VALUES:
        raise NotPlain(f"more than {MOST_VALUES:,} values")


def _written(value: Any, blobs: list[bytes], depth: int) -> Any:
    """Return a value in lists, texts and numbers."""
    kind = type(value)
    if kind in LEAVES:
        return value
    if depth > DEEPEST:
        raise NotPlain(f"the answer is deeper than {DEEPEST}")
    if kind in (list, tuple, set, frozenset):
        if set(map(type, value)) <= LEAVES:  # a sheet has 400,000 cells
            return [kind.__name__, *value]
        return [kind.__name__, *(_written(element, blobs, depth + 1) for element in value)]
    if isinstance(value, dict):
        return ["dict", _written([*value], blobs, depth + 1), _written([*value.values()], blobs, depth + 1)]
    if isinstance(value, enum.Enum):
        return ["enum", *_name_of(kind), value.name]
    if dataclasses.is_dataclass(value):
        values = (getattr(value, field.name) for field in dataclasses.fields(value))
        return ["data", *_name_of(kind), *(_written(element, blobs, depth + 1) for element in values)]
    if isinstance(value, AudioChecksError):
        return ["error", *_name_of(kind), _written([value.args, vars(value)], blobs, depth + 1)]
    if isinstance(value, np.ndarray):
        if value.dtype.kind not in NUMBERS:
            raise NotPlain("an array of objects; numbers are wanted")
        blobs.append(value.tobytes())
        return ["array", value.dtype.str, list(value.shape), value.nbytes]
    if isinstance(value, bytes | bytearray):
        blobs.append(bytes(value))
        return ["bytes", len(value)]
    if isinstance(value, PurePath):
        return ["path", str(value)]
    if isinstance(value, np.generic):
        return value.item()
    raise NotPlain(f"a {kind.__qualname__} may not come out of a sandbox")


def _name_of(kind: type) -> tuple[str, str]:
    return kind.__module__, kind.__qualname__


class _Reader:
    """Makes values of JSON and of the bytes after it, in the order in which they were written."""

    def __init__(self, blobs: memoryview) -> None:
        self._blobs = blobs
        self._place = 0

    def read(self, encoded: Any, depth: int) -> Any:
        """Return one value."""
        if not isinstance(encoded, list):
            if isinstance(encoded, dict):
                raise NotPlain("the answer has a mapping that names no kind")
            return encoded
        if depth > DEEPEST:
            raise NotPlain(f"the answer is deeper than {DEEPEST}")
        match encoded:
            case ["list", *_]:
                return self._items(encoded, depth)
            case ["tuple", *_]:
                return tuple(self._items(encoded, depth))
            case ["set", *_]:
                return set(self._items(encoded, depth))
            case ["frozenset", *_]:
                return frozenset(self._items(encoded, depth))
            case ["dict", list(keys), list(values)]:
                return dict(zip(self.read(keys, depth + 1), self.read(values, depth + 1), strict=True))
            case ["enum", str(module), str(name), str(member)]:
                return _class_of(module, name, enum.Enum)[member]
            case ["data", str(module), str(name), *values]:
                return self._data(_class_of(module, name, None), values, depth)
            case ["error", str(module), str(name), list(args_and_state)]:
                args, state = self.read(args_and_state, depth + 1)
                error = _class_of(module, name, AudioChecksError)
                made: AudioChecksError = BaseException.__new__(error)
                made.args = args
                vars(made).update(state)
                return made
            case ["array", str(dtype), list(shape), int(size)]:
                return self._array(dtype, shape, size)
            case ["bytes", int(size)]:
                return bytes(self._blob(size))
            case ["path", str(text)]:
                return Path(text)
        raise NotPlain("the answer has a value of no known kind")

    def _items(self, encoded: list[Any], depth: int) -> list[Any]:
        items = encoded[1:]
        if set(map(type, items)) <= LEAVES:
            return items
        return [self.read(item, depth + 1) for item in items]

    def _blob(self, size: int) -> memoryview:
        begin = self._place
        self._place = end = begin + size
        if size < 0 or end > len(self._blobs):
            raise NotPlain("the answer is cut short")
        return self._blobs[begin:end]

    def _array(self, dtype: str, shape: list[Any], size: int) -> np.ndarray[Any, Any]:
        array_dtype = np.dtype(dtype)
        if array_dtype.kind not in NUMBERS or not all(type(count) is int and count >= 0 for count in shape):
            raise NotPlain("an array of objects; numbers are wanted")
        return np.frombuffer(self._blob(size), array_dtype).reshape(shape).copy()

    def _data(self, kind: type[Any], values: list[Any], depth: int) -> Any:
        made: Any = object.__new__(kind)
        for field, value in zip(dataclasses.fields(kind), values, strict=True):
            object.__setattr__(made, field.name, self.read(value, depth + 1))
        return made


def _class_of(module: str, name: str, base: type | None) -> type[Any]:
    """Return a class of audio_checks that is loaded: of the base, or a data class."""
    if module.partition(".")[0] == "audio_checks" and (loaded := sys.modules.get(module)):
        candidate = vars(loaded).get(name)
        if isinstance(candidate, type) and (
            issubclass(candidate, base) if base else dataclasses.is_dataclass(candidate)
        ):
            return candidate
    raise NotPlain(f"{module}.{name} may not come out of a sandbox")
