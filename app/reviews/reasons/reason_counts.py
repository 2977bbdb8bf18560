"""Reasons found again: how often each was given in a project, and of which versions."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.core.web.http import Page, cursor_of, uuid_cursor
from app.projects.service import ProjectAccess, project_access
from app.reviews.reasons import queries
from app.reviews.reasons.queries import ReasonFilter, ReasonPlace
from app.reviews.reasons.rules import ReasonKind
from app.reviews.reasons.schemas import ReasonCount, ReasonPlaceRead, ReasonsRead
from app.sound_lists.rules import label

PAGE_PLACES = 50


def reason_counts(
    session: Session, actor: Actor, project_id: UUID, *, designer_id: UUID | None, category: str | None
) -> ReasonsRead:
    """Return the number of uses of each reason; a designer sees those of their own takes."""
    access = project_access(session, actor, project_id)
    reason_filter = _filter(access, designer_id, category)
    counted = queries.counts(session, reason_filter)
    designers = queries.designers_with_reasons(session, project_id) if access.is_team else []
    return ReasonsRead(
        change=[ReasonCount(reason=reason, versions=number) for kind, reason, number in counted if kind == "change"],
        pick=[ReasonCount(reason=reason, versions=number) for kind, reason, number in counted if kind == "pick"],
        designers=[PersonBrief.model_validate(designer) for designer in designers],
        categories=list(queries.categories_with_reasons(session, _filter(access, None, None))),
    )


def reason_places(
    session: Session,
    actor: Actor,
    project_id: UUID,
    kind: ReasonKind,
    reason: str,
    *,
    designer_id: UUID | None,
    category: str | None,
    cursor: str | None,
) -> Page[ReasonPlaceRead]:
    """Return the versions of which a reason was given, newest first."""
    access = project_access(session, actor, project_id)
    reason_filter = _filter(access, designer_id, category)
    reason_rows = queries.places(session, reason_filter, kind, reason, after=uuid_cursor(cursor), limit=PAGE_PLACES + 1)
    shown = reason_rows[:PAGE_PLACES]
    return Page(
        items=[_shown(row, access.project.cue_prefix) for row in shown],
        next=cursor_of(shown[-1].verdict.id) if len(reason_rows) > len(shown) else None,
    )


def _filter(access: ProjectAccess, designer_id: UUID | None, category: str | None) -> ReasonFilter:
    """Return a filter within the caller's sight: a designer's own takes, whatever designer was asked for."""
    return ReasonFilter(access.project.id, access.only_designer_id or designer_id, category)


def _shown(reason_place: ReasonPlace, prefix: str) -> ReasonPlaceRead:
    verdict, take, cue = reason_place.verdict, reason_place.take, reason_place.cue
    return ReasonPlaceRead(
        verdict_id=verdict.id,
        take_id=take.id,
        cue_id=cue.id,
        cue_label=label(prefix, cue.number),
        cue_name=cue.name,
        variation=take.variation,
        number=take.number or 0,
        label=take.label,
        designer=PersonBrief.model_validate(take.designer),
        given_by=PersonBrief.model_validate(verdict.author) if verdict.author else None,
        on_behalf_of=PersonBrief.model_validate(verdict.represented) if verdict.represented else None,
        given_at=verdict.created_at,
        reasons=verdict.reasons,
        text=verdict.note,
        start_s=reason_place.start_s,
    )
