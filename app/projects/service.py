"""Projects: who stands where in one, and the steps that change it."""

from dataclasses import dataclass
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Role
from app.projects import queries
from app.projects.errors import DeciderNeeded, DesignerNeeded, ProducerNeeded, ProjectNotFound, TeamNeeded
from app.projects.models import Engagement, Project


@dataclass(frozen=True)
class Standing:
    """What a caller is in one project; whoever has one sees the project."""

    project: Project
    actor: Actor
    roles: frozenset[Role]
    is_liaison: bool
    is_decider: bool
    engagement: Engagement | None

    @property
    def is_team(self) -> bool:
        """Whether the caller is a member of the studio."""
        return bool(self.roles)

    @property
    def is_producer(self) -> bool:
        """Whether the caller runs the project and its money."""
        return Role.PRODUCER in self.roles

    @property
    def only_designer_id(self) -> UUID | None:
        """The designer whose work alone the caller sees; None: the whole project's."""
        return None if self.is_team or self.actor.is_build else self.actor.person

    def ensure_team(self) -> None:
        """Raise TeamNeeded unless the caller is a member of the studio."""
        if not self.is_team:
            raise TeamNeeded("only the game team can do this")

    def ensure_producer(self) -> None:
        """Raise ProducerNeeded unless the caller is a producer of the studio."""
        if not self.is_producer:
            raise ProducerNeeded("only a producer of the studio can do this")

    def ensure_speaks(self) -> None:
        """Raise TeamNeeded unless the caller speaks for the team: a producer, a liaison or the decider."""
        if not (self.is_producer or self.is_liaison or self.is_decider):
            raise TeamNeeded("only a producer or a liaison of this project can do this")

    def ensure_decider(self) -> None:
        """Raise DeciderNeeded unless the caller has the last word."""
        if not self.is_decider:
            raise DeciderNeeded(
                "you advise here: only the project's approver decides; comment instead"
            )

    def ensure_designer(self) -> Engagement:
        """Return the caller's engagement, or raise DesignerNeeded."""
        if self.engagement is None:
            raise DesignerNeeded("only a sound designer engaged on this project can do this")
        return self.engagement


def standing_in(session: Session, actor: Actor, project_id: UUID) -> Standing:
    """Return what the caller is in a project; raise ProjectNotFound where they may not see it."""
    project = queries.project_by_id(session, project_id)
    if project is None:
        raise ProjectNotFound(f"no project {project_id}")
    if actor.is_build:
        if actor.token_project_id != project.id:
            raise ProjectNotFound(f"no project {project_id}")
        return Standing(project, actor, frozenset(), is_liaison=False, is_decider=False, engagement=None)
    if actor.person_id is None:
        raise ProjectNotFound(f"no project {project_id}")
    roles = actor.roles_in(project.studio_id)
    engagement = queries.engagement_of(session, project.id, actor.person_id)
    if not roles and engagement is None:
        raise ProjectNotFound(f"no project {project_id}")
    return Standing(
        project=project,
        actor=actor,
        roles=roles,
        is_liaison=bool(roles) and queries.is_liaison(session, project.id, actor.person_id),
        is_decider=bool(roles) and queries.decider_of(session, project) == actor.person_id,
        engagement=engagement,
    )
