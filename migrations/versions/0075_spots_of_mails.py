"""The places in sounds that an email leads to."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

revision = "0075"
down_revision = "0074"
branch_labels = None
depends_on = None


def upgrade() -> None:
    document = sa.JSON().with_variant(JSONB(), "postgresql")
    op.add_column("notifications_mails", sa.Column("spots", document, nullable=False, server_default="{}"))
    with op.batch_alter_table("notifications_mails") as table:
        table.alter_column("spots", server_default=None)


def downgrade() -> None:
    with op.batch_alter_table("notifications_mails") as table:
        table.drop_column("spots")
