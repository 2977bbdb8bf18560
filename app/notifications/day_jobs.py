"""Mails about the days that contracts name."""

from app.agreements.clauses.facts import format_long_date
from app.agreements.clauses.named_term_queries import contracts_with_days
from app.agreements.models import DateReminder
from app.agreements.reminders import near_days
from app.core import clock
from app.core.db import insert_if_absent
from app.core.jobs.queue import Payload
from app.core.runtime import Runtime
from app.notifications import queries
from app.notifications.kinds import notice
from app.notifications.notifier import Notifier


@notice()
def remind_of_days(runtime: Runtime, _payload: Payload) -> None:
    """Remind both parties once of each day that their contract names, two weeks before it."""
    today = clock.now().date()
    with runtime.database.writing() as session:
        for contract, named in near_days(session, contracts_with_days(session), today):
            of = {"contract_id": contract.id, "term": named.term, "day": named.day}
            row = of | {"studio_id": contract.studio_id, "project_id": contract.project_id, "sent_at": clock.now()}
            if not insert_if_absent(session, DateReminder, row, unique=tuple(of)):
                continue
            recipients = {queries.address_of(session, contract.designer_id)}
            recipients |= queries.producer_addresses(session, contract.studio_id)
            event_id = f"day:{contract.id}:{named.term}:{named.day}"
            notifier = Notifier(runtime, session, contract.project, event_id)
            line = f"{contract.title}: {named.words} on {format_long_date(named.day)}."
            for recipient in recipients:
                notifier.notify(recipient, "contract:day", "a day in a contract", line, page=f"contracts/{contract.id}")
