"""Alembic's entry: one history for SQLite and PostgreSQL, over every room's tables."""

import sqlalchemy as sa
from alembic import context

from app.kit.db import Base
from app.tables import is_ours

connectable = context.config.attributes["engine"]

with connectable.connect() as connection:
    if connection.dialect.name == "sqlite":
        connection.execute(sa.text("PRAGMA foreign_keys=OFF"))
        connection.rollback()
    context.configure(
        connection=connection,
        target_metadata=Base.metadata,
        render_as_batch=True,
        include_name=lambda name, kind, _parents: kind != "table" or is_ours(name or ""),
        compare_type=True,
    )
    with context.begin_transaction():
        context.run_migrations()
