"""The keys that go with packs are found among all their files."""

import sqlalchemy as sa
from alembic import op

revision = "0016"
down_revision = "0015"
branch_labels = None
depends_on = None


def upgrade() -> None:
    with op.batch_alter_table("builds_packed_files", schema=None) as batch_op:
        batch_op.create_index(
            "ix_builds_packed_files_keys",
            ["studio_id", "sha256", "size_bytes"],
            unique=False,
            sqlite_where=sa.text("kind = 'key'"),
            postgresql_where=sa.text("kind = 'key'"),
        )


def downgrade() -> None:
    with op.batch_alter_table("builds_packed_files", schema=None) as batch_op:
        batch_op.drop_index("ix_builds_packed_files_keys")
