"""Sources of takes, a studio's calendar, pauses of the clause on silence, and late interest."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

import app.kit.db

revision = "0030"
down_revision = "0029"
branch_labels = None
depends_on = None

SOURCES, HOLIDAYS, PAUSES = "deliveries_source_statements", "accounts_holidays", "reviews_clock_pauses"
LINES, VERDICTS = "contracts_ledger_lines", "reviews_verdicts"
ABOUT_SOMETHING = "cue_id is not null or milestone_id is not null or tax_bp is not null"


def instant() -> app.kit.db.UtcDateTime:
    return app.kit.db.UtcDateTime(timezone=True)


def refers(table: str, column: str, other: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{table}_{column}"))


def columns_of(table: str, **more: str) -> list[sa.schema.SchemaItem]:
    """Return the columns that name what a row belongs to, and their constraints."""
    named = {"studio_id": "accounts_studios", "project_id": "projects_projects", **more}
    return [
        sa.Column("id", sa.Uuid(), nullable=False),
        *(sa.Column(name, sa.Uuid(), nullable=False) for name in named),
        *(refers(table, name, other) for name, other in named.items()),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{table}")),
    ]


def index(table: str, *columns: str) -> None:
    for column in columns:
        op.create_index(op.f(f"ix_{table}_{column}"), table, [column])


def upgrade() -> None:
    op.create_table(
        SOURCES,
        *columns_of(SOURCES, delivery_id="deliveries_deliveries", designer_id="accounts_people"),
        sa.Column("take_id", sa.Uuid()),
        sa.Column("sources", sa.JSON().with_variant(JSONB(), "postgresql"), nullable=False),
        sa.Column("stated_at", instant(), nullable=False),
        refers(SOURCES, "take_id", "deliveries_takes"),
        sa.UniqueConstraint("take_id", name=op.f(f"uq_{SOURCES}_take_id")),
    )
    index(SOURCES, "project_id", "delivery_id")
    op.create_index(f"ix_{SOURCES}_remembered", SOURCES, ["studio_id", "designer_id", "stated_at"])
    without_take = sa.text("take_id is null")
    op.create_index(
        f"uq_{SOURCES}_delivery",
        SOURCES,
        ["delivery_id"],
        unique=True,
        sqlite_where=without_take,
        postgresql_where=without_take,
    )

    op.create_table(
        HOLIDAYS,
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("day", sa.Date(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("created_at", instant(), nullable=False),
        refers(HOLIDAYS, "studio_id", "accounts_studios"),
        sa.PrimaryKeyConstraint("studio_id", "day", name=op.f(f"pk_{HOLIDAYS}")),
    )
    with op.batch_alter_table("accounts_studios") as table:
        table.add_column(sa.Column("time_zone", sa.String(), nullable=False, server_default="UTC"))

    op.create_table(
        PAUSES,
        *columns_of(PAUSES, contract_id="contracts_contracts"),
        sa.Column("change_order", sa.Integer(), nullable=False),
        sa.Column("began_at", instant(), nullable=False),
        sa.Column("ended_at", instant()),
        sa.CheckConstraint("ended_at is null or ended_at >= began_at", name=op.f(f"ck_{PAUSES}_ends_after_it_began")),
    )
    index(PAUSES, "studio_id", "project_id", "contract_id")
    with op.batch_alter_table(VERDICTS) as table:
        table.alter_column("given_by", existing_type=sa.Uuid(), nullable=True)
        table.create_check_constraint(
            op.f(f"ck_{VERDICTS}_given_or_deemed"), "given_by is not null or deemed_by_contract_id is not null"
        )

    with op.batch_alter_table(LINES) as table:
        table.alter_column("person_id", existing_type=sa.Uuid(), nullable=True)
        table.add_column(sa.Column("late_invoice_id", sa.Uuid()))
        table.add_column(sa.Column("late_until_on", sa.Date()))
        table.create_foreign_key(op.f(f"fk_{LINES}_late_invoice_id"), "contracts_invoices", ["late_invoice_id"], ["id"])
        table.drop_constraint(op.f(f"ck_{LINES}_about_something"), type_="check")
        table.create_check_constraint(
            op.f(f"ck_{LINES}_about_something"), f"{ABOUT_SOMETHING} or late_invoice_id is not null"
        )
        table.create_check_constraint(
            op.f(f"ck_{LINES}_late_until_a_day"), "(late_invoice_id is null) = (late_until_on is null)"
        )


def downgrade() -> None:
    """Take it all back; verdicts and lines that name nobody keep none, so they are refused by the older tables."""
    for table in (PAUSES, HOLIDAYS, SOURCES):
        op.drop_table(table)
    with op.batch_alter_table(LINES) as table:
        table.drop_constraint(op.f(f"ck_{LINES}_late_until_a_day"), type_="check")
        table.drop_constraint(op.f(f"ck_{LINES}_about_something"), type_="check")
        table.create_check_constraint(op.f(f"ck_{LINES}_about_something"), ABOUT_SOMETHING)
        table.drop_constraint(op.f(f"fk_{LINES}_late_invoice_id"), type_="foreignkey")
        table.drop_column("late_until_on")
        table.drop_column("late_invoice_id")
        table.alter_column("person_id", existing_type=sa.Uuid(), nullable=False)
    with op.batch_alter_table(VERDICTS) as table:
        table.drop_constraint(op.f(f"ck_{VERDICTS}_given_or_deemed"), type_="check")
        table.alter_column("given_by", existing_type=sa.Uuid(), nullable=False)
    with op.batch_alter_table("accounts_studios") as table:
        table.drop_column("time_zone")
