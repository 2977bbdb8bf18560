"""Members join projects when they are named there, and leave them with the studio."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Studio
from app.accounts.queries import members
from app.accounts.rules import AccessKind, MemberChange, MembersSee, Role
from app.projects.members import queries
from app.projects.models import Project, ProjectMember


def ensure_member(session: Session, project: Project, person_id: UUID) -> None:
    """Put a member of the studio in a project unless they are in it."""
    if session.get(ProjectMember, (project.id, person_id)) is None:
        session.add(ProjectMember(project_id=project.id, person_id=person_id, studio_id=project.studio_id))
        session.flush()


def producer_of(session: Session, project: Project) -> UUID:
    """Return the producer who has been in a project longest."""
    roles_of = queries.members_of(session, project.id)
    return next(member.person_id for member, roles in roles_of if Role.PRODUCER in roles)


def end_membership(session: Session, change: MemberChange) -> None:
    """Take who left the studio out of its projects; a producer joins those that none is in then."""
    if change.has_left:
        queries.delete_memberships(session, change.studio_id, change.person_id)
    if session.get_one(Studio, change.studio_id).members_see is MembersSee.OWN:
        producers = [member.person_id for member in members(session, change.studio_id) if Role.PRODUCER in member.roles]
        leaves_themselves = change.changed_by not in producers
        lead_projects(session, change.studio_id, producers[0] if leaves_themselves else change.changed_by)
    if AccessKind.TOKENS in change.kept:
        for token, project in queries.tokens_out_of_sight(session, change.studio_id, change.changed_by):
            token.created_by = producer_of(session, project)
        session.flush()


def lead_projects(session: Session, studio_id: UUID, producer_id: UUID) -> None:
    """Put a producer in the projects of a studio that no producer is in."""
    for project in queries.projects_without_producer(session, studio_id):
        ensure_member(session, project, producer_id)
