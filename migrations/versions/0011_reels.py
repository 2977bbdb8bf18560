"""Preview reels: all takes of a cue in a row."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects import postgresql

import app.kit.db

revision = "0011"
down_revision = "0010"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.create_table(
        "renders_reels",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("gap_ms", sa.Integer(), nullable=False),
        sa.Column("crossfade_ms", sa.Integer(), nullable=False),
        sa.Column("with_slates", sa.Boolean(), nullable=False),
        sa.Column("takes", sa.JSON().with_variant(postgresql.JSONB(), "postgresql"), nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("is_spoken", sa.Boolean(), nullable=False),
        sa.Column("duration_s", sa.Double(), nullable=True),
        sa.Column("sha256", sa.String(), nullable=True),
        sa.Column("file_bytes", sa.BigInteger(), nullable=True),
        sa.Column("refusal", sa.String(), nullable=True),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.CheckConstraint("sha256 is null or refusal is null", name=op.f("ck_renders_reels_made_or_refused")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_renders_reels_cue_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_renders_reels_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_renders_reels_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_renders_reels")),
        sa.UniqueConstraint("cue_id", "key", name=op.f("uq_renders_reels_cue_id_key")),
    )
    with op.batch_alter_table("renders_reels", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_renders_reels_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_renders_reels_studio_id"), ["studio_id"], unique=False)


def downgrade() -> None:
    with op.batch_alter_table("renders_reels", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_renders_reels_studio_id"))
        batch_op.drop_index(batch_op.f("ix_renders_reels_project_id"))

    op.drop_table("renders_reels")
