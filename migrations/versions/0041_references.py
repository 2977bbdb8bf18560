"""References, their versions, and who opened them."""

import sqlalchemy as sa
from alembic import op

revision = "0041"
down_revision = "0040"
branch_labels = None
depends_on = None

REFERENCES, VERSIONS, OPENINGS = "references_references", "references_versions", "references_openings"


def instant(name: str, *, nullable: bool = True) -> sa.Column:
    return sa.Column(name, sa.DateTime(timezone=True), nullable=nullable)


def text(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, sa.String(), nullable=nullable)


def word(name: str) -> sa.Column:
    return sa.Column(name, sa.String(length=32), nullable=False)


def number(name: str, *, nullable: bool = True) -> sa.Column:
    return sa.Column(name, sa.Integer(), nullable=nullable)


def uuid(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, sa.Uuid(), nullable=nullable)


def key(table: str, column: str, other: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{table}_{column}"))


def keys(table: str, *people: str) -> tuple[sa.ForeignKeyConstraint, ...]:
    return (
        key(table, "studio_id", "accounts_studios"),
        key(table, "project_id", "projects_projects"),
        *(key(table, person, "accounts_people") for person in people),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{table}")),
    )


def check(table: str, name: str, condition: str) -> sa.CheckConstraint:
    return sa.CheckConstraint(condition, name=op.f(f"ck_{table}_{name}"))


def index(table: str, *columns: str) -> None:
    for column in columns:
        op.create_index(op.f(f"ix_{table}_{column}"), table, [column])


def upgrade() -> None:
    op.create_table(
        REFERENCES,
        uuid("id"),
        uuid("studio_id"),
        uuid("project_id"),
        uuid("cue_id", nullable=True),
        text("category", nullable=True),
        text("caption"),
        text("terms"),
        sa.Column("start_s", sa.Double()),
        sa.Column("end_s", sa.Double()),
        number("newest_number", nullable=False),
        uuid("added_by"),
        instant("added_at", nullable=False),
        uuid("removed_by", nullable=True),
        instant("removed_at"),
        *keys(REFERENCES, "added_by", "removed_by"),
        key(REFERENCES, "cue_id", "sound_lists_cues"),
        check(REFERENCES, "pinned_once", "cue_id is null or category is null"),
        check(REFERENCES, "removed_by_a_person", "(removed_at is null) = (removed_by is null)"),
        check(REFERENCES, "range_ends_later", "end_s is null or end_s > start_s"),
    )
    index(REFERENCES, "studio_id", "cue_id")
    op.create_index(f"ix_{REFERENCES}_board", REFERENCES, ["project_id", "id"])
    op.create_table(
        VERSIONS,
        uuid("id"),
        uuid("studio_id"),
        uuid("project_id"),
        uuid("reference_id"),
        number("number", nullable=False),
        word("kind"),
        text("media_type"),
        text("file_name"),
        text("url", nullable=True),
        text("sha256", nullable=True),
        sa.Column("file_bytes", sa.BigInteger()),
        text("excerpt"),
        word("preview"),
        text("problem"),
        number("width_px"),
        number("height_px"),
        text("thumb_sha256", nullable=True),
        number("thumb_bytes"),
        text("view_sha256", nullable=True),
        number("view_bytes"),
        uuid("added_by"),
        instant("added_at", nullable=False),
        *keys(VERSIONS, "added_by"),
        key(VERSIONS, "reference_id", REFERENCES),
        sa.UniqueConstraint("reference_id", "number", name=op.f(f"uq_{VERSIONS}_reference_id_number")),
        check(VERSIONS, "file_or_link", "(url is null) <> (sha256 is null)"),
        check(VERSIONS, "file_has_a_size", "(sha256 is null) = (file_bytes is null)"),
    )
    index(VERSIONS, "project_id")
    op.create_index(f"ix_{VERSIONS}_kept", VERSIONS, ["studio_id", "sha256", "file_bytes"])
    op.create_table(
        OPENINGS,
        uuid("id"),
        uuid("studio_id"),
        uuid("project_id"),
        uuid("version_id"),
        uuid("person_id"),
        instant("opened_at", nullable=False),
        *keys(OPENINGS, "person_id"),
        key(OPENINGS, "version_id", VERSIONS),
    )
    index(OPENINGS, "studio_id", "person_id")
    op.create_index(f"ix_{OPENINGS}_of_person", OPENINGS, ["version_id", "person_id", "opened_at"])
    op.create_index(f"ix_{OPENINGS}_log", OPENINGS, ["project_id", "id"])


def downgrade() -> None:
    for table in (OPENINGS, VERSIONS, REFERENCES):
        op.drop_table(table)
