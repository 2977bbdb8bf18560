"""How much the game needs a cue, and columns of the project's own."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects import postgresql

revision = "0048"
down_revision = "0047"
branch_labels = None
depends_on = None

CUES, COLUMNS = "sound_lists_cues", "sound_lists_columns"
JSON = sa.JSON().with_variant(postgresql.JSONB(), "postgresql")


def upgrade() -> None:
    with op.batch_alter_table(CUES) as table:
        table.add_column(sa.Column("need", sa.String(length=32), nullable=False, server_default="must"))
    with op.batch_alter_table(CUES) as table:
        table.alter_column("need", server_default=None)
    op.create_table(
        COLUMNS,
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("folded", sa.String(), nullable=False),
        sa.Column("kind", sa.String(length=32), nullable=False),
        sa.Column("choices", JSON, nullable=False),
        sa.Column("position", sa.Integer(), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f(f"fk_{COLUMNS}_studio_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f(f"fk_{COLUMNS}_project_id")),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{COLUMNS}")),
        sa.UniqueConstraint("project_id", "folded", name=op.f(f"uq_{COLUMNS}_project_id_folded")),
    )
    op.create_index(op.f(f"ix_{COLUMNS}_studio_id"), COLUMNS, ["studio_id"])


def downgrade() -> None:
    op.drop_table(COLUMNS)
    with op.batch_alter_table(CUES) as table:
        table.drop_column("need")
