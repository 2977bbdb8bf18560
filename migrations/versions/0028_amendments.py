"""Notices that contracts end early, change orders, and who agreed to the text of either."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

import app.kit.db

revision = "0028"
down_revision = "0027"
branch_labels = None
depends_on = None

PARTIES = ("studio", "designer")
PROOFS = ("mail", "operator")
ORDER_STATES = ("proposed", "agreed", "refused", "withdrawn", "lapsed")


def enum(name: str, values: tuple[str, ...]) -> sa.Enum:
    return sa.Enum(*values, name=name, native_enum=False, length=32)


def instant() -> app.kit.db.UtcDateTime:
    return app.kit.db.UtcDateTime(timezone=True)


def columns_of(table: str) -> list[sa.schema.SchemaItem]:
    """Return the columns that each table begins with, and their constraints."""
    named = {
        "studio_id": "accounts_studios",
        "project_id": "projects_projects",
        "contract_id": "contracts_contracts",
    }
    return [
        sa.Column("id", sa.Uuid(), nullable=False),
        *(sa.Column(name, sa.Uuid(), nullable=False) for name in named),
        *(
            sa.ForeignKeyConstraint([name], [f"{other}.id"], name=op.f(f"fk_{table}_{name}"))
            for name, other in named.items()
        ),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{table}")),
    ]


def index_tenants(table: str) -> None:
    for name in ("studio_id", "project_id"):
        op.create_index(op.f(f"ix_{table}_{name}"), table, [name])


def person(table: str, name: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint([name], ["accounts_people.id"], name=op.f(f"fk_{table}_{name}"))


def upgrade() -> None:
    notices = "contracts_notices"
    op.create_table(
        notices,
        *columns_of(notices),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("party", enum("party", PARTIES), nullable=False),
        sa.Column("given_by", sa.Uuid(), nullable=False),
        sa.Column("given_at", instant(), nullable=False),
        sa.Column("reason", sa.String(), nullable=False),
        sa.Column("ends_on", sa.Date()),
        sa.Column("withdrawn_at", instant()),
        sa.Column("settled_at", instant()),
        sa.Column("statement", sa.String()),
        sa.Column("statement_sha256", sa.String()),
        person(notices, "given_by"),
        sa.UniqueConstraint("contract_id", "number", name=op.f(f"uq_{notices}_contract_id_number")),
        sa.CheckConstraint(
            "withdrawn_at is null or settled_at is null", name=op.f(f"ck_{notices}_withdrawn_or_settled")
        ),
        sa.CheckConstraint(
            "(settled_at is null) = (statement is null)", name=op.f(f"ck_{notices}_settled_by_a_statement")
        ),
        sa.CheckConstraint(
            "(statement is null) = (statement_sha256 is null)", name=op.f(f"ck_{notices}_statement_has_hash")
        ),
    )
    index_tenants(notices)
    op.create_index(
        f"uq_{notices}_standing",
        notices,
        ["contract_id"],
        unique=True,
        sqlite_where=sa.text("withdrawn_at is null"),
        postgresql_where=sa.text("withdrawn_at is null"),
    )
    orders = "contracts_change_orders"
    op.create_table(
        orders,
        *columns_of(orders),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("state", enum("changeorderstate", ORDER_STATES), nullable=False),
        sa.Column("party", enum("party", PARTIES), nullable=False),
        sa.Column("proposed_by", sa.Uuid(), nullable=False),
        sa.Column("proposed_at", instant(), nullable=False),
        sa.Column("reason", sa.String(), nullable=False),
        sa.Column("begins_at_once", sa.Boolean(), nullable=False),
        sa.Column("changes", sa.JSON().with_variant(JSONB(), "postgresql"), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("text_sha256", sa.String(), nullable=False),
        sa.Column("closed_at", instant()),
        sa.Column("close_reason", sa.String(), nullable=False),
        person(orders, "proposed_by"),
        sa.UniqueConstraint("contract_id", "number", name=op.f(f"uq_{orders}_contract_id_number")),
        sa.CheckConstraint("(state = 'proposed') = (closed_at is null)", name=op.f(f"ck_{orders}_closed_is_dated")),
    )
    index_tenants(orders)
    acceptances = "contracts_amendment_acceptances"
    op.create_table(
        acceptances,
        *columns_of(acceptances),
        sa.Column("text_sha256", sa.String(), nullable=False),
        sa.Column("party", enum("party", PARTIES), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("email", sa.String(), nullable=False),
        sa.Column("email_proof", enum("addressproof", PROOFS)),
        sa.Column("address", sa.String(), nullable=False),
        sa.Column("accepted_at", instant(), nullable=False),
        person(acceptances, "person_id"),
        sa.UniqueConstraint("contract_id", "text_sha256", "party", name=f"uq_{acceptances}_party"),
    )
    index_tenants(acceptances)


def downgrade() -> None:
    for table in ("contracts_amendment_acceptances", "contracts_change_orders", "contracts_notices"):
        op.drop_table(table)
