"""Dry stems: sounds without their reverb, which takes are compared with."""

import sqlalchemy as sa
from alembic import op

import app.kit.db

revision = "0019"
down_revision = "0018"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.create_table(
        "deliveries_dry_stems",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("delivery_id", sa.Uuid(), nullable=False),
        sa.Column("stem", sa.String(), nullable=False),
        sa.Column("upload_id", sa.Uuid(), nullable=True),
        sa.Column("archive_id", sa.Uuid(), nullable=True),
        sa.Column("archive_entry", sa.Integer(), nullable=True),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("file_bytes", sa.BigInteger(), nullable=False),
        sa.Column("received_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.Column("withdrawn_at", app.kit.db.UtcDateTime(timezone=True), nullable=True),
        sa.CheckConstraint("file_bytes >= 0", name=op.f("ck_deliveries_dry_stems_size_known")),
        sa.ForeignKeyConstraint(
            ["archive_id"], ["deliveries_archives.id"], name=op.f("fk_deliveries_dry_stems_archive_id")
        ),
        sa.ForeignKeyConstraint(
            ["delivery_id"], ["deliveries_deliveries.id"], name=op.f("fk_deliveries_dry_stems_delivery_id")
        ),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_deliveries_dry_stems_project_id")
        ),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_deliveries_dry_stems_studio_id")),
        sa.ForeignKeyConstraint(["upload_id"], ["kit_uploads.id"], name=op.f("fk_deliveries_dry_stems_upload_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_deliveries_dry_stems")),
        sa.UniqueConstraint(
            "archive_id", "archive_entry", name=op.f("uq_deliveries_dry_stems_archive_id_archive_entry")
        ),
        sa.UniqueConstraint("upload_id", "stem", name=op.f("uq_deliveries_dry_stems_upload_id_stem")),
    )
    with op.batch_alter_table("deliveries_dry_stems", schema=None) as batch_op:
        batch_op.create_index("ix_deliveries_dry_stems_kept", ["studio_id", "sha256", "file_bytes"], unique=False)
        batch_op.create_index("ix_deliveries_dry_stems_of_takes", ["delivery_id", "stem"], unique=False)
        batch_op.create_index(batch_op.f("ix_deliveries_dry_stems_project_id"), ["project_id"], unique=False)


def downgrade() -> None:
    op.drop_table("deliveries_dry_stems")
