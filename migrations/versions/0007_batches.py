"""Batches: every game file of a project rendered again, one by one."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects import postgresql

import app.kit.db

revision = "0007"
down_revision = "0006"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.create_table(
        "renders_batches",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column(
            "state",
            sa.Enum("planning", "running", "done", "cancelled", name="batchstate", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("spec_id", sa.Uuid(), nullable=True),
        sa.Column("targets", sa.JSON().with_variant(postgresql.JSONB(), "postgresql"), nullable=False),
        sa.Column("asked_by", sa.Uuid(), nullable=True),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.Column("ended_at", app.kit.db.UtcDateTime(timezone=True), nullable=True),
        sa.CheckConstraint(
            "(ended_at is null) = (state in ('planning', 'running'))", name=op.f("ck_renders_batches_ended_is_dated")
        ),
        sa.ForeignKeyConstraint(["asked_by"], ["accounts_people.id"], name=op.f("fk_renders_batches_asked_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_renders_batches_project_id")),
        sa.ForeignKeyConstraint(["spec_id"], ["projects_specs.id"], name=op.f("fk_renders_batches_spec_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_renders_batches_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_renders_batches")),
        sa.UniqueConstraint("project_id", "number", name=op.f("uq_renders_batches_project_id_number")),
    )
    with op.batch_alter_table("renders_batches", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_renders_batches_studio_id"), ["studio_id"], unique=False)

    op.create_table(
        "renders_batch_items",
        sa.Column("batch_id", sa.Uuid(), nullable=False),
        sa.Column("place", sa.Integer(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("target", sa.String(), nullable=False),
        sa.Column("category", sa.String(), nullable=False),
        sa.Column(
            "state",
            sa.Enum("waiting", "made", "kept", "refused", "left", name="itemstate", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("before_bytes", sa.BigInteger(), nullable=True),
        sa.Column("after_bytes", sa.BigInteger(), nullable=True),
        sa.Column("reason", sa.String(), nullable=False),
        sa.ForeignKeyConstraint(["batch_id"], ["renders_batches.id"], name=op.f("fk_renders_batch_items_batch_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_renders_batch_items_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_renders_batch_items_take_id")),
        sa.PrimaryKeyConstraint("batch_id", "place", name=op.f("pk_renders_batch_items")),
        sa.UniqueConstraint(
            "batch_id", "take_id", "target", name=op.f("uq_renders_batch_items_batch_id_take_id_target")
        ),
    )
    with op.batch_alter_table("renders_batch_items", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_renders_batch_items_studio_id"), ["studio_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_renders_batch_items_take_id"), ["take_id"], unique=False)
        batch_op.create_index("ix_renders_batch_items_waiting", ["batch_id", "state", "place"], unique=False)


def downgrade() -> None:
    with op.batch_alter_table("renders_batch_items", schema=None) as batch_op:
        batch_op.drop_index("ix_renders_batch_items_waiting")
        batch_op.drop_index(batch_op.f("ix_renders_batch_items_take_id"))
        batch_op.drop_index(batch_op.f("ix_renders_batch_items_studio_id"))

    op.drop_table("renders_batch_items")
    with op.batch_alter_table("renders_batches", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_renders_batches_studio_id"))

    op.drop_table("renders_batches")
