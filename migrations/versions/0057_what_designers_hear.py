"""What the designers of a project may hear of each other; projects that exist stay as closed as they were."""

import sqlalchemy as sa
from alembic import op

revision = "0057"
down_revision = "0056"
branch_labels = None
depends_on = None

PROJECTS, COLUMN = "projects_projects", "designers_hear"


def upgrade() -> None:
    op.add_column(PROJECTS, sa.Column(COLUMN, sa.String(length=32), nullable=False, server_default="own"))
    with op.batch_alter_table(PROJECTS) as table:
        table.alter_column(COLUMN, server_default=None)


def downgrade() -> None:
    with op.batch_alter_table(PROJECTS) as table:
        table.drop_column(COLUMN)
