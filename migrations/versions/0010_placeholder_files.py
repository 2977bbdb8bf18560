"""Placeholder files for sounds that are not accepted yet."""

import sqlalchemy as sa
from alembic import op

import app.kit.db

revision = "0010"
down_revision = "0009"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.create_table(
        "builds_placeholder_files",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("variation", sa.Integer(), nullable=False),
        sa.Column("target", sa.String(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=True),
        sa.Column("file_bytes", sa.BigInteger(), nullable=True),
        sa.Column("is_spoken", sa.Boolean(), nullable=False),
        sa.Column("refusal", sa.String(), nullable=True),
        sa.Column("made_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.CheckConstraint(
            "(refusal is null) = (sha256 is not null)", name=op.f("ck_builds_placeholder_files_made_or_refused")
        ),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_builds_placeholder_files_cue_id")),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_builds_placeholder_files_project_id")
        ),
        sa.ForeignKeyConstraint(
            ["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_placeholder_files_studio_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_builds_placeholder_files")),
        sa.UniqueConstraint(
            "cue_id", "variation", "target", name=op.f("uq_builds_placeholder_files_cue_id_variation_target")
        ),
    )
    with op.batch_alter_table("builds_placeholder_files", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_builds_placeholder_files_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_builds_placeholder_files_studio_id"), ["studio_id"], unique=False)

    with op.batch_alter_table("builds_packs", schema=None) as batch_op:
        batch_op.add_column(sa.Column("placeholders", sa.Boolean(), nullable=False, server_default=sa.false()))


def downgrade() -> None:
    with op.batch_alter_table("builds_packs", schema=None) as batch_op:
        batch_op.drop_column("placeholders")

    with op.batch_alter_table("builds_placeholder_files", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_builds_placeholder_files_studio_id"))
        batch_op.drop_index(batch_op.f("ix_builds_placeholder_files_project_id"))

    op.drop_table("builds_placeholder_files")
