"""Notices in the app; who is mentioned in comments and change requests, and who has seen a comment."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

import app.kit.db

revision = "0051"
down_revision = "0050"
branch_labels = None
depends_on = None

NOTICES, SIGHTINGS = "notifications_notices", "reviews_acknowledgements"
WITH_MENTIONS = ("reviews_comments", "reviews_change_requests")


def instant(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, app.kit.db.UtcDateTime(timezone=True), nullable=nullable)


def key(table: str, column: str, other: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{table}_{column}"))


def upgrade() -> None:
    op.create_table(
        NOTICES,
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid()),
        *(sa.Column(name, sa.String(), nullable=False) for name in ("topic", "event_id", "news")),
        *(sa.Column(name, sa.String(), nullable=False) for name in ("subject", "text", "path")),
        instant("created_at"),
        instant("read_at", nullable=True),
        key(NOTICES, "person_id", "accounts_people"),
        key(NOTICES, "studio_id", "accounts_studios"),
        key(NOTICES, "project_id", "projects_projects"),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{NOTICES}")),
        sa.UniqueConstraint("person_id", "topic", "event_id", name=op.f(f"uq_{NOTICES}_person_id_topic_event_id")),
    )
    op.create_index(op.f(f"ix_{NOTICES}_studio_id"), NOTICES, ["studio_id"])
    op.create_index(op.f(f"ix_{NOTICES}_project_id"), NOTICES, ["project_id"])
    op.create_index(op.f(f"ix_{NOTICES}_read_at"), NOTICES, ["read_at"])
    op.create_index(f"ix_{NOTICES}_of_person", NOTICES, ["person_id", "id"])
    unread = sa.text("read_at is null")
    op.create_index(f"ix_{NOTICES}_unread", NOTICES, ["person_id"], sqlite_where=unread, postgresql_where=unread)
    op.create_table(
        SIGHTINGS,
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("comment_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        instant("created_at"),
        key(SIGHTINGS, "studio_id", "accounts_studios"),
        key(SIGHTINGS, "project_id", "projects_projects"),
        key(SIGHTINGS, "comment_id", "reviews_comments"),
        key(SIGHTINGS, "person_id", "accounts_people"),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{SIGHTINGS}")),
        sa.UniqueConstraint("comment_id", "person_id", name=op.f(f"uq_{SIGHTINGS}_comment_id_person_id")),
    )
    op.create_index(op.f(f"ix_{SIGHTINGS}_studio_id"), SIGHTINGS, ["studio_id"])
    op.create_index(op.f(f"ix_{SIGHTINGS}_project_id"), SIGHTINGS, ["project_id"])
    for table_name in WITH_MENTIONS:
        with op.batch_alter_table(table_name) as table:
            names = sa.JSON().with_variant(JSONB(), "postgresql")
            table.add_column(sa.Column("mentions", names, nullable=False, server_default="{}"))
        with op.batch_alter_table(table_name) as table:
            table.alter_column("mentions", server_default=None)


def downgrade() -> None:
    for table_name in WITH_MENTIONS:
        with op.batch_alter_table(table_name) as table:
            table.drop_column("mentions")
    op.drop_table(SIGHTINGS)
    op.drop_table(NOTICES)
