"""A project's due things as an iCalendar feed, as the holder of a secret address sees them now."""

from collections.abc import Iterator, Sequence
from datetime import date, datetime, timedelta
from itertools import groupby
from typing import TYPE_CHECKING
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements.clauses.named_days import named_days
from app.agreements.clauses.named_term_queries import named_terms
from app.agreements.models import Contract
from app.agreements.plan import queries as plan_queries
from app.agreements.queries import agreed_in
from app.core.money import money
from app.dashboards.due import queries as due_queries
from app.money import calendar
from app.money.errors import CalendarNotFound
from app.money.invoices import service as invoices
from app.money.models import CalendarLink
from app.projects.errors import NdaNeeded, ProjectNotFound
from app.projects.service import ProjectAccess, project_access
from app.sound_lists.models import Cue

if TYPE_CHECKING:
    from icalendar import Event

REFRESH = timedelta(hours=6)
NAMED = 20  # cues of one day that its event names


def feed(session: Session, secret: str) -> bytes:
    """Return the calendar behind a link; raise CalendarNotFound where its holder sees the project no more."""
    from icalendar import Calendar  # 2.5 MiB, for a page that programs fetch a few times a day

    actor, link = calendar.holder_of(session, secret)
    try:
        access = project_access(session, actor, link.project_id)
    except (ProjectNotFound, NdaNeeded):
        raise CalendarNotFound("the person who created this calendar link does not see the project") from None
    name = access.project.name
    contracts = agreed_in(session, actor, link.project_id) if access.is_party else []
    made = Calendar.new(name=name, prodid="-//Soundlist//EN", refresh_interval=REFRESH)
    for event in (
        *_cues_due(session, access, contracts, link),
        *(event for contract in contracts for event in _of_contract(session, actor, contract, name)),
        *_named(session, contracts, name),
    ):
        made.add_component(event)
    return bytes(made.to_ical())


def _cues_due(
    session: Session, access: ProjectAccess, contracts: Sequence[Contract], link: CalendarLink
) -> Iterator["Event"]:
    """Yield one event for each day on which cues are due; a designer's own, once a contract says which those are."""
    own_cue_ids = _own_cues(session, contracts) if access.only_designer_id and contracts else None
    open_cues = [
        cue for cue in due_queries.open_cues(session, link.project_id) if own_cue_ids is None or cue.id in own_cue_ids
    ]
    for day, cues in groupby(open_cues, key=lambda cue: cue.due_on):
        if day is not None:
            due = list(cues)
            yield _event(
                f"cues-{day.isoformat()}-{link.project_id}",
                link.created_at,
                day,
                f"{access.project.name}: {len(due)} {'cue' if len(due) == 1 else 'cues'} due",
                _names(due),
            )


def _own_cues(session: Session, contracts: Sequence[Contract]) -> set[UUID]:
    planned = (cue for contract in contracts for cue in plan_queries.cues_of(session, contract.id))
    return {cue.cue_id for cue in planned if cue.cut_at is None and cue.accepted_at is None}


def _names(cues: Sequence[Cue]) -> str:
    named = ", ".join(cue.name for cue in cues[:NAMED])
    return f"{named} and {len(cues) - NAMED} more" if len(cues) > NAMED else named


def _of_contract(session: Session, actor: Actor, contract: Contract, name: str) -> Iterator["Event"]:
    stamp = contract.agreed_at or contract.created_at
    cues = plan_queries.cues_of(session, contract.id)
    for milestone in plan_queries.milestones_of(session, contract.id):
        if milestone.due_on is not None:
            milestone_cues = [cue for cue in cues if cue.milestone_id == milestone.id and cue.cut_at is None]
            accepted = sum(cue.accepted_at is not None for cue in milestone_cues)
            yield _event(
                str(milestone.id),
                stamp,
                milestone.due_on,
                f"{name}: {milestone.name} due, {accepted} of {len(milestone_cues)} accepted",
                f"{contract.title}, {money(milestone.amount_minor, contract.currency)}",
            )
    for invoice in invoices.invoices(session, actor, contract.id):
        if invoice.state != "paid":
            yield _event(
                str(invoice.id),
                stamp,
                invoice.due_on,
                f"{name}: invoice {invoice.full_number} due",
                f"{contract.title}, {money(invoice.open_minor, invoice.currency)} open",
            )


def _named(session: Session, contracts: Sequence[Contract], name: str) -> Iterator["Event"]:
    terms = named_terms(session, contracts) if contracts else {}
    for contract in contracts:
        if contract.agreed_at is not None:
            for named_day in named_days(terms[contract.id], contract.agreed_at.date()):
                uid = f"{named_day.term}-{named_day.day.isoformat()}-{contract.id}"
                yield _event(uid, contract.agreed_at, named_day.day, f"{name}: {named_day.words}", contract.title)


def _event(uid: str, stamp: datetime, day: date, summary: str, description: str) -> "Event":
    from icalendar import Event

    return Event.new(
        uid=f"{uid}@soundlist",
        stamp=stamp,
        start=day,
        end=day + timedelta(days=1),
        summary=summary,
        description=description,
    )
