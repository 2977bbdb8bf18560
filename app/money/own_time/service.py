"""Time without a contract: logged and read by one person, and part of no figure that another sees."""

from collections import defaultdict
from statistics import quantiles
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.hiring.errors import PostingNotFound
from app.hiring.postings.access import posting_access
from app.money.errors import OwnTimeNotFound, WorkNotNamed
from app.money.estimates.rules import ENOUGH
from app.money.ledger.rules import ensure_not_ahead
from app.money.models import OwnTime
from app.money.overview import brief
from app.money.own_time import queries
from app.money.own_time.schemas import CategoryHabit, OwnTimeAdd, OwnTimeRead, OwnTimes
from app.projects.models import Project
from app.projects.service import project_access
from app.sound_lists.service import cue_for


def own_times(session: Session, actor: Actor, project_id: UUID, *, posting_id: UUID | None = None) -> OwnTimes:
    """Return the caller's time in a project, and how long a cue of each category takes them."""
    project = _seen_project(session, actor, project_id, posting_id)
    return OwnTimes(
        times=[_read(time, project) for time in queries.own_times(session, actor.person, project_id)],
        categories=_habits(session, actor.person, project.studio_id),
    )


def log_own_time(session: Session, actor: Actor, project_id: UUID, given: OwnTimeAdd) -> OwnTimeRead:
    """Note time that went into a cue, a bid or a project that the caller sees."""
    project = _seen_project(session, actor, project_id, given.posting_id)
    ensure_not_ahead(given.worked_on, clock.now().date(), "log time only after it was worked")
    if given.cue_id is None and not given.note.strip():
        raise WorkNotNamed("the time names no cue and has no description", fix="choose a cue, or say what it was for")
    cue = None
    if given.cue_id is not None:
        cue = cue_for(session, project_access(session, actor, project_id), given.cue_id)
    time = OwnTime(
        studio_id=project.studio_id,
        project_id=project_id,
        person_id=actor.person,
        cue_id=cue.id if cue else None,
        cue=cue,
        minutes=given.minutes,
        worked_on=given.worked_on,
        note=given.note.strip(),
    )
    session.add(time)
    session.flush()
    return _read(time, project)


def drop_own_time(session: Session, actor: Actor, own_time_id: UUID) -> None:
    """Remove an entry of the caller's."""
    time = queries.own_time_by_id(session, actor.person, own_time_id)
    if time is None:
        raise OwnTimeNotFound(f"no logged time {own_time_id}")
    session.delete(time)
    session.flush()


def _seen_project(session: Session, actor: Actor, project_id: UUID, posting_id: UUID | None) -> Project:
    """Return a project that the caller sees, or of which they see a posting."""
    if posting_id is None:
        return project_access(session, actor, project_id).project
    if posting_access(session, actor, posting_id).posting.project_id != project_id:
        raise PostingNotFound(f"no posting {posting_id} in this project")
    return session.get_one(Project, project_id)


def _habits(session: Session, person_id: UUID, studio_id: UUID) -> list[CategoryHabit]:
    taken: dict[str, list[int]] = defaultdict(list)
    for category, minutes in queries.minutes_of_approved(session, person_id, studio_id):
        taken[category].append(int(minutes))
    habits = []
    for category, minutes_of_cues in sorted(taken.items()):
        if len(minutes_of_cues) >= ENOUGH:
            low, _, high = quantiles(minutes_of_cues, n=4, method="inclusive")
            habits.append(
                CategoryHabit(category=category, cues=len(minutes_of_cues), low_min=round(low), high_min=round(high))
            )
    return habits


def _read(time: OwnTime, project: Project) -> OwnTimeRead:
    return OwnTimeRead(
        id=time.id,
        cue=brief(time.cue, project.cue_prefix) if time.cue else None,
        minutes=time.minutes,
        worked_on=time.worked_on,
        note=time.note,
    )
