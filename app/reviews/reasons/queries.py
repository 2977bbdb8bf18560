"""Reasons and labels, read from the database; callers have checked access."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any
from uuid import UUID

from sqlalchemy import Integer, Select, and_, cast, func, select
from sqlalchemy.orm import Session, joinedload

from app.accounts.models import Person
from app.deliveries.models import Take
from app.reviews.models import ChangeRequest, GivenReason, ReasonList, Verdict
from app.reviews.reasons.rules import ReasonKind
from app.sound_lists.models import Cue


def lists_of(session: Session, studio_id: UUID) -> dict[ReasonKind, Sequence[str]]:
    """Return the lists that a studio wrote."""
    query = select(ReasonList.kind, ReasonList.reasons).where(ReasonList.studio_id == studio_id)
    return dict(session.execute(query).all())


@dataclass(frozen=True)
class ReasonFilter:
    """The versions whose reasons are wanted; None filters nothing."""

    project_id: UUID
    designer_id: UUID | None = None
    category: str | None = None


@dataclass(frozen=True)
class ReasonPlace:
    """A verdict that gave a reason, with its version, its cue, and where in the sound a change was meant."""

    verdict: Verdict
    take: Take
    cue: Cue
    start_s: float | None


def counts(session: Session, reason_filter: ReasonFilter) -> Sequence[tuple[ReasonKind, str, int]]:
    """Return the number of uses of each reason, the most frequent first."""
    given = func.count()
    query = _filtered(select(GivenReason.kind, GivenReason.reason, given.label("given")), reason_filter)
    grouped = query.group_by(GivenReason.kind, GivenReason.reason)
    if reason_filter.category is None:
        return session.execute(grouped.order_by(given.desc(), GivenReason.reason)).all()
    # By cue first: SQLite otherwise reads the rows of all categories, in the order of their reasons.
    by_cue = grouped.group_by(GivenReason.cue_id, GivenReason.designer_id).subquery()
    uses = cast(func.sum(by_cue.c.given), Integer)
    summed = select(by_cue.c.kind, by_cue.c.reason, uses).group_by(by_cue.c.kind, by_cue.c.reason)
    return session.execute(summed.order_by(uses.desc(), by_cue.c.reason)).all()


def designers_with_reasons(session: Session, project_id: UUID) -> Sequence[Person]:
    """Return the designers of whose takes reasons were given, by name."""
    ids = select(GivenReason.designer_id).where(GivenReason.project_id == project_id).distinct()
    return session.scalars(select(Person).where(Person.id.in_(ids)).order_by(Person.name, Person.id)).all()


def categories_with_reasons(session: Session, reason_filter: ReasonFilter) -> Sequence[str]:
    """Return the categories of the cues of which reasons were given, by name; empty for cues without one."""
    is_given = _filtered(select(GivenReason.cue_id), reason_filter).where(GivenReason.cue_id == Cue.id).exists()
    of_project = select(Cue.category).distinct().where(Cue.project_id == reason_filter.project_id)
    return session.scalars(of_project.where(is_given).order_by(Cue.category)).all()


def places(
    session: Session, reason_filter: ReasonFilter, kind: ReasonKind, reason: str, *, after: UUID | None, limit: int
) -> list[ReasonPlace]:
    """Return the verdicts that gave a reason, newest first."""
    query = (
        _filtered(select(Verdict, Take, Cue, ChangeRequest.start_s).select_from(GivenReason), reason_filter)
        .join(Verdict, Verdict.id == GivenReason.verdict_id)
        .join(Take, Take.id == Verdict.take_id)
        .join(Cue, Cue.id == GivenReason.cue_id)
        .outerjoin(ChangeRequest, ChangeRequest.id == GivenReason.change_request_id)
        .where(and_(GivenReason.kind == kind, GivenReason.reason == reason))
        .options(joinedload(Verdict.author), joinedload(Verdict.represented), joinedload(Take.designer))
        .order_by(GivenReason.verdict_id.desc())
        .limit(limit)
    )
    if after is not None:
        query = query.where(GivenReason.verdict_id < after)
    return [ReasonPlace(*row) for row in session.execute(query)]


def _filtered(query: Select[*tuple[Any, ...]], reason_filter: ReasonFilter) -> Select[*tuple[Any, ...]]:
    query = query.where(GivenReason.project_id == reason_filter.project_id)
    if reason_filter.designer_id is not None:
        query = query.where(GivenReason.designer_id == reason_filter.designer_id)
    if reason_filter.category is not None:
        of_category = select(Cue.id).where(
            Cue.project_id == reason_filter.project_id, Cue.category == reason_filter.category
        )
        query = query.where(GivenReason.cue_id.in_(of_category))
    return query
