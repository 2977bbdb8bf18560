"""Columns of the project's own, stated without a database: which they may be, and which values fit them."""

from collections.abc import Iterator, Mapping, Sequence
from enum import StrEnum
from typing import NamedTuple
from uuid import UUID

from app.sound_lists.rules import NEW_CUE, folded, tidy_line, tidy_text
from audio_checks import EMPTY, MAX_FIGURE_CHARS, number_text, read_cell, read_number

MAX_COLUMNS = 20
MAX_NAME_CHARS = 60
MAX_CHOICES = 50
MAX_CHOICE_CHARS = 60
FIELDS = frozenset({*NEW_CUE, "number"})


class ColumnKind(StrEnum):
    """The kind of a column's values."""

    TEXT = "text"
    NUMBER = "number"
    YES_NO = "yes_no"
    CHOICE = "choice"
    DATE = "date"


class Column(NamedTuple):
    """A column of the project's own."""

    id: UUID | None  # None: not saved yet
    name: str
    kind: ColumnKind
    choices: Sequence[str] = ()  # of a choice, in the order shown


def key_of(name: str) -> str:
    """Return the key that two spellings of a column's name share."""
    return folded(tidy_line(name))


def kept_name(name: str) -> str:
    """Return the name under which a column that is not a field is kept; never that of a field."""
    plain = tidy_line(name)
    return f"{plain} (own)" if plain.lower() in FIELDS else plain


def by_key(columns: Sequence[Column]) -> dict[str, Column]:
    """Return columns by what the spellings of their names share."""
    return {key_of(column.name): column for column in columns}


def column_faults(columns: Sequence[Column]) -> Iterator[tuple[int, str, str]]:
    """Yield the faults of a set of columns: the place from 1, the field, and the fault in words."""
    seen: dict[str, int] = {}
    for position, column in enumerate(columns, start=1):
        key = key_of(column.name)
        if not column.name:
            yield position, "name", "enter a name for the column"
        elif len(column.name) > MAX_NAME_CHARS:
            yield position, "name", f"{len(column.name)} characters; at most {MAX_NAME_CHARS} are kept"
        elif column.name.lower() in FIELDS:
            yield position, "name", f'every list has a column "{column.name}"; choose another name'
        elif seen.setdefault(key, position) != position:
            yield position, "name", f'"{column.name}" is the name of column {seen[key]} too; choose another name'
        if column.kind is ColumnKind.CHOICE:
            yield from ((position, "choices", message) for message in _faults_of_choices(column.choices))
    if len(columns) > MAX_COLUMNS:
        yield MAX_COLUMNS + 1, "name", f"{len(columns)} columns; a list may have {MAX_COLUMNS} of its own"


def _faults_of_choices(choices: Sequence[str]) -> Iterator[str]:
    if not choices:
        yield "enter the choices, one a line"
    if len(choices) > MAX_CHOICES:
        yield f"{len(choices)} choices; at most {MAX_CHOICES} are kept"
    if long := next((choice for choice in choices if len(choice) > MAX_CHOICE_CHARS), None):
        yield f'"{long[:20]}…" has {len(long)} characters; a choice may have {MAX_CHOICE_CHARS}'
    keys = [key_of(choice) for choice in choices]
    if twice := next((choice for choice in choices if keys.count(key_of(choice)) > 1), None):
        yield f'"{twice}" is there twice'


def read_value(column: Column, text: str, day_first: bool | None = None) -> str:
    """Return a value as the list keeps it, empty for none; raise ValueError that says what was wanted and found."""
    plain = tidy_text(text)
    if column.kind is ColumnKind.TEXT or not plain:
        return plain
    if column.kind is ColumnKind.CHOICE:
        return _choice(column.choices, plain)
    if plain.lower() in EMPTY:
        return ""
    if column.kind is ColumnKind.DATE:
        return str(read_cell("due_on", plain, day_first=day_first) or "")
    if column.kind is ColumnKind.YES_NO:
        return "yes" if read_cell("placeholder", plain) else "no"
    if len(plain) > MAX_FIGURE_CHARS:
        raise ValueError(f'wanted a number such as 1.5, found "{plain[:40]}"')
    return number_text(read_number(plain))


def _choice(choices: Sequence[str], text: str) -> str:
    key = key_of(text)
    matched_choice = next((choice for choice in choices if key_of(choice) == key), None)
    if matched_choice is None:
        if text.lower() in EMPTY:
            return ""
        raise ValueError(f'wanted {", ".join(choices)}; found "{text[:40]}"')
    return matched_choice


def fitted(columns: Mapping[str, Column], extra: Mapping[str, str]) -> tuple[dict[str, str], list[tuple[str, str]]]:
    """Return a cue's values as the list keeps them, and what does not fit: the column, and the fault in words.

    `columns` is by `key_of`. A value of no column stays as text.
    """
    kept: dict[str, str] = {}
    faults: list[tuple[str, str]] = []
    for name, text in extra.items():
        column = columns.get(key_of(name))
        if column is None:
            kept[kept_name(name)] = tidy_text(text)
            continue
        try:
            kept[column.name] = read_value(column, text)
        except ValueError as error:
            kept[column.name] = text
            faults.append((column.name, str(error)))
    return {name: text for name, text in kept.items() if text}, faults
