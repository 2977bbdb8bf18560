"""Hours beside days, with refusals; lines of the ledger for hours and for the months of a retainer."""

import sqlalchemy as sa
from alembic import op

import app.kit.db

revision = "0058"
down_revision = "0057"
branch_labels = None
depends_on = None

DAYS, LINES = "contracts_worked_days", "contracts_ledger_lines"
ABOUT = "cue_id is not null or milestone_id is not null or tax_bp is not null or late_invoice_id is not null"
AGREED = "(agreed_at is null) = (agreed_by is null)"
CHECKS_OF_DAYS = {
    "hours_of_a_day_at_most": "minutes between 1 and 1440",
    "in_one_unit": "(quarters is null) <> (minutes is null)",
    "agreed_at_some_time": "agreed_by is null or agreed_at is not null",
    "refused_by_somebody": "(refused_at is null) = (refused_by is null)",
    "agreed_or_refused": "agreed_at is null or refused_at is null",
}
CHECKS_OF_LINES = {
    "about_something": f"{ABOUT} or kind in ('bonus', 'worked_day', 'worked_hours', 'retainer') or about_id is not null",
    "hours_are_named": "(kind = 'worked_hours') = (worked_day_id is not null)",
    "months_are_numbered": "(kind = 'retainer') = (month_number is not null)",
}
UNIQUE = {  # index: table, columns and condition
    f"uq_{DAYS}_quarters": (DAYS, ["contract_id", "worked_on"], "quarters is not null"),
    f"uq_{LINES}_month": (LINES, ["contract_id", "month_number"], "kind = 'retainer'"),
    f"uq_{LINES}_hours": (LINES, ["worked_day_id"], "kind = 'worked_hours'"),
}
REFERRED = {"cue_id": "sound_lists_cues", "refused_by": "accounts_people"}


def upgrade() -> None:
    with op.batch_alter_table(DAYS) as table:
        for name in ("milestone_id", "quarters"):
            kind = sa.Uuid() if name == "milestone_id" else sa.Integer()
            table.alter_column(name, existing_type=kind, nullable=True)
        table.add_column(sa.Column("cue_id", sa.Uuid()))
        table.add_column(sa.Column("minutes", sa.Integer()))
        table.add_column(sa.Column("refused_by", sa.Uuid()))
        table.add_column(sa.Column("refused_at", app.kit.db.UtcDateTime(timezone=True)))
        table.add_column(sa.Column("refusal", sa.String(), nullable=False, server_default=""))
        for name, other in REFERRED.items():
            table.create_foreign_key(op.f(f"fk_{DAYS}_{name}"), other, [name], ["id"])
        table.drop_constraint(op.f(f"uq_{DAYS}_contract_id_worked_on"), type_="unique")
        table.drop_constraint(op.f(f"ck_{DAYS}_agreed_by_somebody"), type_="check")
        for name, condition in CHECKS_OF_DAYS.items():
            table.create_check_constraint(op.f(f"ck_{DAYS}_{name}"), condition)
    with op.batch_alter_table(DAYS) as table:
        table.alter_column("refusal", existing_type=sa.String(), server_default=None)
    op.create_index(op.f(f"ix_{DAYS}_contract_id"), DAYS, ["contract_id"])
    with op.batch_alter_table(LINES) as table:
        table.add_column(sa.Column("worked_day_id", sa.Uuid()))
        table.add_column(sa.Column("month_number", sa.Integer()))
        table.create_foreign_key(op.f(f"fk_{LINES}_worked_day_id"), DAYS, ["worked_day_id"], ["id"])
        table.drop_constraint(op.f(f"ck_{LINES}_about_something"), type_="check")
        for name, condition in CHECKS_OF_LINES.items():
            table.create_check_constraint(op.f(f"ck_{LINES}_{name}"), condition)
    for name, (table_name, columns, condition) in UNIQUE.items():
        where = sa.text(condition)
        op.create_index(name, table_name, columns, unique=True, sqlite_where=where, postgresql_where=where)


def downgrade() -> None:
    """Take it back; hours, refusals and their lines are refused by the older tables."""
    for name, (table_name, *_) in UNIQUE.items():
        op.drop_index(name, table_name)
    with op.batch_alter_table(LINES) as table:
        for name in CHECKS_OF_LINES:
            table.drop_constraint(op.f(f"ck_{LINES}_{name}"), type_="check")
        table.create_check_constraint(
            op.f(f"ck_{LINES}_about_something"), f"{ABOUT} or kind = 'bonus' or about_id is not null"
        )
        table.drop_constraint(op.f(f"fk_{LINES}_worked_day_id"), type_="foreignkey")
        table.drop_column("month_number")
        table.drop_column("worked_day_id")
    op.drop_index(op.f(f"ix_{DAYS}_contract_id"), DAYS)
    with op.batch_alter_table(DAYS) as table:
        for name in CHECKS_OF_DAYS:
            table.drop_constraint(op.f(f"ck_{DAYS}_{name}"), type_="check")
        table.create_check_constraint(op.f(f"ck_{DAYS}_agreed_by_somebody"), AGREED)
        table.create_unique_constraint(op.f(f"uq_{DAYS}_contract_id_worked_on"), ["contract_id", "worked_on"])
        for name in REFERRED:
            table.drop_constraint(op.f(f"fk_{DAYS}_{name}"), type_="foreignkey")
        for name in ("refusal", "refused_at", "refused_by", "minutes", "cue_id"):
            table.drop_column(name)
        table.alter_column("quarters", existing_type=sa.Integer(), nullable=False)
        table.alter_column("milestone_id", existing_type=sa.Uuid(), nullable=False)
