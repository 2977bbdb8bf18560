"""Contracts: texts, versions, acceptances and their records; and what a designer accepted before they may look."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects import postgresql

import app.kit.db

revision = "0006"
down_revision = "0005"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.create_table(
        "contracts_templates",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column(
            "kind",
            sa.Enum(
                "nda", "framework", "statement_of_work", "single", name="contractkind", native_enum=False, length=32
            ),
            nullable=False,
        ),
        sa.Column("clauses", sa.JSON().with_variant(postgresql.JSONB(), "postgresql"), nullable=False),
        sa.Column("terms", sa.JSON().with_variant(postgresql.JSONB(), "postgresql"), nullable=False),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.Column("changed_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name=op.f("fk_contracts_templates_created_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_templates_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_templates")),
        sa.UniqueConstraint("studio_id", "name", name=op.f("uq_contracts_templates_studio_id_name")),
    )
    with op.batch_alter_table("contracts_templates", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_contracts_templates_studio_id"), ["studio_id"], unique=False)

    op.create_table(
        "contracts_contracts",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("engagement_id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column("framework_id", sa.Uuid(), nullable=True),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("title", sa.String(), nullable=False),
        sa.Column(
            "kind",
            sa.Enum(
                "nda", "framework", "statement_of_work", "single", name="contractkind", native_enum=False, length=32
            ),
            nullable=False,
        ),
        sa.Column(
            "state",
            sa.Enum("draft", "sent", "agreed", "ended", name="contractstate", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("currency", sa.String(), nullable=False),
        sa.Column(
            "release_clause",
            sa.Enum("per_cue", "on_completion", name="releaseclause", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("deposit_bp", sa.Integer(), nullable=False),
        sa.Column("holdback_bp", sa.Integer(), nullable=False),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.Column("agreed_at", app.kit.db.UtcDateTime(timezone=True), nullable=True),
        sa.Column("ended_at", app.kit.db.UtcDateTime(timezone=True), nullable=True),
        sa.Column("end_reason", sa.String(), nullable=True),
        sa.Column("record_length", sa.Integer(), nullable=False),
        sa.Column("record_sha256", sa.String(), nullable=False),
        sa.CheckConstraint(
            "(kind = 'statement_of_work') = (framework_id is not null)",
            name=op.f("ck_contracts_contracts_batch_has_framework"),
        ),
        sa.CheckConstraint(
            "(state <> 'agreed') or (agreed_at is not null)", name=op.f("ck_contracts_contracts_agreed_is_dated")
        ),
        sa.CheckConstraint(
            "(state = 'ended') = (ended_at is not null)", name=op.f("ck_contracts_contracts_ended_is_dated")
        ),
        sa.CheckConstraint("deposit_bp between 0 and 10000", name=op.f("ck_contracts_contracts_deposit_is_a_part")),
        sa.CheckConstraint("holdback_bp between 0 and 10000", name=op.f("ck_contracts_contracts_holdback_is_a_part")),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name=op.f("fk_contracts_contracts_created_by")),
        sa.ForeignKeyConstraint(
            ["designer_id"], ["accounts_people.id"], name=op.f("fk_contracts_contracts_designer_id")
        ),
        sa.ForeignKeyConstraint(
            ["engagement_id"], ["projects_engagements.id"], name=op.f("fk_contracts_contracts_engagement_id")
        ),
        sa.ForeignKeyConstraint(
            ["framework_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_contracts_framework_id")
        ),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_contracts_project_id")
        ),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_contracts_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_contracts")),
        sa.UniqueConstraint("project_id", "number", name=op.f("uq_contracts_contracts_project_id_number")),
    )
    with op.batch_alter_table("contracts_contracts", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_contracts_contracts_designer_id"), ["designer_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_contracts_engagement_id"), ["engagement_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_contracts_framework_id"), ["framework_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_contracts_studio_id"), ["studio_id"], unique=False)

    op.create_table(
        "contracts_events",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("seq", sa.Integer(), nullable=False),
        sa.Column("at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.Column("kind", sa.String(), nullable=False),
        sa.Column("payload", sa.String(), nullable=False),
        sa.Column("previous_sha256", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_events_contract_id")
        ),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_events_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_events_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_events")),
        sa.UniqueConstraint("contract_id", "seq", name=op.f("uq_contracts_events_contract_id_seq")),
    )
    with op.batch_alter_table("contracts_events", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_contracts_events_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_events_studio_id"), ["studio_id"], unique=False)

    op.create_table(
        "contracts_versions",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("clauses", sa.JSON().with_variant(postgresql.JSONB(), "postgresql"), nullable=False),
        sa.Column("terms", sa.JSON().with_variant(postgresql.JSONB(), "postgresql"), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("text_sha256", sa.String(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.Column("sent_at", app.kit.db.UtcDateTime(timezone=True), nullable=True),
        sa.Column("pdf_sha256", sa.String(), nullable=True),
        sa.Column("pdf_bytes", sa.Integer(), nullable=True),
        sa.CheckConstraint("(sent_at is null) = (pdf_sha256 is null)", name=op.f("ck_contracts_versions_sent_as_pdf")),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_versions_contract_id")
        ),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name=op.f("fk_contracts_versions_created_by")),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_versions_project_id")
        ),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_versions_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_versions")),
        sa.UniqueConstraint("contract_id", "number", name=op.f("uq_contracts_versions_contract_id_number")),
    )
    with op.batch_alter_table("contracts_versions", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_contracts_versions_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_versions_studio_id"), ["studio_id"], unique=False)

    op.create_table(
        "contracts_acceptances",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("version_id", sa.Uuid(), nullable=False),
        sa.Column("party", sa.Enum("studio", "designer", name="party", native_enum=False, length=32), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("email", sa.String(), nullable=False),
        sa.Column("address", sa.String(), nullable=False),
        sa.Column("accepted_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_acceptances_contract_id")
        ),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_contracts_acceptances_person_id")),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_acceptances_project_id")
        ),
        sa.ForeignKeyConstraint(
            ["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_acceptances_studio_id")
        ),
        sa.ForeignKeyConstraint(
            ["version_id"], ["contracts_versions.id"], name=op.f("fk_contracts_acceptances_version_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_acceptances")),
        sa.UniqueConstraint("version_id", "party", name=op.f("uq_contracts_acceptances_version_id_party")),
    )
    with op.batch_alter_table("contracts_acceptances", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_contracts_acceptances_contract_id"), ["contract_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_acceptances_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_contracts_acceptances_studio_id"), ["studio_id"], unique=False)

    with op.batch_alter_table("projects_engagements", schema=None) as batch_op:
        batch_op.add_column(sa.Column("nda_sha256", sa.String(), nullable=True))
        batch_op.add_column(sa.Column("nda_accepted_at", app.kit.db.UtcDateTime(timezone=True), nullable=True))
        batch_op.create_check_constraint(
            batch_op.f("ck_projects_engagements_nda_is_dated"), "(nda_sha256 is null) = (nda_accepted_at is null)"
        )

    with op.batch_alter_table("projects_projects", schema=None) as batch_op:
        batch_op.add_column(sa.Column("nda_needed", sa.Boolean(), nullable=False, server_default=sa.false()))
    with op.batch_alter_table("projects_projects", schema=None) as batch_op:
        batch_op.alter_column("nda_needed", server_default=None)


def downgrade() -> None:
    with op.batch_alter_table("projects_projects", schema=None) as batch_op:
        batch_op.drop_column("nda_needed")

    with op.batch_alter_table("projects_engagements", schema=None) as batch_op:
        batch_op.drop_constraint(batch_op.f("ck_projects_engagements_nda_is_dated"), type_="check")
        batch_op.drop_column("nda_accepted_at")
        batch_op.drop_column("nda_sha256")

    op.drop_table("contracts_acceptances")
    op.drop_table("contracts_versions")
    op.drop_table("contracts_events")
    op.drop_table("contracts_contracts")
    op.drop_table("contracts_templates")
