"""Pictures of people."""

import sqlalchemy as sa
from alembic import op

revision = "0066"
down_revision = "0065"
branch_labels = None
depends_on = None

PEOPLE, PICTURES = "accounts_people", "accounts_pictures"


def upgrade() -> None:
    op.add_column(PEOPLE, sa.Column("picture_sha256", sa.String(), nullable=True))
    op.create_table(
        PICTURES,
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("content", sa.LargeBinary(), nullable=False),
        sa.Column("saved_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(
            ["person_id"], [f"{PEOPLE}.id"], name=op.f(f"fk_{PICTURES}_person_id"), ondelete="CASCADE"
        ),
        sa.PrimaryKeyConstraint("person_id", name=op.f(f"pk_{PICTURES}")),
    )


def downgrade() -> None:
    op.drop_table(PICTURES)
    op.drop_column(PEOPLE, "picture_sha256")
