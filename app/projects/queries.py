"""Projects within the caller's reach."""

from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.projects.models import DeciderChange, Engagement, Liaison, Project, Spec


def project_by_id(session: Session, project_id: UUID) -> Project | None:
    """Return a project without asking who looks; for services that check the caller's standing, and for jobs."""
    return session.get(Project, project_id)


def engagement_of(session: Session, project_id: UUID, person_id: UUID) -> Engagement | None:
    """Return a designer's running engagement on a project."""
    return session.scalar(
        select(Engagement).where(
            Engagement.project_id == project_id,
            Engagement.designer_id == person_id,
            Engagement.ended_at.is_(None),
        )
    )


def decider_of(session: Session, project: Project) -> UUID:
    """Return who has the last word: the one named last, else the producer who opened the project."""
    named = session.scalar(
        select(DeciderChange.person_id)
        .where(DeciderChange.project_id == project.id)
        .order_by(DeciderChange.id.desc())
        .limit(1)
    )
    return named or project.created_by


def is_liaison(session: Session, project_id: UUID, person_id: UUID) -> bool:
    """Whether a person speaks for the team in a project."""
    return session.get(Liaison, (project_id, person_id)) is not None


def current_spec(session: Session, project_id: UUID) -> Spec:
    """Return the newest version of the delivery spec; every project has one from its first moment."""
    return session.scalars(
        select(Spec).where(Spec.project_id == project_id).order_by(Spec.version.desc()).limit(1)
    ).one()
