"""Guest links, playlists with their sessions, saved views, and comments of guests."""

import sqlalchemy as sa
from alembic import op

revision = "0053"
down_revision = "0052"
branch_labels = None
depends_on = None

LINKS, SOUNDS, VISITS, PLAYS = "shares_guest_links", "shares_guest_sounds", "shares_guest_visits", "shares_guest_plays"
COPIES = "shares_guest_copies"
LISTS, ENTRIES, POSITIONS = "shares_playlists", "shares_playlist_entries", "shares_playlist_positions"
SESSIONS, LISTENERS = "shares_live_sessions", "shares_live_listeners"
VIEWS = "shares_saved_views"
COMMENTS = "reviews_comments"
PEOPLE, TAKES = "accounts_people", "deliveries_takes"


def instant(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, sa.DateTime(timezone=True), nullable=nullable)


def text(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, sa.String(), nullable=nullable)


def word(name: str) -> sa.Column:
    return sa.Column(name, sa.String(length=32), nullable=False)


def number(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, sa.Integer(), nullable=nullable)


def flag(name: str) -> sa.Column:
    return sa.Column(name, sa.Boolean(), nullable=False)


def seconds(name: str) -> sa.Column:
    return sa.Column(name, sa.Double(), nullable=False)


def uuid(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, sa.Uuid(), nullable=nullable)


def key(table: str, column: str, other: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{table}_{column}"))


def keys(table: str, *primary: str) -> tuple[sa.Constraint, ...]:
    return (
        key(table, "studio_id", "accounts_studios"),
        key(table, "project_id", "projects_projects"),
        sa.PrimaryKeyConstraint(*primary, name=op.f(f"pk_{table}")),
    )


def check(table: str, name: str, condition: str) -> sa.CheckConstraint:
    return sa.CheckConstraint(condition, name=op.f(f"ck_{table}_{name}"))


def unique(table: str, *columns: str) -> sa.UniqueConstraint:
    return sa.UniqueConstraint(*columns, name=op.f(f"uq_{table}_{'_'.join(columns)}"))


def index(table: str, *columns: str) -> None:
    for column in columns:
        op.create_index(op.f(f"ix_{table}_{column}"), table, [column])


def upgrade() -> None:
    with op.batch_alter_table(COMMENTS) as table:
        table.add_column(text("guest_name", nullable=True))
        table.alter_column("written_by", existing_type=sa.Uuid(), nullable=True)
        table.create_check_constraint(
            op.f(f"ck_{COMMENTS}_by_a_person_or_guest"), "(written_by is null) <> (guest_name is null)"
        )
    _add_links()
    _add_visits()
    _add_playlists()
    _add_sessions()
    op.create_table(
        VIEWS,
        *(uuid("id"), uuid("studio_id"), uuid("project_id"), uuid("person_id"), word("page"), text("name")),
        *(text("query"), instant("created_at")),
        *keys(VIEWS, "id"),
        key(VIEWS, "person_id", PEOPLE),
        unique(VIEWS, "project_id", "person_id", "page", "name"),
    )
    index(VIEWS, "studio_id", "person_id")


def _add_links() -> None:
    op.create_table(
        LINKS,
        *(uuid("id"), uuid("studio_id"), uuid("project_id"), word("kind"), text("title"), text("secret_sha256")),
        *(text("password_hash", nullable=True), flag("may_comment"), flag("has_beeps")),
        *(instant("expires_at", nullable=True), number("max_openings", nullable=True), number("openings")),
        *(uuid("made_by"), instant("created_at"), instant("revoked_at", nullable=True)),
        uuid("revoked_by", nullable=True),
        *keys(LINKS, "id"),
        key(LINKS, "made_by", PEOPLE),
        key(LINKS, "revoked_by", PEOPLE),
        unique(LINKS, "secret_sha256"),
        check(LINKS, "revoked_by_a_person", "(revoked_at is null) = (revoked_by is null)"),
        check(LINKS, "opened_at_least_once", "max_openings is null or max_openings > 0"),
    )
    index(LINKS, "studio_id")
    op.create_index(f"ix_{LINKS}_project", LINKS, ["project_id", "id"])
    op.create_table(
        SOUNDS,
        *(uuid("link_id"), number("place"), uuid("studio_id"), uuid("project_id"), uuid("take_id")),
        *keys(SOUNDS, "link_id", "place"),
        key(SOUNDS, "link_id", LINKS),
        key(SOUNDS, "take_id", TAKES),
    )
    index(SOUNDS, "studio_id", "project_id", "take_id")


def _add_visits() -> None:
    op.create_table(
        VISITS,
        *(uuid("id"), uuid("studio_id"), uuid("project_id"), uuid("link_id"), text("secret_sha256")),
        *(text("guest_name"), instant("opened_at")),
        *keys(VISITS, "id"),
        key(VISITS, "link_id", LINKS),
        unique(VISITS, "secret_sha256"),
    )
    index(VISITS, "studio_id", "project_id")
    op.create_index(f"ix_{VISITS}_link", VISITS, ["link_id", "id"])
    op.create_table(
        PLAYS,
        *(uuid("visit_id"), number("place"), uuid("studio_id"), uuid("project_id"), number("plays")),
        instant("last_at"),
        *keys(PLAYS, "visit_id", "place"),
        key(PLAYS, "visit_id", VISITS),
    )
    index(PLAYS, "studio_id", "project_id")
    op.create_table(
        COPIES,
        *(uuid("studio_id"), text("key"), text("preview_sha256"), flag("has_beeps"), text("sha256", nullable=True)),
        *(sa.Column("file_bytes", sa.BigInteger()), text("refusal", nullable=True), instant("created_at")),
        key(COPIES, "studio_id", "accounts_studios"),
        sa.PrimaryKeyConstraint("studio_id", "key", name=op.f(f"pk_{COPIES}")),
        check(COPIES, "made_or_refused", "sha256 is null or refusal is null"),
    )


def _add_playlists() -> None:
    op.create_table(
        LISTS,
        *(uuid("id"), uuid("studio_id"), uuid("project_id"), text("name"), number("edition"), uuid("made_by")),
        *(instant("created_at"), instant("removed_at", nullable=True)),
        *keys(LISTS, "id"),
        key(LISTS, "made_by", PEOPLE),
    )
    index(LISTS, "studio_id")
    op.create_index(f"ix_{LISTS}_project", LISTS, ["project_id", "id"])
    op.create_table(
        ENTRIES,
        *(uuid("playlist_id"), number("place"), uuid("studio_id"), uuid("project_id"), uuid("take_id")),
        *keys(ENTRIES, "playlist_id", "place"),
        key(ENTRIES, "playlist_id", LISTS),
        key(ENTRIES, "take_id", TAKES),
        unique(ENTRIES, "playlist_id", "take_id"),
    )
    index(ENTRIES, "studio_id", "project_id", "take_id")
    op.create_table(
        POSITIONS,
        *(uuid("playlist_id"), uuid("person_id"), uuid("studio_id"), uuid("project_id"), uuid("take_id")),
        seconds("at_s"),
        *keys(POSITIONS, "playlist_id", "person_id"),
        key(POSITIONS, "playlist_id", LISTS),
        key(POSITIONS, "person_id", PEOPLE),
        key(POSITIONS, "take_id", TAKES),
    )
    index(POSITIONS, "studio_id", "project_id")


def _add_sessions() -> None:
    op.create_table(
        SESSIONS,
        *(uuid("playlist_id"), uuid("studio_id"), uuid("project_id"), number("sequence")),
        *(uuid("holder_id", nullable=True), uuid("take_id", nullable=True), flag("is_playing")),
        *(seconds("position_s"), instant("set_at")),
        *keys(SESSIONS, "playlist_id"),
        key(SESSIONS, "playlist_id", LISTS),
        key(SESSIONS, "holder_id", PEOPLE),
        key(SESSIONS, "take_id", TAKES),
    )
    index(SESSIONS, "studio_id", "project_id")
    op.create_table(
        LISTENERS,
        *(uuid("playlist_id"), uuid("person_id"), uuid("studio_id"), uuid("project_id"), instant("seen_at")),
        *keys(LISTENERS, "playlist_id", "person_id"),
        key(LISTENERS, "playlist_id", LISTS),
        key(LISTENERS, "person_id", PEOPLE),
    )
    index(LISTENERS, "studio_id", "project_id")


def downgrade() -> None:
    for table in (VIEWS, LISTENERS, SESSIONS, POSITIONS, ENTRIES, LISTS, COPIES, PLAYS, VISITS, SOUNDS, LINKS):
        op.drop_table(table)
    written_by = sa.column("written_by")
    op.execute(sa.table(COMMENTS, written_by).delete().where(written_by.is_(None)))
    with op.batch_alter_table(COMMENTS) as table:
        table.drop_constraint(op.f(f"ck_{COMMENTS}_by_a_person_or_guest"), type_="check")
        table.alter_column("written_by", existing_type=sa.Uuid(), nullable=False)
        table.drop_column("guest_name")
