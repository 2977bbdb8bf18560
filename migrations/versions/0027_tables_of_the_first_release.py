"""Every table of the first release.

Earlier revisions of this history are folded into this one. It keeps the number of the last of them, so a database that
was brought up to date before needs nothing.
"""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects import postgresql

revision = "0027"
down_revision = None
branch_labels = None
depends_on = None

JSON = sa.JSON().with_variant(postgresql.JSONB(), "postgresql")


def upgrade() -> None:
    op.create_table(
        "accounts_people",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("email", sa.String(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("password_hash", sa.String()),
        sa.Column("demo_part", sa.String()),
        sa.Column("email_verified_at", sa.DateTime(timezone=True)),
        sa.Column("email_proof", sa.Enum("mail", "operator", name="addressproof", native_enum=False, length=32)),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint(
            "(email_verified_at is null) = (email_proof is null)", name=op.f("ck_accounts_people_verified_somehow")
        ),
        sa.CheckConstraint("email = lower(email)", name=op.f("ck_accounts_people_email_lower_case")),
        sa.PrimaryKeyConstraint("id", name="pk_accounts_people"),
        sa.UniqueConstraint("demo_part", name="uq_accounts_people_demo_part"),
        sa.UniqueConstraint("email", name="uq_accounts_people_email"),
    )
    op.create_table(
        "accounts_rate_limits",
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("free_at_s", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("key", name="pk_accounts_rate_limits"),
    )
    op.create_index("ix_accounts_rate_limits_free_at_s", "accounts_rate_limits", ["free_at_s"])
    op.create_table(
        "accounts_sign_ups",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("email", sa.String(), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("used_at", sa.DateTime(timezone=True)),
        sa.Column("secret_sha256", sa.String()),
        sa.Column("is_sent_by_mail_only", sa.Boolean(), nullable=False),
        sa.PrimaryKeyConstraint("id", name="pk_accounts_sign_ups"),
        sa.UniqueConstraint("secret_sha256", name="uq_accounts_sign_ups_secret_sha256"),
    )
    op.create_index("ix_accounts_sign_ups_email", "accounts_sign_ups", ["email"])
    op.create_table(
        "accounts_studios",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("is_demo", sa.Boolean(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.PrimaryKeyConstraint("id", name="pk_accounts_studios"),
    )
    op.create_table(
        "kit_changed_rooms",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid()),
        sa.Column("rooms", JSON, nullable=False),
        sa.PrimaryKeyConstraint("id", name="pk_kit_changed_rooms"),
    )
    op.create_table(
        "kit_heartbeats",
        sa.Column("worker_id", sa.String(), nullable=False),
        sa.Column("beat_at", sa.DateTime(timezone=True), nullable=False),
        sa.PrimaryKeyConstraint("worker_id", name="pk_kit_heartbeats"),
    )
    op.create_table(
        "kit_saved_responses",
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("request_sha256", sa.String(), nullable=False),
        sa.Column("status", sa.Integer()),
        sa.Column("media_type", sa.String()),
        sa.Column("body", sa.String()),
        sa.Column("rights", sa.String()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.PrimaryKeyConstraint("key", name="pk_kit_saved_responses"),
    )
    op.create_index("ix_kit_saved_responses_created_at", "kit_saved_responses", ["created_at"])
    op.create_table(
        "kit_uploads",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("owner_id", sa.Uuid(), nullable=False),
        sa.Column("scope", sa.String(), nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("length", sa.BigInteger(), nullable=False),
        sa.Column("expected_sha256", sa.String()),
        sa.Column("sha256", sa.String()),
        sa.Column("multipart_id", sa.String()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("finished_at", sa.DateTime(timezone=True)),
        sa.CheckConstraint("(sha256 is null) = (finished_at is null)", name=op.f("ck_kit_uploads_finished_is_hashed")),
        sa.CheckConstraint("length >= 0", name=op.f("ck_kit_uploads_length_known")),
        sa.PrimaryKeyConstraint("id", name="pk_kit_uploads"),
    )
    op.create_index("ix_kit_uploads_studio_id", "kit_uploads", ["studio_id"])
    op.create_table(
        "accounts_email_verifications",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("used_at", sa.DateTime(timezone=True)),
        sa.Column("secret_sha256", sa.String()),
        sa.Column("is_sent_by_mail_only", sa.Boolean(), nullable=False),
        sa.ForeignKeyConstraint(
            ["person_id"], ["accounts_people.id"], name="fk_accounts_email_verifications_person_id"
        ),
        sa.PrimaryKeyConstraint("id", name="pk_accounts_email_verifications"),
        sa.UniqueConstraint("secret_sha256", name="uq_accounts_email_verifications_secret_sha256"),
    )
    op.create_index("ix_accounts_email_verifications_person_id", "accounts_email_verifications", ["person_id"])
    op.create_table(
        "accounts_memberships",
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("roles", JSON, nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name="fk_accounts_memberships_person_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_accounts_memberships_studio_id"),
        sa.PrimaryKeyConstraint("studio_id", "person_id", name="pk_accounts_memberships"),
    )
    op.create_index("ix_accounts_memberships_person_id", "accounts_memberships", ["person_id"])
    op.create_table(
        "accounts_operators",
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("named_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name="fk_accounts_operators_person_id"),
        sa.PrimaryKeyConstraint("person_id", name="pk_accounts_operators"),
    )
    op.create_table(
        "accounts_password_resets",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("used_at", sa.DateTime(timezone=True)),
        sa.Column("secret_sha256", sa.String()),
        sa.Column("is_sent_by_mail_only", sa.Boolean(), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name="fk_accounts_password_resets_person_id"),
        sa.PrimaryKeyConstraint("id", name="pk_accounts_password_resets"),
        sa.UniqueConstraint("secret_sha256", name="uq_accounts_password_resets_secret_sha256"),
    )
    op.create_index("ix_accounts_password_resets_person_id", "accounts_password_resets", ["person_id"])
    op.create_table(
        "accounts_quotas",
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("kind", sa.String(), nullable=False),
        sa.Column("maximum", sa.BigInteger(), nullable=False),
        sa.CheckConstraint("maximum >= 0", name=op.f("ck_accounts_quotas_maximum_known")),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_accounts_quotas_studio_id"),
        sa.PrimaryKeyConstraint("studio_id", "kind", name="pk_accounts_quotas"),
    )
    op.create_table(
        "accounts_sign_ins",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("secret_sha256", sa.String(), nullable=False),
        sa.Column("device", sa.String(), nullable=False),
        sa.Column("place", sa.String(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("last_seen_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name="fk_accounts_sign_ins_person_id"),
        sa.PrimaryKeyConstraint("id", name="pk_accounts_sign_ins"),
        sa.UniqueConstraint("secret_sha256", name="uq_accounts_sign_ins_secret_sha256"),
    )
    op.create_index("ix_accounts_sign_ins_person_id", "accounts_sign_ins", ["person_id"])
    op.create_table(
        "accounts_studio_invitations",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("email", sa.String(), nullable=False),
        sa.Column("roles", JSON, nullable=False),
        sa.Column("approves_project_id", sa.Uuid()),
        sa.Column("invited_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("accepted_at", sa.DateTime(timezone=True)),
        sa.Column("accepted_by", sa.Uuid()),
        sa.Column("revoked_at", sa.DateTime(timezone=True)),
        sa.Column("secret_sha256", sa.String()),
        sa.Column("is_sent_by_mail_only", sa.Boolean(), nullable=False),
        sa.ForeignKeyConstraint(
            ["accepted_by"], ["accounts_people.id"], name="fk_accounts_studio_invitations_accepted_by"
        ),
        sa.ForeignKeyConstraint(
            ["invited_by"], ["accounts_people.id"], name="fk_accounts_studio_invitations_invited_by"
        ),
        sa.ForeignKeyConstraint(
            ["studio_id"], ["accounts_studios.id"], name="fk_accounts_studio_invitations_studio_id"
        ),
        sa.PrimaryKeyConstraint("id", name="pk_accounts_studio_invitations"),
        sa.UniqueConstraint("secret_sha256", name="uq_accounts_studio_invitations_secret_sha256"),
    )
    op.create_index("ix_accounts_studio_invitations_studio_id", "accounts_studio_invitations", ["studio_id"])
    op.create_table(
        "accounts_tokens",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("secret_sha256", sa.String(), nullable=False),
        sa.Column("scopes", JSON, nullable=False),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("last_used_at", sa.DateTime(timezone=True)),
        sa.Column("revoked_at", sa.DateTime(timezone=True)),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name="fk_accounts_tokens_created_by"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_accounts_tokens_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_accounts_tokens"),
        sa.UniqueConstraint("secret_sha256", name="uq_accounts_tokens_secret_sha256"),
    )
    op.create_index("ix_accounts_tokens_project_id", "accounts_tokens", ["project_id"])
    op.create_index("ix_accounts_tokens_studio_id", "accounts_tokens", ["studio_id"])
    op.create_table(
        "builds_fingerprints",
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("sound_sha256", sa.String(), nullable=False),
        sa.Column("fingerprint_version", sa.Integer(), nullable=False),
        sa.Column("entry", JSON, nullable=False),
        sa.Column("fingerprinted_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_builds_fingerprints_studio_id"),
        sa.PrimaryKeyConstraint("studio_id", "sound_sha256", name="pk_builds_fingerprints"),
    )
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
        sa.Column("clauses", JSON, nullable=False),
        sa.Column("terms", JSON, nullable=False),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("changed_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name="fk_contracts_templates_created_by"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_contracts_templates_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_contracts_templates"),
        sa.UniqueConstraint("studio_id", "name", name="uq_contracts_templates_studio_id_name"),
    )
    op.create_index("ix_contracts_templates_studio_id", "contracts_templates", ["studio_id"])
    op.create_table(
        "notifications_mails",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid()),
        sa.Column("topic", sa.String(), nullable=False),
        sa.Column("recipient", sa.String(), nullable=False),
        sa.Column("subject", sa.String(), nullable=False),
        sa.Column("lines", JSON, nullable=False),
        sa.Column("event_ids", JSON, nullable=False),
        sa.Column("link", sa.String()),
        sa.Column("secret_of", sa.String()),
        sa.Column("secret_of_id", sa.Uuid()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("sealed_at", sa.DateTime(timezone=True)),
        sa.Column("claimed_until", sa.DateTime(timezone=True)),
        sa.Column("sent_at", sa.DateTime(timezone=True)),
        sa.Column("failure", sa.String()),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_notifications_mails_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_notifications_mails"),
    )
    op.create_index("ix_notifications_mails_studio_id", "notifications_mails", ["studio_id"])
    op.create_index(
        "uq_notifications_mails_open",
        "notifications_mails",
        ["topic", "recipient"],
        unique=True,
        sqlite_where=sa.text("sealed_at is null"),
        postgresql_where=sa.text("sealed_at is null"),
    )
    op.create_table(
        "projects_projects",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("description", sa.String(), nullable=False),
        sa.Column("cue_prefix", sa.String(), nullable=False),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("archived_at", sa.DateTime(timezone=True)),
        sa.Column("nda_needed", sa.Boolean(), nullable=False),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name="fk_projects_projects_created_by"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_projects_projects_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_projects_projects"),
    )
    op.create_index("ix_projects_projects_studio_id", "projects_projects", ["studio_id"])
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
        sa.Column("drawn_bytes", sa.BigInteger()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_renders_pictures_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_renders_pictures"),
        sa.UniqueConstraint("studio_id", "sound_sha256", name="uq_renders_pictures_studio_id_sound_sha256"),
    )
    op.create_index("ix_renders_pictures_kept", "renders_pictures", ["studio_id", "drawn_bytes"])
    op.create_index("ix_renders_pictures_sound_sha256", "renders_pictures", ["sound_sha256"])
    op.create_table(
        "renders_timbres",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("sound_sha256", sa.String(), nullable=False),
        sa.Column("timbre", JSON, nullable=False),
        sa.Column("bands_db", JSON, nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_renders_timbres_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_renders_timbres"),
        sa.UniqueConstraint("studio_id", "sound_sha256", name="uq_renders_timbres_studio_id_sound_sha256"),
    )
    op.create_index("ix_renders_timbres_studio_id", "renders_timbres", ["studio_id"])
    op.create_table(
        "builds_builds",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("label", sa.String(), nullable=False),
        sa.Column("commit", sa.String(), nullable=False),
        sa.Column("target", sa.String(), nullable=False),
        sa.Column("files", sa.Integer(), nullable=False),
        sa.Column("rejected", sa.Integer(), nullable=False),
        sa.Column("warnings", sa.Integer(), nullable=False),
        sa.Column("report", JSON, nullable=False),
        sa.Column("token_id", sa.Uuid()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_builds_builds_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_builds_builds_studio_id"),
        sa.ForeignKeyConstraint(["token_id"], ["accounts_tokens.id"], name="fk_builds_builds_token_id"),
        sa.PrimaryKeyConstraint("id", name="pk_builds_builds"),
    )
    op.create_index("ix_builds_builds_project_id", "builds_builds", ["project_id"])
    op.create_index("ix_builds_builds_studio_id", "builds_builds", ["studio_id"])
    op.create_table(
        "builds_packs",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("target", sa.String(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("with_masters", sa.Boolean(), nullable=False),
        sa.Column("allow_missing", sa.Boolean(), nullable=False),
        sa.Column("placeholders", sa.Boolean(), nullable=False),
        sa.Column(
            "state",
            sa.Enum("sealing", "sealed", "refused", name="packstate", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("refusal", sa.String(), nullable=False),
        sa.Column("sealed_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("sealed_at", sa.DateTime(timezone=True)),
        sa.CheckConstraint(
            "(state = 'sealed') = (sealed_at is not null)", name=op.f("ck_builds_packs_sealed_is_dated")
        ),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_builds_packs_project_id"),
        sa.ForeignKeyConstraint(["sealed_by"], ["accounts_people.id"], name="fk_builds_packs_sealed_by"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_builds_packs_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_builds_packs"),
        sa.UniqueConstraint("project_id", "target", "number", name="uq_builds_packs_project_id_target_number"),
    )
    op.create_index("ix_builds_packs_studio_id", "builds_packs", ["studio_id"])
    op.create_table(
        "contracts_calendar_links",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("secret_sha256", sa.String(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("revoked_at", sa.DateTime(timezone=True)),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name="fk_contracts_calendar_links_person_id"),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name="fk_contracts_calendar_links_project_id"
        ),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_contracts_calendar_links_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_contracts_calendar_links"),
        sa.UniqueConstraint("secret_sha256", name="uq_contracts_calendar_links_secret_sha256"),
    )
    op.create_index("ix_contracts_calendar_links_person_id", "contracts_calendar_links", ["person_id"])
    op.create_index("ix_contracts_calendar_links_project_id", "contracts_calendar_links", ["project_id"])
    op.create_index("ix_contracts_calendar_links_studio_id", "contracts_calendar_links", ["studio_id"])
    op.create_table(
        "deliveries_deliveries",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("closed_at", sa.DateTime(timezone=True)),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name="fk_deliveries_deliveries_designer_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_deliveries_deliveries_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_deliveries_deliveries_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_deliveries_deliveries"),
        sa.UniqueConstraint("project_id", "number", name="uq_deliveries_deliveries_project_id_number"),
    )
    op.create_index("ix_deliveries_deliveries_designer_id", "deliveries_deliveries", ["designer_id"])
    op.create_index("ix_deliveries_deliveries_project_id", "deliveries_deliveries", ["project_id"])
    op.create_index("ix_deliveries_deliveries_studio_id", "deliveries_deliveries", ["studio_id"])
    op.create_table(
        "deliveries_takes_acts",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column(
            "kind",
            sa.Enum("matched", "moved", "discarded", "restored", name="takesactkind", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("done_by", sa.Uuid(), nullable=False),
        sa.Column("done_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("undone_at", sa.DateTime(timezone=True)),
        sa.Column("takes", JSON, nullable=False),
        sa.ForeignKeyConstraint(["done_by"], ["accounts_people.id"], name="fk_deliveries_takes_acts_done_by"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_deliveries_takes_acts_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_deliveries_takes_acts_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_deliveries_takes_acts"),
    )
    op.create_index("ix_deliveries_takes_acts_project", "deliveries_takes_acts", ["project_id", "id"])
    op.create_table(
        "projects_approver_changes",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("reason", sa.String(), nullable=False),
        sa.Column("changed_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["changed_by"], ["accounts_people.id"], name="fk_projects_approver_changes_changed_by"),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name="fk_projects_approver_changes_person_id"),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name="fk_projects_approver_changes_project_id"
        ),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_projects_approver_changes_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_projects_approver_changes"),
    )
    op.create_index("ix_projects_approver_changes_project_id", "projects_approver_changes", ["project_id"])
    op.create_index("ix_projects_approver_changes_studio_id", "projects_approver_changes", ["studio_id"])
    op.create_table(
        "projects_engagements",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column(
            "kind",
            sa.Enum("advisory", "contract", "in-house", name="engagementkind", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("ended_at", sa.DateTime(timezone=True)),
        sa.Column("nda_sha256", sa.String()),
        sa.Column("nda_accepted_at", sa.DateTime(timezone=True)),
        sa.CheckConstraint(
            "(nda_sha256 is null) = (nda_accepted_at is null)", name=op.f("ck_projects_engagements_nda_is_dated")
        ),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name="fk_projects_engagements_designer_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_projects_engagements_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_projects_engagements_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_projects_engagements"),
        sa.UniqueConstraint("project_id", "designer_id", name="uq_projects_engagements_project_id_designer_id"),
    )
    op.create_index("ix_projects_engagements_designer_id", "projects_engagements", ["designer_id"])
    op.create_index("ix_projects_engagements_project_id", "projects_engagements", ["project_id"])
    op.create_index("ix_projects_engagements_studio_id", "projects_engagements", ["studio_id"])
    op.create_table(
        "projects_invitations",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("email", sa.String(), nullable=False),
        sa.Column(
            "kind",
            sa.Enum("advisory", "contract", "in-house", name="engagementkind", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("invited_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("accepted_at", sa.DateTime(timezone=True)),
        sa.Column("accepted_by", sa.Uuid()),
        sa.Column("revoked_at", sa.DateTime(timezone=True)),
        sa.Column("secret_sha256", sa.String()),
        sa.Column("is_sent_by_mail_only", sa.Boolean(), nullable=False),
        sa.ForeignKeyConstraint(["accepted_by"], ["accounts_people.id"], name="fk_projects_invitations_accepted_by"),
        sa.ForeignKeyConstraint(["invited_by"], ["accounts_people.id"], name="fk_projects_invitations_invited_by"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_projects_invitations_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_projects_invitations_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_projects_invitations"),
        sa.UniqueConstraint("secret_sha256", name="uq_projects_invitations_secret_sha256"),
    )
    op.create_index("ix_projects_invitations_project_id", "projects_invitations", ["project_id"])
    op.create_index("ix_projects_invitations_studio_id", "projects_invitations", ["studio_id"])
    op.create_table(
        "projects_liaisons",
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name="fk_projects_liaisons_person_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_projects_liaisons_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_projects_liaisons_studio_id"),
        sa.PrimaryKeyConstraint("project_id", "person_id", name="pk_projects_liaisons"),
    )
    op.create_index("ix_projects_liaisons_studio_id", "projects_liaisons", ["studio_id"])
    op.create_table(
        "projects_specs",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("toml", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name="fk_projects_specs_created_by"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_projects_specs_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_projects_specs_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_projects_specs"),
        sa.UniqueConstraint("project_id", "version", name="uq_projects_specs_project_id_version"),
    )
    op.create_index("ix_projects_specs_project_id", "projects_specs", ["project_id"])
    op.create_index("ix_projects_specs_studio_id", "projects_specs", ["studio_id"])
    op.create_table(
        "reviews_feedback",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("sent_by", sa.Uuid(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_reviews_feedback_project_id"),
        sa.ForeignKeyConstraint(["sent_by"], ["accounts_people.id"], name="fk_reviews_feedback_sent_by"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_reviews_feedback_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_reviews_feedback"),
    )
    op.create_index("ix_reviews_feedback_project_id", "reviews_feedback", ["project_id"])
    op.create_index("ix_reviews_feedback_studio_id", "reviews_feedback", ["studio_id"])
    op.create_table(
        "sound_lists_cues",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
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
        sa.Column("length_locked", sa.Boolean(), nullable=False),
        sa.Column("frame_rate_fps", sa.Double()),
        sa.Column("loop", sa.Boolean(), nullable=False),
        sa.Column(
            "reverb", sa.Enum("dry", "designed-tail", "separate-tail", name="reverb", native_enum=False, length=32)
        ),
        sa.Column("variations", sa.Integer(), nullable=False),
        sa.Column(
            "state",
            sa.Enum("concept", "prototype", "locked", "cut", name="cuestate", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("playback_priority", sa.Integer()),
        sa.Column("placeholder", sa.Boolean(), nullable=False),
        sa.Column("palette", sa.Boolean(), nullable=False),
        sa.Column("extra", JSON, nullable=False),
        sa.Column("edition", sa.Integer(), nullable=False),
        sa.Column("cut_reason", sa.String()),
        sa.Column("cut_at", sa.DateTime(timezone=True)),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("(state = 'cut') = (cut_at is not null)", name=op.f("ck_sound_lists_cues_cut_is_dated")),
        sa.CheckConstraint("duration_s is null or duration_s > 0", name=op.f("ck_sound_lists_cues_duration_positive")),
        sa.CheckConstraint("variations between 1 and 99", name=op.f("ck_sound_lists_cues_variations_in_range")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_sound_lists_cues_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_sound_lists_cues_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_sound_lists_cues"),
        sa.UniqueConstraint("project_id", "number", name="uq_sound_lists_cues_project_id_number"),
    )
    op.create_index(
        "ix_sound_lists_cues_counted", "sound_lists_cues", ["state", "project_id", "variations", "placeholder"]
    )
    op.create_index("ix_sound_lists_cues_order", "sound_lists_cues", ["project_id", "position", "number"])
    op.create_index(
        "ix_sound_lists_cues_palette",
        "sound_lists_cues",
        ["project_id", "position", "number"],
        sqlite_where=sa.text("palette = 1"),
        postgresql_where=sa.text("palette"),
    )
    op.create_index("ix_sound_lists_cues_studio_id", "sound_lists_cues", ["studio_id"])
    op.create_index(
        "uq_sound_lists_cues_summed", "sound_lists_cues", ["id", "state", "variations", "placeholder"], unique=True
    )
    op.create_table(
        "sound_lists_revisions",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("summary", sa.String(), nullable=False),
        sa.Column("changed_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["changed_by"], ["accounts_people.id"], name="fk_sound_lists_revisions_changed_by"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_sound_lists_revisions_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_sound_lists_revisions_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_sound_lists_revisions"),
        sa.UniqueConstraint("project_id", "number", name="uq_sound_lists_revisions_project_id_number"),
    )
    op.create_index("ix_sound_lists_revisions_project_id", "sound_lists_revisions", ["project_id"])
    op.create_index("ix_sound_lists_revisions_studio_id", "sound_lists_revisions", ["studio_id"])
    op.create_table(
        "builds_placeholder_files",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("variation", sa.Integer(), nullable=False),
        sa.Column("target", sa.String(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("sha256", sa.String()),
        sa.Column("file_bytes", sa.BigInteger()),
        sa.Column("is_spoken", sa.Boolean(), nullable=False),
        sa.Column("refusal", sa.String()),
        sa.Column("made_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint(
            "(refusal is null) = (sha256 is not null)", name=op.f("ck_builds_placeholder_files_made_or_refused")
        ),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name="fk_builds_placeholder_files_cue_id"),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name="fk_builds_placeholder_files_project_id"
        ),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_builds_placeholder_files_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_builds_placeholder_files"),
        sa.UniqueConstraint(
            "cue_id", "variation", "target", name="uq_builds_placeholder_files_cue_id_variation_target"
        ),
    )
    op.create_index("ix_builds_placeholder_files_project_id", "builds_placeholder_files", ["project_id"])
    op.create_index("ix_builds_placeholder_files_studio_id", "builds_placeholder_files", ["studio_id"])
    op.create_table(
        "contracts_contracts",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("engagement_id", sa.Uuid(), nullable=False),
        sa.Column("designer_id", sa.Uuid(), nullable=False),
        sa.Column("framework_id", sa.Uuid()),
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
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("agreed_at", sa.DateTime(timezone=True)),
        sa.Column("ended_at", sa.DateTime(timezone=True)),
        sa.Column("end_reason", sa.String()),
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
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name="fk_contracts_contracts_created_by"),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name="fk_contracts_contracts_designer_id"),
        sa.ForeignKeyConstraint(
            ["engagement_id"], ["projects_engagements.id"], name="fk_contracts_contracts_engagement_id"
        ),
        sa.ForeignKeyConstraint(
            ["framework_id"], ["contracts_contracts.id"], name="fk_contracts_contracts_framework_id"
        ),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_contracts_contracts_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_contracts_contracts_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_contracts_contracts"),
        sa.UniqueConstraint("project_id", "number", name="uq_contracts_contracts_project_id_number"),
    )
    op.create_index("ix_contracts_contracts_designer_id", "contracts_contracts", ["designer_id"])
    op.create_index("ix_contracts_contracts_engagement_id", "contracts_contracts", ["engagement_id"])
    op.create_index("ix_contracts_contracts_framework_id", "contracts_contracts", ["framework_id"])
    op.create_index("ix_contracts_contracts_studio_id", "contracts_contracts", ["studio_id"])
    op.create_table(
        "deliveries_archives",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("delivery_id", sa.Uuid(), nullable=False),
        sa.Column("upload_id", sa.Uuid(), nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("archive_bytes", sa.BigInteger(), nullable=False),
        sa.Column(
            "state",
            sa.Enum("received", "unpacked", "refused", name="archivestate", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("message", sa.String(), nullable=False),
        sa.Column("entries", JSON, nullable=False),
        sa.Column("received_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(
            ["delivery_id"], ["deliveries_deliveries.id"], name="fk_deliveries_archives_delivery_id"
        ),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_deliveries_archives_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_deliveries_archives_studio_id"),
        sa.ForeignKeyConstraint(["upload_id"], ["kit_uploads.id"], name="fk_deliveries_archives_upload_id"),
        sa.PrimaryKeyConstraint("id", name="pk_deliveries_archives"),
        sa.UniqueConstraint("upload_id", name="uq_deliveries_archives_upload_id"),
    )
    op.create_index("ix_deliveries_archives_delivery_id", "deliveries_archives", ["delivery_id"])
    op.create_index("ix_deliveries_archives_project_id", "deliveries_archives", ["project_id"])
    op.create_index("ix_deliveries_archives_studio_id", "deliveries_archives", ["studio_id"])
    op.create_table(
        "renders_batches",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column(
            "state",
            sa.Enum("planning", "running", "done", "cancelled", name="batchstate", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("spec_id", sa.Uuid()),
        sa.Column("targets", JSON, nullable=False),
        sa.Column("asked_by", sa.Uuid()),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("ended_at", sa.DateTime(timezone=True)),
        sa.CheckConstraint(
            "(ended_at is null) = (state in ('planning', 'running'))", name=op.f("ck_renders_batches_ended_is_dated")
        ),
        sa.ForeignKeyConstraint(["asked_by"], ["accounts_people.id"], name="fk_renders_batches_asked_by"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_renders_batches_project_id"),
        sa.ForeignKeyConstraint(["spec_id"], ["projects_specs.id"], name="fk_renders_batches_spec_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_renders_batches_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_renders_batches"),
        sa.UniqueConstraint("project_id", "number", name="uq_renders_batches_project_id_number"),
    )
    op.create_index("ix_renders_batches_studio_id", "renders_batches", ["studio_id"])
    op.create_table(
        "renders_reels",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
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
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("sha256 is null or refusal is null", name=op.f("ck_renders_reels_made_or_refused")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name="fk_renders_reels_cue_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_renders_reels_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_renders_reels_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_renders_reels"),
        sa.UniqueConstraint("cue_id", "key", name="uq_renders_reels_cue_id_key"),
    )
    op.create_index("ix_renders_reels_project_id", "renders_reels", ["project_id"])
    op.create_index("ix_renders_reels_studio_id", "renders_reels", ["studio_id"])
    op.create_table(
        "reviews_reminders",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("waiting_since", sa.DateTime(timezone=True), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name="fk_reviews_reminders_cue_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_reviews_reminders_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_reviews_reminders_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_reviews_reminders"),
        sa.UniqueConstraint(
            "cue_id", "waiting_since", "number", name="uq_reviews_reminders_cue_id_waiting_since_number"
        ),
    )
    op.create_index("ix_reviews_reminders_project_id", "reviews_reminders", ["project_id"])
    op.create_index("ix_reviews_reminders_studio_id", "reviews_reminders", ["studio_id"])
    op.create_table(
        "reviews_rounds",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("feedback_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer()),
        sa.Column("why_not_counted", sa.String()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint(
            "(number is null) = (why_not_counted is not null)", name=op.f("ck_reviews_rounds_counted_or_why_not")
        ),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name="fk_reviews_rounds_cue_id"),
        sa.ForeignKeyConstraint(["feedback_id"], ["reviews_feedback.id"], name="fk_reviews_rounds_feedback_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_reviews_rounds_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_reviews_rounds_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_reviews_rounds"),
        sa.UniqueConstraint("cue_id", "feedback_id", name="uq_reviews_rounds_cue_id_feedback_id"),
        sa.UniqueConstraint("cue_id", "number", name="uq_reviews_rounds_cue_id_number"),
    )
    op.create_index("ix_reviews_rounds_project_id", "reviews_rounds", ["project_id"])
    op.create_index("ix_reviews_rounds_studio_id", "reviews_rounds", ["studio_id"])
    op.create_table(
        "sound_lists_cue_changes",
        sa.Column("revision_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("before", JSON, nullable=False),
        sa.Column("after", JSON, nullable=False),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name="fk_sound_lists_cue_changes_cue_id"),
        sa.ForeignKeyConstraint(
            ["revision_id"], ["sound_lists_revisions.id"], name="fk_sound_lists_cue_changes_revision_id"
        ),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_sound_lists_cue_changes_studio_id"),
        sa.PrimaryKeyConstraint("revision_id", "cue_id", name="pk_sound_lists_cue_changes"),
    )
    op.create_index("ix_sound_lists_cue_changes_cue_id", "sound_lists_cue_changes", ["cue_id"])
    op.create_index("ix_sound_lists_cue_changes_studio_id", "sound_lists_cue_changes", ["studio_id"])
    op.create_table(
        "sound_lists_questions",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("asked_by", sa.Uuid(), nullable=False),
        sa.Column("asked_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("answer", sa.String()),
        sa.Column("answered_by", sa.Uuid()),
        sa.Column("answered_at", sa.DateTime(timezone=True)),
        sa.ForeignKeyConstraint(["answered_by"], ["accounts_people.id"], name="fk_sound_lists_questions_answered_by"),
        sa.ForeignKeyConstraint(["asked_by"], ["accounts_people.id"], name="fk_sound_lists_questions_asked_by"),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name="fk_sound_lists_questions_cue_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_sound_lists_questions_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_sound_lists_questions_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_sound_lists_questions"),
    )
    op.create_index("ix_sound_lists_questions_cue_id", "sound_lists_questions", ["cue_id"])
    op.create_index(
        "ix_sound_lists_questions_open",
        "sound_lists_questions",
        ["project_id", "cue_id"],
        sqlite_where=sa.text("answered_at is null"),
        postgresql_where=sa.text("answered_at is null"),
    )
    op.create_index("ix_sound_lists_questions_project_id", "sound_lists_questions", ["project_id"])
    op.create_index("ix_sound_lists_questions_studio_id", "sound_lists_questions", ["studio_id"])
    op.create_table(
        "sound_lists_stems",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("variation", sa.Integer(), nullable=False),
        sa.Column("stem", sa.String(), nullable=False),
        sa.Column("folded", sa.String(), nullable=False),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name="fk_sound_lists_stems_cue_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_sound_lists_stems_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_sound_lists_stems_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_sound_lists_stems"),
        sa.UniqueConstraint("cue_id", "variation", name="uq_sound_lists_stems_cue_id_variation"),
        sa.UniqueConstraint("project_id", "folded", name="uq_sound_lists_stems_project_id_folded"),
    )
    op.create_index("ix_sound_lists_stems_studio_id", "sound_lists_stems", ["studio_id"])
    op.create_table(
        "contracts_events",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("seq", sa.Integer(), nullable=False),
        sa.Column("at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("kind", sa.String(), nullable=False),
        sa.Column("payload", sa.String(), nullable=False),
        sa.Column("previous_sha256", sa.String(), nullable=False),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name="fk_contracts_events_contract_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_contracts_events_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_contracts_events_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_contracts_events"),
        sa.UniqueConstraint("contract_id", "seq", name="uq_contracts_events_contract_id_seq"),
    )
    op.create_index("ix_contracts_events_project_id", "contracts_events", ["project_id"])
    op.create_index("ix_contracts_events_studio_id", "contracts_events", ["studio_id"])
    op.create_table(
        "contracts_extra_rounds",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("proposed_by", sa.Uuid(), nullable=False),
        sa.Column("proposed_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("agreed_by", sa.Uuid()),
        sa.Column("agreed_at", sa.DateTime(timezone=True)),
        sa.Column("dropped_at", sa.DateTime(timezone=True)),
        sa.CheckConstraint(
            "agreed_at is null or dropped_at is null", name=op.f("ck_contracts_extra_rounds_agreed_or_dropped")
        ),
        sa.ForeignKeyConstraint(["agreed_by"], ["accounts_people.id"], name="fk_contracts_extra_rounds_agreed_by"),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name="fk_contracts_extra_rounds_contract_id"
        ),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name="fk_contracts_extra_rounds_cue_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_contracts_extra_rounds_project_id"),
        sa.ForeignKeyConstraint(["proposed_by"], ["accounts_people.id"], name="fk_contracts_extra_rounds_proposed_by"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_contracts_extra_rounds_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_contracts_extra_rounds"),
        sa.UniqueConstraint(
            "contract_id", "cue_id", "number", name="uq_contracts_extra_rounds_contract_id_cue_id_number"
        ),
    )
    op.create_index("ix_contracts_extra_rounds_cue_id", "contracts_extra_rounds", ["cue_id"])
    op.create_index("ix_contracts_extra_rounds_project_id", "contracts_extra_rounds", ["project_id"])
    op.create_index("ix_contracts_extra_rounds_studio_id", "contracts_extra_rounds", ["studio_id"])
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
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("number > 0", name=op.f("ck_contracts_invoices_numbered_from_one")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name="fk_contracts_invoices_contract_id"),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name="fk_contracts_invoices_designer_id"),
        sa.ForeignKeyConstraint(["issued_by"], ["accounts_people.id"], name="fk_contracts_invoices_issued_by"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_contracts_invoices_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_contracts_invoices_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_contracts_invoices"),
        sa.UniqueConstraint(
            "studio_id", "designer_id", "number", name="uq_contracts_invoices_studio_id_designer_id_number"
        ),
    )
    op.create_index("ix_contracts_invoices_contract_id", "contracts_invoices", ["contract_id"])
    op.create_index("ix_contracts_invoices_designer_id", "contracts_invoices", ["designer_id"])
    op.create_index("ix_contracts_invoices_project_id", "contracts_invoices", ["project_id"])
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
        sa.Column("due_on", sa.Date()),
        sa.Column("tax_bp", sa.Integer()),
        sa.CheckConstraint("amount_minor >= 0", name=op.f("ck_contracts_milestones_amount_not_negative")),
        sa.CheckConstraint("tax_bp between 0 and 10000", name=op.f("ck_contracts_milestones_tax_is_a_part")),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name="fk_contracts_milestones_contract_id"
        ),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_contracts_milestones_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_contracts_milestones_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_contracts_milestones"),
        sa.UniqueConstraint("contract_id", "position", name="uq_contracts_milestones_contract_id_position"),
    )
    op.create_index("ix_contracts_milestones_project_id", "contracts_milestones", ["project_id"])
    op.create_index("ix_contracts_milestones_studio_id", "contracts_milestones", ["studio_id"])
    op.create_table(
        "contracts_versions",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("clauses", JSON, nullable=False),
        sa.Column("terms", JSON, nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("text_sha256", sa.String(), nullable=False),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column("created_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("sent_at", sa.DateTime(timezone=True)),
        sa.Column("pdf_sha256", sa.String()),
        sa.Column("pdf_bytes", sa.Integer()),
        sa.CheckConstraint("(sent_at is null) = (pdf_sha256 is null)", name=op.f("ck_contracts_versions_sent_as_pdf")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name="fk_contracts_versions_contract_id"),
        sa.ForeignKeyConstraint(["created_by"], ["accounts_people.id"], name="fk_contracts_versions_created_by"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_contracts_versions_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_contracts_versions_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_contracts_versions"),
        sa.UniqueConstraint("contract_id", "number", name="uq_contracts_versions_contract_id_number"),
    )
    op.create_index("ix_contracts_versions_project_id", "contracts_versions", ["project_id"])
    op.create_index("ix_contracts_versions_studio_id", "contracts_versions", ["studio_id"])
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
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("minutes > 0", name=op.f("ck_contracts_work_logs_minutes_positive")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name="fk_contracts_work_logs_contract_id"),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name="fk_contracts_work_logs_cue_id"),
        sa.ForeignKeyConstraint(["logged_by"], ["accounts_people.id"], name="fk_contracts_work_logs_logged_by"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_contracts_work_logs_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_contracts_work_logs_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_contracts_work_logs"),
    )
    op.create_index("ix_contracts_work_logs_contract_id", "contracts_work_logs", ["contract_id"])
    op.create_index("ix_contracts_work_logs_cue_id", "contracts_work_logs", ["cue_id"])
    op.create_index("ix_contracts_work_logs_project_id", "contracts_work_logs", ["project_id"])
    op.create_index("ix_contracts_work_logs_studio_id", "contracts_work_logs", ["studio_id"])
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
        sa.ForeignKeyConstraint(["archive_id"], ["deliveries_archives.id"], name="fk_deliveries_dry_stems_archive_id"),
        sa.ForeignKeyConstraint(
            ["delivery_id"], ["deliveries_deliveries.id"], name="fk_deliveries_dry_stems_delivery_id"
        ),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_deliveries_dry_stems_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_deliveries_dry_stems_studio_id"),
        sa.ForeignKeyConstraint(["upload_id"], ["kit_uploads.id"], name="fk_deliveries_dry_stems_upload_id"),
        sa.PrimaryKeyConstraint("id", name="pk_deliveries_dry_stems"),
        sa.UniqueConstraint("archive_id", "archive_entry", name="uq_deliveries_dry_stems_archive_id_archive_entry"),
        sa.UniqueConstraint("upload_id", "stem", name="uq_deliveries_dry_stems_upload_id_stem"),
    )
    op.create_index("ix_deliveries_dry_stems_kept", "deliveries_dry_stems", ["studio_id", "sha256", "file_bytes"])
    op.create_index("ix_deliveries_dry_stems_of_takes", "deliveries_dry_stems", ["delivery_id", "stem"])
    op.create_index("ix_deliveries_dry_stems_project_id", "deliveries_dry_stems", ["project_id"])
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
        sa.Column("cue_id", sa.Uuid()),
        sa.Column("variation", sa.Integer(), nullable=False),
        sa.Column("number", sa.Integer()),
        sa.Column("alternate", sa.Integer()),
        sa.Column(
            "state",
            sa.Enum(
                "received",
                "conforming",
                "returned",
                "unjudged",
                "approved",
                "change_requested",
                "set_aside",
                name="takestate",
                native_enum=False,
                length=32,
            ),
            nullable=False,
        ),
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
        sa.CheckConstraint(
            "(cue_id is null) = (number is null)", name=op.f("ck_deliveries_takes_numbered_when_matched")
        ),
        sa.CheckConstraint("master_bytes >= 0", name=op.f("ck_deliveries_takes_master_size_known")),
        sa.ForeignKeyConstraint(["archive_id"], ["deliveries_archives.id"], name="fk_deliveries_takes_archive_id"),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name="fk_deliveries_takes_cue_id"),
        sa.ForeignKeyConstraint(["delivery_id"], ["deliveries_deliveries.id"], name="fk_deliveries_takes_delivery_id"),
        sa.ForeignKeyConstraint(["designer_id"], ["accounts_people.id"], name="fk_deliveries_takes_designer_id"),
        sa.ForeignKeyConstraint(["fix_of_id"], ["deliveries_takes.id"], name="fk_deliveries_takes_fix_of_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_deliveries_takes_project_id"),
        sa.ForeignKeyConstraint(["rechecked_by"], ["accounts_people.id"], name="fk_deliveries_takes_rechecked_by"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_deliveries_takes_studio_id"),
        sa.ForeignKeyConstraint(["upload_id"], ["kit_uploads.id"], name="fk_deliveries_takes_upload_id"),
        sa.PrimaryKeyConstraint("id", name="pk_deliveries_takes"),
        sa.UniqueConstraint("archive_id", "archive_entry", name="uq_deliveries_takes_archive_id_archive_entry"),
        sa.UniqueConstraint("cue_id", "variation", "number", name="uq_deliveries_takes_cue_id_variation_number"),
        sa.UniqueConstraint("upload_id", name="uq_deliveries_takes_upload_id"),
    )
    op.create_index("ix_deliveries_takes_delivery_id", "deliveries_takes", ["delivery_id"])
    op.create_index("ix_deliveries_takes_fix_of_id", "deliveries_takes", ["fix_of_id"])
    op.create_index("ix_deliveries_takes_kept", "deliveries_takes", ["studio_id", "master_sha256", "master_bytes"])
    op.create_index("ix_deliveries_takes_master_sha256", "deliveries_takes", ["master_sha256"])
    op.create_index("ix_deliveries_takes_project_id_id", "deliveries_takes", ["project_id", "id"])
    op.create_index(
        "ix_deliveries_takes_project_waiting", "deliveries_takes", ["project_id", "state", "state_since", "cue_id"]
    )
    op.create_index(
        "ix_deliveries_takes_studio_waiting", "deliveries_takes", ["studio_id", "state", "state_since", "cue_id"]
    )
    op.create_index(
        "ix_deliveries_takes_sums",
        "deliveries_takes",
        ["project_id", "cue_id", "variation", "state", "number", "designer_id", "studio_id"],
    )
    op.create_index(
        "uq_reviews_one_approved",
        "deliveries_takes",
        ["cue_id", "variation"],
        unique=True,
        sqlite_where=sa.text("state = 'approved'"),
        postgresql_where=sa.text("state = 'approved'"),
    )
    op.create_table(
        "conformance_check_runs",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("spec_id", sa.Uuid(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("is_current", sa.Boolean(), nullable=False),
        sa.Column("needs_notification", sa.Boolean(), server_default=sa.false(), nullable=False),
        sa.Column("verdict", sa.String(), nullable=False),
        sa.Column("pcm_sha256", sa.String()),
        sa.Column("report", JSON, nullable=False),
        sa.Column("tool_version", sa.String(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_conformance_check_runs_project_id"),
        sa.ForeignKeyConstraint(["spec_id"], ["projects_specs.id"], name="fk_conformance_check_runs_spec_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_conformance_check_runs_studio_id"),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name="fk_conformance_check_runs_take_id"),
        sa.PrimaryKeyConstraint("id", name="pk_conformance_check_runs"),
    )
    op.create_index("ix_conformance_check_runs_key", "conformance_check_runs", ["key"])
    op.create_index("ix_conformance_check_runs_project_id", "conformance_check_runs", ["project_id"])
    op.create_index("ix_conformance_check_runs_studio_id", "conformance_check_runs", ["studio_id"])
    op.create_index("ix_conformance_check_runs_take_id", "conformance_check_runs", ["take_id"])
    op.create_index(
        "ix_conformance_check_runs_unnotified",
        "conformance_check_runs",
        ["project_id"],
        sqlite_where=sa.text("needs_notification"),
        postgresql_where=sa.text("needs_notification"),
    )
    op.create_index(
        "uq_conformance_check_runs_current",
        "conformance_check_runs",
        ["take_id"],
        unique=True,
        sqlite_where=sa.text("is_current"),
        postgresql_where=sa.text("is_current"),
    )
    op.create_table(
        "conformance_fixes",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column(
            "state", sa.Enum("making", "made", "refused", name="fixstate", native_enum=False, length=32), nullable=False
        ),
        sa.Column("asked_by", sa.Uuid()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("made_at", sa.DateTime(timezone=True)),
        sa.Column("refusal", sa.String()),
        sa.Column("sha256", sa.String()),
        sa.Column("fixed_bytes", sa.BigInteger()),
        sa.Column("made", JSON, nullable=False),
        sa.Column("used_by", sa.Uuid()),
        sa.Column("used_at", sa.DateTime(timezone=True)),
        sa.Column("new_take_id", sa.Uuid()),
        sa.CheckConstraint("(state = 'made') = (sha256 is not null)", name=op.f("ck_conformance_fixes_made_has_file")),
        sa.CheckConstraint(
            "(used_by is null) = (new_take_id is null)", name=op.f("ck_conformance_fixes_used_is_a_take")
        ),
        sa.ForeignKeyConstraint(["asked_by"], ["accounts_people.id"], name="fk_conformance_fixes_asked_by"),
        sa.ForeignKeyConstraint(["new_take_id"], ["deliveries_takes.id"], name="fk_conformance_fixes_new_take_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_conformance_fixes_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_conformance_fixes_studio_id"),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name="fk_conformance_fixes_take_id"),
        sa.ForeignKeyConstraint(["used_by"], ["accounts_people.id"], name="fk_conformance_fixes_used_by"),
        sa.PrimaryKeyConstraint("id", name="pk_conformance_fixes"),
        sa.UniqueConstraint("take_id", "key", name="uq_conformance_fixes_take_id_key"),
    )
    op.create_index("ix_conformance_fixes_new_take_id", "conformance_fixes", ["new_take_id"])
    op.create_index("ix_conformance_fixes_project_id", "conformance_fixes", ["project_id"])
    op.create_index("ix_conformance_fixes_sha256", "conformance_fixes", ["sha256"])
    op.create_index("ix_conformance_fixes_studio_id", "conformance_fixes", ["studio_id"])
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
        sa.Column("email_proof", sa.Enum("mail", "operator", name="addressproof", native_enum=False, length=32)),
        sa.Column("address", sa.String(), nullable=False),
        sa.Column("accepted_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name="fk_contracts_acceptances_contract_id"
        ),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name="fk_contracts_acceptances_person_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_contracts_acceptances_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_contracts_acceptances_studio_id"),
        sa.ForeignKeyConstraint(["version_id"], ["contracts_versions.id"], name="fk_contracts_acceptances_version_id"),
        sa.PrimaryKeyConstraint("id", name="pk_contracts_acceptances"),
        sa.UniqueConstraint("version_id", "party", name="uq_contracts_acceptances_version_id_party"),
    )
    op.create_index("ix_contracts_acceptances_contract_id", "contracts_acceptances", ["contract_id"])
    op.create_index("ix_contracts_acceptances_project_id", "contracts_acceptances", ["project_id"])
    op.create_index("ix_contracts_acceptances_studio_id", "contracts_acceptances", ["studio_id"])
    op.create_table(
        "contracts_cues",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("milestone_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("position", sa.Integer(), nullable=False),
        sa.Column("price_minor", sa.BigInteger()),
        sa.Column("amount_minor", sa.BigInteger()),
        sa.Column("estimate_min", sa.Integer()),
        sa.Column("accepted_at", sa.DateTime(timezone=True)),
        sa.Column(
            "accepted_by", sa.Enum("verdict", "silence", "adoption", name="acceptedby", native_enum=False, length=32)
        ),
        sa.Column("cut_at", sa.DateTime(timezone=True)),
        sa.Column(
            "cut_in",
            sa.Enum("not_begun", "in_work", "delivered", "accepted", name="workstate", native_enum=False, length=32),
        ),
        sa.CheckConstraint(
            "(accepted_at is null) = (accepted_by is null)", name=op.f("ck_contracts_cues_accepted_somehow")
        ),
        sa.CheckConstraint("(cut_at is null) = (cut_in is null)", name=op.f("ck_contracts_cues_cut_in_a_state")),
        sa.CheckConstraint("amount_minor >= 0", name=op.f("ck_contracts_cues_amount_not_negative")),
        sa.CheckConstraint("estimate_min > 0", name=op.f("ck_contracts_cues_estimate_positive")),
        sa.CheckConstraint("price_minor >= 0", name=op.f("ck_contracts_cues_price_not_negative")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name="fk_contracts_cues_contract_id"),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name="fk_contracts_cues_cue_id"),
        sa.ForeignKeyConstraint(["milestone_id"], ["contracts_milestones.id"], name="fk_contracts_cues_milestone_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_contracts_cues_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_contracts_cues_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_contracts_cues"),
        sa.UniqueConstraint("contract_id", "cue_id", name="uq_contracts_cues_contract_id_cue_id"),
    )
    op.create_index("ix_contracts_cues_cue_id", "contracts_cues", ["cue_id"])
    op.create_index("ix_contracts_cues_milestone_id", "contracts_cues", ["milestone_id"])
    op.create_index("ix_contracts_cues_project_id", "contracts_cues", ["project_id"])
    op.create_index("ix_contracts_cues_studio_id", "contracts_cues", ["studio_id"])
    op.create_table(
        "contracts_payments",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("contract_id", sa.Uuid(), nullable=False),
        sa.Column("invoice_id", sa.Uuid(), nullable=False),
        sa.Column("refund_of_id", sa.Uuid()),
        sa.Column("amount_minor", sa.BigInteger(), nullable=False),
        sa.Column("reference", sa.String(), nullable=False),
        sa.Column("paid_on", sa.Date(), nullable=False),
        sa.Column("recorded_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("amount_minor <> 0", name=op.f("ck_contracts_payments_not_nothing")),
        sa.ForeignKeyConstraint(["contract_id"], ["contracts_contracts.id"], name="fk_contracts_payments_contract_id"),
        sa.ForeignKeyConstraint(["invoice_id"], ["contracts_invoices.id"], name="fk_contracts_payments_invoice_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_contracts_payments_project_id"),
        sa.ForeignKeyConstraint(["recorded_by"], ["accounts_people.id"], name="fk_contracts_payments_recorded_by"),
        sa.ForeignKeyConstraint(["refund_of_id"], ["contracts_payments.id"], name="fk_contracts_payments_refund_of_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_contracts_payments_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_contracts_payments"),
    )
    op.create_index("ix_contracts_payments_contract_id", "contracts_payments", ["contract_id"])
    op.create_index("ix_contracts_payments_invoice_id", "contracts_payments", ["invoice_id"])
    op.create_index("ix_contracts_payments_project_id", "contracts_payments", ["project_id"])
    op.create_index("ix_contracts_payments_refund_of_id", "contracts_payments", ["refund_of_id"])
    op.create_index("ix_contracts_payments_studio_id", "contracts_payments", ["studio_id"])
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
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("agreed_by", sa.Uuid()),
        sa.Column("agreed_at", sa.DateTime(timezone=True)),
        sa.CheckConstraint(
            "(agreed_at is null) = (agreed_by is null)", name=op.f("ck_contracts_worked_days_agreed_by_somebody")
        ),
        sa.CheckConstraint("quarters between 1 and 4", name=op.f("ck_contracts_worked_days_a_day_at_most")),
        sa.ForeignKeyConstraint(["agreed_by"], ["accounts_people.id"], name="fk_contracts_worked_days_agreed_by"),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name="fk_contracts_worked_days_contract_id"
        ),
        sa.ForeignKeyConstraint(["logged_by"], ["accounts_people.id"], name="fk_contracts_worked_days_logged_by"),
        sa.ForeignKeyConstraint(
            ["milestone_id"], ["contracts_milestones.id"], name="fk_contracts_worked_days_milestone_id"
        ),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_contracts_worked_days_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_contracts_worked_days_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_contracts_worked_days"),
        sa.UniqueConstraint("contract_id", "worked_on", name="uq_contracts_worked_days_contract_id_worked_on"),
    )
    op.create_index("ix_contracts_worked_days_project_id", "contracts_worked_days", ["project_id"])
    op.create_index("ix_contracts_worked_days_studio_id", "contracts_worked_days", ["studio_id"])
    op.create_table(
        "deliveries_cue_sums",
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("viewer_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column(
            "state",
            sa.Enum("concept", "prototype", "locked", "cut", name="cuestate", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("variations", sa.Integer(), nullable=False),
        sa.Column("placeholder", sa.Boolean(), nullable=False),
        sa.Column("facts", sa.String(), nullable=False),
        sa.Column("newest_id", sa.Uuid(), nullable=False),
        sa.Column("newest_back_since", sa.DateTime(timezone=True)),
        sa.Column("back_since", sa.DateTime(timezone=True)),
        sa.ForeignKeyConstraint(
            ["cue_id", "state", "variations", "placeholder"],
            [
                "sound_lists_cues.id",
                "sound_lists_cues.state",
                "sound_lists_cues.variations",
                "sound_lists_cues.placeholder",
            ],
            name="fk_deliveries_cue_sums_cue",
            onupdate="CASCADE",
        ),
        sa.ForeignKeyConstraint(["newest_id"], ["deliveries_takes.id"], name="fk_deliveries_cue_sums_newest_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_deliveries_cue_sums_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_deliveries_cue_sums_studio_id"),
        sa.PrimaryKeyConstraint("cue_id", "viewer_id", name="pk_deliveries_cue_sums"),
        sqlite_with_rowid=False,
    )
    op.create_index(
        "ix_deliveries_cue_sums_alike",
        "deliveries_cue_sums",
        ["project_id", "viewer_id", "state", "variations", "placeholder", "facts", "studio_id"],
    )
    op.create_index(
        "ix_deliveries_cue_sums_back",
        "deliveries_cue_sums",
        ["project_id", "viewer_id", "back_since", "cue_id"],
        sqlite_where=sa.text("back_since is not null"),
        postgresql_where=sa.text("back_since is not null"),
    )
    op.create_index(
        "ix_deliveries_cue_sums_newest_back",
        "deliveries_cue_sums",
        ["project_id", "viewer_id", "newest_back_since"],
        sqlite_where=sa.text("newest_back_since is not null"),
        postgresql_where=sa.text("newest_back_since is not null"),
    )
    op.create_table(
        "renders_batch_items",
        sa.Column("batch_id", sa.Uuid(), nullable=False),
        sa.Column("place", sa.Integer(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("target", sa.String(), nullable=False),
        sa.Column("category", sa.String(), nullable=False),
        sa.Column(
            "state",
            sa.Enum("waiting", "made", "kept", "refused", "left", name="itemstate", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("before_bytes", sa.BigInteger()),
        sa.Column("after_bytes", sa.BigInteger()),
        sa.Column("reason", sa.String(), nullable=False),
        sa.ForeignKeyConstraint(["batch_id"], ["renders_batches.id"], name="fk_renders_batch_items_batch_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_renders_batch_items_studio_id"),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name="fk_renders_batch_items_take_id"),
        sa.PrimaryKeyConstraint("batch_id", "place", name="pk_renders_batch_items"),
        sa.UniqueConstraint("batch_id", "take_id", "target", name="uq_renders_batch_items_batch_id_take_id_target"),
    )
    op.create_index("ix_renders_batch_items_studio_id", "renders_batch_items", ["studio_id"])
    op.create_index("ix_renders_batch_items_take_id", "renders_batch_items", ["take_id"])
    op.create_index("ix_renders_batch_items_waiting", "renders_batch_items", ["batch_id", "state", "place"])
    op.create_table(
        "renders_master_exports",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column("provenance", JSON, nullable=False),
        sa.Column("left", JSON, nullable=False),
        sa.Column("file_name", sa.String(), nullable=False),
        sa.Column("sha256", sa.String()),
        sa.Column("file_bytes", sa.BigInteger()),
        sa.Column("refusal", sa.String()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint("sha256 is null or refusal is null", name=op.f("ck_renders_master_exports_made_or_refused")),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_renders_master_exports_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_renders_master_exports_studio_id"),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name="fk_renders_master_exports_take_id"),
        sa.PrimaryKeyConstraint("id", name="pk_renders_master_exports"),
        sa.UniqueConstraint("take_id", "key", name="uq_renders_master_exports_take_id_key"),
    )
    op.create_index("ix_renders_master_exports_project_id", "renders_master_exports", ["project_id"])
    op.create_index("ix_renders_master_exports_studio_id", "renders_master_exports", ["studio_id"])
    op.create_table(
        "renders_renders",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("target", sa.String(), nullable=False),
        sa.Column("key", sa.String(), nullable=False),
        sa.Column(
            "state", sa.Enum("made", "refused", name="renderstate", native_enum=False, length=32), nullable=False
        ),
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
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_renders_renders_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_renders_renders_studio_id"),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name="fk_renders_renders_take_id"),
        sa.PrimaryKeyConstraint("id", name="pk_renders_renders"),
        sa.UniqueConstraint("take_id", "target", "key", name="uq_renders_renders_take_id_target_key"),
    )
    op.create_index("ix_renders_renders_kept", "renders_renders", ["studio_id", "sha256", "file_bytes"])
    op.create_index("ix_renders_renders_project_id", "renders_renders", ["project_id"])
    op.create_index("ix_renders_renders_take_id", "renders_renders", ["take_id"])
    op.create_table(
        "renders_sets",
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("spec_id", sa.Uuid(), nullable=False),
        sa.Column("edition", sa.Integer(), nullable=False),
        sa.Column("completed_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["spec_id"], ["projects_specs.id"], name="fk_renders_sets_spec_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_renders_sets_studio_id"),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name="fk_renders_sets_take_id"),
        sa.PrimaryKeyConstraint("take_id", name="pk_renders_sets"),
    )
    op.create_index("ix_renders_sets_studio_id", "renders_sets", ["studio_id"])
    op.create_table(
        "reviews_change_requests",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("start_s", sa.Double()),
        sa.Column("end_s", sa.Double()),
        sa.Column("written_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("feedback_id", sa.Uuid()),
        sa.CheckConstraint("end_s is null or end_s >= start_s", name=op.f("ck_reviews_change_requests_range_forwards")),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name="fk_reviews_change_requests_cue_id"),
        sa.ForeignKeyConstraint(
            ["feedback_id"], ["reviews_feedback.id"], name="fk_reviews_change_requests_feedback_id"
        ),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_reviews_change_requests_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_reviews_change_requests_studio_id"),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name="fk_reviews_change_requests_take_id"),
        sa.ForeignKeyConstraint(["written_by"], ["accounts_people.id"], name="fk_reviews_change_requests_written_by"),
        sa.PrimaryKeyConstraint("id", name="pk_reviews_change_requests"),
    )
    op.create_index("ix_reviews_change_requests_cue_id", "reviews_change_requests", ["cue_id"])
    op.create_index(
        "ix_reviews_change_requests_drafts",
        "reviews_change_requests",
        ["project_id"],
        sqlite_where=sa.text("feedback_id is null"),
        postgresql_where=sa.text("feedback_id is null"),
    )
    op.create_index("ix_reviews_change_requests_feedback_id", "reviews_change_requests", ["feedback_id"])
    op.create_index("ix_reviews_change_requests_project_id_id", "reviews_change_requests", ["project_id", "id"])
    op.create_index("ix_reviews_change_requests_studio_id", "reviews_change_requests", ["studio_id"])
    op.create_index("ix_reviews_change_requests_take_id", "reviews_change_requests", ["take_id"])
    op.create_index(
        "uq_reviews_change_requests_draft",
        "reviews_change_requests",
        ["take_id"],
        unique=True,
        sqlite_where=sa.text("feedback_id is null"),
        postgresql_where=sa.text("feedback_id is null"),
    )
    op.create_table(
        "reviews_comments",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("text", sa.String(), nullable=False),
        sa.Column("start_s", sa.Double()),
        sa.Column("end_s", sa.Double()),
        sa.Column("written_by", sa.Uuid(), nullable=False),
        sa.Column("decides", sa.Boolean(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("resolved_at", sa.DateTime(timezone=True)),
        sa.Column("resolved_by", sa.Uuid()),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_reviews_comments_project_id"),
        sa.ForeignKeyConstraint(["resolved_by"], ["accounts_people.id"], name="fk_reviews_comments_resolved_by"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_reviews_comments_studio_id"),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name="fk_reviews_comments_take_id"),
        sa.ForeignKeyConstraint(["written_by"], ["accounts_people.id"], name="fk_reviews_comments_written_by"),
        sa.PrimaryKeyConstraint("id", name="pk_reviews_comments"),
    )
    op.create_index("ix_reviews_comments_project_id_id", "reviews_comments", ["project_id", "id"])
    op.create_index("ix_reviews_comments_studio_id", "reviews_comments", ["studio_id"])
    op.create_index("ix_reviews_comments_take_id", "reviews_comments", ["take_id"])
    op.create_table(
        "reviews_verdicts",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("action_id", sa.Uuid(), nullable=False),
        sa.Column(
            "kind",
            sa.Enum(
                "approve", "request_change", "set_aside", "withdraw", name="verdictkind", native_enum=False, length=32
            ),
            nullable=False,
        ),
        sa.Column("note", sa.String(), nullable=False),
        sa.Column(
            "state_before",
            sa.Enum(
                "received",
                "conforming",
                "returned",
                "unjudged",
                "approved",
                "change_requested",
                "set_aside",
                name="takestate",
                native_enum=False,
                length=32,
            ),
            nullable=False,
        ),
        sa.Column("since_before", sa.DateTime(timezone=True), nullable=False),
        sa.Column("dropped_draft", JSON, nullable=False),
        sa.Column("withdraws_id", sa.Uuid()),
        sa.Column("given_by", sa.Uuid(), nullable=False),
        sa.Column("deemed_by_contract_id", sa.Uuid()),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name="fk_reviews_verdicts_cue_id"),
        sa.ForeignKeyConstraint(
            ["deemed_by_contract_id"], ["contracts_contracts.id"], name="fk_reviews_verdicts_deemed_by_contract_id"
        ),
        sa.ForeignKeyConstraint(["given_by"], ["accounts_people.id"], name="fk_reviews_verdicts_given_by"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_reviews_verdicts_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_reviews_verdicts_studio_id"),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name="fk_reviews_verdicts_take_id"),
        sa.ForeignKeyConstraint(["withdraws_id"], ["reviews_verdicts.id"], name="fk_reviews_verdicts_withdraws_id"),
        sa.PrimaryKeyConstraint("id", name="pk_reviews_verdicts"),
        sa.UniqueConstraint("withdraws_id", name="uq_reviews_verdicts_withdraws_id"),
    )
    op.create_index("ix_reviews_verdicts_action_id", "reviews_verdicts", ["action_id"])
    op.create_index("ix_reviews_verdicts_cue_id", "reviews_verdicts", ["cue_id"])
    op.create_index("ix_reviews_verdicts_deemed_by_contract_id", "reviews_verdicts", ["deemed_by_contract_id"])
    op.create_index("ix_reviews_verdicts_project_id_id", "reviews_verdicts", ["project_id", "id"])
    op.create_index("ix_reviews_verdicts_studio_id", "reviews_verdicts", ["studio_id"])
    op.create_index("ix_reviews_verdicts_take_id", "reviews_verdicts", ["take_id"])
    op.create_table(
        "builds_packed_files",
        sa.Column("pack_id", sa.Uuid(), nullable=False),
        sa.Column("place", sa.Integer(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("path", sa.String(), nullable=False),
        sa.Column(
            "kind",
            sa.Enum("game", "placeholder", "master", "key", name="filekind", native_enum=False, length=32),
            nullable=False,
        ),
        sa.Column("sha256", sa.String(), nullable=False),
        sa.Column("size_bytes", sa.BigInteger(), nullable=False),
        sa.Column("pcm_sha256", sa.String()),
        sa.Column("render_id", sa.Uuid()),
        sa.ForeignKeyConstraint(["pack_id"], ["builds_packs.id"], name="fk_builds_packed_files_pack_id"),
        sa.ForeignKeyConstraint(["render_id"], ["renders_renders.id"], name="fk_builds_packed_files_render_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_builds_packed_files_studio_id"),
        sa.PrimaryKeyConstraint("pack_id", "place", name="pk_builds_packed_files"),
        sa.UniqueConstraint("pack_id", "path", name="uq_builds_packed_files_pack_id_path"),
    )
    op.create_index(
        "ix_builds_packed_files_keys",
        "builds_packed_files",
        ["studio_id", "sha256", "size_bytes"],
        sqlite_where=sa.text("kind = 'key'"),
        postgresql_where=sa.text("kind = 'key'"),
    )
    op.create_index("ix_builds_packed_files_studio_id", "builds_packed_files", ["studio_id"])
    op.create_table(
        "conformance_waivers",
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("take_id", sa.Uuid(), nullable=False),
        sa.Column("check_run_id", sa.Uuid(), nullable=False),
        sa.Column("master_sha256", sa.String(), nullable=False),
        sa.Column("codes", JSON, nullable=False),
        sa.Column("reason", sa.String(), nullable=False),
        sa.Column("waived_by", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(
            ["check_run_id"], ["conformance_check_runs.id"], name="fk_conformance_waivers_check_run_id"
        ),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_conformance_waivers_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_conformance_waivers_studio_id"),
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name="fk_conformance_waivers_take_id"),
        sa.ForeignKeyConstraint(["waived_by"], ["accounts_people.id"], name="fk_conformance_waivers_waived_by"),
        sa.PrimaryKeyConstraint("id", name="pk_conformance_waivers"),
    )
    op.create_index("ix_conformance_waivers_project_id", "conformance_waivers", ["project_id"])
    op.create_index("ix_conformance_waivers_studio_id", "conformance_waivers", ["studio_id"])
    op.create_index("ix_conformance_waivers_take_id", "conformance_waivers", ["take_id"])
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
                "held_back",
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
        sa.Column("cue_id", sa.Uuid()),
        sa.Column("milestone_id", sa.Uuid()),
        sa.Column("about_id", sa.Uuid()),
        sa.Column("round_number", sa.Integer()),
        sa.Column("tax_bp", sa.Integer()),
        sa.Column("payment_id", sa.Uuid()),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
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
        sa.ForeignKeyConstraint(["about_id"], ["contracts_ledger_lines.id"], name="fk_contracts_ledger_lines_about_id"),
        sa.ForeignKeyConstraint(
            ["contract_id"], ["contracts_contracts.id"], name="fk_contracts_ledger_lines_contract_id"
        ),
        sa.ForeignKeyConstraint(["cue_id"], ["sound_lists_cues.id"], name="fk_contracts_ledger_lines_cue_id"),
        sa.ForeignKeyConstraint(
            ["milestone_id"], ["contracts_milestones.id"], name="fk_contracts_ledger_lines_milestone_id"
        ),
        sa.ForeignKeyConstraint(["payment_id"], ["contracts_payments.id"], name="fk_contracts_ledger_lines_payment_id"),
        sa.ForeignKeyConstraint(["person_id"], ["accounts_people.id"], name="fk_contracts_ledger_lines_person_id"),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_contracts_ledger_lines_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_contracts_ledger_lines_studio_id"),
        sa.PrimaryKeyConstraint("id", name="pk_contracts_ledger_lines"),
    )
    op.create_index("ix_contracts_ledger_lines_contract_id", "contracts_ledger_lines", ["contract_id"])
    op.create_index("ix_contracts_ledger_lines_project_id", "contracts_ledger_lines", ["project_id"])
    op.create_index("ix_contracts_ledger_lines_studio_id", "contracts_ledger_lines", ["studio_id"])
    op.create_index(
        "uq_contracts_ledger_lines_reversed",
        "contracts_ledger_lines",
        ["about_id"],
        unique=True,
        sqlite_where=sa.text("kind = 'reversed'"),
        postgresql_where=sa.text("kind = 'reversed'"),
    )
    op.create_index(
        "uq_contracts_ledger_lines_round",
        "contracts_ledger_lines",
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
            ["invoice_id"], ["contracts_invoices.id"], name="fk_contracts_invoice_lines_invoice_id"
        ),
        sa.ForeignKeyConstraint(
            ["ledger_line_id"], ["contracts_ledger_lines.id"], name="fk_contracts_invoice_lines_ledger_line_id"
        ),
        sa.ForeignKeyConstraint(["project_id"], ["projects_projects.id"], name="fk_contracts_invoice_lines_project_id"),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name="fk_contracts_invoice_lines_studio_id"),
        sa.PrimaryKeyConstraint("ledger_line_id", name="pk_contracts_invoice_lines"),
    )
    op.create_index("ix_contracts_invoice_lines_invoice_id", "contracts_invoice_lines", ["invoice_id"])
    op.create_index("ix_contracts_invoice_lines_project_id", "contracts_invoice_lines", ["project_id"])
    op.create_index("ix_contracts_invoice_lines_studio_id", "contracts_invoice_lines", ["studio_id"])


def downgrade() -> None:
    for table in (
        "contracts_invoice_lines",
        "contracts_ledger_lines",
        "conformance_waivers",
        "builds_packed_files",
        "reviews_verdicts",
        "reviews_comments",
        "reviews_change_requests",
        "renders_sets",
        "renders_renders",
        "renders_master_exports",
        "renders_batch_items",
        "deliveries_cue_sums",
        "contracts_worked_days",
        "contracts_payments",
        "contracts_cues",
        "contracts_acceptances",
        "conformance_fixes",
        "conformance_check_runs",
        "deliveries_takes",
        "deliveries_dry_stems",
        "contracts_work_logs",
        "contracts_versions",
        "contracts_milestones",
        "contracts_invoices",
        "contracts_extra_rounds",
        "contracts_events",
        "sound_lists_stems",
        "sound_lists_questions",
        "sound_lists_cue_changes",
        "reviews_rounds",
        "reviews_reminders",
        "renders_reels",
        "renders_batches",
        "deliveries_archives",
        "contracts_contracts",
        "builds_placeholder_files",
        "sound_lists_revisions",
        "sound_lists_cues",
        "reviews_feedback",
        "projects_specs",
        "projects_liaisons",
        "projects_invitations",
        "projects_engagements",
        "projects_approver_changes",
        "deliveries_takes_acts",
        "deliveries_deliveries",
        "contracts_calendar_links",
        "builds_packs",
        "builds_builds",
        "renders_timbres",
        "renders_pictures",
        "projects_projects",
        "notifications_mails",
        "contracts_templates",
        "builds_fingerprints",
        "accounts_tokens",
        "accounts_studio_invitations",
        "accounts_sign_ins",
        "accounts_quotas",
        "accounts_password_resets",
        "accounts_operators",
        "accounts_memberships",
        "accounts_email_verifications",
        "kit_uploads",
        "kit_saved_responses",
        "kit_heartbeats",
        "kit_changed_rooms",
        "accounts_studios",
        "accounts_sign_ups",
        "accounts_rate_limits",
        "accounts_people",
    ):
        op.drop_table(table)
