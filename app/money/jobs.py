"""The jobs of this room: months of retainers, and cues that were accepted before their contract."""

from uuid import UUID

from app.agreements.plan.queries import cues_of
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.money import queries, verdicts
from app.money.work.retainers import charge_retainer


@job("money.charge_retainers")
def charge_retainers(runtime: Runtime, _payload: Payload) -> None:
    """Charge the months of retainers that have begun, each contract in a transaction of its own."""
    with runtime.database.reading() as session:
        contract_ids = queries.contracts_with_retainer(session)
    for contract_id in contract_ids:
        with runtime.database.writing() as session:
            charge_retainer(session, contract_id)


@job("money.add_accepted_cues")
def add_accepted_cues(runtime: Runtime, payload: Payload) -> None:
    """Add the cues that were accepted before to the contract that is agreed now."""
    contract_id = UUID(payload["contract_id"])
    with runtime.database.reading() as session:
        cue_ids = [cue.cue_id for cue in cues_of(session, contract_id) if cue.accepted_at is None]
    for cue_id in cue_ids:
        with runtime.database.writing() as session:
            verdicts.add_accepted_cue(session, contract_id, cue_id)
