"""The endpoints of project members, and of the projects that a studio's members see."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.errors import RecentSignInNeeded, StudioNotFound
from app.accounts.rules import Actor, Audience
from app.accounts.schemas import PersonBrief
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.projects.errors import MemberNeeded, ProducerNeeded, ProjectMemberNotFound, ProjectNotFound, TeamNeeded
from app.projects.members import people
from app.projects.members.schemas import ProjectMemberRead, ProjectMembersRead, ProjectSight

router = APIRouter(prefix="/v1", tags=["projects"])


@router.get("/studios/{studio_id}/members-see", responses=problems(StudioNotFound))
def read_members_see(studio_id: UUID, session: DbSession, actor: Actor = allows(Audience.STUDIO)) -> ProjectSight:
    """Return whether the studio's members see all projects or only those that they are in."""
    return ProjectSight(members_see=people.members_see(session, actor, studio_id))


@router.put("/studios/{studio_id}/members-see", responses=problems(StudioNotFound, ProducerNeeded, RecentSignInNeeded))
def set_members_see(
    studio_id: UUID,
    body: ProjectSight,
    session: DbSession,
    actor: Actor = allows(Audience.PRODUCER, recent_sign_in=True),
) -> ProjectSight:
    """Show the studio's members all projects, or only those that they are in."""
    return ProjectSight(members_see=people.set_members_see(session, actor, studio_id, body.members_see))


@router.get("/projects/{project_id}/members", responses=problems(ProjectNotFound, TeamNeeded))
def list_project_members(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> ProjectMembersRead:
    """Return the members of the project."""
    sight, members = people.people_of_project(session, actor, project_id)
    return ProjectMembersRead(
        members_see=sight,
        members=[ProjectMemberRead(person=PersonBrief.model_validate(member.person)) for member in members],
    )


@router.put(
    "/projects/{project_id}/members/{person_id}",
    status_code=204,
    responses=problems(ProjectNotFound, ProducerNeeded, ProjectMemberNotFound),
)
def add_project_member(
    project_id: UUID, person_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> None:
    """Put a member of the studio in the project."""
    people.add_member(session, actor, project_id, person_id)


@router.delete(
    "/projects/{project_id}/members/{person_id}",
    status_code=204,
    responses=problems(ProjectNotFound, ProducerNeeded, ProjectMemberNotFound, MemberNeeded),
)
def remove_project_member(
    project_id: UUID, person_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> None:
    """Take a member of the studio out of the project, and revoke the build tokens that they made for it."""
    people.remove_member(session, actor, project_id, person_id)
