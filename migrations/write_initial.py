"""Writes `versions/0001_initial.py` from the models: `make migration`, until the first release."""

import hashlib
import re
import subprocess
import sys
from pathlib import Path
from typing import Any, Literal

import sqlalchemy as sa
from alembic.autogenerate import produce_migrations, render_python_code
from alembic.migration import MigrationContext

from app import tables  # noqa: F401  every model
from app.core.db import Base

INITIAL = Path(__file__).parent / "versions" / "0001_initial.py"
SOURCE = '''"""Every table. Written by `make migration` from the models; do not edit it by hand."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

revision = "0001_{digest}"  # with a digest of the tables: a database that has other tables is recognized
down_revision = None
branch_labels = None
depends_on = None

JSON = sa.JSON().with_variant(JSONB(), "postgresql")


def upgrade() -> None:
{upgrade}'''
WITHOUT_DEFAULTS = re.compile(r", (nullable=True|unique=False)(?=[,)])")


def write_initial(path: Path, models: sa.MetaData = Base.metadata) -> None:
    """Write the migration that creates every table of the models."""
    with sa.create_engine("sqlite://").connect() as connection:
        context = MigrationContext.configure(connection, opts={"target_metadata": models})
        operations = produce_migrations(context, models).upgrade_ops
        upgrade = render_python_code(operations, render_item=_render_type, migration_context=context)
    lines = [line for line in WITHOUT_DEFAULTS.sub("", upgrade).splitlines() if "###" not in line]
    upgrade = "\n".join(lines).replace("\n    )", ",\n    )") + "\n"
    digest = hashlib.sha256(upgrade.encode()).hexdigest()[:8]
    path.write_text(SOURCE.format(digest=digest, upgrade=upgrade), encoding="utf-8")
    subprocess.run([sys.executable, "-m", "ruff", "format", "--quiet", "--line-length=320", str(path)], check=True)


def _render_type(kind: str, item: Any, _context: Any) -> str | Literal[False]:
    """Render a type of ours as the type that the database has, so that the migration imports no model."""
    if kind == "type" and isinstance(item, sa.JSON):
        return "JSON"
    if kind == "type" and isinstance(item, sa.types.TypeDecorator):
        return f"sa.{item.impl!r}"
    return False


if __name__ == "__main__":
    write_initial(INITIAL)
