"""Hours of work on a calendar: what is wanted by when, against the hours that designers say they have."""

from collections import defaultdict
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.queries import people_by_id
from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.core import clock
from app.dashboards.hours import queries as hours_queries
from app.dashboards.hours.rules import OpenWork, by_category, outlook, summed
from app.dashboards.hours.schemas import CategoryHours, DesignerHours, HoursSum, ProjectHours, WeekHours
from app.hiring.models import RosterEntry
from app.hiring.roster.rules import Busy, free_days, monday_of
from app.hiring.roster.service import entries_of_bidders
from app.money.queries import worked_minutes
from app.projects.service import project_access


def project_hours(session: Session, actor: Actor, project_id: UUID) -> ProjectHours:
    """Return the hours of a project's agreed work; for producers, who see designers' estimates."""
    access = project_access(session, actor, project_id)
    access.ensure_team()
    access.ensure_producer()
    rows = hours_queries.open_work(session, project_id)
    worked = worked_minutes(session, {contract_id for contract_id, *_ in rows})
    by_designer: dict[UUID, list[OpenWork]] = defaultdict(list)
    for contract_id, designer_id, cue_id, category, estimate_min, due_on in rows:
        minutes = worked.get((contract_id, cue_id), 0)
        by_designer[designer_id].append(OpenWork(cue_id, designer_id, category, estimate_min, minutes, due_on))
    every = [work for works in by_designer.values() for work in works]
    people = people_by_id(session, set(by_designer))
    proven = [person.email for person in people.values() if person.email_proof is not None]
    on_file = entries_of_bidders(session, actor, access.project.studio_id, proven)
    designers = [
        _of_designer(person, by_designer[person.id], *on_file.get(person.email, (None, [])))
        for person in sorted(people.values(), key=lambda person: (person.name, person.id))
    ]
    return ProjectHours(
        total=HoursSum.model_validate(summed(every)),
        uncontracted=hours_queries.uncontracted_cues(session, project_id),
        categories=[CategoryHours(category=name, **vars(category_work)) for name, category_work in by_category(every)],
        designers=designers,
    )


def _of_designer(person: Person, works: list[OpenWork], entry: RosterEntry | None, busy: list[Busy]) -> DesignerHours:
    today = clock.now().date()
    days = free_days(busy, today, entry.available_from_on if entry else None)
    weekly_hours = entry.weekly_hours if entry else None
    return DesignerHours(
        designer=PersonBrief.model_validate(person),
        undated=sum(work.due_on is None for work in works),
        roster_entry_id=entry.id if entry else None,
        weekly_hours=weekly_hours,
        weeks=[WeekHours(**vars(week)) for week in outlook(works, monday_of(today), days, weekly_hours)],
        **vars(summed(works)),
    )
