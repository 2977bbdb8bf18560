"""What each person wants to be mailed, and the moment from which a mail is sent."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

import app.kit.db

revision = "0042"
down_revision = "0041"
branch_labels = None
depends_on = None

MAILS, WISHES = "notifications_mails", "notifications_mail_preferences"


def upgrade() -> None:
    op.create_table(
        WISHES,
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("cadences", sa.JSON().with_variant(JSONB(), "postgresql"), nullable=False),
        sa.Column("time_zone", sa.String(), nullable=False),
        sa.Column("daily_at", sa.Time(), nullable=False),
        sa.Column("quiet_from", sa.Time()),
        sa.Column("quiet_until", sa.Time()),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f(f"fk_{WISHES}_person_id")),
        sa.PrimaryKeyConstraint("person_id", name=op.f(f"pk_{WISHES}")),
    )
    with op.batch_alter_table(MAILS) as table:
        table.add_column(sa.Column("news", sa.String()))
        table.add_column(sa.Column("send_after", app.kit.db.UtcDateTime(timezone=True)))
    op.execute(f"update {MAILS} set send_after = created_at")  # noqa: S608 - a constant
    with op.batch_alter_table(MAILS) as table:
        table.alter_column("send_after", nullable=False)


def downgrade() -> None:
    with op.batch_alter_table(MAILS) as table:
        table.drop_column("send_after")
        table.drop_column("news")
    op.drop_table(WISHES)
