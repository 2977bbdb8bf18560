"""Fills tables with very many rows: COPY on PostgreSQL, one statement for thousands of rows on SQLite."""

import json
from collections import defaultdict
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import Enum
from typing import Any

import sqlalchemy as sa

from app.kit.db import Base, Database

ROWS_AT_ONCE = 20_000
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
        """Write what is gathered."""
        for table in Base.metadata.sorted_tables:
            if table in self._rows:
                self._write(table)
        self._gathered = 0

    def _bound(self, column: sa.Column[Any]) -> Callable[[Any], Any]:
        if self._database.is_sqlite:
            processor = column.type.dialect_impl(self._database.engine.dialect).bind_processor(
                self._database.engine.dialect
            )
            return processor or (lambda value: value)
        if isinstance(column.type, sa.JSON):
            return lambda value: None if value is None else json.dumps(value)
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
def filling(database: Database, *, analysed: bool = True) -> Iterator[Bulk]:
    """Give a Bulk whose rows are there when the block ends, with fresh statistics for the planner if wanted."""
    connection = database.engine.raw_connection()
    try:
        cursor = connection.cursor()
        if database.is_sqlite:
            cursor.execute("PRAGMA synchronous=OFF")
            cursor.execute("BEGIN IMMEDIATE")
        bulk = Bulk(database, connection)
        yield bulk
        bulk.flush()
        if database.is_sqlite:
            cursor.execute("COMMIT")
        else:
            connection.commit()
    finally:
        connection.invalidate()
    if not analysed:
        return
    with database.engine.connect().execution_options(isolation_level="AUTOCOMMIT") as analysing:
        analysing.exec_driver_sql("ANALYZE" if database.is_sqlite else "VACUUM ANALYZE")
