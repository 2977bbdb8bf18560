"""What studios keep is summed up from indices, drawings and previews with it."""

import sqlalchemy as sa
from alembic import op

revision = "0013"
down_revision = "0012"
branch_labels = None
depends_on = None


def upgrade() -> None:
    with op.batch_alter_table("renders_pictures", schema=None) as batch_op:
        batch_op.add_column(sa.Column("drawn_bytes", sa.BigInteger(), nullable=True))
        batch_op.drop_index(batch_op.f("ix_renders_pictures_studio_id"))
        batch_op.create_index("ix_renders_pictures_kept", ["studio_id", "drawn_bytes"], unique=False)

    with op.batch_alter_table("renders_renders", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_renders_renders_studio_id"))
        batch_op.create_index("ix_renders_renders_kept", ["studio_id", "sha256", "file_bytes"], unique=False)

    with op.batch_alter_table("deliveries_takes", schema=None) as batch_op:
        batch_op.create_index("ix_deliveries_takes_kept", ["studio_id", "master_sha256", "master_bytes"], unique=False)


def downgrade() -> None:
    with op.batch_alter_table("deliveries_takes", schema=None) as batch_op:
        batch_op.drop_index("ix_deliveries_takes_kept")

    with op.batch_alter_table("renders_renders", schema=None) as batch_op:
        batch_op.drop_index("ix_renders_renders_kept")
        batch_op.create_index(batch_op.f("ix_renders_renders_studio_id"), ["studio_id"], unique=False)

    with op.batch_alter_table("renders_pictures", schema=None) as batch_op:
        batch_op.drop_index("ix_renders_pictures_kept")
        batch_op.create_index(batch_op.f("ix_renders_pictures_studio_id"), ["studio_id"], unique=False)
        batch_op.drop_column("drawn_bytes")
