"""Queries for people, studios, memberships and sessions."""

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from datetime import datetime, timedelta
from typing import Any
from uuid import UUID

from sqlalchemy import ColumnElement, bindparam, delete, null, or_, select, update
from sqlalchemy.orm import Session, joinedload

from app.accounts.models import (
    DeskToken,
    EmailVerification,
    Holiday,
    InvoiceDetails,
    Membership,
    Operator,
    PasswordReset,
    Person,
    PersonPicture,
    SignIn,
    SignUp,
    Studio,
    StudioInvitation,
    Token,
)
from app.accounts.rules import Actor, MembersSee, Role, Scope, SecondFactorUse
from app.accounts.second_factors.queries import second_factor_exists
from app.core import clock
from app.core.db import Database, UtcDateTime

TOKEN_USE_RECORDED_EVERY = timedelta(minutes=1)
SEEN_RECORDED_EVERY = timedelta(minutes=10)
IDLE_FOR = timedelta(days=14)  # a browser unused for so long is signed out


def actor_for_person(session: Session, person_id: UUID) -> Actor:
    """Return a person with the roles held in each studio."""
    held = select(Membership.studio_id, Membership.roles, Studio.members_see).join(Membership.studio)
    rows = session.execute(held.where(Membership.person_id == person_id)).all()
    return Actor(person_id=person_id, roles=_roles(rows), limited_studio_ids=_limited(rows))


def _roles(rows: Iterable[Any]) -> dict[UUID, frozenset[Role]]:
    return {row.studio_id: frozenset(map(Role, row.roles)) for row in rows if row.studio_id is not None}


def _limited(rows: Iterable[Any]) -> frozenset[UUID]:
    return frozenset(row.studio_id for row in rows if row.members_see is MembersSee.OWN)


# Built once: every request of a browser asks for it.
_SIGNED_IN = (
    select(
        SignIn.id,
        SignIn.person_id,
        SignIn.created_at,
        SignIn.last_seen_at,
        SignIn.second_factor_studio_id,
        Membership.studio_id,
        Membership.roles,
        Studio.second_factor_for,
        Studio.members_see,
        second_factor_exists(SignIn.person_id).label("has_second_factor"),
    )
    .join(Membership, Membership.person_id == SignIn.person_id, isouter=True)
    .join(Studio, Studio.id == Membership.studio_id, isouter=True)
    .where(
        SignIn.secret_sha256 == bindparam("secret_sha256"),
        SignIn.expires_at > bindparam("now", type_=UtcDateTime()),
        SignIn.last_seen_at > bindparam("idle_since", type_=UtcDateTime()),
    )
)


@dataclass(frozen=True)
class SignedIn:
    """The holder of a session cookie."""

    actor: Actor
    unrecorded_id: UUID | None  # of the sign-in, where its use is to be noted (`record_seen`)
    signed_in_at: datetime
    lacks_second_factor: bool  # which one of their studios requires of every member


def actor_for_sign_in(database: Database, secret_sha256: str) -> SignedIn | None:
    """Return the sign-in of a session cookie with its person; None when it is unknown or over."""
    now = clock.now()
    values = {"secret_sha256": secret_sha256, "now": now, "idle_since": now - IDLE_FOR}
    rows = database.read_autocommit(_SIGNED_IN, values)
    if not rows:
        return None
    first = rows[0]
    vouching = first.second_factor_studio_id
    is_required = any(
        SecondFactorUse.EVERYTHING in (row.second_factor_for or ()) for row in rows if row.studio_id != vouching
    )
    return SignedIn(
        Actor(
            person_id=first.person_id,
            roles=_roles(rows),
            second_factor_studio_id=vouching,
            limited_studio_ids=_limited(rows),
        ),
        first.id if first.last_seen_at < now - SEEN_RECORDED_EVERY else None,
        first.created_at,
        lacks_second_factor=is_required and not first.has_second_factor,
    )


def record_seen(session: Session, sign_in_id: UUID) -> None:
    """Record the time of a browser's last use."""
    session.execute(update(SignIn).where(SignIn.id == sign_in_id).values(last_seen_at=clock.now()))


_TOKEN = select(Token.id, Token.studio_id, Token.project_id, Token.scopes).where(
    Token.secret_sha256 == bindparam("secret_sha256"),
    Token.revoked_at.is_(None),
    Token.expires_at > bindparam("now", type_=UtcDateTime()),
)
_TOKENS_PAST_USE = (
    select(Token.revoked_at, Token.expires_at).where(Token.secret_sha256 == bindparam("secret_sha256")),
    select(null().label("revoked_at"), DeskToken.expires_at).where(
        DeskToken.secret_sha256 == bindparam("secret_sha256")
    ),
)


def actor_for_token(database: Database, secret_sha256: str) -> Actor | None:
    """Return the build that holds this token, None when it is unknown, revoked or over."""
    for token in database.read_autocommit(_TOKEN, {"secret_sha256": secret_sha256, "now": clock.now()}):
        return Actor(
            token_id=token.id,
            token_studio_id=token.studio_id,
            token_project_id=token.project_id,
            scopes=frozenset(map(Scope, token.scopes)),
        )
    return None


def token_past_use(database: Database, secret_sha256: str) -> tuple[datetime | None, datetime] | None:
    """Return the times of revocation and of the end of a token that is refused; None for an unknown one."""
    for statement in _TOKENS_PAST_USE:
        for token in database.read_autocommit(statement, {"secret_sha256": secret_sha256}):
            return token.revoked_at, token.expires_at
    return None


_DESK_TOKEN = (
    select(DeskToken.id, DeskToken.person_id, Membership.studio_id, Membership.roles, Studio.members_see)
    .join(Membership, Membership.person_id == DeskToken.person_id, isouter=True)
    .join(Studio, Studio.id == Membership.studio_id, isouter=True)
    .where(
        DeskToken.secret_sha256 == bindparam("secret_sha256"),
        DeskToken.expires_at > bindparam("now", type_=UtcDateTime()),
    )
)


def actor_for_desk_token(database: Database, secret_sha256: str) -> tuple[Actor, UUID] | None:
    """Return the holder of this desk token, and its id; None when it is unknown, revoked or over."""
    rows = database.read_autocommit(_DESK_TOKEN, {"secret_sha256": secret_sha256, "now": clock.now()})
    if not rows:
        return None
    actor = Actor(person_id=rows[0].person_id, roles=_roles(rows), limited_studio_ids=_limited(rows))
    return actor, rows[0].id


def record_desk_token_use(session: Session, desk_token_id: UUID) -> None:
    """Record the time of a desk token's last use, to the minute."""
    now = clock.now()
    is_old = DeskToken.last_used_at.is_(None) | (DeskToken.last_used_at < now - TOKEN_USE_RECORDED_EVERY)
    session.execute(update(DeskToken).where(DeskToken.id == desk_token_id, is_old).values(last_used_at=now))


def desk_tokens(session: Session, person_id: UUID) -> Sequence[DeskToken]:
    """Return a person's desk tokens that are not over, newest first."""
    query = select(DeskToken).where(DeskToken.person_id == person_id, DeskToken.expires_at > clock.now())
    return session.scalars(query.order_by(DeskToken.id.desc())).all()


def actor_for_demo_part(session: Session, part: str) -> Actor | None:
    """Return the demo's person who plays this part, with no more than their roles in demo studios."""
    person_id = session.scalar(select(Person.id).where(Person.demo_part == part))
    if person_id is None:
        return None
    actor = actor_for_person(session, person_id)
    demo_ids = set(session.scalars(select(Studio.id).where(Studio.id.in_(actor.roles), Studio.is_demo)))
    return replace(actor, roles={id_: roles for id_, roles in actor.roles.items() if id_ in demo_ids})


def record_token_use(session: Session, token_id: UUID) -> None:
    """Record the time of a token's last use, to the minute."""
    now = clock.now()
    is_old = Token.last_used_at.is_(None) | (Token.last_used_at < now - TOKEN_USE_RECORDED_EVERY)
    session.execute(update(Token).where(Token.id == token_id, is_old).values(last_used_at=now))


def people_by_id(session: Session, ids: set[UUID]) -> dict[UUID, Person]:
    """Return people by their ids."""
    return {person.id: person for person in session.scalars(select(Person).where(Person.id.in_(ids)))}


def person_by_email(session: Session, email: str) -> Person | None:
    """Return the person with this normalised address."""
    return session.scalar(select(Person).where(Person.email == email))


def picture_of(session: Session, person_id: UUID) -> PersonPicture | None:
    """Return the picture of a person; callers have checked who sees it."""
    return session.get(PersonPicture, person_id)


def has_account(session: Session, email: str) -> bool:
    """Whether a normalised address has an account."""
    return session.scalar(select(Person.id).where(Person.email == email)) is not None


def end_sign_ins(session: Session, person_id: UUID, *, except_sha256: str | None = None) -> None:
    """End every sign-in of a person, but for the one given."""
    ended = delete(SignIn).where(SignIn.person_id == person_id)
    session.execute(ended.where(SignIn.secret_sha256 != except_sha256) if except_sha256 else ended)


def end_desk_tokens(session: Session, person_id: UUID) -> None:
    """End every desk token of a person."""
    session.execute(delete(DeskToken).where(DeskToken.person_id == person_id))


def end_sign_in(session: Session, secret_sha256: str) -> None:
    """End one sign-in."""
    session.execute(delete(SignIn).where(SignIn.secret_sha256 == secret_sha256))


def open_sign_ins(session: Session, person_id: UUID) -> Sequence[SignIn]:
    """Return a person's sign-ins that are not over, the one used last first."""
    now = clock.now()
    return session.scalars(
        select(SignIn)
        .where(SignIn.person_id == person_id, SignIn.expires_at > now, SignIn.last_seen_at > now - IDLE_FOR)
        .order_by(SignIn.last_seen_at.desc(), SignIn.id.desc())
    ).all()


def drop_old_sign_ins(session: Session, person_id: UUID) -> None:
    """Forget a person's sign-ins that are over."""
    now = clock.now()
    is_over = or_(SignIn.expires_at <= now, SignIn.last_seen_at <= now - IDLE_FOR)
    session.execute(delete(SignIn).where(SignIn.person_id == person_id, is_over))


def has_people(session: Session) -> bool:
    """Whether there is any account, the people of the demo aside."""
    return session.scalar(select(Person.id).where(Person.demo_part.is_(None)).limit(1)) is not None


def open_verification(session: Session, secret_sha256: str, person_id: UUID) -> EmailVerification | None:
    """Return a person's own verification behind a link that is still good."""
    return session.scalar(
        select(EmailVerification)
        .where(
            EmailVerification.secret_sha256 == secret_sha256,
            EmailVerification.person_id == person_id,
            EmailVerification.used_at.is_(None),
            EmailVerification.expires_at > clock.now(),
        )
        .with_for_update()
    )


def drop_verifications(session: Session, person_id: UUID) -> None:
    """Revoke a person's unused verification links."""
    unused = EmailVerification.used_at.is_(None)
    session.execute(delete(EmailVerification).where(EmailVerification.person_id == person_id, unused))


def open_sign_up(session: Session, secret_sha256: str, *, lock: bool = False) -> SignUp | None:
    """Return the sign-up behind a link that is still good; `lock` it where the link is about to be used."""
    query = select(SignUp).where(
        SignUp.secret_sha256 == secret_sha256, SignUp.used_at.is_(None), SignUp.expires_at > clock.now()
    )
    return session.scalar(query.with_for_update() if lock else query)


def drop_sign_ups(session: Session, email: str) -> None:
    """Revoke an address's unused sign-up links, and delete expired ones."""
    session.execute(delete(SignUp).where(or_(SignUp.email == email, SignUp.expires_at <= clock.now())))


def operators(session: Session) -> Sequence[Operator]:
    """Return the operators, in the order of naming."""
    return session.scalars(
        select(Operator).options(joinedload(Operator.person)).order_by(Operator.named_at, Operator.person_id)
    ).all()


def is_operator(session: Session, person_id: UUID) -> bool:
    """Return whether a person is an operator."""
    return session.scalar(select(Operator.person_id).where(Operator.person_id == person_id)) is not None


def open_reset(session: Session, secret_sha256: str) -> PasswordReset | None:
    """Return the reset behind a link that is still good."""
    return session.scalar(
        select(PasswordReset)
        .where(
            PasswordReset.secret_sha256 == secret_sha256,
            PasswordReset.used_at.is_(None),
            PasswordReset.expires_at > clock.now(),
        )
        .with_for_update()
    )


def drop_resets(session: Session, person_id: UUID) -> None:
    """Revoke a person's unused reset links."""
    session.execute(delete(PasswordReset).where(PasswordReset.person_id == person_id, PasswordReset.used_at.is_(None)))


def names_of_studios(session: Session, person_id: UUID) -> Sequence[str]:
    """Return the names of the studios that a person belongs to."""
    return session.scalars(
        select(Studio.name).join(Membership, Membership.studio_id == Studio.id).where(Membership.person_id == person_id)
    ).all()


def studio_locked(session: Session, studio_id: UUID) -> Studio | None:
    """Return a studio, locked until this transaction ends."""
    return session.scalar(select(Studio).where(Studio.id == studio_id).with_for_update(key_share=True))


def members(session: Session, studio_id: UUID) -> Sequence[Membership]:
    """Return the people of a studio with their roles, in order of joining."""
    return session.scalars(
        select(Membership)
        .where(Membership.studio_id == studio_id)
        .options(joinedload(Membership.person))
        .order_by(Membership.created_at, Membership.person_id)
    ).all()


def membership(session: Session, studio_id: UUID, person_id: UUID) -> Membership | None:
    """Return a person's place in a studio."""
    return session.scalar(
        select(Membership)
        .where(Membership.studio_id == studio_id, Membership.person_id == person_id)
        .options(joinedload(Membership.person))
    )


def member_at_address(session: Session, studio_id: UUID, email: str) -> UUID | None:
    """Return the member of the studio to whom a normalised address belongs."""
    query = select(Membership.person_id).join(Membership.person)
    return session.scalar(query.where(Membership.studio_id == studio_id, Person.email == email))


def studio_invitations(session: Session, studio_id: UUID) -> Sequence[StudioInvitation]:
    """Return the invitations into a studio that were neither accepted nor revoked, newest first."""
    return session.scalars(
        select(StudioInvitation)
        .where(
            StudioInvitation.studio_id == studio_id,
            StudioInvitation.accepted_at.is_(None),
            StudioInvitation.revoked_at.is_(None),
        )
        .options(joinedload(StudioInvitation.inviter))
        .order_by(StudioInvitation.id.desc())
    ).all()


def studio_invitation_by_secret(session: Session, secret_sha256: str) -> StudioInvitation | None:
    """Return the invitation behind a link, with its studio, while it can be accepted."""
    return session.scalar(
        select(StudioInvitation)
        .where(
            StudioInvitation.secret_sha256 == secret_sha256,
            StudioInvitation.accepted_at.is_(None),
            StudioInvitation.revoked_at.is_(None),
            StudioInvitation.expires_at > clock.now(),
        )
        .options(joinedload(StudioInvitation.studio), joinedload(StudioInvitation.inviter))
    )


def project_tokens(session: Session, project_id: UUID) -> Sequence[Token]:
    """Return the tokens of a project, revoked ones too, newest first."""
    return session.scalars(
        select(Token).where(Token.project_id == project_id).options(joinedload(Token.creator)).order_by(Token.id.desc())
    ).all()


def project_token(session: Session, project_id: UUID, token_id: UUID) -> Token | None:
    """Return one token of a project."""
    return session.scalar(
        select(Token).where(Token.id == token_id, Token.project_id == project_id).options(joinedload(Token.creator))
    )


def tokens_that_end_before(session: Session, before: datetime, now: datetime) -> Sequence[Token | DeskToken]:
    """Return the tokens of builds and desks that end soon and whose end was not announced, locked."""
    of_builds = select(Token).where(Token.revoked_at.is_(None), *_ends_unannounced(Token, before, now))
    of_desks = select(DeskToken).where(*_ends_unannounced(DeskToken, before, now))
    return [*session.scalars(of_builds.with_for_update()), *session.scalars(of_desks.with_for_update())]


def _ends_unannounced(
    table: type[Token] | type[DeskToken], before: datetime, now: datetime
) -> tuple[ColumnElement[bool], ...]:
    return table.expires_at > now, table.expires_at <= before, table.warned_at.is_(None)


def live_tokens_of(session: Session, studio_id: UUID, person_id: UUID) -> Sequence[Token]:
    """Return the tokens that a person made in a studio and that work still, the oldest first."""
    return session.scalars(select(Token).where(*_live_tokens(studio_id, person_id)).order_by(Token.id)).all()


def revoke_tokens(session: Session, studio_id: UUID, person_id: UUID) -> None:
    """Revoke the tokens that a person made in a studio."""
    session.execute(update(Token).where(*_live_tokens(studio_id, person_id)).values(revoked_at=clock.now()))


def hand_tokens_over(session: Session, studio_id: UUID, person_id: UUID, *, to: UUID) -> None:
    """Keep the tokens that a person made in a studio, in another person's name."""
    session.execute(update(Token).where(*_live_tokens(studio_id, person_id)).values(created_by=to))


def _live_tokens(studio_id: UUID, person_id: UUID) -> tuple[ColumnElement[bool], ...]:
    works = Token.revoked_at.is_(None), Token.expires_at > clock.now()
    return Token.studio_id == studio_id, Token.created_by == person_id, *works


def holidays_of(session: Session, studio_ids: Collection[UUID]) -> Sequence[Holiday]:
    """Return the holidays of studios, in order."""
    return session.scalars(
        select(Holiday).where(Holiday.studio_id.in_(studio_ids)).order_by(Holiday.day, Holiday.studio_id)
    ).all()


def time_zones_of(session: Session, studio_ids: Collection[UUID]) -> dict[UUID, str]:
    """Return the time zone of each studio."""
    return dict(session.execute(select(Studio.id, Studio.time_zone).where(Studio.id.in_(studio_ids))).all())


def invoice_details_of(
    session: Session, *, person_id: UUID | None = None, studio_id: UUID | None = None
) -> Sequence[InvoiceDetails]:
    """Return every saved state of a person's or a studio's invoice details, the oldest first."""
    owner = InvoiceDetails.person_id == person_id if person_id else InvoiceDetails.studio_id == studio_id
    return session.scalars(select(InvoiceDetails).where(owner).order_by(InvoiceDetails.id)).all()
