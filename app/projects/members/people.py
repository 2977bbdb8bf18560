"""The people of one project, whom a producer adds and removes, and the studio's setting that makes it matter."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.errors import StudioNotFound
from app.accounts.models import Studio
from app.accounts.queries import membership, studio_locked
from app.accounts.rules import Actor, MembersSee, Role
from app.accounts.security_log.rules import SecurityEventKind
from app.accounts.security_log.service import record
from app.accounts.service import ensure_member_of, ensure_producer_of
from app.core import clock
from app.core.events import send
from app.projects.approval import queries as approval_queries
from app.projects.approval.service import approval_rights
from app.projects.errors import MemberNeeded, ProjectMemberNotFound
from app.projects.members import queries
from app.projects.members.service import ensure_member, lead_projects
from app.projects.models import Project, ProjectMember
from app.projects.queries import is_liaison, liaisons_of
from app.projects.service import project_access
from app.projects.signals import NeededPeople

SETTING_WORDS = {
    MembersSee.ALL: "let members see all projects",
    MembersSee.OWN: "let members see only the projects that they are in",
}


def members_see(session: Session, actor: Actor, studio_id: UUID) -> MembersSee:
    """Return the projects that the members of the caller's studio see."""
    ensure_member_of(actor, studio_id)
    return session.get_one(Studio, studio_id).members_see


def set_members_see(session: Session, actor: Actor, studio_id: UUID, sight: MembersSee) -> MembersSee:
    """Show the members of a studio all projects or their own; the caller joins those that no producer is in."""
    ensure_producer_of(session, actor, studio_id)
    studio = studio_locked(session, studio_id)
    if studio is None:
        raise StudioNotFound(f"no studio {studio_id}")
    if studio.members_see is not sight:
        if sight is MembersSee.OWN:  # before it holds: the caller may not see all projects then
            _add_named_people(session, studio_id)
            lead_projects(session, studio_id, actor.person)
        studio.members_see = sight
        session.flush()
        record(session, SecurityEventKind.ROLES, SETTING_WORDS[sight], studio_ids=[studio_id], person_id=actor.person)
    return sight


def _add_named_people(session: Session, studio_id: UUID) -> None:
    for project in queries.projects_of_studio(session, studio_id):
        rights = approval_rights(session, project)
        leads = {liaison.person_id for liaison in liaisons_of(session, [project.id])}
        deputies = {deputy_id for deputy_ids in rights.deputies.values() for deputy_id in deputy_ids}
        for person_id in {
            rights.approver_id,
            *rights.by_category.values(),
            *leads,
            *deputies,
            *_needed(session, project),
        }:
            ensure_member(session, project, person_id)


def _needed(session: Session, project: Project) -> dict[UUID, str]:
    """Return the people whom rooms above this one need in a project, each with what they are there."""
    return {id_: part for needed in send(session, NeededPeople(project.id)) for id_, part in needed.items()}


def people_of_project(session: Session, actor: Actor, project_id: UUID) -> tuple[MembersSee, Sequence[ProjectMember]]:
    """Return the studio's visibility setting, and the project's members in order of joining."""
    access = project_access(session, actor, project_id)
    access.ensure_team()
    members = [member for member, _ in queries.members_of(session, project_id)]
    return members_see(session, actor, access.project.studio_id), members


def add_member(session: Session, actor: Actor, project_id: UUID, person_id: UUID) -> None:
    """Put a member of the studio in a project; raise ProjectMemberNotFound for others."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    studio_locked(session, access.project.studio_id)  # nobody leaves between the look and the naming
    if membership(session, access.project.studio_id, person_id) is None:
        raise ProjectMemberNotFound(f"no person {person_id} in this studio", fix="invite them into the studio first")
    ensure_member(session, access.project, person_id)


def remove_member(session: Session, actor: Actor, project_id: UUID, person_id: UUID) -> None:
    """Take a member out of a project, and revoke the build tokens that they made for it.

    Raises MemberNeeded for approvers, deputies, audio leads, signers and the only producer.
    """
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    studio_locked(session, access.project.studio_id)  # two producers leaving at once would leave none
    roles = {member.person_id: held for member, held in queries.members_of(session, project_id)}
    member = session.get(ProjectMember, (project_id, person_id))
    if member is None:
        raise ProjectMemberNotFound(f"no person {person_id} in this project")
    today = clock.now().date()
    if is_liaison(session, project_id, person_id) or approval_rights(session, access.project).is_approver(person_id):
        raise MemberNeeded("this person is an approver or an audio lead here", fix="name another person first")
    if part := _needed(session, access.project).get(person_id):
        raise MemberNeeded(f"this person {part}", fix="name another person first")
    if approval_queries.is_deputy_until(session, project_id, person_id, until=today):
        raise MemberNeeded("this person is a deputy, or has one", fix="withdraw the deputy first")
    if not any(Role.PRODUCER in held for id_, held in roles.items() if id_ != person_id):
        raise MemberNeeded("this person is the only producer in the project", fix="add another producer first")
    session.delete(member)
    queries.revoke_tokens(session, project_id, person_id)
    session.flush()
