"""Invoice numbers of the designer's own series, and the day on which a cue is needed."""

import sqlalchemy as sa
from alembic import op

revision = "0031"
down_revision = "0030"
branch_labels = None
depends_on = None

INVOICES, CUES = "contracts_invoices", "sound_lists_cues"
UNIQUE = "uq_contracts_invoices_studio_id_designer_id_full_number"


def upgrade() -> None:
    with op.batch_alter_table(INVOICES) as table:
        table.add_column(sa.Column("full_number", sa.String(), nullable=True))
    op.execute("update contracts_invoices set full_number = cast(number as varchar)")
    with op.batch_alter_table(INVOICES) as table:
        table.alter_column("full_number", nullable=False)
        table.create_unique_constraint(op.f(UNIQUE), ["studio_id", "designer_id", "full_number"])
    with op.batch_alter_table(CUES) as table:
        table.add_column(sa.Column("due_on", sa.Date()))


def downgrade() -> None:
    with op.batch_alter_table(CUES) as table:
        table.drop_column("due_on")
    with op.batch_alter_table(INVOICES) as table:
        table.drop_constraint(op.f(UNIQUE), type_="unique")
        table.drop_column("full_number")
