"""The record of the newest backup, so that every process can report how old it is."""

from datetime import datetime

import sqlalchemy as sa
import structlog
from sqlalchemy.orm import Mapped, Session, mapped_column

from app.core import clock
from app.core.db import Base, Database

log = structlog.get_logger(__name__)


class Backup(Base):
    """A finished backup; only the newest is kept."""

    __tablename__ = "core_backups"

    finished_at: Mapped[datetime] = mapped_column(primary_key=True)
    damaged_blobs: Mapped[int]  # left out, because their bytes are not what their names say


def record_backup(database: Database, damaged_blobs: int) -> None:
    """Record a finished backup in place of the one before; where that fails the backup itself stands."""
    try:
        with database.writing() as session:
            session.execute(sa.delete(Backup))
            session.add(Backup(finished_at=clock.now(), damaged_blobs=damaged_blobs))
    except sa.exc.SQLAlchemyError as error:
        log.warning("the time of this backup could not be recorded", error=str(getattr(error, "orig", None) or error))


def newest_backup(session: Session) -> Backup | None:
    """Return the newest backup that was finished, if there is any."""
    return session.scalar(sa.select(Backup))
