"""Studios, their people and invitations, and the tokens of builds."""

from collections.abc import Collection, Sequence
from datetime import timedelta
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts import addresses, people, queries
from app.accounts.authentication import new_secret, sha256_of
from app.accounts.errors import (
    AlreadyMember,
    MemberNotFound,
    ProducerNeeded,
    SignUpNotFound,
    StudioInvitationNotFound,
    StudioNotFound,
    TooManyStudios,
)
from app.accounts.models import Membership, Person, SignUp, Studio, StudioInvitation, Token
from app.accounts.quotas import queries as quota_queries
from app.accounts.quotas.queries import people_in, tokens_of
from app.accounts.quotas.service import QuotaKind, ensure_quota
from app.accounts.rules import (
    MAX_TOKEN_DAYS,
    AccessKind,
    Actor,
    Role,
    Scope,
    ensure_address,
    ensure_producer_remains,
)
from app.core import clock
from app.core.db import bypass_row_policies
from app.core.events import publish
from app.core.plural import counted

INVITATION_LIFETIME = timedelta(days=30)
TOKEN_PREFIX = "slt_"  # noqa: S105  secret scanners find a leaked token by it


def sign_up(session: Session, *, email: str, name: str, password: str, studio_name: str | None = None) -> Person:
    """Make an account and the studio it produces for, named after the person until it gets a name of its own."""
    studio_name = studio_name or f"{name[:100]}’s studio"
    person = people.create_person(session, email=email, name=name, password=password, studio_name=studio_name)
    create_studio(session, studio_name, person)
    return person


def request_sign_up(session: Session, email: str) -> None:
    """Schedule a mail with a sign-up link, or a note that the address has an account; the job finds out which."""
    publish(session, "sign_up.asked", studio_id=None, recipient=ensure_address(email))


def sign_up_by_secret(session: Session, secret: str, *, lock: bool = False) -> SignUp:
    """Return the sign-up of a mailed link; raise SignUpNotFound when it is past use."""
    with bypass_row_policies(session):  # only the secret identifies the link
        begun = queries.open_sign_up(session, sha256_of(secret), lock=lock)
    if begun is None:
        raise SignUpNotFound("this link was used already or is older than a day", fix="sign up again for a new one")
    return begun


def finish_sign_up(session: Session, secret: str, *, name: str, password: str, studio_name: str | None) -> Person:
    """Make the account that a mailed link opens, its address verified by the link, with its studio."""
    begun = sign_up_by_secret(session, secret, lock=True)
    person = sign_up(session, email=begun.email, name=name, password=password, studio_name=studio_name)
    with bypass_row_policies(session):  # the row has no owner yet
        begun.used_at = clock.now()
        session.flush()
    addresses.verify(session, person, addresses.account_proof(begun))
    return person


def ensure_may_open_studio(session: Session, person: Person, maximum: int) -> None:
    """Raise TooManyStudios where a person has opened as many as one may: each has quotas of its own."""
    with bypass_row_policies(session):  # they may have left some
        opened = quota_queries.studios_opened_by(session, person.id)
    if opened >= maximum:
        raise TooManyStudios(
            f"you have opened {counted(opened, 'studio', 'studios')}, as many as one account may on this server",
            fix="ask its operator to raise SOUNDLIST_STUDIOS_PER_ACCOUNT",
        )


def create_studio(session: Session, name: str, person: Person, *, is_demo: bool = False) -> Studio:
    """Make a studio with its first producer."""
    studio = Studio(name=name, is_demo=is_demo, opened_by=person.id)
    with bypass_row_policies(session):  # the new studio has no members yet
        session.add(studio)
        session.flush()
        add_member(session, studio.id, person.id, [Role.PRODUCER])
    return studio


def rename_studio(session: Session, actor: Actor, studio_id: UUID, name: str) -> Studio:
    """Give a studio another name; signed contracts keep the one that they were signed under."""
    studio = ensure_producer_of(session, actor, studio_id)
    studio.name = name
    session.flush()
    return studio


def add_member(session: Session, studio_id: UUID, person_id: UUID, roles: Collection[Role]) -> Membership:
    """Give a person a place in a studio."""
    ensure_quota(session, studio_id, QuotaKind.PEOPLE, people_in)
    membership = Membership(studio_id=studio_id, person_id=person_id, roles=sorted(set(roles)))
    session.add(membership)
    session.flush()
    return membership


def ensure_member_of(actor: Actor, studio_id: UUID) -> None:
    """Raise StudioNotFound unless the caller belongs to the studio."""
    if not actor.roles_in(studio_id):
        raise StudioNotFound(f"no studio {studio_id}")


def ensure_producer_of(session: Session, actor: Actor, studio_id: UUID) -> Studio:
    """Return the studio, or raise StudioNotFound to strangers and ProducerNeeded to its other members."""
    ensure_member_of(actor, studio_id)
    if Role.PRODUCER not in actor.roles_in(studio_id):
        raise ProducerNeeded("only a producer of the studio can do this")
    return session.get_one(Studio, studio_id)


def people_of(session: Session, actor: Actor, studio_id: UUID) -> Sequence[Membership]:
    """Return the people of the caller's studio."""
    ensure_member_of(actor, studio_id)
    return queries.members(session, studio_id)


def change_roles(
    session: Session,
    actor: Actor,
    studio_id: UUID,
    person_id: UUID,
    roles: Collection[Role],
    *,
    hand_over_to: UUID | None = None,
) -> Membership:
    """Change a member's roles, and end what the new ones no longer allow.

    Raises LastProducer if no producer would be left, HandOverNeeded where another person must take over first.
    """
    membership = _membership_to_change(session, actor, studio_id, person_id, frozenset(roles))
    if Role.PRODUCER in roles and Role.PRODUCER not in membership.roles:
        publish(session, "producer.named", studio_id=studio_id, person_id=person_id)
    membership.roles = sorted(set(roles))
    _publish_change(session, actor, studio_id, person_id, membership.roles, hand_over_to, ())
    return membership


def remove_member(
    session: Session,
    actor: Actor,
    studio_id: UUID,
    person_id: UUID,
    *,
    hand_over_to: UUID | None = None,
    kept: Collection[AccessKind] = (),
) -> None:
    """End a membership with all that it gave; the person's account and what they did remain.

    Nothing is kept in the name of who leaves by themselves.
    Raises LastProducer if no producer would be left, HandOverNeeded where another person must take over first.
    """
    session.delete(_membership_to_change(session, actor, studio_id, person_id, frozenset()))
    _publish_change(session, actor, studio_id, person_id, [], hand_over_to, () if person_id == actor.person else kept)


def _publish_change(
    session: Session,
    actor: Actor,
    studio_id: UUID,
    person_id: UUID,
    roles: Sequence[str],
    hand_over_to: UUID | None,
    kept: Collection[AccessKind],
) -> None:
    """End the grants of the membership in each room, in this transaction."""
    session.flush()
    address = session.get_one(Person, person_id).email
    for invitation in queries.studio_invitations(session, studio_id):
        is_by_former_producer = invitation.invited_by == person_id and Role.PRODUCER not in roles
        if invitation.email == address or is_by_former_producer:
            invitation.revoked_at = clock.now()
    with bypass_row_policies(session):  # what ends is in projects too that the producer is not in
        if not roles and AccessKind.TOKENS in kept:
            queries.hand_tokens_over(session, studio_id, person_id, to=actor.person)
        elif not roles:
            queries.revoke_tokens(session, studio_id, person_id)
        publish(
            session,
            "member.changed",
            studio_id=studio_id,
            person_id=person_id,
            roles=[*roles],
            changed_by=actor.person,
            hand_over_to=hand_over_to,
            kept=sorted(kept),
        )


def _membership_to_change(
    session: Session, actor: Actor, studio_id: UUID, person_id: UUID, new_roles: frozenset[Role]
) -> Membership:
    ensure_producer_of(session, actor, studio_id)
    queries.studio_locked(session, studio_id)  # two producers leaving at once would leave none
    places = {member.person_id: member for member in queries.members(session, studio_id)}
    if person_id not in places:
        raise MemberNotFound(f"no person {person_id} in this studio")
    others = [frozenset(Role(role) for role in member.roles) for id_, member in places.items() if id_ != person_id]
    ensure_producer_remains(others, new_roles)
    return places[person_id]


def invite_member(
    session: Session,
    actor: Actor,
    studio_id: UUID,
    *,
    email: str,
    roles: Collection[Role],
    approves_project_id: UUID | None = None,
) -> StudioInvitation:
    """Mail a link into the studio; an earlier one to the same address loses its worth."""
    studio = ensure_producer_of(session, actor, studio_id)
    address = ensure_address(email)
    if queries.member_at_address(session, studio_id, address) is not None:
        raise AlreadyMember(
            f"{address} is already in this studio",
            errors=[{"where": "email", "message": "this person is already in the studio"}],
        )
    ensure_quota(session, studio_id, QuotaKind.PEOPLE, people_in)
    for earlier in queries.studio_invitations(session, studio_id):
        if earlier.email == address:
            earlier.revoked_at = clock.now()
    inviter = session.get_one(Person, actor.person)
    invitation = StudioInvitation(
        studio_id=studio_id,
        email=address,
        roles=sorted(set(roles)),
        approves_project_id=approves_project_id,
        inviter=inviter,
        expires_at=clock.now() + INVITATION_LIFETIME,
    )
    session.add(invitation)
    session.flush()
    publish(
        session,
        "member.invited",
        studio_id=studio_id,
        recipient=address,
        link_id=invitation.id,
        subject_name=studio.name,
        from_name=inviter.name,
    )
    return invitation


def open_invitations(session: Session, actor: Actor, studio_id: UUID) -> Sequence[StudioInvitation]:
    """Return the studio's invitations that wait for an answer."""
    ensure_producer_of(session, actor, studio_id)
    return queries.studio_invitations(session, studio_id)


def revoke_studio_invitation(session: Session, actor: Actor, studio_id: UUID, invitation_id: UUID) -> None:
    """Revoke an invitation's link."""
    for invitation in open_invitations(session, actor, studio_id):
        if invitation.id == invitation_id:
            invitation.revoked_at = clock.now()
            return
    raise StudioInvitationNotFound(f"no open invitation {invitation_id}")


def studio_invitation_by_secret(session: Session, secret: str) -> StudioInvitation:
    """Return the invitation behind a link, with its studio; raise StudioInvitationNotFound when it is past use."""
    with bypass_row_policies(session):  # only the secret identifies the invitation
        invitation = queries.studio_invitation_by_secret(session, sha256_of(secret))
    if invitation is None:
        raise StudioInvitationNotFound(
            "this invitation is unknown, used, withdrawn or expired", fix="ask the studio for a new one"
        )
    return invitation


def accept_studio_invitation(
    session: Session, actor: Actor, secret: str, *, name: str | None = None, password: str | None = None
) -> tuple[Person, Studio]:
    """Join the studio that a link invites to, with the account of its address, made now if there is none."""
    invitation = studio_invitation_by_secret(session, secret)
    person = people.person_by_link(
        session, actor, invitation.email, invitation, name=name, password=password, studio_name=invitation.studio.name
    )
    with bypass_row_policies(session):  # the joining person cannot see the studio yet
        invitation.accepted_at = clock.now()
        invitation.accepted_by = person.id
        roles = {Role(role) for role in invitation.roles}
        membership = queries.membership(session, invitation.studio_id, person.id)
        if Role.PRODUCER in roles and (membership is None or Role.PRODUCER not in membership.roles):
            publish(session, "producer.named", studio_id=invitation.studio_id, person_id=person.id)
        if membership is None:
            add_member(session, invitation.studio_id, person.id, roles)
        else:
            roles |= {Role(role) for role in membership.roles}
            membership.roles = sorted(roles)
        publish(session, "member.joined", studio_id=invitation.studio_id, person_id=person.id, roles=sorted(roles))
        if invitation.approves_project_id is not None:
            publish(
                session,
                "approver.joined",
                studio_id=invitation.studio_id,
                project_id=invitation.approves_project_id,
                person_id=person.id,
                invited_by=invitation.invited_by,
            )
    return person, invitation.studio


def add_token(
    session: Session,
    *,
    studio_id: UUID,
    project_id: UUID,
    created_by: UUID,
    name: str,
    scopes: Collection[Scope],
    days: int = MAX_TOKEN_DAYS,
) -> tuple[Token, str]:
    """Make a key for a project's builds that ends after so many days, and return it with its secret, kept nowhere."""
    ensure_quota(session, studio_id, QuotaKind.TOKENS, tokens_of)
    secret = TOKEN_PREFIX + new_secret()
    token = Token(
        studio_id=studio_id,
        project_id=project_id,
        name=name,
        secret_sha256=sha256_of(secret),
        scopes=sorted(set(scopes)),
        creator=session.get_one(Person, created_by),
        expires_at=clock.now() + timedelta(days=days),
    )
    session.add(token)
    session.flush()
    publish(session, "token.made", studio_id=studio_id, token_id=token.id)
    return token, secret
