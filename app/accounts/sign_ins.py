"""Signed-in browsers: their beginning, where they are, and their end."""

from collections.abc import Sequence
from datetime import timedelta
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts import queries
from app.accounts.authentication import new_secret, sha256_of
from app.accounts.errors import SignInNotFound
from app.accounts.models import SignIn
from app.accounts.rules import Actor
from app.core import clock
from app.core.access_scope import AccessScope
from app.core.db import bypass_row_policies, set_access_scope

SIGN_IN_LIFETIME = timedelta(days=30)


def start_sign_in(
    session: Session,
    person_id: UUID,
    *,
    replaces: str | None = None,
    device: str = "",
    place: str = "",
    second_factor_studio_id: UUID | None = None,
) -> str:
    """Sign a person in, and return the secret for the cookie; the browser's sign-in before this one ends."""
    if replaces is not None:
        with bypass_row_policies(session):  # it may be another person's
            queries.end_sign_in(session, sha256_of(replaces))
    set_access_scope(session, AccessScope(person_id=person_id))
    queries.drop_old_sign_ins(session, person_id)
    secret = new_secret()
    session.add(
        SignIn(
            person_id=person_id,
            secret_sha256=sha256_of(secret),
            device=device,
            place=place,
            second_factor_studio_id=second_factor_studio_id,
            expires_at=clock.now() + SIGN_IN_LIFETIME,
        )
    )
    session.flush()
    return secret


def sign_ins_of(session: Session, actor: Actor) -> Sequence[SignIn]:
    """Return the caller's sign-ins that are not over, the one used last first."""
    return queries.open_sign_ins(session, actor.person)


def end_one(session: Session, actor: Actor, sign_in_id: UUID) -> None:
    """End one of the caller's sign-ins."""
    for signed_in in sign_ins_of(session, actor):
        if signed_in.id == sign_in_id:
            session.delete(signed_in)
            return
    raise SignInNotFound(f"no sign-in {sign_in_id} of yours")


def end_others(session: Session, actor: Actor, kept_secret: str | None) -> None:
    """End every sign-in of the caller but the one that asks."""
    queries.end_sign_ins(session, actor.person, except_sha256=sha256_of(kept_secret) if kept_secret else None)


def end_sign_in(session: Session, secret: str) -> None:
    """Sign one browser out."""
    queries.end_sign_in(session, sha256_of(secret))
