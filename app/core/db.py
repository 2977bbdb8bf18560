"""The database: one engine, sessions for requests and jobs, ids, and the types that both databases share."""

import select
import sqlite3
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from enum import StrEnum
from functools import cache
from pathlib import Path
from typing import Any, TypeVarTuple
from uuid import UUID

import psycopg
import sqlalchemy as sa
from pydantic_core import from_json
from sqlalchemy import Dialect, MetaData, event
from sqlalchemy.dialects import postgresql, sqlite
from sqlalchemy.dialects.postgresql import JSONB
from sqlalchemy.engine import make_url
from sqlalchemy.orm import DeclarativeBase, Session
from sqlalchemy.sql.dml import ReturningInsert
from uuid_utils import uuid7

from app.core.access_scope import AccessScope

CONSTRAINT_NAMES = {
    "ix": "ix_%(table_name)s_%(column_0_N_name)s",
    "uq": "uq_%(table_name)s_%(column_0_N_name)s",
    "ck": "ck_%(table_name)s_%(constraint_name)s",
    "fk": "fk_%(table_name)s_%(column_0_name)s",
    "pk": "pk_%(table_name)s",
}
BEGIN = "soundlist_begin"  # execution option: what a transaction begins with
READ_ONLY = "BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY"
BUSY_TIMEOUT_MS = 15_000
REQUEST_ROLE = "soundlist_request"  # on PostgreSQL: what a request's transaction runs as; it owns nothing
PERSON, PROJECT = "soundlist.person_id", "soundlist.project_id"  # settings that the row policies read
SET_REACH = "soundlist_set_reach"  # a function there: sets both, and looks up the reachable studios once
PREPARED = 400  # statements that a connection keeps prepared; requests of all kinds send some 300
Columns = TypeVarTuple("Columns")
UNAVAILABLE_STATES = frozenset(
    {"57P01", "57P02", "57P03", "53300"}
)  # shut down, crashed, not up yet, too many connections
UNIQUE_VIOLATION = "23505"
DISK_FULL = "53100"
CONFLICT_STATES = frozenset({"40001", "40P01"})  # serialization failure, deadlock
CONNECTION = {
    # Row policies raise the planner's cost estimates, and JIT compilation takes longer than any of our statements.
    "options": "-cjit=off",  # without a space, which pg_dump would read as a plus
    # A lost host is detected within half a minute.
    "connect_timeout": "10",
    "keepalives_idle": "10",
    "keepalives_interval": "5",
    "keepalives_count": "3",
    "tcp_user_timeout": "30000",
}
# Keys in a session's info: its reach, the reach set in its transaction, and its BEGIN statement.
REACH, APPLIED_REACH, BYPASSED, BEGIN_STATEMENT = "reach", "said reach", "bypassed", "begins"


def new_id() -> UUID:
    """Return a UUIDv7: unique, and ordered by the time of its making."""
    return UUID(bytes=uuid7().bytes)


def is_unavailable(error: BaseException) -> bool:
    """Whether an error means that the database is unreachable or out of connections at the moment."""
    if isinstance(error, sa.exc.TimeoutError):  # every connection of the pool is in use
        return True
    if not isinstance(error, sa.exc.DBAPIError):
        return False
    if isinstance(error.orig, sqlite3.OperationalError):
        return error.orig.sqlite_errorcode & 0xFF in (sqlite3.SQLITE_BUSY, sqlite3.SQLITE_IOERR)
    if error.connection_invalidated:
        return True
    state = getattr(error.orig, "sqlstate", None)
    return isinstance(error, sa.exc.OperationalError) and (
        state is None or state[:2] == "08" or state in UNAVAILABLE_STATES
    )


def is_full(error: BaseException) -> bool:
    """Whether an error means that the database's disk, or the size that it may have, is used up."""
    if not isinstance(error, sa.exc.DBAPIError):
        return False
    if isinstance(error.orig, sqlite3.Error):
        return getattr(error.orig, "sqlite_errorcode", 0) & 0xFF == sqlite3.SQLITE_FULL
    return getattr(error.orig, "sqlstate", None) == DISK_FULL


def is_conflict(error: BaseException) -> bool:
    """Whether the transaction was rolled back because of a conflict with another one."""
    if isinstance(error, sa.exc.IntegrityError):
        return getattr(error.orig, "sqlstate", None) == UNIQUE_VIOLATION or (
            isinstance(error.orig, sqlite3.IntegrityError)
            and error.orig.sqlite_errorcode in (sqlite3.SQLITE_CONSTRAINT_UNIQUE, sqlite3.SQLITE_CONSTRAINT_PRIMARYKEY)
        )
    return isinstance(error, sa.exc.DBAPIError) and getattr(error.orig, "sqlstate", None) in CONFLICT_STATES


class UtcDateTime(sa.types.TypeDecorator[datetime]):
    """An instant with its zone on both databases; SQLite alone would drop the zone."""

    impl = sa.DateTime(timezone=True)
    cache_ok = True

    def process_bind_param(self, value: datetime | None, dialect: Dialect) -> datetime | None:  # noqa: ARG002  SQLAlchemy gives it
        """Store in UTC; refuse an instant without a zone."""
        if value is None:
            return None
        if value.tzinfo is None:
            raise ValueError(f"{value!r} has no time zone")
        return value.astimezone(UTC)

    def process_result_value(self, value: datetime | None, dialect: Dialect) -> datetime | None:  # noqa: ARG002  SQLAlchemy gives it
        """Read back as UTC."""
        return None if value is None else value.replace(tzinfo=UTC) if value.tzinfo is None else value.astimezone(UTC)


class Base(DeclarativeBase):
    """The base of all our tables: named constraints, UTC instants, JSON that is JSONB on PostgreSQL."""

    metadata = MetaData(naming_convention=CONSTRAINT_NAMES)
    type_annotation_map = {  # noqa: RUF012  SQLAlchemy reads it once
        datetime: UtcDateTime(),
        StrEnum: sa.Enum(StrEnum, native_enum=False, length=32, values_callable=lambda kind: [e.value for e in kind]),
        dict[str, Any]: sa.JSON().with_variant(JSONB(), "postgresql"),
        list[str]: sa.JSON().with_variant(JSONB(), "postgresql"),
        list[float]: sa.JSON().with_variant(JSONB(), "postgresql"),
        list[dict[str, Any]]: sa.JSON().with_variant(JSONB(), "postgresql"),
        list[list[list[int]]]: sa.JSON(none_as_null=True).with_variant(JSONB(none_as_null=True), "postgresql"),
    }


class _Session(Session):
    """A session whose transactions begin within its reach, where it has one."""


class Database:
    """One engine and the two kinds of transaction on it."""

    def __init__(self, url: str, *, connections: int = 15) -> None:
        """Open nothing yet; PostgreSQL gets this many connections at most, the embedded database 40."""
        self.url = url
        self.session_info: dict[str, Any] = {}  # what every session of this database carries
        parsed = make_url(url)
        if parsed.drivername in ("postgresql", "postgres"):
            parsed = parsed.set(drivername="postgresql+psycopg")
        self.is_sqlite = parsed.get_backend_name() == "sqlite"
        if self.is_sqlite:
            if parsed.database:
                Path(parsed.database).parent.mkdir(parents=True, exist_ok=True)
            self.engine = sa.create_engine(
                parsed, pool_size=20, max_overflow=20, json_deserializer=from_json, hide_parameters=True
            )
            event.listen(self.engine, "connect", _prepare_sqlite)
        else:
            parsed = parsed.set(query={**CONNECTION, **parsed.query})
            # The connection that was used last is used next: it has the statements prepared that are sent most.
            self.engine = sa.create_engine(
                parsed,
                pool_size=connections,
                max_overflow=0,
                pool_timeout=10,
                pool_use_lifo=True,
                json_deserializer=from_json,
                hide_parameters=True,
            )
            event.listen(self.engine, "connect", _prepare_postgresql)
            event.listen(self.engine, "checkout", ensure_open)
        event.listen(self.engine, "begin", _begin)
        self._read, self._write = ("BEGIN", "BEGIN IMMEDIATE") if self.is_sqlite else (READ_ONLY, "BEGIN")
        self._reader = self.engine.execution_options(**{BEGIN: self._read})
        self._writer = self.engine.execution_options(**{BEGIN: self._write})
        self._plain = self.engine if self.is_sqlite else self.engine.execution_options(**{BEGIN: ""})
        self._alone = self._writer if self.is_sqlite else self._plain

    @contextmanager
    def reading(self, reach: AccessScope | None = None) -> Iterator[Session]:
        """Give a session that sees one moment and changes nothing: closing it rolls back.

        Without a reach it is the server's own: jobs, and what happens before it is known who comes.
        """
        with self._session(self._reader, self._read, reach) as session:
            yield session
            if not self.is_sqlite and session.in_transaction():
                # Nothing is to be kept, but after a rollback psycopg forgets every statement that it had prepared.
                with suppress(psycopg.Error):  # a broken connection is reported when the session closes
                    session.connection().connection.commit()

    @contextmanager
    def autocommit_session(self) -> Iterator[Session]:
        """Give a session of the server's own for one SELECT, which PostgreSQL is not asked to begin and to end."""
        with _Session(self._plain, info=self.session_info) as session:
            yield session

    def read_autocommit(
        self, statement: sa.Select[*tuple[Any, ...]], values: Mapping[str, Any]
    ) -> Sequence[sa.Row[*tuple[Any, ...]]]:
        """Return the rows of one SELECT of the server's own without a session, which costs as much as the SELECT."""
        with self._plain.connect() as connection:
            return connection.execute(statement, values).all()

    @contextmanager
    def writing(self, reach: AccessScope | None = None) -> Iterator[Session]:
        """Give a session whose work is committed when the block ends, and undone when it raises."""
        with self._session(self._writer, self._write, reach) as session, session.begin():
            yield session

    def write_autocommit(self, statement: sa.Insert | sa.Update, values: Mapping[str, Any]) -> int:
        """Run one statement of the server's own, which PostgreSQL is not asked to begin and to end; count its rows."""
        with self._alone.connect() as connection:
            written = connection.execute(statement, values)
            connection.commit()
            return written.rowcount

    def _session(self, engine: sa.Engine, begins: str, reach: AccessScope | None) -> Session:
        if reach is None:
            return _Session(engine, expire_on_commit=False, info=self.session_info)
        is_guarded = not self.is_sqlite
        session = _Session(self._plain if is_guarded else engine, expire_on_commit=False, info=self.session_info)
        session.info |= {REACH: reach, BEGIN_STATEMENT: begins}
        return session

    def dispose(self) -> None:
        """Close every connection."""
        self.engine.dispose()


def ensure_open(connection: Any, _record: Any, _proxy: Any) -> None:
    """Have a pool make new connections where PostgreSQL has ended this one.

    No statement is pending, so readable bytes are a termination message or a notice; only then is the connection
    tested, because a test before each transaction costs as much as a statement.
    """
    line = select.poll()
    line.register(connection.fileno(), select.POLLIN)
    if not line.poll(0):
        return
    try:
        connection.execute("")
        connection.rollback()
    except psycopg.OperationalError as error:
        raise sa.exc.InvalidatePoolError from error


def bind_reach(session: Session, reach: AccessScope) -> None:
    """Let a session that has not begun its transaction begin it within this reach."""
    if REACH in session.info:
        session.info[REACH] = reach


def set_access_scope(session: Session, reach: AccessScope) -> None:
    """Continue a request's transaction as another caller, once that caller is known."""
    if REACH not in session.info:
        return
    session.info[REACH] = reach
    if _is_guarded(session) and not session.info.get(BYPASSED):
        session.flush()
        connection = session.connection()
        if session.info[APPLIED_REACH] != reach:  # a new transaction has already set it
            _apply_reach(session, connection)


def insert_if_absent(
    session: Session,
    table: type[Base],
    values: Mapping[str, Any],
    *,
    unique: tuple[str, ...],
    where: sa.ColumnElement[bool] | None = None,
) -> bool:
    """Insert a row unless another has its unique columns, written by another transaction; return whether it is new.

    An INSERT that violates the unique index would undo all that its transaction did before; `where` is the unique
    index's own condition. On PostgreSQL it waits for a transaction that has just written the other row.
    """
    session.flush()  # rows that it refers to
    insert = _insert_if_absent(session.get_bind().dialect.name, table, unique, where)
    return session.scalar(insert, dict(values)) is not None


def insert_all_if_absent(
    session: Session, table: type[Base], rows: Sequence[Mapping[str, Any]], *, unique: tuple[str, ...]
) -> None:
    """Insert rows, those of the same columns by one statement, each unless another has its unique columns."""
    session.flush()
    insert = _insert_if_absent(session.get_bind().dialect.name, table, unique, None)
    alike: dict[frozenset[str], list[Mapping[str, Any]]] = defaultdict(list)
    for row in rows:
        alike[frozenset(row)].append(row)
    for some in alike.values():
        session.execute(insert, some)


@cache  # to build the statement takes longer than to run it
def _insert_if_absent(
    dialect: str, table: type[Base], unique: tuple[str, ...], where: sa.ColumnElement[bool] | None
) -> ReturningInsert[int]:
    insert = (postgresql if dialect == "postgresql" else sqlite).insert(table.__table__)
    if_absent: ReturningInsert[int] = insert.on_conflict_do_nothing(index_elements=unique, index_where=where).returning(
        sa.literal(1)
    )
    return if_absent


def row_of(new: Base) -> dict[str, Any]:
    """Return the columns that were set of an object that no session knows yet."""
    return {name: value for name, value in vars(new).items() if not name.startswith("_")}


@contextmanager
def bypass_row_policies(session: Session) -> Iterator[None]:
    """Let a block access any row: each use states why the caller's reach is too narrow. Blocks may nest."""
    if REACH not in session.info or session.info.get(BYPASSED):
        yield
        return
    is_guarded = _is_guarded(session)
    if is_guarded:
        session.flush()  # what came before is held to the caller's reach
        _send(session.connection(), "SET LOCAL ROLE NONE")
    session.info[BYPASSED] = True
    try:
        yield
        if is_guarded:
            session.flush()
    except BaseException:
        if is_guarded:
            session.rollback()  # the session must not go on with access to every row
        raise
    finally:
        session.info[BYPASSED] = False
    if is_guarded:
        _apply_reach(session, session.connection())  # which may be more now


def scope_in_force(session: Session) -> AccessScope | None:
    """Return the reach that holds a session's statements now; None for the server's own, and past the policies."""
    return None if session.info.get(BYPASSED) else session.info.get(REACH)


def _is_guarded(session: Session) -> bool:
    return REACH in session.info and session.get_bind().dialect.name == "postgresql"


@event.listens_for(_Session, "after_begin")
def _begin_with_reach(session: Session, _transaction: Any, connection: sa.Connection) -> None:
    if _is_guarded(session):
        _apply_reach(session, connection, session.info[BEGIN_STATEMENT])


def _apply_reach(session: Session, connection: sa.Connection, *before: str) -> None:
    reach: AccessScope = session.info[REACH]
    session.info[APPLIED_REACH] = reach
    settings = ", ".join(f"'{value}'" if value else "null" for value in (reach.person_id, reach.project_id))
    _send(connection, *before, f"SELECT {SET_REACH}({settings})", f"SET LOCAL ROLE {REQUEST_ROLE}")


def _send(connection: sa.Connection, *statements: str) -> None:
    """Send statements that answer nothing, all on one way."""
    connection.exec_driver_sql("; ".join(statements))


def _begin(connection: sa.Connection) -> None:
    if statement := connection.get_execution_options().get(BEGIN, "BEGIN"):
        connection.exec_driver_sql(statement)


def _prepare_postgresql(connection: Any, _record: Any) -> None:
    connection.autocommit = True  # we send BEGIN ourselves, together with the transaction's settings
    connection.prepared_max = PREPARED
    connection.prepare_threshold = 1  # sent once more: nearly all are sent again and again, and each time planned


def _prepare_sqlite(connection: Any, _record: Any) -> None:
    connection.isolation_level = None  # we send BEGIN ourselves
    cursor = connection.cursor()
    cursor.execute("PRAGMA journal_mode=WAL")
    cursor.execute("PRAGMA synchronous=FULL")
    cursor.execute("PRAGMA foreign_keys=ON")
    cursor.execute(f"PRAGMA busy_timeout={BUSY_TIMEOUT_MS}")
    cursor.close()
