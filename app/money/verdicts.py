"""Brings verdicts, rounds, cuts and comments to the contract of their cue, in the same transaction."""

from collections.abc import Collection, Mapping, Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.clauses.deemed_acceptance import CLAUSE as SILENCE
from app.agreements.models import Contract, ContractCue
from app.agreements.plan import queries as plan_queries
from app.agreements.rules import AcceptedBy, WorkState
from app.core.recorded_rows import RowChanges
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.deliveries.signals import WorkDone
from app.money import settlement
from app.reviews import queries
from app.reviews.rules import missing_variations
from app.reviews.signals import CommentWritten, CueCut, CueDecided, RoundCounted, TakeJudged
from app.sound_lists.models import Cue


def record_work(session: Session, work: WorkDone) -> None:
    """Record an event of a designer's work in the contract that covers the cue, if one does."""
    covered = plan_queries.running_cue(session, work.cue_id, {work.designer_id})
    if covered is not None:
        settlement.record_of_cue(
            session, covered, work.kind, work.by, work.facts, on_behalf_of=work.on_behalf_of, rows=work.rows
        )


def record_verdict(session: Session, judged: TakeJudged) -> None:
    """Record a verdict in the contract that covers its cue."""
    verdict, take = judged.verdict, judged.take
    if take.cue_id is None:
        return
    is_deemed = verdict.deemed_by_contract_id is not None
    facts: dict[str, object] = {
        "verdict": verdict.kind.value,
        "variation": take.variation,
        "version": take.number or 0,
        "note": verdict.note,
        "verdict_id": str(verdict.id),
    }
    if verdict.without_listening:
        facts["without_listening"] = True
    if is_deemed:
        facts["clause"] = SILENCE
    by = None if is_deemed else verdict.given_by
    rows = RowChanges().add(verdict, take, *judged.sent_with)
    record_work(session, WorkDone(take.cue_id, take.designer_id, "judged", facts, by, verdict.on_behalf_of, rows))


def record_comment(session: Session, written: CommentWritten) -> None:
    """Record a comment in the contract that covers its cue."""
    comment, take = written.comment, written.take
    if take.cue_id is None:
        return
    facts: dict[str, object] = {"variation": take.variation, "version": take.number or 0}
    facts |= {"comment_id": str(comment.id), "text": comment.text}
    if comment.guest_name is not None:
        facts["guest"] = comment.guest_name
    rows = RowChanges().add(comment)
    record_work(session, WorkDone(take.cue_id, take.designer_id, "commented", facts, comment.written_by, rows=rows))


def settle_decision(session: Session, decided: CueDecided) -> None:
    """Make the share of an accepted cue due, or take it back."""
    if not decided.is_accepted:
        settlement.reopen_cue(session, decided.cue.id, person_id=decided.person_id)
        return
    settlement.accept_cue(
        session,
        decided.cue.id,
        designer_ids={take.designer_id for take in decided.approved},
        person_id=decided.person_id,
        rows=_rows_of(session, decided.approved),
        by=AcceptedBy.SILENCE if decided.is_deemed else AcceptedBy.VERDICT,
    )


def _rows_of(session: Session, approved: Sequence[Take]) -> RowChanges:
    """Return the takes that a cue is accepted by, and their verdicts, for the record."""
    return RowChanges().add(*approved, *queries.effective_verdicts(session, [take.id for take in approved]))


def price_round(session: Session, counted: RoundCounted) -> None:
    """Propose the price of a counted round."""
    settlement.price_round(session, counted.cue_id, number=counted.number, person_id=counted.person_id)


def settle_cut(session: Session, cut: CueCut) -> None:
    """Settle a cut cue under the contract that covers it, by how far its designer's work is."""
    covered = plan_queries.running_cue(session, cut.cue.id, None)
    if covered is not None:
        states = work_states(session, session.get_one(Contract, covered.contract_id), [covered])
        settlement.settle_cut(session, cut.cue.id, state=states[cut.cue.id], person_id=cut.person_id)


def add_accepted_cue(session: Session, contract_id: UUID, cue_id: UUID) -> None:
    """Settle a cue that was accepted before its contract was agreed, in the name of who approved it, if anyone did."""
    queries.lock_cue(session, cue_id)
    cue, contract = session.get_one(Cue, cue_id), session.get_one(Contract, contract_id)
    approved = queries.approved_takes(session, cue_id)
    if missing_variations(cue.variations, [take.variation for take in approved]):
        return
    if contract.designer_id in {take.designer_id for take in approved}:
        verdicts = queries.effective_verdicts(session, [take.id for take in approved])
        if any(verdict.adoption_id is not None for verdict in verdicts):
            return  # it was in the game before anyone was asked to make it
        person_id = verdicts[-1].given_by if verdicts else contract.created_by
        rows = RowChanges().add(*approved, *verdicts)
        settlement.add_accepted_cue(session, contract_id, cue_id, person_id=person_id, rows=rows)


def work_states(session: Session, contract: Contract, covered: Sequence[ContractCue]) -> dict[UUID, WorkState]:
    """Return the state of the work of a contract's own designer on cues that it covers, as kill fees go by it."""
    states = queries.variation_states(session, [contract_cue.cue_id for contract_cue in covered], contract.designer_id)
    states_by_cue = {
        contract_cue.cue_id: work_state(contract_cue.cue.variations, states[contract_cue.cue_id])
        for contract_cue in covered
    }
    for cue_id, state in states_by_cue.items():
        if state is WorkState.ACCEPTED and plan_queries.is_accepted_elsewhere(session, contract.id, cue_id):
            states_by_cue[cue_id] = WorkState.NOT_BEGUN  # it was paid for there
    return states_by_cue


def work_state(variations: int, states: Mapping[int, Collection[TakeState]]) -> WorkState:
    """Return the state of the work on a cue, from the states of each variation's takes.

    A file that the checks returned shows work, and is not delivered yet; one that a change was asked of is work again.
    """
    if not any(states.values()):
        return WorkState.NOT_BEGUN
    takes_of_each = [states.get(variation, ()) for variation in range(1, variations + 1)]
    if all(TakeState.APPROVED in take_states for take_states in takes_of_each):
        return WorkState.ACCEPTED
    if all({TakeState.APPROVED, TakeState.CONFORMING} & set(take_states) for take_states in takes_of_each):
        return WorkState.DELIVERED
    return WorkState.IN_WORK
