"""Samples that come with a bid."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects import postgresql

revision = "0056"
down_revision = "0055"
branch_labels = None
depends_on = None

SAMPLES = "hiring_samples"
JSON = sa.JSON().with_variant(postgresql.JSONB(), "postgresql")
KEYS = {
    "studio_id": "accounts_studios",
    "project_id": "projects_projects",
    "bid_id": "hiring_bids",
    "designer_id": "accounts_people",
}


def upgrade() -> None:
    op.create_table(
        SAMPLES,
        sa.Column("id", sa.Uuid(), nullable=False),
        *(sa.Column(name, sa.Uuid(), nullable=False) for name in KEYS),
        *(sa.Column(name, sa.String(), nullable=False) for name in ("line_key", "file_name", "media_type", "sha256")),
        sa.Column("file_bytes", sa.BigInteger(), nullable=False),
        sa.Column("state", sa.String(length=32), nullable=False),
        sa.Column("spec_version", sa.Integer()),
        sa.Column("findings", JSON, nullable=False),
        sa.Column("problem", sa.String(), nullable=False),
        sa.Column("added_at", sa.DateTime(timezone=True), nullable=False),
        *(
            sa.ForeignKeyConstraint([name], [f"{table}.id"], name=op.f(f"fk_{SAMPLES}_{name}"))
            for name, table in KEYS.items()
        ),
        sa.CheckConstraint("file_bytes > 0", name=op.f(f"ck_{SAMPLES}_not_empty")),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{SAMPLES}")),
    )
    for name in KEYS:
        op.create_index(op.f(f"ix_{SAMPLES}_{name}"), SAMPLES, [name])


def downgrade() -> None:
    op.drop_table(SAMPLES)
