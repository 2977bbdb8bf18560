"""Rows of any table, read from one kind of database and written to the other without a change.

JSON is carried as its text, so that what is NULL and what is JSON's null stay apart.
"""

import base64
import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from datetime import date, datetime
from decimal import Decimal
from itertools import islice
from typing import Any
from uuid import UUID

import sqlalchemy as sa
from sqlalchemy.dialects.postgresql import JSONB
from sqlalchemy.exc import DataError, IntegrityError
from sqlalchemy.orm import Session

from app.core.db import UtcDateTime
from app.operations.erasure.scope_queries import self_references
from app.transfers.refusal import TransferRefused

Row = dict[str, Any]
AT_ONCE = 500


@dataclass
class Digest:
    """The number of rows of a table, and a sum over them that does not depend on their order."""

    rows: int = 0
    total: int = 0

    def add(self, table: sa.Table, row: Row) -> None:
        """Count a row."""
        text = json.dumps([_canonical(column, row[column.name]) for column in _sorted(table)])
        self.rows += 1
        self.total = (self.total + int.from_bytes(hashlib.sha256(text.encode()).digest())) % (1 << 256)

    @property
    def hex(self) -> str:
        """The sum in hexadecimal digits."""
        return f"{self.total:064x}"


def read(session: Session, table: sa.Table, where: sa.ColumnElement[bool] | None = None) -> Iterator[Row]:
    """Yield the rows of a table, without those below others of the same table coming before them."""
    is_sqlite = session.get_bind().dialect.name == "sqlite"
    select = sa.select(*(_read_column(column, is_sqlite=is_sqlite) for column in table.columns))
    if where is not None:
        select = select.where(where)
    above = self_references(table)
    if not above:
        yield from _streamed(session, select)
        return
    yield from _streamed(session, select.where(*(column.is_(None) for column in above)))
    waiting = list(_streamed(session, select.where(sa.or_(*(column.is_not(None) for column in above)))))
    while waiting:
        ids = {row["id"] for row in waiting}
        ready = [row for row in waiting if all(row[column.name] not in ids for column in above)]
        if not ready:
            raise TransferRefused(f"rows of {table.name} refer to one another in a circle; restore a backup")
        yield from ready
        waiting = [row for row in waiting if any(row[column.name] in ids for column in above)]


def write(session: Session, table: sa.Table, rows: Iterable[Row]) -> int:
    """Insert rows and return how many; raise TransferRefused where one is there already or cannot be stored."""
    is_sqlite = session.get_bind().dialect.name == "sqlite"
    columns = {column.name: _written_column(column, is_sqlite=is_sqlite) for column in table.columns}
    insert, count, following = sa.insert(table).values(columns), 0, iter(rows)
    while batch := list(islice(following, AT_ONCE)):
        try:
            session.connection().execute(insert, [_bound(row) for row in batch])
        except (IntegrityError, DataError) as error:
            reason = str(error.orig).strip().splitlines()[0]
            raise TransferRefused(f"{table.name}: rows cannot be stored here ({reason})") from error
        count += len(batch)
    return count


def digest(session: Session, table: sa.Table, where: sa.ColumnElement[bool] | None = None) -> Digest:
    """Return the digest of a table, or of some of its rows."""
    digested = Digest()
    for row in read(session, table, where):
        digested.add(table, row)
    return digested


def to_json(row: Row) -> str:
    """Return a row as one line of JSON."""
    return json.dumps({name: _to_json(value) for name, value in row.items()}, ensure_ascii=False)


def from_json(table: sa.Table, line: bytes) -> Row:
    """Return the row that a line of JSON holds; raise TransferRefused where it is not one of the table."""
    try:
        values = json.loads(line)
        if set(values) != {column.name for column in table.columns}:
            raise ValueError("its columns are not those of this version")
        return {column.name: _from_json(column, values[column.name]) for column in table.columns}
    except (ValueError, TypeError, AttributeError) as error:
        raise TransferRefused(f"a row of {table.name} cannot be read ({error}); the file was altered") from None


def _streamed(session: Session, select: sa.Select[Any]) -> Iterator[Row]:
    rows = session.connection().execute(select.execution_options(stream_results=True, yield_per=AT_ONCE))
    for row in rows.mappings():
        yield dict(row)


def _is_json(column: sa.Column[Any]) -> bool:
    return isinstance(column.type, sa.JSON)


def _is_text(column: sa.Column[Any]) -> bool:
    return _is_json(column) or isinstance(column.type, sa.Enum)


def _read_column(column: sa.Column[Any], *, is_sqlite: bool) -> sa.ColumnElement[Any]:
    if not _is_text(column):
        return column
    if _is_json(column) and not is_sqlite:
        return sa.cast(column, sa.Text).label(column.name)
    return sa.type_coerce(column, sa.Text).label(column.name)


def _written_column(column: sa.Column[Any], *, is_sqlite: bool) -> sa.ColumnElement[Any]:
    name = f"new_{column.name}"
    if not _is_text(column):
        return sa.bindparam(name, type_=column.type)
    text = sa.bindparam(name, type_=sa.Text())
    return sa.cast(text, JSONB) if _is_json(column) and not is_sqlite else text


def _bound(row: Row) -> Mapping[str, Any]:
    return {f"new_{name}": value for name, value in row.items()}


def _sorted(table: sa.Table) -> list[sa.Column[Any]]:
    return sorted(table.columns, key=lambda column: column.name)


def _canonical(column: sa.Column[Any], value: Any) -> Any:
    if value is not None and _is_json(column):
        return ["json", _normal(json.loads(value))]
    if isinstance(value, Decimal):
        return str(value.normalize())
    return _to_json(value)


def _normal(value: Any) -> Any:
    """Return JSON as both databases give it back: keys in order, no negative zero."""
    if isinstance(value, dict):
        return {key: _normal(value[key]) for key in sorted(value)}
    if isinstance(value, list):
        return [_normal(item) for item in value]
    return value + 0.0 if isinstance(value, float) else value


def _to_json(value: Any) -> Any:
    if isinstance(value, UUID | Decimal):
        return str(value)
    if isinstance(value, date):  # an instant too
        return value.isoformat()
    if isinstance(value, bytes):
        return base64.b64encode(value).decode()
    return value


def _from_json(column: sa.Column[Any], value: Any) -> Any:
    if value is None or _is_text(column):
        return value
    match column.type:
        case sa.Uuid():
            return UUID(value)
        case UtcDateTime():
            return datetime.fromisoformat(value)
        case sa.Date():
            return date.fromisoformat(value)
        case sa.LargeBinary():
            return base64.b64decode(value, validate=True)
        case sa.Numeric() if column.type.asdecimal:
            return Decimal(value)
    return value
