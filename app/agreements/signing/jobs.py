"""The jobs of this room: sealing what all have signed."""

from uuid import UUID

from app.agreements import queries
from app.agreements.signing import seals
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime


@job("agreements.seal_contract")
def seal_contract(runtime: Runtime, payload: Payload) -> None:
    """Make and seal the PDF of a contract that all have signed."""
    seals.seal_contract(runtime, UUID(payload["contract_id"]))


@job("agreements.seal_unsealed")
def seal_unsealed(runtime: Runtime, _payload: Payload) -> None:
    """Seal contracts that were signed before there were seals."""
    with runtime.database.reading() as session:
        contract_ids = queries.unsealed_contracts(session)
    for contract_id in contract_ids:
        seals.seal_contract(runtime, contract_id)
