"""Bonuses that are calculated: when a game shipped, the first counted round of a cue, and their lines."""

import sqlalchemy as sa
from alembic import op

import app.kit.db

revision = "0040"
down_revision = "0039"
branch_labels = None
depends_on = None

CONTRACTS, CUES, LINES = "contracts_contracts", "contracts_cues", "contracts_ledger_lines"
BEFORE = "cue_id is not null or milestone_id is not null or tax_bp is not null or late_invoice_id is not null"


def lines_are_about(condition: str) -> None:
    with op.batch_alter_table(LINES) as table:
        table.drop_constraint(op.f(f"ck_{LINES}_about_something"), type_="check")
        table.create_check_constraint(op.f(f"ck_{LINES}_about_something"), condition)


def upgrade() -> None:
    with op.batch_alter_table(CONTRACTS) as table:
        table.add_column(sa.Column("game_shipped_on", sa.Date()))
    with op.batch_alter_table(CUES) as table:
        table.add_column(sa.Column("change_requested_at", app.kit.db.UtcDateTime(timezone=True)))
    lines_are_about(f"{BEFORE} or kind = 'bonus' or about_id is not null")


def downgrade() -> None:
    """Take it back; lines of bonuses are refused by the older table."""
    lines_are_about(BEFORE)
    with op.batch_alter_table(CUES) as table:
        table.drop_column("change_requested_at")
    with op.batch_alter_table(CONTRACTS) as table:
        table.drop_column("game_shipped_on")
