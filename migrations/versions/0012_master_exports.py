"""Masters handed out with what is known of them."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects import postgresql

import app.kit.db

revision = "0012"
down_revision = "0011"
branch_labels = None
depends_on = None

JSON = sa.JSON().with_variant(postgresql.JSONB(), "postgresql")


def upgrade() -> None:
    op.create_table(
        "renders_master_exports",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("provenance", JSON, nullable=False),
        sa.Column("left", JSON, nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=True),
        sa.Column("file_bytes", sa.BigInteger(), nullable=True),
        sa.Column("refusal", sa.String(), nullable=True),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.CheckConstraint("sha256 is null or refusal is null", name=op.f("ck_renders_master_exports_made_or_refused")),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_renders_master_exports_project_id")
        ),
        sa.ForeignKeyConstraint(
            ["studio_id"], ["accounts_studios.id"], name=op.f("fk_renders_master_exports_studio_id")
        ),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_renders_master_exports_take_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_renders_master_exports")),
        sa.UniqueConstraint("take_id", "key", name=op.f("uq_renders_master_exports_take_id_key")),
    )
    with op.batch_alter_table("renders_master_exports", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_renders_master_exports_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_renders_master_exports_studio_id"), ["studio_id"], unique=False)


def downgrade() -> None:
    with op.batch_alter_table("renders_master_exports", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_renders_master_exports_studio_id"))
        batch_op.drop_index(batch_op.f("ix_renders_master_exports_project_id"))

    op.drop_table("renders_master_exports")
