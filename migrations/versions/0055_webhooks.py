"""Webhooks and their calls."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

import app.kit.db

revision = "0055"
down_revision = "0054"
branch_labels = None
depends_on = None

WEBHOOKS, CALLS = "webhooks_webhooks", "webhooks_calls"


def instant(name: str, *, nullable: bool = True) -> sa.Column:
    return sa.Column(name, app.kit.db.UtcDateTime(timezone=True), nullable=nullable)


def key(table: str, column: str, other: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{table}_{column}"))


def index(table: str, *columns: str) -> None:
    for column in columns:
        op.create_index(op.f(f"ix_{table}_{column}"), table, [column])


def upgrade() -> None:
    op.create_table(
        WEBHOOKS,
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid()),
        sa.Column("url", sa.String(), nullable=False),
        sa.Column("form", sa.String(length=32), nullable=False),
        sa.Column("events", sa.JSON().with_variant(JSONB(), "postgresql"), nullable=False),
        sa.Column("secret_number", sa.Integer(), nullable=False),
        instant("rotated_at"),
        instant("failing_since"),
        instant("disabled_at"),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        instant("created_at", nullable=False),
        key(WEBHOOKS, "studio_id", "accounts_studios"),
        key(WEBHOOKS, "project_id", "projects_projects"),
        key(WEBHOOKS, "created_by", "accounts_people"),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{WEBHOOKS}")),
    )
    index(WEBHOOKS, "studio_id", "project_id")
    op.create_table(
        CALLS,
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("webhook_id", sa.Uuid(), nullable=False),
        *(sa.Column(name, sa.String(), nullable=False) for name in ("event_id", "event", "body")),
        sa.Column("state", sa.String(length=32), nullable=False),
        sa.Column("tries", sa.Integer(), nullable=False),
        sa.Column("next_attempt", sa.Uuid()),
        instant("next_at"),
        instant("tried_at"),
        sa.Column("took_ms", sa.Integer()),
        sa.Column("status", sa.Integer()),
        *(sa.Column(name, sa.String(), nullable=False) for name in ("answer", "problem")),
        instant("created_at", nullable=False),
        key(CALLS, "studio_id", "accounts_studios"),
        key(CALLS, "webhook_id", WEBHOOKS),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{CALLS}")),
        sa.UniqueConstraint("webhook_id", "event_id", name=op.f(f"uq_{CALLS}_webhook_id_event_id")),
    )
    index(CALLS, "studio_id", "created_at")
    op.create_index(f"ix_{CALLS}_log", CALLS, ["webhook_id", "id"])


def downgrade() -> None:
    op.drop_table(CALLS)
    op.drop_table(WEBHOOKS)
