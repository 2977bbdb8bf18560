"""Every table. Written by `make migration` from the models; do not edit it by hand."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

revision = "0001_16504615"  # with a digest of the tables: a database that has other tables is recognized
down_revision = None
branch_labels = None
depends_on = None

JSON = sa.JSON().with_variant(JSONB(), "postgresql")


def upgrade() -> None:
    op.create_table(
        "accounts_people",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("email", sa.String(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("password_hash", sa.String()),
        sa.Column("demo_part", sa.String()),
        sa.Column("email_verified_at", sa.DateTime(timezone=True)),
        sa.Column("email_proof", sa.Enum("mail", "operator", "provider", name="addressproof", native_enum=False, length=32)),
        sa.Column("picture_sha256", sa.String()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(email_verified_at is null) = (email_proof is null)", name=op.f("ck_accounts_people_verified_somehow")),
        sa.CheckConstraint("email = lower(email)", name=op.f("ck_accounts_people_email_lower_case")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_people")),
        sa.UniqueConstraint("demo_part", name=op.f("uq_accounts_people_demo_part")),
        sa.UniqueConstraint("email", name=op.f("uq_accounts_people_email")),
    )
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
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("used_at", sa.DateTime(timezone=True)),
        sa.Column("secret_sha256", sa.String()),
        sa.Column("is_sent_by_mail_only", sa.Boolean(), nullable=False),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_sign_ups")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_accounts_sign_ups_secret_sha256")),
    )
    op.create_index(op.f("ix_accounts_sign_ups_email"), "accounts_sign_ups", ["email"])
    op.create_table(
        "core_backups",
        sa.Column("finished_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("damaged_blobs", sa.Integer(), nullable=False),
        sa.PrimaryKeyConstraint("finished_at", name=op.f("pk_core_backups")),
    )
    op.create_table(
        "core_changed_rooms",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid()),
        sa.Column("rooms", JSON, nullable=False),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_core_changed_rooms")),
    )
    op.create_table(
        "core_heartbeats",
        sa.Column("worker_id", sa.String(), nullable=False),
        sa.Column("beat_at", sa.DateTime(timezone=True), nullable=False),
        sa.PrimaryKeyConstraint("worker_id", name=op.f("pk_core_heartbeats")),
    )
    op.create_table(
        "core_saved_responses",
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("request_sha256", sa.String(), nullable=False),
        sa.Column("status", sa.Integer()),
        sa.Column("media_type", sa.String()),
        sa.Column("body", sa.String()),
        sa.Column("rights", sa.String()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.PrimaryKeyConstraint("key", name=op.f("pk_core_saved_responses")),
    )
    op.create_index(op.f("ix_core_saved_responses_created_at"), "core_saved_responses", ["created_at"])
    op.create_table(
        "core_uploads",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("owner_id", sa.Uuid(), nullable=False),
        sa.Column("scope", sa.String(), nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("length", sa.BigInteger(), nullable=False),
        sa.Column("expected_sha256", sa.String()),
        sa.Column("sha256", sa.String()),
        sa.Column("multipart_id", sa.String()),
        sa.Column("finished_at", sa.DateTime(timezone=True)),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(sha256 is null) = (finished_at is null)", name=op.f("ck_core_uploads_finished_is_hashed")),
        sa.CheckConstraint("length >= 0", name=op.f("ck_core_uploads_length_known")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_core_uploads")),
    )
    op.create_index(op.f("ix_core_uploads_studio_id"), "core_uploads", ["studio_id"])
    op.create_table(
        "operations_damaged_blobs",
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("kind", sa.String(), nullable=False),
        sa.Column("state", sa.Enum("missing", "altered", name="blobstate", native_enum=False, length=32), nullable=False),
        sa.Column("found_at", sa.DateTime(timezone=True), nullable=False),
        sa.PrimaryKeyConstraint("studio_id", "sha256", name=op.f("pk_operations_damaged_blobs")),
    )
    op.create_table(
        "operations_scrubs",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("started_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("finished_at", sa.DateTime(timezone=True)),
        sa.Column("last_studio_id", sa.Uuid()),
        sa.Column("last_sha256", sa.String()),
        sa.Column("blobs", sa.Integer(), nullable=False),
        sa.Column("size_bytes", sa.BigInteger(), nullable=False),
        sa.Column("missing", sa.Integer(), nullable=False),
        sa.Column("altered", sa.Integer(), nullable=False),
        sa.Column("orphaned", sa.Integer(), nullable=False),
        sa.Column("orphaned_bytes", sa.BigInteger(), nullable=False),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_operations_scrubs")),
    )
    op.create_index(op.f("ix_operations_scrubs_started_at"), "operations_scrubs", ["started_at"])
    op.create_table(
        "accounts_desk_tokens",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("secret_sha256", sa.String(), nullable=False),
        sa.Column("last_used_at", sa.DateTime(timezone=True)),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("warned_at", sa.DateTime(timezone=True)),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_accounts_desk_tokens_person_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_desk_tokens")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_accounts_desk_tokens_secret_sha256")),
    )
    op.create_index(op.f("ix_accounts_desk_tokens_person_id"), "accounts_desk_tokens", ["person_id"])
    op.create_table(
        "accounts_email_changes",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("new_email", sa.String(), nullable=False),
        sa.Column("is_new_end", sa.Boolean(), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("confirmed_at", sa.DateTime(timezone=True)),
        sa.Column("secret_sha256", sa.String()),
        sa.Column("is_sent_by_mail_only", sa.Boolean(), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_accounts_email_changes_person_id"), ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_email_changes")),
        sa.UniqueConstraint("person_id", "is_new_end", name=op.f("uq_accounts_email_changes_person_id_is_new_end")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_accounts_email_changes_secret_sha256")),
    )
    op.create_index(op.f("ix_accounts_email_changes_person_id"), "accounts_email_changes", ["person_id"])
    op.create_table(
        "accounts_email_verifications",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("used_at", sa.DateTime(timezone=True)),
        sa.Column("secret_sha256", sa.String()),
        sa.Column("is_sent_by_mail_only", sa.Boolean(), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_accounts_email_verifications_person_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_email_verifications")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_accounts_email_verifications_secret_sha256")),
    )
    op.create_index(op.f("ix_accounts_email_verifications_person_id"), "accounts_email_verifications", ["person_id"])
    op.create_table(
        "accounts_operators",
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("named_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_accounts_operators_person_id")),
        sa.PrimaryKeyConstraint("person_id", name=op.f("pk_accounts_operators")),
    )
    op.create_table(
        "accounts_passkeys",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("credential_id", sa.LargeBinary(), nullable=False),
        sa.Column("public_key", sa.LargeBinary(), nullable=False),
        sa.Column("sign_count", sa.BigInteger(), nullable=False),
        sa.Column("challenge_made_at_us", sa.BigInteger(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("last_used_at", sa.DateTime(timezone=True)),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_accounts_passkeys_person_id"), ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_passkeys")),
        sa.UniqueConstraint("credential_id", name=op.f("uq_accounts_passkeys_credential_id")),
    )
    op.create_index(op.f("ix_accounts_passkeys_person_id"), "accounts_passkeys", ["person_id"])
    op.create_table(
        "accounts_password_resets",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("used_at", sa.DateTime(timezone=True)),
        sa.Column("secret_sha256", sa.String()),
        sa.Column("is_sent_by_mail_only", sa.Boolean(), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_accounts_password_resets_person_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_password_resets")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_accounts_password_resets_secret_sha256")),
    )
    op.create_index(op.f("ix_accounts_password_resets_person_id"), "accounts_password_resets", ["person_id"])
    op.create_table(
        "accounts_pictures",
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("content", sa.LargeBinary(), nullable=False),
        sa.Column("saved_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_accounts_pictures_person_id"), ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("person_id", name=op.f("pk_accounts_pictures")),
    )
    op.create_table(
        "accounts_recovery_codes",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("code_sha256", sa.String(), nullable=False),
        sa.Column("used_at", sa.DateTime(timezone=True)),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_accounts_recovery_codes_person_id"), ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_recovery_codes")),
    )
    op.create_index(op.f("ix_accounts_recovery_codes_person_id"), "accounts_recovery_codes", ["person_id"])
    op.create_table(
        "accounts_sign_ins",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("secret_sha256", sa.String(), nullable=False),
        sa.Column("device", sa.String(), nullable=False),
        sa.Column("place", sa.String(), nullable=False),
        sa.Column("last_seen_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("second_factor_studio_id", sa.Uuid()),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_accounts_sign_ins_person_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_sign_ins")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_accounts_sign_ins_secret_sha256")),
    )
    op.create_index(op.f("ix_accounts_sign_ins_person_id"), "accounts_sign_ins", ["person_id"])
    op.create_table(
        "accounts_studios",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("is_demo", sa.Boolean(), nullable=False),
        sa.Column("time_zone", sa.String(), nullable=False),
        sa.Column("second_factor_for", JSON, nullable=False),
        sa.Column("members_see", sa.Enum("all", "own", name="memberssee", native_enum=False, length=32), nullable=False),
        sa.Column("opened_by", sa.Uuid()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["opened_by"], ["accounts_people.id"], name=op.f("fk_accounts_studios_opened_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_studios")),
    )
    op.create_index(op.f("ix_accounts_studios_opened_by"), "accounts_studios", ["opened_by"])
    op.create_table(
        "accounts_totp_factors",
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("sealed_secret", sa.LargeBinary(), nullable=False),
        sa.Column("last_step", sa.BigInteger(), nullable=False),
        sa.Column("confirmed_at", sa.DateTime(timezone=True)),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_accounts_totp_factors_person_id"), ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("person_id", name=op.f("pk_accounts_totp_factors")),
    )
    op.create_table(
        "notifications_mail_preferences",
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("cadences", JSON, nullable=False),
        sa.Column("time_zone", sa.String(), nullable=False),
        sa.Column("daily_at", sa.Time(), nullable=False),
        sa.Column("quiet_from", sa.Time()),
        sa.Column("quiet_until", sa.Time()),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_notifications_mail_preferences_person_id")),
        sa.PrimaryKeyConstraint("person_id", name=op.f("pk_notifications_mail_preferences")),
    )
    op.create_table(
        "accounts_holidays",
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("day", sa.Date(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_accounts_holidays_studio_id")),
        sa.PrimaryKeyConstraint("studio_id", "day", name=op.f("pk_accounts_holidays")),
    )
    op.create_table(
        "accounts_invoice_details",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid()),
        sa.Column("person_id", sa.Uuid()),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("street", sa.String(), nullable=False),
        sa.Column("postal_code", sa.String(), nullable=False),
        sa.Column("city", sa.String(), nullable=False),
        sa.Column("country_code", sa.String(), nullable=False),
        sa.Column("vat_id", sa.String(), nullable=False),
        sa.Column("tax_number", sa.String(), nullable=False),
        sa.Column("account_number", sa.String(), nullable=False),
        sa.Column("no_tax_reason", sa.String(), nullable=False),
        sa.Column("saved_by", sa.Uuid(), nullable=False),
        sa.Column("saved_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(studio_id is null) <> (person_id is null)", name=op.f("ck_accounts_invoice_details_one_owner")),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_accounts_invoice_details_person_id")),
        sa.ForeignKeyConstraint(["saved_by"], ["accounts_people.id"], name=op.f("fk_accounts_invoice_details_saved_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_accounts_invoice_details_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_invoice_details")),
    )
    op.create_index(op.f("ix_accounts_invoice_details_person_id"), "accounts_invoice_details", ["person_id"])
    op.create_index(op.f("ix_accounts_invoice_details_studio_id"), "accounts_invoice_details", ["studio_id"])
    op.create_table(
        "accounts_memberships",
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("roles", JSON, nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_accounts_memberships_person_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_accounts_memberships_studio_id")),
        sa.PrimaryKeyConstraint("studio_id", "person_id", name=op.f("pk_accounts_memberships")),
    )
    op.create_index(op.f("ix_accounts_memberships_person_id"), "accounts_memberships", ["person_id"])
    op.create_table(
        "accounts_quotas",
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("kind", sa.String(), nullable=False),
        sa.Column("maximum", sa.BigInteger(), nullable=False),
        sa.CheckConstraint("maximum >= 0", name=op.f("ck_accounts_quotas_maximum_known")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_accounts_quotas_studio_id")),
        sa.PrimaryKeyConstraint("studio_id", "kind", name=op.f("pk_accounts_quotas")),
    )
    op.create_table(
        "accounts_sign_in_domains",
        sa.Column("domain", sa.String(), nullable=False),
        sa.Column("bound_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_accounts_sign_in_domains_studio_id")),
        sa.PrimaryKeyConstraint("domain", name=op.f("pk_accounts_sign_in_domains")),
    )
    op.create_index(op.f("ix_accounts_sign_in_domains_studio_id"), "accounts_sign_in_domains", ["studio_id"])
    op.create_table(
        "accounts_sign_in_providers",
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("issuer", sa.String(), nullable=False),
        sa.Column("client_id", sa.String(), nullable=False),
        sa.Column("sealed_client_secret", sa.LargeBinary(), nullable=False),
        sa.Column("authorization_endpoint", sa.String(), nullable=False),
        sa.Column("token_endpoint", sa.String(), nullable=False),
        sa.Column("jwks_uri", sa.String(), nullable=False),
        sa.Column("is_secret_in_body", sa.Boolean(), nullable=False),
        sa.Column("saved_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_accounts_sign_in_providers_studio_id")),
        sa.PrimaryKeyConstraint("studio_id", name=op.f("pk_accounts_sign_in_providers")),
    )
    op.create_table(
        "accounts_studio_invitations",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("email", sa.String(), nullable=False),
        sa.Column("roles", JSON, nullable=False),
        sa.Column("approves_project_id", sa.Uuid()),
        sa.Column("invited_by", sa.Uuid(), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("accepted_at", sa.DateTime(timezone=True)),
        sa.Column("accepted_by", sa.Uuid()),
        sa.Column("revoked_at", sa.DateTime(timezone=True)),
        sa.Column("secret_sha256", sa.String()),
        sa.Column("is_sent_by_mail_only", sa.Boolean(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["accepted_by"], ["accounts_people.id"], name=op.f("fk_accounts_studio_invitations_accepted_by")),
        sa.ForeignKeyConstraint(["invited_by"], ["accounts_people.id"], name=op.f("fk_accounts_studio_invitations_invited_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_accounts_studio_invitations_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_studio_invitations")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_accounts_studio_invitations_secret_sha256")),
    )
    op.create_index(op.f("ix_accounts_studio_invitations_studio_id"), "accounts_studio_invitations", ["studio_id"])
    op.create_table(
        "accounts_tokens",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("secret_sha256", sa.String(), nullable=False),
        sa.Column("scopes", JSON, nullable=False),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("last_used_at", sa.DateTime(timezone=True)),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("warned_at", sa.DateTime(timezone=True)),
        sa.Column("revoked_at", sa.DateTime(timezone=True)),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name=op.f("fk_accounts_tokens_created_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_accounts_tokens_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_tokens")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_accounts_tokens_secret_sha256")),
    )
    op.create_index(op.f("ix_accounts_tokens_expires_at"), "accounts_tokens", ["expires_at"])
    op.create_index(op.f("ix_accounts_tokens_project_id"), "accounts_tokens", ["project_id"])
    op.create_index(op.f("ix_accounts_tokens_studio_id"), "accounts_tokens", ["studio_id"])
    op.create_table(
        "builds_fingerprints",
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("sound_sha256", sa.String(), nullable=False),
        sa.Column("fingerprint_version", sa.Integer(), nullable=False),
        sa.Column("entry", JSON, nullable=False),
        sa.Column("fingerprinted_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_fingerprints_studio_id")),
        sa.PrimaryKeyConstraint("studio_id", "sound_sha256", name=op.f("pk_builds_fingerprints")),
    )
    op.create_table(
        "builds_master_fingerprints",
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("sound_sha256", sa.String(), nullable=False),
        sa.Column("fingerprint_version", sa.Integer(), nullable=False),
        sa.Column("pcm_sha256", sa.String()),
        sa.Column("sample_rate_hz", sa.Integer(), nullable=False),
        sa.Column("fingerprint", sa.LargeBinary()),
        sa.Column("moments", sa.LargeBinary(), nullable=False),
        sa.Column("made_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_master_fingerprints_studio_id")),
        sa.PrimaryKeyConstraint("studio_id", "sound_sha256", name=op.f("pk_builds_master_fingerprints")),
    )
    op.create_table(
        "builds_sound_libraries",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("licence", sa.String(), nullable=False),
        sa.Column("sounds", sa.Integer(), nullable=False),
        sa.Column("added_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_builds_sound_libraries_person_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_sound_libraries_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_builds_sound_libraries")),
        sa.UniqueConstraint("studio_id", "person_id", "name", name=op.f("uq_builds_sound_libraries_studio_id_person_id_name")),
    )
    op.create_table(
        "contracts_templates",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("kind", sa.Enum("nda", "framework", "statement_of_work", "single", name="contractkind", native_enum=False, length=32), nullable=False),
        sa.Column("clauses", JSON, nullable=False),
        sa.Column("terms", JSON, nullable=False),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("changed_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name=op.f("fk_contracts_templates_created_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_templates_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_templates")),
        sa.UniqueConstraint("studio_id", "name", name=op.f("uq_contracts_templates_studio_id_name")),
    )
    op.create_index(op.f("ix_contracts_templates_studio_id"), "contracts_templates", ["studio_id"])
    op.create_table(
        "hiring_roster_entries",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("email", sa.String(), nullable=False),
        sa.Column("specialities", JSON, nullable=False),
        sa.Column("services", JSON, nullable=False),
        sa.Column("languages", JSON, nullable=False),
        sa.Column("equipment", sa.String(), nullable=False),
        sa.Column("credits", sa.String(), nullable=False),
        sa.Column("referees", sa.String(), nullable=False),
        sa.Column("links", JSON, nullable=False),
        sa.Column("exclusivity", sa.Enum("unknown", "alone", "several", name="exclusivity", native_enum=False, length=32), nullable=False),
        sa.Column("weekly_hours", sa.Integer()),
        sa.Column("available_from_on", sa.Date()),
        sa.Column("notes", sa.String(), nullable=False),
        sa.Column("rate_minor", sa.BigInteger()),
        sa.Column("rate_currency", sa.String(), nullable=False),
        sa.Column("rate_unit", sa.Enum("hour", "day", name="rateunit", native_enum=False, length=32)),
        sa.Column("calendar_name", sa.String()),
        sa.Column("calendar_read_at", sa.DateTime(timezone=True)),
        sa.Column("calendar_to_on", sa.Date()),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("added_by", sa.Uuid(), nullable=False),
        sa.Column("added_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("changed_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("(rate_minor is null) = (rate_unit is null)", name=op.f("ck_hiring_roster_entries_rate_has_a_unit")),
        sa.CheckConstraint("email = lower(email)", name=op.f("ck_hiring_roster_entries_email_lower_case")),
        sa.CheckConstraint("weekly_hours is null or weekly_hours between 1 and 168", name=op.f("ck_hiring_roster_entries_hours_of_a_week")),
        sa.ForeignKeyConstraint(["added_by"], ["accounts_people.id"], name=op.f("fk_hiring_roster_entries_added_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_hiring_roster_entries_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_hiring_roster_entries")),
        sa.UniqueConstraint("studio_id", "email", name=op.f("uq_hiring_roster_entries_studio_id_email")),
    )
    op.create_index(op.f("ix_hiring_roster_entries_studio_id"), "hiring_roster_entries", ["studio_id"])
    op.create_table(
        "notifications_mails",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid()),
        sa.Column("about_project_id", sa.Uuid()),
        sa.Column("topic", sa.String(), nullable=False),
        sa.Column("recipient", sa.String(), nullable=False),
        sa.Column("subject", sa.String(), nullable=False),
        sa.Column("lines", JSON, nullable=False),
        sa.Column("line_project_ids", JSON, nullable=False),
        sa.Column("spots", JSON, nullable=False),
        sa.Column("event_ids", JSON, nullable=False),
        sa.Column("folds", JSON, nullable=False),
        sa.Column("news", sa.String()),
        sa.Column("link", sa.String()),
        sa.Column("secret_of", sa.String()),
        sa.Column("secret_of_id", sa.Uuid()),
        sa.Column("send_after", sa.DateTime(timezone=True), nullable=False),
        sa.Column("sealed_at", sa.DateTime(timezone=True)),
        sa.Column("claimed_until", sa.DateTime(timezone=True)),
        sa.Column("sent_at", sa.DateTime(timezone=True)),
        sa.Column("failure", sa.String()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_notifications_mails_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_notifications_mails")),
    )
    op.create_index(op.f("ix_notifications_mails_studio_id"), "notifications_mails", ["studio_id"])
    op.create_index("uq_notifications_mails_open", "notifications_mails", ["topic", "recipient"], unique=True, sqlite_where=sa.text("sealed_at is null"), postgresql_where=sa.text("sealed_at is null"))
    op.create_table(
        "projects_projects",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("description", sa.String(), nullable=False),
        sa.Column("cue_prefix", sa.String(), nullable=False),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("archived_at", sa.DateTime(timezone=True)),
        sa.Column("nda_needed", sa.Boolean(), nullable=False),
        sa.Column("designers_hear", sa.Enum("own", "approved", "waiting", name="designershear", native_enum=False, length=32), nullable=False),
        sa.Column("is_sample", sa.Boolean(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name=op.f("fk_projects_projects_created_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_projects_projects_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_projects_projects")),
    )
    op.create_index(op.f("ix_projects_projects_studio_id"), "projects_projects", ["studio_id"])
    op.create_table(
        "renders_pictures",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("sound_sha256", sa.String(), nullable=False),
        sa.Column("duration_s", sa.Double()),
        sa.Column("facts", JSON, nullable=False),
        sa.Column("thumb", JSON, nullable=False),
        sa.Column("peaks_sha256", sa.String()),
        sa.Column("spectrum_sha256", sa.String()),
        sa.Column("preview_sha256", sa.String()),
        sa.Column("preview_media_type", sa.String()),
        sa.Column("light_sha256", sa.String()),
        sa.Column("drawn_bytes", sa.BigInteger()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_renders_pictures_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_renders_pictures")),
        sa.UniqueConstraint("studio_id", "sound_sha256", name=op.f("uq_renders_pictures_studio_id_sound_sha256")),
    )
    op.create_index("ix_renders_pictures_kept", "renders_pictures", ["studio_id", "drawn_bytes"])
    op.create_index(op.f("ix_renders_pictures_sound_sha256"), "renders_pictures", ["sound_sha256"])
    op.create_table(
        "renders_timbres",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("sound_sha256", sa.String(), nullable=False),
        sa.Column("timbre", JSON, nullable=False),
        sa.Column("bands_db", JSON, nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_renders_timbres_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_renders_timbres")),
        sa.UniqueConstraint("studio_id", "sound_sha256", name=op.f("uq_renders_timbres_studio_id_sound_sha256")),
    )
    op.create_index(op.f("ix_renders_timbres_studio_id"), "renders_timbres", ["studio_id"])
    op.create_table(
        "reviews_reason_lists",
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("kind", sa.Enum("change", "pick", "label", name="reasonkind", native_enum=False, length=32), nullable=False),
        sa.Column("reasons", JSON, nullable=False),
        sa.Column("set_by", sa.Uuid(), nullable=False),
        sa.Column("set_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["set_by"], ["accounts_people.id"], name=op.f("fk_reviews_reason_lists_set_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_reviews_reason_lists_studio_id")),
        sa.PrimaryKeyConstraint("studio_id", "kind", name=op.f("pk_reviews_reason_lists")),
    )
    op.create_table(
        "scenes_sounds",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("sound_sha256", sa.String(), nullable=False),
        sa.Column("part", sa.String(), nullable=False),
        sa.Column("duration_s", sa.Double()),
        sa.Column("excitation", sa.String()),
        sa.Column("thumb", JSON, nullable=False),
        sa.Column("preview_sha256", sa.String()),
        sa.Column("preview_bytes", sa.BigInteger()),
        sa.Column("problem", sa.String(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_scenes_sounds_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_scenes_sounds")),
        sa.UniqueConstraint("studio_id", "sound_sha256", "part", name=op.f("uq_scenes_sounds_studio_id_sound_sha256_part")),
    )
    op.create_index("ix_scenes_sounds_kept", "scenes_sounds", ["studio_id", "preview_sha256", "preview_bytes"])
    op.create_table(
        "shares_guest_copies",
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("preview_sha256", sa.String(), nullable=False),
        sa.Column("has_beeps", sa.Boolean(), nullable=False),
        sa.Column("sha256", sa.String()),
        sa.Column("file_bytes", sa.BigInteger()),
        sa.Column("refusal", sa.String()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("sha256 is null or refusal is null", name=op.f("ck_shares_guest_copies_made_or_refused")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_shares_guest_copies_studio_id")),
        sa.PrimaryKeyConstraint("studio_id", "key", name=op.f("pk_shares_guest_copies")),
    )
    op.create_table(
        "accounts_security_events",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid()),
        sa.Column("kind", sa.Enum("sign_in", "email", "password", "second_factor", "roles", "removal", "token", "webhook", "guest_link", "export", name="securityeventkind", native_enum=False, length=32), nullable=False),
        sa.Column("summary", sa.String(), nullable=False),
        sa.Column("person_id", sa.Uuid()),
        sa.Column("about_id", sa.Uuid()),
        sa.Column("network", sa.String(), nullable=False),
        sa.Column("at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["about_id"], ["accounts_people.id"], name=op.f("fk_accounts_security_events_about_id")),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_accounts_security_events_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_accounts_security_events_project_id"), ondelete="SET NULL"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_accounts_security_events_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_accounts_security_events")),
    )
    op.create_index(op.f("ix_accounts_security_events_about_id"), "accounts_security_events", ["about_id"])
    op.create_index(op.f("ix_accounts_security_events_at"), "accounts_security_events", ["at"])
    op.create_index(op.f("ix_accounts_security_events_person_id"), "accounts_security_events", ["person_id"])
    op.create_index(op.f("ix_accounts_security_events_project_id"), "accounts_security_events", ["project_id"])
    op.create_index("ix_accounts_security_events_studio_id", "accounts_security_events", ["studio_id", "id"])
    op.create_table(
        "briefs_briefs",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("answers", JSON, nullable=False),
        sa.Column("changed_by", sa.Uuid(), nullable=False),
        sa.Column("changed_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["changed_by"], ["accounts_people.id"], name=op.f("fk_briefs_briefs_changed_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_briefs_briefs_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_briefs_briefs_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_briefs_briefs")),
        sa.UniqueConstraint("project_id", name=op.f("uq_briefs_briefs_project_id")),
    )
    op.create_index(op.f("ix_briefs_briefs_studio_id"), "briefs_briefs", ["studio_id"])
    op.create_table(
        "briefs_decisions",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("decided_on", sa.Date(), nullable=False),
        sa.Column("attended", sa.String(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("written_by", sa.Uuid(), nullable=False),
        sa.Column("signed_at", sa.DateTime(timezone=True)),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_briefs_decisions_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_briefs_decisions_studio_id")),
        sa.ForeignKeyConstraint(["written_by"], ["accounts_people.id"], name=op.f("fk_briefs_decisions_written_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_briefs_decisions")),
    )
    op.create_index(op.f("ix_briefs_decisions_project_id"), "briefs_decisions", ["project_id"])
    op.create_index(op.f("ix_briefs_decisions_studio_id"), "briefs_decisions", ["studio_id"])
    op.create_table(
        "briefs_follow_ups",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("question", sa.String(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("asked_by", sa.Uuid(), nullable=False),
        sa.Column("asked_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("answer", sa.String()),
        sa.Column("answered_by", sa.Uuid()),
        sa.Column("answered_at", sa.DateTime(timezone=True)),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["answered_by"], ["accounts_people.id"], name=op.f("fk_briefs_follow_ups_answered_by")),
        sa.ForeignKeyConstraint(["asked_by"], ["accounts_people.id"], name=op.f("fk_briefs_follow_ups_asked_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_briefs_follow_ups_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_briefs_follow_ups_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_briefs_follow_ups")),
    )
    op.create_index(op.f("ix_briefs_follow_ups_project_id"), "briefs_follow_ups", ["project_id"])
    op.create_index(op.f("ix_briefs_follow_ups_studio_id"), "briefs_follow_ups", ["studio_id"])
    op.create_table(
        "briefs_versions",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("answers", JSON, nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("published_by", sa.Uuid(), nullable=False),
        sa.Column("published_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_briefs_versions_project_id")),
        sa.ForeignKeyConstraint(["published_by"], ["accounts_people.id"], name=op.f("fk_briefs_versions_published_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_briefs_versions_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_briefs_versions")),
        sa.UniqueConstraint("project_id", "number", name=op.f("uq_briefs_versions_project_id_number")),
    )
    op.create_index(op.f("ix_briefs_versions_studio_id"), "briefs_versions", ["studio_id"])
    op.create_table(
        "builds_accepted_drifts",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("target", sa.String(), nullable=False),
        sa.Column("path", sa.String(), nullable=False),
        sa.Column("status", sa.Enum("same", "gain", "trimmed", "resampled", "re-encoded", "changed", "missing", "unknown", "placeholder", "duplicate", "converted", "unapproved", "unused", "depends", name="auditstatus", native_enum=False, length=32), nullable=False),
        sa.Column("played_status", sa.Enum("same", "gain", "trimmed", "resampled", "re-encoded", "changed", "missing", "unknown", "placeholder", "duplicate", "converted", "unapproved", "unused", "depends", name="auditstatus", native_enum=False, length=32), nullable=False),
        sa.Column("gain_db", sa.Double()),
        sa.Column("reason", sa.String(), nullable=False),
        sa.Column("accepted_by", sa.Uuid(), nullable=False),
        sa.Column("accepted_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("withdrawn_by", sa.Uuid()),
        sa.Column("withdrawn_at", sa.DateTime(timezone=True)),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("(withdrawn_at is null) = (withdrawn_by is null)", name=op.f("ck_builds_accepted_drifts_withdrawn_by_a_person")),
        sa.ForeignKeyConstraint(["accepted_by"], ["accounts_people.id"], name=op.f("fk_builds_accepted_drifts_accepted_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_builds_accepted_drifts_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_accepted_drifts_studio_id")),
        sa.ForeignKeyConstraint(["withdrawn_by"], ["accounts_people.id"], name=op.f("fk_builds_accepted_drifts_withdrawn_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_builds_accepted_drifts")),
    )
    op.create_index("ix_builds_accepted_drifts_project", "builds_accepted_drifts", ["project_id", "id"])
    op.create_index(op.f("ix_builds_accepted_drifts_studio_id"), "builds_accepted_drifts", ["studio_id"])
    op.create_table(
        "builds_audits",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("label", sa.String(), nullable=False),
        sa.Column("commit", sa.String(), nullable=False),
        sa.Column("target", sa.String(), nullable=False),
        sa.Column("engine", sa.String(), nullable=False),
        sa.Column("sounds", sa.Integer(), nullable=False),
        sa.Column("drifted", sa.Integer(), nullable=False),
        sa.Column("new_drifts", sa.Integer(), nullable=False),
        sa.Column("unread", JSON, nullable=False),
        sa.Column("token_id", sa.Uuid()),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_builds_audits_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_audits_studio_id")),
        sa.ForeignKeyConstraint(["token_id"], ["accounts_tokens.id"], name=op.f("fk_builds_audits_token_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_builds_audits")),
    )
    op.create_index("ix_builds_audits_newest", "builds_audits", ["project_id", "target", "id"])
    op.create_index(op.f("ix_builds_audits_studio_id"), "builds_audits", ["studio_id"])
    op.create_table(
        "builds_builds",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("label", sa.String(), nullable=False),
        sa.Column("commit", sa.String(), nullable=False),
        sa.Column("target", sa.String(), nullable=False),
        sa.Column("files", sa.Integer(), nullable=False),
        sa.Column("rejected", sa.Integer(), nullable=False),
        sa.Column("warnings", sa.Integer(), nullable=False),
        sa.Column("report", JSON, nullable=False),
        sa.Column("token_id", sa.Uuid()),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_builds_builds_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_builds_studio_id")),
        sa.ForeignKeyConstraint(["token_id"], ["accounts_tokens.id"], name=op.f("fk_builds_builds_token_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_builds_builds")),
    )
    op.create_index(op.f("ix_builds_builds_project_id"), "builds_builds", ["project_id"])
    op.create_index(op.f("ix_builds_builds_studio_id"), "builds_builds", ["studio_id"])
    op.create_table(
        "builds_library_sounds",
        sa.Column("library_id", sa.Uuid(), nullable=False),
        sa.Column("path", sa.String(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("fingerprint_version", sa.Integer(), nullable=False),
        sa.Column("pcm_sha256", sa.String(), nullable=False),
        sa.Column("sample_rate_hz", sa.Integer(), nullable=False),
        sa.Column("fingerprint", sa.LargeBinary(), nullable=False),
        sa.Column("moments", sa.LargeBinary(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["library_id"], ["builds_sound_libraries.id"], name=op.f("fk_builds_library_sounds_library_id"), ondelete="CASCADE"),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_builds_library_sounds_person_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_library_sounds_studio_id")),
        sa.PrimaryKeyConstraint("library_id", "path", name=op.f("pk_builds_library_sounds")),
    )
    op.create_index(op.f("ix_builds_library_sounds_studio_id"), "builds_library_sounds", ["studio_id"])
    op.create_table(
        "builds_packs",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("target", sa.String(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("with_masters", sa.Boolean(), nullable=False),
        sa.Column("allow_missing", sa.Boolean(), nullable=False),
        sa.Column("placeholders", sa.Boolean(), nullable=False),
        sa.Column("handoff", sa.Enum("none", "fmod", "godot", "unity", "unreal", "wwise", name="handoff", native_enum=False, length=32), nullable=False),
        sa.Column("state", sa.Enum("sealing", "sealed", "refused", name="packstate", native_enum=False, length=32), nullable=False),
        sa.Column("refusal", sa.String(), nullable=False),
        sa.Column("sealed_by", sa.Uuid(), nullable=False),
        sa.Column("sealed_at", sa.DateTime(timezone=True)),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(state = 'sealed') = (sealed_at is not null)", name=op.f("ck_builds_packs_sealed_is_dated")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_builds_packs_project_id")),
        sa.ForeignKeyConstraint(["sealed_by"], ["accounts_people.id"], name=op.f("fk_builds_packs_sealed_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_packs_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_builds_packs")),
        sa.UniqueConstraint("project_id", "target", "number", name=op.f("uq_builds_packs_project_id_target_number")),
    )
    op.create_index(op.f("ix_builds_packs_studio_id"), "builds_packs", ["studio_id"])
    op.create_table(
        "contracts_calendar_links",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("secret_sha256", sa.String(), nullable=False),
        sa.Column("revoked_at", sa.DateTime(timezone=True)),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_contracts_calendar_links_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_calendar_links_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_calendar_links_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_calendar_links")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_contracts_calendar_links_secret_sha256")),
    )
    op.create_index(op.f("ix_contracts_calendar_links_person_id"), "contracts_calendar_links", ["person_id"])
    op.create_index(op.f("ix_contracts_calendar_links_project_id"), "contracts_calendar_links", ["project_id"])
    op.create_index(op.f("ix_contracts_calendar_links_studio_id"), "contracts_calendar_links", ["studio_id"])
    op.create_table(
        "deliveries_deliveries",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("closed_at", sa.DateTime(timezone=True)),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name=op.f("fk_deliveries_deliveries_designer_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_deliveries_deliveries_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_deliveries_deliveries_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_deliveries_deliveries")),
        sa.UniqueConstraint("project_id", "number", name=op.f("uq_deliveries_deliveries_project_id_number")),
    )
    op.create_index(op.f("ix_deliveries_deliveries_designer_id"), "deliveries_deliveries", ["designer_id"])
    op.create_index(op.f("ix_deliveries_deliveries_project_id"), "deliveries_deliveries", ["project_id"])
    op.create_index(op.f("ix_deliveries_deliveries_studio_id"), "deliveries_deliveries", ["studio_id"])
    op.create_table(
        "deliveries_tray_actions",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("kind", sa.Enum("matched", "moved", "discarded", "restored", "split", name="trayactionkind", native_enum=False, length=32), nullable=False),
        sa.Column("done_by", sa.Uuid(), nullable=False),
        sa.Column("done_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("undone_at", sa.DateTime(timezone=True)),
        sa.Column("takes", JSON, nullable=False),
        sa.ForeignKeyConstraint(["done_by"], ["accounts_people.id"], name=op.f("fk_deliveries_tray_actions_done_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_deliveries_tray_actions_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_deliveries_tray_actions_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_deliveries_tray_actions")),
    )
    op.create_index("ix_deliveries_tray_actions_project", "deliveries_tray_actions", ["project_id", "id"])
    op.create_table(
        "hiring_busy_ranges",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("entry_id", sa.Uuid(), nullable=False),
        sa.Column("from_on", sa.Date(), nullable=False),
        sa.Column("to_on", sa.Date(), nullable=False),
        sa.Column("kind", sa.Enum("booked", "half_days", name="busykind", native_enum=False, length=32), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("is_from_calendar", sa.Boolean(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("from_on <= to_on", name=op.f("ck_hiring_busy_ranges_in_order")),
        sa.ForeignKeyConstraint(["entry_id"], ["hiring_roster_entries.id"], name=op.f("fk_hiring_busy_ranges_entry_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_hiring_busy_ranges_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_hiring_busy_ranges")),
    )
    op.create_index(op.f("ix_hiring_busy_ranges_entry_id"), "hiring_busy_ranges", ["entry_id"])
    op.create_index(op.f("ix_hiring_busy_ranges_studio_id"), "hiring_busy_ranges", ["studio_id"])
    op.create_table(
        "hiring_loans",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("entry_id", sa.Uuid(), nullable=False),
        sa.Column("item", sa.String(), nullable=False),
        sa.Column("lent_on", sa.Date(), nullable=False),
        sa.Column("due_on", sa.Date()),
        sa.Column("returned_on", sa.Date()),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("due_on is null or due_on >= lent_on", name=op.f("ck_hiring_loans_due_after_lent")),
        sa.CheckConstraint("returned_on is null or returned_on >= lent_on", name=op.f("ck_hiring_loans_returned_after_lent")),
        sa.ForeignKeyConstraint(["entry_id"], ["hiring_roster_entries.id"], name=op.f("fk_hiring_loans_entry_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_hiring_loans_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_hiring_loans")),
    )
    op.create_index(op.f("ix_hiring_loans_entry_id"), "hiring_loans", ["entry_id"])
    op.create_index(op.f("ix_hiring_loans_studio_id"), "hiring_loans", ["studio_id"])
    op.create_table(
        "hiring_postings",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("title", sa.String(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("equipment", sa.String(), nullable=False),
        sa.Column("phase", sa.Enum("production", "advisory", name="postingphase", native_enum=False, length=32), nullable=False),
        sa.Column("state", sa.Enum("draft", "open", "closed", "awarded", name="postingstate", native_enum=False, length=32), nullable=False),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("currency", sa.String(), nullable=False),
        sa.Column("price_minor", sa.BigInteger()),
        sa.Column("budget_minor", sa.BigInteger()),
        sa.Column("is_budget_shown", sa.Boolean(), nullable=False),
        sa.Column("rate_floor_minor", sa.BigInteger()),
        sa.Column("scope", sa.Enum("all", "categories", "cues", name="askedscope", native_enum=False, length=32), nullable=False),
        sa.Column("categories", JSON, nullable=False),
        sa.Column("cue_ids", JSON, nullable=False),
        sa.Column("lines", JSON, nullable=False),
        sa.Column("headings", JSON, nullable=False),
        sa.Column("bids_until_on", sa.Date()),
        sa.Column("work_from_on", sa.Date()),
        sa.Column("work_to_on", sa.Date()),
        sa.Column("secret_sha256", sa.String()),
        sa.Column("link_made_by", sa.Uuid()),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("opened_at", sa.DateTime(timezone=True)),
        sa.Column("closed_at", sa.DateTime(timezone=True)),
        sa.Column("awarded_bid_id", sa.Uuid()),
        sa.Column("awarded_at", sa.DateTime(timezone=True)),
        sa.Column("contract_id", sa.Uuid()),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name=op.f("fk_hiring_postings_created_by")),
        sa.ForeignKeyConstraint(["link_made_by"], ["accounts_people.id"], name=op.f("fk_hiring_postings_link_made_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_hiring_postings_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_hiring_postings_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_hiring_postings")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_hiring_postings_secret_sha256")),
    )
    op.create_index(op.f("ix_hiring_postings_project_id"), "hiring_postings", ["project_id"])
    op.create_index(op.f("ix_hiring_postings_studio_id"), "hiring_postings", ["studio_id"])
    op.create_table(
        "hiring_reel_sounds",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("entry_id", sa.Uuid(), nullable=False),
        sa.Column("title", sa.String(), nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("media_type", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("file_bytes", sa.BigInteger(), nullable=False),
        sa.Column("added_by", sa.Uuid(), nullable=False),
        sa.Column("added_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("file_bytes > 0", name=op.f("ck_hiring_reel_sounds_not_empty")),
        sa.ForeignKeyConstraint(["added_by"], ["accounts_people.id"], name=op.f("fk_hiring_reel_sounds_added_by")),
        sa.ForeignKeyConstraint(["entry_id"], ["hiring_roster_entries.id"], name=op.f("fk_hiring_reel_sounds_entry_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_hiring_reel_sounds_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_hiring_reel_sounds")),
    )
    op.create_index(op.f("ix_hiring_reel_sounds_entry_id"), "hiring_reel_sounds", ["entry_id"])
    op.create_index(op.f("ix_hiring_reel_sounds_studio_id"), "hiring_reel_sounds", ["studio_id"])
    op.create_table(
        "notifications_notices",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid()),
        sa.Column("topic", sa.String(), nullable=False),
        sa.Column("event_id", sa.String(), nullable=False),
        sa.Column("event_ids", JSON, nullable=False),
        sa.Column("count", sa.Integer(), nullable=False),
        sa.Column("is_open", sa.Boolean(), nullable=False),
        sa.Column("news", sa.String(), nullable=False),
        sa.Column("subject", sa.String(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("path", sa.String(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("read_at", sa.DateTime(timezone=True)),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_notifications_notices_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_notifications_notices_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_notifications_notices_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_notifications_notices")),
        sa.UniqueConstraint("person_id", "topic", "event_id", name=op.f("uq_notifications_notices_person_id_topic_event_id")),
    )
    op.create_index("ix_notifications_notices_of_person", "notifications_notices", ["person_id", "id"])
    op.create_index(op.f("ix_notifications_notices_project_id"), "notifications_notices", ["project_id"])
    op.create_index(op.f("ix_notifications_notices_read_at"), "notifications_notices", ["read_at"])
    op.create_index(op.f("ix_notifications_notices_studio_id"), "notifications_notices", ["studio_id"])
    op.create_index("ix_notifications_notices_unread", "notifications_notices", ["person_id"], sqlite_where=sa.text("read_at is null"), postgresql_where=sa.text("read_at is null"))
    op.create_index("uq_notifications_notices_open", "notifications_notices", ["person_id", "topic"], unique=True, sqlite_where=sa.text("is_open"), postgresql_where=sa.text("is_open"))
    op.create_table(
        "operations_erasures",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid()),
        sa.Column("requested_by", sa.Uuid(), nullable=False),
        sa.Column("requested_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("due_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_operations_erasures_project_id")),
        sa.ForeignKeyConstraint(["requested_by"], ["accounts_people.id"], name=op.f("fk_operations_erasures_requested_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_operations_erasures_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_operations_erasures")),
    )
    op.create_index(op.f("ix_operations_erasures_due_at"), "operations_erasures", ["due_at"])
    op.create_index(op.f("ix_operations_erasures_requested_by"), "operations_erasures", ["requested_by"])
    op.create_index("uq_operations_erasures_of_project", "operations_erasures", ["project_id"], unique=True)
    op.create_index("uq_operations_erasures_of_studio", "operations_erasures", ["studio_id"], unique=True, sqlite_where=sa.text("project_id is null"), postgresql_where=sa.text("project_id is null"))
    op.create_table(
        "operations_master_retentions",
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column("ends_on", sa.Date()),
        sa.Column("announced_at", sa.DateTime(timezone=True)),
        sa.Column("kept_by", sa.Uuid()),
        sa.Column("kept_at", sa.DateTime(timezone=True)),
        sa.Column("deleted_at", sa.DateTime(timezone=True)),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name=op.f("fk_operations_master_retentions_designer_id")),
        sa.ForeignKeyConstraint(["kept_by"], ["accounts_people.id"], name=op.f("fk_operations_master_retentions_kept_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_operations_master_retentions_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_operations_master_retentions_studio_id")),
        sa.PrimaryKeyConstraint("project_id", "designer_id", name=op.f("pk_operations_master_retentions")),
    )
    op.create_index(op.f("ix_operations_master_retentions_studio_id"), "operations_master_retentions", ["studio_id"])
    op.create_table(
        "projects_approver_changes",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("reason", sa.String(), nullable=False),
        sa.Column("changed_by", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["changed_by"], ["accounts_people.id"], name=op.f("fk_projects_approver_changes_changed_by")),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_projects_approver_changes_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_projects_approver_changes_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_projects_approver_changes_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_projects_approver_changes")),
    )
    op.create_index(op.f("ix_projects_approver_changes_project_id"), "projects_approver_changes", ["project_id"])
    op.create_index(op.f("ix_projects_approver_changes_studio_id"), "projects_approver_changes", ["studio_id"])
    op.create_table(
        "projects_budgets",
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("currency", sa.String(), nullable=False),
        sa.Column("amount_minor", sa.BigInteger(), nullable=False),
        sa.Column("set_by", sa.Uuid(), nullable=False),
        sa.Column("set_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("amount_minor > 0", name=op.f("ck_projects_budgets_not_nothing")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_projects_budgets_project_id")),
        sa.ForeignKeyConstraint(["set_by"], ["accounts_people.id"], name=op.f("fk_projects_budgets_set_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_projects_budgets_studio_id")),
        sa.PrimaryKeyConstraint("project_id", "currency", name=op.f("pk_projects_budgets")),
    )
    op.create_index(op.f("ix_projects_budgets_studio_id"), "projects_budgets", ["studio_id"])
    op.create_table(
        "projects_category_approvers",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("category", sa.String(), nullable=False),
        sa.Column("person_id", sa.Uuid()),
        sa.Column("named_by", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("category <> ''", name=op.f("ck_projects_category_approvers_names_a_category")),
        sa.ForeignKeyConstraint(["named_by"], ["accounts_people.id"], name=op.f("fk_projects_category_approvers_named_by")),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_projects_category_approvers_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_projects_category_approvers_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_projects_category_approvers_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_projects_category_approvers")),
    )
    op.create_index(op.f("ix_projects_category_approvers_project_id"), "projects_category_approvers", ["project_id"])
    op.create_index(op.f("ix_projects_category_approvers_studio_id"), "projects_category_approvers", ["studio_id"])
    op.create_table(
        "projects_credit_lines",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("role", sa.String(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("added_by", sa.Uuid(), nullable=False),
        sa.Column("added_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("role <> '' and name <> ''", name=op.f("ck_projects_credit_lines_role_and_name")),
        sa.ForeignKeyConstraint(["added_by"], ["accounts_people.id"], name=op.f("fk_projects_credit_lines_added_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_projects_credit_lines_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_projects_credit_lines_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_projects_credit_lines")),
    )
    op.create_index(op.f("ix_projects_credit_lines_project_id"), "projects_credit_lines", ["project_id"])
    op.create_index(op.f("ix_projects_credit_lines_studio_id"), "projects_credit_lines", ["studio_id"])
    op.create_table(
        "projects_credit_names",
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("is_left_out", sa.Boolean(), nullable=False),
        sa.Column("changed_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_projects_credit_names_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_projects_credit_names_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_projects_credit_names_studio_id")),
        sa.PrimaryKeyConstraint("project_id", "person_id", name=op.f("pk_projects_credit_names")),
    )
    op.create_index(op.f("ix_projects_credit_names_person_id"), "projects_credit_names", ["person_id"])
    op.create_index(op.f("ix_projects_credit_names_studio_id"), "projects_credit_names", ["studio_id"])
    op.create_table(
        "projects_deputies",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("deputy_id", sa.Uuid(), nullable=False),
        sa.Column("from_on", sa.Date(), nullable=False),
        sa.Column("until_on", sa.Date(), nullable=False),
        sa.Column("named_by", sa.Uuid(), nullable=False),
        sa.Column("withdrawn_at", sa.DateTime(timezone=True)),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("deputy_id <> person_id", name=op.f("ck_projects_deputies_two_people")),
        sa.CheckConstraint("until_on >= from_on", name=op.f("ck_projects_deputies_ends_after_it_began")),
        sa.ForeignKeyConstraint(["deputy_id"], ["accounts_people.id"], name=op.f("fk_projects_deputies_deputy_id")),
        sa.ForeignKeyConstraint(["named_by"], ["accounts_people.id"], name=op.f("fk_projects_deputies_named_by")),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_projects_deputies_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_projects_deputies_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_projects_deputies_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_projects_deputies")),
    )
    op.create_index(op.f("ix_projects_deputies_project_id"), "projects_deputies", ["project_id"])
    op.create_index(op.f("ix_projects_deputies_studio_id"), "projects_deputies", ["studio_id"])
    op.create_table(
        "projects_engagements",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column("kind", sa.Enum("advisory", "contract", "in-house", name="engagementkind", native_enum=False, length=32), nullable=False),
        sa.Column("kind_since", sa.DateTime(timezone=True), nullable=False),
        sa.Column("ended_at", sa.DateTime(timezone=True)),
        sa.Column("nda_sha256", sa.String()),
        sa.Column("nda_accepted_at", sa.DateTime(timezone=True)),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(nda_sha256 is null) = (nda_accepted_at is null)", name=op.f("ck_projects_engagements_nda_is_dated")),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name=op.f("fk_projects_engagements_designer_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_projects_engagements_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_projects_engagements_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_projects_engagements")),
        sa.UniqueConstraint("project_id", "designer_id", name=op.f("uq_projects_engagements_project_id_designer_id")),
    )
    op.create_index(op.f("ix_projects_engagements_designer_id"), "projects_engagements", ["designer_id"])
    op.create_index(op.f("ix_projects_engagements_project_id"), "projects_engagements", ["project_id"])
    op.create_index(op.f("ix_projects_engagements_studio_id"), "projects_engagements", ["studio_id"])
    op.create_table(
        "projects_invitations",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("email", sa.String(), nullable=False),
        sa.Column("kind", sa.Enum("advisory", "contract", "in-house", name="engagementkind", native_enum=False, length=32), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("invited_by", sa.Uuid(), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("accepted_at", sa.DateTime(timezone=True)),
        sa.Column("accepted_by", sa.Uuid()),
        sa.Column("revoked_at", sa.DateTime(timezone=True)),
        sa.Column("secret_sha256", sa.String()),
        sa.Column("is_sent_by_mail_only", sa.Boolean(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["accepted_by"], ["accounts_people.id"], name=op.f("fk_projects_invitations_accepted_by")),
        sa.ForeignKeyConstraint(["invited_by"], ["accounts_people.id"], name=op.f("fk_projects_invitations_invited_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_projects_invitations_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_projects_invitations_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_projects_invitations")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_projects_invitations_secret_sha256")),
    )
    op.create_index(op.f("ix_projects_invitations_project_id"), "projects_invitations", ["project_id"])
    op.create_index(op.f("ix_projects_invitations_studio_id"), "projects_invitations", ["studio_id"])
    op.create_table(
        "projects_liaisons",
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_projects_liaisons_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_projects_liaisons_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_projects_liaisons_studio_id")),
        sa.PrimaryKeyConstraint("project_id", "person_id", name=op.f("pk_projects_liaisons")),
    )
    op.create_index(op.f("ix_projects_liaisons_studio_id"), "projects_liaisons", ["studio_id"])
    op.create_table(
        "projects_members",
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_projects_members_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_projects_members_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_projects_members_studio_id")),
        sa.PrimaryKeyConstraint("project_id", "person_id", name=op.f("pk_projects_members")),
    )
    op.create_index(op.f("ix_projects_members_person_id"), "projects_members", ["person_id"])
    op.create_index(op.f("ix_projects_members_studio_id"), "projects_members", ["studio_id"])
    op.create_table(
        "projects_specs",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("toml", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name=op.f("fk_projects_specs_created_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_projects_specs_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_projects_specs_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_projects_specs")),
        sa.UniqueConstraint("project_id", "version", name=op.f("uq_projects_specs_project_id_version")),
    )
    op.create_index(op.f("ix_projects_specs_project_id"), "projects_specs", ["project_id"])
    op.create_index(op.f("ix_projects_specs_studio_id"), "projects_specs", ["studio_id"])
    op.create_table(
        "reviews_approval_rules",
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("blockers", sa.Enum("none", "notes", "items", "both", name="approvalblockers", native_enum=False, length=32), nullable=False),
        sa.Column("set_by", sa.Uuid(), nullable=False),
        sa.Column("set_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_reviews_approval_rules_project_id")),
        sa.ForeignKeyConstraint(["set_by"], ["accounts_people.id"], name=op.f("fk_reviews_approval_rules_set_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_reviews_approval_rules_studio_id")),
        sa.PrimaryKeyConstraint("project_id", name=op.f("pk_reviews_approval_rules")),
    )
    op.create_index(op.f("ix_reviews_approval_rules_studio_id"), "reviews_approval_rules", ["studio_id"])
    op.create_table(
        "reviews_checklist_items",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("category", sa.String(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("place", sa.Integer(), nullable=False),
        sa.Column("written_by", sa.Uuid(), nullable=False),
        sa.Column("removed_at", sa.DateTime(timezone=True)),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("text <> ''", name=op.f("ck_reviews_checklist_items_has_text")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_reviews_checklist_items_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_reviews_checklist_items_studio_id")),
        sa.ForeignKeyConstraint(["written_by"], ["accounts_people.id"], name=op.f("fk_reviews_checklist_items_written_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_reviews_checklist_items")),
        sa.UniqueConstraint("project_id", "category", "text", name=op.f("uq_reviews_checklist_items_project_id_category_text")),
    )
    op.create_index(op.f("ix_reviews_checklist_items_studio_id"), "reviews_checklist_items", ["studio_id"])
    op.create_table(
        "reviews_feedback",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("sent_by", sa.Uuid(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_reviews_feedback_project_id")),
        sa.ForeignKeyConstraint(["sent_by"], ["accounts_people.id"], name=op.f("fk_reviews_feedback_sent_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_reviews_feedback_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_reviews_feedback")),
    )
    op.create_index(op.f("ix_reviews_feedback_project_id"), "reviews_feedback", ["project_id"])
    op.create_index(op.f("ix_reviews_feedback_studio_id"), "reviews_feedback", ["studio_id"])
    op.create_table(
        "reviews_palette_approvals",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("approved_by", sa.Uuid(), nullable=False),
        sa.Column("cue_ids", JSON, nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["approved_by"], ["accounts_people.id"], name=op.f("fk_reviews_palette_approvals_approved_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_reviews_palette_approvals_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_reviews_palette_approvals_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_reviews_palette_approvals")),
    )
    op.create_index(op.f("ix_reviews_palette_approvals_project_id"), "reviews_palette_approvals", ["project_id"])
    op.create_index(op.f("ix_reviews_palette_approvals_studio_id"), "reviews_palette_approvals", ["studio_id"])
    op.create_table(
        "scenes_comparisons",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("sound_sha256", sa.String(), nullable=False),
        sa.Column("against_sha256", sa.String(), nullable=False),
        sa.Column("lag_s", sa.Double()),
        sa.Column("gain_db", sa.Double()),
        sa.Column("residue_db", sa.Double()),
        sa.Column("spectra", JSON, nullable=False),
        sa.Column("sha256", sa.String()),
        sa.Column("file_bytes", sa.BigInteger()),
        sa.Column("refusal", sa.String()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("sha256 is null or refusal is null", name=op.f("ck_scenes_comparisons_made_or_refused")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_scenes_comparisons_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_scenes_comparisons_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_scenes_comparisons")),
        sa.UniqueConstraint("project_id", "sound_sha256", "against_sha256", name=op.f("uq_scenes_comparisons_project_id_sound_sha256_against_sha256")),
    )
    op.create_index("ix_scenes_comparisons_kept", "scenes_comparisons", ["studio_id", "sha256", "file_bytes"])
    op.create_table(
        "shares_guest_links",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("kind", sa.Enum("cues", "palette", "approved", "playlist", name="sharedkind", native_enum=False, length=32), nullable=False),
        sa.Column("title", sa.String(), nullable=False),
        sa.Column("secret_sha256", sa.String(), nullable=False),
        sa.Column("password_hash", sa.String()),
        sa.Column("may_comment", sa.Boolean(), nullable=False),
        sa.Column("has_beeps", sa.Boolean(), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True)),
        sa.Column("max_openings", sa.Integer()),
        sa.Column("openings", sa.Integer(), nullable=False),
        sa.Column("made_by", sa.Uuid(), nullable=False),
        sa.Column("revoked_at", sa.DateTime(timezone=True)),
        sa.Column("revoked_by", sa.Uuid()),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(revoked_at is null) = (revoked_by is null)", name=op.f("ck_shares_guest_links_revoked_by_a_person")),
        sa.CheckConstraint("max_openings is null or max_openings > 0", name=op.f("ck_shares_guest_links_opened_at_least_once")),
        sa.ForeignKeyConstraint(["made_by"], ["accounts_people.id"], name=op.f("fk_shares_guest_links_made_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_shares_guest_links_project_id")),
        sa.ForeignKeyConstraint(["revoked_by"], ["accounts_people.id"], name=op.f("fk_shares_guest_links_revoked_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_shares_guest_links_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_shares_guest_links")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_shares_guest_links_secret_sha256")),
    )
    op.create_index("ix_shares_guest_links_project", "shares_guest_links", ["project_id", "id"])
    op.create_index(op.f("ix_shares_guest_links_studio_id"), "shares_guest_links", ["studio_id"])
    op.create_table(
        "shares_playlists",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("edition", sa.Integer(), nullable=False),
        sa.Column("made_by", sa.Uuid(), nullable=False),
        sa.Column("removed_at", sa.DateTime(timezone=True)),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["made_by"], ["accounts_people.id"], name=op.f("fk_shares_playlists_made_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_shares_playlists_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_shares_playlists_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_shares_playlists")),
    )
    op.create_index("ix_shares_playlists_project", "shares_playlists", ["project_id", "id"])
    op.create_index(op.f("ix_shares_playlists_studio_id"), "shares_playlists", ["studio_id"])
    op.create_table(
        "shares_saved_views",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("page", sa.Enum("sound_list", "review_queue", name="viewedpage", native_enum=False, length=32), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("query", sa.String(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_shares_saved_views_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_shares_saved_views_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_shares_saved_views_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_shares_saved_views")),
        sa.UniqueConstraint("project_id", "person_id", "page", "name", name=op.f("uq_shares_saved_views_project_id_person_id_page_name")),
    )
    op.create_index(op.f("ix_shares_saved_views_person_id"), "shares_saved_views", ["person_id"])
    op.create_index(op.f("ix_shares_saved_views_studio_id"), "shares_saved_views", ["studio_id"])
    op.create_table(
        "sound_lists_columns",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("folded", sa.String(), nullable=False),
        sa.Column("kind", sa.Enum("text", "number", "yes_no", "choice", "date", name="columnkind", native_enum=False, length=32), nullable=False),
        sa.Column("choices", JSON, nullable=False),
        sa.Column("position", sa.Integer(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_sound_lists_columns_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_sound_lists_columns_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_sound_lists_columns")),
        sa.UniqueConstraint("project_id", "folded", name=op.f("uq_sound_lists_columns_project_id_folded")),
    )
    op.create_index(op.f("ix_sound_lists_columns_studio_id"), "sound_lists_columns", ["studio_id"])
    op.create_table(
        "sound_lists_cues",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("position", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("category", sa.String(), nullable=False),
        sa.Column("description", sa.String(), nullable=False),
        sa.Column("use", sa.String(), nullable=False),
        sa.Column("trigger", sa.String(), nullable=False),
        sa.Column("duration_s", sa.Double()),
        sa.Column("duration_min_s", sa.Double()),
        sa.Column("duration_max_s", sa.Double()),
        sa.Column("length_locked", sa.Boolean(), nullable=False),
        sa.Column("frame_rate_fps", sa.Double()),
        sa.Column("loop", sa.Boolean(), nullable=False),
        sa.Column("reverb", sa.Enum("dry", "designed-tail", "separate-tail", name="reverb", native_enum=False, length=32)),
        sa.Column("channels", sa.Enum("mono", "stereo", name="cuechannels", native_enum=False, length=32)),
        sa.Column("variations", sa.Integer(), nullable=False),
        sa.Column("state", sa.Enum("concept", "prototype", "locked", "cut", name="cuestate", native_enum=False, length=32), nullable=False),
        sa.Column("phase", sa.Enum("concept", "palette", "alpha", "beta", "gold", name="phase", native_enum=False, length=32)),
        sa.Column("need", sa.Enum("must", "should", "wish", name="need", native_enum=False, length=32), nullable=False),
        sa.Column("playback_priority", sa.Integer()),
        sa.Column("due_on", sa.Date()),
        sa.Column("placeholder", sa.Boolean(), nullable=False),
        sa.Column("palette", sa.Boolean(), nullable=False),
        sa.Column("implementer_id", sa.Uuid()),
        sa.Column("recorder_id", sa.Uuid()),
        sa.Column("extra", JSON, nullable=False),
        sa.Column("dismissed_facts", JSON, nullable=False),
        sa.Column("edition", sa.Integer(), nullable=False),
        sa.Column("cut_reason", sa.String()),
        sa.Column("cut_at", sa.DateTime(timezone=True)),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(state = 'cut') = (cut_at is not null)", name=op.f("ck_sound_lists_cues_cut_is_dated")),
        sa.CheckConstraint("duration_min_s > 0 and duration_max_s >= duration_min_s", name=op.f("ck_sound_lists_cues_duration_bounds_in_order")),
        sa.CheckConstraint("duration_s is null or duration_s > 0", name=op.f("ck_sound_lists_cues_duration_positive")),
        sa.CheckConstraint("variations between 1 and 99", name=op.f("ck_sound_lists_cues_variations_in_range")),
        sa.ForeignKeyConstraint(["implementer_id"], ["accounts_people.id"], name=op.f("fk_sound_lists_cues_implementer_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_sound_lists_cues_project_id")),
        sa.ForeignKeyConstraint(["recorder_id"], ["accounts_people.id"], name=op.f("fk_sound_lists_cues_recorder_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_sound_lists_cues_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_sound_lists_cues")),
        sa.UniqueConstraint("project_id", "number", name=op.f("uq_sound_lists_cues_project_id_number")),
    )
    op.create_index("ix_sound_lists_cues_category", "sound_lists_cues", ["project_id", "category", "id", "studio_id"])
    op.create_index("ix_sound_lists_cues_counted", "sound_lists_cues", ["state", "project_id", "variations", "placeholder"])
    op.create_index(op.f("ix_sound_lists_cues_implementer_id"), "sound_lists_cues", ["implementer_id"])
    op.create_index("ix_sound_lists_cues_order", "sound_lists_cues", ["project_id", "position", "number"])
    op.create_index("ix_sound_lists_cues_palette", "sound_lists_cues", ["project_id", "position", "number"], sqlite_where=sa.text("palette = 1"), postgresql_where=sa.text("palette"))
    op.create_index(op.f("ix_sound_lists_cues_recorder_id"), "sound_lists_cues", ["recorder_id"])
    op.create_index(op.f("ix_sound_lists_cues_studio_id"), "sound_lists_cues", ["studio_id"])
    op.create_index("uq_sound_lists_cues_summed", "sound_lists_cues", ["id", "state", "variations", "placeholder"], unique=True)
    op.create_table(
        "sound_lists_revisions",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("summary", sa.String(), nullable=False),
        sa.Column("changed_by", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["changed_by"], ["accounts_people.id"], name=op.f("fk_sound_lists_revisions_changed_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_sound_lists_revisions_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_sound_lists_revisions_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_sound_lists_revisions")),
        sa.UniqueConstraint("project_id", "number", name=op.f("uq_sound_lists_revisions_project_id_number")),
    )
    op.create_index(op.f("ix_sound_lists_revisions_project_id"), "sound_lists_revisions", ["project_id"])
    op.create_index(op.f("ix_sound_lists_revisions_studio_id"), "sound_lists_revisions", ["studio_id"])
    op.create_table(
        "voice_lines_characters",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("folded", sa.String(), nullable=False),
        sa.Column("notes", sa.String(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_voice_lines_characters_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_voice_lines_characters_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_voice_lines_characters")),
        sa.UniqueConstraint("project_id", "folded", name=op.f("uq_voice_lines_characters_project_id_folded")),
    )
    op.create_index(op.f("ix_voice_lines_characters_studio_id"), "voice_lines_characters", ["studio_id"])
    op.create_table(
        "voice_lines_performers",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("folded", sa.String(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_voice_lines_performers_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_voice_lines_performers_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_voice_lines_performers")),
        sa.UniqueConstraint("project_id", "folded", name=op.f("uq_voice_lines_performers_project_id_folded")),
    )
    op.create_index(op.f("ix_voice_lines_performers_studio_id"), "voice_lines_performers", ["studio_id"])
    op.create_table(
        "voice_lines_settings",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("original_language", sa.String(), nullable=False),
        sa.Column("tolerance_percent", sa.Integer(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("tolerance_percent between 1 and 100", name=op.f("ck_voice_lines_settings_tolerance_in_range")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_voice_lines_settings_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_voice_lines_settings_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_voice_lines_settings")),
        sa.UniqueConstraint("project_id", name=op.f("uq_voice_lines_settings_project_id")),
    )
    op.create_index(op.f("ix_voice_lines_settings_studio_id"), "voice_lines_settings", ["studio_id"])
    op.create_table(
        "webhooks_webhooks",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid()),
        sa.Column("url", sa.String(), nullable=False),
        sa.Column("form", sa.Enum("json", "slack", "discord", "teams", name="webhookform", native_enum=False, length=32), nullable=False),
        sa.Column("events", JSON, nullable=False),
        sa.Column("secret_number", sa.Integer(), nullable=False),
        sa.Column("rotated_at", sa.DateTime(timezone=True)),
        sa.Column("failing_since", sa.DateTime(timezone=True)),
        sa.Column("disabled_at", sa.DateTime(timezone=True)),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name=op.f("fk_webhooks_webhooks_created_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_webhooks_webhooks_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_webhooks_webhooks_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_webhooks_webhooks")),
    )
    op.create_index(op.f("ix_webhooks_webhooks_project_id"), "webhooks_webhooks", ["project_id"])
    op.create_index(op.f("ix_webhooks_webhooks_studio_id"), "webhooks_webhooks", ["studio_id"])
    op.create_table(
        "briefs_reads",
        sa.Column("version_id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column("read_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name=op.f("fk_briefs_reads_designer_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_briefs_reads_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_briefs_reads_studio_id")),
        sa.ForeignKeyConstraint(["version_id"], ["briefs_versions.id"], name=op.f("fk_briefs_reads_version_id")),
        sa.PrimaryKeyConstraint("version_id", "designer_id", name=op.f("pk_briefs_reads")),
    )
    op.create_index(op.f("ix_briefs_reads_designer_id"), "briefs_reads", ["designer_id"])
    op.create_index(op.f("ix_briefs_reads_project_id"), "briefs_reads", ["project_id"])
    op.create_index(op.f("ix_briefs_reads_studio_id"), "briefs_reads", ["studio_id"])
    op.create_table(
        "builds_listening_passes",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("audit_id", sa.Uuid(), nullable=False),
        sa.Column("started_by", sa.Uuid(), nullable=False),
        sa.Column("started_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("closed_by", sa.Uuid()),
        sa.Column("closed_at", sa.DateTime(timezone=True)),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("(closed_at is null) = (closed_by is null)", name=op.f("ck_builds_listening_passes_closed_by_a_person")),
        sa.ForeignKeyConstraint(["audit_id"], ["builds_audits.id"], name=op.f("fk_builds_listening_passes_audit_id")),
        sa.ForeignKeyConstraint(["closed_by"], ["accounts_people.id"], name=op.f("fk_builds_listening_passes_closed_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_builds_listening_passes_project_id")),
        sa.ForeignKeyConstraint(["started_by"], ["accounts_people.id"], name=op.f("fk_builds_listening_passes_started_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_listening_passes_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_builds_listening_passes")),
    )
    op.create_index(op.f("ix_builds_listening_passes_project_id"), "builds_listening_passes", ["project_id"])
    op.create_index(op.f("ix_builds_listening_passes_studio_id"), "builds_listening_passes", ["studio_id"])
    op.create_index("uq_builds_listening_passes_open", "builds_listening_passes", ["project_id"], unique=True, sqlite_where=sa.text("closed_at is null"), postgresql_where=sa.text("closed_at is null"))
    op.create_table(
        "builds_marked_cues",
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("mark", sa.Enum("in-build", "heard", name="cuemark", native_enum=False, length=32), nullable=False),
        sa.Column("marked_by", sa.Uuid(), nullable=False),
        sa.Column("marked_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_builds_marked_cues_cue_id")),
        sa.ForeignKeyConstraint(["marked_by"], ["accounts_people.id"], name=op.f("fk_builds_marked_cues_marked_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_builds_marked_cues_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_marked_cues_studio_id")),
        sa.PrimaryKeyConstraint("cue_id", "mark", name=op.f("pk_builds_marked_cues")),
    )
    op.create_index(op.f("ix_builds_marked_cues_project_id"), "builds_marked_cues", ["project_id"])
    op.create_index(op.f("ix_builds_marked_cues_studio_id"), "builds_marked_cues", ["studio_id"])
    op.create_table(
        "builds_placeholder_files",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("variation", sa.Integer(), nullable=False),
        sa.Column("target", sa.String(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("sha256", sa.String()),
        sa.Column("file_bytes", sa.BigInteger()),
        sa.Column("is_spoken", sa.Boolean(), nullable=False),
        sa.Column("refusal", sa.String()),
        sa.Column("made_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("(refusal is null) = (sha256 is not null)", name=op.f("ck_builds_placeholder_files_made_or_refused")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_builds_placeholder_files_cue_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_builds_placeholder_files_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_placeholder_files_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_builds_placeholder_files")),
        sa.UniqueConstraint("cue_id", "variation", "target", name=op.f("uq_builds_placeholder_files_cue_id_variation_target")),
    )
    op.create_index(op.f("ix_builds_placeholder_files_project_id"), "builds_placeholder_files", ["project_id"])
    op.create_index(op.f("ix_builds_placeholder_files_studio_id"), "builds_placeholder_files", ["studio_id"])
    op.create_table(
        "contracts_approval_reminders",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("waiting_since", sa.DateTime(timezone=True), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_contracts_approval_reminders_cue_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_approval_reminders_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_approval_reminders_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_approval_reminders")),
        sa.UniqueConstraint("cue_id", "waiting_since", "number", name=op.f("uq_contracts_approval_reminders_cue_id_waiting_since_number")),
    )
    op.create_index(op.f("ix_contracts_approval_reminders_project_id"), "contracts_approval_reminders", ["project_id"])
    op.create_index(op.f("ix_contracts_approval_reminders_studio_id"), "contracts_approval_reminders", ["studio_id"])
    op.create_table(
        "contracts_contracts",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("engagement_id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column("framework_id", sa.Uuid()),
        sa.Column("joint_id", sa.Uuid()),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("title", sa.String(), nullable=False),
        sa.Column("kind", sa.Enum("nda", "framework", "statement_of_work", "single", name="contractkind", native_enum=False, length=32), nullable=False),
        sa.Column("state", sa.Enum("draft", "sent", "agreed", "ended", name="contractstate", native_enum=False, length=32), nullable=False),
        sa.Column("currency", sa.String(), nullable=False),
        sa.Column("release_clause", sa.Enum("per_cue", "on_completion", name="releaseclause", native_enum=False, length=32), nullable=False),
        sa.Column("deposit_bp", sa.Integer(), nullable=False),
        sa.Column("holdback_bp", sa.Integer(), nullable=False),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("signs_first", sa.Enum("studio", "designer", name="party", native_enum=False, length=32)),
        sa.Column("agreed_at", sa.DateTime(timezone=True)),
        sa.Column("ended_at", sa.DateTime(timezone=True)),
        sa.Column("end_reason", sa.String()),
        sa.Column("record_length", sa.Integer(), nullable=False),
        sa.Column("record_sha256", sa.String(), nullable=False),
        sa.Column("head_mailed_length", sa.Integer(), nullable=False),
        sa.Column("head_mailed_on", sa.Date()),
        sa.Column("changed_terms", JSON, nullable=False),
        sa.Column("game_shipped_on", sa.Date()),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(kind = 'statement_of_work') = (framework_id is not null)", name=op.f("ck_contracts_contracts_batch_has_framework")),
        sa.CheckConstraint("(state <> 'agreed') or (agreed_at is not null)", name=op.f("ck_contracts_contracts_agreed_is_dated")),
        sa.CheckConstraint("(state = 'ended') = (ended_at is not null)", name=op.f("ck_contracts_contracts_ended_is_dated")),
        sa.CheckConstraint("deposit_bp between 0 and 10000", name=op.f("ck_contracts_contracts_deposit_is_a_part")),
        sa.CheckConstraint("holdback_bp between 0 and 10000", name=op.f("ck_contracts_contracts_holdback_is_a_part")),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name=op.f("fk_contracts_contracts_created_by")),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name=op.f("fk_contracts_contracts_designer_id")),
        sa.ForeignKeyConstraint(["engagement_id"], ["projects_engagements.id"], name=op.f("fk_contracts_contracts_engagement_id")),
        sa.ForeignKeyConstraint(["framework_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_contracts_framework_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_contracts_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_contracts_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_contracts")),
        sa.UniqueConstraint("project_id", "number", name=op.f("uq_contracts_contracts_project_id_number")),
    )
    op.create_index(op.f("ix_contracts_contracts_designer_id"), "contracts_contracts", ["designer_id"])
    op.create_index(op.f("ix_contracts_contracts_engagement_id"), "contracts_contracts", ["engagement_id"])
    op.create_index(op.f("ix_contracts_contracts_framework_id"), "contracts_contracts", ["framework_id"])
    op.create_index(op.f("ix_contracts_contracts_joint_id"), "contracts_contracts", ["joint_id"])
    op.create_index(op.f("ix_contracts_contracts_studio_id"), "contracts_contracts", ["studio_id"])
    op.create_table(
        "contracts_own_times",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid()),
        sa.Column("minutes", sa.Integer(), nullable=False),
        sa.Column("worked_on", sa.Date(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("minutes between 1 and 1440", name=op.f("ck_contracts_own_times_hours_of_a_day_at_most")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_contracts_own_times_cue_id")),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_contracts_own_times_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_own_times_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_own_times_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_own_times")),
    )
    op.create_index(op.f("ix_contracts_own_times_person_id"), "contracts_own_times", ["person_id"])
    op.create_index(op.f("ix_contracts_own_times_project_id"), "contracts_own_times", ["project_id"])
    op.create_index(op.f("ix_contracts_own_times_studio_id"), "contracts_own_times", ["studio_id"])
    op.create_table(
        "deliveries_adoptions",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("folder", sa.String(), nullable=False),
        sa.Column("files", JSON, nullable=False),
        sa.Column("game", JSON),
        sa.Column("opened_by", sa.Uuid()),
        sa.Column("delivery_id", sa.Uuid()),
        sa.Column("adopted_by", sa.Uuid()),
        sa.Column("adopted_at", sa.DateTime(timezone=True)),
        sa.Column("undone_by", sa.Uuid()),
        sa.Column("undone_at", sa.DateTime(timezone=True)),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(adopted_at is null) = (adopted_by is null)", name=op.f("ck_deliveries_adoptions_adopted_by_a_person")),
        sa.CheckConstraint("(undone_at is null) = (undone_by is null)", name=op.f("ck_deliveries_adoptions_undone_by_a_person")),
        sa.CheckConstraint("undone_at is null or adopted_at is not null", name=op.f("ck_deliveries_adoptions_undone_after_adopted")),
        sa.ForeignKeyConstraint(["adopted_by"], ["accounts_people.id"], name=op.f("fk_deliveries_adoptions_adopted_by")),
        sa.ForeignKeyConstraint(["delivery_id"], ["deliveries_deliveries.id"], name=op.f("fk_deliveries_adoptions_delivery_id")),
        sa.ForeignKeyConstraint(["opened_by"], ["accounts_people.id"], name=op.f("fk_deliveries_adoptions_opened_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_deliveries_adoptions_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_deliveries_adoptions_studio_id")),
        sa.ForeignKeyConstraint(["undone_by"], ["accounts_people.id"], name=op.f("fk_deliveries_adoptions_undone_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_deliveries_adoptions")),
    )
    op.create_index("ix_deliveries_adoptions_project_id_id", "deliveries_adoptions", ["project_id", "id"])
    op.create_index(op.f("ix_deliveries_adoptions_studio_id"), "deliveries_adoptions", ["studio_id"])
    op.create_table(
        "deliveries_archives",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("delivery_id", sa.Uuid(), nullable=False),
        sa.Column("upload_id", sa.Uuid(), nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("archive_bytes", sa.BigInteger(), nullable=False),
        sa.Column("state", sa.Enum("received", "unpacked", "refused", name="archivestate", native_enum=False, length=32), nullable=False),
        sa.Column("message", sa.String(), nullable=False),
        sa.Column("entries", JSON, nullable=False),
        sa.Column("received_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["delivery_id"], ["deliveries_deliveries.id"], name=op.f("fk_deliveries_archives_delivery_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_deliveries_archives_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_deliveries_archives_studio_id")),
        sa.ForeignKeyConstraint(["upload_id"], ["core_uploads.id"], name=op.f("fk_deliveries_archives_upload_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_deliveries_archives")),
        sa.UniqueConstraint("upload_id", name=op.f("uq_deliveries_archives_upload_id")),
    )
    op.create_index(op.f("ix_deliveries_archives_delivery_id"), "deliveries_archives", ["delivery_id"])
    op.create_index(op.f("ix_deliveries_archives_project_id"), "deliveries_archives", ["project_id"])
    op.create_index(op.f("ix_deliveries_archives_studio_id"), "deliveries_archives", ["studio_id"])
    op.create_table(
        "deliveries_handoffs",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("from_id", sa.Uuid(), nullable=False),
        sa.Column("to_id", sa.Uuid()),
        sa.Column("done_percent", sa.Integer(), nullable=False),
        sa.Column("missing", sa.String(), nullable=False),
        sa.Column("written_by", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("done_percent between 0 and 100", name=op.f("ck_deliveries_handoffs_percent_in_range")),
        sa.CheckConstraint("to_id is null or to_id != from_id", name=op.f("ck_deliveries_handoffs_to_another")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_deliveries_handoffs_cue_id")),
        sa.ForeignKeyConstraint(["from_id"], ["accounts_people.id"], name=op.f("fk_deliveries_handoffs_from_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_deliveries_handoffs_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_deliveries_handoffs_studio_id")),
        sa.ForeignKeyConstraint(["to_id"], ["accounts_people.id"], name=op.f("fk_deliveries_handoffs_to_id")),
        sa.ForeignKeyConstraint(["written_by"], ["accounts_people.id"], name=op.f("fk_deliveries_handoffs_written_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_deliveries_handoffs")),
    )
    op.create_index(op.f("ix_deliveries_handoffs_cue_id"), "deliveries_handoffs", ["cue_id"])
    op.create_index(op.f("ix_deliveries_handoffs_project_id"), "deliveries_handoffs", ["project_id"])
    op.create_index(op.f("ix_deliveries_handoffs_studio_id"), "deliveries_handoffs", ["studio_id"])
    op.create_table(
        "hiring_bids",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("posting_id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column("state", sa.Enum("draft", "sent", "withdrawn", name="bidstate", native_enum=False, length=32), nullable=False),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("content", JSON, nullable=False),
        sa.Column("sent", JSON),
        sa.Column("sent_at", sa.DateTime(timezone=True)),
        sa.Column("resent_at", sa.DateTime(timezone=True)),
        sa.Column("changed_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("is_shortlisted", sa.Boolean(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name=op.f("fk_hiring_bids_designer_id")),
        sa.ForeignKeyConstraint(["posting_id"], ["hiring_postings.id"], name=op.f("fk_hiring_bids_posting_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_hiring_bids_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_hiring_bids_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_hiring_bids")),
        sa.UniqueConstraint("posting_id", "designer_id", name=op.f("uq_hiring_bids_posting_id_designer_id")),
    )
    op.create_index(op.f("ix_hiring_bids_designer_id"), "hiring_bids", ["designer_id"])
    op.create_index(op.f("ix_hiring_bids_project_id"), "hiring_bids", ["project_id"])
    op.create_index(op.f("ix_hiring_bids_studio_id"), "hiring_bids", ["studio_id"])
    op.create_table(
        "hiring_candidates",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("posting_id", sa.Uuid(), nullable=False),
        sa.Column("email", sa.String(), nullable=False),
        sa.Column("person_id", sa.Uuid()),
        sa.Column("invited_by", sa.Uuid()),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("joined_at", sa.DateTime(timezone=True)),
        sa.Column("revoked_at", sa.DateTime(timezone=True)),
        sa.Column("secret_sha256", sa.String()),
        sa.Column("is_sent_by_mail_only", sa.Boolean(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["invited_by"], ["accounts_people.id"], name=op.f("fk_hiring_candidates_invited_by")),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_hiring_candidates_person_id")),
        sa.ForeignKeyConstraint(["posting_id"], ["hiring_postings.id"], name=op.f("fk_hiring_candidates_posting_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_hiring_candidates_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_hiring_candidates_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_hiring_candidates")),
        sa.UniqueConstraint("posting_id", "email", name=op.f("uq_hiring_candidates_posting_id_email")),
        sa.UniqueConstraint("posting_id", "person_id", name=op.f("uq_hiring_candidates_posting_id_person_id")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_hiring_candidates_secret_sha256")),
    )
    op.create_index(op.f("ix_hiring_candidates_person_id"), "hiring_candidates", ["person_id"])
    op.create_index(op.f("ix_hiring_candidates_project_id"), "hiring_candidates", ["project_id"])
    op.create_index(op.f("ix_hiring_candidates_studio_id"), "hiring_candidates", ["studio_id"])
    op.create_table(
        "hiring_questions",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("posting_id", sa.Uuid(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("asked_by", sa.Uuid(), nullable=False),
        sa.Column("asked_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("answer", sa.String()),
        sa.Column("is_for_all", sa.Boolean(), nullable=False),
        sa.Column("answered_by", sa.Uuid()),
        sa.Column("answered_at", sa.DateTime(timezone=True)),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["answered_by"], ["accounts_people.id"], name=op.f("fk_hiring_questions_answered_by")),
        sa.ForeignKeyConstraint(["asked_by"], ["accounts_people.id"], name=op.f("fk_hiring_questions_asked_by")),
        sa.ForeignKeyConstraint(["posting_id"], ["hiring_postings.id"], name=op.f("fk_hiring_questions_posting_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_hiring_questions_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_hiring_questions_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_hiring_questions")),
    )
    op.create_index(op.f("ix_hiring_questions_posting_id"), "hiring_questions", ["posting_id"])
    op.create_index(op.f("ix_hiring_questions_project_id"), "hiring_questions", ["project_id"])
    op.create_index(op.f("ix_hiring_questions_studio_id"), "hiring_questions", ["studio_id"])
    op.create_table(
        "references_references",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid()),
        sa.Column("category", sa.String()),
        sa.Column("caption", sa.String(), nullable=False),
        sa.Column("terms", sa.String(), nullable=False),
        sa.Column("words", sa.String(), nullable=False),
        sa.Column("start_s", sa.Double()),
        sa.Column("end_s", sa.Double()),
        sa.Column("newest_number", sa.Integer(), nullable=False),
        sa.Column("spotted_from_id", sa.Uuid()),
        sa.Column("added_by", sa.Uuid(), nullable=False),
        sa.Column("added_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("removed_by", sa.Uuid()),
        sa.Column("removed_at", sa.DateTime(timezone=True)),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("(removed_at is null) = (removed_by is null)", name=op.f("ck_references_references_removed_by_a_person")),
        sa.CheckConstraint("cue_id is null or category is null", name=op.f("ck_references_references_pinned_once")),
        sa.CheckConstraint("end_s is null or end_s > start_s", name=op.f("ck_references_references_range_ends_later")),
        sa.ForeignKeyConstraint(["added_by"], ["accounts_people.id"], name=op.f("fk_references_references_added_by")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_references_references_cue_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_references_references_project_id")),
        sa.ForeignKeyConstraint(["removed_by"], ["accounts_people.id"], name=op.f("fk_references_references_removed_by")),
        sa.ForeignKeyConstraint(["spotted_from_id"], ["references_references.id"], name=op.f("fk_references_references_spotted_from_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_references_references_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_references_references")),
    )
    op.create_index("ix_references_references_board", "references_references", ["project_id", "id"])
    op.create_index(op.f("ix_references_references_cue_id"), "references_references", ["cue_id"])
    op.create_index(op.f("ix_references_references_spotted_from_id"), "references_references", ["spotted_from_id"])
    op.create_index(op.f("ix_references_references_studio_id"), "references_references", ["studio_id"])
    op.create_table(
        "renders_batches",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("state", sa.Enum("planning", "running", "done", "cancelled", name="batchstate", native_enum=False, length=32), nullable=False),
        sa.Column("spec_id", sa.Uuid()),
        sa.Column("targets", JSON, nullable=False),
        sa.Column("asked_by", sa.Uuid()),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("ended_at", sa.DateTime(timezone=True)),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(ended_at is null) = (state in ('planning', 'running'))", name=op.f("ck_renders_batches_ended_is_dated")),
        sa.ForeignKeyConstraint(["asked_by"], ["accounts_people.id"], name=op.f("fk_renders_batches_asked_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_renders_batches_project_id")),
        sa.ForeignKeyConstraint(["spec_id"], ["projects_specs.id"], name=op.f("fk_renders_batches_spec_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_renders_batches_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_renders_batches")),
        sa.UniqueConstraint("project_id", "number", name=op.f("uq_renders_batches_project_id_number")),
    )
    op.create_index(op.f("ix_renders_batches_studio_id"), "renders_batches", ["studio_id"])
    op.create_table(
        "renders_reels",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("gap_ms", sa.Integer(), nullable=False),
        sa.Column("crossfade_ms", sa.Integer(), nullable=False),
        sa.Column("with_slates", sa.Boolean(), nullable=False),
        sa.Column("takes", JSON, nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("is_spoken", sa.Boolean(), nullable=False),
        sa.Column("duration_s", sa.Double()),
        sa.Column("sha256", sa.String()),
        sa.Column("file_bytes", sa.BigInteger()),
        sa.Column("refusal", sa.String()),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("sha256 is null or refusal is null", name=op.f("ck_renders_reels_made_or_refused")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_renders_reels_cue_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_renders_reels_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_renders_reels_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_renders_reels")),
        sa.UniqueConstraint("cue_id", "key", name=op.f("uq_renders_reels_cue_id_key")),
    )
    op.create_index(op.f("ix_renders_reels_project_id"), "renders_reels", ["project_id"])
    op.create_index(op.f("ix_renders_reels_studio_id"), "renders_reels", ["studio_id"])
    op.create_table(
        "reviews_game_levels",
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("variation", sa.Integer(), nullable=False),
        sa.Column("plays", JSON, nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_reviews_game_levels_cue_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_reviews_game_levels_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_reviews_game_levels_studio_id")),
        sa.PrimaryKeyConstraint("cue_id", "variation", name=op.f("pk_reviews_game_levels")),
    )
    op.create_index(op.f("ix_reviews_game_levels_project_id"), "reviews_game_levels", ["project_id"])
    op.create_index(op.f("ix_reviews_game_levels_studio_id"), "reviews_game_levels", ["studio_id"])
    op.create_table(
        "reviews_rounds",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("feedback_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer()),
        sa.Column("why_not_counted", sa.String()),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(number is null) = (why_not_counted is not null)", name=op.f("ck_reviews_rounds_counted_or_why_not")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_reviews_rounds_cue_id")),
        sa.ForeignKeyConstraint(["feedback_id"], ["reviews_feedback.id"], name=op.f("fk_reviews_rounds_feedback_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_reviews_rounds_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_reviews_rounds_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_reviews_rounds")),
        sa.UniqueConstraint("cue_id", "feedback_id", name=op.f("uq_reviews_rounds_cue_id_feedback_id")),
        sa.UniqueConstraint("cue_id", "number", name=op.f("uq_reviews_rounds_cue_id_number")),
    )
    op.create_index(op.f("ix_reviews_rounds_project_id"), "reviews_rounds", ["project_id"])
    op.create_index(op.f("ix_reviews_rounds_studio_id"), "reviews_rounds", ["studio_id"])
    op.create_table(
        "shares_guest_visits",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("link_id", sa.Uuid(), nullable=False),
        sa.Column("secret_sha256", sa.String(), nullable=False),
        sa.Column("guest_name", sa.String(), nullable=False),
        sa.Column("opened_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["link_id"], ["shares_guest_links.id"], name=op.f("fk_shares_guest_visits_link_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_shares_guest_visits_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_shares_guest_visits_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_shares_guest_visits")),
        sa.UniqueConstraint("secret_sha256", name=op.f("uq_shares_guest_visits_secret_sha256")),
    )
    op.create_index("ix_shares_guest_visits_link", "shares_guest_visits", ["link_id", "id"])
    op.create_index(op.f("ix_shares_guest_visits_project_id"), "shares_guest_visits", ["project_id"])
    op.create_index(op.f("ix_shares_guest_visits_studio_id"), "shares_guest_visits", ["studio_id"])
    op.create_table(
        "shares_live_listeners",
        sa.Column("playlist_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("seen_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("page_id", sa.Uuid()),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_shares_live_listeners_person_id")),
        sa.ForeignKeyConstraint(["playlist_id"], ["shares_playlists.id"], name=op.f("fk_shares_live_listeners_playlist_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_shares_live_listeners_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_shares_live_listeners_studio_id")),
        sa.PrimaryKeyConstraint("playlist_id", "person_id", name=op.f("pk_shares_live_listeners")),
    )
    op.create_index(op.f("ix_shares_live_listeners_project_id"), "shares_live_listeners", ["project_id"])
    op.create_index(op.f("ix_shares_live_listeners_studio_id"), "shares_live_listeners", ["studio_id"])
    op.create_table(
        "sound_lists_cue_changes",
        sa.Column("revision_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("before", JSON, nullable=False),
        sa.Column("after", JSON, nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_sound_lists_cue_changes_cue_id")),
        sa.ForeignKeyConstraint(["revision_id"], ["sound_lists_revisions.id"], name=op.f("fk_sound_lists_cue_changes_revision_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_sound_lists_cue_changes_studio_id")),
        sa.PrimaryKeyConstraint("revision_id", "cue_id", name=op.f("pk_sound_lists_cue_changes")),
    )
    op.create_index(op.f("ix_sound_lists_cue_changes_cue_id"), "sound_lists_cue_changes", ["cue_id"])
    op.create_index(op.f("ix_sound_lists_cue_changes_studio_id"), "sound_lists_cue_changes", ["studio_id"])
    op.create_table(
        "sound_lists_questions",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("asked_by", sa.Uuid(), nullable=False),
        sa.Column("asked_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("answer", sa.String()),
        sa.Column("answered_by", sa.Uuid()),
        sa.Column("answered_at", sa.DateTime(timezone=True)),
        sa.Column("owner_id", sa.Uuid()),
        sa.Column("due_on", sa.Date()),
        sa.Column("blocks", sa.Boolean(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["answered_by"], ["accounts_people.id"], name=op.f("fk_sound_lists_questions_answered_by")),
        sa.ForeignKeyConstraint(["asked_by"], ["accounts_people.id"], name=op.f("fk_sound_lists_questions_asked_by")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_sound_lists_questions_cue_id")),
        sa.ForeignKeyConstraint(["owner_id"], ["accounts_people.id"], name=op.f("fk_sound_lists_questions_owner_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_sound_lists_questions_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_sound_lists_questions_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_sound_lists_questions")),
    )
    op.create_index(op.f("ix_sound_lists_questions_cue_id"), "sound_lists_questions", ["cue_id"])
    op.create_index("ix_sound_lists_questions_open", "sound_lists_questions", ["project_id", "cue_id"], sqlite_where=sa.text("answered_at is null"), postgresql_where=sa.text("answered_at is null"))
    op.create_index(op.f("ix_sound_lists_questions_project_id"), "sound_lists_questions", ["project_id"])
    op.create_index(op.f("ix_sound_lists_questions_studio_id"), "sound_lists_questions", ["studio_id"])
    op.create_table(
        "sound_lists_spoken_placeholders",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("file_bytes", sa.BigInteger(), nullable=False),
        sa.Column("duration_s", sa.Double(), nullable=False),
        sa.Column("recorded_by", sa.Uuid(), nullable=False),
        sa.Column("recorded_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("file_bytes > 0", name=op.f("ck_sound_lists_spoken_placeholders_not_empty")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_sound_lists_spoken_placeholders_cue_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_sound_lists_spoken_placeholders_project_id")),
        sa.ForeignKeyConstraint(["recorded_by"], ["accounts_people.id"], name=op.f("fk_sound_lists_spoken_placeholders_recorded_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_sound_lists_spoken_placeholders_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_sound_lists_spoken_placeholders")),
        sa.UniqueConstraint("cue_id", name=op.f("uq_sound_lists_spoken_placeholders_cue_id")),
    )
    op.create_index("ix_sound_lists_spoken_placeholders_kept", "sound_lists_spoken_placeholders", ["studio_id", "sha256", "file_bytes"])
    op.create_index(op.f("ix_sound_lists_spoken_placeholders_project_id"), "sound_lists_spoken_placeholders", ["project_id"])
    op.create_table(
        "sound_lists_stems",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("variation", sa.Integer(), nullable=False),
        sa.Column("stem", sa.String(), nullable=False),
        sa.Column("folded", sa.String(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_sound_lists_stems_cue_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_sound_lists_stems_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_sound_lists_stems_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_sound_lists_stems")),
        sa.UniqueConstraint("cue_id", "variation", name=op.f("uq_sound_lists_stems_cue_id_variation")),
        sa.UniqueConstraint("project_id", "folded", name=op.f("uq_sound_lists_stems_project_id_folded")),
    )
    op.create_index(op.f("ix_sound_lists_stems_studio_id"), "sound_lists_stems", ["studio_id"])
    op.create_table(
        "voice_lines_castings",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("character_id", sa.Uuid(), nullable=False),
        sa.Column("language", sa.String(), nullable=False),
        sa.Column("performer_id", sa.Uuid()),
        sa.Column("directed_by", sa.String(), nullable=False),
        sa.Column("cast_by", sa.String(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["character_id"], ["voice_lines_characters.id"], name=op.f("fk_voice_lines_castings_character_id")),
        sa.ForeignKeyConstraint(["performer_id"], ["voice_lines_performers.id"], name=op.f("fk_voice_lines_castings_performer_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_voice_lines_castings_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_voice_lines_castings_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_voice_lines_castings")),
        sa.UniqueConstraint("character_id", "language", name=op.f("uq_voice_lines_castings_character_id_language")),
    )
    op.create_index(op.f("ix_voice_lines_castings_performer_id"), "voice_lines_castings", ["performer_id"])
    op.create_index(op.f("ix_voice_lines_castings_project_id"), "voice_lines_castings", ["project_id"])
    op.create_index(op.f("ix_voice_lines_castings_studio_id"), "voice_lines_castings", ["studio_id"])
    op.create_table(
        "voice_lines_lines",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("character_id", sa.Uuid(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("folded", sa.String(), nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("scene", sa.String(), nullable=False),
        sa.Column("direction", sa.String(), nullable=False),
        sa.Column("position", sa.Integer(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["character_id"], ["voice_lines_characters.id"], name=op.f("fk_voice_lines_lines_character_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_voice_lines_lines_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_voice_lines_lines_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_voice_lines_lines")),
        sa.UniqueConstraint("project_id", "folded", name=op.f("uq_voice_lines_lines_project_id_folded")),
    )
    op.create_index(op.f("ix_voice_lines_lines_character_id"), "voice_lines_lines", ["character_id"])
    op.create_index("ix_voice_lines_lines_order", "voice_lines_lines", ["project_id", "position"])
    op.create_index(op.f("ix_voice_lines_lines_studio_id"), "voice_lines_lines", ["studio_id"])
    op.create_table(
        "voice_lines_releases",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("performer_id", sa.Uuid(), nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("file_bytes", sa.BigInteger(), nullable=False),
        sa.Column("valid_from", sa.Date(), nullable=False),
        sa.Column("valid_until", sa.Date()),
        sa.Column("synthetic_use", sa.Enum("yes", "no", "not_asked", name="syntheticuse", native_enum=False, length=32), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("added_by", sa.Uuid(), nullable=False),
        sa.Column("added_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("removed_by", sa.Uuid()),
        sa.Column("removed_at", sa.DateTime(timezone=True)),
        sa.CheckConstraint("(removed_at is null) = (removed_by is null)", name=op.f("ck_voice_lines_releases_removed_by_a_person")),
        sa.CheckConstraint("valid_until is null or valid_until >= valid_from", name=op.f("ck_voice_lines_releases_ends_after_it_begins")),
        sa.ForeignKeyConstraint(["added_by"], ["accounts_people.id"], name=op.f("fk_voice_lines_releases_added_by")),
        sa.ForeignKeyConstraint(["performer_id"], ["voice_lines_performers.id"], name=op.f("fk_voice_lines_releases_performer_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_voice_lines_releases_project_id")),
        sa.ForeignKeyConstraint(["removed_by"], ["accounts_people.id"], name=op.f("fk_voice_lines_releases_removed_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_voice_lines_releases_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_voice_lines_releases")),
    )
    op.create_index("ix_voice_lines_releases_kept", "voice_lines_releases", ["studio_id", "sha256", "file_bytes"])
    op.create_index(op.f("ix_voice_lines_releases_performer_id"), "voice_lines_releases", ["performer_id"])
    op.create_index(op.f("ix_voice_lines_releases_project_id"), "voice_lines_releases", ["project_id"])
    op.create_table(
        "webhooks_calls",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("webhook_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid()),
        sa.Column("event_id", sa.String(), nullable=False),
        sa.Column("event", sa.String(), nullable=False),
        sa.Column("body", sa.String(), nullable=False),
        sa.Column("state", sa.Enum("waiting", "delivered", "failed", name="callstate", native_enum=False, length=32), nullable=False),
        sa.Column("tries", sa.Integer(), nullable=False),
        sa.Column("next_attempt", sa.Uuid()),
        sa.Column("next_at", sa.DateTime(timezone=True)),
        sa.Column("tried_at", sa.DateTime(timezone=True)),
        sa.Column("took_ms", sa.Integer()),
        sa.Column("status", sa.Integer()),
        sa.Column("answer", sa.String(), nullable=False),
        sa.Column("problem", sa.String(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_webhooks_calls_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_webhooks_calls_studio_id")),
        sa.ForeignKeyConstraint(["webhook_id"], ["webhooks_webhooks.id"], name=op.f("fk_webhooks_calls_webhook_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_webhooks_calls")),
        sa.UniqueConstraint("webhook_id", "event_id", name=op.f("uq_webhooks_calls_webhook_id_event_id")),
    )
    op.create_index(op.f("ix_webhooks_calls_created_at"), "webhooks_calls", ["created_at"])
    op.create_index("ix_webhooks_calls_log", "webhooks_calls", ["webhook_id", "id"])
    op.create_index(op.f("ix_webhooks_calls_project_id"), "webhooks_calls", ["project_id"])
    op.create_index(op.f("ix_webhooks_calls_studio_id"), "webhooks_calls", ["studio_id"])
    op.create_table(
        "contracts_amendment_acceptances",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("text_sha256", sa.String(), nullable=False),
        sa.Column("party", sa.Enum("studio", "designer", name="party", native_enum=False, length=32), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("email", sa.String(), nullable=False),
        sa.Column("email_proof", sa.Enum("mail", "operator", "provider", name="addressproof", native_enum=False, length=32)),
        sa.Column("address", sa.String(), nullable=False),
        sa.Column("agent", sa.String(), nullable=False),
        sa.Column("code_entered_at", sa.DateTime(timezone=True)),
        sa.Column("drawing", JSON),
        sa.Column("accepted_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_amendment_acceptances_contract_id")),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_contracts_amendment_acceptances_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_amendment_acceptances_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_amendment_acceptances_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_amendment_acceptances")),
        sa.UniqueConstraint("contract_id", "text_sha256", "person_id", name="uq_contracts_amendment_acceptances_person"),
    )
    op.create_index(op.f("ix_contracts_amendment_acceptances_project_id"), "contracts_amendment_acceptances", ["project_id"])
    op.create_index(op.f("ix_contracts_amendment_acceptances_studio_id"), "contracts_amendment_acceptances", ["studio_id"])
    op.create_table(
        "contracts_change_orders",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("state", sa.Enum("proposed", "agreed", "refused", "withdrawn", "lapsed", name="changeorderstate", native_enum=False, length=32), nullable=False),
        sa.Column("party", sa.Enum("studio", "designer", name="party", native_enum=False, length=32), nullable=False),
        sa.Column("proposed_by", sa.Uuid(), nullable=False),
        sa.Column("proposed_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("reason", sa.String(), nullable=False),
        sa.Column("begins_at_once", sa.Boolean(), nullable=False),
        sa.Column("changes", JSON, nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("text_sha256", sa.String(), nullable=False),
        sa.Column("closed_at", sa.DateTime(timezone=True)),
        sa.Column("close_reason", sa.String(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("(state = 'proposed') = (closed_at is null)", name=op.f("ck_contracts_change_orders_closed_is_dated")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_change_orders_contract_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_change_orders_project_id")),
        sa.ForeignKeyConstraint(["proposed_by"], ["accounts_people.id"], name=op.f("fk_contracts_change_orders_proposed_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_change_orders_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_change_orders")),
        sa.UniqueConstraint("contract_id", "number", name=op.f("uq_contracts_change_orders_contract_id_number")),
    )
    op.create_index(op.f("ix_contracts_change_orders_project_id"), "contracts_change_orders", ["project_id"])
    op.create_index(op.f("ix_contracts_change_orders_studio_id"), "contracts_change_orders", ["studio_id"])
    op.create_table(
        "contracts_clock_pauses",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("change_order", sa.Integer(), nullable=False),
        sa.Column("began_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("ended_at", sa.DateTime(timezone=True)),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("ended_at is null or ended_at >= began_at", name=op.f("ck_contracts_clock_pauses_ends_after_it_began")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_clock_pauses_contract_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_clock_pauses_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_clock_pauses_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_clock_pauses")),
    )
    op.create_index(op.f("ix_contracts_clock_pauses_contract_id"), "contracts_clock_pauses", ["contract_id"])
    op.create_index(op.f("ix_contracts_clock_pauses_project_id"), "contracts_clock_pauses", ["project_id"])
    op.create_index(op.f("ix_contracts_clock_pauses_studio_id"), "contracts_clock_pauses", ["studio_id"])
    op.create_table(
        "contracts_date_reminders",
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("term", sa.String(), nullable=False),
        sa.Column("day", sa.Date(), nullable=False),
        sa.Column("sent_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_date_reminders_contract_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_date_reminders_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_date_reminders_studio_id")),
        sa.PrimaryKeyConstraint("contract_id", "term", "day", name=op.f("pk_contracts_date_reminders")),
    )
    op.create_index(op.f("ix_contracts_date_reminders_project_id"), "contracts_date_reminders", ["project_id"])
    op.create_index(op.f("ix_contracts_date_reminders_studio_id"), "contracts_date_reminders", ["studio_id"])
    op.create_table(
        "contracts_events",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("seq", sa.Integer(), nullable=False),
        sa.Column("at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("kind", sa.String(), nullable=False),
        sa.Column("payload", sa.String(), nullable=False),
        sa.Column("previous_sha256", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_events_contract_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_events_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_events_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_events")),
        sa.UniqueConstraint("contract_id", "seq", name=op.f("uq_contracts_events_contract_id_seq")),
    )
    op.create_index(op.f("ix_contracts_events_project_id"), "contracts_events", ["project_id"])
    op.create_index(op.f("ix_contracts_events_studio_id"), "contracts_events", ["studio_id"])
    op.create_table(
        "contracts_extra_rounds",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("proposed_by", sa.Uuid(), nullable=False),
        sa.Column("proposed_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("agreed_by", sa.Uuid()),
        sa.Column("agreed_at", sa.DateTime(timezone=True)),
        sa.Column("dropped_at", sa.DateTime(timezone=True)),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("agreed_at is null or dropped_at is null", name=op.f("ck_contracts_extra_rounds_agreed_or_dropped")),
        sa.ForeignKeyConstraint(["agreed_by"], ["accounts_people.id"], name=op.f("fk_contracts_extra_rounds_agreed_by")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_extra_rounds_contract_id")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_contracts_extra_rounds_cue_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_extra_rounds_project_id")),
        sa.ForeignKeyConstraint(["proposed_by"], ["accounts_people.id"], name=op.f("fk_contracts_extra_rounds_proposed_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_extra_rounds_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_extra_rounds")),
        sa.UniqueConstraint("contract_id", "cue_id", "number", name=op.f("uq_contracts_extra_rounds_contract_id_cue_id_number")),
    )
    op.create_index(op.f("ix_contracts_extra_rounds_cue_id"), "contracts_extra_rounds", ["cue_id"])
    op.create_index(op.f("ix_contracts_extra_rounds_project_id"), "contracts_extra_rounds", ["project_id"])
    op.create_index(op.f("ix_contracts_extra_rounds_studio_id"), "contracts_extra_rounds", ["studio_id"])
    op.create_table(
        "contracts_invoices",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("full_number", sa.String(), nullable=False),
        sa.Column("issued_on", sa.Date(), nullable=False),
        sa.Column("due_on", sa.Date(), nullable=False),
        sa.Column("po_number", sa.String(), nullable=False),
        sa.Column("seller", sa.String(), nullable=False),
        sa.Column("buyer", sa.String(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("reverse_charge", sa.Boolean(), nullable=False),
        sa.Column("issued_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("number > 0", name=op.f("ck_contracts_invoices_numbered_from_one")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_invoices_contract_id")),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name=op.f("fk_contracts_invoices_designer_id")),
        sa.ForeignKeyConstraint(["issued_by"], ["accounts_people.id"], name=op.f("fk_contracts_invoices_issued_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_invoices_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_invoices_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_invoices")),
        sa.UniqueConstraint("studio_id", "designer_id", "full_number", name=op.f("uq_contracts_invoices_studio_id_designer_id_full_number")),
        sa.UniqueConstraint("studio_id", "designer_id", "number", name=op.f("uq_contracts_invoices_studio_id_designer_id_number")),
    )
    op.create_index(op.f("ix_contracts_invoices_contract_id"), "contracts_invoices", ["contract_id"])
    op.create_index(op.f("ix_contracts_invoices_designer_id"), "contracts_invoices", ["designer_id"])
    op.create_index(op.f("ix_contracts_invoices_project_id"), "contracts_invoices", ["project_id"])
    op.create_table(
        "contracts_milestones",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("position", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("is_deposit", sa.Boolean(), nullable=False),
        sa.Column("amount_minor", sa.BigInteger(), nullable=False),
        sa.Column("due_on", sa.Date()),
        sa.Column("tax_bp", sa.Integer()),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("amount_minor >= 0", name=op.f("ck_contracts_milestones_amount_not_negative")),
        sa.CheckConstraint("tax_bp between 0 and 10000", name=op.f("ck_contracts_milestones_tax_is_a_part")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_milestones_contract_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_milestones_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_milestones_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_milestones")),
        sa.UniqueConstraint("contract_id", "position", name=op.f("uq_contracts_milestones_contract_id_position")),
    )
    op.create_index(op.f("ix_contracts_milestones_project_id"), "contracts_milestones", ["project_id"])
    op.create_index(op.f("ix_contracts_milestones_studio_id"), "contracts_milestones", ["studio_id"])
    op.create_table(
        "contracts_notices",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("party", sa.Enum("studio", "designer", name="party", native_enum=False, length=32), nullable=False),
        sa.Column("given_by", sa.Uuid(), nullable=False),
        sa.Column("given_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("reason", sa.String(), nullable=False),
        sa.Column("ends_on", sa.Date()),
        sa.Column("withdrawn_at", sa.DateTime(timezone=True)),
        sa.Column("settled_at", sa.DateTime(timezone=True)),
        sa.Column("statement", sa.String()),
        sa.Column("statement_sha256", sa.String()),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("(settled_at is null) = (statement is null)", name=op.f("ck_contracts_notices_settled_by_a_statement")),
        sa.CheckConstraint("(statement is null) = (statement_sha256 is null)", name=op.f("ck_contracts_notices_statement_has_hash")),
        sa.CheckConstraint("withdrawn_at is null or settled_at is null", name=op.f("ck_contracts_notices_withdrawn_or_settled")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_notices_contract_id")),
        sa.ForeignKeyConstraint(["given_by"], ["accounts_people.id"], name=op.f("fk_contracts_notices_given_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_notices_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_notices_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_notices")),
        sa.UniqueConstraint("contract_id", "number", name=op.f("uq_contracts_notices_contract_id_number")),
    )
    op.create_index(op.f("ix_contracts_notices_project_id"), "contracts_notices", ["project_id"])
    op.create_index(op.f("ix_contracts_notices_studio_id"), "contracts_notices", ["studio_id"])
    op.create_index("uq_contracts_notices_standing", "contracts_notices", ["contract_id"], unique=True, sqlite_where=sa.text("withdrawn_at is null"), postgresql_where=sa.text("withdrawn_at is null"))
    op.create_table(
        "contracts_signers",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("position", sa.Integer(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_signers_contract_id")),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_contracts_signers_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_signers_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_signers_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_signers")),
        sa.UniqueConstraint("contract_id", "person_id", name=op.f("uq_contracts_signers_contract_id_person_id")),
        sa.UniqueConstraint("contract_id", "position", name=op.f("uq_contracts_signers_contract_id_position")),
    )
    op.create_index(op.f("ix_contracts_signers_project_id"), "contracts_signers", ["project_id"])
    op.create_index(op.f("ix_contracts_signers_studio_id"), "contracts_signers", ["studio_id"])
    op.create_table(
        "contracts_signing_codes",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("text_sha256", sa.String(), nullable=False),
        sa.Column("code_hash", sa.String()),
        sa.Column("tries", sa.Integer(), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("used_at", sa.DateTime(timezone=True)),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_signing_codes_contract_id")),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_contracts_signing_codes_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_signing_codes_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_signing_codes_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_signing_codes")),
    )
    op.create_index(op.f("ix_contracts_signing_codes_contract_id"), "contracts_signing_codes", ["contract_id"])
    op.create_index(op.f("ix_contracts_signing_codes_project_id"), "contracts_signing_codes", ["project_id"])
    op.create_index(op.f("ix_contracts_signing_codes_studio_id"), "contracts_signing_codes", ["studio_id"])
    op.create_table(
        "contracts_versions",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("clauses", JSON, nullable=False),
        sa.Column("terms", JSON, nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("text_sha256", sa.String(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("sent_at", sa.DateTime(timezone=True)),
        sa.Column("pdf_sha256", sa.String()),
        sa.Column("pdf_bytes", sa.Integer()),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(sent_at is null) = (pdf_sha256 is null)", name=op.f("ck_contracts_versions_sent_as_pdf")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_versions_contract_id")),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name=op.f("fk_contracts_versions_created_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_versions_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_versions_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_versions")),
        sa.UniqueConstraint("contract_id", "number", name=op.f("uq_contracts_versions_contract_id_number")),
    )
    op.create_index(op.f("ix_contracts_versions_project_id"), "contracts_versions", ["project_id"])
    op.create_index(op.f("ix_contracts_versions_studio_id"), "contracts_versions", ["studio_id"])
    op.create_table(
        "contracts_work_logs",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("minutes", sa.Integer(), nullable=False),
        sa.Column("worked_on", sa.Date(), nullable=False),
        sa.Column("logged_by", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("minutes > 0", name=op.f("ck_contracts_work_logs_minutes_positive")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_work_logs_contract_id")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_contracts_work_logs_cue_id")),
        sa.ForeignKeyConstraint(["logged_by"], ["accounts_people.id"], name=op.f("fk_contracts_work_logs_logged_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_work_logs_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_work_logs_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_work_logs")),
    )
    op.create_index(op.f("ix_contracts_work_logs_contract_id"), "contracts_work_logs", ["contract_id"])
    op.create_index(op.f("ix_contracts_work_logs_cue_id"), "contracts_work_logs", ["cue_id"])
    op.create_index(op.f("ix_contracts_work_logs_project_id"), "contracts_work_logs", ["project_id"])
    op.create_index(op.f("ix_contracts_work_logs_studio_id"), "contracts_work_logs", ["studio_id"])
    op.create_table(
        "deliveries_dry_stems",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("delivery_id", sa.Uuid(), nullable=False),
        sa.Column("stem", sa.String(), nullable=False),
        sa.Column("upload_id", sa.Uuid()),
        sa.Column("archive_id", sa.Uuid()),
        sa.Column("archive_entry", sa.Integer()),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("file_bytes", sa.BigInteger(), nullable=False),
        sa.Column("received_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("withdrawn_at", sa.DateTime(timezone=True)),
        sa.CheckConstraint("file_bytes >= 0", name=op.f("ck_deliveries_dry_stems_size_known")),
        sa.ForeignKeyConstraint(["archive_id"], ["deliveries_archives.id"], name=op.f("fk_deliveries_dry_stems_archive_id")),
        sa.ForeignKeyConstraint(["delivery_id"], ["deliveries_deliveries.id"], name=op.f("fk_deliveries_dry_stems_delivery_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_deliveries_dry_stems_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_deliveries_dry_stems_studio_id")),
        sa.ForeignKeyConstraint(["upload_id"], ["core_uploads.id"], name=op.f("fk_deliveries_dry_stems_upload_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_deliveries_dry_stems")),
        sa.UniqueConstraint("archive_id", "archive_entry", name=op.f("uq_deliveries_dry_stems_archive_id_archive_entry")),
        sa.UniqueConstraint("upload_id", "stem", name=op.f("uq_deliveries_dry_stems_upload_id_stem")),
    )
    op.create_index("ix_deliveries_dry_stems_kept", "deliveries_dry_stems", ["studio_id", "sha256", "file_bytes"])
    op.create_index("ix_deliveries_dry_stems_of_takes", "deliveries_dry_stems", ["delivery_id", "stem"])
    op.create_index(op.f("ix_deliveries_dry_stems_project_id"), "deliveries_dry_stems", ["project_id"])
    op.create_table(
        "deliveries_takes",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("delivery_id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column("upload_id", sa.Uuid()),
        sa.Column("archive_id", sa.Uuid()),
        sa.Column("archive_entry", sa.Integer()),
        sa.Column("fix_of_id", sa.Uuid()),
        sa.Column("split_of_id", sa.Uuid()),
        sa.Column("split_first_frame", sa.BigInteger()),
        sa.Column("split_end_frame", sa.BigInteger()),
        sa.Column("cue_id", sa.Uuid()),
        sa.Column("variation", sa.Integer(), nullable=False),
        sa.Column("number", sa.Integer()),
        sa.Column("alternate", sa.Integer()),
        sa.Column("state", sa.Enum("received", "conforming", "returned", "unjudged", "approved", "change_requested", "set_aside", name="takestate", native_enum=False, length=32), nullable=False),
        sa.Column("late", sa.Boolean(), nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("master_sha256", sa.String(), nullable=False),
        sa.Column("master_bytes", sa.BigInteger(), nullable=False),
        sa.Column("received_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("state_since", sa.DateTime(timezone=True), nullable=False),
        sa.Column("conforming_since", sa.DateTime(timezone=True)),
        sa.Column("returned_since", sa.DateTime(timezone=True)),
        sa.Column("edition", sa.Integer(), nullable=False),
        sa.Column("rechecked_by", sa.Uuid()),
        sa.Column("discarded_at", sa.DateTime(timezone=True)),
        sa.Column("master_deleted_at", sa.DateTime(timezone=True)),
        sa.Column("label", sa.String()),
        sa.Column("labelled_by", sa.Uuid()),
        sa.Column("labelled_at", sa.DateTime(timezone=True)),
        sa.Column("verdict_reasons", JSON, nullable=False),
        sa.CheckConstraint("(cue_id is null) = (number is null)", name=op.f("ck_deliveries_takes_numbered_when_matched")),
        sa.CheckConstraint("(split_of_id is null) = (split_first_frame is null) and (split_of_id is null) = (split_end_frame is null)", name=op.f("ck_deliveries_takes_split_has_range")),
        sa.CheckConstraint("master_bytes >= 0", name=op.f("ck_deliveries_takes_master_size_known")),
        sa.ForeignKeyConstraint(["archive_id"], ["deliveries_archives.id"], name=op.f("fk_deliveries_takes_archive_id")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_deliveries_takes_cue_id")),
        sa.ForeignKeyConstraint(["delivery_id"], ["deliveries_deliveries.id"], name=op.f("fk_deliveries_takes_delivery_id")),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name=op.f("fk_deliveries_takes_designer_id")),
        sa.ForeignKeyConstraint(["fix_of_id"], ["deliveries_takes.id"], name=op.f("fk_deliveries_takes_fix_of_id")),
        sa.ForeignKeyConstraint(["labelled_by"], ["accounts_people.id"], name=op.f("fk_deliveries_takes_labelled_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_deliveries_takes_project_id")),
        sa.ForeignKeyConstraint(["rechecked_by"], ["accounts_people.id"], name=op.f("fk_deliveries_takes_rechecked_by")),
        sa.ForeignKeyConstraint(["split_of_id"], ["deliveries_takes.id"], name=op.f("fk_deliveries_takes_split_of_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_deliveries_takes_studio_id")),
        sa.ForeignKeyConstraint(["upload_id"], ["core_uploads.id"], name=op.f("fk_deliveries_takes_upload_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_deliveries_takes")),
        sa.UniqueConstraint("archive_id", "archive_entry", name=op.f("uq_deliveries_takes_archive_id_archive_entry")),
        sa.UniqueConstraint("cue_id", "variation", "number", name=op.f("uq_deliveries_takes_cue_id_variation_number")),
        sa.UniqueConstraint("upload_id", name=op.f("uq_deliveries_takes_upload_id")),
    )
    op.create_index(op.f("ix_deliveries_takes_delivery_id"), "deliveries_takes", ["delivery_id"])
    op.create_index("ix_deliveries_takes_file_names", "deliveries_takes", ["project_id", "id", "file_name", "designer_id", "discarded_at", "studio_id"])
    op.create_index(op.f("ix_deliveries_takes_fix_of_id"), "deliveries_takes", ["fix_of_id"])
    op.create_index("ix_deliveries_takes_kept", "deliveries_takes", ["studio_id", "master_sha256", "master_bytes", "master_deleted_at"])
    op.create_index("ix_deliveries_takes_labelled", "deliveries_takes", ["project_id", "id", "label", "designer_id", "cue_id", "studio_id"], sqlite_where=sa.text("label is not null"), postgresql_where=sa.text("label is not null"))
    op.create_index(op.f("ix_deliveries_takes_master_sha256"), "deliveries_takes", ["master_sha256"])
    op.create_index("ix_deliveries_takes_project_waiting", "deliveries_takes", ["project_id", "state", "state_since", "cue_id", "designer_id", "studio_id"])
    op.create_index(op.f("ix_deliveries_takes_split_of_id"), "deliveries_takes", ["split_of_id"])
    op.create_index("ix_deliveries_takes_studio_waiting", "deliveries_takes", ["studio_id", "state", "state_since", "cue_id"])
    op.create_index("ix_deliveries_takes_sums", "deliveries_takes", ["project_id", "cue_id", "variation", "state", "number", "designer_id", "studio_id"])
    op.create_index("uq_reviews_one_approved", "deliveries_takes", ["cue_id", "variation"], unique=True, sqlite_where=sa.text("state = 'approved'"), postgresql_where=sa.text("state = 'approved'"))
    op.create_table(
        "hiring_bid_notes",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("bid_id", sa.Uuid(), nullable=False),
        sa.Column("kind", sa.Enum("call", "interview", "other", name="bidnotekind", native_enum=False, length=32), nullable=False),
        sa.Column("held_on", sa.Date(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("written_by", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["bid_id"], ["hiring_bids.id"], name=op.f("fk_hiring_bid_notes_bid_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_hiring_bid_notes_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_hiring_bid_notes_studio_id")),
        sa.ForeignKeyConstraint(["written_by"], ["accounts_people.id"], name=op.f("fk_hiring_bid_notes_written_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_hiring_bid_notes")),
    )
    op.create_index(op.f("ix_hiring_bid_notes_bid_id"), "hiring_bid_notes", ["bid_id"])
    op.create_index(op.f("ix_hiring_bid_notes_project_id"), "hiring_bid_notes", ["project_id"])
    op.create_index(op.f("ix_hiring_bid_notes_studio_id"), "hiring_bid_notes", ["studio_id"])
    op.create_table(
        "hiring_samples",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("bid_id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column("line_key", sa.String(), nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("media_type", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("file_bytes", sa.BigInteger(), nullable=False),
        sa.Column("state", sa.Enum("pending", "conforming", "returned", "unchecked", name="samplestate", native_enum=False, length=32), nullable=False),
        sa.Column("spec_version", sa.Integer()),
        sa.Column("findings", JSON, nullable=False),
        sa.Column("problem", sa.String(), nullable=False),
        sa.Column("added_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("file_bytes > 0", name=op.f("ck_hiring_samples_not_empty")),
        sa.ForeignKeyConstraint(["bid_id"], ["hiring_bids.id"], name=op.f("fk_hiring_samples_bid_id")),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name=op.f("fk_hiring_samples_designer_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_hiring_samples_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_hiring_samples_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_hiring_samples")),
    )
    op.create_index(op.f("ix_hiring_samples_bid_id"), "hiring_samples", ["bid_id"])
    op.create_index(op.f("ix_hiring_samples_designer_id"), "hiring_samples", ["designer_id"])
    op.create_index(op.f("ix_hiring_samples_project_id"), "hiring_samples", ["project_id"])
    op.create_index(op.f("ix_hiring_samples_studio_id"), "hiring_samples", ["studio_id"])
    op.create_table(
        "hiring_scores",
        sa.Column("bid_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("scores", JSON, nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("changed_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["bid_id"], ["hiring_bids.id"], name=op.f("fk_hiring_scores_bid_id")),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_hiring_scores_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_hiring_scores_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_hiring_scores_studio_id")),
        sa.PrimaryKeyConstraint("bid_id", "person_id", name=op.f("pk_hiring_scores")),
    )
    op.create_index(op.f("ix_hiring_scores_project_id"), "hiring_scores", ["project_id"])
    op.create_index(op.f("ix_hiring_scores_studio_id"), "hiring_scores", ["studio_id"])
    op.create_table(
        "references_versions",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("reference_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("kind", sa.Enum("picture", "pdf", "text", "video", "audio", "file", "link", name="referencekind", native_enum=False, length=32), nullable=False),
        sa.Column("media_type", sa.String(), nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("url", sa.String()),
        sa.Column("sha256", sa.String()),
        sa.Column("file_bytes", sa.BigInteger()),
        sa.Column("excerpt", sa.String(), nullable=False),
        sa.Column("preview", sa.Enum("none", "pending", "made", "refused", name="previewstate", native_enum=False, length=32), nullable=False),
        sa.Column("problem", sa.String(), nullable=False),
        sa.Column("width_px", sa.Integer()),
        sa.Column("height_px", sa.Integer()),
        sa.Column("thumb_sha256", sa.String()),
        sa.Column("thumb_bytes", sa.Integer()),
        sa.Column("view_sha256", sa.String()),
        sa.Column("view_bytes", sa.Integer()),
        sa.Column("added_by", sa.Uuid(), nullable=False),
        sa.Column("added_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(sha256 is null) = (file_bytes is null)", name=op.f("ck_references_versions_file_has_a_size")),
        sa.CheckConstraint("(url is null) <> (sha256 is null)", name=op.f("ck_references_versions_file_or_link")),
        sa.ForeignKeyConstraint(["added_by"], ["accounts_people.id"], name=op.f("fk_references_versions_added_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_references_versions_project_id")),
        sa.ForeignKeyConstraint(["reference_id"], ["references_references.id"], name=op.f("fk_references_versions_reference_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_references_versions_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_references_versions")),
        sa.UniqueConstraint("reference_id", "number", name=op.f("uq_references_versions_reference_id_number")),
    )
    op.create_index("ix_references_versions_kept", "references_versions", ["studio_id", "sha256", "file_bytes"])
    op.create_index(op.f("ix_references_versions_project_id"), "references_versions", ["project_id"])
    op.create_table(
        "shares_guest_plays",
        sa.Column("visit_id", sa.Uuid(), nullable=False),
        sa.Column("place", sa.Integer(), nullable=False),
        sa.Column("plays", sa.Integer(), nullable=False),
        sa.Column("last_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_shares_guest_plays_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_shares_guest_plays_studio_id")),
        sa.ForeignKeyConstraint(["visit_id"], ["shares_guest_visits.id"], name=op.f("fk_shares_guest_plays_visit_id")),
        sa.PrimaryKeyConstraint("visit_id", "place", name=op.f("pk_shares_guest_plays")),
    )
    op.create_index(op.f("ix_shares_guest_plays_project_id"), "shares_guest_plays", ["project_id"])
    op.create_index(op.f("ix_shares_guest_plays_studio_id"), "shares_guest_plays", ["studio_id"])
    op.create_table(
        "voice_lines_texts",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("line_id", sa.Uuid(), nullable=False),
        sa.Column("language", sa.String(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("newest_number", sa.Integer(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_voice_lines_texts_cue_id")),
        sa.ForeignKeyConstraint(["line_id"], ["voice_lines_lines.id"], name=op.f("fk_voice_lines_texts_line_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_voice_lines_texts_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_voice_lines_texts_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_voice_lines_texts")),
        sa.UniqueConstraint("cue_id", name=op.f("uq_voice_lines_texts_cue_id")),
        sa.UniqueConstraint("line_id", "language", name=op.f("uq_voice_lines_texts_line_id_language")),
    )
    op.create_index("ix_voice_lines_texts_language", "voice_lines_texts", ["project_id", "language"])
    op.create_index(op.f("ix_voice_lines_texts_studio_id"), "voice_lines_texts", ["studio_id"])
    op.create_table(
        "webhooks_attempts",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("call_id", sa.Uuid(), nullable=False),
        sa.Column("tried_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("took_ms", sa.Integer(), nullable=False),
        sa.Column("status", sa.Integer()),
        sa.Column("answer", sa.String(), nullable=False),
        sa.Column("problem", sa.String(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["call_id"], ["webhooks_calls.id"], name=op.f("fk_webhooks_attempts_call_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_webhooks_attempts_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_webhooks_attempts")),
    )
    op.create_index(op.f("ix_webhooks_attempts_call_id"), "webhooks_attempts", ["call_id"])
    op.create_index(op.f("ix_webhooks_attempts_studio_id"), "webhooks_attempts", ["studio_id"])
    op.create_table(
        "builds_audited_sounds",
        sa.Column("audit_id", sa.Uuid(), nullable=False),
        sa.Column("place", sa.Integer(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("path", sa.String(), nullable=False),
        sa.Column("cue_id", sa.Uuid()),
        sa.Column("take_id", sa.Uuid()),
        sa.Column("status", sa.Enum("same", "gain", "trimmed", "resampled", "re-encoded", "changed", "missing", "unknown", "placeholder", "duplicate", "converted", "unapproved", "unused", "depends", name="auditstatus", native_enum=False, length=32), nullable=False),
        sa.Column("played_status", sa.Enum("same", "gain", "trimmed", "resampled", "re-encoded", "changed", "missing", "unknown", "placeholder", "duplicate", "converted", "unapproved", "unused", "depends", name="auditstatus", native_enum=False, length=32), nullable=False),
        sa.Column("has_drifted", sa.Boolean(), nullable=False),
        sa.Column("gain_db", sa.Double()),
        sa.Column("file_db", sa.Double()),
        sa.Column("property_db", sa.Double()),
        sa.Column("message", sa.String(), nullable=False),
        sa.Column("moves", JSON, nullable=False),
        sa.Column("depends", JSON, nullable=False),
        sa.Column("events", JSON, nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["audit_id"], ["builds_audits.id"], name=op.f("fk_builds_audited_sounds_audit_id")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_builds_audited_sounds_cue_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_builds_audited_sounds_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_audited_sounds_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_builds_audited_sounds_take_id")),
        sa.PrimaryKeyConstraint("audit_id", "place", name=op.f("pk_builds_audited_sounds")),
    )
    op.create_index(op.f("ix_builds_audited_sounds_cue_id"), "builds_audited_sounds", ["cue_id"])
    op.create_index("ix_builds_audited_sounds_drift", "builds_audited_sounds", ["audit_id", "has_drifted", "place"])
    op.create_index("ix_builds_audited_sounds_history", "builds_audited_sounds", ["project_id", "path", "audit_id"])
    op.create_index(op.f("ix_builds_audited_sounds_studio_id"), "builds_audited_sounds", ["studio_id"])
    op.create_table(
        "builds_library_matches",
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("library_id", sa.Uuid(), nullable=False),
        sa.Column("path", sa.String(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("licence", sa.String(), nullable=False),
        sa.Column("score", sa.Double(), nullable=False),
        sa.Column("gain_db", sa.Double(), nullable=False),
        sa.Column("has_same_samples", sa.Boolean(), nullable=False),
        sa.Column("is_trimmed", sa.Boolean(), nullable=False),
        sa.Column("is_resampled", sa.Boolean(), nullable=False),
        sa.Column("found_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["library_id"], ["builds_sound_libraries.id"], name=op.f("fk_builds_library_matches_library_id"), ondelete="CASCADE"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_builds_library_matches_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_library_matches_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_builds_library_matches_take_id")),
        sa.PrimaryKeyConstraint("take_id", "library_id", "path", name=op.f("pk_builds_library_matches")),
    )
    op.create_index(op.f("ix_builds_library_matches_library_id"), "builds_library_matches", ["library_id"])
    op.create_table(
        "builds_listening_notes",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("pass_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("said", sa.Enum("too-loud", "too-soft", "too-long", "too-short", "wrong", "missing", "good", "not-reached", name="heardas", native_enum=False, length=32), nullable=False),
        sa.Column("amount_db", sa.Double()),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("written_by", sa.Uuid(), nullable=False),
        sa.Column("written_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("received_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("undone_at", sa.DateTime(timezone=True)),
        sa.Column("recording_id", sa.Uuid()),
        sa.Column("at_s", sa.Double()),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("(recording_id is null) = (at_s is null)", name=op.f("ck_builds_listening_notes_recording_has_a_time")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_builds_listening_notes_cue_id")),
        sa.ForeignKeyConstraint(["pass_id"], ["builds_listening_passes.id"], name=op.f("fk_builds_listening_notes_pass_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_builds_listening_notes_project_id")),
        sa.ForeignKeyConstraint(["recording_id"], ["references_versions.id"], name=op.f("fk_builds_listening_notes_recording_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_listening_notes_studio_id")),
        sa.ForeignKeyConstraint(["written_by"], ["accounts_people.id"], name=op.f("fk_builds_listening_notes_written_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_builds_listening_notes")),
    )
    op.create_index("ix_builds_listening_notes_heard", "builds_listening_notes", ["project_id", "said", "cue_id"])
    op.create_index("ix_builds_listening_notes_pass", "builds_listening_notes", ["pass_id", "cue_id"])
    op.create_index(op.f("ix_builds_listening_notes_recording_id"), "builds_listening_notes", ["recording_id"])
    op.create_index(op.f("ix_builds_listening_notes_studio_id"), "builds_listening_notes", ["studio_id"])
    op.create_table(
        "builds_same_sounds",
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("other_take_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("score", sa.Double(), nullable=False),
        sa.Column("gain_db", sa.Double(), nullable=False),
        sa.Column("has_same_samples", sa.Boolean(), nullable=False),
        sa.Column("is_trimmed", sa.Boolean(), nullable=False),
        sa.Column("is_resampled", sa.Boolean(), nullable=False),
        sa.Column("found_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["other_take_id"], ["deliveries_takes.id"], name=op.f("fk_builds_same_sounds_other_take_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_builds_same_sounds_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_same_sounds_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_builds_same_sounds_take_id")),
        sa.PrimaryKeyConstraint("take_id", "other_take_id", name=op.f("pk_builds_same_sounds")),
    )
    op.create_index(op.f("ix_builds_same_sounds_studio_id"), "builds_same_sounds", ["studio_id"])
    op.create_table(
        "conformance_check_runs",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("spec_id", sa.Uuid(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("is_current", sa.Boolean(), nullable=False),
        sa.Column("needs_notification", sa.Boolean(), nullable=False),
        sa.Column("verdict", sa.String(), nullable=False),
        sa.Column("pcm_sha256", sa.String()),
        sa.Column("report", JSON, nullable=False),
        sa.Column("tool_version", sa.String(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_conformance_check_runs_project_id")),
        sa.ForeignKeyConstraint(["spec_id"], ["projects_specs.id"], name=op.f("fk_conformance_check_runs_spec_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_conformance_check_runs_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_conformance_check_runs_take_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_conformance_check_runs")),
    )
    op.create_index(op.f("ix_conformance_check_runs_key"), "conformance_check_runs", ["key"])
    op.create_index(op.f("ix_conformance_check_runs_project_id"), "conformance_check_runs", ["project_id"])
    op.create_index(op.f("ix_conformance_check_runs_studio_id"), "conformance_check_runs", ["studio_id"])
    op.create_index(op.f("ix_conformance_check_runs_take_id"), "conformance_check_runs", ["take_id"])
    op.create_index("ix_conformance_check_runs_unnotified", "conformance_check_runs", ["project_id"], sqlite_where=sa.text("needs_notification"), postgresql_where=sa.text("needs_notification"))
    op.create_index("uq_conformance_check_runs_current", "conformance_check_runs", ["take_id"], unique=True, sqlite_where=sa.text("is_current"), postgresql_where=sa.text("is_current"))
    op.create_table(
        "conformance_fixes",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("state", sa.Enum("making", "made", "refused", name="fixstate", native_enum=False, length=32), nullable=False),
        sa.Column("asked_by", sa.Uuid()),
        sa.Column("made_at", sa.DateTime(timezone=True)),
        sa.Column("refusal", sa.String()),
        sa.Column("sha256", sa.String()),
        sa.Column("fixed_bytes", sa.BigInteger()),
        sa.Column("made", JSON, nullable=False),
        sa.Column("used_by", sa.Uuid()),
        sa.Column("used_at", sa.DateTime(timezone=True)),
        sa.Column("new_take_id", sa.Uuid()),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(state = 'made') = (sha256 is not null)", name=op.f("ck_conformance_fixes_made_has_file")),
        sa.CheckConstraint("(used_by is null) = (new_take_id is null)", name=op.f("ck_conformance_fixes_used_is_a_take")),
        sa.ForeignKeyConstraint(["asked_by"], ["accounts_people.id"], name=op.f("fk_conformance_fixes_asked_by")),
        sa.ForeignKeyConstraint(["new_take_id"], ["deliveries_takes.id"], name=op.f("fk_conformance_fixes_new_take_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_conformance_fixes_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_conformance_fixes_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_conformance_fixes_take_id")),
        sa.ForeignKeyConstraint(["used_by"], ["accounts_people.id"], name=op.f("fk_conformance_fixes_used_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_conformance_fixes")),
        sa.UniqueConstraint("take_id", "key", name=op.f("uq_conformance_fixes_take_id_key")),
    )
    op.create_index(op.f("ix_conformance_fixes_new_take_id"), "conformance_fixes", ["new_take_id"])
    op.create_index(op.f("ix_conformance_fixes_project_id"), "conformance_fixes", ["project_id"])
    op.create_index(op.f("ix_conformance_fixes_sha256"), "conformance_fixes", ["sha256"])
    op.create_index(op.f("ix_conformance_fixes_studio_id"), "conformance_fixes", ["studio_id"])
    op.create_table(
        "conformance_splits",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("shortest_pause_s", sa.Double(), nullable=False),
        sa.Column("state", sa.Enum("making", "made", "refused", name="fixstate", native_enum=False, length=32), nullable=False),
        sa.Column("asked_by", sa.Uuid(), nullable=False),
        sa.Column("asked_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("refusal", sa.String()),
        sa.Column("found_by", sa.String()),
        sa.Column("sample_rate_hz", sa.Integer()),
        sa.Column("tray_action_id", sa.Uuid()),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(state = 'made') = (found_by is not null)", name=op.f("ck_conformance_splits_made_has_parts")),
        sa.CheckConstraint("(found_by is null) = (sample_rate_hz is null)", name=op.f("ck_conformance_splits_rate_with_parts")),
        sa.ForeignKeyConstraint(["asked_by"], ["accounts_people.id"], name=op.f("fk_conformance_splits_asked_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_conformance_splits_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_conformance_splits_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_conformance_splits_take_id")),
        sa.ForeignKeyConstraint(["tray_action_id"], ["deliveries_tray_actions.id"], name=op.f("fk_conformance_splits_tray_action_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_conformance_splits")),
        sa.UniqueConstraint("take_id", "shortest_pause_s", name=op.f("uq_conformance_splits_take_id_shortest_pause_s")),
    )
    op.create_index(op.f("ix_conformance_splits_project_id"), "conformance_splits", ["project_id"])
    op.create_index(op.f("ix_conformance_splits_studio_id"), "conformance_splits", ["studio_id"])
    op.create_index(op.f("ix_conformance_splits_tray_action_id"), "conformance_splits", ["tray_action_id"])
    op.create_table(
        "contracts_acceptances",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("version_id", sa.Uuid(), nullable=False),
        sa.Column("party", sa.Enum("studio", "designer", name="party", native_enum=False, length=32), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("email", sa.String(), nullable=False),
        sa.Column("email_proof", sa.Enum("mail", "operator", "provider", name="addressproof", native_enum=False, length=32)),
        sa.Column("address", sa.String(), nullable=False),
        sa.Column("agent", sa.String(), nullable=False),
        sa.Column("code_entered_at", sa.DateTime(timezone=True)),
        sa.Column("drawing", JSON),
        sa.Column("accepted_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_acceptances_contract_id")),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_contracts_acceptances_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_acceptances_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_acceptances_studio_id")),
        sa.ForeignKeyConstraint(["version_id"], ["contracts_versions.id"], name=op.f("fk_contracts_acceptances_version_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_acceptances")),
        sa.UniqueConstraint("version_id", "person_id", name=op.f("uq_contracts_acceptances_version_id_person_id")),
    )
    op.create_index(op.f("ix_contracts_acceptances_contract_id"), "contracts_acceptances", ["contract_id"])
    op.create_index(op.f("ix_contracts_acceptances_project_id"), "contracts_acceptances", ["project_id"])
    op.create_index(op.f("ix_contracts_acceptances_studio_id"), "contracts_acceptances", ["studio_id"])
    op.create_table(
        "contracts_cues",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("milestone_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("position", sa.Integer(), nullable=False),
        sa.Column("price_minor", sa.BigInteger()),
        sa.Column("amount_minor", sa.BigInteger()),
        sa.Column("estimate_min", sa.Integer()),
        sa.Column("accepted_at", sa.DateTime(timezone=True)),
        sa.Column("accepted_by", sa.Enum("verdict", "silence", "adoption", name="acceptedby", native_enum=False, length=32)),
        sa.Column("cut_at", sa.DateTime(timezone=True)),
        sa.Column("cut_in", sa.Enum("not_begun", "in_work", "delivered", "accepted", name="workstate", native_enum=False, length=32)),
        sa.Column("change_requested_at", sa.DateTime(timezone=True)),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("(accepted_at is null) = (accepted_by is null)", name=op.f("ck_contracts_cues_accepted_somehow")),
        sa.CheckConstraint("(cut_at is null) = (cut_in is null)", name=op.f("ck_contracts_cues_cut_in_a_state")),
        sa.CheckConstraint("amount_minor >= 0", name=op.f("ck_contracts_cues_amount_not_negative")),
        sa.CheckConstraint("estimate_min > 0", name=op.f("ck_contracts_cues_estimate_positive")),
        sa.CheckConstraint("price_minor >= 0", name=op.f("ck_contracts_cues_price_not_negative")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_cues_contract_id")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_contracts_cues_cue_id")),
        sa.ForeignKeyConstraint(["milestone_id"], ["contracts_milestones.id"], name=op.f("fk_contracts_cues_milestone_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_cues_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_cues_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_cues")),
        sa.UniqueConstraint("contract_id", "cue_id", name=op.f("uq_contracts_cues_contract_id_cue_id")),
    )
    op.create_index(op.f("ix_contracts_cues_cue_id"), "contracts_cues", ["cue_id"])
    op.create_index(op.f("ix_contracts_cues_milestone_id"), "contracts_cues", ["milestone_id"])
    op.create_index(op.f("ix_contracts_cues_project_id"), "contracts_cues", ["project_id"])
    op.create_index(op.f("ix_contracts_cues_studio_id"), "contracts_cues", ["studio_id"])
    op.create_table(
        "contracts_payments",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("invoice_id", sa.Uuid(), nullable=False),
        sa.Column("refund_of_id", sa.Uuid()),
        sa.Column("amount_minor", sa.BigInteger(), nullable=False),
        sa.Column("reference", sa.String(), nullable=False),
        sa.Column("paid_on", sa.Date(), nullable=False),
        sa.Column("recorded_by", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("amount_minor <> 0", name=op.f("ck_contracts_payments_not_nothing")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_payments_contract_id")),
        sa.ForeignKeyConstraint(["invoice_id"], ["contracts_invoices.id"], name=op.f("fk_contracts_payments_invoice_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_payments_project_id")),
        sa.ForeignKeyConstraint(["recorded_by"], ["accounts_people.id"], name=op.f("fk_contracts_payments_recorded_by")),
        sa.ForeignKeyConstraint(["refund_of_id"], ["contracts_payments.id"], name=op.f("fk_contracts_payments_refund_of_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_payments_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_payments")),
    )
    op.create_index(op.f("ix_contracts_payments_contract_id"), "contracts_payments", ["contract_id"])
    op.create_index(op.f("ix_contracts_payments_invoice_id"), "contracts_payments", ["invoice_id"])
    op.create_index(op.f("ix_contracts_payments_project_id"), "contracts_payments", ["project_id"])
    op.create_index(op.f("ix_contracts_payments_refund_of_id"), "contracts_payments", ["refund_of_id"])
    op.create_index(op.f("ix_contracts_payments_studio_id"), "contracts_payments", ["studio_id"])
    op.create_table(
        "contracts_seals",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("version_id", sa.Uuid(), nullable=False),
        sa.Column("file_sha256", sa.String(), nullable=False),
        sa.Column("file_bytes", sa.Integer(), nullable=False),
        sa.Column("key_sha256", sa.String(), nullable=False),
        sa.Column("is_timestamped", sa.Boolean(), nullable=False),
        sa.Column("sealed_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_seals_contract_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_seals_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_seals_studio_id")),
        sa.ForeignKeyConstraint(["version_id"], ["contracts_versions.id"], name=op.f("fk_contracts_seals_version_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_seals")),
        sa.UniqueConstraint("version_id", name=op.f("uq_contracts_seals_version_id")),
    )
    op.create_index(op.f("ix_contracts_seals_contract_id"), "contracts_seals", ["contract_id"])
    op.create_index(op.f("ix_contracts_seals_file_sha256"), "contracts_seals", ["file_sha256"])
    op.create_index(op.f("ix_contracts_seals_project_id"), "contracts_seals", ["project_id"])
    op.create_index(op.f("ix_contracts_seals_studio_id"), "contracts_seals", ["studio_id"])
    op.create_table(
        "contracts_worked_days",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("milestone_id", sa.Uuid()),
        sa.Column("cue_id", sa.Uuid()),
        sa.Column("worked_on", sa.Date(), nullable=False),
        sa.Column("quarters", sa.Integer()),
        sa.Column("minutes", sa.Integer()),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("logged_by", sa.Uuid(), nullable=False),
        sa.Column("agreed_by", sa.Uuid()),
        sa.Column("agreed_at", sa.DateTime(timezone=True)),
        sa.Column("refused_by", sa.Uuid()),
        sa.Column("refused_at", sa.DateTime(timezone=True)),
        sa.Column("refusal", sa.String(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(quarters is null) <> (minutes is null)", name=op.f("ck_contracts_worked_days_in_one_unit")),
        sa.CheckConstraint("(refused_at is null) = (refused_by is null)", name=op.f("ck_contracts_worked_days_refused_by_somebody")),
        sa.CheckConstraint("agreed_at is null or refused_at is null", name=op.f("ck_contracts_worked_days_agreed_or_refused")),
        sa.CheckConstraint("agreed_by is null or agreed_at is not null", name=op.f("ck_contracts_worked_days_agreed_at_some_time")),
        sa.CheckConstraint("minutes between 1 and 1440", name=op.f("ck_contracts_worked_days_hours_of_a_day_at_most")),
        sa.CheckConstraint("quarters between 1 and 4", name=op.f("ck_contracts_worked_days_a_day_at_most")),
        sa.ForeignKeyConstraint(["agreed_by"], ["accounts_people.id"], name=op.f("fk_contracts_worked_days_agreed_by")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_worked_days_contract_id")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_contracts_worked_days_cue_id")),
        sa.ForeignKeyConstraint(["logged_by"], ["accounts_people.id"], name=op.f("fk_contracts_worked_days_logged_by")),
        sa.ForeignKeyConstraint(["milestone_id"], ["contracts_milestones.id"], name=op.f("fk_contracts_worked_days_milestone_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_worked_days_project_id")),
        sa.ForeignKeyConstraint(["refused_by"], ["accounts_people.id"], name=op.f("fk_contracts_worked_days_refused_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_worked_days_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_worked_days")),
    )
    op.create_index(op.f("ix_contracts_worked_days_contract_id"), "contracts_worked_days", ["contract_id"])
    op.create_index(op.f("ix_contracts_worked_days_project_id"), "contracts_worked_days", ["project_id"])
    op.create_index(op.f("ix_contracts_worked_days_studio_id"), "contracts_worked_days", ["studio_id"])
    op.create_index("uq_contracts_worked_days_quarters", "contracts_worked_days", ["contract_id", "worked_on"], unique=True, sqlite_where=sa.text("quarters is not null"), postgresql_where=sa.text("quarters is not null"))
    op.create_table(
        "deliveries_source_banks",
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("plug_ins", JSON, nullable=False),
        sa.Column("recipe", sa.String(), nullable=False),
        sa.Column("changed_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_deliveries_source_banks_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_deliveries_source_banks_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_deliveries_source_banks_take_id")),
        sa.PrimaryKeyConstraint("take_id", name=op.f("pk_deliveries_source_banks")),
    )
    op.create_index(op.f("ix_deliveries_source_banks_project_id"), "deliveries_source_banks", ["project_id"])
    op.create_index(op.f("ix_deliveries_source_banks_studio_id"), "deliveries_source_banks", ["studio_id"])
    op.create_table(
        "deliveries_source_files",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("upload_id", sa.Uuid(), nullable=False),
        sa.Column("kind", sa.Enum("session", "layer", name="sourcefilekind", native_enum=False, length=32), nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("file_bytes", sa.BigInteger(), nullable=False),
        sa.Column("received_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("file_bytes >= 0", name=op.f("ck_deliveries_source_files_size_known")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_deliveries_source_files_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_deliveries_source_files_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_deliveries_source_files_take_id")),
        sa.ForeignKeyConstraint(["upload_id"], ["core_uploads.id"], name=op.f("fk_deliveries_source_files_upload_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_deliveries_source_files")),
        sa.UniqueConstraint("take_id", "upload_id", name=op.f("uq_deliveries_source_files_take_id_upload_id")),
    )
    op.create_index("ix_deliveries_source_files_kept", "deliveries_source_files", ["studio_id", "sha256", "file_bytes"])
    op.create_index(op.f("ix_deliveries_source_files_project_id"), "deliveries_source_files", ["project_id"])
    op.create_index(op.f("ix_deliveries_source_files_studio_id"), "deliveries_source_files", ["studio_id"])
    op.create_index(op.f("ix_deliveries_source_files_upload_id"), "deliveries_source_files", ["upload_id"])
    op.create_table(
        "deliveries_source_statements",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("delivery_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid()),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column("sources", JSON, nullable=False),
        sa.Column("stated_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["delivery_id"], ["deliveries_deliveries.id"], name=op.f("fk_deliveries_source_statements_delivery_id")),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name=op.f("fk_deliveries_source_statements_designer_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_deliveries_source_statements_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_deliveries_source_statements_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_deliveries_source_statements_take_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_deliveries_source_statements")),
        sa.UniqueConstraint("take_id", name=op.f("uq_deliveries_source_statements_take_id")),
    )
    op.create_index(op.f("ix_deliveries_source_statements_delivery_id"), "deliveries_source_statements", ["delivery_id"])
    op.create_index(op.f("ix_deliveries_source_statements_project_id"), "deliveries_source_statements", ["project_id"])
    op.create_index("ix_deliveries_source_statements_remembered", "deliveries_source_statements", ["studio_id", "designer_id", "stated_at"])
    op.create_index("uq_deliveries_source_statements_delivery", "deliveries_source_statements", ["delivery_id"], unique=True, sqlite_where=sa.text("take_id is null"), postgresql_where=sa.text("take_id is null"))
    op.create_table(
        "deliveries_take_counts",
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("viewer_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("state", sa.Enum("concept", "prototype", "locked", "cut", name="cuestate", native_enum=False, length=32), nullable=False),
        sa.Column("variations", sa.Integer(), nullable=False),
        sa.Column("placeholder", sa.Boolean(), nullable=False),
        sa.Column("facts", sa.String(), nullable=False),
        sa.Column("newest_id", sa.Uuid(), nullable=False),
        sa.Column("newest_back_since", sa.DateTime(timezone=True)),
        sa.Column("back_since", sa.DateTime(timezone=True)),
        sa.ForeignKeyConstraint(["cue_id", "state", "variations", "placeholder"], ["sound_lists_cues.id", "sound_lists_cues.state", "sound_lists_cues.variations", "sound_lists_cues.placeholder"], name="fk_deliveries_take_counts_cue", onupdate="CASCADE"),
        sa.ForeignKeyConstraint(["newest_id"], ["deliveries_takes.id"], name=op.f("fk_deliveries_take_counts_newest_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_deliveries_take_counts_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_deliveries_take_counts_studio_id")),
        sa.PrimaryKeyConstraint("cue_id", "viewer_id", name=op.f("pk_deliveries_take_counts")),
        sqlite_with_rowid=False,
    )
    op.create_index("ix_deliveries_take_counts_alike", "deliveries_take_counts", ["project_id", "viewer_id", "state", "variations", "placeholder", "facts", "studio_id"])
    op.create_index("ix_deliveries_take_counts_back", "deliveries_take_counts", ["project_id", "viewer_id", "back_since", "cue_id"], sqlite_where=sa.text("back_since is not null"), postgresql_where=sa.text("back_since is not null"))
    op.create_index("ix_deliveries_take_counts_newest_back", "deliveries_take_counts", ["project_id", "viewer_id", "newest_back_since"], sqlite_where=sa.text("newest_back_since is not null"), postgresql_where=sa.text("newest_back_since is not null"))
    op.create_table(
        "references_openings",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("version_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("opened_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_references_openings_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_references_openings_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_references_openings_studio_id")),
        sa.ForeignKeyConstraint(["version_id"], ["references_versions.id"], name=op.f("fk_references_openings_version_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_references_openings")),
    )
    op.create_index("ix_references_openings_log", "references_openings", ["project_id", "id"])
    op.create_index("ix_references_openings_of_person", "references_openings", ["version_id", "person_id", "opened_at"])
    op.create_index(op.f("ix_references_openings_person_id"), "references_openings", ["person_id"])
    op.create_index(op.f("ix_references_openings_studio_id"), "references_openings", ["studio_id"])
    op.create_table(
        "renders_batch_items",
        sa.Column("batch_id", sa.Uuid(), nullable=False),
        sa.Column("place", sa.Integer(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("target", sa.String(), nullable=False),
        sa.Column("category", sa.String(), nullable=False),
        sa.Column("state", sa.Enum("waiting", "made", "kept", "refused", "left", name="itemstate", native_enum=False, length=32), nullable=False),
        sa.Column("before_bytes", sa.BigInteger()),
        sa.Column("after_bytes", sa.BigInteger()),
        sa.Column("reason", sa.String(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["batch_id"], ["renders_batches.id"], name=op.f("fk_renders_batch_items_batch_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_renders_batch_items_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_renders_batch_items_take_id")),
        sa.PrimaryKeyConstraint("batch_id", "place", name=op.f("pk_renders_batch_items")),
        sa.UniqueConstraint("batch_id", "take_id", "target", name=op.f("uq_renders_batch_items_batch_id_take_id_target")),
    )
    op.create_index(op.f("ix_renders_batch_items_studio_id"), "renders_batch_items", ["studio_id"])
    op.create_index(op.f("ix_renders_batch_items_take_id"), "renders_batch_items", ["take_id"])
    op.create_index("ix_renders_batch_items_waiting", "renders_batch_items", ["batch_id", "state", "place"])
    op.create_table(
        "renders_master_exports",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("provenance", JSON, nullable=False),
        sa.Column("left", JSON, nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("sha256", sa.String()),
        sa.Column("file_bytes", sa.BigInteger()),
        sa.Column("refusal", sa.String()),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("sha256 is null or refusal is null", name=op.f("ck_renders_master_exports_made_or_refused")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_renders_master_exports_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_renders_master_exports_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_renders_master_exports_take_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_renders_master_exports")),
        sa.UniqueConstraint("take_id", "key", name=op.f("uq_renders_master_exports_take_id_key")),
    )
    op.create_index(op.f("ix_renders_master_exports_project_id"), "renders_master_exports", ["project_id"])
    op.create_index(op.f("ix_renders_master_exports_studio_id"), "renders_master_exports", ["studio_id"])
    op.create_table(
        "renders_renders",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("target", sa.String(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("state", sa.Enum("made", "refused", name="renderstate", native_enum=False, length=32), nullable=False),
        sa.Column("refusal", sa.String()),
        sa.Column("sha256", sa.String()),
        sa.Column("pcm_sha256", sa.String()),
        sa.Column("file_bytes", sa.Integer()),
        sa.Column("facts", JSON, nullable=False),
        sa.Column("measurements", JSON, nullable=False),
        sa.Column("attenuation_db", sa.Double()),
        sa.Column("loss", JSON),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(state = 'made') = (sha256 is not null)", name=op.f("ck_renders_renders_made_has_file")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_renders_renders_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_renders_renders_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_renders_renders_take_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_renders_renders")),
        sa.UniqueConstraint("take_id", "target", "key", name=op.f("uq_renders_renders_take_id_target_key")),
    )
    op.create_index("ix_renders_renders_kept", "renders_renders", ["studio_id", "sha256", "file_bytes"])
    op.create_index(op.f("ix_renders_renders_project_id"), "renders_renders", ["project_id"])
    op.create_index(op.f("ix_renders_renders_take_id"), "renders_renders", ["take_id"])
    op.create_table(
        "renders_sets",
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("spec_id", sa.Uuid(), nullable=False),
        sa.Column("edition", sa.Integer(), nullable=False),
        sa.Column("completed_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["spec_id"], ["projects_specs.id"], name=op.f("fk_renders_sets_spec_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_renders_sets_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_renders_sets_take_id")),
        sa.PrimaryKeyConstraint("take_id", name=op.f("pk_renders_sets")),
    )
    op.create_index(op.f("ix_renders_sets_studio_id"), "renders_sets", ["studio_id"])
    op.create_table(
        "reviews_change_requests",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("reasons", JSON, nullable=False),
        sa.Column("start_s", sa.Double()),
        sa.Column("end_s", sa.Double()),
        sa.Column("written_by", sa.Uuid(), nullable=False),
        sa.Column("feedback_id", sa.Uuid()),
        sa.Column("sends_at", sa.DateTime(timezone=True)),
        sa.Column("mentions", JSON, nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("end_s is null or end_s >= start_s", name=op.f("ck_reviews_change_requests_range_forwards")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_reviews_change_requests_cue_id")),
        sa.ForeignKeyConstraint(["feedback_id"], ["reviews_feedback.id"], name=op.f("fk_reviews_change_requests_feedback_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_reviews_change_requests_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_reviews_change_requests_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_reviews_change_requests_take_id")),
        sa.ForeignKeyConstraint(["written_by"], ["accounts_people.id"], name=op.f("fk_reviews_change_requests_written_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_reviews_change_requests")),
    )
    op.create_index(op.f("ix_reviews_change_requests_cue_id"), "reviews_change_requests", ["cue_id"])
    op.create_index("ix_reviews_change_requests_drafts", "reviews_change_requests", ["project_id"], sqlite_where=sa.text("feedback_id is null"), postgresql_where=sa.text("feedback_id is null"))
    op.create_index(op.f("ix_reviews_change_requests_feedback_id"), "reviews_change_requests", ["feedback_id"])
    op.create_index("ix_reviews_change_requests_project_id_id", "reviews_change_requests", ["project_id", "id"])
    op.create_index(op.f("ix_reviews_change_requests_studio_id"), "reviews_change_requests", ["studio_id"])
    op.create_index(op.f("ix_reviews_change_requests_take_id"), "reviews_change_requests", ["take_id"])
    op.create_index("uq_reviews_change_requests_draft", "reviews_change_requests", ["take_id"], unique=True, sqlite_where=sa.text("feedback_id is null"), postgresql_where=sa.text("feedback_id is null"))
    op.create_table(
        "reviews_heard_takes",
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("heard_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_reviews_heard_takes_person_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_reviews_heard_takes_take_id")),
        sa.PrimaryKeyConstraint("take_id", "person_id", name=op.f("pk_reviews_heard_takes")),
    )
    op.create_table(
        "reviews_item_checks",
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("item_id", sa.Uuid(), nullable=False),
        sa.Column("checked_by", sa.Uuid(), nullable=False),
        sa.Column("checked_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["checked_by"], ["accounts_people.id"], name=op.f("fk_reviews_item_checks_checked_by")),
        sa.ForeignKeyConstraint(["item_id"], ["reviews_checklist_items.id"], name=op.f("fk_reviews_item_checks_item_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_reviews_item_checks_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_reviews_item_checks_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_reviews_item_checks_take_id")),
        sa.PrimaryKeyConstraint("take_id", "item_id", name=op.f("pk_reviews_item_checks")),
    )
    op.create_index(op.f("ix_reviews_item_checks_project_id"), "reviews_item_checks", ["project_id"])
    op.create_index(op.f("ix_reviews_item_checks_studio_id"), "reviews_item_checks", ["studio_id"])
    op.create_table(
        "reviews_verdicts",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("action_id", sa.Uuid(), nullable=False),
        sa.Column("kind", sa.Enum("approve", "request_change", "set_aside", "withdraw", name="verdictkind", native_enum=False, length=32), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("reasons", JSON, nullable=False),
        sa.Column("state_before", sa.Enum("received", "conforming", "returned", "unjudged", "approved", "change_requested", "set_aside", name="takestate", native_enum=False, length=32), nullable=False),
        sa.Column("since_before", sa.DateTime(timezone=True), nullable=False),
        sa.Column("dropped_draft", JSON, nullable=False),
        sa.Column("withdraws_id", sa.Uuid()),
        sa.Column("given_by", sa.Uuid()),
        sa.Column("on_behalf_of", sa.Uuid()),
        sa.Column("deemed_by_contract_id", sa.Uuid()),
        sa.Column("adoption_id", sa.Uuid()),
        sa.Column("without_listening", sa.Boolean(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("given_by is not null or deemed_by_contract_id is not null", name=op.f("ck_reviews_verdicts_given_or_deemed")),
        sa.ForeignKeyConstraint(["adoption_id"], ["deliveries_adoptions.id"], name=op.f("fk_reviews_verdicts_adoption_id")),
        sa.ForeignKeyConstraint(["deemed_by_contract_id"], ["contracts_contracts.id"], name=op.f("fk_reviews_verdicts_deemed_by_contract_id")),
        sa.ForeignKeyConstraint(["given_by"], ["accounts_people.id"], name=op.f("fk_reviews_verdicts_given_by")),
        sa.ForeignKeyConstraint(["on_behalf_of"], ["accounts_people.id"], name=op.f("fk_reviews_verdicts_on_behalf_of")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_reviews_verdicts_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_reviews_verdicts_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_reviews_verdicts_take_id")),
        sa.ForeignKeyConstraint(["withdraws_id"], ["reviews_verdicts.id"], name=op.f("fk_reviews_verdicts_withdraws_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_reviews_verdicts")),
        sa.UniqueConstraint("withdraws_id", name=op.f("uq_reviews_verdicts_withdraws_id")),
    )
    op.create_index(op.f("ix_reviews_verdicts_action_id"), "reviews_verdicts", ["action_id"])
    op.create_index(op.f("ix_reviews_verdicts_adoption_id"), "reviews_verdicts", ["adoption_id"])
    op.create_index(op.f("ix_reviews_verdicts_cue_id"), "reviews_verdicts", ["cue_id"])
    op.create_index(op.f("ix_reviews_verdicts_deemed_by_contract_id"), "reviews_verdicts", ["deemed_by_contract_id"])
    op.create_index("ix_reviews_verdicts_project_id_id", "reviews_verdicts", ["project_id", "id"])
    op.create_index(op.f("ix_reviews_verdicts_studio_id"), "reviews_verdicts", ["studio_id"])
    op.create_index(op.f("ix_reviews_verdicts_take_id"), "reviews_verdicts", ["take_id"])
    op.create_table(
        "scenes_beds",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("category", sa.String(), nullable=False),
        sa.Column("role", sa.Enum("music", "ambience", "voice", name="bedrole", native_enum=False, length=32), nullable=False),
        sa.Column("take_id", sa.Uuid()),
        sa.Column("reference_id", sa.Uuid()),
        sa.Column("level_db", sa.Double(), nullable=False),
        sa.Column("is_on", sa.Boolean(), nullable=False),
        sa.Column("changed_by", sa.Uuid(), nullable=False),
        sa.Column("changed_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("(take_id is null) <> (reference_id is null)", name=op.f("ck_scenes_beds_take_or_reference")),
        sa.CheckConstraint("level_db between -60 and 12", name=op.f("ck_scenes_beds_level_in_range")),
        sa.ForeignKeyConstraint(["changed_by"], ["accounts_people.id"], name=op.f("fk_scenes_beds_changed_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_scenes_beds_project_id")),
        sa.ForeignKeyConstraint(["reference_id"], ["references_references.id"], name=op.f("fk_scenes_beds_reference_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_scenes_beds_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_scenes_beds_take_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_scenes_beds")),
        sa.UniqueConstraint("project_id", "category", "role", name=op.f("uq_scenes_beds_project_id_category_role")),
    )
    op.create_index(op.f("ix_scenes_beds_studio_id"), "scenes_beds", ["studio_id"])
    op.create_table(
        "shares_guest_sounds",
        sa.Column("link_id", sa.Uuid(), nullable=False),
        sa.Column("place", sa.Integer(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["link_id"], ["shares_guest_links.id"], name=op.f("fk_shares_guest_sounds_link_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_shares_guest_sounds_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_shares_guest_sounds_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_shares_guest_sounds_take_id")),
        sa.PrimaryKeyConstraint("link_id", "place", name=op.f("pk_shares_guest_sounds")),
    )
    op.create_index(op.f("ix_shares_guest_sounds_project_id"), "shares_guest_sounds", ["project_id"])
    op.create_index(op.f("ix_shares_guest_sounds_studio_id"), "shares_guest_sounds", ["studio_id"])
    op.create_index(op.f("ix_shares_guest_sounds_take_id"), "shares_guest_sounds", ["take_id"])
    op.create_table(
        "shares_live_sessions",
        sa.Column("playlist_id", sa.Uuid(), nullable=False),
        sa.Column("sequence", sa.Integer(), nullable=False),
        sa.Column("holder_id", sa.Uuid()),
        sa.Column("take_id", sa.Uuid()),
        sa.Column("is_playing", sa.Boolean(), nullable=False),
        sa.Column("position_s", sa.Double(), nullable=False),
        sa.Column("set_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["holder_id"], ["accounts_people.id"], name=op.f("fk_shares_live_sessions_holder_id")),
        sa.ForeignKeyConstraint(["playlist_id"], ["shares_playlists.id"], name=op.f("fk_shares_live_sessions_playlist_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_shares_live_sessions_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_shares_live_sessions_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_shares_live_sessions_take_id")),
        sa.PrimaryKeyConstraint("playlist_id", name=op.f("pk_shares_live_sessions")),
    )
    op.create_index(op.f("ix_shares_live_sessions_project_id"), "shares_live_sessions", ["project_id"])
    op.create_index(op.f("ix_shares_live_sessions_studio_id"), "shares_live_sessions", ["studio_id"])
    op.create_table(
        "shares_playlist_entries",
        sa.Column("playlist_id", sa.Uuid(), nullable=False),
        sa.Column("place", sa.Integer(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["playlist_id"], ["shares_playlists.id"], name=op.f("fk_shares_playlist_entries_playlist_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_shares_playlist_entries_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_shares_playlist_entries_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_shares_playlist_entries_take_id")),
        sa.PrimaryKeyConstraint("playlist_id", "place", name=op.f("pk_shares_playlist_entries")),
        sa.UniqueConstraint("playlist_id", "take_id", name=op.f("uq_shares_playlist_entries_playlist_id_take_id")),
    )
    op.create_index(op.f("ix_shares_playlist_entries_project_id"), "shares_playlist_entries", ["project_id"])
    op.create_index(op.f("ix_shares_playlist_entries_studio_id"), "shares_playlist_entries", ["studio_id"])
    op.create_index(op.f("ix_shares_playlist_entries_take_id"), "shares_playlist_entries", ["take_id"])
    op.create_table(
        "shares_playlist_positions",
        sa.Column("playlist_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("at_s", sa.Double(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_shares_playlist_positions_person_id")),
        sa.ForeignKeyConstraint(["playlist_id"], ["shares_playlists.id"], name=op.f("fk_shares_playlist_positions_playlist_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_shares_playlist_positions_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_shares_playlist_positions_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_shares_playlist_positions_take_id")),
        sa.PrimaryKeyConstraint("playlist_id", "person_id", name=op.f("pk_shares_playlist_positions")),
    )
    op.create_index(op.f("ix_shares_playlist_positions_project_id"), "shares_playlist_positions", ["project_id"])
    op.create_index(op.f("ix_shares_playlist_positions_studio_id"), "shares_playlist_positions", ["studio_id"])
    op.create_table(
        "voice_lines_text_versions",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("text_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("written_by", sa.Uuid(), nullable=False),
        sa.Column("written_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("takes_fit_by", sa.Uuid()),
        sa.Column("takes_fit_at", sa.DateTime(timezone=True)),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("(takes_fit_at is null) = (takes_fit_by is null)", name=op.f("ck_voice_lines_text_versions_fit_said_by_a_person")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_voice_lines_text_versions_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_voice_lines_text_versions_studio_id")),
        sa.ForeignKeyConstraint(["takes_fit_by"], ["accounts_people.id"], name=op.f("fk_voice_lines_text_versions_takes_fit_by")),
        sa.ForeignKeyConstraint(["text_id"], ["voice_lines_texts.id"], name=op.f("fk_voice_lines_text_versions_text_id")),
        sa.ForeignKeyConstraint(["written_by"], ["accounts_people.id"], name=op.f("fk_voice_lines_text_versions_written_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_voice_lines_text_versions")),
        sa.UniqueConstraint("text_id", "number", name=op.f("uq_voice_lines_text_versions_text_id_number")),
    )
    op.create_index(op.f("ix_voice_lines_text_versions_project_id"), "voice_lines_text_versions", ["project_id"])
    op.create_index(op.f("ix_voice_lines_text_versions_studio_id"), "voice_lines_text_versions", ["studio_id"])
    op.create_table(
        "builds_game_tasks",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid()),
        sa.Column("path", sa.String(), nullable=False),
        sa.Column("kind", sa.Enum("too-loud", "too-soft", "too-long", "too-short", "wrong", "missing", "drift", name="taskkind", native_enum=False, length=32), nullable=False),
        sa.Column("role", sa.Enum("implementer", "designer", name="taskrole", native_enum=False, length=32), nullable=False),
        sa.Column("assignee_id", sa.Uuid()),
        sa.Column("gain_db", sa.Double()),
        sa.Column("where", sa.String(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("note_id", sa.Uuid()),
        sa.Column("audit_id", sa.Uuid()),
        sa.Column("asked_by", sa.Uuid(), nullable=False),
        sa.Column("asked_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("done_by", sa.Uuid()),
        sa.Column("done_at", sa.DateTime(timezone=True)),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("(done_at is null) = (done_by is null)", name=op.f("ck_builds_game_tasks_done_by_a_person")),
        sa.CheckConstraint("(note_id is null) <> (audit_id is null)", name=op.f("ck_builds_game_tasks_from_note_or_audit")),
        sa.ForeignKeyConstraint(["asked_by"], ["accounts_people.id"], name=op.f("fk_builds_game_tasks_asked_by")),
        sa.ForeignKeyConstraint(["assignee_id"], ["accounts_people.id"], name=op.f("fk_builds_game_tasks_assignee_id")),
        sa.ForeignKeyConstraint(["audit_id"], ["builds_audits.id"], name=op.f("fk_builds_game_tasks_audit_id")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_builds_game_tasks_cue_id")),
        sa.ForeignKeyConstraint(["done_by"], ["accounts_people.id"], name=op.f("fk_builds_game_tasks_done_by")),
        sa.ForeignKeyConstraint(["note_id"], ["builds_listening_notes.id"], name=op.f("fk_builds_game_tasks_note_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_builds_game_tasks_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_game_tasks_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_builds_game_tasks")),
        sa.UniqueConstraint("note_id", name=op.f("uq_builds_game_tasks_note_id")),
    )
    op.create_index("ix_builds_game_tasks_project", "builds_game_tasks", ["project_id", "done_at", "id"])
    op.create_index(op.f("ix_builds_game_tasks_studio_id"), "builds_game_tasks", ["studio_id"])
    op.create_table(
        "builds_packed_files",
        sa.Column("pack_id", sa.Uuid(), nullable=False),
        sa.Column("place", sa.Integer(), nullable=False),
        sa.Column("path", sa.String(), nullable=False),
        sa.Column("kind", sa.Enum("game", "placeholder", "master", "key", name="filekind", native_enum=False, length=32), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("size_bytes", sa.BigInteger(), nullable=False),
        sa.Column("pcm_sha256", sa.String()),
        sa.Column("render_id", sa.Uuid()),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["pack_id"], ["builds_packs.id"], name=op.f("fk_builds_packed_files_pack_id")),
        sa.ForeignKeyConstraint(["render_id"], ["renders_renders.id"], name=op.f("fk_builds_packed_files_render_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_builds_packed_files_studio_id")),
        sa.PrimaryKeyConstraint("pack_id", "place", name=op.f("pk_builds_packed_files")),
        sa.UniqueConstraint("pack_id", "path", name=op.f("uq_builds_packed_files_pack_id_path")),
    )
    op.create_index("ix_builds_packed_files_keys", "builds_packed_files", ["studio_id", "sha256", "size_bytes"], sqlite_where=sa.text("kind = 'key'"), postgresql_where=sa.text("kind = 'key'"))
    op.create_index(op.f("ix_builds_packed_files_studio_id"), "builds_packed_files", ["studio_id"])
    op.create_table(
        "conformance_split_parts",
        sa.Column("split_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("first_frame", sa.BigInteger(), nullable=False),
        sa.Column("end_frame", sa.BigInteger(), nullable=False),
        sa.Column("label", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("part_bytes", sa.BigInteger(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.CheckConstraint("first_frame < end_frame", name=op.f("ck_conformance_split_parts_holds_frames")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_conformance_split_parts_project_id")),
        sa.ForeignKeyConstraint(["split_id"], ["conformance_splits.id"], name=op.f("fk_conformance_split_parts_split_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_conformance_split_parts_studio_id")),
        sa.PrimaryKeyConstraint("split_id", "number", name=op.f("pk_conformance_split_parts")),
    )
    op.create_index(op.f("ix_conformance_split_parts_project_id"), "conformance_split_parts", ["project_id"])
    op.create_index(op.f("ix_conformance_split_parts_sha256"), "conformance_split_parts", ["sha256"])
    op.create_index(op.f("ix_conformance_split_parts_studio_id"), "conformance_split_parts", ["studio_id"])
    op.create_table(
        "conformance_waivers",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("check_run_id", sa.Uuid(), nullable=False),
        sa.Column("master_sha256", sa.String(), nullable=False),
        sa.Column("codes", JSON, nullable=False),
        sa.Column("reason", sa.String(), nullable=False),
        sa.Column("waived_by", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["check_run_id"], ["conformance_check_runs.id"], name=op.f("fk_conformance_waivers_check_run_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_conformance_waivers_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_conformance_waivers_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_conformance_waivers_take_id")),
        sa.ForeignKeyConstraint(["waived_by"], ["accounts_people.id"], name=op.f("fk_conformance_waivers_waived_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_conformance_waivers")),
    )
    op.create_index(op.f("ix_conformance_waivers_project_id"), "conformance_waivers", ["project_id"])
    op.create_index(op.f("ix_conformance_waivers_studio_id"), "conformance_waivers", ["studio_id"])
    op.create_index(op.f("ix_conformance_waivers_take_id"), "conformance_waivers", ["take_id"])
    op.create_table(
        "contracts_ledger_lines",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("kind", sa.Enum("deposit", "accepted", "held_back", "cut", "extra_round", "worked_day", "worked_hours", "retainer", "extra_work", "late_interest", "bonus", "tax", "reversed", "paid", "refunded", name="linekind", native_enum=False, length=32), nullable=False),
        sa.Column("amount_minor", sa.BigInteger(), nullable=False),
        sa.Column("clause", sa.String(), nullable=False),
        sa.Column("cue_id", sa.Uuid()),
        sa.Column("milestone_id", sa.Uuid()),
        sa.Column("about_id", sa.Uuid()),
        sa.Column("round_number", sa.Integer()),
        sa.Column("tax_bp", sa.Integer()),
        sa.Column("payment_id", sa.Uuid()),
        sa.Column("late_invoice_id", sa.Uuid()),
        sa.Column("late_until_on", sa.Date()),
        sa.Column("worked_day_id", sa.Uuid()),
        sa.Column("month_number", sa.Integer()),
        sa.Column("person_id", sa.Uuid()),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(kind = 'retainer') = (month_number is not null)", name=op.f("ck_contracts_ledger_lines_months_are_numbered")),
        sa.CheckConstraint("(kind = 'worked_hours') = (worked_day_id is not null)", name=op.f("ck_contracts_ledger_lines_hours_are_named")),
        sa.CheckConstraint("(kind in ('paid', 'refunded')) = (payment_id is not null)", name=op.f("ck_contracts_ledger_lines_payments_are_named")),
        sa.CheckConstraint("(kind in ('reversed', 'paid', 'refunded')) = (about_id is not null)", name=op.f("ck_contracts_ledger_lines_about_a_line")),
        sa.CheckConstraint("cue_id is not null or milestone_id is not null or tax_bp is not null or late_invoice_id is not null or kind in ('bonus', 'worked_day', 'worked_hours', 'retainer') or about_id is not null", name=op.f("ck_contracts_ledger_lines_about_something")),
        sa.CheckConstraint("(late_invoice_id is null) = (late_until_on is null)", name=op.f("ck_contracts_ledger_lines_late_until_a_day")),
        sa.CheckConstraint("amount_minor <> 0", name=op.f("ck_contracts_ledger_lines_not_nothing")),
        sa.ForeignKeyConstraint(["about_id"], ["contracts_ledger_lines.id"], name=op.f("fk_contracts_ledger_lines_about_id")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name=op.f("fk_contracts_ledger_lines_contract_id")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name=op.f("fk_contracts_ledger_lines_cue_id")),
        sa.ForeignKeyConstraint(["late_invoice_id"], ["contracts_invoices.id"], name=op.f("fk_contracts_ledger_lines_late_invoice_id")),
        sa.ForeignKeyConstraint(["milestone_id"], ["contracts_milestones.id"], name=op.f("fk_contracts_ledger_lines_milestone_id")),
        sa.ForeignKeyConstraint(["payment_id"], ["contracts_payments.id"], name=op.f("fk_contracts_ledger_lines_payment_id")),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_contracts_ledger_lines_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_ledger_lines_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_ledger_lines_studio_id")),
        sa.ForeignKeyConstraint(["worked_day_id"], ["contracts_worked_days.id"], name=op.f("fk_contracts_ledger_lines_worked_day_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_contracts_ledger_lines")),
    )
    op.create_index(op.f("ix_contracts_ledger_lines_contract_id"), "contracts_ledger_lines", ["contract_id"])
    op.create_index(op.f("ix_contracts_ledger_lines_project_id"), "contracts_ledger_lines", ["project_id"])
    op.create_index(op.f("ix_contracts_ledger_lines_studio_id"), "contracts_ledger_lines", ["studio_id"])
    op.create_index("uq_contracts_ledger_lines_hours", "contracts_ledger_lines", ["worked_day_id"], unique=True, sqlite_where=sa.text("kind = 'worked_hours'"), postgresql_where=sa.text("kind = 'worked_hours'"))
    op.create_index("uq_contracts_ledger_lines_month", "contracts_ledger_lines", ["contract_id", "month_number"], unique=True, sqlite_where=sa.text("kind = 'retainer'"), postgresql_where=sa.text("kind = 'retainer'"))
    op.create_index("uq_contracts_ledger_lines_reversed", "contracts_ledger_lines", ["about_id"], unique=True, sqlite_where=sa.text("kind = 'reversed'"), postgresql_where=sa.text("kind = 'reversed'"))
    op.create_index("uq_contracts_ledger_lines_round", "contracts_ledger_lines", ["contract_id", "cue_id", "round_number"], unique=True, sqlite_where=sa.text("kind = 'extra_round'"), postgresql_where=sa.text("kind = 'extra_round'"))
    op.create_table(
        "reviews_comments",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("reply_to_id", sa.Uuid()),
        sa.Column("change_request_id", sa.Uuid()),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("start_s", sa.Double()),
        sa.Column("end_s", sa.Double()),
        sa.Column("written_by", sa.Uuid()),
        sa.Column("guest_name", sa.String()),
        sa.Column("decides", sa.Boolean(), nullable=False),
        sa.Column("resolved_at", sa.DateTime(timezone=True)),
        sa.Column("resolved_by", sa.Uuid()),
        sa.Column("mentions", JSON, nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(written_by is null) <> (guest_name is null)", name=op.f("ck_reviews_comments_by_a_person_or_guest")),
        sa.ForeignKeyConstraint(["change_request_id"], ["reviews_change_requests.id"], name=op.f("fk_reviews_comments_change_request_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_reviews_comments_project_id")),
        sa.ForeignKeyConstraint(["reply_to_id"], ["reviews_comments.id"], name=op.f("fk_reviews_comments_reply_to_id")),
        sa.ForeignKeyConstraint(["resolved_by"], ["accounts_people.id"], name=op.f("fk_reviews_comments_resolved_by")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_reviews_comments_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_reviews_comments_take_id")),
        sa.ForeignKeyConstraint(["written_by"], ["accounts_people.id"], name=op.f("fk_reviews_comments_written_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_reviews_comments")),
    )
    op.create_index(op.f("ix_reviews_comments_change_request_id"), "reviews_comments", ["change_request_id"])
    op.create_index("ix_reviews_comments_project_id_id", "reviews_comments", ["project_id", "id"])
    op.create_index(op.f("ix_reviews_comments_reply_to_id"), "reviews_comments", ["reply_to_id"])
    op.create_index(op.f("ix_reviews_comments_studio_id"), "reviews_comments", ["studio_id"])
    op.create_index(op.f("ix_reviews_comments_take_id"), "reviews_comments", ["take_id"])
    op.create_table(
        "reviews_given_reasons",
        sa.Column("verdict_id", sa.Uuid(), nullable=False),
        sa.Column("reason", sa.String(), nullable=False),
        sa.Column("kind", sa.Enum("change", "pick", "label", name="reasonkind", native_enum=False, length=32), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column("change_request_id", sa.Uuid()),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["change_request_id"], ["reviews_change_requests.id"], name=op.f("fk_reviews_given_reasons_change_request_id")),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name=op.f("fk_reviews_given_reasons_designer_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_reviews_given_reasons_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_reviews_given_reasons_studio_id")),
        sa.ForeignKeyConstraint(["verdict_id"], ["reviews_verdicts.id"], name=op.f("fk_reviews_given_reasons_verdict_id")),
        sa.PrimaryKeyConstraint("verdict_id", "reason", name=op.f("pk_reviews_given_reasons")),
    )
    op.create_index("ix_reviews_given_reasons_counted", "reviews_given_reasons", ["project_id", "designer_id", "kind", "reason", "cue_id", "studio_id"])
    op.create_index("ix_reviews_given_reasons_found", "reviews_given_reasons", ["project_id", "kind", "reason", "verdict_id"])
    op.create_index("ix_reviews_given_reasons_of_cues", "reviews_given_reasons", ["project_id", "cue_id", "designer_id", "kind", "reason", "studio_id"])
    op.create_index(op.f("ix_reviews_given_reasons_studio_id"), "reviews_given_reasons", ["studio_id"])
    op.create_table(
        "contracts_invoice_lines",
        sa.Column("ledger_line_id", sa.Uuid(), nullable=False),
        sa.Column("invoice_id", sa.Uuid(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.ForeignKeyConstraint(["invoice_id"], ["contracts_invoices.id"], name=op.f("fk_contracts_invoice_lines_invoice_id")),
        sa.ForeignKeyConstraint(["ledger_line_id"], ["contracts_ledger_lines.id"], name=op.f("fk_contracts_invoice_lines_ledger_line_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_contracts_invoice_lines_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_contracts_invoice_lines_studio_id")),
        sa.PrimaryKeyConstraint("ledger_line_id", name=op.f("pk_contracts_invoice_lines")),
    )
    op.create_index(op.f("ix_contracts_invoice_lines_invoice_id"), "contracts_invoice_lines", ["invoice_id"])
    op.create_index(op.f("ix_contracts_invoice_lines_project_id"), "contracts_invoice_lines", ["project_id"])
    op.create_index(op.f("ix_contracts_invoice_lines_studio_id"), "contracts_invoice_lines", ["studio_id"])
    op.create_table(
        "reviews_acknowledgements",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("comment_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["comment_id"], ["reviews_comments.id"], name=op.f("fk_reviews_acknowledgements_comment_id")),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name=op.f("fk_reviews_acknowledgements_person_id")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_reviews_acknowledgements_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_reviews_acknowledgements_studio_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_reviews_acknowledgements")),
        sa.UniqueConstraint("comment_id", "person_id", name=op.f("uq_reviews_acknowledgements_comment_id_person_id")),
    )
    op.create_index(op.f("ix_reviews_acknowledgements_project_id"), "reviews_acknowledgements", ["project_id"])
    op.create_index(op.f("ix_reviews_acknowledgements_studio_id"), "reviews_acknowledgements", ["studio_id"])
    op.create_table(
        "reviews_note_answers",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("comment_id", sa.Uuid()),
        sa.Column("change_request_id", sa.Uuid()),
        sa.Column("is_done", sa.Boolean(), nullable=False),
        sa.Column("given_by", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(comment_id is null) <> (change_request_id is null)", name=op.f("ck_reviews_note_answers_one_note")),
        sa.ForeignKeyConstraint(["change_request_id"], ["reviews_change_requests.id"], name=op.f("fk_reviews_note_answers_change_request_id")),
        sa.ForeignKeyConstraint(["comment_id"], ["reviews_comments.id"], name=op.f("fk_reviews_note_answers_comment_id")),
        sa.ForeignKeyConstraint(["given_by"], ["accounts_people.id"], name=op.f("fk_reviews_note_answers_given_by")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name=op.f("fk_reviews_note_answers_project_id")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_reviews_note_answers_studio_id")),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f("fk_reviews_note_answers_take_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_reviews_note_answers")),
    )
    op.create_index("ix_reviews_note_answers_change_request_id", "reviews_note_answers", ["change_request_id", "id"])
    op.create_index("ix_reviews_note_answers_comment_id", "reviews_note_answers", ["comment_id", "id"])
    op.create_index(op.f("ix_reviews_note_answers_project_id"), "reviews_note_answers", ["project_id"])
    op.create_index(op.f("ix_reviews_note_answers_studio_id"), "reviews_note_answers", ["studio_id"])
    op.create_index(op.f("ix_reviews_note_answers_take_id"), "reviews_note_answers", ["take_id"])
