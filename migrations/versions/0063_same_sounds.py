"""Fingerprints of masters, and the takes of different projects that hold the same sound."""

import sqlalchemy as sa
from alembic import op

revision = "0063"
down_revision = "0062"
branch_labels = None
depends_on = None

FINGERPRINTS, SAME = "builds_master_fingerprints", "builds_same_sounds"


def upgrade() -> None:
    op.create_table(
        FINGERPRINTS,
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("sound_sha256", sa.String(), nullable=False),
        sa.Column("fingerprint_version", sa.Integer(), nullable=False),
        sa.Column("pcm_sha256", sa.String(), nullable=True),
        sa.Column("sample_rate_hz", sa.Integer(), nullable=False),
        sa.Column("fingerprint", sa.LargeBinary(), nullable=True),
        sa.Column("moments", sa.LargeBinary(), nullable=False),
        sa.Column("made_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f(f"fk_{FINGERPRINTS}_studio_id")),
        sa.PrimaryKeyConstraint("studio_id", "sound_sha256", name=op.f(f"pk_{FINGERPRINTS}")),
    )
    op.create_table(
        SAME,
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("other_take_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("score", sa.Double(), nullable=False),
        sa.Column("gain_db", sa.Double(), nullable=False),
        sa.Column("has_same_samples", sa.Boolean(), nullable=False),
        sa.Column("is_trimmed", sa.Boolean(), nullable=False),
        sa.Column("is_resampled", sa.Boolean(), nullable=False),
        sa.Column("found_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f(f"fk_{SAME}_take_id")),
        sa.ForeignKeyConstraint(["other_take_id"], ["deliveries_takes.id"], name=op.f(f"fk_{SAME}_other_take_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f(f"fk_{SAME}_studio_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f(f"fk_{SAME}_project_id")),
        sa.PrimaryKeyConstraint("take_id", "other_take_id", name=op.f(f"pk_{SAME}")),
    )
    op.create_index(op.f(f"ix_{SAME}_studio_id"), SAME, ["studio_id"])


def downgrade() -> None:
    op.drop_table(SAME)
    op.drop_table(FINGERPRINTS)
