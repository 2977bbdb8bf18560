"""The endpoints of a studio: its people, and who is invited into it."""

from collections.abc import Sequence
from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Query, Request, Response

from app.accounts import queries, service
from app.accounts.authentication import sha256_of
from app.accounts.errors import (
    AlreadyMember,
    BadAddress,
    CannotTakeOver,
    HandOverNeeded,
    LastProducer,
    MemberNotFound,
    NameNeeded,
    NotInDemo,
    PasswordTooWeak,
    ProducerNeeded,
    RecentSignInNeeded,
    SignInNeeded,
    StudioInvitationNotFound,
    StudioNotFound,
    TooManyAttempts,
    TooManyStudios,
)
from app.accounts.models import Membership, Person, Studio, StudioInvitation
from app.accounts.rules import AccessKind, Actor, Audience, Role
from app.accounts.schemas import (
    InvitationAccept,
    JoinedStudio,
    MemberRead,
    PersonBrief,
    PersonRead,
    RolesChange,
    StudioAdd,
    StudioBrief,
    StudioChange,
    StudioInvitationAdd,
    StudioInvitationRead,
    StudioInvitationShown,
)
from app.accounts.web.browser_sign_ins import sign_in_browser
from app.accounts.web.policies import allows, ensure_recent_sign_in
from app.accounts.web.request_limits import (
    DeferredSession,
    ensure_invitation_allowed,
    ensure_sign_in_allowed,
)
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.core.web.idempotency import UNSAVED

router = APIRouter(prefix="/v1", tags=["accounts"])
_unsaved_router = APIRouter(dependencies=UNSAVED)


@router.post("/studios", status_code=201, response_model=StudioBrief, responses=problems(NotInDemo, TooManyStudios))
def create_studio(
    body: StudioAdd, session: DbSession, runtime: CurrentRuntime, actor: Actor = allows(Audience.PERSON)
) -> Studio:
    """Open a further studio, with the caller as its producer."""
    person = session.get_one(Person, actor.person)
    if person.demo_part is not None:
        raise NotInDemo("the people of the demo have the demo's studio only")
    service.ensure_may_open_studio(session, person, runtime.settings.studios_per_account)
    return service.create_studio(session, body.name, person)


@router.put("/studios/{studio_id}", response_model=StudioBrief, responses=problems(StudioNotFound, ProducerNeeded))
def rename_studio(
    studio_id: UUID, body: StudioChange, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> Studio:
    """Give the studio another name."""
    return service.rename_studio(session, actor, studio_id, body.name)


def _member(membership: Membership) -> MemberRead:
    return MemberRead.model_validate(
        {
            "person": PersonBrief.model_validate(membership.person),
            "email": membership.person.email,
            "roles": membership.roles,
            "since": membership.created_at,
        }
    )


@router.get("/studios/{studio_id}/people", responses=problems(StudioNotFound))
def list_people(studio_id: UUID, session: DbSession, actor: Actor = allows(Audience.STUDIO)) -> list[MemberRead]:
    """Return the people of the studio."""
    return [_member(membership) for membership in service.people_of(session, actor, studio_id)]


@router.put(
    "/studios/{studio_id}/people/{person_id}",
    responses=problems(
        StudioNotFound,
        MemberNotFound,
        ProducerNeeded,
        RecentSignInNeeded,
        LastProducer,
        HandOverNeeded,
        CannotTakeOver,
    ),
)
def change_member_roles(
    studio_id: UUID,
    person_id: UUID,
    body: RolesChange,
    request: Request,
    session: DbSession,
    actor: Actor = allows(Audience.PRODUCER),
) -> MemberRead:
    """Change a member's roles in the studio, and end what the new ones no longer allow; it always keeps a producer."""
    if Role.PRODUCER in body.roles:
        ensure_recent_sign_in(request)
    return _member(
        service.change_roles(session, actor, studio_id, person_id, body.roles, hand_over_to=body.hand_over_to)
    )


@router.delete(
    "/studios/{studio_id}/people/{person_id}",
    status_code=204,
    responses=problems(StudioNotFound, MemberNotFound, ProducerNeeded, LastProducer, HandOverNeeded, CannotTakeOver),
)
def remove_member(
    studio_id: UUID,
    person_id: UUID,
    session: DbSession,
    keep: Annotated[
        list[AccessKind],
        Query(
            default_factory=list,
            description="Access made by the member that the caller takes over, or a producer in its project where the "
            "caller is not; the rest is revoked or disabled.",
        ),
    ],
    hand_over_to: Annotated[
        UUID | None, Query(description="Who becomes the approver of the projects that the member approves.")
    ] = None,
    actor: Actor = allows(Audience.PRODUCER),
) -> None:
    """Remove a member from the studio, and end all that the membership gave; the studio always keeps a producer."""
    service.remove_member(session, actor, studio_id, person_id, hand_over_to=hand_over_to, kept=keep)


@router.post(
    "/studios/{studio_id}/invitations",
    status_code=201,
    response_model=StudioInvitationRead,
    responses=problems(StudioNotFound, ProducerNeeded, RecentSignInNeeded, AlreadyMember, BadAddress, TooManyAttempts),
)
def invite_member(
    studio_id: UUID,
    body: StudioInvitationAdd,
    request: Request,
    session: DbSession,
    actor: Actor = allows(Audience.PRODUCER),
) -> StudioInvitation:
    """Mail an invitation to the studio; the answer does not reveal whether the address has an account."""
    if Role.PRODUCER in body.roles:
        ensure_recent_sign_in(request)
    service.ensure_producer_of(session, actor, studio_id)
    ensure_invitation_allowed(session, actor, body.email)
    return service.invite_member(session, actor, studio_id, email=body.email, roles=body.roles)


@router.get(
    "/studios/{studio_id}/invitations",
    response_model=list[StudioInvitationRead],
    responses=problems(StudioNotFound, ProducerNeeded),
)
def list_studio_invitations(
    studio_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> Sequence[StudioInvitation]:
    """Return the invitations that wait for an answer."""
    return service.open_invitations(session, actor, studio_id)


@router.delete(
    "/studios/{studio_id}/invitations/{studio_invitation_id}",
    status_code=204,
    responses=problems(StudioNotFound, ProducerNeeded, StudioInvitationNotFound),
)
def revoke_studio_invitation(
    studio_id: UUID, studio_invitation_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> None:
    """Withdraw an invitation into the studio."""
    service.revoke_studio_invitation(session, actor, studio_id, studio_invitation_id)


@router.get("/studio-invitations/{secret}", responses=problems(StudioInvitationNotFound))
def read_studio_invitation(
    secret: str, session: DbSession, _actor: Actor = allows(Audience.ANYONE)
) -> StudioInvitationShown:
    """Show the holder of a link what they are invited to."""
    invitation = service.studio_invitation_by_secret(session, secret)
    return StudioInvitationShown.model_validate(
        {
            "studio_name": invitation.studio.name,
            "email": invitation.email,
            "roles": invitation.roles,
            "invited_by_name": invitation.inviter.name,
            "has_account": queries.has_account(session, invitation.email),
            "expires_at": invitation.expires_at,
        }
    )


@_unsaved_router.post(
    "/studio-invitations/{secret}/accept",
    responses=problems(StudioInvitationNotFound, SignInNeeded, NameNeeded, PasswordTooWeak, TooManyAttempts),
)
def accept_studio_invitation(
    secret: str,
    body: InvitationAccept,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    begin: DeferredSession,
    actor: Actor = allows(Audience.ANYONE),
) -> JoinedStudio:
    """Join the studio with the invited address's account, made now if there is none, and sign in."""
    ensure_sign_in_allowed(request, sha256_of(secret))
    with begin() as session:
        person, studio = service.accept_studio_invitation(
            session, actor, secret, name=body.name, password=body.password
        )
        if actor.person_id != person.id:
            sign_in_browser(session, runtime.settings, request, response, person)
    return JoinedStudio(person=PersonRead.model_validate(person), studio=StudioBrief.model_validate(studio))


router.include_router(_unsaved_router)
