"""What game files are known by, for manifests."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects import postgresql

import app.kit.db

revision = "0021"
down_revision = "0020"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.create_table(
        "builds_fingerprints",
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("sound_sha256", sa.String(), nullable=False),
        sa.Column("fingerprint_version", sa.Integer(), nullable=False),
        sa.Column("entry", sa.JSON().with_variant(postgresql.JSONB(), "postgresql"), nullable=False),
        sa.Column("fingerprinted_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_fingerprints_studio_id")),
        sa.PrimaryKeyConstraint("studio_id", "sound_sha256", name=op.f("pk_builds_fingerprints")),
    )


def downgrade() -> None:
    op.drop_table("builds_fingerprints")
