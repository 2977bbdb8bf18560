"""Masters are deleted when their contracts' retention period is over: announced, carried out, on record.

Masters that one designer delivered in one project are deleted together, once the period of every contract between the
two is over. A producer may keep them longer.
"""

from dataclasses import dataclass
from datetime import date
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import Actor
from app.agreements.access import contract_for_producer, visible_contract
from app.agreements.clauses.named_term_queries import named_terms
from app.agreements.models import Contract
from app.agreements.record import service as record
from app.agreements.rules import ContractState
from app.amendments.queries import standing_notice
from app.core import clock
from app.core.db import bypass_row_policies, new_id
from app.core.plural import counted, day_in_words
from app.money.figures import open_tax_minor
from app.money.ledger.service import load_ledger_book
from app.money.overview import figures
from app.notifications import queries as notification_queries
from app.notifications import service as notifications
from app.notifications.notices import service as notices
from app.operations.models import MasterRetention
from app.operations.retention import queries as retention_queries
from app.operations.retention.queries import SIGNED, Masters
from app.operations.retention.rules import announced_day, end_of_masters, is_to_be_announced
from app.operations.schemas import MasterRetentionRead

TERM = "retention_years"
ANNOUNCED, POSTPONED, DELETED = "masters_end_announced", "masters_end_postponed", "masters_deleted"  # kinds of entries
KEPT_LONGER, NOT_KEPT_LONGER = "masters_kept_longer", "masters_not_kept_longer"


@dataclass(frozen=True)
class Plan:
    """The day on which a designer's masters in a project are due for deletion."""

    contracts: list[Contract]  # signed
    masters: Masters
    years: int | None = None  # None: a contract sets no end
    ends_on: date | None = None


def read_retention(session: Session, actor: Actor, contract_id: UUID) -> MasterRetentionRead:
    """Return the retention of the masters of a contract's designer in its project."""
    return _read(session, visible_contract(session, actor, contract_id))


def set_kept_longer(session: Session, actor: Actor, contract_id: UUID, *, keep: bool) -> MasterRetentionRead:
    """Keep masters longer than the contracts ask, or no longer; the records name the producer."""
    contract = contract_for_producer(session, actor, contract_id)
    retention = _retention(session, contract)
    if (retention.kept_by is not None) is keep:
        return _read(session, contract)
    retention.kept_by, retention.kept_at = (actor.person, clock.now()) if keep else (None, None)
    retention.ends_on = retention.announced_at = None  # days of notice begin again
    session.flush()
    for signed in _signed(session, contract.project_id, contract.designer_id):
        record.append(session, signed.id, KEPT_LONGER if keep else NOT_KEPT_LONGER, {}, by=actor.person)
    return _read(session, contract)


def look_after(session: Session, project_id: UUID, designer_id: UUID, *, base_url: str) -> str | None:
    """Announce, postpone or carry out the deletion of a designer's masters in a project; return its kind of entry."""
    plan = plan_of(session, project_id, designer_id)
    if plan.ends_on is None or plan.masters.kept == 0:
        return None
    retention = _retention(session, plan.contracts[0])
    if retention.kept_by is not None:
        return None
    today = clock.now().date()
    if retention.ends_on is not None and retention.ends_on < plan.ends_on:  # delivered or agreed since
        retention.ends_on = retention.announced_at = None
        _record(session, plan, POSTPONED, {"ends_on": plan.ends_on.isoformat()})
        return POSTPONED
    if retention.ends_on is None:
        if not is_to_be_announced(plan.ends_on, today):
            return None
        retention.ends_on, retention.announced_at = announced_day(plan.ends_on, today), clock.now()
        _record(session, plan, ANNOUNCED, {"ends_on": retention.ends_on.isoformat(), **_facts(plan)})
        _announce(session, plan, retention.ends_on, base_url)
        return ANNOUNCED
    if today < retention.ends_on or _obstacles(session, project_id, designer_id):
        return None
    retention_queries.mark_deleted(session, retention.studio_id, project_id, designer_id, clock.now())
    retention.deleted_at, retention.ends_on, retention.announced_at = clock.now(), None, None
    _record(session, plan, DELETED, _facts(plan))
    _report(session, plan, base_url)
    return DELETED


def plan_of(session: Session, project_id: UUID, designer_id: UUID) -> Plan:
    """Return the day on which the masters that a designer delivered in a project are due for deletion."""
    signed = _signed(session, project_id, designer_id)
    masters = retention_queries.masters(session, project_id, designer_id)
    named = named_terms(session, signed) if signed else {}
    years = [contract.changed_terms.get(TERM, named[contract.id].get(TERM)) for contract in signed]
    if not signed or any(not isinstance(number, int) for number in years):
        return Plan(signed, masters)
    longest = max(number for number in years if isinstance(number, int))
    if masters.last_delivery_at is None:
        return Plan(signed, masters, longest)
    agreed_on = max(contract.agreed_at.date() for contract in signed if contract.agreed_at)
    ends_on = end_of_masters(masters.last_delivery_at.date(), agreed_on, longest)
    return Plan(signed, masters, longest, ends_on)


def _obstacles(session: Session, project_id: UUID, designer_id: UUID) -> list[str]:
    """Return the reasons for which masters that are due are not deleted yet."""
    contracts = retention_queries.contracts(session, project_id, designer_id)
    return [obstacle for contract in contracts for obstacle in _obstacles_of_contract(session, contract)]


def _obstacles_of_contract(session: Session, contract: Contract) -> list[str]:
    if contract.state is ContractState.SENT:
        return [f"{contract.title} waits for a signature"]
    notice = standing_notice(session, contract.id)
    if contract.state is ContractState.AGREED and notice is not None:
        return [f"the termination of {contract.title} is not settled"]
    book = load_ledger_book(session, contract)
    sums = figures(session, contract, book)
    if sums.open_minor or sums.due_minor or open_tax_minor(book):
        return [f"money is open in {contract.title}"]
    return []


def _read(session: Session, contract: Contract) -> MasterRetentionRead:
    with bypass_row_policies(session):  # other contracts of the two count too, whoever of them reads this one
        plan = plan_of(session, contract.project_id, contract.designer_id)
        obstacles = _obstacles(session, contract.project_id, contract.designer_id) if plan.ends_on else []
        retention = retention_queries.retention(session, contract.project_id, contract.designer_id)
    announced_on = retention.ends_on if retention else None
    kept_by = retention.kept_by if retention else None
    return MasterRetentionRead(
        years=plan.years,
        last_delivery_on=plan.masters.last_delivery_at and plan.masters.last_delivery_at.date(),
        masters=plan.masters.kept,
        ends_on=None if kept_by else max(filter(None, (announced_on, plan.ends_on)), default=None),
        announced_at=retention and retention.announced_at,
        obstacles=obstacles,
        kept_by=session.get_one(Person, kept_by).name if kept_by else None,
        deleted_at=retention and retention.deleted_at,
    )


def _retention(session: Session, contract: Contract) -> MasterRetention:
    """Return the retention of the masters of a contract's designer, locked; add it where there is none."""
    retention = retention_queries.retention(session, contract.project_id, contract.designer_id, locked=True)
    if retention is None:
        retention = MasterRetention(
            project_id=contract.project_id, designer_id=contract.designer_id, studio_id=contract.studio_id
        )
        session.add(retention)
        session.flush()
    return retention


def _signed(session: Session, project_id: UUID, designer_id: UUID) -> list[Contract]:
    contracts = retention_queries.contracts(session, project_id, designer_id)
    return [contract for contract in contracts if contract.state in SIGNED]


def _record(session: Session, plan: Plan, kind: str, facts: dict[str, object]) -> None:
    for contract in plan.contracts:
        record.append(session, contract.id, kind, facts, by=None)


def _facts(plan: Plan) -> dict[str, object]:
    """Return the facts of the record about masters that are deleted: their number, size and retention period."""
    last = plan.masters.last_delivery_at
    return {
        "masters": plan.masters.kept,
        "size_bytes": plan.masters.size_bytes,
        "years": plan.years or 0,
        "last_delivery_on": last.date().isoformat() if last else "",
    }


def _announce(session: Session, plan: Plan, ends_on: date, base_url: str) -> None:
    designer = plan.contracts[0].designer.name
    line = (
        f"{counted(plan.masters.kept, 'master')} that {designer} delivered will be deleted on {day_in_words(ends_on)}: "
        f"the contract has them kept for {counted(plan.years or 0, 'year')} after the last delivery. Download what you "
        "need before. Game files stay. A producer can keep the masters longer on the page of the contract."
    )
    _tell(session, plan, f"masters will be deleted on {day_in_words(ends_on)}", line, base_url)


def _report(session: Session, plan: Plan, base_url: str) -> None:
    designer = plan.contracts[0].designer.name
    line = (
        f"{counted(plan.masters.kept, 'master')} that {designer} delivered were deleted as announced: the contract's "
        "years of keeping them are over. Game files, checks and the record stay."
    )
    _tell(session, plan, "masters were deleted", line, base_url)


def _tell(session: Session, plan: Plan, subject: str, line: str, base_url: str) -> None:
    """Mail both parties, whatever their mail preferences, and add a notice."""
    contract = plan.contracts[-1]
    event_id, path = str(new_id()), f"/projects/{contract.project_id}/contracts/{contract.id}"
    topic, subject = f"contract:masters:{event_id}", f"{contract.project.name}: {subject}"
    recipients = notification_queries.producer_addresses(session, contract.studio_id, contract.project_id)
    recipients |= {notification_queries.address_of(session, contract.designer_id)}
    for recipient in sorted(recipients):
        notices.add(
            session,
            event_id=event_id,
            studio_id=contract.studio_id,
            project_id=contract.project_id,
            topic=topic,
            recipient=recipient,
            subject=subject,
            text=line,
            path=path,
        )
        notifications.write_mail(
            session,
            event_id=event_id,
            studio_id=contract.studio_id,
            project_id=contract.project_id,
            topic=topic,
            recipient=recipient,
            subject=subject,
            lines=[line],
            link=f"{base_url}{path}",
        )
