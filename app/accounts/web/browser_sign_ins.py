"""Cookies by which a browser stays signed in."""

from datetime import timedelta
from uuid import UUID

import structlog
from fastapi import Request, Response
from sqlalchemy.orm import Session

from app.accounts import authentication, sign_ins
from app.accounts.authentication import (
    SESSION_COOKIE,
    csrf_token,
)
from app.accounts.models import Person
from app.accounts.rules import device_of
from app.accounts.security_log import service as security_log
from app.accounts.security_log.rules import SecurityEventKind
from app.accounts.web.policies import client_address
from app.core import clock
from app.core.events import publish
from app.core.web.http import runtime_of
from app.settings import Settings

DEVICE_LIFETIME = timedelta(days=365)
NEW_ACCOUNT = timedelta(minutes=1)  # who opens one knows of the browser
log = structlog.get_logger(__name__)


def sign_in_browser(
    session: Session,
    settings: Settings,
    request: Request,
    response: Response,
    person: Person,
    *,
    second_factor_studio_id: UUID | None = None,
) -> None:
    """Give the answering browser a session in place of the one it had, and mail a first sign-in to the person."""
    if not _is_known(request, person):
        publish(
            session,
            "device.signed_in",
            studio_id=None,
            person_id=person.id,
            device=device_of(request.headers.get("user-agent", "")),
            place=client_address(request) or "an unknown address",
        )
    device = device_of(request.headers.get("user-agent", ""))
    security_log.record_of_person(session, SecurityEventKind.SIGN_IN, f"signed in with {device}", person.id)
    secret = sign_ins.start_sign_in(
        session,
        person.id,
        replaces=request.cookies.get(SESSION_COOKIE),
        device=device_of(request.headers.get("user-agent", "")),
        place=client_address(request),
        second_factor_studio_id=second_factor_studio_id,
    )
    set_cookie(response, settings, SESSION_COOKIE, secret, lifetime=sign_ins.SIGN_IN_LIFETIME)
    device = authentication.device_cookie(settings, person.email)
    set_cookie(response, settings, authentication.DEVICE_COOKIE, device, lifetime=DEVICE_LIFETIME)
    give_csrf_token(response, settings, secret)
    log.info("signed in", person_id=str(person.id), place=client_address(request))


def _is_known(request: Request, person: Person) -> bool:
    """Whether a browser signed in to an account before, or opened it just now."""
    cookie = request.cookies.get(authentication.DEVICE_COOKIE, "")
    is_device = authentication.device_for(runtime_of(request).settings, cookie, person.email) is not None
    return is_device or clock.now() - person.created_at < NEW_ACCOUNT


def set_cookie(response: Response, settings: Settings, name: str, value: str, *, lifetime: timedelta) -> None:
    """Set a cookie that no script reads and no other site sends."""
    max_age = int(lifetime.total_seconds())
    response.set_cookie(name, value, max_age=max_age, httponly=True, samesite="lax", secure=settings.is_https)


def give_csrf_token(response: Response, settings: Settings, secret: str) -> None:
    """Set the cookie from which our page reads its CSRF token."""
    response.set_cookie(
        authentication.CSRF_COOKIE,
        csrf_token(settings, secret),
        samesite="lax",
        secure=settings.is_https,
        httponly=False,
    )
