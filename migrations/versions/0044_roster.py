"""The roster of a studio, the days on which its designers are busy, and the sounds of their reels."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

revision = "0044"
down_revision = "0043"
branch_labels = None
depends_on = None

ENTRIES, RANGES, SOUNDS = "hiring_roster_entries", "hiring_busy_ranges", "hiring_reel_sounds"


def instant(name: str, *, nullable: bool = True) -> sa.Column:
    return sa.Column(name, sa.DateTime(timezone=True), nullable=nullable)


def day(name: str, *, nullable: bool = True) -> sa.Column:
    return sa.Column(name, sa.Date(), nullable=nullable)


def text(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, sa.String(), nullable=nullable)


def word(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, sa.String(length=32), nullable=nullable)


def document(name: str) -> sa.Column:
    return sa.Column(name, sa.JSON().with_variant(JSONB(), "postgresql"), nullable=False)


def uuid(name: str) -> sa.Column:
    return sa.Column(name, sa.Uuid(), nullable=False)


def key(table: str, column: str, other: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{table}_{column}"))


def check(table: str, name: str, condition: str) -> sa.CheckConstraint:
    return sa.CheckConstraint(condition, name=op.f(f"ck_{table}_{name}"))


def primary(table: str) -> sa.PrimaryKeyConstraint:
    return sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{table}"))


def index(table: str, *columns: str) -> None:
    for column in columns:
        op.create_index(op.f(f"ix_{table}_{column}"), table, [column])


def upgrade() -> None:
    op.create_table(
        ENTRIES,
        uuid("id"),
        uuid("studio_id"),
        text("name"),
        text("email"),
        *(document(name) for name in ("specialities", "services", "languages")),
        *(text(name) for name in ("equipment", "credits", "referees")),
        document("links"),
        word("exclusivity"),
        sa.Column("weekly_hours", sa.Integer()),
        day("available_from_on"),
        text("notes"),
        sa.Column("rate_minor", sa.BigInteger()),
        text("rate_currency"),
        word("rate_unit", nullable=True),
        text("calendar_name", nullable=True),
        instant("calendar_read_at"),
        day("calendar_to_on"),
        sa.Column("revision", sa.Integer(), nullable=False),
        uuid("added_by"),
        instant("added_at", nullable=False),
        instant("changed_at", nullable=False),
        key(ENTRIES, "studio_id", "accounts_studios"),
        key(ENTRIES, "added_by", "accounts_people"),
        primary(ENTRIES),
        sa.UniqueConstraint("studio_id", "email", name=op.f(f"uq_{ENTRIES}_studio_id_email")),
        check(ENTRIES, "email_lower_case", "email = lower(email)"),
        check(ENTRIES, "rate_has_a_unit", "(rate_minor is null) = (rate_unit is null)"),
        check(ENTRIES, "hours_of_a_week", "weekly_hours is null or weekly_hours between 1 and 168"),
    )
    index(ENTRIES, "studio_id")
    op.create_table(
        RANGES,
        uuid("id"),
        uuid("studio_id"),
        uuid("entry_id"),
        day("from_on", nullable=False),
        day("to_on", nullable=False),
        word("kind"),
        text("note"),
        sa.Column("is_from_calendar", sa.Boolean(), nullable=False),
        key(RANGES, "studio_id", "accounts_studios"),
        key(RANGES, "entry_id", ENTRIES),
        primary(RANGES),
        check(RANGES, "in_order", "from_on <= to_on"),
    )
    index(RANGES, "studio_id", "entry_id")
    op.create_table(
        SOUNDS,
        uuid("id"),
        uuid("studio_id"),
        uuid("entry_id"),
        *(text(name) for name in ("title", "file_name", "media_type", "sha256")),
        sa.Column("file_bytes", sa.BigInteger(), nullable=False),
        uuid("added_by"),
        instant("added_at", nullable=False),
        key(SOUNDS, "studio_id", "accounts_studios"),
        key(SOUNDS, "entry_id", ENTRIES),
        key(SOUNDS, "added_by", "accounts_people"),
        primary(SOUNDS),
        check(SOUNDS, "not_empty", "file_bytes > 0"),
    )
    index(SOUNDS, "studio_id", "entry_id")


def downgrade() -> None:
    for table in (SOUNDS, RANGES, ENTRIES):
        op.drop_table(table)
