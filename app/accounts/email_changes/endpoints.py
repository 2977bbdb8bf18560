"""The endpoints that change an account's address."""

from fastapi import APIRouter, Request

from app.accounts.authentication import SESSION_COOKIE
from app.accounts.email_changes import service as email_changes
from app.accounts.email_changes.schemas import EmailChangeAdd, EmailChangeRead, EmailChangeShown
from app.accounts.errors import (
    AddressTaken,
    BadAddress,
    EmailChangeNotFound,
    NotInDemo,
    RecentSignInNeeded,
    SameAddress,
    TooManyAttempts,
)
from app.accounts.models import EmailChange, Person
from app.accounts.rules import Actor, Audience, ensure_address
from app.accounts.schemas import PersonRead
from app.accounts.web.policies import allows
from app.accounts.web.request_limits import DeferredSession, ensure_mail_allowed
from app.core.web.http import DbSession, problems
from app.core.web.idempotency import UNSAVED

router = APIRouter(prefix="/v1", tags=["accounts"])
_unsaved_router = APIRouter(dependencies=UNSAVED)


def _read(ends: list[EmailChange]) -> EmailChangeRead:
    old_end, new_end = ends
    return EmailChangeRead(
        new_email=new_end.new_email,
        old_confirmed=old_end.confirmed_at is not None,
        new_confirmed=new_end.confirmed_at is not None,
        expires_at=new_end.expires_at,
    )


@router.get("/me/email-change")
def read_my_email_change(session: DbSession, actor: Actor = allows(Audience.PERSON)) -> EmailChangeRead | None:
    """Return the change of the caller's address that waits, null where none does."""
    ends = email_changes.pending_email_change(session, actor)
    return _read(ends) if ends else None


@_unsaved_router.post(
    "/me/email-change",
    status_code=202,
    responses=problems(BadAddress, NotInDemo, RecentSignInNeeded, SameAddress, TooManyAttempts),
)
def request_my_email_change(
    body: EmailChangeAdd,
    request: Request,
    begin: DeferredSession,
    actor: Actor = allows(Audience.PERSON, recent_sign_in=True),
) -> EmailChangeRead:
    """Mail a link to the caller's address and to the new one; nothing changes before both are followed."""
    ensure_mail_allowed(request, str(actor.person))
    ensure_mail_allowed(request, ensure_address(body.email))
    with begin() as session:
        return _read(email_changes.request_email_change(session, actor, body.email))


@router.delete("/me/email-change", status_code=204)
def cancel_my_email_change(session: DbSession, actor: Actor = allows(Audience.PERSON)) -> None:
    """Stop the change of the caller's address."""
    email_changes.cancel_email_change(session, actor)


@router.get("/email-changes/{secret}", responses=problems(EmailChangeNotFound))
def read_email_change(secret: str, session: DbSession, _actor: Actor = allows(Audience.ANYONE)) -> EmailChangeShown:
    """Show the holder of a mailed link which address an account is to have."""
    end = email_changes.email_change_by_secret(session, secret)
    return EmailChangeShown(
        new_email=end.new_email,
        is_new_end=end.is_new_end,
        is_confirmed=end.confirmed_at is not None,
        expires_at=end.expires_at,
    )


@router.post(
    "/email-changes/{secret}/confirm", response_model=PersonRead, responses=problems(AddressTaken, EmailChangeNotFound)
)
def confirm_email_change(
    secret: str, request: Request, session: DbSession, actor: Actor = allows(Audience.PERSON)
) -> Person:
    """Confirm one end of the caller's change; the second one changes the address and ends other sign-ins."""
    kept_secret = request.cookies.get(SESSION_COOKIE)
    return email_changes.confirm_email_change(session, actor, secret, kept_secret=kept_secret)


@router.delete("/email-changes/{secret}", status_code=204, responses=problems(EmailChangeNotFound))
def stop_email_change(secret: str, session: DbSession, _actor: Actor = allows(Audience.ANYONE)) -> None:
    """Stop a change by the link mailed to either end, signed in or not."""
    email_changes.stop_by_link(session, secret)


router.include_router(_unsaved_router)
