"""Queries for changes of an account's address."""

from uuid import UUID

from sqlalchemy import delete, select
from sqlalchemy.orm import Session

from app.accounts.models import EmailChange
from app.core import clock


def open_email_changes(session: Session, person_id: UUID) -> list[EmailChange]:
    """Return both ends of a person's change that is not over, the old one first."""
    changes = select(EmailChange).where(EmailChange.person_id == person_id, EmailChange.expires_at > clock.now())
    return list(session.scalars(changes.order_by(EmailChange.is_new_end)))


def email_change_by_secret(session: Session, secret_sha256: str) -> EmailChange | None:
    """Return the end of a change behind a link that is still good."""
    return session.scalar(
        select(EmailChange).where(EmailChange.secret_sha256 == secret_sha256, EmailChange.expires_at > clock.now())
    )


def drop_email_changes(session: Session, person_id: UUID) -> None:
    """Delete a person's change, with the links of both ends."""
    session.execute(delete(EmailChange).where(EmailChange.person_id == person_id))
