"""Keys for `soundlist desk`."""

import sqlalchemy as sa
from alembic import op

revision = "0070"
down_revision = "0069"
branch_labels = None
depends_on = None

TOKENS = "accounts_desk_tokens"


def upgrade() -> None:
    op.create_table(
        TOKENS,
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("secret_sha256", sa.String(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("last_used_at", sa.DateTime(timezone=True), nullable=True),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f(f"fk_{TOKENS}_person_id")),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{TOKENS}")),
        sa.UniqueConstraint("secret_sha256", name=op.f(f"uq_{TOKENS}_secret_sha256")),
    )
    op.create_index(op.f(f"ix_{TOKENS}_person_id"), TOKENS, ["person_id"])


def downgrade() -> None:
    op.drop_table(TOKENS)
