"""Why takes stand as they do: a copy of the reasons of their verdicts, so that lists show them without a join."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

revision = "0077"
down_revision = "0076"
branch_labels = None
depends_on = None

TAKES, COLUMN = "deliveries_takes", "verdict_reasons"
# What a take stands by is its newest verdict that was not taken back; only those are in given_reasons.
COPY = """
update deliveries_takes set verdict_reasons = (
    select verdict.reasons from reviews_verdicts as verdict
    where verdict.take_id = deliveries_takes.id
      and verdict.kind = case deliveries_takes.state when 'approved' then 'approve' else 'request_change' end
      and not exists (select 1 from reviews_verdicts as back where back.withdraws_id = verdict.id)
    order by verdict.id desc limit 1
)
where state in ('approved', 'change_requested') and id in (
    select verdict.take_id from reviews_given_reasons as given
    join reviews_verdicts as verdict on verdict.id = given.verdict_id
    where given.kind = case deliveries_takes.state when 'approved' then 'pick' else 'change' end
)
"""


def upgrade() -> None:
    words = sa.JSON().with_variant(JSONB(), "postgresql")
    with op.batch_alter_table(TAKES) as table:
        table.add_column(sa.Column(COLUMN, words, nullable=False, server_default="[]"))
    op.execute(COPY)


def downgrade() -> None:
    with op.batch_alter_table(TAKES) as table:
        table.drop_column(COLUMN)
