"""Checklists by category, what is checked of a take, and what blocks approval; no project has either until set."""

import sqlalchemy as sa
from alembic import op

revision = "0065"
down_revision = "0064"
branch_labels = None
depends_on = None

ITEMS, CHECKS, RULES = "reviews_checklist_items", "reviews_item_checks", "reviews_approval_rules"
PARENTS = {
    "studio_id": "accounts_studios",
    "project_id": "projects_projects",
    "take_id": "deliveries_takes",
    "item_id": ITEMS,
    **dict.fromkeys(("written_by", "checked_by", "set_by"), "accounts_people"),
}


def upgrade() -> None:
    op.create_table(
        ITEMS,
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("category", sa.String(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("place", sa.Integer(), nullable=False),
        sa.Column("written_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("removed_at", sa.DateTime(timezone=True), nullable=True),
        *_references(ITEMS, "studio_id", "project_id", "written_by"),
        sa.CheckConstraint("text <> ''", name=op.f(f"ck_{ITEMS}_has_text")),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{ITEMS}")),
        sa.UniqueConstraint("project_id", "category", "text", name=op.f(f"uq_{ITEMS}_project_id_category_text")),
    )
    op.create_index(op.f(f"ix_{ITEMS}_studio_id"), ITEMS, ["studio_id"])
    op.create_table(
        CHECKS,
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("item_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("checked_by", sa.Uuid(), nullable=False),
        sa.Column("checked_at", sa.DateTime(timezone=True), nullable=False),
        *_references(CHECKS, "take_id", "item_id", "studio_id", "project_id", "checked_by"),
        sa.PrimaryKeyConstraint("take_id", "item_id", name=op.f(f"pk_{CHECKS}")),
    )
    op.create_index(op.f(f"ix_{CHECKS}_studio_id"), CHECKS, ["studio_id"])
    op.create_index(op.f(f"ix_{CHECKS}_project_id"), CHECKS, ["project_id"])
    op.create_table(
        RULES,
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("blockers", sa.String(length=32), nullable=False),
        sa.Column("set_by", sa.Uuid(), nullable=False),
        sa.Column("set_at", sa.DateTime(timezone=True), nullable=False),
        *_references(RULES, "project_id", "studio_id", "set_by"),
        sa.PrimaryKeyConstraint("project_id", name=op.f(f"pk_{RULES}")),
    )
    op.create_index(op.f(f"ix_{RULES}_studio_id"), RULES, ["studio_id"])


def _references(table: str, *columns: str) -> list[sa.ForeignKeyConstraint]:
    return [
        sa.ForeignKeyConstraint([column], [f"{PARENTS[column]}.id"], name=op.f(f"fk_{table}_{column}"))
        for column in columns
    ]


def downgrade() -> None:
    op.drop_table(RULES)
    op.drop_table(CHECKS)
    op.drop_table(ITEMS)
