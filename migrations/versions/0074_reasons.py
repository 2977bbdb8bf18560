"""Reasons of verdicts, the studio's lists of them, and labels of alternates; verdicts before have no reasons."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

revision = "0074"
down_revision = "0073"
branch_labels = None
depends_on = None

LISTS, GIVEN, TAKES = "reviews_reason_lists", "reviews_given_reasons", "deliveries_takes"
WITH_REASONS = ("reviews_verdicts", "reviews_change_requests")
PARENTS = {
    "studio_id": "accounts_studios",
    "project_id": "projects_projects",
    "verdict_id": "reviews_verdicts",
    "change_request_id": "reviews_change_requests",
    **dict.fromkeys(("set_by", "labelled_by"), "accounts_people"),
}


def upgrade() -> None:
    words = sa.JSON().with_variant(JSONB(), "postgresql")
    for table_name in WITH_REASONS:
        with op.batch_alter_table(table_name) as table:
            table.add_column(sa.Column("reasons", words, nullable=False, server_default="[]"))
    with op.batch_alter_table(TAKES) as table:
        table.add_column(sa.Column("label", sa.String(), nullable=True))
        table.add_column(sa.Column("labelled_by", sa.Uuid(), nullable=True))
        table.add_column(sa.Column("labelled_at", sa.DateTime(timezone=True), nullable=True))
        table.create_foreign_key(op.f(f"fk_{TAKES}_labelled_by"), "accounts_people", ["labelled_by"], ["id"])
    op.create_table(
        LISTS,
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("kind", sa.String(length=32), nullable=False),
        sa.Column("reasons", words, nullable=False),
        sa.Column("set_by", sa.Uuid(), nullable=False),
        sa.Column("set_at", sa.DateTime(timezone=True), nullable=False),
        *_references(LISTS, "studio_id", "set_by"),
        sa.PrimaryKeyConstraint("studio_id", "kind", name=op.f(f"pk_{LISTS}")),
    )
    op.create_table(
        GIVEN,
        sa.Column("verdict_id", sa.Uuid(), nullable=False),
        sa.Column("reason", sa.String(), nullable=False),
        sa.Column("kind", sa.String(length=32), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("change_request_id", sa.Uuid(), nullable=True),
        *_references(GIVEN, "verdict_id", "studio_id", "project_id", "change_request_id"),
        sa.PrimaryKeyConstraint("verdict_id", "reason", name=op.f(f"pk_{GIVEN}")),
    )
    op.create_index(op.f(f"ix_{GIVEN}_studio_id"), GIVEN, ["studio_id"])
    op.create_index(f"ix_{GIVEN}_found", GIVEN, ["project_id", "kind", "reason", "verdict_id"])


def _references(table: str, *columns: str) -> list[sa.ForeignKeyConstraint]:
    return [
        sa.ForeignKeyConstraint([column], [f"{PARENTS[column]}.id"], name=op.f(f"fk_{table}_{column}"))
        for column in columns
    ]


def downgrade() -> None:
    op.drop_table(GIVEN)
    op.drop_table(LISTS)
    with op.batch_alter_table(TAKES) as table:
        table.drop_constraint(op.f(f"fk_{TAKES}_labelled_by"), type_="foreignkey")
        for column in ("labelled_at", "labelled_by", "label"):
            table.drop_column(column)
    for table_name in WITH_REASONS:
        with op.batch_alter_table(table_name) as table:
            table.drop_column("reasons")
