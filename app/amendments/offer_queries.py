"""Records since a contract was signed, read from the database; callers have checked the reader."""

from collections.abc import Collection, Sequence
from datetime import datetime
from uuid import UUID

from sqlalchemy import Row, func, or_, select
from sqlalchemy.orm import Session, contains_eager, joinedload

from app.accounts.models import Person
from app.agreements.models import Contract
from app.amendments.offer_rules import ListChange
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.money.models import WorkLog
from app.projects.models import Spec
from app.references.models import Reference, ReferenceVersion
from app.reviews.models import Feedback, Round
from app.sound_lists.models import Cue, CueChange, Question, Revision


def work_began(session: Session, contract: Contract, cue_ids: Collection[UUID]) -> dict[UUID, datetime]:
    """Return the time of first delivery, or logged work, of the contract's designer for each of these cues."""
    takes = (
        select(Take.cue_id, func.min(Take.received_at))
        .where(in_array(Take.cue_id, cue_ids), Take.designer_id == contract.designer_id)
        .group_by(Take.cue_id)
    )
    logs = (
        select(WorkLog.cue_id, func.min(WorkLog.created_at))
        .where(WorkLog.contract_id == contract.id)
        .group_by(WorkLog.cue_id)
    )
    began: dict[UUID, datetime] = {}
    for query in (takes, logs):
        for cue_id, at in session.execute(query):
            if cue_id is not None:
                began[cue_id] = min(at, began.get(cue_id, at))
    return began


def list_changes_since(
    session: Session, project_id: UUID, cue_ids: Collection[UUID], since: datetime
) -> Sequence[ListChange]:
    """Return the changes of revisions after an instant to these cues, the oldest first."""
    rows = session.execute(
        select(CueChange, Revision.number, Revision.created_at, Person.name)
        .join(Revision, Revision.id == CueChange.revision_id)
        .join(Person, Person.id == Revision.changed_by)
        .where(
            Revision.project_id == project_id,
            Revision.created_at > since,
            in_array(CueChange.cue_id, cue_ids),
        )
        .order_by(Revision.number, CueChange.cue_id)
    )
    return [
        ListChange(change.cue_id, number, at, name, change.before, change.after) for change, number, at, name in rows
    ]


def who_listed(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, str]:
    """Return the person who listed each of these cues."""
    rows = session.execute(
        select(CueChange.cue_id, Person.name)
        .join(Revision, Revision.id == CueChange.revision_id)
        .join(Person, Person.id == Revision.changed_by)
        .where(in_array(CueChange.cue_id, cue_ids))
        .order_by(Revision.number.desc())
    )
    return dict(rows.all())  # the oldest revision comes last, and counts


def answered_since(session: Session, contract: Contract, since: datetime) -> Sequence[Question]:
    """Return the questions of a contract's designer that were answered after an instant, with who answered."""
    return session.scalars(
        select(Question)
        .where(
            Question.project_id == contract.project_id,
            Question.asked_by == contract.designer_id,
            Question.answered_at > since,
        )
        .options(joinedload(Question.answerer))
        .order_by(Question.answered_at, Question.id)
    ).all()


def rounds_beyond(
    session: Session, cue_ids: Collection[UUID], included: int
) -> Sequence[Row[UUID, int | None, datetime, str]]:
    """Return the counted rounds of cues beyond a number of them, each with when and by whom it was sent."""
    return session.execute(
        select(Round.cue_id, Round.number, Round.created_at, Person.name)
        .join(Feedback, Feedback.id == Round.feedback_id)
        .join(Person, Person.id == Feedback.sent_by)
        .where(in_array(Round.cue_id, cue_ids), Round.number > included)
        .order_by(Round.number, Round.cue_id)
    ).all()


def references_since(session: Session, contract: Contract, since: datetime) -> Sequence[ReferenceVersion]:
    """Return the newest versions of references to a cue or a category that others than the designer added since."""
    return session.scalars(
        select(ReferenceVersion)
        .join(ReferenceVersion.reference)
        .where(
            Reference.project_id == contract.project_id,
            Reference.removed_at.is_(None),
            or_(Reference.cue_id.is_not(None), Reference.category.is_not(None)),
            ReferenceVersion.number == Reference.newest_number,
            ReferenceVersion.added_at > since,
            ReferenceVersion.added_by != contract.designer_id,
        )
        .options(contains_eager(ReferenceVersion.reference), joinedload(ReferenceVersion.author))
        .order_by(ReferenceVersion.id)
    ).all()


def cues_listed_since(session: Session, project_id: UUID, since: datetime) -> Sequence[Cue]:
    """Return the cues that were put on a project's list after an instant, in list order."""
    return session.scalars(
        select(Cue).where(Cue.project_id == project_id, Cue.created_at > since).order_by(Cue.position, Cue.number)
    ).all()


def specs_since(session: Session, project_id: UUID, since: datetime) -> tuple[Spec | None, Sequence[Spec]]:
    """Return the delivery spec that held at an instant, and the versions after it, with their authors."""
    versions = select(Spec).where(Spec.project_id == project_id).options(joinedload(Spec.author))
    held = session.scalar(versions.where(Spec.created_at <= since).order_by(Spec.version.desc()).limit(1))
    return held, session.scalars(versions.where(Spec.created_at > since).order_by(Spec.version)).all()
