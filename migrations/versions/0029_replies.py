"""Comments that reply to another comment, or to a change request."""

import sqlalchemy as sa
from alembic import op

revision = "0029"
down_revision = "0028"
branch_labels = None
depends_on = None

TABLE = "reviews_comments"
REFERRED = {"reply_to_id": TABLE, "change_request_id": "reviews_change_requests"}


def upgrade() -> None:
    with op.batch_alter_table(TABLE) as table:
        for column, other in REFERRED.items():
            table.add_column(sa.Column(column, sa.Uuid()))
            table.create_foreign_key(op.f(f"fk_{TABLE}_{column}"), other, [column], ["id"])
            table.create_index(op.f(f"ix_{TABLE}_{column}"), [column])


def downgrade() -> None:
    with op.batch_alter_table(TABLE) as table:
        for column in REFERRED:
            table.drop_index(op.f(f"ix_{TABLE}_{column}"))
            table.drop_constraint(op.f(f"fk_{TABLE}_{column}"), type_="foreignkey")
            table.drop_column(column)
