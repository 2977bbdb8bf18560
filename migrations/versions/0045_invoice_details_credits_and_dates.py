"""Invoice details of studios and people, credits, and reminders of the days that contracts name."""

import sqlalchemy as sa
from alembic import op

revision = "0045"
down_revision = "0044"
branch_labels = None
depends_on = None

DETAILS, NAMES, LINES = "accounts_invoice_details", "projects_credit_names", "projects_credit_lines"
REMINDERS = "contracts_date_reminders"
TEXTS = (
    *("name", "street", "postal_code", "city", "country_code"),
    *("vat_id", "tax_number", "account_number", "no_tax_reason"),
)


def instant(name: str) -> sa.Column:
    return sa.Column(name, sa.DateTime(timezone=True), nullable=False)


def text(name: str) -> sa.Column:
    return sa.Column(name, sa.String(), nullable=False)


def uuid(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, sa.Uuid(), nullable=nullable)


def key(table: str, column: str, other: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{table}_{column}"))


def primary(table: str, *columns: str) -> sa.PrimaryKeyConstraint:
    return sa.PrimaryKeyConstraint(*columns, name=op.f(f"pk_{table}"))


def index(table: str, *columns: str) -> None:
    for column in columns:
        op.create_index(op.f(f"ix_{table}_{column}"), table, [column])


def upgrade() -> None:
    op.create_table(
        DETAILS,
        uuid("id"),
        uuid("studio_id", nullable=True),
        uuid("person_id", nullable=True),
        *(text(name) for name in TEXTS),
        uuid("saved_by"),
        instant("saved_at"),
        key(DETAILS, "studio_id", "accounts_studios"),
        key(DETAILS, "person_id", "accounts_people"),
        key(DETAILS, "saved_by", "accounts_people"),
        primary(DETAILS, "id"),
        sa.CheckConstraint("(studio_id is null) <> (person_id is null)", name=op.f(f"ck_{DETAILS}_one_owner")),
    )
    index(DETAILS, "studio_id", "person_id")
    op.create_table(
        NAMES,
        uuid("project_id"),
        uuid("person_id"),
        uuid("studio_id"),
        text("name"),
        sa.Column("is_left_out", sa.Boolean(), nullable=False),
        instant("changed_at"),
        key(NAMES, "project_id", "projects_projects"),
        key(NAMES, "person_id", "accounts_people"),
        key(NAMES, "studio_id", "accounts_studios"),
        primary(NAMES, "project_id", "person_id"),
    )
    index(NAMES, "person_id", "studio_id")
    op.create_table(
        LINES,
        uuid("id"),
        uuid("studio_id"),
        uuid("project_id"),
        text("role"),
        text("name"),
        uuid("added_by"),
        instant("added_at"),
        key(LINES, "studio_id", "accounts_studios"),
        key(LINES, "project_id", "projects_projects"),
        key(LINES, "added_by", "accounts_people"),
        primary(LINES, "id"),
        sa.CheckConstraint("role <> '' and name <> ''", name=op.f(f"ck_{LINES}_role_and_name")),
    )
    index(LINES, "studio_id", "project_id")
    op.create_table(
        REMINDERS,
        uuid("contract_id"),
        text("term"),
        sa.Column("day", sa.Date(), nullable=False),
        uuid("studio_id"),
        uuid("project_id"),
        instant("sent_at"),
        key(REMINDERS, "contract_id", "contracts_contracts"),
        key(REMINDERS, "studio_id", "accounts_studios"),
        key(REMINDERS, "project_id", "projects_projects"),
        primary(REMINDERS, "contract_id", "term", "day"),
    )
    index(REMINDERS, "studio_id", "project_id")


def downgrade() -> None:
    for table in (REMINDERS, LINES, NAMES, DETAILS):
        op.drop_table(table)
