"""The jobs of this room: contracts whose last day has passed."""

from app.amendments import ending, queries
from app.core import clock
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime


@job("amendments.settle_ended")
def settle_ended(runtime: Runtime, _payload: Payload) -> None:
    """Settle each contract whose notice is over, in a transaction of its own."""
    today = clock.now().date()
    with runtime.database.reading() as session:
        contract_ids = queries.contracts_to_settle(session, today)
    for contract_id in contract_ids:
        with runtime.database.writing() as session:
            ending.settle_if_over(session, contract_id, today)
