"""Queries of the dashboards; each function is one SELECT, whatever the size of the project."""

from collections.abc import Collection, Sequence
from datetime import datetime
from uuid import UUID

from sqlalchemy import Row, Select, and_, exists, func, or_, select
from sqlalchemy.orm import Session, aliased, joinedload, load_only, selectinload

from app.accounts.models import Membership, Person, Studio
from app.accounts.rules import LEAD_ROLES, Actor
from app.builds.models import Build
from app.conformance.models import CheckRun
from app.core.in_array import in_array
from app.deliveries.models import Delivery, Take, TakeCounts
from app.deliveries.queries import in_tray
from app.deliveries.rules import TakeState
from app.notifications.models import Mail
from app.projects.models import Engagement, Liaison, Project
from app.projects.rules import ApprovalScope
from app.reviews.models import Acknowledgement, ChangeRequest, Comment, Feedback, Round, Verdict
from app.reviews.rules import VerdictKind
from app.sound_lists.models import Cue, Question
from app.sound_lists.rules import CueState

LATELY = 12
BUILDS = 24
WITH_OTHERS = 200  # shown at once; the oldest first
ANSWERED = 20  # of a designer's questions; earlier answers are with their cues


def my_projects(session: Session, person_id: UUID, studio_ids: Collection[UUID]) -> Sequence[Project]:
    """Return the projects that a person sees: those of their studios and those they are engaged on."""
    engaged = select(Engagement.project_id).where(Engagement.designer_id == person_id, Engagement.ended_at.is_(None))
    return session.scalars(
        select(Project)
        .where(or_(in_array(Project.studio_id, studio_ids), Project.id.in_(engaged)), Project.archived_at.is_(None))
        .options(joinedload(Project.studio))
        .order_by(Project.created_at.desc())
    ).all()


def my_engagements(session: Session, person_id: UUID) -> Sequence[Engagement]:
    """Return a person's running engagements, in order of their making."""
    return session.scalars(
        select(Engagement)
        .where(Engagement.designer_id == person_id, Engagement.ended_at.is_(None))
        .order_by(Engagement.id)
    ).all()


def my_liaisons(session: Session, actor: Actor) -> set[UUID]:
    """Return the projects in which the caller is a liaison."""
    named = select(Liaison.project_id).where(Liaison.person_id == actor.person)
    return set(session.scalars(named.where(Liaison.studio_id.in_(actor.studios_with(LEAD_ROLES)))))


def unmatched_takes(session: Session, project_id: UUID) -> Sequence[Row[Take, Person]]:
    """Return the takes without a cue that wait longest, with their designers."""
    return session.execute(
        select(Take, Person)
        .join(Person, Person.id == Take.designer_id)
        .where(*in_tray(project_id, None))
        .order_by(Take.state_since, Take.id)
        .limit(WITH_OTHERS)
    ).all()


def takes_with_designers(session: Session, project: Project) -> Sequence[Row[Take, Cue, Person]]:
    """Return the takes that came back, are the newest of a cue, and still needed, with cue and designer."""
    picked = aliased(Take)
    approved = (
        select(func.count())
        .where(picked.cue_id == Cue.id, picked.state == TakeState.APPROVED, picked.variation <= Cue.variations)
        .correlate(Cue)
        .scalar_subquery()
    )
    back = (TakeCounts.viewer_id == project.studio_id, TakeCounts.newest_back_since.is_not(None))
    return session.execute(
        select(Take, Cue, Person)
        .select_from(TakeCounts)
        .join(Take, Take.id == TakeCounts.newest_id)
        .join(Cue, Cue.id == TakeCounts.cue_id)
        .join(Person, Person.id == Take.designer_id)
        .where(TakeCounts.project_id == project.id, *back, Cue.state != CueState.CUT, approved < Cue.variations)
        .order_by(TakeCounts.newest_back_since, TakeCounts.newest_id)
        .limit(WITH_OTHERS)
    ).all()


def loops(session: Session, cue_ids: Collection[UUID]) -> set[UUID]:
    """Return those of the cues that are played as loops."""
    return set(session.scalars(select(Cue.id).where(in_array(Cue.id, cue_ids), Cue.loop)))


def current_runs(session: Session, take_ids: Collection[UUID]) -> dict[UUID, CheckRun]:
    """Return the standing check run of each take."""
    rows = session.scalars(select(CheckRun).where(in_array(CheckRun.take_id, take_ids), CheckRun.is_current))
    return {run.take_id: run for run in rows}


def open_questions(
    session: Session, project_id: UUID, *, asked_by: UUID | None = None
) -> Sequence[Row[Question, Cue, Person]]:
    """Return the questions that wait for an answer with their cue and asker, the oldest first."""
    query = _questions(project_id, asked_by).where(Question.answered_at.is_(None))
    return session.execute(query).all()


def own_questions(session: Session, project_id: UUID, asked_by: UUID) -> Sequence[Row[Question, Cue, Person]]:
    """Return a person's open questions and those answered last, the oldest first."""
    answered = (
        select(Question.id)
        .where(Question.project_id == project_id, Question.asked_by == asked_by, Question.answered_at.is_not(None))
        .order_by(Question.answered_at.desc())
        .limit(ANSWERED)
    )
    query = _questions(project_id, asked_by).where(or_(Question.answered_at.is_(None), Question.id.in_(answered)))
    return session.execute(query).all()


def _questions(project_id: UUID, asked_by: UUID | None) -> Select[Question, Cue, Person]:
    query = (
        select(Question, Cue, Person)
        .join(Cue, Cue.id == Question.cue_id)
        .join(Person, Person.id == Question.asked_by)
        .where(Question.project_id == project_id)
        .options(
            joinedload(Question.owner),
            load_only(Cue.id, Cue.number, Cue.name),
            load_only(Person.id, Person.name, Person.picture_sha256),
        )
        .order_by(Question.asked_at)
    )
    return query if asked_by is None else query.where(Question.asked_by == asked_by)


def sent_changes(session: Session, take_ids: Collection[UUID]) -> Sequence[Row[ChangeRequest, int | None]]:
    """Return the changes that were sent for these takes, with the round they counted as."""
    return session.execute(
        select(ChangeRequest, Round.number)
        .join(
            Round,
            and_(Round.feedback_id == ChangeRequest.feedback_id, Round.cue_id == ChangeRequest.cue_id),
            isouter=True,
        )
        .where(in_array(ChangeRequest.take_id, take_ids), ChangeRequest.feedback_id.is_not(None))
        .order_by(ChangeRequest.created_at)
    ).all()


def comments_of_takes(session: Session, take_ids: Collection[UUID]) -> Sequence[Comment]:
    """Return the comments on takes, with their authors, the oldest first."""
    return session.scalars(
        select(Comment)
        .where(in_array(Comment.take_id, take_ids))
        .options(joinedload(Comment.author), selectinload(Comment.acknowledgements).joinedload(Acknowledgement.person))
        .order_by(Comment.id)
    ).all()


def unsent_mails(session: Session, studio_id: UUID) -> int:
    """Return the number of mails of the studio that wait in the outbox."""
    return session.scalar(select(func.count()).where(Mail.studio_id == studio_id, Mail.sent_at.is_(None))) or 0


def builds(session: Session, project_id: UUID) -> Sequence[Build]:
    """Return the latest builds, newest first."""
    return session.scalars(
        select(Build).where(Build.project_id == project_id).order_by(Build.id.desc()).limit(BUILDS)
    ).all()


def team_size(session: Session, studio_id: UUID) -> int:
    """Return the number of members of the studio."""
    return session.scalar(select(func.count()).where(Membership.studio_id == studio_id)) or 0


def latest_deliveries(
    session: Session, project_id: UUID, designer_id: UUID | None
) -> Sequence[Row[Delivery, Person, int, int]]:
    """Return the latest deliveries with their designer, how many files came, and how many have no cue."""
    newest = select(Delivery.id).where(
        Delivery.project_id == project_id, exists().where(Take.delivery_id == Delivery.id, Take.discarded_at.is_(None))
    )
    if designer_id is not None:
        newest = newest.where(Delivery.designer_id == designer_id)
    return session.execute(
        select(Delivery, Person, func.count(Take.id), func.count(Take.id).filter(Take.cue_id.is_(None)))
        .join(Person, Person.id == Delivery.designer_id)
        .join(Take, and_(Take.delivery_id == Delivery.id, Take.discarded_at.is_(None)))
        .where(Delivery.id.in_(newest.order_by(Delivery.id.desc()).limit(LATELY)))
        .group_by(Delivery.id, Person.id)
        .order_by(Delivery.id.desc())
    ).all()


def latest_returns(
    session: Session, project_id: UUID, designer_id: UUID | None
) -> Sequence[Row[Take, Cue | None, CheckRun]]:
    """Return the takes that came back from the check last."""
    query = (
        select(Take, Cue, CheckRun)
        .join(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .join(Cue, Cue.id == Take.cue_id, isouter=True)
        .where(Take.project_id == project_id, Take.state == TakeState.RETURNED)
        .order_by(Take.state_since.desc())
        .limit(LATELY)
    )
    if designer_id is not None:
        query = query.where(Take.designer_id == designer_id)
    return session.execute(query).all()


def latest_approvals(
    session: Session, project_id: UUID, designer_id: UUID | None
) -> Sequence[Row[Verdict, Cue, Take, Person | None]]:
    """Return the latest approvals that stand, with who gave them; nobody did what a clause on silence approved."""
    withdrawal = aliased(Verdict)
    query = (
        select(Verdict, Cue, Take, Person)
        .join(Cue, Cue.id == Verdict.cue_id)
        .join(Take, Take.id == Verdict.take_id)
        .outerjoin(Person, Person.id == Verdict.given_by)
        .where(
            Verdict.project_id == project_id,
            Verdict.kind == VerdictKind.APPROVE,
            ~exists().where(withdrawal.withdraws_id == Verdict.id),
        )
        .order_by(Verdict.id.desc())
        .limit(LATELY)
    )
    if designer_id is not None:
        query = query.where(Take.designer_id == designer_id)
    return session.execute(query).all()


def latest_feedback(session: Session, project_id: UUID) -> Sequence[Row[Feedback, Person, int]]:
    """Return the latest sendings of changes with how many changes they held."""
    holds_some = exists().where(ChangeRequest.feedback_id == Feedback.id)
    newest = select(Feedback.id).where(Feedback.project_id == project_id, holds_some)
    return session.execute(
        select(Feedback, Person, func.count(ChangeRequest.id))
        .join(Person, Person.id == Feedback.sent_by)
        .join(ChangeRequest, ChangeRequest.feedback_id == Feedback.id)
        .where(Feedback.id.in_(newest.order_by(Feedback.id.desc()).limit(LATELY)))
        .group_by(Feedback.id, Person.id)
        .order_by(Feedback.id.desc())
    ).all()


def conforming_takes_since(session: Session, project_id: UUID, designer_id: UUID) -> datetime | None:
    """Return the start of the longest wait for a verdict among a designer's takes."""
    return session.scalar(
        select(func.min(Take.state_since)).where(
            Take.project_id == project_id, Take.state == TakeState.CONFORMING, Take.designer_id == designer_id
        )
    )


def back_since(session: Session, project_id: UUID, viewer_id: UUID) -> datetime | None:
    """Return the start of the longest wait of a take that went back to its designer, in a viewer's sight."""
    of_viewer = (
        TakeCounts.project_id == project_id,
        TakeCounts.viewer_id == viewer_id,
        TakeCounts.state != CueState.CUT,
    )
    return session.scalar(select(func.min(TakeCounts.back_since)).where(*of_viewer, TakeCounts.back_since.is_not(None)))


def tray_since(session: Session, project_id: UUID, designer_id: UUID) -> tuple[int, datetime | None]:
    """Return the number of a designer's files waiting for a cue, and the oldest wait's start."""
    count, since = session.execute(
        select(func.count(), func.min(Take.state_since)).where(*in_tray(project_id, designer_id))
    ).one()
    return count, since


def drafts_since(session: Session, project_id: UUID, scope: ApprovalScope) -> tuple[int, datetime | None]:
    """Return the number of unsent change requests of cues that a person approves, and the oldest wait's start."""
    query = select(func.count(), func.min(ChangeRequest.created_at)).where(
        ChangeRequest.project_id == project_id, ChangeRequest.feedback_id.is_(None), ChangeRequest.sends_at.is_(None)
    )
    if not scope.is_all:
        approved = Cue.category.not_in(scope.others) if scope.rest else Cue.category.in_(scope.own)
        query = query.join(Cue, Cue.id == ChangeRequest.cue_id).where(approved)
    count, since = session.execute(query).one()
    return count, since


def questions_open_since(session: Session, project_id: UUID, *, asked_by: UUID | None) -> tuple[int, datetime | None]:
    """Return the number of unanswered questions, and the oldest wait's start; one person's where one is given."""
    query = select(func.count(), func.min(Question.asked_at)).where(
        Question.project_id == project_id, Question.answered_at.is_(None)
    )
    count, since = session.execute(query.where(Question.asked_by == asked_by) if asked_by else query).one()
    return count, since


def has_verdicts(session: Session, project_id: UUID) -> bool:
    """Return whether anything in the project was decided."""
    return session.scalar(select(Verdict.id).where(Verdict.project_id == project_id).limit(1)) is not None


def studio_names(session: Session, ids: Collection[UUID]) -> dict[UUID, str]:
    """Return the names of studios."""
    return dict(session.execute(select(Studio.id, Studio.name).where(in_array(Studio.id, ids))).all())


def conforming_since(session: Session, cue_ids: Collection[UUID]) -> list[tuple[UUID, datetime]]:
    """Return arrival times of takes that the checks let through, by cue."""
    let_through = (TakeState.CONFORMING, TakeState.APPROVED, TakeState.CHANGE_REQUESTED, TakeState.SET_ASIDE)
    rows = session.execute(
        select(Take.cue_id, Take.received_at).where(in_array(Take.cue_id, cue_ids), Take.state.in_(let_through))
    )
    return [(cue_id, at) for cue_id, at in rows if cue_id is not None]


def changes_since(session: Session, cue_ids: Collection[UUID]) -> list[tuple[UUID, datetime]]:
    """Return the times of changes sent to the designer, by cue."""
    rows = session.execute(
        select(Verdict.cue_id, Verdict.created_at).where(
            in_array(Verdict.cue_id, cue_ids), Verdict.kind == VerdictKind.REQUEST_CHANGE
        )
    )
    return [(cue_id, at) for cue_id, at in rows]


def questions_since(
    session: Session, project_id: UUID, cue_ids: Collection[UUID]
) -> list[tuple[UUID, datetime, datetime | None]]:
    """Return the times of questions and of their answers, by cue."""
    rows = session.execute(
        select(Question.cue_id, Question.asked_at, Question.answered_at).where(
            Question.project_id == project_id, in_array(Question.cue_id, cue_ids)
        )
    )
    return [(cue_id, asked_at, answered_at) for cue_id, asked_at, answered_at in rows]


def designers_with_approved_takes(session: Session, project_id: UUID) -> Sequence[UUID]:
    """Return the designers of whom a sound of a project is approved."""
    return session.scalars(
        select(Take.designer_id).where(Take.project_id == project_id, Take.state == TakeState.APPROVED).distinct()
    ).all()
