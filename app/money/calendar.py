"""The dates of a project's contracts as an iCalendar feed, behind a secret address for each person."""

from datetime import timedelta
from uuid import UUID

from icalendar import Calendar, Event
from sqlalchemy.orm import Session

from app.accounts.authentication import new_secret, sha256_of
from app.accounts.queries import actor_for_person
from app.accounts.rules import Actor
from app.agreements import plan_queries
from app.agreements.models import Contract, Milestone
from app.agreements.queries import agreed_in
from app.kit import clock
from app.kit.db import bypass_row_policies, widen_reach
from app.kit.money import money
from app.money import queries
from app.money.errors import CalendarNotFound
from app.money.models import CalendarLink
from app.projects.errors import ProjectNotFound
from app.projects.models import Project
from app.projects.service import project_access

ICALENDAR = "text/calendar"
REFRESH = timedelta(hours=6)


def make_link(session: Session, actor: Actor, project_id: UUID) -> str:
    """Return the secret of the caller's calendar of a project; an earlier one loses its worth."""
    access = project_access(session, actor, project_id)
    access.ensure_party()
    withdraw_links(session, actor, project_id)
    secret = new_secret()
    session.add(
        CalendarLink(
            studio_id=access.project.studio_id,
            project_id=project_id,
            person_id=actor.person,
            secret_sha256=sha256_of(secret),
        )
    )
    session.flush()
    return secret


def withdraw_links(session: Session, actor: Actor, project_id: UUID) -> None:
    """Revoke the addresses of the caller's calendar of a project."""
    project_access(session, actor, project_id)
    for link in queries.calendars_of(session, project_id, actor.person):
        link.revoked_at = clock.now()


def feed(session: Session, secret: str) -> bytes:
    """Return the calendar behind a link as its holder sees the project now; raise CalendarNotFound for any other."""
    with bypass_row_policies(session):  # the secret is all that says whose calendar it is
        link = queries.calendar_by_secret(session, sha256_of(secret))
        actor = actor_for_person(session, link.person_id) if link else None
    if link is None or actor is None:
        raise CalendarNotFound(
            "this calendar link is unknown or was replaced", fix="create a new calendar link on the Money page"
        )
    widen_reach(session, actor.reach)
    try:
        access = project_access(session, actor, link.project_id)
    except ProjectNotFound:
        raise CalendarNotFound("the person who created this calendar link has left the project") from None
    calendar = Calendar.new(name=access.project.name, prodid="-//Soundlist//EN", refresh_interval=REFRESH)
    for contract in agreed_in(session, actor, link.project_id):
        for event in _events(session, contract, access.project):
            calendar.add_component(event)
    return bytes(calendar.to_ical())


def _events(session: Session, contract: Contract, project: Project) -> list[Event]:
    cues = plan_queries.cues_of(session, contract.id)
    events = []
    for milestone in plan_queries.milestones_of(session, contract.id):
        if milestone.due_on is None:
            continue
        wanted = [cue for cue in cues if cue.milestone_id == milestone.id and cue.cut_at is None]
        accepted = sum(cue.accepted_at is not None for cue in wanted)
        events.append(
            _event(
                contract,
                milestone,
                summary=f"{project.name}: {milestone.name} due, {accepted} of {len(wanted)} accepted",
                description=f"{contract.title}, {money(milestone.amount_minor, contract.currency)}",
            )
        )
    return events


def _event(contract: Contract, milestone: Milestone, *, summary: str, description: str) -> Event:
    if milestone.due_on is None:
        raise AssertionError("only dated milestones are in a calendar")
    return Event.new(
        uid=f"{milestone.id}@soundlist",
        stamp=contract.agreed_at or contract.created_at,
        start=milestone.due_on,
        end=milestone.due_on + timedelta(days=1),
        summary=summary,
        description=description,
    )
