"""A mail says until when one worker is sending it, so that no other of many does."""

import sqlalchemy as sa
from alembic import op

from app.kit.db import UtcDateTime

revision = "0005"
down_revision = "0004"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column("notifications_mails", sa.Column("claimed_until", UtcDateTime(), nullable=True))


def downgrade() -> None:
    with op.batch_alter_table("notifications_mails") as table:
        table.drop_column("claimed_until")
