"""The clip that a reference was spotted from."""

import sqlalchemy as sa
from alembic import op

revision = "0068"
down_revision = "0067"
branch_labels = None
depends_on = None

REFERENCES = "references_references"


def upgrade() -> None:
    with op.batch_alter_table(REFERENCES) as table:
        table.add_column(sa.Column("spotted_from_id", sa.Uuid(), nullable=True))
        table.create_foreign_key(op.f(f"fk_{REFERENCES}_spotted_from_id"), REFERENCES, ["spotted_from_id"], ["id"])
        table.create_index(op.f(f"ix_{REFERENCES}_spotted_from_id"), ["spotted_from_id"])


def downgrade() -> None:
    with op.batch_alter_table(REFERENCES) as table:
        table.drop_index(op.f(f"ix_{REFERENCES}_spotted_from_id"))
        table.drop_constraint(op.f(f"fk_{REFERENCES}_spotted_from_id"), type_="foreignkey")
        table.drop_column("spotted_from_id")
