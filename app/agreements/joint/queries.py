"""The other contract of joint work, read from the database; callers have checked who looks at the first."""

from uuid import UUID

from sqlalchemy import exists, select
from sqlalchemy.orm import Session

from app.agreements.models import Contract
from app.agreements.queries import WHOLE


def other_contract(session: Session, contract: Contract) -> Contract | None:
    """Return the other contract of joint work; None for a contract that stands alone."""
    if contract.joint_id is None:
        return None
    return session.scalar(
        select(Contract).where(Contract.joint_id == contract.joint_id, Contract.id != contract.id).options(*WHOLE)
    )


def is_designer_of_other(session: Session, contract: Contract, person_id: UUID) -> bool:
    """Whether a person is the designer of the other contract of joint work."""
    of_other = Contract.joint_id == contract.joint_id, Contract.id != contract.id, Contract.designer_id == person_id
    return contract.joint_id is not None and bool(session.scalar(select(exists().where(*of_other))))
