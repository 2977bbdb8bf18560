"""Facts known of a designer from work for one studio, seen by that studio and by the designer alone."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.dashboards.track_record import queries as work_queries
from app.dashboards.track_record.schemas import WorkedProject, WorkFigures
from app.dashboards.velocity.rules import CuePace, days_late, first_pass_share, mean_rounds, median_hours, on_time_share
from app.dashboards.velocity.service import cue_paces
from app.hiring.roster.queries import designers_of
from app.hiring.roster.service import entry_seen
from app.money.estimates.rules import error_rate
from app.money.estimates.service import estimates_of
from app.money.schemas import HabitRead


def work_of_entry(session: Session, actor: Actor, entry_id: UUID) -> WorkFigures | None:
    """Return facts known of a designer on file; None where no proven account of that address works for the studio."""
    access, entry = entry_seen(session, actor, entry_id)
    person = designers_of(session, entry.studio_id, [entry.email]).get(entry.email)
    if person is None:
        return None
    return _figures(session, access.studio.id, access.studio.name, person.id, with_estimates=access.is_producer)


def own_work(session: Session, actor: Actor) -> list[WorkFigures]:
    """Return the facts that the studios that the caller works or worked for know from that work."""
    return [
        _figures(session, studio_id, name, actor.person, with_estimates=True)
        for studio_id, name in work_queries.studios_of(session, actor.person)
    ]


def _figures(
    session: Session, studio_id: UUID, studio_name: str, designer_id: UUID, *, with_estimates: bool
) -> WorkFigures:
    now = clock.now()
    every: list[CuePace] = []
    projects = []
    for project_id, name, since in work_queries.projects_of(session, studio_id, designer_id):
        paces = list(cue_paces(session, project_id, designer_id).values())
        accepted = sum(pace.accepted_at is not None for pace in paces)
        projects.append(WorkedProject(id=project_id, name=name, since=since, accepted=accepted))
        every += paces
    revisions = work_queries.revision_times(session, studio_id, designer_id)
    return WorkFigures(
        studio_id=studio_id,
        studio_name=studio_name,
        projects=projects,
        accepted=sum(project.accepted for project in projects),
        on_time=on_time_share(every, now.date()),
        days_late=days_late(every, now.date()),
        first_pass=first_pass_share(every),
        rounds_per_cue=mean_rounds(every),
        revision_hours=median_hours(revisions, now),
        estimates=_estimates(session, studio_id, designer_id) if with_estimates else None,
    )


def _estimates(session: Session, studio_id: UUID, designer_id: UUID) -> HabitRead:
    pairs = [
        (cue.estimate, cue.actual)
        for contract in work_queries.contracts_of(session, studio_id, designer_id)
        for cue in estimates_of(session, contract).cues
        if cue.actual is not None
    ]
    rate = error_rate(pairs)
    return HabitRead(
        pairs=rate.pairs, mean_percent=rate.mean_percent, spread_points=rate.spread_points, habit=rate.habit
    )
