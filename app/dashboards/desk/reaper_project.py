"""A designer's owed work, as a project for REAPER."""

from collections.abc import Iterator, Sequence
from uuid import UUID

from sqlalchemy.orm import Session

import audio_checks
from app.accounts.rules import Actor
from app.dashboards import queries
from app.dashboards.desk import queries as desk_queries
from app.dashboards.desk.reaper_rules import OwedFile, RenderFormat, reaper_project
from app.dashboards.desk.service import STRETCH
from app.dashboards.progress import queries as progress_queries
from app.dashboards.progress.queries import ListRow
from app.dashboards.rules import CAME_BACK, UNFINISHED, statuses_of
from app.deliveries.models import Take
from app.projects.models import Project
from app.projects.queries import current_spec
from app.projects.service import project_access
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState, label
from app.sound_lists.service import stems_by_cue

MOST_CUES = 2_000
RATE_HZ, DEPTH = 48_000, 24  # where the spec takes any


def reaper_project_of(session: Session, actor: Actor, project_id: UUID) -> str:
    """Return a project with a region for each file that the caller owes, those to change with their change requests."""
    access = project_access(session, actor, project_id)
    access.ensure_designer()
    rows = list(_owed_rows(session, access.project, actor.person))[:MOST_CUES]
    ids = [row.id for row in rows]
    cues = desk_queries.cues_by_id(session, ids)
    stems = stems_by_cue(session, ids)
    back = {
        (cue.id, take.variation): take for take, cue in desk_queries.takes_back(session, ids, actor.person)
    }  # of one variation the last that came back
    notes = _notes(session, list(back.values()))
    pictures = progress_queries.pictures(
        session, access.project.studio_id, [back_take.master_sha256 for back_take in back.values()]
    )
    files = []
    for row in rows:
        names = dict(stems[row.id])
        for variation, status in enumerate(statuses_of(row.facts, row.variations), start=1):
            take = back.get((row.id, variation))
            if (status in UNFINISHED or status in CAME_BACK) and variation in names:
                drawn = pictures.get(take.master_sha256) if take else None
                length_s = drawn.duration_s if drawn else cues[row.id].duration_s
                files.append(OwedFile(names[variation], length_s, notes.get(take.id, ()) if take else ()))
    spec = audio_checks.parse_spec(current_spec(session, project_id).toml)
    about = [_about(cues[row.id], row.number, access.project.cue_prefix) for row in rows]
    return reaper_project(f"{access.project.name}: files to deliver", about, files, _format(spec))


def _owed_rows(session: Session, project: Project, designer_id: UUID) -> Iterator[ListRow]:
    """Yield the cues of the list with a file that the designer owes, in list order."""
    after: tuple[int, int] | None = None
    while True:
        stretch = progress_queries.list_rows(session, project.id, designer_id, after=after, limit=STRETCH)
        for row in stretch:
            if row.state is not CueState.CUT and {*statuses_of(row.facts, row.variations)} & (UNFINISHED | CAME_BACK):
                yield row
        if len(stretch) < STRETCH:
            return
        after = stretch[-1].position, stretch[-1].number


def _notes(session: Session, takes: Sequence[Take]) -> dict[UUID, tuple[tuple[float, str], ...]]:
    notes: dict[UUID, tuple[tuple[float, str], ...]] = {}
    for change, _ in queries.sent_changes(session, [take.id for take in takes]):
        notes[change.take_id] = (*notes.get(change.take_id, ()), (change.start_s or 0.0, change.text))
    return notes


def _about(cue: Cue, number: int, prefix: str) -> str:
    return ": ".join(part for part in (f"{label(prefix, number)} {cue.name}", cue.description or cue.use) if part)


def _format(spec: audio_checks.DeliverySpec) -> RenderFormat:
    rates, depths = spec.accept.sample_rates_hz, spec.accept.bit_depths
    return RenderFormat(
        RATE_HZ if not rates or RATE_HZ in rates else rates[0], DEPTH if not depths or DEPTH in depths else depths[0]
    )
