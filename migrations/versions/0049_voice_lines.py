"""Voice lines: characters, performers, castings, lines, texts and their versions, releases."""

import sqlalchemy as sa
from alembic import op

revision = "0049"
down_revision = "0048"
branch_labels = None
depends_on = None

SETTINGS, CHARACTERS, PERFORMERS = "voice_lines_settings", "voice_lines_characters", "voice_lines_performers"
CASTINGS, LINES, TEXTS = "voice_lines_castings", "voice_lines_lines", "voice_lines_texts"
VERSIONS, RELEASES = "voice_lines_text_versions", "voice_lines_releases"


def instant(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, sa.DateTime(timezone=True), nullable=nullable)


def text(*names: str) -> tuple[sa.Column, ...]:
    return tuple(sa.Column(name, sa.String(), nullable=False) for name in names)


def number(name: str) -> sa.Column:
    return sa.Column(name, sa.Integer(), nullable=False)


def uuid(*names: str, nullable: bool = False) -> tuple[sa.Column, ...]:
    return tuple(sa.Column(name, sa.Uuid(), nullable=nullable) for name in names)


def key(table: str, column: str, other: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{table}_{column}"))


def keys(table: str, **others: str) -> tuple[sa.Constraint, ...]:
    return (
        key(table, "studio_id", "accounts_studios"),
        key(table, "project_id", "projects_projects"),
        *(key(table, column, other) for column, other in others.items()),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{table}")),
    )


def unique(table: str, *columns: str) -> sa.UniqueConstraint:
    return sa.UniqueConstraint(*columns, name=op.f(f"uq_{table}_{'_'.join(columns)}"))


def check(table: str, name: str, condition: str) -> sa.CheckConstraint:
    return sa.CheckConstraint(condition, name=op.f(f"ck_{table}_{name}"))


def index(table: str, *columns: str) -> None:
    for column in columns:
        op.create_index(op.f(f"ix_{table}_{column}"), table, [column])


def upgrade() -> None:
    _make_cast()
    _make_lines()
    op.create_table(
        RELEASES,
        *uuid("id", "studio_id", "project_id", "performer_id"),
        *text("file_name", "sha256"),
        sa.Column("file_bytes", sa.BigInteger(), nullable=False),
        sa.Column("valid_from", sa.Date(), nullable=False),
        sa.Column("valid_until", sa.Date()),
        sa.Column("synthetic_use", sa.String(length=32), nullable=False),
        *text("note"),
        *uuid("added_by"),
        instant("added_at"),
        *uuid("removed_by", nullable=True),
        instant("removed_at", nullable=True),
        *keys(RELEASES, performer_id=PERFORMERS, added_by="accounts_people", removed_by="accounts_people"),
        check(RELEASES, "ends_after_it_begins", "valid_until is null or valid_until >= valid_from"),
        check(RELEASES, "removed_by_a_person", "(removed_at is null) = (removed_by is null)"),
    )
    index(RELEASES, "project_id", "performer_id")
    op.create_index(f"ix_{RELEASES}_kept", RELEASES, ["studio_id", "sha256", "file_bytes"])


def _make_cast() -> None:
    op.create_table(
        SETTINGS,
        *uuid("id", "studio_id", "project_id"),
        *text("original_language"),
        number("tolerance_percent"),
        *keys(SETTINGS),
        unique(SETTINGS, "project_id"),
        check(SETTINGS, "tolerance_in_range", "tolerance_percent between 1 and 100"),
    )
    index(SETTINGS, "studio_id")
    for table, more in ((CHARACTERS, ("notes",)), (PERFORMERS, ())):
        op.create_table(
            table,
            *uuid("id", "studio_id", "project_id"),
            *text("name", "folded", *more),
            *keys(table),
            unique(table, "project_id", "folded"),
        )
        index(table, "studio_id")
    op.create_table(
        CASTINGS,
        *uuid("id", "studio_id", "project_id", "character_id"),
        *text("language"),
        *uuid("performer_id", nullable=True),
        *text("directed_by", "cast_by"),
        *keys(CASTINGS, character_id=CHARACTERS, performer_id=PERFORMERS),
        unique(CASTINGS, "character_id", "language"),
    )
    index(CASTINGS, "studio_id", "project_id", "performer_id")


def _make_lines() -> None:
    op.create_table(
        LINES,
        *uuid("id", "studio_id", "project_id", "character_id"),
        *text("key", "folded", "file_name", "scene", "direction"),
        number("position"),
        instant("created_at"),
        *keys(LINES, character_id=CHARACTERS),
        unique(LINES, "project_id", "folded"),
    )
    index(LINES, "studio_id", "character_id")
    op.create_index(f"ix_{LINES}_order", LINES, ["project_id", "position"])
    op.create_table(
        TEXTS,
        *uuid("id", "studio_id", "project_id", "line_id"),
        *text("language"),
        *uuid("cue_id"),
        *text("text"),
        number("newest_number"),
        *keys(TEXTS, line_id=LINES, cue_id="sound_lists_cues"),
        unique(TEXTS, "cue_id"),
        unique(TEXTS, "line_id", "language"),
    )
    index(TEXTS, "studio_id")
    op.create_index(f"ix_{TEXTS}_language", TEXTS, ["project_id", "language"])
    op.create_table(
        VERSIONS,
        *uuid("id", "studio_id", "project_id", "text_id"),
        number("number"),
        *text("text"),
        *uuid("written_by"),
        instant("written_at"),
        *uuid("takes_fit_by", nullable=True),
        instant("takes_fit_at", nullable=True),
        *keys(VERSIONS, text_id=TEXTS, written_by="accounts_people", takes_fit_by="accounts_people"),
        unique(VERSIONS, "text_id", "number"),
        check(VERSIONS, "fit_said_by_a_person", "(takes_fit_at is null) = (takes_fit_by is null)"),
    )
    index(VERSIONS, "studio_id", "project_id")


def downgrade() -> None:
    for table in (RELEASES, VERSIONS, TEXTS, LINES, CASTINGS, PERFORMERS, CHARACTERS, SETTINGS):
        op.drop_table(table)
