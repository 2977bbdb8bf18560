"""Effort of a posting, a contract or a whole list, and the size that a brief leads to."""

from collections.abc import Collection, Mapping, Sequence
from datetime import date
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import Actor
from app.agreements.access import visible_contract
from app.agreements.errors import ContractNotFound
from app.agreements.plan.queries import wanted_cues
from app.briefs.queries import answers_of
from app.core import clock
from app.dashboards.effort import queries as effort_queries
from app.dashboards.effort.rules import (
    ASSUMED_WEEKLY_HOURS,
    NO_HOURS,
    Basis,
    Logged,
    Work,
    effort,
    finish_on,
    fit_of,
    size_of_game,
)
from app.dashboards.effort.schemas import Effort, EffortLine, SizeEstimate, SizeLineRead
from app.hiring.errors import PostingNotFound
from app.hiring.postings.access import posting_access
from app.hiring.postings.service import asked_cues
from app.hiring.roster.rules import Busy, BusyKind
from app.hiring.roster.service import entries_of_bidders
from app.projects.service import ProjectAccess, project_access
from app.sound_lists.errors import KitNotFound
from app.sound_lists.kits.rules import all_kits, kit_of
from app.sound_lists.models import Cue
from app.sound_lists.queries import category_counts, cues_by_id
from app.sound_lists.rules import CueState


def project_effort(
    session: Session,
    actor: Actor,
    project_id: UUID,
    *,
    posting_id: UUID | None = None,
    contract_id: UUID | None = None,
    begin_on: date | None = None,
    due_on: date | None = None,
    weekly_hours: float | None = None,
) -> Effort:
    """Return the hours of a posting's cues, a contract's, or those that no agreed contract covers.

    Logged hours count for producers alone; all others get the usual figures.
    """
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    designer: Person | None = None
    estimates: Mapping[UUID, int | None] = {}
    if contract_id is not None:
        contract = visible_contract(session, actor, contract_id)
        if contract.project_id != project_id:
            raise ContractNotFound(f"no contract {contract_id} in this project")
        designer = session.get_one(Person, contract.designer_id)
        estimates = effort_queries.estimated_minutes(session, contract_id)
        planned = cues_by_id(session, project_id, list(estimates))
        cues: Collection[Cue] = planned.values() or wanted_cues(session, project_id)
    elif posting_id is not None:
        if posting_access(session, actor, posting_id).posting.project_id != project_id:
            raise PostingNotFound(f"no posting {posting_id} in this project")
        cues = asked_cues(session, actor, posting_id)
    else:
        cues = wanted_cues(session, project_id)
    works = [Work(cue.category, cue.variations, cue.planned_length_s, estimates.get(cue.id)) for cue in cues]
    lines = effort(works, _histories(session, access, designer))
    hours = sum((line.hours for line in lines), NO_HOURS)
    on_file_hours, busy = _availability(session, actor, access, designer)
    weekly = weekly_hours or on_file_hours or ASSUMED_WEEKLY_HOURS
    today = clock.now().date()
    begin_on = max(begin_on or today, today)
    earliest_on, latest_on = (finish_on(effort_h, begin_on, weekly, busy) for effort_h in (hours.low_h, hours.high_h))
    return Effort(
        cues=len(works),
        files=sum(work.variations for work in works),
        low_h=hours.low_h,
        high_h=hours.high_h,
        concepts=sum(cue.state is CueState.CONCEPT for cue in cues),
        lines=[
            EffortLine(**{name: value for name, value in vars(line).items() if name != "hours"}, **vars(line.hours))
            for line in lines
        ],
        weekly_hours=weekly,
        weekly_hours_from="given" if weekly_hours else "roster" if on_file_hours else "assumed",
        begin_on=begin_on,
        earliest_on=earliest_on,
        latest_on=latest_on,
        due_on=due_on,
        fit=fit_of(due_on, earliest_on, latest_on) if works else None,
    )


def _histories(
    session: Session, access: ProjectAccess, designer: Person | None
) -> Sequence[tuple[Basis, Collection[Logged]]]:
    if not access.is_producer:
        return []
    rows = effort_queries.logged_cues(session, access.project.studio_id)
    of_studio = [
        (designer_id, Logged(Work(category, variations, length_s), int(minutes)))
        for designer_id, category, variations, length_s, minutes in rows
    ]
    of_designer = [logged for designer_id, logged in of_studio if designer is not None and designer_id == designer.id]
    return [(Basis.DESIGNER, of_designer), (Basis.STUDIO, [logged for _, logged in of_studio])]


def _availability(
    session: Session, actor: Actor, access: ProjectAccess, designer: Person | None
) -> tuple[float | None, list[Busy]]:
    """Return the hours a week and the taken days of a designer on file; nothing of one who is not."""
    if designer is None or designer.email_proof is None:
        return None, []
    on_file = entries_of_bidders(session, actor, access.project.studio_id, [designer.email])
    entry, busy = on_file.get(designer.email, (None, []))
    if entry is None:
        return None, []
    if entry.available_from_on is not None:
        busy = [*busy, Busy(date.min, entry.available_from_on - date.resolution, BusyKind.BOOKED)]
    return entry.weekly_hours, busy


def size_estimate(session: Session, actor: Actor, project_id: UUID, *, kit_key: str | None) -> SizeEstimate:
    """Return the cues and hours that the answers of a brief lead to, by one starter kit or by all of them."""
    project_access(session, actor, project_id).ensure_team()
    kit = None if kit_key is None else kit_of(kit_key)
    if kit_key is not None and kit is None:
        raise KitNotFound(f'no kit "{kit_key}"')
    answers = answers_of(session, project_id)
    categories = _value(answers, "categories")
    lines = size_of_game(categories, _value(answers, "scenes"), [kit] if kit else all_kits())
    hours = sum((line.hours for line in lines), NO_HOURS)
    counted = {line.category for line in lines}
    return SizeEstimate(
        low_cues=sum(line.low_cues for line in lines),
        high_cues=sum(line.high_cues for line in lines),
        low_h=hours.low_h,
        high_h=hours.high_h,
        lines=[
            SizeLineRead(**{name: value for name, value in vars(line).items() if name != "hours"}, **vars(line.hours))
            for line in lines
        ],
        unknown=[category for category in categories if category not in counted],
        listed_cues=sum(count for _, count in category_counts(session, project_id)),
    )


def _value(answers: Mapping[str, Any], key: str) -> list[Any]:
    return answers.get(key, {}).get("value") or []
