"""Facts known of a designer's work for one studio; each function is one SELECT of narrow rows."""

from collections.abc import Sequence
from datetime import datetime
from uuid import UUID

from sqlalchemy import Row, and_, func, select
from sqlalchemy.orm import Session

from app.accounts.models import Studio
from app.agreements.models import Contract
from app.agreements.rules import ContractState
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.projects.models import Engagement, Project
from app.reviews.models import Round
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState

NEWEST = 1_000  # rounds: older ones say nothing of today


def projects_of(session: Session, studio_id: UUID, designer_id: UUID) -> Sequence[Row[UUID, str, datetime]]:
    """Return the projects of a studio that a designer is or was engaged on, and since when, the newest first."""
    return session.execute(
        select(Project.id, Project.name, func.min(Engagement.created_at))
        .join(Engagement, Engagement.project_id == Project.id)
        .where(Project.studio_id == studio_id, Engagement.designer_id == designer_id)
        .group_by(Project.id, Project.name)
        .order_by(func.min(Engagement.created_at).desc())
    ).all()


def studios_of(session: Session, designer_id: UUID) -> Sequence[Row[UUID, str]]:
    """Return the studios that a designer works or worked for, by name."""
    return session.execute(
        select(Studio.id, Studio.name)
        .join(Engagement, Engagement.studio_id == Studio.id)
        .where(Engagement.designer_id == designer_id)
        .group_by(Studio.id, Studio.name)
        .order_by(Studio.name)
    ).all()


def contracts_of(session: Session, studio_id: UUID, designer_id: UUID) -> Sequence[Contract]:
    """Return the contracts of a studio with a designer that were agreed, those that ended since too."""
    states = (ContractState.AGREED, ContractState.ENDED)
    query = select(Contract).where(
        Contract.studio_id == studio_id,
        Contract.designer_id == designer_id,
        Contract.state.in_(states),
        Contract.agreed_at.is_not(None),
    )
    return session.scalars(query.order_by(Contract.id)).all()


def revision_times(session: Session, studio_id: UUID, designer_id: UUID) -> Sequence[tuple[datetime, datetime | None]]:
    """Return the times of sent changes of a cue and of the designer's next take; None while they are awaited."""
    next_take = (
        select(func.min(Take.received_at))
        .where(Take.cue_id == Round.cue_id, Take.designer_id == designer_id, Take.received_at > Round.created_at)
        .correlate(Round)
        .scalar_subquery()
    )
    own_cue_ids = select(Take.cue_id).where(Take.studio_id == studio_id, Take.designer_id == designer_id)
    is_awaited = and_(
        Cue.state != CueState.CUT,
        Cue.id.in_(own_cue_ids.where(Take.state == TakeState.CHANGE_REQUESTED).correlate(None)),
    )
    rows = session.execute(
        select(Round.created_at, next_take, is_awaited)
        .join(Cue, Cue.id == Round.cue_id)
        .where(Round.studio_id == studio_id, Round.cue_id.in_(own_cue_ids))
        .order_by(Round.id.desc())
        .limit(NEWEST)
    )
    return [(sent_at, came_at) for sent_at, came_at, awaited in rows if came_at is not None or awaited]
