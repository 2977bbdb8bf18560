"""Writes `versions/0001_initial.py` from the models: `make migration`, until the first release."""

import hashlib
import re
import shutil
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


def release_of(checkout: Path) -> str | None:
    """Return the first release of a checkout, whose tables no later version may write anew; None before there is one."""
    command = ["git", "-C", str(checkout), "tag", "--list", "v[0-9]*", "--sort=version:refname"]
    if shutil.which("git") is None:
        return None
    tags = subprocess.run(command, check=False, capture_output=True, text=True).stdout.split()
    return tags[0] if tags else None


if __name__ == "__main__":
    if release := release_of(INITIAL.parent):
        sys.exit(
            f"{INITIAL.name} was released with {release}, and databases were made by it: leave it as it is, and add a file"
            " to migrations/versions that changes its tables, with its revision as down_revision"
        )
    write_initial(INITIAL)
