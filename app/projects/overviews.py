"""Projects as their pages head them: approver, audio leads, engagements and the caller's part."""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.queries import people_by_id
from app.accounts.rules import Actor, Role
from app.projects import queries
from app.projects.approval.service import approval_rights_of
from app.projects.models import Engagement, Project
from app.projects.rules import ApprovalRights
from app.projects.service import project_access


@dataclass(frozen=True)
class ProjectOverview:
    """A project as its page's header shows it; a designer sees only their own engagement."""

    project: Project
    approver: Person
    rights: ApprovalRights
    category_approvers: Mapping[str, Person]
    liaisons: Sequence[Person]
    engagements: Sequence[Engagement]
    spec_version: int
    roles: frozenset[Role]
    person_id: UUID

    @property
    def is_producer(self) -> bool:
        """Whether the caller runs the project and its money."""
        return Role.PRODUCER in self.roles

    @property
    def is_liaison(self) -> bool:
        """Whether the caller acts for the team."""
        return bool(self.roles) and any(person.id == self.person_id for person in self.liaisons)

    @property
    def is_approver(self) -> bool:
        """Whether the caller approves some cues today, as an approver or a deputy."""
        return bool(self.roles) and self.rights.scope_of(self.person_id).is_any

    @property
    def own_engagement(self) -> Engagement | None:
        """The caller's running engagement."""
        running = (
            engagement
            for engagement in self.engagements
            if engagement.designer_id == self.person_id and engagement.ended_at is None
        )
        return next(running, None)


def overviews(session: Session, actor: Actor, projects: Sequence[Project]) -> list[ProjectOverview]:
    """Return projects that the caller sees as their pages head them, in the given order."""
    ids = [project.id for project in projects]
    approvers = queries.approvers_of(session, projects)
    rights = approval_rights_of(session, {project_id: person.id for project_id, person in approvers.items()})
    people = people_by_id(
        session, {person_id for of_project in rights.values() for person_id in of_project.by_category.values()}
    )
    versions = queries.spec_versions_of(session, ids)
    liaisons: defaultdict[UUID, list[Person]] = defaultdict(list)
    for liaison in queries.liaisons_of(session, ids):
        liaisons[liaison.project_id].append(liaison.person)
    engagements: defaultdict[UUID, list[Engagement]] = defaultdict(list)
    for engagement in queries.engagements_of(session, ids):
        engagements[engagement.project_id].append(engagement)
    return [
        ProjectOverview(
            project=project,
            approver=approvers[project.id],
            rights=rights[project.id],
            category_approvers={name: people[person_id] for name, person_id in rights[project.id].by_category.items()},
            liaisons=liaisons[project.id],
            engagements=[
                engagement
                for engagement in engagements[project.id]
                if actor.roles_in(project.studio_id) or engagement.designer_id == actor.person
            ],
            spec_version=versions[project.id],
            roles=actor.roles_in(project.studio_id),
            person_id=actor.person,
        )
        for project in projects
    ]


def overview(session: Session, actor: Actor, project_id: UUID) -> ProjectOverview:
    """Return one project as its page heads it."""
    access = project_access(session, actor, project_id, before_nda=True)
    session.refresh(access.project, ["studio"])
    return overviews(session, actor, [access.project])[0]
