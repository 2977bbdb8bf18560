"""Projects: access to them, and the steps that change them."""

from collections.abc import Sequence
from dataclasses import dataclass
from uuid import UUID

from sqlalchemy.orm import Session

import audio_checks
from app.accounts.authentication import sha256_of
from app.accounts.queries import membership, studio_locked
from app.accounts.quotas.service import QuotaKind, ensure_quota
from app.accounts.rules import LEAD_ROLES, Actor, Role
from app.accounts.service import ensure_producer_of
from app.core import clock
from app.core.access_scope import AccessScope
from app.core.db import bypass_row_policies, set_access_scope
from app.core.events import publish
from app.projects import queries
from app.projects.approval import queries as approval_queries
from app.projects.errors import (
    DesignerNeeded,
    InvitationNotFound,
    LiaisonIsApprover,
    LiaisonNotFound,
    NdaNeeded,
    ProducerNeeded,
    ProjectNotFound,
    SpecChanged,
    SpecVersionNotFound,
    TeamNeeded,
)
from app.projects.members.service import ensure_member
from app.projects.models import ApproverChange, Engagement, Liaison, Project, ProjectInvitation, Spec
from app.projects.rules import DesignersHear, ensure_can_approve
from app.projects.specs.service import add_version, read_spec
from app.projects.visibility import nda_is_pending


@dataclass(frozen=True)
class ProjectAccess:
    """A caller's roles in one project; a caller with access sees the project."""

    project: Project
    actor: Actor
    roles: frozenset[Role]
    is_liaison: bool
    is_approver: bool
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

    @property
    def is_party(self) -> bool:
        """Whether the caller sees contracts and money: acts for the team, or is a designer, who sees their own."""
        return not self.is_team or self.is_producer or self.is_liaison or self.is_approver

    def ensure_team(self) -> None:
        """Raise TeamNeeded unless the caller is a member of the studio."""
        if not self.is_team:
            raise TeamNeeded("only the game team can do this")

    def ensure_producer(self) -> None:
        """Raise ProducerNeeded unless the caller is a producer of the studio."""
        if not self.is_producer:
            raise ProducerNeeded("only a producer of the studio can do this")

    def ensure_may_speak(self) -> None:
        """Raise TeamNeeded unless the caller acts for the team: a producer, a liaison or the approver."""
        if not (self.is_producer or self.is_liaison or self.is_approver):
            raise TeamNeeded("only a producer or an audio lead of this project can do this")

    def ensure_party(self) -> None:
        """Raise TeamNeeded for members of the studio who do not act for it, and so see no contract and no money.

        Designers pass: they see their own.
        """
        if not self.is_party:
            self.ensure_may_speak()

    def ensure_designer(self) -> Engagement:
        """Return the caller's engagement, or raise DesignerNeeded."""
        if self.engagement is None:
            raise DesignerNeeded("only a sound designer engaged on this project can do this")
        return self.engagement


def project_access(session: Session, actor: Actor, project_id: UUID, *, before_nda: bool = False) -> ProjectAccess:
    """Return the caller's access to a project; raise ProjectNotFound if they may not see it.

    Raises NdaNeeded for a designer who has not accepted the NDA that the project asks for, but for what may be seen
    `before_nda`.
    """
    if actor.is_build:
        built = queries.project_by_id(session, project_id)
        if built is None or actor.token_project_id != built.id:
            raise ProjectNotFound(f"no project {project_id}")
        return ProjectAccess(built, actor, frozenset(), is_liaison=False, is_approver=False, engagement=None)
    facts = queries.access_facts(session, project_id, actor.person_id) if actor.person_id else None
    if facts is None:
        raise ProjectNotFound(f"no project {project_id}")
    return access_from_facts(actor, facts, before_nda=before_nda)


def ensure_speaks_in(session: Session, actor: Actor, project_id: UUID) -> None:
    """Raise TeamNeeded unless the caller acts for the studio in a project."""
    project_access(session, actor, project_id).ensure_may_speak()


def access_from_facts(actor: Actor, facts: queries.AccessFacts, *, before_nda: bool = False) -> ProjectAccess:
    """Return a person's access to a project by these facts of theirs; raise as `project_access` does."""
    project, engagement = facts.project, facts.engagement
    roles = actor.roles_in(project.studio_id)
    if not roles and engagement is None:
        raise ProjectNotFound(f"no project {project.id}")
    if not roles and not before_nda and engagement is not None and nda_is_pending(project, engagement):
        raise NdaNeeded(
            "this project shows its brief, list and spec once its non-disclosure agreement is signed",
            fix="read and sign it under Contract & money; if there is none, the studio has not sent it yet",
        )
    may_lead = not roles.isdisjoint(LEAD_ROLES)  # a row that names the caller gives nothing by itself
    return ProjectAccess(
        project=project,
        actor=actor,
        roles=roles,
        is_liaison=may_lead and facts.is_liaison,
        is_approver=may_lead and facts.approver_id == actor.person_id,
        engagement=engagement,
    )


def create_project(
    session: Session,
    actor: Actor,
    studio_id: UUID,
    *,
    name: str,
    cue_prefix: str,
    description: str = "",
    preset: str = "44k1",
) -> Project:
    """Create a project with the field's default spec; its creator is the approver until another is named."""
    ensure_producer_of(session, actor, studio_id)
    ensure_quota(session, studio_id, QuotaKind.PROJECTS, queries.projects_count)
    project = Project(
        studio_id=studio_id, name=name, description=description, cue_prefix=cue_prefix, created_by=actor.person
    )
    with bypass_row_policies(session):  # who sees only their own projects is in the new one from here on
        session.add(project)
        session.flush()
        ensure_member(session, project, actor.person)
    toml = audio_checks.new_spec(preset, name=name)
    add_version(session, project, actor.person, toml=toml, number=1, note="The field's defaults")
    return project


def change_project(
    session: Session,
    actor: Actor,
    project_id: UUID,
    *,
    name: str | None = None,
    description: str | None = None,
    cue_prefix: str | None = None,
    archived: bool | None = None,
    nda_needed: bool | None = None,
    designers_hear: DesignersHear | None = None,
) -> None:
    """Change a project's name and settings, or archive it; None leaves a value as it is."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    project = access.project
    project.name = project.name if name is None else name
    project.description = project.description if description is None else description
    project.cue_prefix = project.cue_prefix if cue_prefix is None else cue_prefix
    project.nda_needed = project.nda_needed if nda_needed is None else nda_needed
    project.designers_hear = project.designers_hear if designers_hear is None else designers_hear
    if archived is not None and archived != (project.archived_at is not None):
        project.archived_at = clock.now() if archived else None
    session.flush()


def add_liaison(session: Session, actor: Actor, project_id: UUID, person_id: UUID) -> None:
    """Make a member of the studio a liaison of this project; they receive the studio's role for it too."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    studio_id = access.project.studio_id
    studio_locked(session, studio_id)  # nobody leaves between the look and the naming
    member = membership(session, studio_id, person_id)
    if member is None:
        raise LiaisonNotFound(f"no person {person_id} in this studio", fix="invite them into the studio first")
    if LEAD_ROLES.isdisjoint(member.roles):
        member.roles = sorted({*member.roles, Role.LIAISON})
    ensure_member(session, access.project, person_id)
    if not queries.is_liaison(session, project_id, person_id):
        session.add(Liaison(project_id=project_id, person_id=person_id, studio_id=studio_id))
        session.flush()


def remove_liaison(session: Session, actor: Actor, project_id: UUID, person_id: UUID) -> None:
    """Remove a liaison; raise LiaisonIsApprover while they are an approver or a deputy, or have a deputy."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    liaison = session.get(Liaison, (project_id, person_id))
    if liaison is None:
        raise LiaisonNotFound(f"no audio lead {person_id} in this project")
    if queries.approver_of(session, access.project) == person_id:
        raise LiaisonIsApprover("this audio lead is the project's approver", fix="name another approver first")
    for named in approval_queries.category_approvers(session, [project_id]):
        if named.person_id == person_id:
            raise LiaisonIsApprover(
                f"this audio lead is the approver of the category {named.category}",
                fix="name another approver of the category first",
            )
    if approval_queries.is_deputy_until(session, project_id, person_id, until=clock.now().date()):
        raise LiaisonIsApprover("this audio lead is a deputy, or has one", fix="withdraw the deputy first")
    session.delete(liaison)
    session.flush()


def name_approver(session: Session, actor: Actor, project_id: UUID, *, person_id: UUID, reason: str) -> None:
    """Make a liaison the approver, or a producer who takes over; who, when and why is kept."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    project = access.project
    studio_locked(session, project.studio_id)  # nobody leaves between the look and the naming
    member = membership(session, project.studio_id, person_id)
    ensure_can_approve(
        is_liaison=member is not None and queries.is_liaison(session, project_id, person_id),
        is_producer=member is not None and Role.PRODUCER in member.roles,
    )
    ensure_member(session, project, person_id)
    session.add(
        ApproverChange(
            studio_id=project.studio_id,
            project_id=project_id,
            person_id=person_id,
            reason=reason,
            changed_by=actor.person,
        )
    )
    session.flush()


def approver_history(session: Session, actor: Actor, project_id: UUID) -> Sequence[ApproverChange]:
    """Return the project's approvers, newest first."""
    project_access(session, actor, project_id).ensure_team()
    return queries.approver_changes(session, project_id)


def spec_in_force(session: Session, actor: Actor, project_id: UUID) -> Spec:
    """Return the spec that holds now."""
    project_access(session, actor, project_id)
    return queries.current_spec_and_author(session, project_id)


def spec_version(session: Session, actor: Actor, project_id: UUID, number: int) -> Spec:
    """Return one version of the spec."""
    project_access(session, actor, project_id)
    spec = queries.spec_version(session, project_id, number)
    if spec is None:
        raise SpecVersionNotFound(f"this project has no spec of version {number}")
    return spec


def spec_versions(session: Session, actor: Actor, project_id: UUID, *, below: int | None, limit: int) -> Sequence[Spec]:
    """Return the versions of the spec, newest first."""
    project_access(session, actor, project_id)
    return queries.spec_versions(session, project_id, below=below, limit=limit)


def save_spec(
    session: Session, actor: Actor, project_id: UUID, *, toml: str, based_on_version: int, note: str = ""
) -> Spec:
    """Add a version to the spec, and have the affected takes checked again.

    Raises BadSpec for what is not a spec, SpecChanged when the newest version is not the one that was edited.
    """
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    read = read_spec(toml)
    queries.lock_project(session, project_id)
    newest = queries.current_spec_and_author(session, project_id)
    if newest.version != based_on_version:
        raise SpecChanged(
            f"{newest.author.name} saved version {newest.version}; yours began from version {based_on_version}",
            fix=f"compare with version {newest.version}, then save what you still want",
        )
    if newest.toml == toml:
        return newest
    spec = add_version(session, access.project, actor.person, toml=toml, number=newest.version + 1, note=note)
    if read.sha256 != newest.sha256:
        publish(
            session,
            "spec.changed",
            studio_id=spec.studio_id,
            project_id=project_id,
            version=spec.version,
            person_id=actor.person,
        )
    return spec


def invitation_by_secret(session: Session, secret: str) -> ProjectInvitation:
    """Return the invitation behind a link, with its project, studio and inviter loaded.

    Raises InvitationNotFound for a link that is unknown, withdrawn or too old; an accepted one still shows the list.
    """
    with bypass_row_policies(session):  # only the secret identifies the invitation
        invitation = queries.invitation_by_secret(session, sha256_of(secret))
    if invitation is None:
        raise InvitationNotFound("this invitation is unknown, withdrawn or expired", fix="ask the studio for a new one")
    set_access_scope(session, AccessScope(project_id=invitation.project_id))
    return invitation
