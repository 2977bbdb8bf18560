"""Two signers of a studio can each sign a change order or a statement."""

from alembic import op

revision = "0043"
down_revision = "0042"
branch_labels = None
depends_on = None

ACCEPTANCES = "contracts_amendment_acceptances"
BY_PARTY, BY_PERSON = f"uq_{ACCEPTANCES}_party", f"uq_{ACCEPTANCES}_person"


def upgrade() -> None:
    with op.batch_alter_table(ACCEPTANCES) as table:
        table.drop_constraint(op.f(BY_PARTY), type_="unique")
        table.create_unique_constraint(op.f(BY_PERSON), ["contract_id", "text_sha256", "person_id"])


def downgrade() -> None:
    """Take it back; texts with two signatures of a party are refused by the older table."""
    with op.batch_alter_table(ACCEPTANCES) as table:
        table.drop_constraint(op.f(BY_PERSON), type_="unique")
        table.create_unique_constraint(op.f(BY_PARTY), ["contract_id", "text_sha256", "party"])
