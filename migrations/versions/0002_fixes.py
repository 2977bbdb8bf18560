"""Fixed copies of masters, and of a take that came from one, which take it fixes."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects import postgresql

import app.kit.db

revision = "0002"
down_revision = "0001"
branch_labels = None
depends_on = None


def upgrade() -> None:
    with op.batch_alter_table("deliveries_takes", schema=None) as batch_op:
        batch_op.add_column(sa.Column("fix_of_id", sa.Uuid(), nullable=True))
        batch_op.create_foreign_key(
            batch_op.f("fk_deliveries_takes_fix_of_id"), "deliveries_takes", ["fix_of_id"], ["id"]
        )
        batch_op.create_index(batch_op.f("ix_deliveries_takes_fix_of_id"), ["fix_of_id"], unique=False)

    op.create_table(
        "conformance_fixes",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column(
            "state",
            sa.Enum("making", "made", "refused", name="mendstate", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("asked_by", sa.Uuid(), nullable=True),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.Column("made_at", app.kit.db.UtcDateTime(timezone=True), nullable=True),
        sa.Column("refusal", sa.String(), nullable=True),
        sa.Column("sha256", sa.String(), nullable=True),
        sa.Column("fixed_bytes", sa.BigInteger(), nullable=True),
        sa.Column("made", sa.JSON().with_variant(postgresql.JSONB(), "postgresql"), nullable=False),
        sa.Column("used_by", sa.Uuid(), nullable=True),
        sa.Column("used_at", app.kit.db.UtcDateTime(timezone=True), nullable=True),
        sa.Column("new_take_id", sa.Uuid(), nullable=True),
        sa.CheckConstraint("(state = 'made') = (sha256 is not null)", name=op.f("ck_conformance_fixes_made_has_file")),
        sa.CheckConstraint(
            "(used_by is null) = (new_take_id is null)", name=op.f("ck_conformance_fixes_used_is_a_take")
        ),
        sa.ForeignKeyConstraint(["asked_by"], ["accounts_people.id"], name=op.f("fk_conformance_fixes_asked_by")),
        sa.ForeignKeyConstraint(
            ["new_take_id"], ["deliveries_takes.id"], name=op.f("fk_conformance_fixes_new_take_id")
        ),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_conformance_fixes_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_conformance_fixes_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_conformance_fixes_take_id")),
        sa.ForeignKeyConstraint(["used_by"], ["accounts_people.id"], name=op.f("fk_conformance_fixes_used_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_conformance_fixes")),
        sa.UniqueConstraint("take_id", "key", name=op.f("uq_conformance_fixes_take_id_key")),
    )
    with op.batch_alter_table("conformance_fixes", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_conformance_fixes_new_take_id"), ["new_take_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_conformance_fixes_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_conformance_fixes_sha256"), ["sha256"], unique=False)
        batch_op.create_index(batch_op.f("ix_conformance_fixes_studio_id"), ["studio_id"], unique=False)


def downgrade() -> None:
    op.drop_table("conformance_fixes")
    with op.batch_alter_table("deliveries_takes", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_deliveries_takes_fix_of_id"))
        batch_op.drop_constraint(batch_op.f("fk_deliveries_takes_fix_of_id"), type_="foreignkey")
        batch_op.drop_column("fix_of_id")
