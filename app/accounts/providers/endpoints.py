"""The endpoints of sign-in providers: a studio's own, and signing in by one."""

from typing import Annotated
from uuid import UUID

import structlog
from fastapi import APIRouter, Query, Request, Response

from app.accounts import rate_limits
from app.accounts.errors import (
    NotInDemo,
    ProducerNeeded,
    ProviderNotFound,
    ProviderRefused,
    ProviderSignInRefused,
    RecentSignInNeeded,
    StudioNotFound,
    TooManyAttempts,
    WrongSecondFactor,
)
from app.accounts.models import Person
from app.accounts.providers import service as providers
from app.accounts.providers import sign_ins as provider_sign_ins
from app.accounts.providers.rules import SIGN_IN_LIFETIME
from app.accounts.providers.schemas import (
    ProviderAnswer,
    ProviderCode,
    ProviderOfDomain,
    ProviderRead,
    ProviderRedirect,
    ProviderSave,
    ProviderSignInDone,
    ProviderSignInStart,
)
from app.accounts.providers.service import StudioProvider
from app.accounts.providers.sign_ins import COOKIE
from app.accounts.rules import MAX_ADDRESS_LENGTH, Actor, Audience
from app.accounts.second_factors import service as second_factors
from app.accounts.web.browser_sign_ins import set_cookie, sign_in_browser
from app.accounts.web.policies import allows
from app.accounts.web.request_limits import (
    DeferredSession,
    ensure_second_factor_allowed,
    ensure_within_limits,
    network_of,
)
from app.core.access_scope import AccessScope
from app.core.db import set_access_scope
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.core.web.idempotency import UNSAVED

router = APIRouter(prefix="/v1", tags=["accounts"])
_unsaved_router = APIRouter(dependencies=UNSAVED)
log = structlog.get_logger(__name__)


@router.get(
    "/studios/{studio_id}/sign-in-provider",
    response_model=ProviderRead,
    responses=problems(StudioNotFound, ProducerNeeded),
)
def read_sign_in_provider(
    studio_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = allows(Audience.PRODUCER)
) -> StudioProvider:
    """Return the sign-in provider of the studio and the domains bound to it."""
    return providers.provider_of(session, actor, runtime.settings, studio_id)


@_unsaved_router.put(
    "/studios/{studio_id}/sign-in-provider",
    response_model=ProviderRead,
    responses=problems(StudioNotFound, ProducerNeeded, NotInDemo, ProviderRefused, RecentSignInNeeded, TooManyAttempts),
)
def set_sign_in_provider(
    studio_id: UUID,
    body: ProviderSave,
    request: Request,
    begin: DeferredSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.PRODUCER, recent_sign_in=True),
) -> StudioProvider:
    """Set the sign-in provider of the studio, after reading its discovery document."""
    with runtime.database.reading(actor.reach) as session:
        providers.ensure_may_set(session, actor, studio_id)
    ensure_within_limits(request, (rate_limits.WEBHOOK_MESSAGES_OF_STUDIO, str(studio_id)))
    endpoints = providers.discover(runtime.settings, body.issuer)
    with begin() as session:
        return providers.set_provider(
            session,
            actor,
            runtime.settings,
            studio_id,
            endpoints,
            issuer=body.issuer,
            client_id=body.client_id,
            client_secret=body.client_secret,
        )


@router.delete(
    "/studios/{studio_id}/sign-in-provider",
    status_code=204,
    responses=problems(StudioNotFound, ProducerNeeded, ProviderNotFound, RecentSignInNeeded),
)
def remove_sign_in_provider(
    studio_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER, recent_sign_in=True)
) -> None:
    """Remove the sign-in provider of the studio; people sign in by password again."""
    providers.remove_provider(session, actor, studio_id)


@router.get("/sign-in/provider", responses=problems(TooManyAttempts))
def read_provider_of_domain(
    domain: Annotated[str, Query(max_length=MAX_ADDRESS_LENGTH, description="What follows the @ of an address.")],
    request: Request,
    session: DbSession,
    _actor: Actor = allows(Audience.ANYONE),
) -> ProviderOfDomain:
    """Return the studio whose provider signs a domain's people in, whoever has an account."""
    ensure_within_limits(request, (rate_limits.PROVIDER_LOOKUPS_FROM_NETWORK, network_of(request)))
    studio = providers.studio_for_domain(session, domain)
    return ProviderOfDomain(studio_id=studio.id if studio else None, studio_name=studio.name if studio else None)


@_unsaved_router.post("/sign-in/oidc/start", responses=problems(ProviderNotFound, TooManyAttempts))
def begin_provider_sign_in(
    body: ProviderSignInStart,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    _actor: Actor = allows(Audience.ANYONE),
) -> ProviderRedirect:
    """Return the provider's page to open; the sign-in is bound to this browser, and ends after ten minutes."""
    ensure_within_limits(request, (rate_limits.SIGN_INS_FROM_NETWORK, network_of(request)))
    with runtime.database.reading() as session:
        provider = provider_sign_ins.provider_to_sign_in(session, body.studio_id)
    url, cookie = provider_sign_ins.begin(runtime.settings, provider, body.next_path)
    set_cookie(response, runtime.settings, COOKIE, cookie, lifetime=SIGN_IN_LIFETIME)
    return ProviderRedirect(url=url)


@_unsaved_router.post(
    "/sign-in/oidc/callback", responses=problems(ProviderNotFound, ProviderSignInRefused, TooManyAttempts)
)
def finish_provider_sign_in(
    body: ProviderAnswer,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    begin: DeferredSession,
    _actor: Actor = allows(Audience.ANYONE),
) -> ProviderSignInDone:
    """Sign in whom the provider vouches for; a second factor of the account itself is asked for first."""
    ensure_within_limits(request, (rate_limits.SIGN_INS_FROM_NETWORK, network_of(request)))
    settings = runtime.settings
    begun = provider_sign_ins.begun_sign_in(settings, request.cookies.get(COOKIE, ""))
    with runtime.database.reading() as session:
        provider = provider_sign_ins.provider_to_sign_in(session, begun.studio_id)
    try:
        proven = provider_sign_ins.proven_person(
            settings, provider, begun, code=body.code, state=body.state, answered_issuer=body.iss
        )
        with begin() as session:
            person = provider_sign_ins.account_of(session, begun.studio_id, proven)
            is_code_needed = provider_sign_ins.asks_for_code(session, person)
            if is_code_needed:
                cookie = provider_sign_ins.code_cookie(
                    settings, person, begun, has_second_factor=proven.has_second_factor
                )
                set_cookie(response, settings, COOKIE, cookie, lifetime=SIGN_IN_LIFETIME)
            else:
                vouching_id = begun.studio_id if proven.has_second_factor else None
                sign_in_browser(session, settings, request, response, person, second_factor_studio_id=vouching_id)
                response.delete_cookie(COOKIE, samesite="lax")
    except ProviderSignInRefused as error:
        reason = type(error.__cause__ or error).__name__
        log.warning("sign-in refused", studio_id=str(begun.studio_id), reason=reason, place=network_of(request))
        raise
    return ProviderSignInDone(second_factor_needed=is_code_needed, next_path=begun.next_path)


@_unsaved_router.post(
    "/sign-in/oidc/code", responses=problems(ProviderSignInRefused, TooManyAttempts, WrongSecondFactor)
)
def give_provider_sign_in_code(
    body: ProviderCode,
    request: Request,
    response: Response,
    runtime: CurrentRuntime,
    begin: DeferredSession,
    _actor: Actor = allows(Audience.ANYONE),
) -> ProviderSignInDone:
    """Sign in whom a provider vouched for by the code of their own second factor."""
    settings = runtime.settings
    person_id, vouching_id, next_path = provider_sign_ins.person_to_code(settings, request.cookies.get(COOKIE, ""))
    ensure_second_factor_allowed(request, str(person_id))
    with begin() as session:
        set_access_scope(session, AccessScope(person_id=person_id))
        second_factors.ensure_right_code(session, settings, person_id, body.code)
        person = session.get_one(Person, person_id)
        sign_in_browser(session, settings, request, response, person, second_factor_studio_id=vouching_id)
    response.delete_cookie(COOKIE, samesite="lax")
    return ProviderSignInDone(second_factor_needed=False, next_path=next_path)


router.include_router(_unsaved_router)
