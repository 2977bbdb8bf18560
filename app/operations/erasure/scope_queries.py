"""The rows that belong to a studio or a project, in any table: by its id, or by the row above."""

from collections.abc import Callable
from uuid import UUID

import sqlalchemy as sa

from app.core.db import Base

STUDIOS, PROJECTS = "accounts_studios", "projects_projects"
Scope = Callable[[sa.Table], sa.ColumnElement[bool] | None]
# Tables without a studio_id whose rows belong to a studio all the same: by which column, to which table.
BELOW = {"reviews_heard_takes": ("take_id", "deliveries_takes")}
KEPT = frozenset({"accounts_security_events"})  # of the studio too, whatever becomes of the project
ACROSS = frozenset({"builds_same_sounds", "builds_library_matches"})  # of two projects at once


def tables() -> list[sa.Table]:
    """Return all tables, those that others refer to first."""
    return list(Base.metadata.sorted_tables)


def of_studio(table: sa.Table, studio_id: UUID) -> sa.ColumnElement[bool] | None:
    """Return the rows of a table that are a studio's; None where none are."""
    if table.name == STUDIOS:
        return table.c.id == studio_id
    if "studio_id" in table.c:
        return table.c.studio_id == studio_id
    if table.name in BELOW:
        column, name = BELOW[table.name]
        above = Base.metadata.tables[name]
        return table.c[column].in_(sa.select(above.c.id).where(above.c.studio_id == studio_id))
    return None


def of_project(table: sa.Table, project_id: UUID) -> sa.ColumnElement[bool] | None:
    """Return the rows of a table that go with a project: its own, and those that refer to one and are no other's."""
    if table.name == PROJECTS:
        return table.c.id == project_id
    if table.name in KEPT:
        return None
    if "project_id" in table.c and table.name not in ACROSS:
        return table.c.project_id == project_id
    conditions = [table.c.project_id == project_id] if "project_id" in table.c else []
    for column in table.columns:
        for key in column.foreign_keys:
            above = key.column.table
            if above is table or above.name in (STUDIOS, PROJECTS, "accounts_people"):
                continue
            within = of_project(above, project_id)
            if within is not None:
                conditions.append(column.in_(sa.select(key.column).where(within)))
    return sa.or_(*conditions) if conditions else None


def self_references(table: sa.Table) -> list[sa.Column[object]]:
    """Return the columns by which rows of a table refer to rows of the same table."""
    return [column for column in table.columns if any(key.column.table is table for key in column.foreign_keys)]
