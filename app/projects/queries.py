"""Projects within the caller's reach."""

from collections.abc import Collection, Sequence
from functools import cache
from typing import NamedTuple
from uuid import UUID

from sqlalchemy import ColumnElement, Select, Uuid, and_, bindparam, exists, func, or_, select
from sqlalchemy.orm import Session, joinedload

from app.accounts.models import Membership, Person
from app.accounts.rules import Actor
from app.kit import clock
from app.projects.models import ApproverChange, Engagement, Liaison, Project, ProjectInvitation, Spec


def project_by_id(session: Session, project_id: UUID) -> Project | None:
    """Return a project without a check of the caller; for services that check the caller's standing, and for jobs."""
    return session.get(Project, project_id)


def projects_count(session: Session, studio_id: UUID) -> int:
    """Return how many projects a studio has, archived ones included."""
    return session.scalar(select(func.count()).where(Project.studio_id == studio_id)) or 0


def access_facts_query() -> Select[Project, Engagement, bool, UUID]:
    """Return the statement for the fields of AccessFacts, of `person_id`, in whichever projects the caller adds."""
    person_id = bindparam("person_id", type_=Uuid())
    named = (
        select(ApproverChange.person_id)
        .where(ApproverChange.project_id == Project.id)
        .order_by(ApproverChange.id.desc())
        .limit(1)
        .scalar_subquery()
    )
    running = and_(
        Engagement.project_id == Project.id, Engagement.designer_id == person_id, Engagement.ended_at.is_(None)
    )
    speaks = exists().where(Liaison.project_id == Project.id, Liaison.person_id == person_id)
    return select(Project, Engagement, speaks, named).join(Engagement, running, isouter=True)


# Built once: nearly every request asks for it.
_ACCESS_FACTS = access_facts_query().where(Project.id == bindparam("project_id", type_=Uuid()))


class AccessFacts(NamedTuple):
    """A project, and the caller's roles in it."""

    project: Project
    engagement: Engagement | None
    is_liaison: bool
    named_approver_id: UUID | None

    @property
    def approver_id(self) -> UUID:
        """The approver: the one named last, else the producer who opened the project."""
        return self.named_approver_id or self.project.created_by


def access_facts(session: Session, project_id: UUID, person_id: UUID) -> AccessFacts | None:
    """Return what a person's standing in a project depends on, without asking what they may see."""
    row = session.execute(_ACCESS_FACTS, {"project_id": project_id, "person_id": person_id}).one_or_none()
    return AccessFacts._make(row) if row else None


def lock_project(session: Session, project_id: UUID) -> None:
    """Lock the numbering of versions in this project until the transaction ends."""
    session.execute(select(Project.id).where(Project.id == project_id).with_for_update(key_share=True))


def projects_seen(
    session: Session, actor: Actor, *, before: UUID | None, limit: int, archived: bool
) -> Sequence[Project]:
    """Return the projects of the caller's studios and engagements, newest first, with their studios."""
    engaged = exists().where(
        Engagement.project_id == Project.id,
        Engagement.designer_id == actor.person,
        Engagement.ended_at.is_(None),
    )
    found = select(Project).where(
        or_(Project.studio_id.in_(actor.roles), engaged),
        Project.archived_at.is_not(None) if archived else Project.archived_at.is_(None),
    )
    if before is not None:
        found = found.where(Project.id < before)
    return session.scalars(found.options(joinedload(Project.studio)).order_by(Project.id.desc()).limit(limit)).all()


def running_projects(session: Session, studio_ids: Collection[UUID]) -> Sequence[Project]:
    """Return the projects of studios that are not archived."""
    return session.scalars(
        select(Project).where(Project.studio_id.in_(studio_ids), Project.archived_at.is_(None)).order_by(Project.id)
    ).all()


def rights_of(session: Session, caller: Actor | None) -> frozenset[str]:
    """Return what a caller may do at all: roles in studios, and running engagements."""
    if caller is None:
        return frozenset()
    rights = {f"studio:{studio_id}:{role}" for studio_id, roles in caller.roles.items() for role in roles}
    if caller.person_id is not None:
        running = Engagement.designer_id == caller.person_id, Engagement.ended_at.is_(None)
        engaged = session.scalars(select(Engagement.project_id).where(*running))
        rights |= {f"project:{project_id}:designer" for project_id in engaged}
    return frozenset(rights)


def any_engagement_of(session: Session, project_id: UUID, person_id: UUID) -> Engagement | None:
    """Return a designer's engagement on a project, running or ended."""
    return session.scalar(
        select(Engagement)
        .where(Engagement.project_id == project_id, Engagement.designer_id == person_id)
        .options(joinedload(Engagement.designer))
    )


def engagement_by_id(session: Session, project_id: UUID, engagement_id: UUID) -> Engagement | None:
    """Return one engagement of a project."""
    return session.scalar(
        select(Engagement)
        .where(Engagement.id == engagement_id, Engagement.project_id == project_id)
        .options(joinedload(Engagement.designer))
    )


def is_engaged_address(session: Session, project_id: UUID, email: str) -> bool:
    """Whether a normalised address belongs to a designer who is engaged on the project now."""
    found = select(Engagement.id).join(Engagement.designer)
    running = found.where(Engagement.project_id == project_id, Engagement.ended_at.is_(None), Person.email == email)
    return session.scalar(running) is not None


def approver_id(project: Project) -> ColumnElement[UUID]:
    """Return the approver as part of a query: the one named last, else who opened the project."""
    named = select(ApproverChange.person_id).where(ApproverChange.project_id == project.id)
    return func.coalesce(named.order_by(ApproverChange.id.desc()).limit(1).scalar_subquery(), project.created_by)


def approver_of(session: Session, project: Project) -> UUID:
    """Return the approver of a project."""
    return session.scalars(select(approver_id(project))).one()


def approvers_of(session: Session, projects: Collection[Project]) -> dict[UUID, Person]:
    """Return the approver of each project, by its id."""
    order = func.row_number().over(partition_by=ApproverChange.project_id, order_by=ApproverChange.id.desc())
    numbered = (
        select(ApproverChange.project_id, ApproverChange.person_id, order.label("place"))
        .where(ApproverChange.project_id.in_([project.id for project in projects]))
        .subquery()
    )
    newest = select(numbered.c.project_id, numbered.c.person_id).where(numbered.c.place == 1)
    named = dict(session.execute(newest).all())
    ids = {project.id: named.get(project.id, project.created_by) for project in projects}
    people = {
        person.id: person for person in session.scalars(select(Person).where(Person.id.in_(set(ids.values())))).all()
    }
    return {project_id: people[person_id] for project_id, person_id in ids.items()}


def approver_changes(session: Session, project_id: UUID) -> Sequence[ApproverChange]:
    """Return the project's approvers, newest first."""
    return session.scalars(
        select(ApproverChange)
        .where(ApproverChange.project_id == project_id)
        .options(joinedload(ApproverChange.person), joinedload(ApproverChange.changer))
        .order_by(ApproverChange.id.desc())
    ).all()


def is_liaison(session: Session, project_id: UUID, person_id: UUID) -> bool:
    """Whether a person acts for the team in a project."""
    return session.get(Liaison, (project_id, person_id)) is not None


def liaisons_of(session: Session, project_ids: Collection[UUID]) -> Sequence[Liaison]:
    """Return the liaisons of projects who are still of the studio, in order of naming."""
    return session.scalars(
        select(Liaison)
        .join(
            Membership,
            (Membership.studio_id == Liaison.studio_id) & (Membership.person_id == Liaison.person_id),
        )
        .where(Liaison.project_id.in_(project_ids))
        .options(joinedload(Liaison.person))
        .order_by(Liaison.created_at, Liaison.person_id)
    ).all()


def engagements_of(session: Session, project_ids: Collection[UUID]) -> Sequence[Engagement]:
    """Return the engagements on projects, running and ended, in order of their making."""
    return session.scalars(
        select(Engagement)
        .where(Engagement.project_id.in_(project_ids))
        .options(joinedload(Engagement.designer))
        .order_by(Engagement.id)
    ).all()


def spec_versions_of(session: Session, project_ids: Collection[UUID]) -> dict[UUID, int]:
    """Return the newest spec version of each project."""
    newest = select(Spec.project_id, func.max(Spec.version)).where(Spec.project_id.in_(project_ids))
    return dict(session.execute(newest.group_by(Spec.project_id)).all())


def current_spec(session: Session, project_id: UUID) -> Spec:
    """Return the newest version of the delivery spec; every project has one from its first moment."""
    return session.scalars(_newest_spec(), {"project_id": project_id}).one()


def current_spec_and_author(session: Session, project_id: UUID) -> Spec:
    """Return the newest version of the delivery spec with the person who saved it."""
    with_author = _newest_spec().options(joinedload(Spec.author))
    return session.scalars(with_author, {"project_id": project_id}).one()


@cache  # asked for so often that building the statement would show
def _newest_spec() -> Select[Spec]:
    of_project = select(Spec).where(Spec.project_id == bindparam("project_id"))
    return of_project.order_by(Spec.version.desc()).limit(1)


def spec_version(session: Session, project_id: UUID, version: int) -> Spec | None:
    """Return one version of the delivery spec."""
    return session.scalar(
        select(Spec).where(Spec.project_id == project_id, Spec.version == version).options(joinedload(Spec.author))
    )


def spec_versions(session: Session, project_id: UUID, *, below: int | None, limit: int) -> Sequence[Spec]:
    """Return the versions of the delivery spec, newest first."""
    found = select(Spec).where(Spec.project_id == project_id)
    if below is not None:
        found = found.where(Spec.version < below)
    return session.scalars(found.options(joinedload(Spec.author)).order_by(Spec.version.desc()).limit(limit)).all()


def invitations(session: Session, project_id: UUID) -> Sequence[ProjectInvitation]:
    """Return a project's invitations that were not withdrawn, newest first."""
    return session.scalars(
        select(ProjectInvitation)
        .where(ProjectInvitation.project_id == project_id, ProjectInvitation.revoked_at.is_(None))
        .options(joinedload(ProjectInvitation.inviter))
        .order_by(ProjectInvitation.id.desc())
    ).all()


def invitation_by_secret(session: Session, secret_sha256: str) -> ProjectInvitation | None:
    """Return the invitation behind a link that is still good, with its project, studio and inviter."""
    return session.scalar(
        select(ProjectInvitation)
        .where(
            ProjectInvitation.secret_sha256 == secret_sha256,
            ProjectInvitation.revoked_at.is_(None),
            ProjectInvitation.expires_at > clock.now(),
        )
        .options(
            joinedload(ProjectInvitation.project).joinedload(Project.studio),
            joinedload(ProjectInvitation.inviter),
        )
    )
