"""Where cues stand, summed up from their takes; each function is one SELECT, whatever the size of the project."""

from collections import defaultdict
from collections.abc import Collection
from datetime import datetime
from typing import Any, NamedTuple
from uuid import UUID

from sqlalchemy import ColumnElement, Select, String, Subquery, and_, case, cast, exists, func, select
from sqlalchemy.orm import Session, load_only
from sqlalchemy.sql.functions import aggregate_strings
from typing_extensions import TypeVarTuple

from app.conformance.models import CheckRun, Waiver
from app.dashboards.rules import CODE_BASE, STATE_CODES
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.kit.among import among
from app.renders.models import Picture
from app.reviews.models import Round
from app.sound_lists.models import Cue, Question
from app.sound_lists.rules import CueState

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


class ListRow(NamedTuple):
    """One cue of the list with the packed facts of its variations, as "17,10"; None where nothing came."""

    id: UUID
    number: int
    name: str
    state: CueState
    variations: int
    placeholder: bool
    palette: bool
    facts: str | None


def _facts(project_id: UUID, designer_id: UUID | None) -> Subquery:
    """Gather the packed facts of each cue's variations in one row a cue."""
    summed = _seen_by(select(Take.cue_id, Take.variation, _packed().label("packed")), designer_id)
    sums = summed.where(Take.project_id == project_id).group_by(Take.cue_id, Take.variation).subquery()
    return (
        select(sums.c.cue_id, aggregate_strings(cast(sums.c.packed, String), ",").label("facts"))
        .join(Cue, and_(Cue.id == sums.c.cue_id, sums.c.variation <= Cue.variations))
        .group_by(sums.c.cue_id)
        .subquery()
    )


class LikeCues(NamedTuple):
    """How many cues of a list are alike in all that their standing depends on."""

    state: CueState
    variations: int
    placeholder: bool
    is_asked: bool
    facts: str | None
    cues: int


def like_cues(session: Session, project_id: UUID, designer_id: UUID | None) -> list[LikeCues]:
    """Return how many cues are alike; only a designer's own takes count where one is given."""
    facts = _facts(project_id, designer_id)
    is_asked = exists().where(Question.cue_id == Cue.id, Question.answered_at.is_(None))
    alike = (Cue.state, Cue.variations, Cue.placeholder, is_asked, facts.c.facts)
    rows = session.execute(
        select(*alike, func.count())
        .join(facts, facts.c.cue_id == Cue.id, isouter=True)
        .where(Cue.project_id == project_id)
        .group_by(*alike)
    )
    return [LikeCues._make(row) for row in rows]


def list_rows(session: Session, project_id: UUID, designer_id: UUID | None) -> list[ListRow]:
    """Return every cue in list order with what its takes add up to; only a designer's own where one is given."""
    facts = _facts(project_id, designer_id)
    rows = session.execute(
        select(Cue.id, Cue.number, Cue.name, Cue.state, Cue.variations, Cue.placeholder, Cue.palette, facts.c.facts)
        .join(facts, facts.c.cue_id == Cue.id, isouter=True)
        .where(Cue.project_id == project_id)
        .order_by(Cue.position, Cue.number)
    )
    return [ListRow._make(row) for row in rows]


class VariationRow(NamedTuple):
    """What the takes of one variation add up to."""

    cue_id: UUID
    variation: int
    packed: int
    waiting: int
    newest: int
    since: datetime


def variation_rows(session: Session, cue_ids: Collection[UUID], designer_id: UUID | None) -> list[VariationRow]:
    """Return what the takes of some cues add up to, by variation."""
    waiting = func.count(case((Take.state == TakeState.CONFORMING, 1)))
    summed = select(
        Take.cue_id, Take.variation, _packed(), waiting, func.max(Take.number), func.max(Take.state_since)
    ).where(among(Take.cue_id, cue_ids))
    rows = session.execute(_seen_by(summed, designer_id).group_by(Take.cue_id, Take.variation))
    return [VariationRow._make(row) for row in rows]


_IN_A_LIST = select(Take).options(
    load_only(
        *(Take.cue_id, Take.number, Take.variation, Take.state, Take.file_name, Take.received_at, Take.master_sha256),
        raiseload=True,
    )
)


def shown_takes(
    session: Session, cue_ids: Collection[UUID], designer_id: UUID | None, *, accepted: Collection[UUID]
) -> dict[UUID, Take]:
    """Return the take that stands for each cue in a list: the approved one of an accepted cue, else the newest."""
    newer = _seen_by(select(Take.id), designer_id).where(Take.cue_id == Cue.id)
    newest_first = newer.order_by(Take.received_at.desc(), Take.id.desc())
    newest = select(newest_first.limit(1).correlate(Cue).scalar_subquery()).where(among(Cue.id, cue_ids))
    newest_ids = [take_id for take_id in session.scalars(newest) if take_id is not None]
    shown = {take.cue_id: take for take in session.scalars(_IN_A_LIST.where(among(Take.id, newest_ids)))}
    if accepted:
        approved = _seen_by(_IN_A_LIST, designer_id).where(
            among(Take.cue_id, accepted), Take.state == TakeState.APPROVED, Take.variation == 1
        )
        shown |= {take.cue_id: take for take in session.scalars(approved)}
    return {cue_id: take for cue_id, take in shown.items() if cue_id is not None}


def asked_cues(session: Session, project_id: UUID) -> set[UUID]:
    """Return the cues on which a question is open."""
    return set(
        session.scalars(
            select(Question.cue_id).where(Question.project_id == project_id, Question.answered_at.is_(None))
        )
    )


def first_open_questions(session: Session, project_id: UUID, cue_ids: Collection[UUID]) -> dict[UUID, str]:
    """Return the question that waits longest for an answer, by cue."""
    rows = session.execute(
        select(Question.cue_id, Question.text)
        .where(Question.project_id == project_id, among(Question.cue_id, cue_ids), Question.answered_at.is_(None))
        .order_by(Question.asked_at.desc())
    )
    return dict(rows.all())


def standing_findings(
    session: Session, cue_ids: Collection[UUID], designer_id: UUID | None
) -> dict[UUID, list[dict[str, Any]]]:
    """Return what was found in the takes of some cues that stand, in the order that the takes came."""
    findings = CheckRun.report["findings"]
    rows = session.execute(
        _seen_by(select(Take.cue_id, findings), designer_id)
        .join(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .where(among(Take.cue_id, cue_ids), Take.state.not_in((TakeState.SET_ASIDE, TakeState.CHANGE_REQUESTED)))
        .where(findings.as_string() != "[]")
        .order_by(Take.received_at, Take.id)
    )
    found: dict[UUID, list[dict[str, Any]]] = defaultdict(list)
    for cue_id, each in rows:
        found[cue_id] += each
    return found


def waived_cues(session: Session, cue_ids: Collection[UUID], designer_id: UUID | None) -> set[UUID]:
    """Return those of the cues of which a take that stands was let through by a waiver."""
    waived = (
        _seen_by(select(Take.cue_id), designer_id)
        .join(Waiver, Waiver.take_id == Take.id)
        .where(among(Take.cue_id, cue_ids), Take.state.in_((TakeState.CONFORMING, TakeState.APPROVED)))
    )
    return {cue_id for cue_id in session.scalars(waived) if cue_id is not None}


def cues_of_other_specs(
    session: Session, cue_ids: Collection[UUID], designer_id: UUID | None, spec_id: UUID
) -> set[UUID]:
    """Return those of the cues with an approved take that another spec than this one let through."""
    found = (
        _seen_by(select(Take.cue_id), designer_id)
        .join(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .where(among(Take.cue_id, cue_ids), Take.state == TakeState.APPROVED, CheckRun.spec_id != spec_id)
    )
    return {cue_id for cue_id in session.scalars(found) if cue_id is not None}


def waiting_files(session: Session, project_id: UUID, designer_id: UUID | None) -> int:
    """Return how many files conform and wait for a verdict."""
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
    shown = load_only(Picture.sound_sha256, Picture.duration_s, Picture.thumb, raiseload=True)
    rows = session.scalars(
        select(Picture).where(Picture.studio_id == studio_id, among(Picture.sound_sha256, sounds)).options(shown)
    )
    return {picture.sound_sha256: picture for picture in rows}


def rounds_by_cue(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, int]:
    """Return how many rounds cues have had; those without any are left out."""
    rows = session.execute(
        select(Round.cue_id, func.max(Round.number)).where(among(Round.cue_id, cue_ids)).group_by(Round.cue_id)
    )
    return {cue_id: number or 0 for cue_id, number in rows}
