"""Change orders that are offered: what changed since both signed, until a change order or a dismissal settles it."""

import json
from collections.abc import Sequence

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements.queries import events_of_kinds
from app.agreements.record import service as record
from app.agreements.rules import Party
from app.amendments import queries, schemas
from app.amendments.change_order_review import Reviewer
from app.amendments.errors import OfferSettled
from app.amendments.offer_finding import SETTLING, Found, SettledOffers

DISMISSED, PROPOSED = "offer_dismissed", "change_proposed"


def offers(session: Session, reviewer: Reviewer, party: Party) -> list[schemas.ChangeOfferRead]:
    """Return changes since both signed that no change order says yet, the newest first, as one party reads them."""
    settled = _settled_offers(session, reviewer, party)
    open_offers = sorted(Found(session, reviewer, settled).all(), key=lambda offer: (offer.at, offer.key), reverse=True)
    return [
        schemas.ChangeOfferRead(
            offer=offer.key,
            kind=offer.kind,
            text=offer.text,
            who=offer.who,
            at=offer.at,
            change=offer.change,
            dismissed=settled.dismissed.get(offer.key),
        )
        for offer in open_offers
    ]


def dismiss(session: Session, actor: Actor, reviewer: Reviewer, party: Party, key: str, *, reason: str) -> None:
    """Note for good that a party wants no change order for something; callers hold the contract's lock."""
    offers_by_key = {offer.offer: offer for offer in offers(session, reviewer, party)}
    if key not in offers_by_key:
        raise OfferSettled(
            "this is no longer offered: a change order has it, or your party dismissed it",
            fix="propose a change order yourself where one is needed",
        )
    facts = {"offer": key, "what": offers_by_key[key].text, "reason": reason, "party": party.value}
    record.append(session, reviewer.contract.id, DISMISSED, facts, by=actor.person)


def taken_up(session: Session, reviewer: Reviewer, party: Party, keys: Sequence[str]) -> list[str]:
    """Return those of the named offers that stand; a change order that is proposed settles them."""
    if not keys:
        return []
    open_now = {offer.offer for offer in offers(session, reviewer, party)}
    return [key for key in dict.fromkeys(keys) if key in open_now]


def _settled_offers(session: Session, reviewer: Reviewer, party: Party) -> SettledOffers:
    contract_id = reviewer.contract.id
    settled = SettledOffers(queries.change_orders_of(session, contract_id))
    settling = {order.number for order in settled.orders if order.state in SETTLING}
    for event in events_of_kinds(session, contract_id, {DISMISSED, PROPOSED}):
        facts = json.loads(event.payload)
        if event.kind == PROPOSED:
            settled.settled.update(facts.get("offers", ()) if facts["change_order"] in settling else ())
        elif facts["party"] == party.value:
            settled.settled.add(facts["offer"])
        else:
            settled.dismissed[facts["offer"]] = schemas.OfferDismissed(
                party=Party(facts["party"]), by=facts["by"], at=event.at, reason=facts["reason"]
            )
    return settled
