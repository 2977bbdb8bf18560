"""Since when a take is fit for a verdict, and who asked for its last check; limits of a studio."""

import sqlalchemy as sa
from alembic import op

import app.kit.db

revision = "0023"
down_revision = "0022"
branch_labels = None
depends_on = None

TAKES = "deliveries_takes"


def upgrade() -> None:
    with op.batch_alter_table(TAKES) as takes:
        takes.add_column(sa.Column("conforming_since", app.kit.db.UtcDateTime(timezone=True), nullable=True))
        takes.add_column(sa.Column("returned_since", app.kit.db.UtcDateTime(timezone=True), nullable=True))
        takes.add_column(sa.Column("rechecked_by", sa.Uuid(), nullable=True))
        takes.create_foreign_key(op.f("fk_deliveries_takes_rechecked_by"), "accounts_people", ["rechecked_by"], ["id"])
    op.create_table(
        "accounts_quotas",
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("kind", sa.String(), nullable=False),
        sa.Column("maximum", sa.BigInteger(), nullable=False),
        sa.CheckConstraint("maximum >= 0", name=op.f("ck_accounts_quotas_maximum_known")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_accounts_quotas_studio_id")),
        sa.PrimaryKeyConstraint("studio_id", "kind", name=op.f("pk_accounts_quotas")),
    )
    # What waits keeps the last day that both sides were shown.
    op.execute("UPDATE deliveries_takes SET conforming_since = state_since WHERE state = 'conforming'")


def downgrade() -> None:
    op.drop_table("accounts_quotas")
    with op.batch_alter_table(TAKES) as takes:
        takes.drop_constraint(op.f("fk_deliveries_takes_rechecked_by"), type_="foreignkey")
        takes.drop_column("rechecked_by")
        takes.drop_column("returned_since")
        takes.drop_column("conforming_since")
