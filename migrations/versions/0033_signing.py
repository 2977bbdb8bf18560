"""Named signers and their order, codes to sign with, and the browser that a signature came from."""

import sqlalchemy as sa
from alembic import op

import app.kit.db

revision = "0033"
down_revision = "0032"
branch_labels = None
depends_on = None

SIGNERS, CODES = "contracts_signers", "contracts_signing_codes"
CONTRACTS, ACCEPTANCES, AMENDMENTS = "contracts_contracts", "contracts_acceptances", "contracts_amendment_acceptances"
PARTY = sa.Enum("studio", "designer", name="party", native_enum=False, length=32)


def instant() -> app.kit.db.UtcDateTime:
    return app.kit.db.UtcDateTime(timezone=True)


def columns_of(table: str) -> list[sa.schema.SchemaItem]:
    named = {
        "studio_id": "accounts_studios",
        "project_id": "projects_projects",
        "contract_id": CONTRACTS,
        "person_id": "accounts_people",
    }
    return [
        sa.Column("id", sa.Uuid(), nullable=False),
        *(sa.Column(name, sa.Uuid(), nullable=False) for name in named),
        *(
            sa.ForeignKeyConstraint([name], [f"{other}.id"], name=op.f(f"fk_{table}_{name}"))
            for name, other in named.items()
        ),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{table}")),
    ]


def index(table: str, *columns: str) -> None:
    for column in columns:
        op.create_index(op.f(f"ix_{table}_{column}"), table, [column])


def upgrade() -> None:
    op.create_table(
        SIGNERS,
        *columns_of(SIGNERS),
        sa.Column("position", sa.Integer(), nullable=False),
        sa.UniqueConstraint("contract_id", "position", name=op.f(f"uq_{SIGNERS}_contract_id_position")),
        sa.UniqueConstraint("contract_id", "person_id", name=op.f(f"uq_{SIGNERS}_contract_id_person_id")),
    )
    index(SIGNERS, "studio_id", "project_id")
    op.create_table(
        CODES,
        *columns_of(CODES),
        sa.Column("text_sha256", sa.String(), nullable=False),
        sa.Column("code_hash", sa.String()),
        sa.Column("tries", sa.Integer(), nullable=False),
        sa.Column("expires_at", instant(), nullable=False),
        sa.Column("used_at", instant()),
    )
    index(CODES, "studio_id", "project_id", "contract_id")
    with op.batch_alter_table(CONTRACTS) as table:
        table.add_column(sa.Column("signs_first", PARTY))
    for acceptances in (ACCEPTANCES, AMENDMENTS):
        with op.batch_alter_table(acceptances) as table:
            table.add_column(sa.Column("agent", sa.String(), nullable=False, server_default=""))
            table.add_column(sa.Column("code_entered_at", instant()))
        with op.batch_alter_table(acceptances) as table:
            table.alter_column("agent", server_default=None)
    with op.batch_alter_table(ACCEPTANCES) as table:
        table.drop_constraint(op.f(f"uq_{ACCEPTANCES}_version_id_party"), type_="unique")
        table.create_unique_constraint(op.f(f"uq_{ACCEPTANCES}_version_id_person_id"), ["version_id", "person_id"])


def downgrade() -> None:
    with op.batch_alter_table(ACCEPTANCES) as table:
        table.drop_constraint(op.f(f"uq_{ACCEPTANCES}_version_id_person_id"), type_="unique")
        table.create_unique_constraint(op.f(f"uq_{ACCEPTANCES}_version_id_party"), ["version_id", "party"])
    for acceptances in (ACCEPTANCES, AMENDMENTS):
        with op.batch_alter_table(acceptances) as table:
            table.drop_column("code_entered_at")
            table.drop_column("agent")
    with op.batch_alter_table(CONTRACTS) as table:
        table.drop_column("signs_first")
    op.drop_table(CODES)
    op.drop_table(SIGNERS)
