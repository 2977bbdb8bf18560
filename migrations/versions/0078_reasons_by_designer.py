"""Whose version and which cue a reason was given of, beside the reason, so that reasons are counted by an index."""

import sqlalchemy as sa
from alembic import op

revision = "0078"
down_revision = "0077"
branch_labels = None
depends_on = None

GIVEN = "reviews_given_reasons"
INDEX = f"ix_{GIVEN}_counted"
COLUMNS = ("designer_id", "cue_id")
COPY = """
update reviews_given_reasons set
    cue_id = (select cue_id from reviews_verdicts where id = verdict_id),
    designer_id = (
        select take.designer_id from reviews_verdicts as verdict
        join deliveries_takes as take on take.id = verdict.take_id where verdict.id = verdict_id
    )
"""


def upgrade() -> None:
    for column in COLUMNS:
        op.add_column(GIVEN, sa.Column(column, sa.Uuid(), nullable=True))
    op.execute(COPY)
    with op.batch_alter_table(GIVEN) as table:
        for column in COLUMNS:
            table.alter_column(column, existing_type=sa.Uuid(), nullable=False)
        table.create_foreign_key(op.f(f"fk_{GIVEN}_designer_id"), "accounts_people", ["designer_id"], ["id"])
    op.create_index(INDEX, GIVEN, ["project_id", "designer_id", "kind", "reason", "cue_id", "studio_id"])


def downgrade() -> None:
    if op.get_bind().dialect.name == "postgresql":  # they name the column; `soundlist migrate` makes those of the table
        for act in ("", "_insert", "_update", "_delete"):
            op.execute(f"drop policy if exists within_reach{act} on {GIVEN}")
    op.drop_index(INDEX, GIVEN)
    with op.batch_alter_table(GIVEN) as table:
        table.drop_constraint(op.f(f"fk_{GIVEN}_designer_id"), type_="foreignkey")
        for column in COLUMNS:
            table.drop_column(column)
