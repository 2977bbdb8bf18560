"""Brings a database to the tables that this version wants."""

from pathlib import Path

from alembic import command
from alembic.config import Config

from app import tables  # noqa: F401  every model, for the comparison
from app.kit import queue
from app.kit.db import Database

MIGRATIONS = Path(__file__).resolve().parent.parent / "migrations"


def alembic_config(database: Database) -> Config:
    """Return Alembic's configuration for a database; there is no ini file."""
    config = Config()
    config.set_main_option("script_location", str(MIGRATIONS))
    config.attributes["engine"] = database.engine
    return config


def migrate(database: Database, revision: str = "head") -> None:
    """Upgrade our tables and those of the job queue."""
    queue.create_tables(database)
    command.upgrade(alembic_config(database), revision)
