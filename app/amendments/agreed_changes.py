"""The effects of a change order on a contract once both have accepted it."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.deemed_acceptance.clock_pauses import end_pause
from app.agreements.models import ContractCue
from app.agreements.plan.service import record_plan
from app.agreements.record import service as record
from app.amendments import schemas
from app.amendments.change_order_review import Review, Reviewer
from app.amendments.models import ChangeOrder
from app.amendments.rules import ChangeOrderState
from app.amendments.work import work_states
from app.core import clock
from app.core.events import publish
from app.money import queries as money_queries
from app.money.ledger.book import CLAUSES, Entry
from app.money.ledger.rules import LineKind
from app.money.ledger.service import write
from app.money.settlement import add_round, cancel_cue, charge_round, settle
from app.reviews.queries import round_counts

PLANNED = ("add_cue", "reprice_cue", "move_date")  # what milestones and prices follow


def apply(session: Session, reviewer: Reviewer, order: ChangeOrder, review: Review, *, person_id: UUID) -> None:
    """Put an accepted change order in force: plan, price and ledger follow it."""
    contract = reviewer.contract
    order.state, order.closed_at = ChangeOrderState.AGREED, clock.now()
    session.flush()
    changes = schemas.CHANGES.validate_python(order.changes)
    terms = {
        name: cap for set_change in changes if set_change.kind == "set_caps" for name, cap in set_change.terms.items()
    }
    contract.changed_terms = contract.changed_terms | terms
    facts = {
        "change_order": order.number,
        "changes": review.difference.changes if review.difference else [],
        "text_sha256_of_amendment": order.text_sha256,
        **({"terms": terms} if terms else {}),
    }
    record.append(session, contract.id, "changed", facts, by=person_id)
    end_pause(session, contract, order.number)
    states = work_states(session, contract)
    position = max((contract_cue.position for contract_cue in reviewer.covered.values()), default=0)
    entries: list[Entry] = []
    for change in changes:
        match change.kind:
            case "add_cue":
                position += 1
                reviewer.milestones[change.milestone_id].amount_minor += change.price_minor
                session.add(
                    ContractCue(
                        studio_id=contract.studio_id,
                        project_id=contract.project_id,
                        contract_id=contract.id,
                        milestone_id=change.milestone_id,
                        cue_id=change.cue_id,
                        position=position,
                        price_minor=change.price_minor,
                        amount_minor=change.price_minor,
                        estimate_min=change.estimate_min,
                    )
                )
            case "cut_cue":
                cancel_cue(session, reviewer.covered[change.cue_id], state=states[change.cue_id], person_id=person_id)
            case "reprice_cue":
                covered = reviewer.covered[change.cue_id]
                milestone = reviewer.milestones[covered.milestone_id]
                milestone.amount_minor += change.price_minor - (covered.amount_minor or 0)
                covered.price_minor = covered.amount_minor = change.price_minor
            case "add_round":
                _agree_round(session, reviewer, change.cue_id, person_id=person_id)
            case "move_date":
                reviewer.milestones[change.milestone_id].due_on = change.due_on
            case "add_work":
                kind = LineKind.EXTRA_WORK
                entries.append(Entry(kind, change.amount_minor, CLAUSES[kind], milestone_id=change.milestone_id))
    session.flush()
    if any(change.kind in PLANNED for change in changes):
        record_plan(session, contract, person_id=person_id)
    write(session, contract, entries, person_id=person_id)
    settle(session, contract.id, person_id)
    publish(session, "change_order.agreed", studio_id=contract.studio_id, contract_id=contract.id)


def _agree_round(session: Session, reviewer: Reviewer, cue_id: UUID, *, person_id: UUID) -> None:
    """Agree to a cue's next round: the one that was proposed, else the one after those included and counted."""
    contract = reviewer.contract
    proposed_rounds = [
        extra_round
        for extra_round in money_queries.extra_rounds_of(session, contract.id)
        if extra_round.cue_id == cue_id
    ]
    proposed = next(
        (round_ for round_ in proposed_rounds if round_.agreed_at is None and round_.dropped_at is None), None
    )
    if proposed is None:
        counted = round_counts(session, [cue_id]).get(cue_id, 0)
        number = max([reviewer.terms.rounds_included, counted, *(round_.number for round_ in proposed_rounds)]) + 1
        proposed = add_round(session, contract, cue_id, number=number, person_id=person_id)
    charge_round(session, contract, proposed, person_id=person_id)
