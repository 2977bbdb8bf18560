"""Sounds closed to the studio by a contract until they are paid."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core.events import send
from app.deliveries.errors import DownloadUnpaid
from app.deliveries.signals import DownloadsClosed


def ensure_open(session: Session, actor: Actor, cue_id: UUID | None, designer_id: UUID) -> None:
    """Raise DownloadUnpaid where the files of a designer's work on a cue are closed to the caller."""
    if reason := closed_to(session, actor, cue_id, designer_id):
        raise DownloadUnpaid(
            f"this file cannot be downloaded: {reason}",
            fix="listen to the preview until then; payments are recorded on the page Money",
        )


def closed_to(session: Session, actor: Actor, cue_id: UUID | None, designer_id: UUID) -> str | None:
    """Return the reason that the files of a designer's work on a cue are closed to the caller; None if open."""
    if cue_id is None or actor.person_id == designer_id:
        return None
    work = (cue_id, designer_id)
    return next((closed[work] for closed in send(session, DownloadsClosed(actor, {work})) if work in closed), None)
