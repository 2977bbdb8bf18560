"""Packs that were handed out with their files, and what each game file lost."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects import postgresql

import app.kit.db

revision = "0009"
down_revision = "0008"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.create_table(
        "builds_packs",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("target", sa.String(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("with_masters", sa.Boolean(), nullable=False),
        sa.Column("allow_missing", sa.Boolean(), nullable=False),
        sa.Column(
            "state",
            sa.Enum("sealing", "sealed", "refused", name="packstate", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("refusal", sa.String(), nullable=False),
        sa.Column("sealed_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.Column("sealed_at", app.kit.db.UtcDateTime(timezone=True), nullable=True),
        sa.CheckConstraint(
            "(state = 'sealed') = (sealed_at is not null)", name=op.f("ck_builds_packs_sealed_is_dated")
        ),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_builds_packs_project_id")),
        sa.ForeignKeyConstraint(["sealed_by"], ["accounts_people.id"], name=op.f("fk_builds_packs_sealed_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_packs_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_builds_packs")),
        sa.UniqueConstraint("project_id", "target", "number", name=op.f("uq_builds_packs_project_id_target_number")),
    )
    with op.batch_alter_table("builds_packs", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_builds_packs_studio_id"), ["studio_id"], unique=False)

    op.create_table(
        "builds_packed_files",
        sa.Column("pack_id", sa.Uuid(), nullable=False),
        sa.Column("place", sa.Integer(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("path", sa.String(), nullable=False),
        sa.Column(
            "kind", sa.Enum("game", "master", "key", name="filekind", native_enum=False, length=32), nullable=False
        ),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("size_bytes", sa.BigInteger(), nullable=False),
        sa.Column("pcm_sha256", sa.String(), nullable=True),
        sa.Column("render_id", sa.Uuid(), nullable=True),
        sa.ForeignKeyConstraint(["pack_id"], ["builds_packs.id"], name=op.f("fk_builds_packed_files_pack_id")),
        sa.ForeignKeyConstraint(["render_id"], ["renders_renders.id"], name=op.f("fk_builds_packed_files_render_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_packed_files_studio_id")),
        sa.PrimaryKeyConstraint("pack_id", "place", name=op.f("pk_builds_packed_files")),
        sa.UniqueConstraint("pack_id", "path", name=op.f("uq_builds_packed_files_pack_id_path")),
    )
    with op.batch_alter_table("builds_packed_files", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_builds_packed_files_studio_id"), ["studio_id"], unique=False)

    with op.batch_alter_table("renders_renders", schema=None) as batch_op:
        batch_op.add_column(sa.Column("loss", sa.JSON().with_variant(postgresql.JSONB(), "postgresql"), nullable=True))


def downgrade() -> None:
    with op.batch_alter_table("renders_renders", schema=None) as batch_op:
        batch_op.drop_column("loss")

    with op.batch_alter_table("builds_packed_files", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_builds_packed_files_studio_id"))

    op.drop_table("builds_packed_files")
    with op.batch_alter_table("builds_packs", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_builds_packs_studio_id"))

    op.drop_table("builds_packs")
