"""Labels of takes: what each is among alternates."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.queries import people_by_id
from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.core import clock
from app.deliveries.models import Take
from app.deliveries.schemas import TakeLabelRead
from app.deliveries.service import take_for


def set_label(session: Session, actor: Actor, take_id: UUID, label: str | None) -> TakeLabelRead:
    """Label a take, as its designer or for the team; the last who did is kept."""
    take, _ = take_for(session, actor, take_id, locked=True)
    if take.label != label:
        take.label, take.labelled_by, take.labelled_at = label, actor.person, clock.now()
        session.flush()
    return label_of(session, take)


def label_of(session: Session, take: Take) -> TakeLabelRead:
    """Return the label of a take with who set it."""
    people = people_by_id(session, {take.labelled_by}) if take.labelled_by else {}
    by = people.get(take.labelled_by) if take.labelled_by else None
    return TakeLabelRead(
        label=take.label, labelled_by=by and PersonBrief.model_validate(by), labelled_at=take.labelled_at
    )
