"""Names that are drawn beside the typed ones when a text is signed."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects import postgresql

revision = "0062"
down_revision = "0061"
branch_labels = None
depends_on = None

TABLES = ("contracts_acceptances", "contracts_amendment_acceptances")
JSON = sa.JSON().with_variant(postgresql.JSONB(), "postgresql")


def upgrade() -> None:
    for name in TABLES:
        op.add_column(name, sa.Column("drawing", JSON))


def downgrade() -> None:
    for name in TABLES:
        with op.batch_alter_table(name) as table:
            table.drop_column("drawing")
