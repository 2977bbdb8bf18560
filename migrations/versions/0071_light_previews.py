"""The light preview of a sound, to begin with over a slow line."""

import sqlalchemy as sa
from alembic import op

revision = "0071"
down_revision = "0070"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column("renders_pictures", sa.Column("light_sha256", sa.String(), nullable=True))


def downgrade() -> None:
    with op.batch_alter_table("renders_pictures") as table:
        table.drop_column("light_sha256")
