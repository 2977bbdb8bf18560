"""The engine whose import files a pack contains."""

import sqlalchemy as sa
from alembic import op

revision = "0037"
down_revision = "0036"
branch_labels = None
depends_on = None

PACKS = "builds_packs"


def upgrade() -> None:
    with op.batch_alter_table(PACKS) as table:
        table.add_column(sa.Column("handoff", sa.String(length=32), nullable=False, server_default="none"))
    with op.batch_alter_table(PACKS) as table:
        table.alter_column("handoff", server_default=None)


def downgrade() -> None:
    with op.batch_alter_table(PACKS) as table:
        table.drop_column("handoff")
