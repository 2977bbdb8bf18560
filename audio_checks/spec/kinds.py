"""The kinds of values in a delivery spec: how each is read, and its JSON Schema.

A value that is read comes back in its plain form (a level is always a float), so that two specs
that say the same have the same tables, and so the same hash.
"""

import math
import re
from collections.abc import Callable, Mapping, Sized
from dataclasses import dataclass
from typing import Any, Protocol

from audio_checks.errors import SpecError, SpecErrors
from audio_checks.metadata.bext import FIELDS as BEXT_FIELDS
from audio_checks.metadata.ixml import ASWG_FIELDS
from audio_checks.spec.patterns import PatternUnsupported, compiled

ANY = "any"  # lifts a limit
METADATA_FIELD = r"(bext|iXML|INFO|Vorbis)(\.[A-Za-z0-9_:-]+)+"
FOLDER = r"[A-Za-z0-9_() .-]+"
SLUG = r"[a-z0-9]+([_-][a-z0-9]+)*"
LONGEST_KEY = 200  # a glob of [files] is the longest
LONGEST_TEXT = 1_000
MOST_ERRORS = 20  # that are named at once


class Kind(Protocol):
    """A key's possible values."""

    def read(self, value: object, where: str) -> Any:
        """Return the value in its plain form, or raise SpecError naming the place."""

    def schema(self) -> dict[str, Any]:
        """Return the JSON Schema of the value."""


@dataclass(frozen=True)
class Number:
    """A finite number between two bounds, or a word instead of it: "any" where it limits."""

    low: float = -math.inf
    high: float = math.inf
    words: tuple[str, ...] = (ANY,)

    def read(self, value: object, where: str) -> float | str:
        """Return a float, or the word."""
        if isinstance(value, str) and value in self.words:
            return value
        if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
            expected = " or ".join(["a number", *(f'"{word}"' for word in self.words)])
            raise SpecError(f"wanted {expected}, found {_shown(value)}", where=where)
        if not self.low <= value <= self.high:
            raise SpecError(f"{value:g} is outside {self.low:g} to {self.high:g}", where=where)
        return float(value)

    def schema(self) -> dict[str, Any]:
        """Return a number within the bounds, or one of the words."""
        number: dict[str, Any] = {"type": "number"}
        if math.isfinite(self.low):
            number["minimum"] = self.low
        if math.isfinite(self.high):
            number["maximum"] = self.high
        return {"anyOf": [number, {"enum": list(self.words)}]} if self.words else number


@dataclass(frozen=True)
class Whole:
    """A whole number between two bounds, one of a few, or a word instead of it."""

    low: int
    high: int
    words: tuple[str, ...] = ()

    def read(self, value: object, where: str) -> int | str:
        """Return the whole number, or the word."""
        if isinstance(value, str) and value in self.words:
            return value
        if isinstance(value, bool) or not isinstance(value, int):
            expected = " or ".join(["a whole number", *(f'"{word}"' for word in self.words)])
            raise SpecError(f"wanted {expected}, found {_shown(value)}", where=where)
        if not self.low <= value <= self.high:
            raise SpecError(f"{value} is outside {self.low} to {self.high}", where=where)
        return value

    def schema(self) -> dict[str, Any]:
        """Return an integer within the bounds, or one of the words."""
        number = {"type": "integer", "minimum": self.low, "maximum": self.high}
        return {"anyOf": [number, {"enum": list(self.words)}]} if self.words else number


@dataclass(frozen=True)
class Word:
    """One of a few words; one that might be expected is refused with its reason."""

    words: tuple[str, ...]
    refused: tuple[str, str] = ("", "")

    def read(self, value: object, where: str) -> str:
        """Return the word."""
        word, reason = self.refused
        if word and value == word:
            raise SpecError(f"wanted {' or '.join(self.words)}, found {_shown(value)}; {reason}", where=where)
        if not isinstance(value, str) or value not in self.words:
            hint = _nearest(value, self.words) if isinstance(value, str) else ""
            raise SpecError(f"wanted one of {', '.join(self.words)}, found {_shown(value)}{hint}", where=where)
        return value

    def schema(self) -> dict[str, Any]:
        """Return the enumeration."""
        return {"enum": list(self.words)}


@dataclass(frozen=True)
class Text:
    """Any text, or "any" to lift what it limits."""

    regex: bool = False

    def read(self, value: object, where: str) -> str:
        """Return the text; a pattern must be one that can be matched in linear time."""
        if not isinstance(value, str) or not value:
            raise SpecError(f"wanted text, found {_shown(value)}", where=where)
        if len(value) > LONGEST_TEXT:
            raise SpecError(f"a text of {len(value):,} characters; at most {LONGEST_TEXT:,} are read", where=where)
        if self.regex and value != ANY:
            try:
                compiled(value)
            except PatternUnsupported as error:
                raise SpecError(str(error), where=where) from None
        return value

    def schema(self) -> dict[str, Any]:
        """Return a string."""
        return {
            "type": "string",
            "minLength": 1,
            "maxLength": LONGEST_TEXT,
            **({"format": "regex"} if self.regex else {}),
        }


@dataclass(frozen=True)
class Listed:
    """A list of values of one kind, without repeats; or "any" where it limits."""

    kind: Kind
    may_be_any: bool = True
    most: int = 100

    def read(self, value: object, where: str) -> list[Any] | str:
        """Return the list, or "any"."""
        if self.may_be_any and value == ANY:
            return ANY
        if not isinstance(value, list):
            expected = 'a list or "any"' if self.may_be_any else "a list"
            raise SpecError(f"wanted {expected}, found {_shown(value)}", where=where)
        if self.may_be_any and not value:
            raise SpecError('an empty list accepts nothing; "any" accepts everything', where=where)
        _ensure_few(value, self.most, where)
        return list(dict.fromkeys(self.kind.read(element, f"{where}[{index}]") for index, element in enumerate(value)))

    def schema(self) -> dict[str, Any]:
        """Return an array, or "any"."""
        array = {"type": "array", "items": self.kind.schema(), "maxItems": self.most}
        if self.may_be_any:
            array["minItems"] = 1
        return {"anyOf": [array, {"const": ANY}]} if self.may_be_any else array


@dataclass(frozen=True)
class Folder:
    """Folders below the top of a pack, with "/" between and "{category}" for a sound's own."""

    def read(self, value: object, where: str) -> str:
        """Return the folders."""
        too_long = isinstance(value, str) and len(value) > LONGEST_KEY
        if not isinstance(value, str) or too_long or (value and not all(map(_is_folder, value.split("/")))):
            raise SpecError(
                'wanted folders with "/" between, such as "Assets/Audio/{category}", '
                f"each of letters, digits and inner _ - . ( ) or spaces, found {_shown(value)}",
                where=where,
            )
        return value

    def schema(self) -> dict[str, Any]:
        """Return a string of that pattern."""
        return {"type": "string", "maxLength": LONGEST_KEY, "pattern": "^[A-Za-z0-9_() ./{}-]*$"}


def _is_folder(part: str) -> bool:
    plain = part.replace("{category}", "x")
    return re.fullmatch(FOLDER, plain) is not None and plain[0] not in " ." and plain[-1] not in " ."


@dataclass(frozen=True)
class Pair:
    """A list of exactly two values of one kind."""

    kind: Kind

    def read(self, value: object, where: str) -> list[Any]:
        """Return the two values."""
        if not isinstance(value, list) or len(value) != 2:
            raise SpecError(f"wanted a list of two numbers, found {_shown(value)}", where=where)
        return [self.kind.read(element, f"{where}[{index}]") for index, element in enumerate(value)]

    def schema(self) -> dict[str, Any]:
        """Return an array of two."""
        return {"type": "array", "items": self.kind.schema(), "minItems": 2, "maxItems": 2}


@dataclass(frozen=True)
class Table:
    """A table of known keys.

    `needed` are those that its schema requires; `needed_unless` is one more, unless another key has one of some values.
    """

    keys: Mapping[str, Kind]
    may_be_any: bool = False
    needed: tuple[str, ...] = ()
    needed_unless: tuple[str, str, tuple[str, ...]] | None = None

    def read(self, value: object, where: str) -> Any:
        """Return the table with each value read; an unknown key is refused with the nearest known one."""
        if self.may_be_any and value == ANY:
            return ANY
        table = _table(value, where)
        return each_read(table, lambda key, member: self._read_key(key, member, _join(where, key)))

    def _read_key(self, key: str, value: object, where: str) -> Any:
        if key not in self.keys:
            raise SpecError(f"no such key{_nearest(key, self.keys)}", where=where)
        return self.keys[key].read(value, where)

    def schema(self) -> dict[str, Any]:
        """Return a closed object."""
        table: dict[str, Any] = {
            "type": "object",
            "additionalProperties": False,
            "properties": {key: kind.schema() for key, kind in self.keys.items()},
        }
        if self.needed:
            table["required"] = list(self.needed)
        if self.needed_unless:
            key, other, values = self.needed_unless
            table["if"] = {"properties": {other: {"enum": list(values)}}, "required": [other]}
            table["else"] = {"required": [key]}
        return {"anyOf": [table, {"const": ANY}]} if self.may_be_any else table


@dataclass(frozen=True)
class Named:
    """A table whose keys are chosen by the writer: slugs, or any text."""

    kind: Kind
    slugs: bool = True
    most: int = 500

    def read(self, value: object, where: str) -> dict[str, Any]:
        """Return the table with each value read."""
        table = _table(value, where)
        _ensure_few(table, self.most, where)
        return each_read(table, lambda key, member: self._read_key(key, member, _join(where, key)))

    def _read_key(self, key: str, value: object, where: str) -> Any:
        if self.slugs and not re.fullmatch(SLUG, key):
            raise SpecError("a name here is lower-case letters and digits, joined by _ or -", where=where)
        return self.kind.read(value, where)

    def schema(self) -> dict[str, Any]:
        """Return an object of any names."""
        names = {"propertyNames": {"pattern": f"^{SLUG}$"}} if self.slugs else {}
        return {
            "type": "object",
            **names,
            "maxProperties": self.most,
            "additionalProperties": self.kind.schema(),
        }


@dataclass(frozen=True)
class Rows:
    """A list of tables, one or more; or "any"."""

    kind: Table
    most: int = 50

    def read(self, value: object, where: str) -> list[Any] | str:
        """Return the list with each table read, or "any"."""
        if value == ANY:
            return ANY
        if not isinstance(value, list) or not value:
            raise SpecError(f'wanted a list of tables or "any", found {_shown(value)}', where=where)
        _ensure_few(value, self.most, where)
        return [self.kind.read(element, f"{where}[{index}]") for index, element in enumerate(value)]

    def schema(self) -> dict[str, Any]:
        """Return an array of tables, or "any"."""
        array = {"type": "array", "items": self.kind.schema(), "minItems": 1, "maxItems": self.most}
        return {"anyOf": [array, {"const": ANY}]}


@dataclass(frozen=True)
class Flag:
    """Yes or no."""

    def read(self, value: object, where: str) -> bool:
        """Return the boolean."""
        if not isinstance(value, bool):
            raise SpecError(f"wanted true or false, found {_shown(value)}", where=where)
        return value

    def schema(self) -> dict[str, Any]:
        """Return a boolean."""
        return {"type": "boolean"}


@dataclass(frozen=True)
class MetadataField:
    """The name of a field that a file can say something in, such as `bext.Originator`."""

    def read(self, value: object, where: str) -> str:
        """Return the name; one of a group whose fields are known must be among them."""
        if not isinstance(value, str) or not re.fullmatch(METADATA_FIELD, value):
            raise SpecError(
                f"wanted a field such as bext.Originator, iXML.PROJECT, iXML.ASWG.catId or INFO.ICMT,"
                f" found {_shown(value)}",
                where=where,
            )
        for group, names in (("bext.", BEXT_FIELDS), ("iXML.ASWG.", tuple(sorted(ASWG_FIELDS)))):
            if value.startswith(group) and value.removeprefix(group) not in names:
                raise SpecError(f"no such field{_nearest(value.removeprefix(group), names, group)}", where=where)
        return value

    def schema(self) -> dict[str, Any]:
        """Return a string of the form."""
        return {"type": "string", "pattern": f"^{METADATA_FIELD}$"}


def each_read(table: Mapping[str, Any], read: Callable[[str, Any], Any]) -> dict[str, Any]:
    """Return a table with each value read; raise what is wrong with all of them at once."""
    done: dict[str, Any] = {}
    errors: list[SpecError] = []
    for key, value in table.items():
        try:
            done[key] = read(key, value)
        except SpecError as error:
            errors += error.errors if isinstance(error, SpecErrors) else [error]
        if len(errors) >= MOST_ERRORS:
            break
    if errors:
        raise errors[0] if len(errors) == 1 else SpecErrors(errors)
    return done


def _table(value: object, where: str) -> dict[str, object]:
    if not isinstance(value, dict):
        raise SpecError(f"wanted a table, found {_shown(value)}", where=where)
    for key in value:
        if len(key) > LONGEST_KEY:
            raise SpecError(f"a key of {len(key):,} characters; at most {LONGEST_KEY} are read", where=where)
    return value


def _ensure_few(values: Sized, most: int, where: str) -> None:
    if len(values) > most:
        raise SpecError(f"has {len(values):,} entries; at most {most:,} are read", where=where)


def _join(where: str, key: str) -> str:
    return f"{where}.{key}" if where else key


def _shown(value: object) -> str:
    text = f'"{value}"' if isinstance(value, str) else str(value)
    return text if len(text) <= 60 else text[:57] + "..."


def _nearest(key: str, keys: Mapping[str, object] | tuple[str, ...], before: str = "") -> str:
    from difflib import get_close_matches  # only where a mistake is reported

    return f'; the nearest known is "{before}{get_close_matches(key[:60], list(keys), n=1, cutoff=0.0)[0]}"'
