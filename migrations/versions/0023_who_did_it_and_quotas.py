"""Since when a take is fit for a verdict, whatever is checked again later, and who asked for its last check."""

import sqlalchemy as sa
from alembic import op

import app.kit.db

revision = "0023"
down_revision = "0021"
branch_labels = None
depends_on = None

TAKES = "deliveries_takes"


def upgrade() -> None:
    with op.batch_alter_table(TAKES) as takes:
        takes.add_column(sa.Column("conforming_since", app.kit.db.UtcDateTime(timezone=True), nullable=True))
        takes.add_column(sa.Column("returned_since", app.kit.db.UtcDateTime(timezone=True), nullable=True))
        takes.add_column(sa.Column("rechecked_by", sa.Uuid(), nullable=True))
        takes.create_foreign_key(op.f("fk_deliveries_takes_rechecked_by"), "accounts_people", ["rechecked_by"], ["id"])
    # What waits keeps the last day that both sides were shown.
    op.execute("UPDATE deliveries_takes SET conforming_since = state_since WHERE state = 'conforming'")


def downgrade() -> None:
    with op.batch_alter_table(TAKES) as takes:
        takes.drop_constraint(op.f("fk_deliveries_takes_rechecked_by"), type_="foreignkey")
        takes.drop_column("rechecked_by")
        takes.drop_column("returned_since")
        takes.drop_column("conforming_since")
