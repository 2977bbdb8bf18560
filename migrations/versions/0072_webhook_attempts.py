"""Each attempt at a message of a webhook, with what was answered."""

import sqlalchemy as sa
from alembic import op

revision = "0072"
down_revision = "0071"
branch_labels = None
depends_on = None

ATTEMPTS = "webhooks_attempts"


def upgrade() -> None:
    op.create_table(
        ATTEMPTS,
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("call_id", sa.Uuid(), nullable=False),
        sa.Column("tried_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("took_ms", sa.Integer(), nullable=False),
        sa.Column("status", sa.Integer(), nullable=True),
        sa.Column("answer", sa.String(), nullable=False),
        sa.Column("problem", sa.String(), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f(f"fk_{ATTEMPTS}_studio_id")),
        sa.ForeignKeyConstraint(["call_id"], ["webhooks_calls.id"], name=op.f(f"fk_{ATTEMPTS}_call_id")),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{ATTEMPTS}")),
    )
    for column in ("studio_id", "call_id"):
        op.create_index(op.f(f"ix_{ATTEMPTS}_{column}"), ATTEMPTS, [column])


def downgrade() -> None:
    op.drop_table(ATTEMPTS)
