"""The brief, read from the database; callers have checked access."""

from collections.abc import Mapping, Sequence
from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy import func, select
from sqlalchemy.orm import Session, joinedload

from app.briefs.models import Brief, BriefRead, BriefVersion, FollowUp

MAX_FOLLOW_UPS = 500


def brief_of(session: Session, project_id: UUID) -> Brief | None:
    """Return the brief of a project; None where nobody has answered anything."""
    return session.scalar(select(Brief).where(Brief.project_id == project_id).execution_options(populate_existing=True))


def answers_of(session: Session, project_id: UUID) -> Mapping[str, Any]:
    """Return the answers of a project as they stand, by question; none where it has no brief."""
    return session.scalar(select(Brief.answers).where(Brief.project_id == project_id)) or {}


def newest_version(session: Session, project_id: UUID) -> int:
    """Return the number of the newest published version, 0 where there is none."""
    return session.scalar(select(func.max(BriefVersion.number)).where(BriefVersion.project_id == project_id)) or 0


def version_of(session: Session, project_id: UUID, number: int) -> BriefVersion | None:
    """Return one published version, with the person who published it."""
    query = select(BriefVersion).where(BriefVersion.project_id == project_id, BriefVersion.number == number)
    return session.scalar(query.options(joinedload(BriefVersion.publisher)))


def versions_of(session: Session, project_id: UUID, *, below: int | None, limit: int) -> Sequence[BriefVersion]:
    """Return published versions, newest first."""
    query = select(BriefVersion).where(BriefVersion.project_id == project_id)
    if below is not None:
        query = query.where(BriefVersion.number < below)
    shown = query.options(joinedload(BriefVersion.publisher)).order_by(BriefVersion.number.desc())
    return session.scalars(shown.limit(limit)).all()


def newest_reads(session: Session, project_id: UUID) -> dict[UUID, BriefRead]:
    """Return for each designer the newest version that they opened, with that version."""
    reads = session.scalars(
        select(BriefRead)
        .join(BriefRead.version)
        .where(BriefRead.project_id == project_id)
        .options(joinedload(BriefRead.version))
        .order_by(BriefVersion.number)
    )
    return {read.designer_id: read for read in reads}


def has_read(session: Session, version_id: UUID, designer_id: UUID) -> bool:
    """Whether a designer has opened a version before."""
    return session.get(BriefRead, (version_id, designer_id)) is not None


def follow_up_by_id(session: Session, follow_up_id: UUID) -> FollowUp | None:
    """Return one follow-up with the people of it."""
    return session.scalar(
        select(FollowUp)
        .where(FollowUp.id == follow_up_id)
        .options(joinedload(FollowUp.asker), joinedload(FollowUp.answerer))
        .execution_options(populate_existing=True)
    )


def open_follow_ups(session: Session, project_id: UUID) -> tuple[int, datetime | None]:
    """Return the number of follow-ups without an answer, and the start of the first wait."""
    waiting = select(func.count(), func.min(FollowUp.asked_at)).where(
        FollowUp.project_id == project_id, FollowUp.answered_at.is_(None)
    )
    count, since = session.execute(waiting).one()
    return count, since


def follow_ups_of(session: Session, project_id: UUID) -> Sequence[FollowUp]:
    """Return the follow-ups of a project, the oldest first."""
    return session.scalars(
        select(FollowUp)
        .where(FollowUp.project_id == project_id)
        .options(joinedload(FollowUp.asker), joinedload(FollowUp.answerer))
        .order_by(FollowUp.id)
        .limit(MAX_FOLLOW_UPS)
    ).all()
