"""An approver in one step: an address is invited and named at once."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.queries import member_at_address, membership, studio_locked
from app.accounts.rules import LEAD_ROLES, Actor, Role, ensure_address
from app.accounts.service import invite_member
from app.projects import queries, service
from app.projects.members.service import ensure_member
from app.projects.models import ApproverChange, Liaison, Project

REASON = "invited as the approver"


def invite_approver(session: Session, actor: Actor, project_id: UUID, *, email: str) -> bool:
    """Name a member the approver, or invite the address and name it on joining; return whether it is named now."""
    access = service.project_access(session, actor, project_id)
    access.ensure_producer()
    studio_id = access.project.studio_id
    person_id = member_at_address(session, studio_id, ensure_address(email))
    if person_id is None:
        invite_member(session, actor, studio_id, email=email, roles={Role.LIAISON}, approves_project_id=project_id)
        return False
    service.add_liaison(session, actor, project_id, person_id)
    service.name_approver(session, actor, project_id, person_id=person_id, reason=REASON)
    return True


def name_invited(session: Session, *, project_id: UUID, person_id: UUID, invited_by: UUID) -> None:
    """Make a person who joined the approver, while they and the producer who invited them are in the studio."""
    project = session.get_one(Project, project_id)
    studio_locked(session, project.studio_id)  # nobody leaves between the look and the naming
    inviter = membership(session, project.studio_id, invited_by)
    if inviter is None or Role.PRODUCER not in inviter.roles:
        return
    member = membership(session, project.studio_id, person_id)
    if member is None or LEAD_ROLES.isdisjoint(member.roles) or queries.approver_of(session, project) == person_id:
        return
    if not queries.is_liaison(session, project_id, person_id):
        session.add(Liaison(project_id=project_id, person_id=person_id, studio_id=project.studio_id))
        session.flush()
    ensure_member(session, project, person_id)
    session.add(
        ApproverChange(
            studio_id=project.studio_id,
            project_id=project_id,
            person_id=person_id,
            reason=REASON,
            changed_by=invited_by,
        )
    )
