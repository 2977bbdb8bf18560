"""What the store calls an upload that comes there in parts."""

import sqlalchemy as sa
from alembic import op

revision = "0003"
down_revision = "0002"
branch_labels = None
depends_on = None


def upgrade() -> None:
    with op.batch_alter_table("kit_uploads", schema=None) as batch_op:
        batch_op.add_column(sa.Column("multipart_id", sa.String(), nullable=True))


def downgrade() -> None:
    with op.batch_alter_table("kit_uploads", schema=None) as batch_op:
        batch_op.drop_column("multipart_id")
