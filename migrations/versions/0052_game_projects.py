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
    gone = f"select id from {VERDICTS} where cue_id not in (select id from {CUES})"
    op.execute(f"delete from {VERDICTS} where withdraws_id in ({gone})")
    op.execute(f"delete from {VERDICTS} where cue_id not in (select id from {CUES})")
    with op.batch_alter_table(VERDICTS) as table:
        table.create_foreign_key(op.f(f"fk_{VERDICTS}_cue_id"), CUES, ["cue_id"], ["id"])
    with op.batch_alter_table(ADOPTIONS) as table:
        table.drop_column("game")
