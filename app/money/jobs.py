"""The jobs of this room: months of retainers."""

from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.money import queries
from app.money.work.retainers import charge_retainer


@job("money.charge_retainers")
def charge_retainers(runtime: Runtime, _payload: Payload) -> None:
    """Charge the months of retainers that have begun, each contract in a transaction of its own."""
    with runtime.database.reading() as session:
        contract_ids = queries.contracts_with_retainer(session)
    for contract_id in contract_ids:
        with runtime.database.writing() as session:
            charge_retainer(session, contract_id)
