"""Case-insensitive search in a text column."""

from typing import Any

import sqlalchemy as sa
from sqlalchemy.ext.compiler import compiles
from sqlalchemy.sql.compiler import SQLCompiler
from sqlalchemy.sql.functions import FunctionElement


class _Bytewise(FunctionElement[str]):
    """A text of which nothing but ASCII is compared without regard to case."""

    type = sa.String()
    inherit_cache = True


Text = sa.orm.InstrumentedAttribute[str] | sa.orm.InstrumentedAttribute[str | None] | sa.ColumnElement[str]


def icontains(text: Text, word: str) -> sa.ColumnElement[bool]:
    """Return whether a text contains a word, ignoring case.

    An ASCII word is compared bytewise: folding the case of all languages costs PostgreSQL twice as much.
    """
    escaped = word.replace("\\", "\\\\").replace("%", "\\%").replace("_", "\\_")
    looked_in = _Bytewise(text) if word.isascii() else text
    return looked_in.ilike(f"%{escaped}%", escape="\\")


@compiles(_Bytewise, "postgresql")
def _by_ascii(element: _Bytewise, compiler: SQLCompiler, **options: Any) -> str:
    (text,) = element.clauses
    return compiler.process(sa.collate(text, "C"), **options)


@compiles(_Bytewise, "sqlite")
def _as_it_is(element: _Bytewise, compiler: SQLCompiler, **options: Any) -> str:
    (text,) = element.clauses  # SQLite folds ASCII alone
    return compiler.process(text, **options)
