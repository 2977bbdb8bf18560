"""What sounds are like beside others, for fit with the palette."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects import postgresql

import app.kit.db

revision = "0014"
down_revision = "0013"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.create_table(
        "renders_timbres",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("sound_sha256", sa.String(), nullable=False),
        sa.Column("timbre", sa.JSON().with_variant(postgresql.JSONB(), "postgresql"), nullable=False),
        sa.Column("bands_db", sa.JSON().with_variant(postgresql.JSONB(), "postgresql"), nullable=False),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_renders_timbres_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_renders_timbres")),
        sa.UniqueConstraint("studio_id", "sound_sha256", name=op.f("uq_renders_timbres_studio_id_sound_sha256")),
    )
    with op.batch_alter_table("renders_timbres", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_renders_timbres_studio_id"), ["studio_id"], unique=False)


def downgrade() -> None:
    with op.batch_alter_table("renders_timbres", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_renders_timbres_studio_id"))

    op.drop_table("renders_timbres")
