"""The page on which a person hears a session."""

import sqlalchemy as sa
from alembic import op

revision = "0069"
down_revision = "0068"
branch_labels = None
depends_on = None

LISTENERS = "shares_live_listeners"


def upgrade() -> None:
    op.add_column(LISTENERS, sa.Column("page_id", sa.Uuid(), nullable=True))


def downgrade() -> None:
    with op.batch_alter_table(LISTENERS) as table:
        table.drop_column("page_id")
