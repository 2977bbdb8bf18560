"""Progress of cues, summed up from their takes; each function is one SELECT, whatever the size of the project."""

from collections import Counter, defaultdict
from collections.abc import Collection
from datetime import datetime
from functools import cache
from typing import Any, NamedTuple
from uuid import UUID

from sqlalchemy import ColumnElement, Select, and_, bindparam, case, exists, func, or_, select, tuple_, union_all
from sqlalchemy.orm import Session, aliased, load_only
from typing_extensions import TypeVarTuple

from app.conformance.models import CheckRun, Waiver
from app.core.exists import row_exists
from app.core.in_array import in_array
from app.deliveries.cue_counts.rules import CODE_BASE, STATE_CODES
from app.deliveries.models import Take, TakeCounts
from app.deliveries.rules import TakeState
from app.renders.models import Picture
from app.reviews.models import HeardTake, Round
from app.sound_lists.models import Cue, Question
from app.sound_lists.rules import CueState, Need, Phase

DECIDED = 50
Ts = TypeVarTuple("Ts")


def _packed() -> ColumnElement[int]:
    """Sum up the takes of one variation in a whole number; `VariationFact.unpacked` reads it."""
    approved = func.max(case((Take.state == TakeState.APPROVED, 2), else_=0))
    waiting = func.max(case((Take.state == TakeState.CONFORMING, 1), else_=0))
    code = case(dict(STATE_CODES), value=Take.state)
    newest = func.max(case((Take.state != TakeState.SET_ASIDE, Take.number * CODE_BASE + code), else_=0)) % CODE_BASE
    return (approved + waiting) * CODE_BASE + newest


def _seen_by(query: Select[*Ts], designer_id: UUID | None) -> Select[*Ts]:
    return query if designer_id is None else query.where(Take.designer_id == designer_id)


class CueGroup(NamedTuple):
    """The number of cues of a list that are equal in all facts of their status."""

    state: CueState
    variations: int
    placeholder: bool
    is_asked: bool
    facts: str | None
    cues: int


def cue_groups(session: Session, project_id: UUID, viewer_id: UUID) -> list[CueGroup]:
    """Return the numbers of cues by state in a view: a designer's id is for their own takes, the studio's for all.

    Cues with takes are counted by their stored sums, all others by the list; those on which a
    question is open are few, and looked up.
    """
    kept = (TakeCounts.state, TakeCounts.variations, TakeCounts.placeholder, TakeCounts.facts)
    listed = (Cue.state, Cue.variations, Cue.placeholder)
    counts: Counter[tuple[CueState, int, bool, bool, str | None]] = Counter()
    of_view = (TakeCounts.project_id == project_id, TakeCounts.viewer_id == viewer_id)
    for state, variations, placeholder, facts, cues in session.execute(
        select(*kept, func.count()).where(*of_view).group_by(*kept)
    ):
        counts[state, variations, placeholder, False, facts] += cues
        counts[state, variations, placeholder, False, None] -= cues
    in_list = (Cue.project_id == project_id, Cue.state.in_([*CueState]))
    for state, variations, placeholder, cues in session.execute(
        select(*listed, func.count()).where(*in_list).group_by(*listed)
    ):
        counts[state, variations, placeholder, False, None] += cues
    asked = select(Question.cue_id).where(Question.project_id == project_id, Question.answered_at.is_(None))
    for state, variations, placeholder, facts in session.execute(
        select(*listed, TakeCounts.facts).join(TakeCounts, _of_view(viewer_id), isouter=True).where(Cue.id.in_(asked))
    ):
        counts[state, variations, placeholder, False, facts] -= 1
        counts[state, variations, placeholder, True, facts] += 1
    return [CueGroup(*alike, cues) for alike, cues in counts.items() if cues]


class NeedGroup(NamedTuple):
    """The number of cues of a list that are equal in their need and in all facts of their status."""

    need: Need
    state: CueState
    variations: int
    placeholder: bool
    facts: str | None
    cues: int


def need_groups(session: Session, project_id: UUID, viewer_id: UUID) -> list[NeedGroup]:
    """Return the numbers of cues that are not cut by need and status in a view."""
    alike = (Cue.need, Cue.state, Cue.variations, Cue.placeholder, TakeCounts.facts)
    query = select(*alike, func.count()).join(TakeCounts, _of_view(viewer_id), isouter=True).select_from(Cue)
    query = query.where(Cue.project_id == project_id, Cue.state != CueState.CUT).group_by(*alike)
    return [NeedGroup._make(row) for row in session.execute(query)]


def _is_asked() -> ColumnElement[bool]:
    asked = (Question.project_id == Cue.project_id, Question.cue_id == Cue.id, Question.answered_at.is_(None))
    return exists().where(*asked)


def _of_view(viewer_id: UUID) -> ColumnElement[bool]:
    return and_(TakeCounts.cue_id == Cue.id, TakeCounts.viewer_id == viewer_id)


class ListRow(NamedTuple):
    """One cue of the list with the packed facts of its variations; None where nothing came."""

    id: UUID
    number: int
    position: int
    name: str
    state: CueState
    variations: int
    placeholder: bool
    palette: bool
    phase: Phase | None
    category: str
    is_asked: bool
    facts: str | None


def list_rows(
    session: Session,
    project_id: UUID,
    viewer_id: UUID,
    *,
    after: tuple[int, int] | None = None,
    limit: int | None = None,
    only: ColumnElement[bool] | None = None,
) -> list[ListRow]:
    """Return the cues that follow a position and number in list order, with what their takes add up to in a view."""
    columns = (Cue.id, Cue.number, Cue.position, Cue.name, Cue.state, Cue.variations, Cue.placeholder, Cue.palette)
    query = select(*columns, Cue.phase, Cue.category, _is_asked(), TakeCounts.facts).join(
        TakeCounts, _of_view(viewer_id), isouter=True
    )
    query = query.select_from(Cue).where(Cue.project_id == project_id)
    if after is not None:
        query = query.where(tuple_(Cue.position, Cue.number) > tuple_(*after))
    if only is not None:
        query = query.where(only)
    return [ListRow._make(row) for row in session.execute(query.order_by(Cue.position, Cue.number).limit(limit))]


class VariationRow(NamedTuple):
    """The sums of the takes of one variation."""

    cue_id: UUID
    variation: int
    packed: int
    waiting: int
    newest: int
    since: datetime


def variation_rows(session: Session, cue_ids: Collection[UUID], designer_id: UUID | None) -> list[VariationRow]:
    """Return the sums of the takes of some cues, by variation."""
    rows = session.execute(_variation_rows(designer_id is not None), _given(cue_ids, designer_id))
    return [VariationRow._make(row) for row in rows]


def _given(cue_ids: Collection[UUID], designer_id: UUID | None) -> dict[str, Any]:
    return {"cue_ids": cue_ids, "designer_id": designer_id}


def _owned(query: Select[*Ts], is_own: bool) -> Select[*Ts]:
    return query.where(Take.designer_id == bindparam("designer_id")) if is_own else query


# Statements of a page are built once: that takes longer than to send them. `is_own`: one designer's takes alone.
@cache
def _variation_rows(is_own: bool) -> Select[UUID | None, int, int, int, int | None, datetime]:
    waiting = func.count(case((Take.state == TakeState.CONFORMING, 1)))
    summed = select(
        Take.cue_id, Take.variation, _packed(), waiting, func.max(Take.number), func.max(Take.state_since)
    ).where(in_array(Take.cue_id, "cue_ids"))
    return _owned(summed, is_own).group_by(Take.cue_id, Take.variation)


class ShownTake(NamedTuple):
    """The take that represents a cue in a list, and its drawing."""

    cue_id: UUID
    id: UUID
    number: int | None
    variation: int
    state: TakeState
    file_name: str
    received_at: datetime
    picture_id: UUID | None
    duration_s: float | None


def shown_takes(
    session: Session,
    cue_ids: Collection[UUID],
    viewer_id: UUID,
    designer_id: UUID | None,
    *,
    accepted: Collection[UUID],
) -> dict[UUID, ShownTake]:
    """Return the take that represents each cue in a list: the approved one of an accepted cue, else the newest."""
    others = [id_ for id_ in cue_ids if id_ not in accepted]
    given = {"cue_ids": others, "viewer_id": viewer_id, "accepted": accepted, "designer_id": designer_id}
    rows = session.execute(_shown_takes(designer_id is not None), given)
    return {take.cue_id: take for take in map(ShownTake._make, rows)}


@cache
def _shown_takes(is_own: bool) -> Select[*tuple[Any, ...]]:
    newest = select(TakeCounts.newest_id).where(
        in_array(TakeCounts.cue_id, "cue_ids"), TakeCounts.viewer_id == bindparam("viewer_id")
    )
    approved = (in_array(Take.cue_id, "accepted"), Take.state == TakeState.APPROVED, Take.variation == 1)
    shown = union_all(newest, _owned(select(Take.id), is_own).where(*approved))
    columns = (Take.cue_id, Take.id, Take.number, Take.variation, Take.state, Take.file_name, Take.received_at)
    return (
        select(*columns, Picture.id, Picture.duration_s)
        .outerjoin(Picture, and_(Picture.studio_id == Take.studio_id, Picture.sound_sha256 == Take.master_sha256))
        .where(Take.id.in_(shown))
    )


def first_open_questions(session: Session, project_id: UUID, cue_ids: Collection[UUID]) -> dict[UUID, str]:
    """Return the question that waits longest for an answer, by cue."""
    return dict(session.execute(_open_questions(), {"project_id": project_id, "cue_ids": cue_ids}).all())


@cache
def _open_questions() -> Select[UUID, str]:
    asked = (Question.project_id == bindparam("project_id"), in_array(Question.cue_id, "cue_ids"))
    query = select(Question.cue_id, Question.text).where(*asked, Question.answered_at.is_(None))
    return query.order_by(Question.asked_at.desc())


def current_findings(
    session: Session, cue_ids: Collection[UUID], designer_id: UUID | None
) -> dict[UUID, list[dict[str, Any]]]:
    """Return the findings in the takes of some cues that stand, in the order that the takes came.

    A returned take stands until a newer one of its variation came, as a fix or from the session.
    """
    findings_by_cue: dict[UUID, list[dict[str, Any]]] = defaultdict(list)
    for cue_id, each in session.execute(_current_findings(designer_id is not None), _given(cue_ids, designer_id)):
        findings_by_cue[cue_id] += each
    return findings_by_cue


@cache
def _current_findings(is_own: bool) -> Select[UUID | None, Any]:
    findings = CheckRun.report["findings"]
    other = aliased(Take)
    newest = (
        select(other.cue_id, other.variation, func.max(other.number).label("number"))
        .where(in_array(other.cue_id, "cue_ids"), other.state != TakeState.SET_ASIDE)
        .where(*([other.designer_id == bindparam("designer_id")] if is_own else []))
        .group_by(other.cue_id, other.variation)
    )
    is_newest = tuple_(Take.cue_id, Take.variation, Take.number).in_(newest)
    return (
        _owned(select(Take.cue_id, findings), is_own)
        .join(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .where(in_array(Take.cue_id, "cue_ids"), Take.state.not_in((TakeState.SET_ASIDE, TakeState.CHANGE_REQUESTED)))
        .where(or_(Take.state.not_in((TakeState.RETURNED, TakeState.UNJUDGED)), is_newest))
        .where(findings.as_string() != "[]")
        .order_by(Take.received_at, Take.id)
    )


class ReviewFacts(NamedTuple):
    """The facts of a cue that a row of the list shows in addition to its takes."""

    rounds: int
    is_waived: bool
    is_elsewhere: bool  # an approved take was let through by another spec than the newest


def review_facts_of_cues(
    session: Session, cue_ids: Collection[UUID], designer_id: UUID | None, spec_id: UUID
) -> dict[UUID, ReviewFacts]:
    """Return these facts of some cues; with a designer, of their own takes only."""
    rows = session.execute(_review_facts(designer_id is not None), _given(cue_ids, designer_id) | {"spec_id": spec_id})
    return {
        cue_id: ReviewFacts(rounds or 0, is_waived, is_elsewhere) for cue_id, rounds, is_waived, is_elsewhere in rows
    }


@cache
def _review_facts(is_own: bool) -> Select[UUID, int | None, bool, bool]:
    rounds = select(func.max(Round.number)).where(Round.cue_id == Cue.id).correlate(Cue).scalar_subquery()
    waived = _owned(select(Take.id).join(Waiver, Waiver.take_id == Take.id), is_own).where(
        Take.cue_id == Cue.id, Take.state.in_((TakeState.CONFORMING, TakeState.APPROVED))
    )
    elsewhere = (
        _owned(select(Take.id), is_own)
        .join(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .where(Take.cue_id == Cue.id, Take.state == TakeState.APPROVED, CheckRun.spec_id != bindparam("spec_id"))
    )
    columns = (Cue.id, rounds, row_exists(waived, Cue), row_exists(elsewhere, Cue))
    return select(*columns).where(in_array(Cue.id, "cue_ids"))


def unheard_takes(session: Session, person_id: UUID, cue_ids: Collection[UUID]) -> dict[UUID, list[UUID]]:
    """Return the takes of some cues that wait or are approved and that a person has not heard, by cue."""
    takes_by_cue: dict[UUID, list[UUID]] = defaultdict(list)
    for cue_id, take_id in session.execute(_unheard_takes(), {"cue_ids": cue_ids, "person_id": person_id}):
        takes_by_cue[cue_id].append(take_id)
    return takes_by_cue


@cache
def _unheard_takes() -> Select[*tuple[Any, ...]]:
    heard = exists().where(HeardTake.take_id == Take.id, HeardTake.person_id == bindparam("person_id"))
    conditions = (in_array(Take.cue_id, "cue_ids"), Take.state.in_((TakeState.CONFORMING, TakeState.APPROVED)), ~heard)
    return select(Take.cue_id, Take.id).where(*conditions).order_by(Take.variation, Take.number)


def waiting_files(session: Session, project_id: UUID, designer_id: UUID | None) -> int:
    """Return the number of files that conform and wait for a verdict."""
    waiting = select(func.count()).where(
        Take.project_id == project_id, Take.state == TakeState.CONFORMING, Take.cue_id.is_not(None)
    )
    return session.scalar(_seen_by(waiting, designer_id)) or 0


def decided_cues(session: Session, project_id: UUID, *, since: datetime) -> list[tuple[Cue, datetime]]:
    """Return the cues of the latest decisions with the instant of each, the newest first."""
    decided = (
        select(Take.cue_id, Take.state_since)
        .where(Take.project_id == project_id, Take.state_since >= since, Take.cue_id.is_not(None))
        .where(Take.state.in_((TakeState.APPROVED, TakeState.CHANGE_REQUESTED)))
        .order_by(Take.state_since.desc())
        .limit(DECIDED)
        .subquery()
    )
    newest = func.max(decided.c.state_since)
    rows = session.execute(
        select(Cue, newest).join(decided, decided.c.cue_id == Cue.id).group_by(Cue.id).order_by(newest.desc())
    )
    return [(cue, at) for cue, at in rows]


def pictures(session: Session, studio_id: UUID, sounds: Collection[str]) -> dict[str, Picture]:
    """Return the pictures of stored sounds by their SHA-256, with what a line shows of them."""
    rows = session.scalars(_pictures(), {"studio_id": studio_id, "sounds": sounds})
    return {picture.sound_sha256: picture for picture in rows}


@cache
def _pictures() -> Select[Picture]:
    shown = load_only(Picture.sound_sha256, Picture.duration_s, Picture.thumb, raiseload=True)
    of_sounds = (Picture.studio_id == bindparam("studio_id"), in_array(Picture.sound_sha256, "sounds"))
    return select(Picture).where(*of_sounds).options(shown)
