"""Facts of a cue that the clarity check asks for no more."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects import postgresql

revision = "0034"
down_revision = "0033"
branch_labels = None
depends_on = None

CUES = "sound_lists_cues"
JSON = sa.JSON().with_variant(postgresql.JSONB(), "postgresql")


def upgrade() -> None:
    with op.batch_alter_table(CUES) as table:
        table.add_column(sa.Column("dismissed_facts", JSON, nullable=False, server_default="[]"))
    with op.batch_alter_table(CUES) as table:
        table.alter_column("dismissed_facts", server_default=None)


def downgrade() -> None:
    with op.batch_alter_table(CUES) as table:
        table.drop_column("dismissed_facts")
