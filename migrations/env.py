"""Alembic's entry: one history for SQLite and PostgreSQL, over every room's tables."""

from collections.abc import Iterator
from contextlib import contextmanager

import sqlalchemy as sa
from alembic import context

from app.core.db import Base
from app.tables import is_ours


@contextmanager
def without_foreign_keys(connection: sa.Connection) -> Iterator[None]:
    """Let SQLite put a new table in an old one's place: dropping the old one would look for rows that refer to it.

    SQLite ignores this setting inside a transaction, and SQLAlchemy begins one before it executes anything.
    """
    if connection.dialect.name != "sqlite":
        yield
        return
    driver = connection.connection.dbapi_connection
    driver.execute("PRAGMA foreign_keys=OFF")
    try:
        yield
        if broken := driver.execute("PRAGMA foreign_key_check").fetchmany(5):
            raise RuntimeError(f"after the migration rows refer to others that are not there: {broken}")
    finally:
        driver.execute("PRAGMA foreign_keys=ON")


with context.config.attributes["engine"].connect() as connection, without_foreign_keys(connection):
    context.configure(
        connection=connection,
        target_metadata=Base.metadata,
        render_as_batch=True,
        include_name=lambda name, kind, _parents: kind != "table" or is_ours(name or ""),
        compare_type=True,
    )
    with context.begin_transaction():
        context.run_migrations()
