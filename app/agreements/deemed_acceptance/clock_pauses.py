"""The time in which a change order is open: the days of the clause on silence do not count then."""

from sqlalchemy.orm import Session

from app.agreements.deemed_acceptance import queries
from app.agreements.models import ClockPause, Contract
from app.core import clock


def begin_pause(session: Session, contract: Contract, change_order: int) -> None:
    """Note that a change order of a contract is open."""
    session.add(
        ClockPause(
            studio_id=contract.studio_id,
            project_id=contract.project_id,
            contract_id=contract.id,
            change_order=change_order,
            began_at=clock.now(),
        )
    )
    session.flush()


def end_pause(session: Session, contract: Contract, change_order: int) -> None:
    """Note that a change order of a contract is closed."""
    for pause in queries.clock_pauses(session, {contract.id}):
        if pause.change_order == change_order and pause.ended_at is None:
            pause.ended_at = clock.now()
    session.flush()
