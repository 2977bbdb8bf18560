"""Whether later versions did what notes on earlier ones asked."""

import sqlalchemy as sa
from alembic import op

revision = "0038"
down_revision = "0037"
branch_labels = None
depends_on = None

ANSWERS = "reviews_note_answers"


def key(column: str, other: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{ANSWERS}_{column}"))


def upgrade() -> None:
    op.create_table(
        ANSWERS,
        *(sa.Column(name, sa.Uuid(), nullable=False) for name in ("id", "studio_id", "project_id", "take_id")),
        *(sa.Column(name, sa.Uuid(), nullable=True) for name in ("comment_id", "change_request_id")),
        sa.Column("is_done", sa.Boolean(), nullable=False),
        sa.Column("given_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(comment_id is null) <> (change_request_id is null)", name=op.f(f"ck_{ANSWERS}_one_note")),
        key("studio_id", "accounts_studios"),
        key("project_id", "projects_projects"),
        key("take_id", "deliveries_takes"),
        key("comment_id", "reviews_comments"),
        key("change_request_id", "reviews_change_requests"),
        key("given_by", "accounts_people"),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{ANSWERS}")),
    )
    for column in ("studio_id", "project_id", "take_id"):
        op.create_index(op.f(f"ix_{ANSWERS}_{column}"), ANSWERS, [column])
    for column in ("comment_id", "change_request_id"):
        op.create_index(f"ix_{ANSWERS}_{column}", ANSWERS, [column, "id"])


def downgrade() -> None:
    op.drop_table(ANSWERS)
