"""Who is who, read from the database."""

from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.accounts.models import Membership, Person, SignIn, Studio, Token
from app.accounts.rules import Actor, Role, Scope
from app.kit import clock


def actor_for_person(session: Session, person_id: UUID) -> Actor:
    """Return a person with the roles held in each studio."""
    rows = session.execute(
        select(Membership.studio_id, Membership.roles).where(Membership.person_id == person_id)
    ).tuples()
    return Actor(person_id=person_id, roles={studio: frozenset(Role(role) for role in roles) for studio, roles in rows})


def actor_for_sign_in(session: Session, secret_sha256: str) -> Actor | None:
    """Return who holds this session cookie, None when it is unknown or over."""
    person_id = session.scalar(
        select(SignIn.person_id).where(SignIn.secret_sha256 == secret_sha256, SignIn.expires_at > clock.now())
    )
    return actor_for_person(session, person_id) if person_id else None


def actor_for_token(session: Session, secret_sha256: str) -> Actor | None:
    """Return the build that holds this token, None when it is unknown or revoked."""
    token = session.scalar(select(Token).where(Token.secret_sha256 == secret_sha256, Token.revoked_at.is_(None)))
    if token is None:
        return None
    return Actor(
        token_id=token.id,
        token_studio_id=token.studio_id,
        token_project_id=token.project_id,
        scopes=frozenset(Scope(scope) for scope in token.scopes),
    )


def actor_for_demo_part(session: Session, part: str) -> Actor | None:
    """Return the demo studio's person who plays this part."""
    person_id = session.scalar(
        select(Person.id)
        .join(Membership, Membership.person_id == Person.id, isouter=True)
        .join(Studio, Studio.id == Membership.studio_id, isouter=True)
        .where(Person.demo_part == part)
    )
    return actor_for_person(session, person_id) if person_id else None


def people_by_id(session: Session, ids: set[UUID]) -> dict[UUID, Person]:
    """Return people by their ids."""
    return {person.id: person for person in session.scalars(select(Person).where(Person.id.in_(ids)))}
