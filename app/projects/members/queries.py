"""The members of projects."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import Row, and_, delete, literal, select, update
from sqlalchemy.orm import Session, joinedload

from app.accounts.models import Membership, Token
from app.accounts.rules import Role
from app.core import clock
from app.projects.models import Project, ProjectMember
from app.projects.visibility import is_closed_to

OF_MEMBER = and_(Membership.studio_id == ProjectMember.studio_id, Membership.person_id == ProjectMember.person_id)


def members_of(session: Session, project_id: UUID) -> Sequence[Row[ProjectMember, list[str]]]:
    """Return the members of a project with their roles in the studio, in order of joining."""
    return session.execute(
        select(ProjectMember, Membership.roles)
        .join(Membership, OF_MEMBER)
        .where(ProjectMember.project_id == project_id)
        .options(joinedload(ProjectMember.person))
        .order_by(ProjectMember.created_at, ProjectMember.person_id)
    ).all()


def is_open_to(session: Session, project: Project, person_id: UUID) -> bool:
    """Whether a member of the studio sees a project."""
    closed = is_closed_to(person_id, studio_id=project.studio_id, project_id=project.id)
    return session.scalar(select(literal(1)).where(closed)) is None


def projects_without_producer(session: Session, studio_id: UUID) -> list[Project]:
    """Return the projects of a studio that no producer is in, archived ones too."""
    members = select(ProjectMember.project_id, Membership.roles).join(Membership, OF_MEMBER)
    rows = session.execute(members.where(ProjectMember.studio_id == studio_id))
    led = {project_id for project_id, roles in rows if Role.PRODUCER in roles}
    return [project for project in projects_of_studio(session, studio_id) if project.id not in led]


def projects_of_studio(session: Session, studio_id: UUID) -> Sequence[Project]:
    """Return the projects of a studio, archived ones too."""
    return session.scalars(select(Project).where(Project.studio_id == studio_id).order_by(Project.id)).all()


def delete_memberships(session: Session, studio_id: UUID, person_id: UUID) -> None:
    """Delete a person's place in every project of a studio."""
    of_person = ProjectMember.studio_id == studio_id, ProjectMember.person_id == person_id
    session.execute(delete(ProjectMember).where(*of_person))


def tokens_out_of_sight(session: Session, studio_id: UUID, person_id: UUID) -> Sequence[Row[Token, Project]]:
    """Return the live tokens in a person's name for projects that they do not see, with the projects."""
    closed = is_closed_to(person_id, studio_id=Project.studio_id, project_id=Project.id)
    tokens = select(Token, Project).join(Project, Project.id == Token.project_id).where(closed)
    of_person = Token.studio_id == studio_id, Token.created_by == person_id, Token.revoked_at.is_(None)
    return session.execute(tokens.where(*of_person)).all()


def revoke_tokens(session: Session, project_id: UUID, person_id: UUID) -> None:
    """Revoke the tokens that a person made for a project's builds."""
    live = Token.project_id == project_id, Token.created_by == person_id, Token.revoked_at.is_(None)
    session.execute(update(Token).where(*live).values(revoked_at=clock.now()))
