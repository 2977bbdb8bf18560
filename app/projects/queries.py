"""Projects within the caller's reach."""

from collections.abc import Collection, Sequence
from functools import cache
from typing import NamedTuple
from uuid import UUID

from sqlalchemy import ColumnElement, ScalarSelect, Select, Uuid, and_, bindparam, exists, func, or_, select
from sqlalchemy.orm import Session, joinedload

from app.accounts.models import Membership, Person
from app.accounts.quotas.queries import Usage
from app.accounts.rules import LEAD_ROLES, Actor, Role
from app.core import clock
from app.core.db import bypass_row_policies
from app.projects.models import ApproverChange, Engagement, Liaison, Project, ProjectInvitation, ProjectMember, Spec


def project_by_id(session: Session, project_id: UUID) -> Project | None:
    """Return a project without a check of the caller; for services that check the caller's standing, and for jobs."""
    return session.get(Project, project_id)


def sample_of_studio(session: Session, studio_id: UUID) -> Project | None:
    """Return the sample project of a studio, archived or not."""
    return session.scalar(select(Project).where(Project.studio_id == studio_id, Project.is_sample).limit(1))


projects_count = Usage(Project.studio_id)  # archived ones included


def _named_approver() -> ScalarSelect[UUID]:
    """Return the approver of a project whoever is a member, as part of a query: the one named last."""
    named = select(ApproverChange.person_id).where(ApproverChange.project_id == Project.id)
    return named.order_by(ApproverChange.id.desc()).limit(1).scalar_subquery()


def access_facts_query() -> Select[Project, Engagement, bool, UUID]:
    """Return the statement for the fields of AccessFacts, of `person_id`, in whichever projects the caller adds."""
    person_id = bindparam("person_id", type_=Uuid())
    running = and_(
        Engagement.project_id == Project.id, Engagement.designer_id == person_id, Engagement.ended_at.is_(None)
    )
    speaks = exists().where(Liaison.project_id == Project.id, Liaison.person_id == person_id)
    return select(Project, Engagement, speaks, _named_approver()).join(Engagement, running, isouter=True)


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
    """Return the basis of a person's standing in a project, without asking what they may see."""
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
    query = select(Project).where(
        or_(Project.studio_id.in_(actor.roles), engaged),
        Project.archived_at.is_not(None) if archived else Project.archived_at.is_(None),
    )
    if before is not None:
        query = query.where(Project.id < before)
    return session.scalars(query.options(joinedload(Project.studio)).order_by(Project.id.desc()).limit(limit)).all()


def running_projects(session: Session, studio_ids: Collection[UUID]) -> Sequence[Project]:
    """Return the projects of studios that are not archived."""
    return session.scalars(
        select(Project).where(Project.studio_id.in_(studio_ids), Project.archived_at.is_(None)).order_by(Project.id)
    ).all()


def rights_of(session: Session, caller: Actor | None) -> frozenset[str]:
    """Return all rights of a caller: roles in studios, and running engagements."""
    if caller is None:
        return frozenset()
    rights = {f"studio:{studio_id}:{role}" for studio_id, roles in caller.roles.items() for role in roles}
    if caller.person_id is not None:
        running = Engagement.designer_id == caller.person_id, Engagement.ended_at.is_(None)
        engaged = session.scalars(select(Engagement.project_id).where(*running))
        rights |= {f"project:{project_id}:designer" for project_id in engaged}
    if caller.limited_studio_ids:
        own = select(ProjectMember.project_id).where(ProjectMember.person_id == caller.person_id)
        rights |= {f"project:{project_id}:member" for project_id in session.scalars(own)}
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
    query = select(Engagement.id).join(Engagement.designer)
    running = query.where(Engagement.project_id == project_id, Engagement.ended_at.is_(None), Person.email == email)
    return session.scalar(running) is not None


def _approver() -> ColumnElement[UUID]:
    return func.coalesce(_named_approver(), Project.created_by)


def approver_ids(session: Session, project_ids: Collection[UUID]) -> dict[UUID, UUID]:
    """Return the approver of each project: the one named last, else who opened it, else the studio's first producer.

    The third case is for those who are in the studio no more, or may not approve with the roles they have there.
    """
    with bypass_row_policies(session):  # a designer does not see the members of the studio
        rows = session.execute(
            select(Project.id, Project.studio_id, _approver(), Membership.roles)
            .outerjoin(Membership, (Membership.studio_id == Project.studio_id) & (Membership.person_id == _approver()))
            .where(Project.id.in_(project_ids))
        ).all()
        vacant = {studio_id for _, studio_id, _, roles in rows if LEAD_ROLES.isdisjoint(roles or ())}
        producers = _first_producers(session, vacant) if vacant else {}
    return {
        project_id: producers.get(studio_id, person_id) if LEAD_ROLES.isdisjoint(roles or ()) else person_id
        for project_id, studio_id, person_id, roles in rows
    }


def _first_producers(session: Session, studio_ids: Collection[UUID]) -> dict[UUID, UUID]:
    rows = session.execute(
        select(Membership.studio_id, Membership.person_id, Membership.roles)
        .where(Membership.studio_id.in_(studio_ids))
        .order_by(Membership.created_at.desc(), Membership.person_id.desc())
    )
    return {studio_id: person_id for studio_id, person_id, roles in rows if Role.PRODUCER in roles}


def approver_of(session: Session, project: Project) -> UUID:
    """Return the approver of a project."""
    return approver_ids(session, [project.id])[project.id]


def approvers_of(session: Session, projects: Collection[Project]) -> dict[UUID, Person]:
    """Return the approver of each project, by its id."""
    ids = approver_ids(session, [project.id for project in projects])
    people = {
        person.id: person for person in session.scalars(select(Person).where(Person.id.in_(set(ids.values())))).all()
    }
    return {project_id: people[person_id] for project_id, person_id in ids.items()}


def projects_approved_by(session: Session, studio_id: UUID, person_id: UUID) -> Sequence[Project]:
    """Return the projects of a studio whose approver is a person, archived ones too, the oldest first."""
    return session.scalars(
        select(Project).where(Project.studio_id == studio_id, _approver() == person_id).order_by(Project.id)
    ).all()


def projects_led_by(session: Session, studio_id: UUID, person_id: UUID) -> Sequence[Project]:
    """Return the projects of a studio in which a person is a liaison, archived ones too, the oldest first."""
    return session.scalars(
        select(Project)
        .join(Liaison, Liaison.project_id == Project.id)
        .where(Project.studio_id == studio_id, Liaison.person_id == person_id)
        .order_by(Project.id)
    ).all()


def open_invitations_by(session: Session, studio_id: UUID, person_id: UUID) -> Sequence[ProjectInvitation]:
    """Return the invitations of designers that a person sent for a studio and that can be accepted still."""
    return session.scalars(
        select(ProjectInvitation)
        .where(
            ProjectInvitation.studio_id == studio_id,
            ProjectInvitation.invited_by == person_id,
            ProjectInvitation.accepted_at.is_(None),
            ProjectInvitation.revoked_at.is_(None),
            ProjectInvitation.expires_at > clock.now(),
        )
        .options(joinedload(ProjectInvitation.project))
        .order_by(ProjectInvitation.id)
    ).all()


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
    """Return the liaisons of projects whose roles in the studio allow it, in order of naming."""
    rows = session.execute(
        select(Liaison, Membership.roles)
        .join(
            Membership,
            (Membership.studio_id == Liaison.studio_id) & (Membership.person_id == Liaison.person_id),
        )
        .where(Liaison.project_id.in_(project_ids))
        .options(joinedload(Liaison.person))
        .order_by(Liaison.created_at, Liaison.person_id)
    )
    return [liaison for liaison, roles in rows if not LEAD_ROLES.isdisjoint(roles)]


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
    query = select(Spec).where(Spec.project_id == project_id)
    if below is not None:
        query = query.where(Spec.version < below)
    return session.scalars(query.options(joinedload(Spec.author)).order_by(Spec.version.desc()).limit(limit)).all()


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
