"""Matters for a party of an agreed contract: change orders to sign, a statement to agree to, changes to propose."""

from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime
from enum import StrEnum

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements.models import Contract
from app.agreements.rules import ORDERS, ContractState, Party
from app.amendments import ending, queries
from app.amendments.change_order_review import Reviewer
from app.amendments.offers import offers
from app.amendments.rules import ChangeOrderState
from app.amendments.signing import signatures


class Amendment(StrEnum):
    """A waiting part of a contract's amendments."""

    CHANGE_ORDER = "change_order"  # for a signature
    STATEMENT = "statement"  # of an early end, for a signature
    OFFERS = "offers"  # what changed, for a change order or a dismissal


@dataclass(frozen=True)
class Waiting:
    """One thing that waits, for the caller or for the other party."""

    what: Amendment
    is_mine: bool
    count: int
    since: datetime


def waiting_amendments(session: Session, actor: Actor, contract: Contract, party: Party) -> Iterator[Waiting]:
    """Yield the waiting matters under a contract that orders work and is in force."""
    if contract.kind not in ORDERS or contract.state is not ContractState.AGREED:
        return
    for order in queries.change_orders_of(session, contract.id):
        if order.state is ChangeOrderState.PROPOSED:
            given = queries.acceptances_of(session, contract.id, order.text_sha256)
            is_mine = signatures(session, contract, given, actor.person, party).is_my_turn
            yield Waiting(Amendment.CHANGE_ORDER, is_mine, 1, order.proposed_at)
    notice = queries.standing_notice(session, contract.id)
    if notice is not None and notice.settled_at is None:
        is_mine = ending.ending(session, actor, contract.id).may.agree
        yield Waiting(Amendment.STATEMENT, is_mine, 1, notice.given_at)
        return  # what changed belongs to the statement now
    open_offers = [offer for offer in offers(session, Reviewer(session, contract), party) if offer.dismissed is None]
    if open_offers:
        yield Waiting(Amendment.OFFERS, True, len(open_offers), open_offers[-1].at)
