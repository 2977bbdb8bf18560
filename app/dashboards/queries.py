"""What the joining screens read; each function is one SELECT, whatever the size of the project."""

from collections import defaultdict
from collections.abc import Collection, Sequence
from datetime import datetime
from typing import Any, NamedTuple
from uuid import UUID

from sqlalchemy import ColumnElement, Row, Select, String, Subquery, and_, case, cast, exists, func, or_, select
from sqlalchemy.orm import Session, aliased, joinedload, load_only
from sqlalchemy.sql.functions import aggregate_strings
from typing_extensions import TypeVarTuple

from app.accounts.models import Membership, Person, Studio
from app.builds.models import Build
from app.conformance.models import CheckRun, Waiver
from app.dashboards.rules import CODE_BASE, STATE_CODES, WITH_DESIGNER
from app.deliveries.models import Delivery, Take
from app.deliveries.rules import TakeState
from app.notifications.models import Mail
from app.projects.models import Engagement, Liaison, Project
from app.renders.models import Picture
from app.reviews.models import ChangeRequest, Comment, Round, Sending, Verdict
from app.reviews.rules import VerdictKind
from app.sound_lists.models import Cue, Question
from app.sound_lists.rules import CueState

LATELY = 12
BUILDS = 24
HITS = 20
DECIDED = 50
WITH_OTHERS = 200  # shown at once; the oldest first
Ts = TypeVarTuple("Ts")


def my_projects(session: Session, person_id: UUID, studio_ids: Collection[UUID]) -> Sequence[Project]:
    """Return the projects that a person sees: those of their studios and those they are engaged on."""
    engaged = select(Engagement.project_id).where(Engagement.designer_id == person_id, Engagement.ended_at.is_(None))
    return session.scalars(
        select(Project)
        .where(or_(Project.studio_id.in_(studio_ids), Project.id.in_(engaged)), Project.archived_at.is_(None))
        .options(joinedload(Project.studio))
        .order_by(Project.created_at.desc())
    ).all()


def my_engagements(session: Session, person_id: UUID) -> Sequence[Engagement]:
    """Return a person's running engagements."""
    return session.scalars(
        select(Engagement).where(Engagement.designer_id == person_id, Engagement.ended_at.is_(None))
    ).all()


def my_liaisons(session: Session, person_id: UUID) -> set[UUID]:
    """Return the projects in which a person is a liaison."""
    return set(session.scalars(select(Liaison.project_id).where(Liaison.person_id == person_id)))


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
    ).where(Take.cue_id.in_(cue_ids))
    rows = session.execute(_seen_by(summed, designer_id).group_by(Take.cue_id, Take.variation))
    return [VariationRow._make(row) for row in rows]


def shown_takes(
    session: Session, cue_ids: Collection[UUID], designer_id: UUID | None, *, accepted: Collection[UUID]
) -> dict[UUID, Take]:
    """Return the take that stands for each cue in a list: the approved one of an accepted cue, else the newest."""
    later = aliased(Take)
    newer = select(later.id).where(later.cue_id == Cue.id).order_by(later.received_at.desc(), later.id.desc())
    if designer_id is not None:
        newer = newer.where(later.designer_id == designer_id)
    newest = select(newer.limit(1).correlate(Cue).scalar_subquery()).where(Cue.id.in_(cue_ids))
    newest_ids = [take_id for take_id in session.scalars(newest) if take_id is not None]
    shown = {take.cue_id: take for take in session.scalars(select(Take).where(Take.id.in_(newest_ids)))}
    approved = _seen_by(select(Take), designer_id).where(
        Take.cue_id.in_(accepted), Take.state == TakeState.APPROVED, Take.variation == 1
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
        .where(Question.project_id == project_id, Question.cue_id.in_(cue_ids), Question.answered_at.is_(None))
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
        .where(Take.cue_id.in_(cue_ids), Take.state.not_in((TakeState.SET_ASIDE, TakeState.CHANGE_REQUESTED)))
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
        .where(Take.cue_id.in_(cue_ids), Take.state.in_((TakeState.CONFORMING, TakeState.APPROVED)))
    )
    return {cue_id for cue_id in session.scalars(waived) if cue_id is not None}


def cues_of_other_specs(
    session: Session, cue_ids: Collection[UUID], designer_id: UUID | None, spec_id: UUID
) -> set[UUID]:
    """Return those of the cues with an approved take that another spec than this one let through."""
    found = (
        _seen_by(select(Take.cue_id), designer_id)
        .join(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .where(Take.cue_id.in_(cue_ids), Take.state == TakeState.APPROVED, CheckRun.spec_id != spec_id)
    )
    return {cue_id for cue_id in session.scalars(found) if cue_id is not None}


def take_counts(session: Session, project_id: UUID, designer_id: UUID) -> dict[tuple[TakeState, bool], int]:
    """Return how many takes of a designer stand where, by state and whether they are for a cue."""
    is_matched = Take.cue_id.is_not(None)
    rows = session.execute(
        select(Take.state, is_matched, func.count())
        .where(Take.project_id == project_id, Take.designer_id == designer_id)
        .group_by(Take.state, is_matched)
    )
    return {(state, bool(matched)): count for state, matched, count in rows}


def waiting_files(session: Session, project_id: UUID, designer_id: UUID | None) -> int:
    """Return how many files conform and wait for a verdict."""
    waiting = select(func.count()).where(
        Take.project_id == project_id, Take.state == TakeState.CONFORMING, Take.cue_id.is_not(None)
    )
    return session.scalar(_seen_by(waiting, designer_id)) or 0


def unmatched_takes(session: Session, project_id: UUID) -> Sequence[Row[Take, str]]:
    """Return the takes without a cue that wait longest, with their designers' names."""
    return session.execute(
        select(Take, Person.name)
        .join(Person, Person.id == Take.designer_id)
        .where(Take.project_id == project_id, Take.cue_id.is_(None))
        .order_by(Take.state_since, Take.id)
        .limit(WITH_OTHERS)
    ).all()


def takes_with_designers(session: Session, project_id: UUID) -> Sequence[Row[Take, Cue, str]]:
    """Return the takes that came back, are the newest of a cue, and still needed, with cue and designer's name."""
    later, picked = aliased(Take), aliased(Take)
    newest_id = (
        select(later.id)
        .where(later.cue_id == Cue.id)
        .order_by(later.received_at.desc(), later.id.desc())
        .limit(1)
        .correlate(Cue)
        .scalar_subquery()
    )
    # Found once for each cue; without the word PostgreSQL would look for it anew for each take.
    wanted = (
        select(Cue.id, newest_id.label("newest_id"))
        .where(Cue.project_id == project_id, Cue.state != CueState.CUT)
        .cte("wanted")
        .prefix_with("MATERIALIZED")
    )
    approved = (
        select(func.count())
        .where(picked.cue_id == Cue.id, picked.state == TakeState.APPROVED, picked.variation <= Cue.variations)
        .correlate(Cue)
        .scalar_subquery()
    )
    return session.execute(
        select(Take, Cue, Person.name)
        .select_from(wanted)
        .join(Take, Take.id == wanted.c.newest_id)
        .join(Cue, Cue.id == wanted.c.id)
        .join(Person, Person.id == Take.designer_id)
        .where(Take.state.in_(WITH_DESIGNER), approved < Cue.variations)
        .order_by(Take.state_since, Take.id)
        .limit(WITH_OTHERS)
    ).all()


def takes_back(session: Session, project_id: UUID, designer_id: UUID) -> Sequence[Row[Take, Cue]]:
    """Return a designer's takes that came back and were not followed by another of theirs, with their cues."""
    later = aliased(Take)
    is_followed = exists().where(
        later.cue_id == Take.cue_id,
        later.variation == Take.variation,
        later.designer_id == designer_id,
        later.number > Take.number,
    )
    return session.execute(
        select(Take, Cue)
        .join(Cue, Cue.id == Take.cue_id)
        .where(Take.project_id == project_id, Take.designer_id == designer_id)
        .where(Take.state.in_(WITH_DESIGNER), Cue.state != CueState.CUT, ~is_followed)
        .order_by(Take.state_since, Take.id)
    ).all()


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


def cues_by_id(session: Session, project_id: UUID) -> dict[UUID, Cue]:
    """Return the whole list, without the stems that its cues own."""
    return {cue.id: cue for cue in session.scalars(select(Cue).where(Cue.project_id == project_id))}


def loops(session: Session, cue_ids: Collection[UUID]) -> set[UUID]:
    """Return those of the cues that are played as loops."""
    return set(session.scalars(select(Cue.id).where(Cue.id.in_(cue_ids), Cue.loop)))


def placeholders(session: Session, project_id: UUID) -> int:
    """Return how many cues still have the game play a stand-in."""
    standing_in = select(func.count()).where(Cue.project_id == project_id, Cue.placeholder, Cue.cut_at.is_(None))
    return session.scalar(standing_in) or 0


def pictures(session: Session, studio_id: UUID, sounds: Collection[str]) -> dict[str, Picture]:
    """Return the pictures of stored sounds by their SHA-256, with what a line shows of them."""
    shown = load_only(Picture.sound_sha256, Picture.duration_s, Picture.thumb, raiseload=True)
    rows = session.scalars(
        select(Picture).where(Picture.studio_id == studio_id, Picture.sound_sha256.in_(sounds)).options(shown)
    )
    return {picture.sound_sha256: picture for picture in rows}


def current_runs(session: Session, take_ids: Collection[UUID]) -> dict[UUID, CheckRun]:
    """Return the standing check run of each take."""
    rows = session.scalars(select(CheckRun).where(CheckRun.take_id.in_(take_ids), CheckRun.is_current))
    return {run.take_id: run for run in rows}


def questions(
    session: Session, project_id: UUID, *, asked_by: UUID | None = None, only_open: bool
) -> Sequence[Row[Question, Cue, Person]]:
    """Return questions with their cue and asker, the oldest first."""
    found = (
        select(Question, Cue, Person)
        .join(Cue, Cue.id == Question.cue_id)
        .join(Person, Person.id == Question.asked_by)
        .where(Question.project_id == project_id)
        .order_by(Question.asked_at)
    )
    if only_open:
        found = found.where(Question.answered_at.is_(None))
    if asked_by is not None:
        found = found.where(Question.asked_by == asked_by)
    return session.execute(found).all()


def rounds_by_cue(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, int]:
    """Return how many rounds cues have had; those without any are left out."""
    rows = session.execute(
        select(Round.cue_id, func.max(Round.number)).where(Round.cue_id.in_(cue_ids)).group_by(Round.cue_id)
    )
    return {cue_id: number or 0 for cue_id, number in rows}


def sent_changes(session: Session, take_ids: Collection[UUID]) -> Sequence[Row[ChangeRequest, int | None]]:
    """Return the changes that were sent for these takes, with the round they counted as."""
    return session.execute(
        select(ChangeRequest, Round.number)
        .join(
            Round,
            and_(Round.sending_id == ChangeRequest.sending_id, Round.cue_id == ChangeRequest.cue_id),
            isouter=True,
        )
        .where(ChangeRequest.take_id.in_(take_ids), ChangeRequest.sending_id.is_not(None))
        .order_by(ChangeRequest.created_at)
    ).all()


def draft_changes(session: Session, project_id: UUID) -> int:
    """Return how many change requests wait to be sent."""
    return (
        session.scalar(
            select(func.count()).where(ChangeRequest.project_id == project_id, ChangeRequest.sending_id.is_(None))
        )
        or 0
    )


def unsent_mails(session: Session, studio_id: UUID) -> int:
    """Return how many mails of the studio wait in the outbox."""
    return session.scalar(select(func.count()).where(Mail.studio_id == studio_id, Mail.sent_at.is_(None))) or 0


def builds(session: Session, project_id: UUID) -> Sequence[Build]:
    """Return the latest builds, newest first."""
    return session.scalars(
        select(Build).where(Build.project_id == project_id).order_by(Build.id.desc()).limit(BUILDS)
    ).all()


def team_size(session: Session, studio_id: UUID) -> int:
    """Return how many members the studio has."""
    return session.scalar(select(func.count()).where(Membership.studio_id == studio_id)) or 0


def latest_deliveries(
    session: Session, project_id: UUID, designer_id: UUID | None
) -> Sequence[Row[Delivery, Person, int, int]]:
    """Return the latest deliveries with their designer, how many files came, and how many have no cue."""
    newest = select(Delivery.id).where(
        Delivery.project_id == project_id, exists().where(Take.delivery_id == Delivery.id)
    )
    if designer_id is not None:
        newest = newest.where(Delivery.designer_id == designer_id)
    return session.execute(
        select(Delivery, Person, func.count(Take.id), func.count(Take.id).filter(Take.cue_id.is_(None)))
        .join(Person, Person.id == Delivery.designer_id)
        .join(Take, Take.delivery_id == Delivery.id)
        .where(Delivery.id.in_(newest.order_by(Delivery.id.desc()).limit(LATELY)))
        .group_by(Delivery.id, Person.id)
        .order_by(Delivery.id.desc())
    ).all()


def latest_returns(
    session: Session, project_id: UUID, designer_id: UUID | None
) -> Sequence[Row[Take, Cue | None, CheckRun]]:
    """Return the takes that came back from the check last."""
    found = (
        select(Take, Cue, CheckRun)
        .join(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .join(Cue, Cue.id == Take.cue_id, isouter=True)
        .where(Take.project_id == project_id, Take.state == TakeState.RETURNED)
        .order_by(Take.state_since.desc())
        .limit(LATELY)
    )
    if designer_id is not None:
        found = found.where(Take.designer_id == designer_id)
    return session.execute(found).all()


def latest_approvals(
    session: Session, project_id: UUID, designer_id: UUID | None
) -> Sequence[Row[Verdict, Cue, Take, Person]]:
    """Return the latest approvals that stand."""
    withdrawal = aliased(Verdict)
    found = (
        select(Verdict, Cue, Take, Person)
        .join(Cue, Cue.id == Verdict.cue_id)
        .join(Take, Take.id == Verdict.take_id)
        .join(Person, Person.id == Verdict.given_by)
        .where(
            Verdict.project_id == project_id,
            Verdict.kind == VerdictKind.APPROVE,
            ~exists().where(withdrawal.withdraws_id == Verdict.id),
        )
        .order_by(Verdict.id.desc())
        .limit(LATELY)
    )
    if designer_id is not None:
        found = found.where(Take.designer_id == designer_id)
    return session.execute(found).all()


def latest_sendings(session: Session, project_id: UUID) -> Sequence[Row[Sending, Person, int]]:
    """Return the latest sendings of changes with how many changes they held."""
    return session.execute(
        select(Sending, Person, func.count(ChangeRequest.id))
        .join(Person, Person.id == Sending.sent_by)
        .join(ChangeRequest, ChangeRequest.sending_id == Sending.id)
        .where(Sending.project_id == project_id)
        .group_by(Sending.id, Person.id)
        .order_by(Sending.id.desc())
        .limit(LATELY)
    ).all()


def find_cues(session: Session, project_id: UUID, words: Sequence[str]) -> Sequence[Cue]:
    """Return the cues whose name, use or description holds every word."""
    found = select(Cue).where(Cue.project_id == project_id)
    for word in words:
        like = f"%{word}%"
        found = found.where(
            or_(
                Cue.name.ilike(like, escape="\\"),
                Cue.use.ilike(like, escape="\\"),
                Cue.description.ilike(like, escape="\\"),
                Cue.category.ilike(like, escape="\\"),
            )
        )
    return session.scalars(found.order_by(Cue.number).limit(HITS)).all()


def find_comments(session: Session, project_id: UUID, word: str) -> Sequence[Row[Comment, Cue]]:
    """Return the newest comments that hold a phrase, with their cue."""
    return session.execute(
        select(Comment, Cue)
        .join(Take, Take.id == Comment.take_id)
        .join(Cue, Cue.id == Take.cue_id)
        .where(Comment.project_id == project_id, Comment.text.ilike(f"%{word}%", escape="\\"))
        .order_by(Comment.id.desc())
        .limit(HITS)
    ).all()


def find_questions(session: Session, project_id: UUID, word: str) -> Sequence[Row[Question, Cue]]:
    """Return the newest questions that hold a phrase, with their cue."""
    return session.execute(
        select(Question, Cue)
        .join(Cue, Cue.id == Question.cue_id)
        .where(Question.project_id == project_id, Question.text.ilike(f"%{word}%", escape="\\"))
        .order_by(Question.id.desc())
        .limit(HITS)
    ).all()


def cue_by_number(session: Session, project_id: UUID, number: int) -> Cue | None:
    """Return the cue of that number."""
    return session.scalar(select(Cue).where(Cue.project_id == project_id, Cue.number == number))


def studio_names(session: Session, ids: Collection[UUID]) -> dict[UUID, str]:
    """Return the names of studios."""
    return dict(session.execute(select(Studio.id, Studio.name).where(Studio.id.in_(ids))).all())


def conforming_since(session: Session, cue_ids: Collection[UUID]) -> list[tuple[UUID, datetime]]:
    """Return when takes came that the checks let through, by cue."""
    let_through = (TakeState.CONFORMING, TakeState.APPROVED, TakeState.CHANGE_REQUESTED, TakeState.SET_ASIDE)
    rows = session.execute(
        select(Take.cue_id, Take.received_at).where(Take.cue_id.in_(cue_ids), Take.state.in_(let_through))
    )
    return [(cue_id, at) for cue_id, at in rows if cue_id is not None]


def changes_since(session: Session, cue_ids: Collection[UUID]) -> list[tuple[UUID, datetime]]:
    """Return when changes were sent to the designer, by cue."""
    rows = session.execute(
        select(Verdict.cue_id, Verdict.created_at).where(
            Verdict.cue_id.in_(cue_ids), Verdict.kind == VerdictKind.REQUEST_CHANGE
        )
    )
    return [(cue_id, at) for cue_id, at in rows]


def questions_since(
    session: Session, project_id: UUID, cue_ids: Collection[UUID]
) -> list[tuple[UUID, datetime, datetime | None]]:
    """Return when questions were asked and answered, by cue."""
    rows = session.execute(
        select(Question.cue_id, Question.asked_at, Question.answered_at).where(
            Question.project_id == project_id, Question.cue_id.in_(cue_ids)
        )
    )
    return [(cue_id, asked_at, answered_at) for cue_id, asked_at, answered_at in rows]
