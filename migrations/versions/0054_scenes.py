"""Beds, sounds measured for scenes, and comparisons."""

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

revision = "0054"
down_revision = "0053"
branch_labels = None
depends_on = None

BEDS, SOUNDS, COMPARISONS = "scenes_beds", "scenes_sounds", "scenes_comparisons"


def instant(name: str) -> sa.Column:
    return sa.Column(name, sa.DateTime(timezone=True), nullable=False)


def text(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, sa.String(), nullable=nullable)


def figure(name: str, *, nullable: bool = True) -> sa.Column:
    return sa.Column(name, sa.Double(), nullable=nullable)


def size(name: str) -> sa.Column:
    return sa.Column(name, sa.BigInteger())


def uuid(name: str, *, nullable: bool = False) -> sa.Column:
    return sa.Column(name, sa.Uuid(), nullable=nullable)


def json(name: str) -> sa.Column:
    return sa.Column(name, sa.JSON().with_variant(JSONB(), "postgresql"), nullable=False)


def keys(table: str, **others: str) -> tuple[sa.Constraint, ...]:
    return (
        *(
            sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{table}_{column}"))
            for column, other in ({"studio_id": "accounts_studios"} | others).items()
        ),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{table}")),
    )


def unique(table: str, *columns: str) -> sa.UniqueConstraint:
    return sa.UniqueConstraint(*columns, name=op.f(f"uq_{table}_{'_'.join(columns)}"))


def check(table: str, name: str, condition: str) -> sa.CheckConstraint:
    return sa.CheckConstraint(condition, name=op.f(f"ck_{table}_{name}"))


def upgrade() -> None:
    op.create_table(
        BEDS,
        uuid("id"),
        uuid("studio_id"),
        uuid("project_id"),
        text("category"),
        sa.Column("role", sa.String(length=32), nullable=False),
        uuid("take_id", nullable=True),
        uuid("reference_id", nullable=True),
        figure("level_db", nullable=False),
        sa.Column("is_on", sa.Boolean(), nullable=False),
        uuid("changed_by"),
        instant("changed_at"),
        *keys(
            BEDS,
            project_id="projects_projects",
            take_id="deliveries_takes",
            reference_id="references_references",
            changed_by="accounts_people",
        ),
        unique(BEDS, "project_id", "category", "role"),
        check(BEDS, "take_or_reference", "(take_id is null) <> (reference_id is null)"),
        check(BEDS, "level_in_range", "level_db between -60 and 12"),
    )
    op.create_index(op.f(f"ix_{BEDS}_studio_id"), BEDS, ["studio_id"])
    op.create_table(
        SOUNDS,
        uuid("id"),
        uuid("studio_id"),
        text("sound_sha256"),
        text("part"),
        figure("duration_s"),
        text("excitation", nullable=True),
        json("thumb"),
        text("preview_sha256", nullable=True),
        size("preview_bytes"),
        text("problem"),
        instant("created_at"),
        *keys(SOUNDS),
        unique(SOUNDS, "studio_id", "sound_sha256", "part"),
    )
    op.create_index(f"ix_{SOUNDS}_kept", SOUNDS, ["studio_id", "preview_sha256", "preview_bytes"])
    op.create_table(
        COMPARISONS,
        uuid("id"),
        uuid("studio_id"),
        uuid("project_id"),
        text("sound_sha256"),
        text("against_sha256"),
        figure("lag_s"),
        figure("gain_db"),
        figure("residue_db"),
        json("spectra"),
        text("sha256", nullable=True),
        size("file_bytes"),
        text("refusal", nullable=True),
        instant("created_at"),
        *keys(COMPARISONS, project_id="projects_projects"),
        unique(COMPARISONS, "project_id", "sound_sha256", "against_sha256"),
        check(COMPARISONS, "made_or_refused", "sha256 is null or refusal is null"),
    )
    op.create_index(f"ix_{COMPARISONS}_kept", COMPARISONS, ["studio_id", "sha256", "file_bytes"])


def downgrade() -> None:
    for table in (COMPARISONS, SOUNDS, BEDS):
        op.drop_table(table)
