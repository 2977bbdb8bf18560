"""Limits on a caller's tries: rate limits of requests."""

from collections.abc import AsyncIterator, Callable
from contextlib import AbstractContextManager
from functools import partial
from typing import Annotated
from uuid import UUID

from fastapi import Depends, Request
from sqlalchemy.orm import Session

from app.accounts import authentication, rate_limits, rules
from app.accounts.rules import Actor
from app.accounts.web.policies import client_address
from app.core.db import bypass_row_policies
from app.core.web.http import (
    database_of,
    person_slot,
    runtime_of,
    transaction,
)

Begin = Callable[[], AbstractContextManager[Session]]


async def _deferred_session(request: Request) -> AsyncIterator[Begin]:
    async with person_slot(request, reads=False):
        yield partial(transaction, request)


# What opens the request's transaction, for endpoints that first write what stays although the request is refused.
DeferredSession = Annotated[Begin, Depends(_deferred_session, scope="function")]


def network_of(request: Request) -> str:
    """Return the place that tries are counted for."""
    return rules.network_of(client_address(request))


def ensure_within_limits(request: Request, *counted: tuple[rate_limits.Limit, str]) -> None:
    """Count one try against each limit; raise TooManyAttempts for too many. What is counted stays counted."""
    for limit, whom in counted:
        with database_of(request).writing() as session:
            rate_limits.count_attempt(session, limit, whom)


def ensure_sign_in_allowed(request: Request, account: str) -> None:
    """Count one guess at an account's password, or at the secret of a link; raise TooManyAttempts for too many."""
    ensure_within_limits(request, *_sign_in_limits(request, account))


def _sign_in_limits(request: Request, account: str) -> list[tuple[rate_limits.Limit, str]]:
    settings = runtime_of(request).settings
    if (
        device := authentication.device_for(settings, request.cookies.get(authentication.DEVICE_COOKIE, ""), account)
    ) is not None:
        return [(rate_limits.SIGN_INS_FROM_DEVICE, device)]  # whatever strangers do, its owner comes through
    network = network_of(request)
    return [
        (rate_limits.SIGN_INS_FROM_NETWORK, network),
        (rate_limits.SIGN_INS_TO_ACCOUNT_FROM_NETWORK, f"{account} {network}"),
        (rate_limits.SIGN_INS_TO_ACCOUNT, account),
    ]


def reset_attempts(session: Session, request: Request, account: str) -> None:
    """Forget the guesses at an account's password, now that it was right."""
    with bypass_row_policies(session):  # the counts are the server's own
        for limit, whom in _sign_in_limits(request, account):
            if limit is not rate_limits.SIGN_INS_FROM_NETWORK:  # an account must not reset guesses at others
                rate_limits.reset(session, limit, whom)
        rate_limits.reset(session, *_second_factor_limit(request, account))


def ensure_invitation_allowed(session: Session, actor: Actor, address: str) -> None:
    """Count one invitation, by its sender and to its mailbox; raise TooManyAttempts for too many."""
    mailbox = rules.mailbox_of(rules.normalised_email(address))
    with bypass_row_policies(session):  # the counts are the server's own
        rate_limits.count_attempt(session, rate_limits.INVITATIONS_BY_PERSON, str(actor.person))
        rate_limits.count_attempt(session, rate_limits.INVITATIONS_TO_MAILBOX, mailbox)


def ensure_second_factor_allowed(request: Request, account: str) -> None:
    """Count one guess at a second factor by who has given the password; raise TooManyAttempts for too many."""
    ensure_within_limits(request, _second_factor_limit(request, account))


def _second_factor_limit(request: Request, account: str) -> tuple[rate_limits.Limit, str]:
    cookie = request.cookies.get(authentication.DEVICE_COOKIE, "")
    device = authentication.device_for(runtime_of(request).settings, cookie, account)
    return rate_limits.SECOND_FACTORS_OF_ACCOUNT, device or account  # who has stolen a password locks nobody out


def ensure_webhook_message_allowed(session: Session, studio_id: UUID) -> None:
    """Count one message that a producer sends by hand; raise TooManyAttempts for too many."""
    with bypass_row_policies(session):  # the counts are the server's own
        rate_limits.count_attempt(session, rate_limits.WEBHOOK_MESSAGES_OF_STUDIO, str(studio_id))


def ensure_guest_visit_allowed(request: Request) -> None:
    """Count one visit of a guest; raise TooManyAttempts for too many."""
    ensure_within_limits(request, (rate_limits.GUEST_VISITS_FROM_NETWORK, network_of(request)))


def ensure_guest_guess_allowed(request: Request, link: str) -> None:
    """Count one guess at a guest link's password; raise TooManyAttempts for too many.

    Each network counts by itself, so that who guesses makes nobody else wait.
    """
    network = network_of(request)
    ensure_within_limits(
        request,
        (rate_limits.SIGN_INS_FROM_NETWORK, network),
        (rate_limits.GUESSES_AT_LINK_FROM_NETWORK, f"{link} {network}"),
    )


def reset_guest_guesses(session: Session, request: Request, link: str) -> None:
    """Forget a network's guesses at a guest link's password, now that one was right."""
    with bypass_row_policies(session):  # the counts are the server's own
        rate_limits.reset(session, rate_limits.GUESSES_AT_LINK_FROM_NETWORK, f"{link} {network_of(request)}")


def ensure_signing_code_allowed(session: Session, actor: Actor) -> None:
    """Count one code mailed to sign with; raise TooManyAttempts for too many."""
    with bypass_row_policies(session):  # the counts are the server's own
        rate_limits.count_attempt(session, rate_limits.SIGNING_CODES_BY_PERSON, str(actor.person))


def ensure_mail_allowed(request: Request, whom: str) -> None:
    """Count one mail that anyone can request for an account, by its mailbox; raise TooManyAttempts for too many."""
    ensure_within_limits(
        request,
        (rate_limits.MAILS_FROM_NETWORK, network_of(request)),
        (rate_limits.MAILS_TO_ADDRESS, rules.mailbox_of(whom)),
    )
