"""What the joining screens read; each function is one SELECT, whatever the size of the project."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import Row, Select, and_, exists, func, or_, select
from sqlalchemy.orm import Session, aliased, joinedload

from app.accounts.models import Membership, Person, Studio
from app.builds.models import Build
from app.conformance.models import CheckRun, Waiver
from app.deliveries.models import Delivery, Take
from app.deliveries.rules import TakeState
from app.notifications.models import Mail
from app.projects.models import Engagement, Liaison, Project
from app.renders.models import Picture
from app.reviews.models import ChangeRequest, Comment, Round, Sending, Verdict
from app.reviews.rules import VerdictKind
from app.sound_lists.models import Cue, Question

LATELY = 12
BUILDS = 24
HITS = 20


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


def cues(session: Session, project_id: UUID) -> Sequence[Cue]:
    """Return the whole list in its order, with the stems that its cues own."""
    return (
        session.scalars(
            select(Cue)
            .where(Cue.project_id == project_id)
            .options(joinedload(Cue.stems))
            .order_by(Cue.position, Cue.number)
        )
        .unique()
        .all()
    )


def _takes(project_id: UUID, designer_id: UUID | None) -> Select[Take]:
    takes = select(Take).where(Take.project_id == project_id)
    return takes if designer_id is None else takes.where(Take.designer_id == designer_id)


def takes(session: Session, project_id: UUID, designer_id: UUID | None) -> Sequence[Take]:
    """Return the project's takes, newest last; only a designer's own where one is given."""
    return session.scalars(_takes(project_id, designer_id).order_by(Take.received_at, Take.id)).all()


def pictures(session: Session, studio_id: UUID, sounds: Collection[str]) -> dict[str, Picture]:
    """Return the pictures of stored sounds by their SHA-256."""
    rows = session.scalars(select(Picture).where(Picture.studio_id == studio_id, Picture.sound_sha256.in_(sounds)))
    return {picture.sound_sha256: picture for picture in rows}


def current_runs(session: Session, take_ids: Collection[UUID]) -> dict[UUID, CheckRun]:
    """Return the standing check run of each take."""
    rows = session.scalars(select(CheckRun).where(CheckRun.take_id.in_(take_ids), CheckRun.is_current))
    return {run.take_id: run for run in rows}


def waived_takes(session: Session, project_id: UUID) -> set[UUID]:
    """Return the takes that a waiver let through."""
    return set(session.scalars(select(Waiver.take_id).where(Waiver.project_id == project_id)))


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


def rounds_by_cue(session: Session, project_id: UUID) -> dict[UUID, int]:
    """Return how many rounds each cue has had."""
    rows = session.execute(
        select(Round.cue_id, func.max(Round.number)).where(Round.project_id == project_id).group_by(Round.cue_id)
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


def people(session: Session, ids: Collection[UUID]) -> dict[UUID, Person]:
    """Return people by id."""
    return {person.id: person for person in session.scalars(select(Person).where(Person.id.in_(ids)))}


def team_size(session: Session, studio_id: UUID) -> int:
    """Return how many members the studio has."""
    return session.scalar(select(func.count()).where(Membership.studio_id == studio_id)) or 0


def latest_deliveries(
    session: Session, project_id: UUID, designer_id: UUID | None
) -> Sequence[Row[Delivery, Person, int, int]]:
    """Return the latest deliveries with their designer, how many files came, and how many have no cue."""
    found = (
        select(Delivery, Person, func.count(Take.id), func.count(Take.id).filter(Take.cue_id.is_(None)))
        .join(Person, Person.id == Delivery.designer_id)
        .join(Take, Take.delivery_id == Delivery.id)
        .where(Delivery.project_id == project_id)
        .group_by(Delivery.id, Person.id)
        .order_by(Delivery.id.desc())
        .limit(LATELY)
    )
    if designer_id is not None:
        found = found.where(Delivery.designer_id == designer_id)
    return session.execute(found).all()


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
