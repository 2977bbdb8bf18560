"""Time without a contract; each function is one SELECT, of one person's own rows."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import Row, exists, func, select, union_all
from sqlalchemy.orm import Session, joinedload

from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.money.models import OwnTime, WorkLog
from app.sound_lists.models import Cue


def own_times(session: Session, person_id: UUID, project_id: UUID) -> Sequence[OwnTime]:
    """Return a person's time in a project with its cues, the newest first."""
    own = select(OwnTime).where(OwnTime.person_id == person_id, OwnTime.project_id == project_id)
    newest = own.options(joinedload(OwnTime.cue)).order_by(OwnTime.worked_on.desc(), OwnTime.id.desc())
    return session.scalars(newest).all()


def own_time_by_id(session: Session, person_id: UUID, own_time_id: UUID) -> OwnTime | None:
    """Return one entry of a person's."""
    return session.scalar(select(OwnTime).where(OwnTime.id == own_time_id, OwnTime.person_id == person_id))


def own_minutes(session: Session, person_id: UUID, cue_ids: Collection[UUID]) -> int:
    """Return the minutes that a person logged for some cues without a contract."""
    of_cues = (OwnTime.person_id == person_id, OwnTime.cue_id.in_(cue_ids))
    return int(session.scalar(select(func.sum(OwnTime.minutes)).where(*of_cues)) or 0)


def minutes_of_approved(session: Session, person_id: UUID, studio_id: UUID) -> Sequence[Row[str, int]]:
    """Return category and all logged minutes of each cue of a studio with an approved version by a person."""
    logged = union_all(
        select(OwnTime.cue_id, OwnTime.minutes).where(OwnTime.person_id == person_id, OwnTime.studio_id == studio_id),
        select(WorkLog.cue_id, WorkLog.minutes).where(WorkLog.logged_by == person_id, WorkLog.studio_id == studio_id),
    ).subquery()
    approved = exists().where(Take.cue_id == Cue.id, Take.designer_id == person_id, Take.state == TakeState.APPROVED)
    by_cue = (
        select(Cue.category, func.sum(logged.c.minutes))
        .join(logged, logged.c.cue_id == Cue.id)
        .where(approved)
        .group_by(Cue.id, Cue.category)
    )
    return session.execute(by_cue).all()
