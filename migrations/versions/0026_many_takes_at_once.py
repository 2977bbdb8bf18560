"""Acts on many takes at once, which can be undone, and takes that were discarded."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects import postgresql

import app.kit.db

revision = "0026"
down_revision = "0025"
branch_labels = None
depends_on = None

KINDS = ("matched", "moved", "discarded", "restored")


def upgrade() -> None:
    op.add_column("deliveries_takes", sa.Column("discarded_at", app.kit.db.UtcDateTime(timezone=True)))
    op.create_table(
        "deliveries_takes_acts",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("kind", sa.Enum(*KINDS, name="takesactkind", native_enum=False, length=32), nullable=False),
        sa.Column("done_by", sa.Uuid(), nullable=False),
        sa.Column("done_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.Column("undone_at", app.kit.db.UtcDateTime(timezone=True)),
        sa.Column("takes", sa.JSON().with_variant(postgresql.JSONB(), "postgresql"), nullable=False),
        sa.ForeignKeyConstraint(
            ["studio_id"], ["accounts_studios.id"], name=op.f("fk_deliveries_takes_acts_studio_id")
        ),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_deliveries_takes_acts_project_id")
        ),
        sa.ForeignKeyConstraint(["done_by"], ["accounts_people.id"], name=op.f("fk_deliveries_takes_acts_done_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_deliveries_takes_acts")),
    )
    op.create_index("ix_deliveries_takes_acts_project", "deliveries_takes_acts", ["project_id", "id"])


def downgrade() -> None:
    op.drop_table("deliveries_takes_acts")
    op.drop_column("deliveries_takes", "discarded_at")
