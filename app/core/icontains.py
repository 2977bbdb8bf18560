"""Case-insensitive search in a text column."""

from typing import Any

import sqlalchemy as sa
from sqlalchemy.ext.compiler import compiles
from sqlalchemy.sql.compiler import SQLCompiler
from sqlalchemy.sql.functions import FunctionElement

ESCAPE = "\\"
Text = sa.orm.InstrumentedAttribute[str] | sa.orm.InstrumentedAttribute[str | None] | sa.ColumnElement[str]


class _ContainsAscii(FunctionElement[bool]):
    """Whether a text is like a pattern of ASCII: nothing else is compared without regard to case."""

    type = sa.Boolean()
    inherit_cache = True


def icontains(text: Text, word: str) -> sa.ColumnElement[bool]:
    """Return whether a text contains a word, ignoring case.

    An ASCII word is compared bytewise: folding the case of all languages costs either database twice as much.
    """
    escaped = word.replace(ESCAPE, ESCAPE * 2).replace("%", ESCAPE + "%").replace("_", ESCAPE + "_")
    pattern = f"%{escaped}%"
    return _ContainsAscii(text, pattern) if word.isascii() else text.ilike(pattern, escape=ESCAPE)


@compiles(_ContainsAscii, "postgresql")
def _by_ascii(element: _ContainsAscii, compiler: SQLCompiler, **options: Any) -> str:
    text, pattern = element.clauses
    return compiler.process(sa.collate(text, "C").ilike(pattern, escape=ESCAPE), **options)


@compiles(_ContainsAscii, "sqlite")
def _by_like(element: _ContainsAscii, compiler: SQLCompiler, **options: Any) -> str:
    text, pattern = element.clauses
    return compiler.process(text.like(pattern, escape=ESCAPE), **options)  # SQLite's LIKE folds ASCII alone
