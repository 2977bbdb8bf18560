"""The budgets of a project, one a currency."""

import sqlalchemy as sa
from alembic import op

revision = "0060"
down_revision = "0059"
branch_labels = None
depends_on = None

BUDGETS = "projects_budgets"


def upgrade() -> None:
    op.create_table(
        BUDGETS,
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("currency", sa.String(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("amount_minor", sa.BigInteger(), nullable=False),
        sa.Column("set_by", sa.Uuid(), nullable=False),
        sa.Column("set_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f(f"fk_{BUDGETS}_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f(f"fk_{BUDGETS}_studio_id")),
        sa.ForeignKeyConstraint(["set_by"], ["accounts_people.id"], name=op.f(f"fk_{BUDGETS}_set_by")),
        sa.CheckConstraint("amount_minor > 0", name=op.f(f"ck_{BUDGETS}_not_nothing")),
        sa.PrimaryKeyConstraint("project_id", "currency", name=op.f(f"pk_{BUDGETS}")),
    )
    op.create_index(op.f(f"ix_{BUDGETS}_studio_id"), BUDGETS, ["studio_id"])


def downgrade() -> None:
    op.drop_table(BUDGETS)
