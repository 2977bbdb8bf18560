"""The states of the two contracts of joint work, which move together until both are agreed."""

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements.joint.queries import other_contract
from app.agreements.models import Contract
from app.agreements.record import service as record
from app.agreements.rules import ContractState
from app.core.db import bypass_row_policies


def take_back_other(session: Session, actor: Actor, contract: Contract) -> None:
    """Make the other contract of joint work a draft again, as this one is; its acceptances no longer count."""
    other = other_contract(session, contract)
    if other is not None and other.state is ContractState.SENT:
        with bypass_row_policies(session):  # the designer of one contract does not write the other
            other.state = ContractState.DRAFT
            record.append_by(session, actor, other, "taken_back", reason=f"{contract.title} is a draft again")


def part_from_other(session: Session, actor: Actor, contract: Contract, *, reason: str) -> None:
    """Let the other contract of joint work be a draft that stands alone, where this one is given up unsigned."""
    other = other_contract(session, contract)
    if other is None or contract.state is ContractState.AGREED:
        return
    with bypass_row_policies(session):  # the designer of one contract does not write the other
        contract.joint_id = other.joint_id = None
        other.state = ContractState.DRAFT
        if other.record_length:  # it was sent once, so its designer reads the record
            record.append_by(session, actor, other, "stands_alone", ended=contract.title, reason=reason)
