"""What the caller of a saved answer may do, and when it was saved, so that old ones are found."""

import sqlalchemy as sa
from alembic import op

revision = "0024"
down_revision = "0023"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column("kit_saved_responses", sa.Column("rights", sa.String()))
    op.create_index("ix_kit_saved_responses_created_at", "kit_saved_responses", ["created_at"])


def downgrade() -> None:
    op.drop_index("ix_kit_saved_responses_created_at", "kit_saved_responses")
    op.drop_column("kit_saved_responses", "rights")
