"""Briefs: answers, published versions, who read which, and follow-ups of designers."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

revision = "0032"
down_revision = "0031"
branch_labels = None
depends_on = None

TABLES = ("briefs_follow_ups", "briefs_reads", "briefs_versions", "briefs_briefs")


def instant() -> sa.types.TypeEngine:
    return sa.DateTime(timezone=True)


def answers() -> sa.Column:
    return sa.Column("answers", sa.JSON().with_variant(JSONB(), "postgresql"), nullable=False)


def tenant() -> tuple[sa.Column, sa.Column]:
    return sa.Column("studio_id", sa.Uuid(), nullable=False), sa.Column("project_id", sa.Uuid(), nullable=False)


def key(table: str, column: str, other: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{table}_{column}"))


def keys(table: str, *people: str) -> tuple[sa.ForeignKeyConstraint, ...]:
    return (
        key(table, "studio_id", "accounts_studios"),
        key(table, "project_id", "projects_projects"),
        *(key(table, person, "accounts_people") for person in people),
    )


def index(table: str, *columns: str) -> None:
    for column in columns:
        op.create_index(op.f(f"ix_{table}_{column}"), table, [column])


def upgrade() -> None:
    follow_ups, reads, versions, briefs = TABLES
    op.create_table(
        briefs,
        sa.Column("id", sa.Uuid(), nullable=False),
        *tenant(),
        sa.Column("revision", sa.Integer(), nullable=False),
        answers(),
        sa.Column("changed_by", sa.Uuid(), nullable=False),
        sa.Column("changed_at", instant(), nullable=False),
        *keys(briefs, "changed_by"),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{briefs}")),
        sa.UniqueConstraint("project_id", name=op.f(f"uq_{briefs}_project_id")),
    )
    index(briefs, "studio_id")
    op.create_table(
        versions,
        sa.Column("id", sa.Uuid(), nullable=False),
        *tenant(),
        sa.Column("number", sa.Integer(), nullable=False),
        answers(),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("published_by", sa.Uuid(), nullable=False),
        sa.Column("published_at", instant(), nullable=False),
        *keys(versions, "published_by"),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{versions}")),
        sa.UniqueConstraint("project_id", "number", name=op.f(f"uq_{versions}_project_id_number")),
    )
    index(versions, "studio_id")
    op.create_table(
        reads,
        sa.Column("version_id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        *tenant(),
        sa.Column("read_at", instant(), nullable=False),
        key(reads, "version_id", versions),
        *keys(reads, "designer_id"),
        sa.PrimaryKeyConstraint("version_id", "designer_id", name=op.f(f"pk_{reads}")),
    )
    index(reads, "designer_id", "studio_id", "project_id")
    op.create_table(
        follow_ups,
        sa.Column("id", sa.Uuid(), nullable=False),
        *tenant(),
        sa.Column("question", sa.String(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("asked_by", sa.Uuid(), nullable=False),
        sa.Column("asked_at", instant(), nullable=False),
        sa.Column("answer", sa.String()),
        sa.Column("answered_by", sa.Uuid()),
        sa.Column("answered_at", instant()),
        *keys(follow_ups, "asked_by", "answered_by"),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{follow_ups}")),
    )
    index(follow_ups, "studio_id", "project_id")


def downgrade() -> None:
    for table in TABLES:
        op.drop_table(table)
