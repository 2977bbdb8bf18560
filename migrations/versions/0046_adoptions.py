"""Adoptions of shipped files, and the approvals that they made."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

import app.kit.db

revision = "0046"
down_revision = "0045"
branch_labels = None
depends_on = None

ADOPTIONS, VERDICTS = "deliveries_adoptions", "reviews_verdicts"
PEOPLE = ("opened_by", "adopted_by", "undone_by")
OTHERS = {"studio_id": "accounts_studios", "project_id": "projects_projects", "delivery_id": "deliveries_deliveries"}
CHECKS = {
    "adopted_by_a_person": "(adopted_at is null) = (adopted_by is null)",
    "undone_by_a_person": "(undone_at is null) = (undone_by is null)",
    "undone_after_adopted": "undone_at is null or adopted_at is not null",
}


def instant(name: str, *, nullable: bool = True) -> sa.Column:
    return sa.Column(name, app.kit.db.UtcDateTime(timezone=True), nullable=nullable)


def key(column: str, other: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{ADOPTIONS}_{column}"))


def upgrade() -> None:
    op.create_table(
        ADOPTIONS,
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("folder", sa.String(), nullable=False),
        sa.Column("files", sa.JSON().with_variant(JSONB(), "postgresql"), nullable=False),
        instant("created_at", nullable=False),
        sa.Column("delivery_id", sa.Uuid()),
        *(sa.Column(name, sa.Uuid()) for name in PEOPLE),
        instant("adopted_at"),
        instant("undone_at"),
        *(key(column, other) for column, other in OTHERS.items()),
        *(key(column, "accounts_people") for column in PEOPLE),
        *(sa.CheckConstraint(rule, name=op.f(f"ck_{ADOPTIONS}_{name}")) for name, rule in CHECKS.items()),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{ADOPTIONS}")),
    )
    op.create_index(op.f(f"ix_{ADOPTIONS}_studio_id"), ADOPTIONS, ["studio_id"])
    op.create_index(f"ix_{ADOPTIONS}_project_id_id", ADOPTIONS, ["project_id", "id"])
    with op.batch_alter_table(VERDICTS) as table:
        table.add_column(sa.Column("adoption_id", sa.Uuid()))
        table.create_foreign_key(op.f(f"fk_{VERDICTS}_adoption_id"), ADOPTIONS, ["adoption_id"], ["id"])
        table.create_index(op.f(f"ix_{VERDICTS}_adoption_id"), ["adoption_id"])


def downgrade() -> None:
    """Take it back; approvals by an adoption stay, as plain ones."""
    with op.batch_alter_table(VERDICTS) as table:
        table.drop_index(op.f(f"ix_{VERDICTS}_adoption_id"))
        table.drop_constraint(op.f(f"fk_{VERDICTS}_adoption_id"), type_="foreignkey")
        table.drop_column("adoption_id")
    op.drop_table(ADOPTIONS)
