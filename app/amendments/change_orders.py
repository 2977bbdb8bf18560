"""Change orders: proposed by either party, read as a difference, and in force when both have accepted the text."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import Actor
from app.agreements.access import party_of, visible_contract
from app.agreements.clauses.figures import prose_errors
from app.agreements.clauses.text import blocks_of
from app.agreements.deemed_acceptance.clock_pauses import begin_pause, end_pause
from app.agreements.drafts.documents import TextPdf, sha256_of
from app.agreements.errors import NotYourContract
from app.agreements.models import Contract
from app.agreements.plan import queries as plan_queries
from app.agreements.queries import newest_version
from app.agreements.record import service as record
from app.agreements.rules import ORDERS, ContractKind, ContractState, Party, next_action_hint
from app.agreements.schemas import BlockRead
from app.agreements.signing.certificates import signatures_page, studio_zone
from app.agreements.signing.service import SignatureRequest
from app.amendments import offers, queries, schemas
from app.amendments.agreed_changes import apply
from app.amendments.change_order_review import Review, Reviewer
from app.amendments.change_order_text import change_order_text, change_order_title
from app.amendments.errors import (
    BadChangeOrder,
    ChangeOrderClosed,
    ChangeOrderNotFound,
    ChangeOrderStale,
    NotInForce,
    NotOwnChangeOrder,
    OwnChangeOrder,
)
from app.amendments.models import ChangeOrder
from app.amendments.rules import ChangeOrderState
from app.amendments.signing import locked_for_party, sign, signatures
from app.core import clock
from app.core.errors import FieldProblem
from app.core.events import publish
from app.money import overview
from app.sound_lists.rules import CueState


def change_orders(session: Session, actor: Actor, contract_id: UUID) -> schemas.ChangeOrdersRead:
    """Return the change orders of a contract, and the milestones and cues that one may name."""
    contract = visible_contract(session, actor, contract_id)
    reviewer, party = Reviewer(session, contract), party_of(actor, contract)
    in_force = contract.kind in ORDERS and contract.state is ContractState.AGREED
    listed_cue_ids = [cue.id for cue in reviewer.listed.values() if cue.state is not CueState.CUT]
    elsewhere = {name for name, _ in plan_queries.covered_elsewhere(session, contract.id, listed_cue_ids)}
    return schemas.ChangeOrdersRead(
        project_id=contract.project_id,
        contract_id=contract.id,
        title=contract.title,
        currency=contract.currency,
        my_party=party,
        may_propose=in_force and party is not None,
        extra_round_bp=reviewer.terms.extra_round_bp,
        orders=[
            _read(session, reviewer, change_order, actor, party)
            for change_order in queries.change_orders_of(session, contract.id)
        ],
        offers=offers.offers(session, reviewer, party) if in_force and party is not None else [],
        milestones=[
            schemas.OrderMilestone(id=milestone.id, name=milestone.name, due_on=milestone.due_on)
            for milestone in reviewer.milestones.values()
            if not milestone.is_deposit and not reviewer.is_done(milestone.id)
        ],
        cues=[
            schemas.OrderCue(
                cue=overview.brief(contract_cue.cue, reviewer.prefix),
                price_minor=contract_cue.amount_minor or 0,
                round_minor=reviewer.round_minor(contract_cue),
            )
            for contract_cue in reviewer.covered.values()
            if contract_cue.accepted_at is None and contract_cue.cut_at is None
        ],
        caps=reviewer.caps.read(),
        cues_to_add=[
            overview.brief(cue, reviewer.prefix)
            for cue in reviewer.listed.values()
            if cue.state is not CueState.CUT and cue.id not in reviewer.covered and cue.name not in elsewhere
        ],
    )


def preview(
    session: Session, actor: Actor, contract_id: UUID, changes: Sequence[schemas.Change]
) -> schemas.ChangePreview:
    """Return the effects of changes, and their faults; nothing is saved."""
    contract = visible_contract(session, actor, contract_id)
    party = party_of(actor, contract)
    if party is None:
        raise NotYourContract("only a producer of the studio and the contract's designer change it")
    _ensure_in_force(contract, party)
    review = Reviewer(session, contract).review(changes)
    return schemas.ChangePreview(difference=review.difference, problems=review.problems)


def propose(session: Session, actor: Actor, contract_id: UUID, order: schemas.ChangeOrderAdd) -> ChangeOrder:
    """Put a change order before both parties; raise BadChangeOrder with every problem that it has."""
    contract, party = locked_for_party(session, actor, contract_id)
    _ensure_in_force(contract, party)
    reviewer = Reviewer(session, contract)
    review = reviewer.review(order.changes)
    of_reason = list(prose_errors(order.reason, plan_queries.agreed_terms(session, contract)))
    if review.problems or of_reason:
        raise BadChangeOrder(
            "; ".join([*review.problems, *of_reason][:5]),
            errors=[
                *[FieldProblem(where="changes", message=problem) for problem in review.problems],
                *[FieldProblem(where="reason", message=problem) for problem in of_reason],
            ],
            fix="change what the message names, and propose it again",
        )
    proposed = ChangeOrder(
        studio_id=contract.studio_id,
        project_id=contract.project_id,
        contract_id=contract.id,
        number=queries.next_change_order_number(session, contract.id),
        party=party,
        proposed_by=actor.person,
        proposed_at=clock.now(),
        reason=order.reason,
        begins_at_once=order.begins_at_once,
        changes=schemas.CHANGES.dump_python(list(order.changes), mode="json"),
        text="",
        text_sha256="",
        proposer=session.get_one(Person, actor.person),
    )
    proposed.text = _text(reviewer, proposed, review)
    proposed.text_sha256 = sha256_of(proposed.text)
    taken_up = offers.taken_up(session, reviewer, party, order.offers)
    session.add(proposed)
    session.flush()
    facts = {
        "change_order": proposed.number,
        "changes": review.difference.changes if review.difference else [],
        "reason": proposed.reason,
        "text_sha256_of_amendment": proposed.text_sha256,
        "begins": "before both agree, at the proposer's risk" if proposed.begins_at_once else "when both agree",
        **({"offers": taken_up} if taken_up else {}),
    }
    begin_pause(session, contract, proposed.number)
    record.append(session, contract.id, "change_proposed", facts, by=actor.person)
    publish(session, "change_order.proposed", studio_id=contract.studio_id, contract_id=contract.id, party=party.value)
    return proposed


def dismiss_offer(session: Session, actor: Actor, contract_id: UUID, offer: str, *, reason: str) -> None:
    """Note that the caller's party wants no change order for something that changed since both signed."""
    contract, party = locked_for_party(session, actor, contract_id)
    _ensure_in_force(contract, party)
    offers.dismiss(session, actor, Reviewer(session, contract), party, offer, reason=reason)


def accept(
    session: Session,
    actor: Actor,
    contract_id: UUID,
    number: int,
    signature: SignatureRequest,
) -> None:
    """Say yes to a change order for the caller's party; with the last yes it is in force.

    Raises ChangeOrderStale where what it changes has changed since.
    """
    contract, party = locked_for_party(session, actor, contract_id)
    order = _open(session, contract, number)
    reviewer = Reviewer(session, contract)
    review = reviewer.review(schemas.CHANGES.validate_python(order.changes))
    if review.problems or _text(reviewer, order, review) != order.text:
        why = review.problems[0] if review.problems else "the plan that it changes is another one now"
        raise ChangeOrderStale(
            f"this change order no longer fits: {why}",
            fix="the party that proposed it withdraws it and proposes another, the other party refuses it",
        )
    have_all_signed = sign(
        session,
        actor,
        contract,
        party,
        kind="change_accepted",
        facts={"change_order": number},
        text_sha256=order.text_sha256,
        signature=signature,
    )
    if have_all_signed:
        apply(session, reviewer, order, review, person_id=actor.person)


def refuse(session: Session, actor: Actor, contract_id: UUID, number: int, *, reason: str) -> None:
    """Refuse a change order, as the party that did not propose it."""
    contract, party = locked_for_party(session, actor, contract_id)
    order = _open(session, contract, number)
    if order.party is party:
        raise OwnChangeOrder("your party proposed this change order", fix="withdraw it; the other party can refuse it")
    _close(session, order, ChangeOrderState.REFUSED, reason, by=actor.person)


def withdraw(session: Session, actor: Actor, contract_id: UUID, number: int, *, reason: str) -> None:
    """Take a change order back, as the party that proposed it."""
    contract, party = locked_for_party(session, actor, contract_id)
    order = _open(session, contract, number)
    if order.party is not party:
        raise NotOwnChangeOrder(f"the {order.party} proposed this change order", fix="refuse it")
    _close(session, order, ChangeOrderState.WITHDRAWN, reason, by=actor.person)


def change_order_pdf(session: Session, actor: Actor, contract_id: UUID, number: int) -> TextPdf:
    """Return the text of a change order as PDF, with its signatures."""
    contract = visible_contract(session, actor, contract_id)
    order = _known(session, contract, number)
    given = queries.acceptances_of(session, contract.id, order.text_sha256)
    signed = signatures_page(given, order.text_sha256, studio_zone(contract))
    return TextPdf.of(change_order_title(order.number, contract.title), order.text, signed)


def _close(session: Session, order: ChangeOrder, state: ChangeOrderState, reason: str, *, by: UUID | None) -> None:
    order.state, order.closed_at, order.close_reason = state, clock.now(), reason
    session.flush()
    facts = {"change_order": order.number, "reason": reason}
    end_pause(session, session.get_one(Contract, order.contract_id), order.number)
    record.append(session, order.contract_id, f"change_{state.value}", facts, by=by)


def _known(session: Session, contract: Contract, number: int) -> ChangeOrder:
    order = queries.change_order_by_number(session, contract.id, number)
    if order is None:
        raise ChangeOrderNotFound(f"this contract has no change order {number}")
    return order


def _open(session: Session, contract: Contract, number: int) -> ChangeOrder:
    order = _known(session, contract, number)
    if order.state is not ChangeOrderState.PROPOSED:
        in_force = contract.state is ContractState.AGREED
        raise ChangeOrderClosed(
            f"change order {number} has {order.state} already"
            if order.state is ChangeOrderState.LAPSED
            else f"change order {number} was {order.state} already",
            fix="propose another one" if in_force else next_action_hint(contract.state, contract.kind),
        )
    return order


def _ensure_in_force(contract: Contract, party: Party) -> None:
    if contract.kind not in ORDERS:
        is_running = contract.kind is ContractKind.FRAMEWORK and contract.state is ContractState.AGREED
        raise NotInForce(
            "this contract orders no work, so no change order can change it",
            fix="propose it to the batch that has the cues"
            if is_running
            else next_action_hint(contract.state, contract.kind, party),
        )
    if contract.state is not ContractState.AGREED:
        is_ended = contract.state is ContractState.ENDED
        raise NotInForce(
            "this contract has ended" if is_ended else "this contract is not signed by both yet",
            fix=next_action_hint(contract.state, contract.kind, party),
        )


def _text(reviewer: Reviewer, order: ChangeOrder, review: Review) -> str:
    contract, difference = reviewer.contract, review.difference
    version = newest_version(reviewer.session, contract.id)
    return change_order_text(
        number=order.number,
        title=contract.title,
        agreed_at=contract.agreed_at,
        contract_sha256=version.text_sha256 if version else "",
        studio=contract.project.studio.name,
        designer=contract.designer.name,
        party=order.party,
        proposed_by=order.proposer.name,
        proposed_on=order.proposed_at.date(),
        reason=order.reason,
        begins_at_once=order.begins_at_once,
        changes=difference.changes if difference else [],
        milestones=difference.milestones if difference else [],
        currency=contract.currency,
    )


def _read(
    session: Session, reviewer: Reviewer, order: ChangeOrder, actor: Actor, party: Party | None
) -> schemas.ChangeOrderRead:
    is_open = order.state is ChangeOrderState.PROPOSED
    review = reviewer.review(schemas.CHANGES.validate_python(order.changes)) if is_open else Review()
    given = queries.acceptances_of(session, reviewer.contract.id, order.text_sha256)
    is_party = is_open and party is not None
    standing = signatures(session, reviewer.contract, given, actor.person_id, party)
    return schemas.ChangeOrderRead(
        number=order.number,
        state=order.state,
        party=order.party,
        proposed_by=order.proposer.name,
        proposed_at=order.proposed_at,
        reason=order.reason,
        begins_at_once=order.begins_at_once,
        closed_at=order.closed_at,
        close_reason=order.close_reason,
        text_sha256=order.text_sha256,
        blocks=[BlockRead.model_validate(block) for block in blocks_of(order.text)],
        difference=review.difference,
        problems=review.problems,
        signed=[schemas.SignedRead.model_validate(signature) for signature in given],
        signatures_needed=standing.needed,
        may=schemas.ChangeOrderMay(
            agree=is_party and not review.problems and standing.is_my_turn,
            refuse=is_party and party is not order.party,
            withdraw=is_party and party is order.party,
        ),
    )


def lapse_open(session: Session, contract: Contract) -> None:
    """Close open proposals when a contract ends; callers hold its lock."""
    for order in queries.change_orders_of(session, contract.id):
        if order.state is ChangeOrderState.PROPOSED:
            _close(session, order, ChangeOrderState.LAPSED, "the contract ended", by=None)
