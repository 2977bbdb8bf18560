"""Seals of signed contracts, and what was last mailed of the head of a record."""

import sqlalchemy as sa
from alembic import op

import app.kit.db

revision = "0035"
down_revision = "0034"
branch_labels = None
depends_on = None

SEALS, CONTRACTS = "contracts_seals", "contracts_contracts"
NAMED = {
    "studio_id": "accounts_studios",
    "project_id": "projects_projects",
    "contract_id": CONTRACTS,
    "version_id": "contracts_versions",
}


def upgrade() -> None:
    op.create_table(
        SEALS,
        sa.Column("id", sa.Uuid(), nullable=False),
        *(sa.Column(name, sa.Uuid(), nullable=False) for name in NAMED),
        sa.Column("file_sha256", sa.String(), nullable=False),
        sa.Column("file_bytes", sa.Integer(), nullable=False),
        sa.Column("key_sha256", sa.String(), nullable=False),
        sa.Column("is_timestamped", sa.Boolean(), nullable=False),
        sa.Column("sealed_at", app.kit.db.UtcDateTime(timezone=True), nullable=False),
        *(
            sa.ForeignKeyConstraint([name], [f"{other}.id"], name=op.f(f"fk_{SEALS}_{name}"))
            for name, other in NAMED.items()
        ),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{SEALS}")),
        sa.UniqueConstraint("version_id", name=op.f(f"uq_{SEALS}_version_id")),
    )
    for column in ("studio_id", "project_id", "contract_id", "file_sha256"):
        op.create_index(op.f(f"ix_{SEALS}_{column}"), SEALS, [column])
    with op.batch_alter_table(CONTRACTS) as table:
        table.add_column(sa.Column("head_mailed_length", sa.Integer(), nullable=False, server_default="0"))
        table.add_column(sa.Column("head_mailed_on", sa.Date()))
    with op.batch_alter_table(CONTRACTS) as table:
        table.alter_column("head_mailed_length", server_default=None)


def downgrade() -> None:
    with op.batch_alter_table(CONTRACTS) as table:
        table.drop_column("head_mailed_on")
        table.drop_column("head_mailed_length")
    op.drop_table(SEALS)
