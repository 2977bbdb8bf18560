"""A designer's takes are found by their cues and projects, not by going through all that the designer ever made."""

from alembic import op

revision = "0017"
down_revision = "0016"
branch_labels = None
depends_on = None


def upgrade() -> None:
    with op.batch_alter_table("deliveries_takes", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_deliveries_takes_designer_id"))


def downgrade() -> None:
    with op.batch_alter_table("deliveries_takes", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_deliveries_takes_designer_id"), ["designer_id"], unique=False)
