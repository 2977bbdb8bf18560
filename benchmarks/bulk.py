"""Fills tables with very many rows: COPY on PostgreSQL, one statement for thousands of rows on SQLite."""

import json
from collections import defaultdict
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import Enum
from typing import Any

import sqlalchemy as sa
from sqlalchemy.schema import AddConstraint, CreateIndex, DropConstraint, DropIndex

from app.core.db import BEGIN, Base, Database

ROWS_AT_ONCE = 20_000
CACHE_KB = 1_000_000  # of SQLite's pages: keys in no order would be read from the disk again and again
BUILD_MEMORY = "SET LOCAL maintenance_work_mem = '512MB'"
Row = tuple[Any, ...]


class Bulk:
    """Gathers rows by table and writes them in large bites, those that others refer to first."""

    def __init__(self, database: Database, connection: Any) -> None:
        self._database = database
        self._connection = connection
        self._rows: dict[sa.Table, list[Row]] = defaultdict(list)
        self._columns: dict[sa.Table, list[tuple[str, Any, Callable[[Any], Any]]]] = {}
        self._gathered = 0
        self.written = 0

    def add(self, model: type[Base], **values: Any) -> None:
        """Add a row; columns left out get their default, or null."""
        table = model.__table__
        if table not in self._columns:
            self._columns[table] = [
                (column.name, column.default.arg if column.default is not None else None, self._bound(column))
                for column in table.columns
            ]
        row = []
        for name, default, bound in self._columns[table]:
            row.append(bound(values.pop(name) if name in values else default(None) if callable(default) else default))
        if values:
            raise ValueError(f"{table.name} has no column {', '.join(values)}")
        self._rows[table].append(tuple(row))
        self._gathered += 1
        if self._gathered >= ROWS_AT_ONCE:
            self.flush()

    def flush(self) -> None:
        """Write what is gathered; in a transaction of its own, since a log of all of it would be as large as all."""
        if self._database.is_sqlite:
            self._connection.cursor().execute("BEGIN IMMEDIATE")
        for table in Base.metadata.sorted_tables:
            if table in self._rows:
                self._write(table)
        self._connection.commit()
        self._gathered = 0

    def _bound(self, column: sa.Column[Any]) -> Callable[[Any], Any]:
        if isinstance(column.type, sa.JSON):  # a text is what was written as JSON already, once for very many rows
            return lambda value: value if value is None or isinstance(value, str) else json.dumps(value)
        if self._database.is_sqlite:
            processor = column.type.dialect_impl(self._database.engine.dialect).bind_processor(
                self._database.engine.dialect
            )
            return processor or (lambda value: value)
        return lambda value: value.value if isinstance(value, Enum) else value

    def _write(self, table: sa.Table) -> None:
        rows, names = self._rows.pop(table, []), [name for name, _, _ in self._columns[table]]
        cursor = self._connection.cursor()
        if self._database.is_sqlite:
            marks = ", ".join("?" * len(names))
            cursor.executemany(f"INSERT INTO {table.name} ({', '.join(names)}) VALUES ({marks})", rows)
        else:
            with cursor.copy(f"COPY {table.name} ({', '.join(names)}) FROM STDIN") as copy:
                for row in rows:
                    copy.write_row(row)
        self.written += len(rows)


@contextmanager
def filling(database: Database) -> Iterator[Bulk]:
    """Give a Bulk whose rows are there when the block ends."""
    connection = database.engine.raw_connection()
    try:
        if database.is_sqlite:
            connection.cursor().execute("PRAGMA synchronous=OFF")
            connection.cursor().execute(f"PRAGMA cache_size=-{CACHE_KB}")
        bulk = Bulk(database, connection)
        yield bulk
        bulk.flush()
    finally:
        connection.invalidate()


@contextmanager
def bare(database: Database) -> Iterator[None]:
    """Take indexes away for a block, and on PostgreSQL foreign keys: made at its end they cost a fraction."""
    tables = Base.metadata.sorted_tables
    stays = database.is_sqlite  # there a foreign key cannot go, and what it refers to must be unique
    indexes = [index for table in tables for index in table.indexes if not (stays and index.unique)]
    keys = [] if database.is_sqlite else [key for table in tables for key in table.foreign_key_constraints]
    with database.writing() as session:
        for gone in (*map(DropConstraint, keys), *map(DropIndex, indexes)):
            session.execute(gone)
    yield
    with database.writing() as session:
        session.execute(sa.text(f"PRAGMA cache_size=-{CACHE_KB}" if database.is_sqlite else BUILD_MEMORY))
        for made in (*map(CreateIndex, indexes), *map(AddConstraint, keys)):
            session.execute(made)


def analyse(database: Database) -> None:
    """Have PostgreSQL gather planner statistics, as autovacuum would; our servers run no ANALYZE on SQLite."""
    if not database.is_sqlite:
        with database.engine.connect().execution_options(**{BEGIN: ""}) as connection:
            connection.exec_driver_sql("VACUUM ANALYZE")
