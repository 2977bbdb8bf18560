"""Which project an invited member becomes the approver of."""

import sqlalchemy as sa
from alembic import op

revision = "0025"
down_revision = "0024"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column("accounts_studio_invitations", sa.Column("approves_project_id", sa.Uuid()))


def downgrade() -> None:
    op.drop_column("accounts_studio_invitations", "approves_project_id")
