"""Indexes by which screens of large projects are read in pages, and not the whole project for each."""

import sqlalchemy as sa
from alembic import op

revision = "0004"
down_revision = "0003"
branch_labels = None
depends_on = None

NEW = (
    ("ix_deliveries_takes_project_waiting", "deliveries_takes", ["project_id", "state", "state_since", "cue_id"]),
    ("ix_deliveries_takes_studio_waiting", "deliveries_takes", ["studio_id", "state", "state_since", "cue_id"]),
    (
        "ix_deliveries_takes_sums",
        "deliveries_takes",
        ["project_id", "cue_id", "variation", "state", "number", "designer_id", "studio_id"],
    ),
    ("ix_deliveries_takes_project_id_id", "deliveries_takes", ["project_id", "id"]),
    ("ix_sound_lists_cues_order", "sound_lists_cues", ["project_id", "position", "number"]),
    ("ix_reviews_verdicts_project_id_id", "reviews_verdicts", ["project_id", "id"]),
    ("ix_reviews_comments_project_id_id", "reviews_comments", ["project_id", "id"]),
    ("ix_reviews_change_requests_project_id_id", "reviews_change_requests", ["project_id", "id"]),
)
# Of some rows only.
NEW_PARTIAL = (
    ("ix_sound_lists_questions_open", "sound_lists_questions", ["project_id", "cue_id"], "answered_at is null"),
    ("ix_reviews_change_requests_drafts", "reviews_change_requests", ["project_id"], "feedback_id is null"),
)
# Begun by a new index, or by a unique constraint.
OLD = (
    ("ix_deliveries_takes_queue", "deliveries_takes", ["project_id", "state", "cue_id"]),
    ("ix_deliveries_takes_studio_id", "deliveries_takes", ["studio_id"]),
    ("ix_deliveries_takes_cue_id", "deliveries_takes", ["cue_id"]),
    ("ix_sound_lists_cues_project_id", "sound_lists_cues", ["project_id"]),
    ("ix_reviews_verdicts_project_id", "reviews_verdicts", ["project_id"]),
    ("ix_reviews_comments_project_id", "reviews_comments", ["project_id"]),
    ("ix_reviews_change_requests_project_id", "reviews_change_requests", ["project_id"]),
)


def upgrade() -> None:
    for name, table, columns in NEW:
        op.create_index(name, table, columns)
    for name, table, columns, of in NEW_PARTIAL:
        op.create_index(name, table, columns, sqlite_where=sa.text(of), postgresql_where=sa.text(of))
    for name, table, _ in OLD:
        op.drop_index(name, table)


def downgrade() -> None:
    for name, table, columns in OLD:
        op.create_index(name, table, columns)
    for name, table, *_ in (*NEW_PARTIAL, *NEW):
        op.drop_index(name, table)
