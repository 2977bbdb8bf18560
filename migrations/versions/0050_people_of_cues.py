"""Who puts a cue into the game, and who records it."""

import sqlalchemy as sa
from alembic import op

revision = "0050"
down_revision = "0049"
branch_labels = None
depends_on = None

CUES = "sound_lists_cues"
PEOPLE = ("implementer_id", "recorder_id")


def upgrade() -> None:
    with op.batch_alter_table(CUES) as table:
        for column in PEOPLE:
            table.add_column(sa.Column(column, sa.Uuid(), nullable=True))
            table.create_foreign_key(op.f(f"fk_{CUES}_{column}"), "accounts_people", [column], ["id"])
            table.create_index(op.f(f"ix_{CUES}_{column}"), [column])


def downgrade() -> None:
    with op.batch_alter_table(CUES) as table:
        for column in PEOPLE:
            table.drop_index(op.f(f"ix_{CUES}_{column}"))
            table.drop_constraint(op.f(f"fk_{CUES}_{column}"), type_="foreignkey")
            table.drop_column(column)
