"""Sound libraries by the fingerprints of their files, and the takes that equal one of them."""

import sqlalchemy as sa
from alembic import op

revision = "0067"
down_revision = "0066"
branch_labels = None
depends_on = None

LIBRARIES, SOUNDS, MATCHES = "builds_sound_libraries", "builds_library_sounds", "builds_library_matches"


def tenant(table: str, *more: tuple[str, str]) -> list[sa.ForeignKeyConstraint]:
    return [
        sa.ForeignKeyConstraint([name], [target], name=op.f(f"fk_{table}_{name}"))
        for name, target in (("studio_id", "accounts_studios.id"), *more)
    ]


def of_library(table: str) -> sa.ForeignKeyConstraint:
    name = op.f(f"fk_{table}_library_id")
    return sa.ForeignKeyConstraint(["library_id"], [f"{LIBRARIES}.id"], name=name, ondelete="CASCADE")


def upgrade() -> None:
    op.create_table(
        LIBRARIES,
        sa.Column("id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("licence", sa.String(), nullable=False),
        sa.Column("sounds", sa.Integer(), nullable=False),
        sa.Column("added_at", sa.DateTime(timezone=True), nullable=False),
        *tenant(LIBRARIES, ("person_id", "accounts_people.id")),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{LIBRARIES}")),
        sa.UniqueConstraint(
            "studio_id", "person_id", "name", name=op.f("uq_builds_sound_libraries_studio_id_person_id_name")
        ),
    )
    op.create_table(
        SOUNDS,
        sa.Column("library_id", sa.Uuid(), nullable=False),
        sa.Column("path", sa.String(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("person_id", sa.Uuid(), nullable=False),
        sa.Column("fingerprint_version", sa.Integer(), nullable=False),
        sa.Column("pcm_sha256", sa.String(), nullable=False),
        sa.Column("sample_rate_hz", sa.Integer(), nullable=False),
        sa.Column("fingerprint", sa.LargeBinary(), nullable=False),
        sa.Column("moments", sa.LargeBinary(), nullable=False),
        of_library(SOUNDS),
        *tenant(SOUNDS, ("person_id", "accounts_people.id")),
        sa.PrimaryKeyConstraint("library_id", "path", name=op.f(f"pk_{SOUNDS}")),
    )
    op.create_index(op.f(f"ix_{SOUNDS}_studio_id"), SOUNDS, ["studio_id"])
    op.create_table(
        MATCHES,
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
        sa.ForeignKeyConstraint(["take_id"], ["deliveries_takes.id"], name=op.f(f"fk_{MATCHES}_take_id")),
        of_library(MATCHES),
        *tenant(MATCHES, ("project_id", "projects_projects.id")),
        sa.PrimaryKeyConstraint("take_id", "library_id", "path", name=op.f(f"pk_{MATCHES}")),
    )
    op.create_index(op.f(f"ix_{MATCHES}_library_id"), MATCHES, ["library_id"])


def downgrade() -> None:
    op.drop_table(MATCHES)
    op.drop_table(SOUNDS)
    op.drop_table(LIBRARIES)
