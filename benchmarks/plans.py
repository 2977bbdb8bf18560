"""How a database says that it will find what a statement asks for."""

import re
import threading
from collections.abc import Collection, Iterator
from contextlib import contextmanager
from itertools import pairwise
from typing import Any

import sqlalchemy as sa

import app.tables  # noqa: F401  every model, for its indexes
from app.core.db import Base

Statement = tuple[str, Any]
INDEX = re.compile(r"(?:USING (?:COVERING )?INDEX|Scan(?: Backward)? using|Bitmap Index Scan on) (\w+)")
ASKING = {"MainThread", "AnyIO worker thread"}  # names of the threads that ask and answer; a worker's have others
# Read from one end to the other they are what is asked for, and little.
PARTIAL = {
    str(index.name)
    for table in Base.metadata.tables.values()
    for index in table.indexes
    if index.dialect_options["postgresql"]["where"] is not None
}


@contextmanager
def heard(engine: sa.Engine) -> Iterator[list[Statement]]:
    """Gather the statements that are executed during a block, but for those of a worker in this process."""
    statements: list[Statement] = []

    def hear(_connection: Any, _cursor: Any, statement: str, parameters: Any, *_: Any) -> None:
        if threading.current_thread().name in ASKING:
            statements.append((statement, parameters))

    sa.event.listen(engine, "before_cursor_execute", hear)
    yield statements
    sa.event.remove(engine, "before_cursor_execute", hear)


def plan_of(connection: sa.Connection, statement: Statement) -> list[str]:
    """Return the lines of what the database says it will do."""
    text, parameters = statement
    if connection.dialect.name == "sqlite":
        return [row[3] for row in connection.exec_driver_sql(f"EXPLAIN QUERY PLAN {text}", parameters)]
    return [row[0] for row in connection.exec_driver_sql(f"EXPLAIN {text}", parameters)]


def indexes_used(connection: sa.Connection, statement: Statement, tables: Collection[str]) -> set[str]:
    """Return the indexes by which a statement finds rows of the tables."""
    if not _is_read(statement):
        return set()
    found = {match[1] for line in plan_of(connection, statement) for match in INDEX.finditer(line)}
    return {index for index in found if any(f"_{table}_" in f"{index}_" for table in tables)}


def _is_read(statement: Statement) -> bool:
    return bool(re.match(r"\s*(SELECT|WITH)\b", statement[0])) and "set_config" not in statement[0]


def whole_reads(connection: sa.Connection, statement: Statement, tables: Collection[str]) -> set[str]:
    """Return those of the tables, or of their indexes, that a statement reads from one end to the other."""
    if not _is_read(statement):
        return set()
    plan = plan_of(connection, statement)
    if connection.dialect.name == "sqlite":
        names = [found.group(1) for line in plan if (found := re.match(r"SCAN (\w+)", line))]
    else:
        names = [
            found.group(1)
            for line, following in pairwise([*plan, ""])
            if (found := re.search(r"(?:Seq|Index|Index Only) Scan(?: Backward)?(?: using \w+)? on (\w+)", line))
            and "Index Cond" not in following
            and not any(name in line for name in PARTIAL)
        ]
    names = [re.sub(r"_\d+$", "", name) for name in names]
    return {table for table in tables if any(name == table or f"_{table}_" in name for name in names)}
