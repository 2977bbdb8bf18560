"""The designers of cues, by their contracts."""

from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.agreements.models import Contract, ContractCue
from app.agreements.rules import ContractState


def designers_of_cues(session: Session, project_id: UUID) -> dict[UUID, tuple[UUID, str]]:
    """Return id and name of the designer who has agreed to make a cue, by the cue."""
    agreed = (
        select(ContractCue.cue_id, Person.id, Person.name)
        .join(Contract, Contract.id == ContractCue.contract_id)
        .join(Person, Person.id == Contract.designer_id)
        .where(ContractCue.project_id == project_id, Contract.state == ContractState.AGREED)
        .order_by(Contract.agreed_at)
    )
    return {cue_id: (person_id, name) for cue_id, person_id, name in session.execute(agreed)}
