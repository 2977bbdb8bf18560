"""The sign-in provider of a studio (OpenID Connect), and the domains that an operator binds to the studio."""

from collections.abc import Sequence
from dataclasses import dataclass
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.errors import (
    BadAddress,
    DomainTaken,
    NotInDemo,
    ProviderNotFound,
    StudioNotFound,
)
from app.accounts.models import SignInDomain, SignInProvider, Studio
from app.accounts.providers import queries as provider_queries
from app.accounts.providers.rules import DISCOVERY_PATH, ProviderEndpoints, domain_of, endpoints_in, wrong_issuer
from app.accounts.rules import Actor, ensure_address
from app.accounts.service import ensure_producer_of
from app.core import clock, outgoing
from app.core.db import bypass_row_policies
from app.core.events import publish
from app.core.outgoing import AddressRefused, RequestFailed, Resolver
from app.core.server_keys import sealed, unsealed
from app.settings import Settings

KEY_PURPOSE = "sign-in providers"
CALLBACK_PAGE = "/sign-in/provider"
JSON_ONLY = {"Accept": "application/json", "User-Agent": "Soundlist-SignIn/1"}


@dataclass(frozen=True)
class StudioProvider:
    """The provider of a studio, the domains bound to the studio, and the address to enter at the provider."""

    issuer: str | None
    client_id: str | None
    domains: Sequence[str]
    redirect_uri: str


def redirect_uri(settings: Settings) -> str:
    """Return the address that providers send browsers back to."""
    return settings.base_url + CALLBACK_PAGE


def provider_of(session: Session, actor: Actor, settings: Settings, studio_id: UUID) -> StudioProvider:
    """Return the sign-in provider of the caller's studio, without its client secret."""
    ensure_producer_of(session, actor, studio_id)
    provider = provider_queries.provider_of(session, studio_id)
    return StudioProvider(
        issuer=provider.issuer if provider else None,
        client_id=provider.client_id if provider else None,
        domains=provider_queries.domains_of(session, studio_id),
        redirect_uri=redirect_uri(settings),
    )


def ensure_may_set(session: Session, actor: Actor, studio_id: UUID) -> None:
    """Raise unless the caller is a producer of the studio and it is not the demo's."""
    if ensure_producer_of(session, actor, studio_id).is_demo:
        raise NotInDemo("the studio of the demo has no sign-in provider")


def discover(settings: Settings, issuer: str, *, resolver: Resolver = outgoing.resolve) -> ProviderEndpoints:
    """Return the endpoints that an issuer publishes; raise ProviderRefused."""
    may_be_localhost = settings.webhook_localhost
    try:
        answer = outgoing.get(
            issuer.rstrip("/") + DISCOVERY_PATH, JSON_ONLY, resolver=resolver, may_be_localhost=may_be_localhost
        )
        if answer.status != 200:
            raise wrong_issuer(f"{issuer}{DISCOVERY_PATH} answers {answer.status}", "check the issuer")
        endpoints = endpoints_in(answer.beginning, issuer)
        for address in (endpoints.authorization_endpoint, endpoints.token_endpoint, endpoints.jwks_uri):
            outgoing.ensure_address(address, may_be_localhost=may_be_localhost)
    except (AddressRefused, RequestFailed) as error:
        raise wrong_issuer(str(error), "enter the issuer's https address, as https://login.studio.example") from None
    return endpoints


def set_provider(
    session: Session,
    actor: Actor,
    settings: Settings,
    studio_id: UUID,
    endpoints: ProviderEndpoints,
    *,
    issuer: str,
    client_id: str,
    client_secret: str,
) -> StudioProvider:
    """Keep the sign-in provider of a studio in place of the one before."""
    ensure_may_set(session, actor, studio_id)
    session.merge(
        SignInProvider(
            studio_id=studio_id,
            issuer=issuer,
            client_id=client_id,
            sealed_client_secret=sealed(
                settings.secret_key.get_secret_value(), KEY_PURPOSE, client_secret, context=studio_id.bytes
            ),
            authorization_endpoint=endpoints.authorization_endpoint,
            token_endpoint=endpoints.token_endpoint,
            jwks_uri=endpoints.jwks_uri,
            is_secret_in_body=endpoints.is_secret_in_body,
            saved_at=clock.now(),
        )
    )
    session.flush()
    _publish_change(session, actor, studio_id, f"set the sign-in provider {issuer}.")
    return provider_of(session, actor, settings, studio_id)


def remove_provider(session: Session, actor: Actor, studio_id: UUID) -> None:
    """Remove the sign-in provider of a studio; its domains stay bound."""
    ensure_producer_of(session, actor, studio_id)
    provider = provider_queries.provider_of(session, studio_id)
    if provider is None:
        raise ProviderNotFound("the studio has no sign-in provider")
    session.delete(provider)
    session.flush()
    _publish_change(session, actor, studio_id, f"removed the sign-in provider {provider.issuer}.")


def client_secret_of(settings: Settings, provider: SignInProvider) -> str:
    """Return the client secret that a producer entered."""
    secret, context = settings.secret_key.get_secret_value(), provider.studio_id.bytes
    return unsealed(secret, KEY_PURPOSE, provider.sealed_client_secret, context=context)


def studio_for_domain(session: Session, domain: str) -> Studio | None:
    """Return the studio whose provider signs in the people of a domain."""
    with bypass_row_policies(session):  # who signs in is not known yet
        return provider_queries.studio_for_domain(session, domain_of(domain))


def bind_domain(session: Session, studio_id: UUID, domain: str) -> Studio:
    """Bind a domain to a studio, which the operator knows to own it."""
    studio = session.get(Studio, studio_id)
    if studio is None:
        raise StudioNotFound(f"no studio {studio_id}")
    name = domain_of(domain)
    try:
        ensure_address(f"name@{name}")
    except BadAddress:
        raise BadAddress(f"{domain} is not a domain", fix="write it as in an address: studio.example") from None
    bound = provider_queries.domain_binding(session, name)
    if bound is not None and bound.studio_id != studio_id:
        raise DomainTaken(f"{name} is bound to the studio {bound.studio_id}", fix="unbind it there first")
    if bound is None:
        session.add(SignInDomain(domain=name, studio_id=studio_id))
    return studio


def unbind_domain(session: Session, domain: str) -> None:
    """End the binding of a domain."""
    bound = provider_queries.domain_binding(session, domain_of(domain))
    if bound is None:
        raise ProviderNotFound(f"{domain} is bound to no studio")
    session.delete(bound)


def _publish_change(session: Session, actor: Actor, studio_id: UUID, change: str) -> None:
    publish(session, "sign_in_provider.changed", studio_id=studio_id, person_id=actor.person, change=change)
