"""Cues accepted by silence or with their agreement, and reminders of those that wait."""

import sqlalchemy as sa
from alembic import op

import app.kit.db

revision = "0015"
down_revision = "0014"
branch_labels = None
depends_on = None

HOW = sa.Enum("verdict", "silence", "adoption", name="acceptedby", native_enum=False, length=32)


def upgrade() -> None:
    op.create_table(
        "reviews_reminders",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("waiting_since", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("created_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_reviews_reminders_cue_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_reviews_reminders_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_reviews_reminders_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_reviews_reminders")),
        sa.UniqueConstraint(
            "cue_id", "waiting_since", "number", name=op.f("uq_reviews_reminders_cue_id_waiting_since_number")
        ),
    )
    with op.batch_alter_table("reviews_reminders", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_reviews_reminders_project_id"), ["project_id"], unique=False)
        batch_op.create_index(batch_op.f("ix_reviews_reminders_studio_id"), ["studio_id"], unique=False)

    op.add_column("contracts_cues", sa.Column("accepted_by", HOW, nullable=True))
    op.execute("update contracts_cues set accepted_by = 'verdict' where accepted_at is not null")
    with op.batch_alter_table("contracts_cues", schema=None) as batch_op:
        batch_op.create_check_constraint("accepted_somehow", "(accepted_at is null) = (accepted_by is null)")

    with op.batch_alter_table("reviews_verdicts", schema=None) as batch_op:
        batch_op.add_column(sa.Column("deemed_by_contract_id", sa.Uuid(), nullable=True))
        batch_op.create_foreign_key(
            batch_op.f("fk_reviews_verdicts_deemed_by_contract_id"),
            "contracts_contracts",
            ["deemed_by_contract_id"],
            ["id"],
        )
        batch_op.create_index(
            batch_op.f("ix_reviews_verdicts_deemed_by_contract_id"), ["deemed_by_contract_id"], unique=False
        )


def downgrade() -> None:
    with op.batch_alter_table("reviews_verdicts", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_reviews_verdicts_deemed_by_contract_id"))
        batch_op.drop_constraint(batch_op.f("fk_reviews_verdicts_deemed_by_contract_id"), type_="foreignkey")
        batch_op.drop_column("deemed_by_contract_id")

    with op.batch_alter_table("contracts_cues", schema=None) as batch_op:
        batch_op.drop_constraint("accepted_somehow", type_="check")
        batch_op.drop_column("accepted_by")

    with op.batch_alter_table("reviews_reminders", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_reviews_reminders_studio_id"))
        batch_op.drop_index(batch_op.f("ix_reviews_reminders_project_id"))

    op.drop_table("reviews_reminders")
