"""Queries for sign-in providers and the domains bound to studios."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.accounts.models import SignInDomain, SignInProvider, Studio


def provider_of(session: Session, studio_id: UUID) -> SignInProvider | None:
    """Return the sign-in provider of a studio."""
    return session.get(SignInProvider, studio_id)


def domains_of(session: Session, studio_id: UUID) -> Sequence[str]:
    """Return the domains bound to a studio, in alphabetical order."""
    bound = select(SignInDomain.domain).where(SignInDomain.studio_id == studio_id).order_by(SignInDomain.domain)
    return session.scalars(bound).all()


def domain_binding(session: Session, domain: str) -> SignInDomain | None:
    """Return the binding of a domain."""
    return session.get(SignInDomain, domain)


def studio_for_domain(session: Session, domain: str) -> Studio | None:
    """Return the studio whose provider signs a domain's people in."""
    return session.scalar(
        select(Studio)
        .join(SignInDomain, SignInDomain.studio_id == Studio.id)
        .join(SignInProvider, SignInProvider.studio_id == Studio.id)
        .where(SignInDomain.domain == domain)
    )
