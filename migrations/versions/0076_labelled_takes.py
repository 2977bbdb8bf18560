"""The index by which the search finds labels."""

import sqlalchemy as sa
from alembic import op

revision = "0076"
down_revision = "0075"
branch_labels = None
depends_on = None

NAME, TAKES = "ix_deliveries_takes_labelled", "deliveries_takes"


def upgrade() -> None:
    where = sa.text("label is not null")
    columns = ["project_id", "id", "label", "designer_id", "studio_id"]
    op.create_index(NAME, TAKES, columns, sqlite_where=where, postgresql_where=where)


def downgrade() -> None:
    op.drop_index(NAME, TAKES)
