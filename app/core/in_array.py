"""A test whether a column is one of many values, sent as one parameter.

`IN (…)` has a parameter for each value, so each number of values is a new statement to compile and plan.
"""

import json
from collections.abc import Collection
from typing import Any, Self, TypeVar

import sqlalchemy as sa
from sqlalchemy import Dialect
from sqlalchemy.dialects.postgresql import ARRAY
from sqlalchemy.ext.compiler import compiles
from sqlalchemy.sql.compiler import SQLCompiler
from sqlalchemy.sql.functions import FunctionElement
from sqlalchemy.sql.operators import OperatorType
from sqlalchemy.types import TypeDecorator, TypeEngine

Value = TypeVar("Value")


class _Values(TypeDecorator[Collection[Any]]):
    """Values of one type: an array on PostgreSQL, a JSON list on SQLite."""

    impl = sa.String
    cache_ok = True

    def __init__(self, of: TypeEngine[Any]) -> None:
        super().__init__()
        self.of = of

    def load_dialect_impl(self, dialect: Dialect) -> TypeEngine[Any]:
        """Return the database's type for many values."""
        return ARRAY(self.of) if dialect.name == "postgresql" else dialect.type_descriptor(sa.String())

    def process_bind_param(self, value: Collection[Any] | None, dialect: Dialect) -> Any:
        """Convert the values to that database's types."""
        if dialect.name == "postgresql":
            return list(value or ())
        write = self.of.dialect_impl(dialect).bind_processor(dialect)
        return json.dumps([write(item) if write else item for item in value or ()])


class _InArray(FunctionElement[bool]):
    """A column and the values."""

    type = sa.Boolean()
    inherit_cache = True

    def self_group(self, against: OperatorType | None = None) -> Self:  # noqa: ARG002  SQLAlchemy gives it
        """Stand as it is: a comparison needs no `= 1` where there is no boolean type."""
        return self


def in_array(
    column: sa.orm.InstrumentedAttribute[Value] | sa.ColumnElement[Value], values: Collection[Any] | str
) -> _InArray:
    """Return the condition that a column is one of the values, however many there are.

    With a parameter's name the values are given when the statement is sent, so it is built once, which takes
    longer than to send it.
    """
    kind = _Values(column.type)
    if isinstance(values, str):
        return _InArray(column, sa.bindparam(values, type_=kind))
    return _InArray(column, sa.bindparam(None, values, type_=kind, unique=True))


@compiles(_InArray, "postgresql")
def _any(element: _InArray, compiler: SQLCompiler, **options: Any) -> str:
    column, values = element.clauses
    return compiler.process(column == sa.func.any(values), **options)


@compiles(_InArray, "sqlite")
def _in_json(element: _InArray, compiler: SQLCompiler, **options: Any) -> str:
    column, values = element.clauses
    listed = sa.select(sa.func.json_each(values).table_valued("value").c.value)
    return compiler.process(column.in_(listed), **options)
