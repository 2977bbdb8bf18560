"""Columns that most tables share. Who owns a row is named by the table, since those rooms stand above this one."""

from datetime import datetime
from uuid import UUID

from sqlalchemy import ForeignKey
from sqlalchemy.orm import Mapped, mapped_column

from app.core import clock


class StudioOwned:
    """A row of one studio, to which its row policy is bound."""

    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"), index=True)


class ProjectOwned(StudioOwned):
    """A row of one project of a studio."""

    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), index=True)


class Dated:
    """A row that knows when it was written."""

    created_at: Mapped[datetime] = mapped_column(default=clock.now)
