"""What the game's project says of an adopted folder, approved levels, and verdicts that outlast an undone cue."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

revision = "0052"
down_revision = "0051"
branch_labels = None
depends_on = None

ADOPTIONS, VERDICTS, LEVELS = "deliveries_adoptions", "reviews_verdicts", "reviews_game_levels"
CUES = "sound_lists_cues"
OTHERS = {"studio_id": "accounts_studios", "project_id": "projects_projects", "cue_id": CUES}


def json() -> sa.JSON:
    return sa.JSON().with_variant(JSONB(), "postgresql")


def upgrade() -> None:
    with op.batch_alter_table(ADOPTIONS) as table:
        table.add_column(sa.Column("game", json(), nullable=True))
    with op.batch_alter_table(VERDICTS) as table:
        table.drop_constraint(op.f(f"fk_{VERDICTS}_cue_id"), type_="foreignkey")
    op.create_table(
        LEVELS,
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("variation", sa.Integer(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("plays", json(), nullable=False),
        *(
            sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{LEVELS}_{column}"))
            for column, other in OTHERS.items()
        ),
        sa.PrimaryKeyConstraint("cue_id", "variation", name=op.f(f"pk_{LEVELS}")),
    )
    for column in ("studio_id", "project_id"):
        op.create_index(op.f(f"ix_{LEVELS}_{column}"), LEVELS, [column])


def downgrade() -> None:
    """Take it back; verdicts of cues that an undone adoption removed go with it."""
    op.drop_table(LEVELS)
    verdicts = sa.table(VERDICTS, sa.column("id"), sa.column("cue_id"), sa.column("withdraws_id"))
    cues = sa.select(sa.table(CUES, sa.column("id")).c.id)
    others = verdicts.alias()
    gone = sa.select(others.c.id).where(others.c.cue_id.not_in(cues))
    op.execute(sa.delete(verdicts).where(verdicts.c.withdraws_id.in_(gone)))
    op.execute(sa.delete(verdicts).where(verdicts.c.cue_id.not_in(cues)))
    with op.batch_alter_table(VERDICTS) as table:
        table.create_foreign_key(op.f(f"fk_{VERDICTS}_cue_id"), CUES, ["cue_id"], ["id"])
    with op.batch_alter_table(ADOPTIONS) as table:
        table.drop_column("game")
