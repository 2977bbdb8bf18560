"""Bodies about columns of the project's own."""

from typing import Annotated
from uuid import UUID

from pydantic import Field

from app.core.web.http import Schema
from app.sound_lists.own_columns.rules import MAX_CHOICES, MAX_COLUMNS, ColumnKind

ColumnName = Annotated[str, Field(max_length=200)]


class ColumnRead(Schema):
    """A column of the project's own; each cue has its value under this name in `extra`."""

    id: UUID
    name: str
    kind: ColumnKind
    choices: list[str] = Field(description="Of a choice, in the order shown.")


class ColumnsRead(Schema):
    """The columns of the project's own, in order."""

    columns: list[ColumnRead]
    edition: str = Field(description="Send it back with a change, so that two editors notice each other.")


class ColumnWanted(Schema):
    """A column as it is wanted."""

    id: UUID | None = Field(None, description="Of a column that is there, perhaps under another name; null: a new one.")
    name: ColumnName
    kind: ColumnKind = ColumnKind.TEXT
    choices: list[ColumnName] = Field(default_factory=list, max_length=4 * MAX_CHOICES)


class ColumnsSet(Schema):
    """All columns of the project's own in their order; one that is left out is removed, and its values are kept."""

    columns: list[ColumnWanted] = Field(max_length=4 * MAX_COLUMNS)
    edition: str = Field(max_length=64, description="The edition that was read.")
