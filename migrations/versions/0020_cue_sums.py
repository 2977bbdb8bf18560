"""What the takes of each cue add up to is kept, so that screens need not read the takes."""

from collections.abc import Iterator
from itertools import groupby
from typing import Any

import sqlalchemy as sa
from alembic import op

import app.kit.db

revision = "0020"
down_revision = "0019"
branch_labels = None
depends_on = None

CODES = {
    "received": 1,
    "conforming": 2,
    "returned": 3,
    "unjudged": 4,
    "approved": 5,
    "change_requested": 6,
    "set_aside": 7,
}
WITH_DESIGNER = ("returned", "change_requested", "unjudged")
AT_ONCE = 5_000
CUE_STATE = sa.Enum("concept", "prototype", "locked", "cut", name="cuestate", native_enum=False, length=32)
TAKES = sa.table(
    "deliveries_takes",
    *(sa.column(name, sa.Uuid()) for name in ("id", "cue_id", "studio_id", "project_id", "designer_id")),
    *(sa.column(name, sa.Integer()) for name in ("variation", "number")),
    sa.column("state", sa.String()),
    *(sa.column(name, app.kit.db.UtcDateTime(timezone=True)) for name in ("state_since", "received_at")),
)
CUES = sa.table(
    "sound_lists_cues",
    *(sa.column(name, sa.Uuid()) for name in ("id", "studio_id", "project_id")),
    *(sa.column("state", sa.String()), sa.column("variations", sa.Integer()), sa.column("placeholder", sa.Boolean())),
)
PROJECTS = sa.table("projects_projects", sa.column("id", sa.Uuid()))


def upgrade() -> None:
    cue = ["id", "state", "variations", "placeholder"]
    counted = ["state", "project_id", "variations", "placeholder"]
    op.create_index("ix_sound_lists_cues_counted", "sound_lists_cues", counted)
    op.create_index("uq_sound_lists_cues_summed", "sound_lists_cues", cue, unique=True)
    instant = app.kit.db.UtcDateTime(timezone=True)
    sums = op.create_table(
        "deliveries_cue_sums",
        sa.Column("cue_id", sa.Uuid(), nullable=False),
        sa.Column("viewer_id", sa.Uuid(), nullable=False),
        sa.Column("studio_id", sa.Uuid(), nullable=False),
        sa.Column("project_id", sa.Uuid(), nullable=False),
        sa.Column("state", CUE_STATE, nullable=False),
        sa.Column("variations", sa.Integer(), nullable=False),
        sa.Column("placeholder", sa.Boolean(), nullable=False),
        sa.Column("facts", sa.String(), nullable=False),
        sa.Column("newest_id", sa.Uuid(), nullable=False),
        sa.Column("newest_back_since", instant, nullable=True),
        sa.Column("back_since", instant, nullable=True),
        sa.ForeignKeyConstraint(
            ["cue_id", "state", "variations", "placeholder"],
            [f"sound_lists_cues.{name}" for name in cue],
            name="fk_deliveries_cue_sums_cue",
            onupdate="CASCADE",
        ),
        sa.ForeignKeyConstraint(["newest_id"], ["deliveries_takes.id"], name=op.f("fk_deliveries_cue_sums_newest_id")),
        sa.ForeignKeyConstraint(
            ["project_id"], ["projects_projects.id"], name=op.f("fk_deliveries_cue_sums_project_id")
        ),
        sa.ForeignKeyConstraint(["studio_id"], ["accounts_studios.id"], name=op.f("fk_deliveries_cue_sums_studio_id")),
        sa.PrimaryKeyConstraint("cue_id", "viewer_id", name=op.f("pk_deliveries_cue_sums")),
        sqlite_with_rowid=False,
    )
    _fill(sums)
    op.create_index(
        "ix_deliveries_cue_sums_alike",
        "deliveries_cue_sums",
        ["project_id", "viewer_id", "state", "variations", "placeholder", "facts", "studio_id"],
    )
    for name, since, further in (
        ("ix_deliveries_cue_sums_newest_back", "newest_back_since", []),
        ("ix_deliveries_cue_sums_back", "back_since", ["cue_id"]),
    ):
        row_exists = sa.text(f"{since} is not null")
        columns = ["project_id", "viewer_id", since, *further]
        op.create_index(name, "deliveries_cue_sums", columns, sqlite_where=row_exists, postgresql_where=row_exists)
    op.create_index(
        "ix_sound_lists_cues_palette",
        "sound_lists_cues",
        ["project_id", "position", "number"],
        sqlite_where=sa.text("palette = 1"),
        postgresql_where=sa.text("palette"),
    )


def _fill(sums: sa.Table) -> None:
    """Sum up the takes that are there, cue by cue."""
    matched = sa.select(TAKES).where(TAKES.c.cue_id.is_not(None)).order_by(TAKES.c.cue_id, TAKES.c.number)
    connection, rows = op.get_bind(), []
    facts = [CUES.c[name] for name in ("studio_id", "project_id", "state", "variations", "placeholder")]
    for project_id in connection.scalars(sa.select(PROJECTS.c.id)).all():
        of_list = sa.select(CUES.c.id, *facts).where(CUES.c.project_id == project_id)
        cues = {cue.id: {fact.name: cue._mapping[fact] for fact in facts} for cue in connection.execute(of_list)}
        takes = connection.execute(matched.where(TAKES.c.project_id == project_id)).all()
        for cue_id, of_cue in groupby(takes, key=lambda take: take.cue_id):
            for viewer_id, own in _views(list(of_cue)):
                rows.append({"cue_id": cue_id, "viewer_id": viewer_id, **cues[cue_id], **_sums(own)})
        for start in range(0, len(rows), AT_ONCE):
            connection.execute(sa.insert(sums), rows[start : start + AT_ONCE])
        rows.clear()


def _views(takes: list[Any]) -> Iterator[tuple[Any, list[Any]]]:
    yield takes[0].studio_id, takes
    for designer_id in {take.designer_id for take in takes}:
        yield designer_id, [take for take in takes if take.designer_id == designer_id]


def _sums(takes: list[Any]) -> dict[str, Any]:
    variations: list[list[Any]] = [[] for _ in range(max(take.variation for take in takes))]
    for take in takes:
        variations[take.variation - 1].append(take)
    last = max(takes, key=lambda take: (take.received_at, take.id))
    back = [own[-1] for own in variations if own and own[-1].state in WITH_DESIGNER]
    return {
        "facts": ",".join(str(_packed([take.state for take in own])) for own in variations),
        "newest_id": last.id,
        "newest_back_since": last.state_since if last.state in WITH_DESIGNER else None,
        "back_since": min((take.state_since for take in back), default=None),
    }


def _packed(states: list[str]) -> int:
    seen = [state for state in states if state != "set_aside"]
    flags = 2 * ("approved" in states) + ("conforming" in states)
    return flags * 8 + (CODES[seen[-1]] if seen else 0)


def downgrade() -> None:
    op.drop_index("ix_sound_lists_cues_palette", "sound_lists_cues")
    op.drop_table("deliveries_cue_sums")
    op.drop_index("uq_sound_lists_cues_summed", "sound_lists_cues")
    op.drop_index("ix_sound_lists_cues_counted", "sound_lists_cues")
