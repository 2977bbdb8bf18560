"""What a studio has of what is limited, and the limits that are its own."""

from uuid import UUID

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.accounts.models import Membership, Person, Quota, Studio, Token
from app.kit import clock


def own_limits(session: Session, studio_id: UUID) -> dict[str, int]:
    """Return the limits of a studio that are not the defaults, by kind."""
    rows = session.execute(select(Quota.kind, Quota.maximum).where(Quota.studio_id == studio_id)).all()
    return dict(rows)


def studios_opened_by(session: Session, person_id: UUID) -> int:
    """Return how many studios a person has opened, with the person locked until this transaction ends."""
    session.execute(select(Person.id).where(Person.id == person_id).with_for_update())
    return session.scalar(select(func.count()).where(Studio.opened_by == person_id)) or 0


def people_in(session: Session, studio_id: UUID) -> int:
    """Return how many members a studio has."""
    return session.scalar(select(func.count()).where(Membership.studio_id == studio_id)) or 0


def tokens_of(session: Session, studio_id: UUID) -> int:
    """Return how many tokens of a studio work."""
    works = (Token.studio_id == studio_id, Token.revoked_at.is_(None), Token.expires_at > clock.now())
    return session.scalar(select(func.count()).where(*works)) or 0
