"""Where in a recording of the game a note of a listening pass was heard."""

import sqlalchemy as sa
from alembic import op

revision = "0061"
down_revision = "0060"
branch_labels = None
depends_on = None

NOTES = "builds_listening_notes"


def upgrade() -> None:
    with op.batch_alter_table(NOTES) as table:
        table.add_column(sa.Column("recording_id", sa.Uuid(), nullable=True))
        table.add_column(sa.Column("at_s", sa.Double(), nullable=True))
        table.create_foreign_key(op.f(f"fk_{NOTES}_recording_id"), "references_versions", ["recording_id"], ["id"])
        table.create_index(op.f(f"ix_{NOTES}_recording_id"), ["recording_id"])
        table.create_check_constraint(
            op.f(f"ck_{NOTES}_recording_has_a_time"), "(recording_id is null) = (at_s is null)"
        )


def downgrade() -> None:
    with op.batch_alter_table(NOTES) as table:
        table.drop_constraint(op.f(f"ck_{NOTES}_recording_has_a_time"), type_="check")
        table.drop_index(op.f(f"ix_{NOTES}_recording_id"))
        table.drop_constraint(op.f(f"fk_{NOTES}_recording_id"), type_="foreignkey")
        table.drop_column("at_s")
        table.drop_column("recording_id")
