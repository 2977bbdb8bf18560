"""Checks whose result is not notified yet are found by an index."""

import sqlalchemy as sa
from alembic import op

revision = "0018"
down_revision = "0017"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column(
        "conformance_check_runs",
        sa.Column("needs_notification", sa.Boolean(), nullable=False, server_default=sa.false()),
    )
    op.create_index(
        "ix_conformance_check_runs_unnotified",
        "conformance_check_runs",
        ["project_id"],
        sqlite_where=sa.text("needs_notification"),
        postgresql_where=sa.text("needs_notification"),
    )


def downgrade() -> None:
    op.drop_index("ix_conformance_check_runs_unnotified", "conformance_check_runs")
    with op.batch_alter_table("conformance_check_runs", schema=None) as batch_op:
        batch_op.drop_column("needs_notification")
