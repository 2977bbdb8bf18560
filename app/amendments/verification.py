"""A contract's tables held against its record: what was altered, taken out or put in by hand is named."""

import json
from collections import defaultdict
from collections.abc import Iterator, Sequence
from typing import Any

from sqlalchemy.orm import Session

from app.agreements import record
from app.agreements.documents import sha256_of
from app.agreements.drawn_names import drawing_sha256
from app.agreements.models import Contract, ContractAcceptance
from app.agreements.queries import events_of, every_contract, versions_of
from app.agreements.redline_rules import faults_of_sent
from app.agreements.redlines import rounds, texts_of
from app.agreements.rules import ContractState
from app.agreements.signing_rules import BY_CODE
from app.amendments import queries
from app.amendments.models import AmendmentAcceptance
from app.amendments.rules import ChangeOrderState
from app.amendments.work_verification import work_faults
from app.kit.storage import Store
from app.money import queries as money_queries

Said = tuple[str, dict[str, Any]]  # kind and payload of an entry
# The state that a contract has after an entry of the record.
STATE_AFTER = {
    "sent": ContractState.SENT,
    "taken_back": ContractState.DRAFT,
    "change_requested": ContractState.DRAFT,
    "redlines_proposed": ContractState.DRAFT,
    "agreed": ContractState.AGREED,
    "ended": ContractState.ENDED,
}
ORDER_STATE_AFTER = {
    "change_proposed": ChangeOrderState.PROPOSED,
    "changed": ChangeOrderState.AGREED,
    "change_refused": ChangeOrderState.REFUSED,
    "change_withdrawn": ChangeOrderState.WITHDRAWN,
    "change_lapsed": ChangeOrderState.LAPSED,
}


def faults_of_all(session: Session, store: Store) -> Iterator[tuple[Contract, list[str]]]:
    """Yield every contract of every studio with what is wrong with it."""
    for contract in every_contract(session):
        yield contract, faults_of(session, store, contract)


def faults_of(session: Session, store: Store, contract: Contract) -> list[str]:
    """Return what is wrong with the record, the texts and the tables of a contract.

    Tables are held against a record that is whole; where it is not, that is what has to be looked into first.
    """
    of_record = list(record.faults_of(session, contract))
    of_tables = [] if of_record else _table_faults_or_why_not(session, contract)
    return [*of_record, *record.text_faults(session, store, contract), *of_tables]


def _table_faults_or_why_not(session: Session, contract: Contract) -> list[str]:
    """Return the faults of tables; of a record that was rewritten with entries of another form, what they lack."""
    try:
        return list(table_faults(session, contract))
    except (KeyError, TypeError, ValueError) as error:
        return [f"an entry of the record has another form than this software writes: {error!r}"]


def table_faults(session: Session, contract: Contract) -> Iterator[str]:
    """Yield, in words, where the tables of a contract are not what its record says."""
    events = events_of(session, contract.id)
    said: list[Said] = [(event.kind, json.loads(event.payload)) for event in events]
    yield from _state(contract, said)
    yield from _shipped(contract, said)
    yield from _changed_terms(contract, said)
    yield from _sent(session, contract, said)
    yield from faults_of_sent(rounds(session, contract), texts_of(session, contract))
    yield from _acceptances(session, contract, said)
    yield from _ledger(session, contract, said)
    yield from _worked_days(session, contract, said)
    yield from _payments(session, contract, said)
    yield from _change_orders(session, contract, said)
    yield from _notices(session, contract, said)
    yield from work_faults(session, contract, events)


def _state(contract: Contract, said: Sequence[Said]) -> Iterator[str]:
    states = [STATE_AFTER[kind] for kind, _ in said if kind in STATE_AFTER]
    recorded = states[-1] if states else ContractState.DRAFT
    if contract.state is not recorded:
        yield f"the contract is {contract.state}, and the record says {recorded}"
    reasons = [payload["reason"] for kind, payload in said if kind == "ended"]
    if reasons and contract.end_reason != reasons[-1]:
        yield "the reason of its end is another one in the record"


def _shipped(contract: Contract, said: Sequence[Said]) -> Iterator[str]:
    recorded = next((payload["shipped_on"] for kind, payload in said if kind == "shipped"), "no day")
    stored = contract.game_shipped_on.isoformat() if contract.game_shipped_on else "no day"
    if stored != recorded:
        yield f"the game shipped on {stored}, and the record says {recorded}"


def _changed_terms(contract: Contract, said: Sequence[Said]) -> Iterator[str]:
    recorded: dict[str, Any] = {}
    for kind, payload in said:
        if kind == "changed":
            recorded |= payload.get("terms", {})
    yield from (
        f"the term {name} is {contract.changed_terms.get(name, 'as signed')} by change orders, "
        f"and the record says {recorded.get(name, 'as signed')}"
        for name in sorted(recorded.keys() | contract.changed_terms.keys())
        if recorded.get(name) != contract.changed_terms.get(name)
    )


def _sent(session: Session, contract: Contract, said: Sequence[Said]) -> Iterator[str]:
    recorded = {payload["version"] for kind, payload in said if kind == "sent"}
    there = {version.number for version in versions_of(session, contract.id)}
    sent = {version.number for version in versions_of(session, contract.id) if version.sent_at is not None}
    for number in sorted(sent - recorded):
        yield f"version {number} was sent, and no entry says so"
    for number in sorted(recorded - there):
        yield f"version {number} of the record is missing"


def _acceptances(session: Session, contract: Contract, said: Sequence[Said]) -> Iterator[str]:
    numbers = {version.id: str(version.number) for version in versions_of(session, contract.id)}
    given = {
        (f"version {numbers.get(one.version_id, '?')}", *_signed_with(one)): drawing_sha256(one.drawing)
        for one in queries.contract_acceptances_of(session, contract.id)
    } | {
        (one.text_sha256, *_signed_with(one)): drawing_sha256(one.drawing)
        for one in queries.all_acceptances_of(session, contract.id)
    }
    recorded = {
        (
            f"version {payload['version']}" if kind == "accepted_by" else payload["text_sha256_of_amendment"],
            *(payload[name] for name in ("party", "name", "email", "address")),
            payload.get("agent", ""),  # entries of before have neither browser nor code
            payload.get("code") == BY_CODE,
        ): payload.get("drawing_sha256", "")
        for kind, payload in said
        if kind in ("accepted_by", "change_accepted", "statement_accepted")
    }
    for what, party, *_ in sorted(recorded.keys() - given.keys()):
        yield f"the acceptance of {what} by the {party} is missing or was altered"
    for what, party, *_ in sorted(given.keys() - recorded.keys()):
        yield f"the acceptance of {what} by the {party} is in no entry"
    for one in sorted(given.keys() & recorded.keys()):
        if given[one] != recorded[one]:
            yield f"the drawn name in the acceptance of {one[0]} by the {one[1]} is not the one in the record"


def _signed_with(one: ContractAcceptance | AmendmentAcceptance) -> tuple[str, str, str, str, str, bool]:
    return one.party.value, one.name, one.email, one.address, one.agent, one.code_entered_at is not None


def _ledger(session: Session, contract: Contract, said: Sequence[Said]) -> Iterator[str]:
    recorded = {
        payload["line"]: (payload["because"], payload["amount_minor"], payload["clause"])
        for _, payload in said
        if "line" in payload
    }
    lines = {
        str(line.id): (line.kind.value, line.amount_minor, line.clause)
        for line, _ in money_queries.ledger_of(session, contract.id)
    }
    for line_id in sorted(recorded.keys() | lines.keys()):
        if line_id not in lines:
            yield f"ledger line {line_id} of the record is missing"
        elif line_id not in recorded:
            yield f"ledger line {line_id} is in no entry"
        elif recorded[line_id] != lines[line_id]:
            yield f"ledger line {line_id} was altered"


def _worked_days(session: Session, contract: Contract, said: Sequence[Said]) -> Iterator[str]:
    """Yield logged work whose agreement is another one in the record; days of before have no entry of their own."""
    recorded = {
        payload["worked_day"]: (payload["worked_on"], payload.get("quarters"), payload.get("minutes"))
        for kind, payload in said
        if kind == "work_agreed"
    }
    logged = {
        str(one.id): (one.worked_on.isoformat(), one.quarters, one.minutes)
        for one in money_queries.worked_days_of(session, contract.id)
        if one.agreed_at is not None
    }
    for day_id in sorted(recorded.keys() | logged.keys()):
        if day_id not in logged:
            yield f"agreed work {day_id} of the record is missing"
        elif day_id not in recorded and logged[day_id][2] is not None:
            yield f"agreed work {day_id} is in no entry"
        elif day_id in recorded and recorded[day_id] != logged[day_id]:
            yield f"agreed work {day_id} was altered"


def _payments(session: Session, contract: Contract, said: Sequence[Said]) -> Iterator[str]:
    recorded: dict[str, int] = defaultdict(int)
    for kind, payload in said:
        if kind in ("paid", "refunded") and "payment" in payload:
            recorded[payload["payment"]] += payload["amount_minor"]
    payments = {str(one.id): one.amount_minor for one in money_queries.payments_of(session, contract.id)}
    for payment_id in sorted(recorded.keys() | payments.keys()):
        if payment_id not in payments:
            yield f"payment {payment_id} of the record is missing"
        elif payment_id not in recorded:
            yield f"payment {payment_id} is in no entry"
        elif recorded[payment_id] != payments[payment_id]:
            yield f"payment {payment_id} was altered"


def _change_orders(session: Session, contract: Contract, said: Sequence[Said]) -> Iterator[str]:
    recorded: dict[int, tuple[str, ChangeOrderState]] = {}
    for kind, payload in said:
        if kind in ORDER_STATE_AFTER:
            number = payload["change_order"]
            text_sha256 = payload.get("text_sha256_of_amendment") or recorded.get(number, ("",))[0]
            recorded[number] = text_sha256, ORDER_STATE_AFTER[kind]
    orders = {one.number: one for one in queries.change_orders_of(session, contract.id)}
    for number in sorted(recorded.keys() | orders.keys()):
        if number not in orders:
            yield f"change order {number} of the record is missing"
        elif number not in recorded:
            yield f"change order {number} is in no entry"
        elif sha256_of(orders[number].text) != recorded[number][0]:
            yield f"the text of change order {number} was altered"
        elif orders[number].state is not recorded[number][1]:
            yield f"change order {number} is {orders[number].state}, and the record says {recorded[number][1]}"


def _notices(session: Session, contract: Contract, said: Sequence[Said]) -> Iterator[str]:
    given = {payload["notice"]: payload for kind, payload in said if kind == "notice_given"}
    settled = {payload["notice"]: payload["text_sha256_of_amendment"] for kind, payload in said if kind == "settled"}
    notices = {one.number: one for one in queries.notices_of(session, contract.id)}
    for number in sorted(given.keys() | notices.keys()):
        notice = notices.get(number)
        if notice is None:
            yield f"notice {number} of the record is missing"
        elif number not in given:
            yield f"notice {number} is in no entry"
        elif (notice.ends_on.isoformat() if notice.ends_on else "", notice.reason) != (
            given[number]["ends_on"],
            given[number]["reason"],
        ):
            yield f"notice {number} was altered"
        elif (sha256_of(notice.statement) if notice.statement else None) != settled.get(number):
            yield f"the settlement statement of notice {number} was altered"
