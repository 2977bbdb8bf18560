"""Placeholders that a person says for a cue."""

import sqlalchemy as sa
from alembic import op

revision = "0059"
down_revision = "0058"
branch_labels = None
depends_on = None

SAID = "sound_lists_spoken_placeholders"
KEYS = {
    "studio_id": "accounts_studios",
    "project_id": "projects_projects",
    "cue_id": "sound_lists_cues",
    "recorded_by": "accounts_people",
}


def upgrade() -> None:
    op.create_table(
        SAID,
        sa.Column("id", sa.Uuid(), nullable=False),
        *(sa.Column(name, sa.Uuid(), nullable=False) for name in KEYS),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("file_bytes", sa.BigInteger(), nullable=False),
        sa.Column("duration_s", sa.Double(), nullable=False),
        sa.Column("recorded_at", sa.DateTime(timezone=True), nullable=False),
        *(
            sa.ForeignKeyConstraint([name], [f"{table}.id"], name=op.f(f"fk_{SAID}_{name}"))
            for name, table in KEYS.items()
        ),
        sa.CheckConstraint("file_bytes > 0", name=op.f(f"ck_{SAID}_not_empty")),
        sa.UniqueConstraint("cue_id", name=op.f(f"uq_{SAID}_cue_id")),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{SAID}")),
    )
    op.create_index(op.f(f"ix_{SAID}_project_id"), SAID, ["project_id"])
    op.create_index(f"ix_{SAID}_kept", SAID, ["studio_id", "sha256", "file_bytes"])


def downgrade() -> None:
    op.drop_table(SAID)
