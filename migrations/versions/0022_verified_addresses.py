"""Addresses are verified, operators are named in the database, sign-ins are listed, and tries are counted together."""

import sqlalchemy as sa
from alembic import op

import app.kit.db

revision = "0022"
down_revision = "0021"
branch_labels = None
depends_on = None

LINKED = ("accounts_password_resets", "accounts_studio_invitations", "projects_invitations")
PROOF = sa.Enum("mail", "operator", name="addressproof", native_enum=False, length=32)
INSTANT = app.kit.db.UtcDateTime(timezone=True)


def upgrade() -> None:
    op.create_table(
        "accounts_rate_limits",
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("free_at_s", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("key", name=op.f("pk_accounts_rate_limits")),
    )
    op.create_index(op.f("ix_accounts_rate_limits_free_at_s"), "accounts_rate_limits", ["free_at_s"])
    op.create_table(
        "accounts_sign_ups",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("email", sa.String(), nullable=False),
        sa.Column("expires_at", INSTANT, nullable=False),
        sa.Column("used_at", INSTANT, nullable=True),
        sa.Column("secret_sha256", sa.String(), nullable=True),
        sa.Column("is_sent_by_mail_only", sa.Boolean(), nullable=False),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_sign_ups")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_accounts_sign_ups_secret_sha256")),
    )
    op.create_index(op.f("ix_accounts_sign_ups_email"), "accounts_sign_ups", ["email"])
    op.create_table(
        "accounts_email_verifications",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("expires_at", INSTANT, nullable=False),
        sa.Column("used_at", INSTANT, nullable=True),
        sa.Column("secret_sha256", sa.String(), nullable=True),
        sa.Column("is_sent_by_mail_only", sa.Boolean(), nullable=False),
        sa.ForeignKeyConstraint(
            ["person_id"], ["accounts_people.id"], name=op.f("fk_accounts_email_verifications_person_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_email_verifications")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_accounts_email_verifications_secret_sha256")),
    )
    op.create_index(op.f("ix_accounts_email_verifications_person_id"), "accounts_email_verifications", ["person_id"])
    op.create_table(
        "accounts_operators",
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("named_at", INSTANT, nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_accounts_operators_person_id")),
        sa.PrimaryKeyConstraint("person_id", name=op.f("pk_accounts_operators")),
    )
    # Servers of the version before go on writing rows without these columns until they are replaced.
    for table in LINKED:
        with op.batch_alter_table(table) as batch_op:
            batch_op.add_column(
                sa.Column("is_sent_by_mail_only", sa.Boolean(), server_default=sa.false(), nullable=False)
            )
            batch_op.alter_column("secret_sha256", existing_type=sa.String(), nullable=True)
    with op.batch_alter_table("accounts_sign_ins", recreate="always") as batch_op:
        batch_op.add_column(sa.Column("device", sa.String(), server_default="", nullable=False))
        batch_op.add_column(sa.Column("place", sa.String(), server_default="", nullable=False))
        batch_op.add_column(sa.Column("last_seen_at", INSTANT, server_default=sa.func.now(), nullable=False))
    with op.batch_alter_table("accounts_people") as batch_op:
        batch_op.add_column(sa.Column("email_verified_at", INSTANT, nullable=True))
        batch_op.add_column(sa.Column("email_proof", PROOF, nullable=True))
        batch_op.create_check_constraint(
            op.f("ck_accounts_people_verified_somehow"), "(email_verified_at is null) = (email_proof is null)"
        )
    with op.batch_alter_table("contracts_acceptances") as batch_op:
        batch_op.add_column(sa.Column("email_proof", PROOF, nullable=True))
    with op.batch_alter_table("notifications_mails") as batch_op:
        batch_op.add_column(sa.Column("secret_of", sa.String(), nullable=True))
        batch_op.add_column(sa.Column("secret_of_id", sa.Uuid(), nullable=True))
    op.execute("update notifications_mails set link = null where sent_at is not null")


def downgrade() -> None:
    with op.batch_alter_table("notifications_mails") as batch_op:
        batch_op.drop_column("secret_of_id")
        batch_op.drop_column("secret_of")
    with op.batch_alter_table("contracts_acceptances") as batch_op:
        batch_op.drop_column("email_proof")
    with op.batch_alter_table("accounts_people") as batch_op:
        batch_op.drop_constraint(op.f("ck_accounts_people_verified_somehow"), type_="check")
        batch_op.drop_column("email_proof")
        batch_op.drop_column("email_verified_at")
    with op.batch_alter_table("accounts_sign_ins") as batch_op:
        batch_op.drop_column("last_seen_at")
        batch_op.drop_column("place")
        batch_op.drop_column("device")
    for table in LINKED:
        # No link was made of these yet: none opens them afterwards either.
        op.execute(f"update {table} set secret_sha256 = cast(id as varchar) where secret_sha256 is null")  # noqa: S608
        with op.batch_alter_table(table) as batch_op:
            batch_op.alter_column("secret_sha256", existing_type=sa.String(), nullable=False)
            batch_op.drop_column("is_sent_by_mail_only")
    op.drop_table("accounts_operators")
    op.drop_table("accounts_email_verifications")
    op.drop_table("accounts_sign_ups")
    op.drop_table("accounts_rate_limits")
