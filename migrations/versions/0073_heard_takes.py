"""Which takes a person has heard; nothing counts as heard before."""

import sqlalchemy as sa
from alembic import op

revision = "0073"
down_revision = "0072"
branch_labels = None
depends_on = None

TABLE = "reviews_heard_takes"


def upgrade() -> None:
    op.create_table(
        TABLE,
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("heard_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f(f"fk_{TABLE}_take_id")),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f(f"fk_{TABLE}_person_id")),
        sa.PrimaryKeyConstraint("take_id", "person_id", name=op.f(f"pk_{TABLE}")),
    )


def downgrade() -> None:
    op.drop_table(TABLE)
