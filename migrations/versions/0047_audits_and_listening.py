"""Audits of game builds, accepted drift, listening passes with their notes, and tasks."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

revision = "0047"
down_revision = "0046"
branch_labels = None
depends_on = None

AUDITS, SOUNDS, ACCEPTED = "builds_audits", "builds_audited_sounds", "builds_accepted_drifts"
PASSES, NOTES, TASKS = "builds_listening_passes", "builds_listening_notes", "builds_game_tasks"
MARKS = "builds_marked_cues"
PEOPLE = "accounts_people"


def instant(name: str, *, nullable: bool = True) -> sa.Column:
    return sa.Column(name, sa.DateTime(timezone=True), nullable=nullable)


def text(name: str) -> sa.Column:
    return sa.Column(name, sa.String(), nullable=False)


def word(name: str) -> sa.Column:
    return sa.Column(name, sa.String(length=32), nullable=False)


def number(name: str) -> sa.Column:
    return sa.Column(name, sa.Integer(), nullable=False)


def level(name: str) -> sa.Column:
    return sa.Column(name, sa.Double())


def document(name: str) -> sa.Column:
    return sa.Column(name, sa.JSON().with_variant(JSONB(), "postgresql"), nullable=False)


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


def index(table: str, *columns: str) -> None:
    for column in columns:
        op.create_index(op.f(f"ix_{table}_{column}"), table, [column])


def upgrade() -> None:
    _add_audits()
    _add_passes()
    op.create_table(
        TASKS,
        *(uuid("id"), uuid("studio_id"), uuid("project_id"), uuid("cue_id", nullable=True)),
        *(text("path"), word("kind"), word("role"), uuid("assignee_id", nullable=True), level("gain_db")),
        *(text("where"), text("text"), uuid("note_id", nullable=True), uuid("audit_id", nullable=True)),
        *(uuid("asked_by"), instant("asked_at", nullable=False), uuid("done_by", nullable=True), instant("done_at")),
        *keys(TASKS, "id"),
        *(key(TASKS, person, PEOPLE) for person in ("assignee_id", "asked_by", "done_by")),
        key(TASKS, "cue_id", "sound_lists_cues"),
        key(TASKS, "note_id", NOTES),
        key(TASKS, "audit_id", AUDITS),
        sa.UniqueConstraint("note_id", name=op.f(f"uq_{TASKS}_note_id")),
        check(TASKS, "done_by_a_person", "(done_at is null) = (done_by is null)"),
        check(TASKS, "from_note_or_audit", "(note_id is null) <> (audit_id is null)"),
    )
    index(TASKS, "studio_id")
    op.create_index(f"ix_{TASKS}_project", TASKS, ["project_id", "done_at", "id"])
    op.create_table(
        MARKS,
        *(uuid("cue_id"), word("mark"), uuid("studio_id"), uuid("project_id"), uuid("marked_by")),
        instant("marked_at", nullable=False),
        *keys(MARKS, "cue_id", "mark"),
        key(MARKS, "cue_id", "sound_lists_cues"),
        key(MARKS, "marked_by", PEOPLE),
    )
    index(MARKS, "studio_id", "project_id")


def _add_audits() -> None:
    op.create_table(
        AUDITS,
        *(uuid("id"), uuid("studio_id"), uuid("project_id"), text("label"), text("commit"), text("target")),
        *(text("engine"), number("sounds"), number("drifted"), number("new_drifts"), document("unread")),
        *(uuid("token_id", nullable=True), instant("created_at", nullable=False)),
        *keys(AUDITS, "id"),
        key(AUDITS, "token_id", "accounts_tokens"),
    )
    index(AUDITS, "studio_id")
    op.create_index(f"ix_{AUDITS}_newest", AUDITS, ["project_id", "target", "id"])
    op.create_table(
        SOUNDS,
        *(uuid("audit_id"), number("place"), uuid("studio_id"), uuid("project_id"), text("path")),
        *(uuid("cue_id", nullable=True), uuid("take_id", nullable=True), word("status"), word("played_status")),
        sa.Column("has_drifted", sa.Boolean(), nullable=False),
        *(level("gain_db"), level("file_db"), level("property_db"), text("message")),
        *(document("moves"), document("depends"), document("events")),
        *keys(SOUNDS, "audit_id", "place"),
        key(SOUNDS, "audit_id", AUDITS),
        key(SOUNDS, "cue_id", "sound_lists_cues"),
        key(SOUNDS, "take_id", "deliveries_takes"),
    )
    index(SOUNDS, "studio_id", "cue_id")
    op.create_index(f"ix_{SOUNDS}_history", SOUNDS, ["project_id", "path", "audit_id"])
    op.create_index(f"ix_{SOUNDS}_drift", SOUNDS, ["audit_id", "has_drifted", "place"])
    op.create_table(
        ACCEPTED,
        *(uuid("id"), uuid("studio_id"), uuid("project_id"), text("target"), text("path")),
        *(word("status"), word("played_status"), level("gain_db"), text("reason")),
        *(uuid("accepted_by"), instant("accepted_at", nullable=False)),
        *(uuid("withdrawn_by", nullable=True), instant("withdrawn_at")),
        *keys(ACCEPTED, "id"),
        key(ACCEPTED, "accepted_by", PEOPLE),
        key(ACCEPTED, "withdrawn_by", PEOPLE),
        check(ACCEPTED, "withdrawn_by_a_person", "(withdrawn_at is null) = (withdrawn_by is null)"),
    )
    index(ACCEPTED, "studio_id")
    op.create_index(f"ix_{ACCEPTED}_project", ACCEPTED, ["project_id", "id"])


def _add_passes() -> None:
    op.create_table(
        PASSES,
        *(uuid("id"), uuid("studio_id"), uuid("project_id"), uuid("audit_id"), uuid("started_by")),
        *(instant("started_at", nullable=False), uuid("closed_by", nullable=True), instant("closed_at")),
        *keys(PASSES, "id"),
        key(PASSES, "audit_id", AUDITS),
        key(PASSES, "started_by", PEOPLE),
        key(PASSES, "closed_by", PEOPLE),
        check(PASSES, "closed_by_a_person", "(closed_at is null) = (closed_by is null)"),
    )
    index(PASSES, "studio_id", "project_id")
    is_open = sa.text("closed_at is null")
    op.create_index(
        f"uq_{PASSES}_open", PASSES, ["project_id"], unique=True, sqlite_where=is_open, postgresql_where=is_open
    )
    op.create_table(
        NOTES,
        *(uuid("id"), uuid("studio_id"), uuid("project_id"), uuid("pass_id"), uuid("cue_id"), word("said")),
        *(level("amount_db"), text("text"), uuid("written_by"), instant("written_at", nullable=False)),
        *(instant("received_at", nullable=False), instant("undone_at")),
        *keys(NOTES, "id"),
        key(NOTES, "pass_id", PASSES),
        key(NOTES, "cue_id", "sound_lists_cues"),
        key(NOTES, "written_by", PEOPLE),
    )
    index(NOTES, "studio_id")
    op.create_index(f"ix_{NOTES}_pass", NOTES, ["pass_id", "cue_id"])
    op.create_index(f"ix_{NOTES}_heard", NOTES, ["project_id", "said", "cue_id"])


def downgrade() -> None:
    for table in (MARKS, TASKS, NOTES, PASSES, ACCEPTED, SOUNDS, AUDITS):
        op.drop_table(table)
