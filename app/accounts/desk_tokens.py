"""Desk tokens: what `soundlist desk` on a person's machine reads their desk with."""

from collections.abc import Sequence
from datetime import timedelta
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts import queries
from app.accounts.authentication import new_secret, sha256_of
from app.accounts.errors import DeskTokenNotFound, NotInDemo, TooManyDeskTokens
from app.accounts.models import DeskToken, Person
from app.accounts.rules import MAX_TOKEN_DAYS, Actor
from app.core import clock
from app.core.events import publish

PREFIX = "sld_"  # secret scanners find a leaked token by it
MAX_TOKENS = 20


def create_desk_token(
    session: Session, actor: Actor, name: str, *, days: int = MAX_TOKEN_DAYS
) -> tuple[DeskToken, str]:
    """Make a key for the caller's desk that ends after so many days; return it with its secret, kept nowhere."""
    person = session.get_one(Person, actor.person)
    if person.demo_part is not None:
        raise NotInDemo("the people of the demo have no desk tokens")
    if len(queries.desk_tokens(session, actor.person)) >= MAX_TOKENS:
        raise TooManyDeskTokens(
            f"you have {MAX_TOKENS} desk tokens, as many as a person may have", fix="revoke one that you do not use"
        )
    secret = PREFIX + new_secret()
    expires_at = clock.now() + timedelta(days=days)
    token = DeskToken(person_id=actor.person, name=name, secret_sha256=sha256_of(secret), expires_at=expires_at)
    session.add(token)
    session.flush()
    publish(session, "desk_token.made", studio_id=None, person_id=actor.person, name=name)
    return token, secret


def desk_tokens_of(session: Session, actor: Actor) -> Sequence[DeskToken]:
    """Return the caller's desk tokens, without their secrets."""
    return queries.desk_tokens(session, actor.person)


def revoke_desk_token(session: Session, actor: Actor, desk_token_id: UUID) -> None:
    """Revoke one of the caller's desk tokens at once."""
    for token in desk_tokens_of(session, actor):
        if token.id == desk_token_id:
            session.delete(token)
            return
    raise DeskTokenNotFound(f"no desk token {desk_token_id} of yours")
