"""Milestones, prices, the ledger, invoices and payments of contracts."""

import sqlalchemy as sa
from alembic import op

import app.kit.db

revision = "0008"
down_revision = "0007"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.create_table(
        "contracts_calendar_links",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("secret_sha256", sa.String(), nullable=False),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.Column("revoked_at", app.kit.db.UtcDateTime(timezone=True), nullable=True),
        sa.ForeignKeyConstraint(
            ["person_id"], ["accounts_people.id"], name=op.f("fk_contracts_calendar_links_person_id")
        ),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_calendar_links_project_id")
        ),
        sa.ForeignKeyConstraint(
            ["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_calendar_links_studio_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_calendar_links")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_contracts_calendar_links_secret_sha256")),
    )
    with op.batch_alter_table("contracts_calendar_links", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_contracts_calendar_links_person_id"), ["person_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_calendar_links_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_calendar_links_studio_id"), ["studio_id"], unique=False)

    op.create_table(
        "contracts_extra_rounds",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("proposed_by", sa.Uuid(), nullable=False),
        sa.Column("proposed_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.Column("agreed_by", sa.Uuid(), nullable=True),
        sa.Column("agreed_at", app.kit.db.UtcDateTime(timezone=True), nullable=True),
        sa.Column("dropped_at", app.kit.db.UtcDateTime(timezone=True), nullable=True),
        sa.CheckConstraint(
            "agreed_at is null or dropped_at is null", name=op.f("ck_contracts_extra_rounds_agreed_or_dropped")
        ),
        sa.ForeignKeyConstraint(
            ["agreed_by"], ["accounts_people.id"], name=op.f("fk_contracts_extra_rounds_agreed_by")
        ),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_extra_rounds_contract_id")
        ),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_contracts_extra_rounds_cue_id")),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_extra_rounds_project_id")
        ),
        sa.ForeignKeyConstraint(
            ["proposed_by"], ["accounts_people.id"], name=op.f("fk_contracts_extra_rounds_proposed_by")
        ),
        sa.ForeignKeyConstraint(
            ["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_extra_rounds_studio_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_extra_rounds")),
        sa.UniqueConstraint(
            "contract_id", "cue_id", "number", name=op.f("uq_contracts_extra_rounds_contract_id_cue_id_number")
        ),
    )
    with op.batch_alter_table("contracts_extra_rounds", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_contracts_extra_rounds_cue_id"), ["cue_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_extra_rounds_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_extra_rounds_studio_id"), ["studio_id"], unique=False)

    op.create_table(
        "contracts_invoices",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("issued_on", sa.Date(), nullable=False),
        sa.Column("due_on", sa.Date(), nullable=False),
        sa.Column("po_number", sa.String(), nullable=False),
        sa.Column("seller", sa.String(), nullable=False),
        sa.Column("buyer", sa.String(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("reverse_charge", sa.Boolean(), nullable=False),
        sa.Column("issued_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.CheckConstraint("number > 0", name=op.f("ck_contracts_invoices_numbered_from_one")),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_invoices_contract_id")
        ),
        sa.ForeignKeyConstraint(
            ["designer_id"], ["accounts_people.id"], name=op.f("fk_contracts_invoices_designer_id")
        ),
        sa.ForeignKeyConstraint(["issued_by"], ["accounts_people.id"], name=op.f("fk_contracts_invoices_issued_by")),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_invoices_project_id")
        ),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_invoices_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_invoices")),
        sa.UniqueConstraint(
            "studio_id", "designer_id", "number", name=op.f("uq_contracts_invoices_studio_id_designer_id_number")
        ),
    )
    with op.batch_alter_table("contracts_invoices", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_contracts_invoices_contract_id"), ["contract_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_invoices_designer_id"), ["designer_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_invoices_project_id"), ["project_id"], unique=False)

    op.create_table(
        "contracts_milestones",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("position", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("is_deposit", sa.Boolean(), nullable=False),
        sa.Column("amount_minor", sa.BigInteger(), nullable=False),
        sa.Column("due_on", sa.Date(), nullable=True),
        sa.Column("tax_bp", sa.Integer(), nullable=True),
        sa.CheckConstraint("amount_minor >= 0", name=op.f("ck_contracts_milestones_amount_not_negative")),
        sa.CheckConstraint("tax_bp between 0 and 10000", name=op.f("ck_contracts_milestones_tax_is_a_part")),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_milestones_contract_id")
        ),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_milestones_project_id")
        ),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_milestones_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_milestones")),
        sa.UniqueConstraint("contract_id", "position", name=op.f("uq_contracts_milestones_contract_id_position")),
    )
    with op.batch_alter_table("contracts_milestones", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_contracts_milestones_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_milestones_studio_id"), ["studio_id"], unique=False)

    op.create_table(
        "contracts_work_logs",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("minutes", sa.Integer(), nullable=False),
        sa.Column("worked_on", sa.Date(), nullable=False),
        sa.Column("logged_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.CheckConstraint("minutes > 0", name=op.f("ck_contracts_work_logs_minutes_positive")),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_work_logs_contract_id")
        ),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_contracts_work_logs_cue_id")),
        sa.ForeignKeyConstraint(["logged_by"], ["accounts_people.id"], name=op.f("fk_contracts_work_logs_logged_by")),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_work_logs_project_id")
        ),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_work_logs_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_work_logs")),
    )
    with op.batch_alter_table("contracts_work_logs", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_contracts_work_logs_contract_id"), ["contract_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_work_logs_cue_id"), ["cue_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_work_logs_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_work_logs_studio_id"), ["studio_id"], unique=False)

    op.create_table(
        "contracts_cues",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("milestone_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("position", sa.Integer(), nullable=False),
        sa.Column("price_minor", sa.BigInteger(), nullable=True),
        sa.Column("amount_minor", sa.BigInteger(), nullable=True),
        sa.Column("estimate_min", sa.Integer(), nullable=True),
        sa.Column("accepted_at", app.kit.db.UtcDateTime(timezone=True), nullable=True),
        sa.Column("cut_at", app.kit.db.UtcDateTime(timezone=True), nullable=True),
        sa.Column(
            "cut_in",
            sa.Enum("not_begun", "in_work", "delivered", "accepted", name="workstate", native_enum=False, length=32),
            nullable=True,
        ),
        sa.CheckConstraint("(cut_at is null) = (cut_in is null)", name=op.f("ck_contracts_cues_cut_in_a_state")),
        sa.CheckConstraint("amount_minor >= 0", name=op.f("ck_contracts_cues_amount_not_negative")),
        sa.CheckConstraint("estimate_min > 0", name=op.f("ck_contracts_cues_estimate_positive")),
        sa.CheckConstraint("price_minor >= 0", name=op.f("ck_contracts_cues_price_not_negative")),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_cues_contract_id")
        ),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_contracts_cues_cue_id")),
        sa.ForeignKeyConstraint(
            ["milestone_id"], ["contracts_milestones.id"], name=op.f("fk_contracts_cues_milestone_id")
        ),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_cues_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_cues_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_cues")),
        sa.UniqueConstraint("contract_id", "cue_id", name=op.f("uq_contracts_cues_contract_id_cue_id")),
    )
    with op.batch_alter_table("contracts_cues", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_contracts_cues_cue_id"), ["cue_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_cues_milestone_id"), ["milestone_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_cues_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_cues_studio_id"), ["studio_id"], unique=False)

    op.create_table(
        "contracts_payments",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("invoice_id", sa.Uuid(), nullable=False),
        sa.Column("refund_of_id", sa.Uuid(), nullable=True),
        sa.Column("amount_minor", sa.BigInteger(), nullable=False),
        sa.Column("reference", sa.String(), nullable=False),
        sa.Column("paid_on", sa.Date(), nullable=False),
        sa.Column("recorded_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.CheckConstraint("amount_minor <> 0", name=op.f("ck_contracts_payments_not_nothing")),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_payments_contract_id")
        ),
        sa.ForeignKeyConstraint(
            ["invoice_id"], ["contracts_invoices.id"], name=op.f("fk_contracts_payments_invoice_id")
        ),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_payments_project_id")
        ),
        sa.ForeignKeyConstraint(
            ["recorded_by"], ["accounts_people.id"], name=op.f("fk_contracts_payments_recorded_by")
        ),
        sa.ForeignKeyConstraint(
            ["refund_of_id"], ["contracts_payments.id"], name=op.f("fk_contracts_payments_refund_of_id")
        ),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_payments_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_payments")),
    )
    with op.batch_alter_table("contracts_payments", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_contracts_payments_contract_id"), ["contract_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_payments_invoice_id"), ["invoice_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_payments_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_payments_refund_of_id"), ["refund_of_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_payments_studio_id"), ["studio_id"], unique=False)

    op.create_table(
        "contracts_worked_days",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("milestone_id", sa.Uuid(), nullable=False),
        sa.Column("worked_on", sa.Date(), nullable=False),
        sa.Column("quarters", sa.Integer(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("logged_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.Column("agreed_by", sa.Uuid(), nullable=True),
        sa.Column("agreed_at", app.kit.db.UtcDateTime(timezone=True), nullable=True),
        sa.CheckConstraint(
            "(agreed_at is null) = (agreed_by is null)", name=op.f("ck_contracts_worked_days_agreed_by_somebody")
        ),
        sa.CheckConstraint("quarters between 1 and 4", name=op.f("ck_contracts_worked_days_a_day_at_most")),
        sa.ForeignKeyConstraint(["agreed_by"], ["accounts_people.id"], name=op.f("fk_contracts_worked_days_agreed_by")),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_worked_days_contract_id")
        ),
        sa.ForeignKeyConstraint(["logged_by"], ["accounts_people.id"], name=op.f("fk_contracts_worked_days_logged_by")),
        sa.ForeignKeyConstraint(
            ["milestone_id"], ["contracts_milestones.id"], name=op.f("fk_contracts_worked_days_milestone_id")
        ),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_worked_days_project_id")
        ),
        sa.ForeignKeyConstraint(
            ["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_worked_days_studio_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_worked_days")),
        sa.UniqueConstraint("contract_id", "worked_on", name=op.f("uq_contracts_worked_days_contract_id_worked_on")),
    )
    with op.batch_alter_table("contracts_worked_days", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_contracts_worked_days_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_worked_days_studio_id"), ["studio_id"], unique=False)

    op.create_table(
        "contracts_ledger_lines",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column(
            "kind",
            sa.Enum(
                "deposit",
                "accepted",
                "cut",
                "extra_round",
                "worked_day",
                "tax",
                "reversed",
                "paid",
                "refunded",
                name="linekind",
                native_enum=False,
                length=32,
            ),
            nullable=False,
        ),
        sa.Column("amount_minor", sa.BigInteger(), nullable=False),
        sa.Column("clause", sa.String(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=True),
        sa.Column("milestone_id", sa.Uuid(), nullable=True),
        sa.Column("about_id", sa.Uuid(), nullable=True),
        sa.Column("round_number", sa.Integer(), nullable=True),
        sa.Column("tax_bp", sa.Integer(), nullable=True),
        sa.Column("payment_id", sa.Uuid(), nullable=True),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.CheckConstraint(
            "(kind in ('paid', 'refunded')) = (payment_id is not null)",
            name=op.f("ck_contracts_ledger_lines_payments_are_named"),
        ),
        sa.CheckConstraint(
            "(kind in ('reversed', 'paid', 'refunded')) = (about_id is not null)",
            name=op.f("ck_contracts_ledger_lines_about_a_line"),
        ),
        sa.CheckConstraint("amount_minor <> 0", name=op.f("ck_contracts_ledger_lines_not_nothing")),
        sa.CheckConstraint(
            "cue_id is not null or milestone_id is not null or tax_bp is not null",
            name=op.f("ck_contracts_ledger_lines_about_something"),
        ),
        sa.ForeignKeyConstraint(
            ["about_id"], ["contracts_ledger_lines.id"], name=op.f("fk_contracts_ledger_lines_about_id")
        ),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_ledger_lines_contract_id")
        ),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_contracts_ledger_lines_cue_id")),
        sa.ForeignKeyConstraint(
            ["milestone_id"], ["contracts_milestones.id"], name=op.f("fk_contracts_ledger_lines_milestone_id")
        ),
        sa.ForeignKeyConstraint(
            ["payment_id"], ["contracts_payments.id"], name=op.f("fk_contracts_ledger_lines_payment_id")
        ),
        sa.ForeignKeyConstraint(
            ["person_id"], ["accounts_people.id"], name=op.f("fk_contracts_ledger_lines_person_id")
        ),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_ledger_lines_project_id")
        ),
        sa.ForeignKeyConstraint(
            ["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_ledger_lines_studio_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_ledger_lines")),
    )
    with op.batch_alter_table("contracts_ledger_lines", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_contracts_ledger_lines_contract_id"), ["contract_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_ledger_lines_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_ledger_lines_studio_id"), ["studio_id"], unique=False)
        batch_op.create_index(
            "uq_contracts_ledger_lines_reversed",
            ["about_id"],
            unique=True,
            sqlite_where=sa.text("kind = 'reversed'"),
            postgresql_where=sa.text("kind = 'reversed'"),
        )
        batch_op.create_index(
            "uq_contracts_ledger_lines_round",
            ["contract_id", "cue_id", "round_number"],
            unique=True,
            sqlite_where=sa.text("kind = 'extra_round'"),
            postgresql_where=sa.text("kind = 'extra_round'"),
        )

    op.create_table(
        "contracts_invoice_lines",
        sa.Column("ledger_line_id", sa.Uuid(), nullable=False),
        sa.Column("invoice_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.ForeignKeyConstraint(
            ["invoice_id"], ["contracts_invoices.id"], name=op.f("fk_contracts_invoice_lines_invoice_id")
        ),
        sa.ForeignKeyConstraint(
            ["ledger_line_id"], ["contracts_ledger_lines.id"], name=op.f("fk_contracts_invoice_lines_ledger_line_id")
        ),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_invoice_lines_project_id")
        ),
        sa.ForeignKeyConstraint(
            ["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_invoice_lines_studio_id")
        ),
        sa.PrimaryKeyConstraint("ledger_line_id", name=op.f("pk_contracts_invoice_lines")),
    )
    with op.batch_alter_table("contracts_invoice_lines", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_contracts_invoice_lines_invoice_id"), ["invoice_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_invoice_lines_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_invoice_lines_studio_id"), ["studio_id"], unique=False)


def downgrade() -> None:
    for table in (
        "contracts_invoice_lines",
        "contracts_ledger_lines",
        "contracts_worked_days",
        "contracts_payments",
        "contracts_cues",
        "contracts_work_logs",
        "contracts_milestones",
        "contracts_invoices",
        "contracts_extra_rounds",
        "contracts_calendar_links",
    ):
        op.drop_table(table)
