"""Designers: invited by a mailed link, engaged by accepting it, and let go."""

from collections.abc import Sequence
from datetime import datetime, timedelta
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.people import person_by_link
from app.accounts.rules import Actor, ensure_address
from app.core import clock
from app.core.db import bypass_row_policies
from app.core.events import publish
from app.projects import queries
from app.projects.errors import AlreadyEngaged, EngagementNotFound, InvitationNotFound
from app.projects.models import Engagement, ProjectInvitation
from app.projects.rules import EngagementKind
from app.projects.service import invitation_by_secret, project_access

INVITATION_LIFETIME = timedelta(days=30)


def invite_designer(
    session: Session,
    actor: Actor,
    project_id: UUID,
    *,
    email: str,
    kind: EngagementKind,
    note: str = "",
) -> ProjectInvitation:
    """Mail a designer a link that shows the list; an earlier one to the same address loses its worth."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    address = ensure_address(email)
    if queries.is_engaged_address(session, project_id, address):
        message = "this designer is already engaged on the project"
        raise AlreadyEngaged(message, errors=[{"where": "email", "message": message}])
    for earlier in queries.invitations(session, project_id):
        if earlier.email == address:
            earlier.revoked_at = clock.now()
    inviter = session.get_one(Person, actor.person)
    invitation = ProjectInvitation(
        studio_id=access.project.studio_id,
        project=access.project,
        email=address,
        kind=kind,
        note=note,
        inviter=inviter,
        expires_at=clock.now() + INVITATION_LIFETIME,
    )
    session.add(invitation)
    session.flush()
    publish(
        session,
        "designer.invited",
        studio_id=invitation.studio_id,
        project_id=project_id,
        recipient=address,
        link_id=invitation.id,
        kind=kind.value,
        subject_name=access.project.name,
        from_name=inviter.name,
        note=note,
    )
    return invitation


def invitations_of(session: Session, actor: Actor, project_id: UUID) -> Sequence[ProjectInvitation]:
    """Return the project's invitations, but for those withdrawn."""
    project_access(session, actor, project_id).ensure_may_speak()
    return queries.invitations(session, project_id)


def revoke_invitation(session: Session, actor: Actor, project_id: UUID, invitation_id: UUID) -> None:
    """Revoke an invitation's link; an engagement made by it remains."""
    for invitation in invitations_of(session, actor, project_id):
        if invitation.id == invitation_id:
            invitation.revoked_at = clock.now()
            return
    raise InvitationNotFound(f"no invitation {invitation_id} in this project")


def accept_invitation(
    session: Session, actor: Actor, secret: str, *, name: str | None = None, password: str | None = None
) -> Engagement:
    """Engage the designer whom a link invites, with the account of its address, made now if there is none.

    Raises InvitationNotFound, or SignInNeeded when the address has an account and the caller is not its holder.
    Accepting again is accepting once.
    """
    invitation = invitation_by_secret(session, secret)
    designer = person_by_link(session, actor, invitation.email, invitation, name=name, password=password)
    with bypass_row_policies(session):  # the designer being engaged cannot see the project yet
        engagement = queries.any_engagement_of(session, invitation.project_id, designer.id)
        if invitation.accepted_at is not None and engagement is not None:
            return engagement
        invitation.accepted_at = clock.now()
        invitation.accepted_by = designer.id
        return engage(
            session,
            studio_id=invitation.studio_id,
            project_id=invitation.project_id,
            designer=designer,
            kind=invitation.kind,
        )


def engage(
    session: Session, *, studio_id: UUID, project_id: UUID, designer: Person, kind: EngagementKind
) -> Engagement:
    """Engage a designer on a project, or take an engagement up again; callers have checked that they may."""
    engagement = queries.any_engagement_of(session, project_id, designer.id)
    if engagement is None:
        engagement = Engagement(studio_id=studio_id, project_id=project_id, designer=designer, kind=kind)
        session.add(engagement)
    else:
        _set_kind(engagement, kind)
        engagement.ended_at = None
    session.flush()
    publish(session, "designer.joined", studio_id=engagement.studio_id, engagement_id=engagement.id)
    return engagement


def _set_kind(engagement: Engagement, kind: EngagementKind) -> None:
    if engagement.kind is not kind:
        engagement.kind, engagement.kind_since = kind, clock.now()


def change_engagement(
    session: Session,
    actor: Actor,
    project_id: UUID,
    engagement_id: UUID,
    *,
    kind: EngagementKind | None = None,
    ended: bool | None = None,
) -> Engagement:
    """Change a designer's tie, end it or take it up again; what is None stays. The designer's work remains."""
    project_access(session, actor, project_id).ensure_producer()
    engagement = queries.engagement_by_id(session, project_id, engagement_id)
    if engagement is None:
        raise EngagementNotFound(f"no engagement {engagement_id} in this project")
    _set_kind(engagement, kind or engagement.kind)
    if ended is not None and ended != (engagement.ended_at is not None):
        engagement.ended_at = clock.now() if ended else None
    if engagement.ended_at is not None:
        for invitation in queries.invitations(session, project_id):
            if engagement.designer_id == invitation.accepted_by or engagement.designer.email == invitation.email:
                invitation.revoked_at = clock.now()  # the link would show the list, and engage again
    session.flush()
    return engagement


def record_nda(session: Session, engagement_id: UUID, *, document_sha256: str, at: datetime) -> None:
    """Keep that a designer accepted an NDA, and which: from now on the project shows them brief, list and spec."""
    engagement = session.get_one(Engagement, engagement_id)
    engagement.nda_sha256, engagement.nda_accepted_at = document_sha256, at
    session.flush()
