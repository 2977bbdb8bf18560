"""Approvers of categories, deputies, and for whom a deputy's verdict was."""

import sqlalchemy as sa
from alembic import op

revision = "0039"
down_revision = "0038"
branch_labels = None
depends_on = None

CATEGORIES, DEPUTIES, VERDICTS = "projects_category_approvers", "projects_deputies", "reviews_verdicts"


def key(table: str, column: str, other: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{table}_{column}"))


def upgrade() -> None:
    op.create_table(
        CATEGORIES,
        *(sa.Column(name, sa.Uuid(), nullable=False) for name in ("id", "studio_id", "project_id")),
        sa.Column("category", sa.String(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=True),
        sa.Column("named_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("category <> ''", name=op.f(f"ck_{CATEGORIES}_names_a_category")),
        key(CATEGORIES, "studio_id", "accounts_studios"),
        key(CATEGORIES, "project_id", "projects_projects"),
        key(CATEGORIES, "person_id", "accounts_people"),
        key(CATEGORIES, "named_by", "accounts_people"),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{CATEGORIES}")),
    )
    op.create_table(
        DEPUTIES,
        *(sa.Column(name, sa.Uuid(), nullable=False) for name in ("id", "studio_id", "project_id")),
        *(sa.Column(name, sa.Uuid(), nullable=False) for name in ("person_id", "deputy_id")),
        *(sa.Column(name, sa.Date(), nullable=False) for name in ("from_on", "until_on")),
        sa.Column("named_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("withdrawn_at", sa.DateTime(timezone=True), nullable=True),
        sa.CheckConstraint("until_on >= from_on", name=op.f(f"ck_{DEPUTIES}_ends_after_it_began")),
        sa.CheckConstraint("deputy_id <> person_id", name=op.f(f"ck_{DEPUTIES}_two_people")),
        key(DEPUTIES, "studio_id", "accounts_studios"),
        key(DEPUTIES, "project_id", "projects_projects"),
        *(key(DEPUTIES, column, "accounts_people") for column in ("person_id", "deputy_id", "named_by")),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{DEPUTIES}")),
    )
    for table in (CATEGORIES, DEPUTIES):
        for column in ("studio_id", "project_id"):
            op.create_index(op.f(f"ix_{table}_{column}"), table, [column])
    with op.batch_alter_table(VERDICTS) as table:
        table.add_column(sa.Column("on_behalf_of", sa.Uuid(), nullable=True))
        table.create_foreign_key(op.f(f"fk_{VERDICTS}_on_behalf_of"), "accounts_people", ["on_behalf_of"], ["id"])


def downgrade() -> None:
    with op.batch_alter_table(VERDICTS) as table:
        table.drop_constraint(op.f(f"fk_{VERDICTS}_on_behalf_of"), type_="foreignkey")
        table.drop_column("on_behalf_of")
    op.drop_table(DEPUTIES)
    op.drop_table(CATEGORIES)
