"""Postings, who may bid, bids, questions and the team's scores."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

revision = "0036"
down_revision = "0035"
branch_labels = None
depends_on = None

TABLES = ("hiring_scores", "hiring_questions", "hiring_bids", "hiring_candidates", "hiring_postings")


def instant(name: str, *, nullable: bool = True) -> sa.Column:
    return sa.Column(name, sa.DateTime(timezone=True), nullable=nullable)


def text(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, sa.String(), nullable=nullable)


def document(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, sa.JSON().with_variant(JSONB(), "postgresql"), nullable=nullable)


def uuid(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, sa.Uuid(), nullable=nullable)


def key(table: str, column: str, other: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{table}_{column}"))


def keys(table: str, *people: str) -> tuple[sa.ForeignKeyConstraint, ...]:
    return (
        key(table, "studio_id", "accounts_studios"),
        key(table, "project_id", "projects_projects"),
        *(key(table, person, "accounts_people") for person in people),
    )


def primary(table: str, *columns: str) -> sa.PrimaryKeyConstraint:
    return sa.PrimaryKeyConstraint(*columns, name=op.f(f"pk_{table}"))


def index(table: str, *columns: str) -> None:
    for column in columns:
        op.create_index(op.f(f"ix_{table}_{column}"), table, [column])


def upgrade() -> None:
    scores, questions, bids, candidates, postings = TABLES
    op.create_table(
        postings,
        uuid("id"),
        uuid("studio_id"),
        uuid("project_id"),
        text("title"),
        text("text"),
        text("phase"),
        text("state"),
        sa.Column("revision", sa.Integer(), nullable=False),
        text("currency"),
        *(sa.Column(name, sa.BigInteger()) for name in ("price_minor", "budget_minor")),
        sa.Column("is_budget_shown", sa.Boolean(), nullable=False),
        sa.Column("rate_floor_minor", sa.BigInteger()),
        text("scope"),
        *(document(name) for name in ("categories", "cue_ids", "lines", "headings")),
        *(sa.Column(name, sa.Date()) for name in ("bids_until_on", "work_from_on", "work_to_on")),
        text("secret_sha256", nullable=True),
        uuid("created_by"),
        instant("created_at", nullable=False),
        instant("opened_at"),
        instant("closed_at"),
        uuid("awarded_bid_id", nullable=True),
        instant("awarded_at"),
        uuid("contract_id", nullable=True),
        *keys(postings, "created_by"),
        primary(postings, "id"),
        sa.UniqueConstraint("secret_sha256", name=op.f(f"uq_{postings}_secret_sha256")),
    )
    index(postings, "studio_id", "project_id")
    op.create_table(
        candidates,
        uuid("id"),
        uuid("studio_id"),
        uuid("project_id"),
        uuid("posting_id"),
        text("email"),
        uuid("person_id", nullable=True),
        uuid("invited_by", nullable=True),
        instant("created_at", nullable=False),
        instant("expires_at", nullable=False),
        instant("joined_at"),
        instant("revoked_at"),
        text("secret_sha256", nullable=True),
        sa.Column("is_sent_by_mail_only", sa.Boolean(), nullable=False),
        key(candidates, "posting_id", postings),
        *keys(candidates, "person_id", "invited_by"),
        primary(candidates, "id"),
        sa.UniqueConstraint("posting_id", "email", name=op.f(f"uq_{candidates}_posting_id_email")),
        sa.UniqueConstraint("posting_id", "person_id", name=op.f(f"uq_{candidates}_posting_id_person_id")),
        sa.UniqueConstraint("secret_sha256", name=op.f(f"uq_{candidates}_secret_sha256")),
    )
    index(candidates, "studio_id", "project_id", "person_id")
    op.create_table(
        bids,
        uuid("id"),
        uuid("studio_id"),
        uuid("project_id"),
        uuid("posting_id"),
        uuid("designer_id"),
        text("state"),
        sa.Column("revision", sa.Integer(), nullable=False),
        document("content"),
        document("sent", nullable=True),
        instant("sent_at"),
        instant("resent_at"),
        instant("changed_at", nullable=False),
        sa.Column("is_shortlisted", sa.Boolean(), nullable=False),
        key(bids, "posting_id", postings),
        *keys(bids, "designer_id"),
        primary(bids, "id"),
        sa.UniqueConstraint("posting_id", "designer_id", name=op.f(f"uq_{bids}_posting_id_designer_id")),
    )
    index(bids, "studio_id", "project_id", "designer_id")
    op.create_table(
        questions,
        uuid("id"),
        uuid("studio_id"),
        uuid("project_id"),
        uuid("posting_id"),
        text("text"),
        uuid("asked_by"),
        instant("asked_at", nullable=False),
        text("answer", nullable=True),
        sa.Column("is_for_all", sa.Boolean(), nullable=False),
        uuid("answered_by", nullable=True),
        instant("answered_at"),
        key(questions, "posting_id", postings),
        *keys(questions, "asked_by", "answered_by"),
        primary(questions, "id"),
    )
    index(questions, "studio_id", "project_id", "posting_id")
    op.create_table(
        scores,
        uuid("bid_id"),
        uuid("person_id"),
        uuid("studio_id"),
        uuid("project_id"),
        document("scores"),
        text("note"),
        instant("changed_at", nullable=False),
        key(scores, "bid_id", bids),
        *keys(scores, "person_id"),
        primary(scores, "bid_id", "person_id"),
    )
    index(scores, "studio_id", "project_id")


def downgrade() -> None:
    for table in TABLES:
        op.drop_table(table)
