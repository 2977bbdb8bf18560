"""Effects of acceptance, cuts and rounds on money; called in the transaction of the verdict or cut itself."""

from collections.abc import Collection, Mapping
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import Actor, Role, SecondFactorUse
from app.accounts.second_factors.requirements import ensure_second_factor_for
from app.agreements.clauses.deemed_acceptance import CLAUSE as SILENCE
from app.agreements.clauses.terms import DepositAtEnd
from app.agreements.models import Contract, ContractCue
from app.agreements.plan import queries as plan_queries
from app.agreements.plan.queries import terms_of
from app.agreements.queries import contract_for, lock_contract
from app.agreements.record import service as record
from app.agreements.rules import AcceptedBy, ContractState, WorkState
from app.core import clock
from app.core.recorded_rows import RowChanges
from app.money import queries
from app.money.bonuses.rules import BonusState
from app.money.bonuses.service import bonus_status
from app.money.ending import Statement, statement_of
from app.money.errors import ExtraRoundNotFound, OtherPartyNeeded, RoundAlreadySettled
from app.money.ledger.book import CLAUSES, Entry, PricedCue, price_of_round, settle_bonus, settle_shares
from app.money.ledger.rules import LineKind
from app.money.ledger.service import cue_label, load_ledger_book, priced, rules_of, write
from app.money.models import ExtraRound
from app.money.work.service import mark_agreed
from app.money.work.worked_hours import HourBook
from app.projects.errors import ProducerNeeded
from app.projects.models import Project


def accept_cue(
    session: Session,
    cue_id: UUID,
    *,
    designer_ids: Collection[UUID],
    person_id: UUID | None,
    rows: RowChanges,
    by: AcceptedBy = AcceptedBy.VERDICT,
) -> None:
    """Make a cue's share due by the release clause, now that every variation is approved.

    Without an agreed contract of one of the takes' designers nothing is owed; accepting twice is accepting once.
    `rows` are the takes that were approved, and their verdicts.
    """
    covered = _locked(session, cue_id, designer_ids)
    if covered is None or covered.accepted_at is not None or covered.cut_at is not None:
        return
    covered.accepted_at, covered.accepted_by = clock.now(), by
    by_clause = by is AcceptedBy.SILENCE
    facts = {"clause": SILENCE} if by_clause else {}
    record_of_cue(session, covered, "accepted", None if by_clause else person_id, facts, rows=rows)
    settle(session, covered.contract_id, person_id, is_by_server=by_clause)


def add_accepted_cue(
    session: Session, contract_id: UUID, cue_id: UUID, *, person_id: UUID | None, rows: RowChanges
) -> None:
    """Take a cue that was approved before into its contract, which is agreed; what was accepted anywhere stays there.

    `person_id` is who had approved it; None: nobody, by a clause on silence. Adopting twice is adopting once.
    `rows` are the takes that were approved, and their verdicts.
    """
    contract = lock_contract(session, contract_id)
    covered = plan_queries.cue_of(session, contract_id, cue_id)
    if covered is None or covered.accepted_at is not None or covered.cut_at is not None or contract.agreed_at is None:
        return
    if contract.state is not ContractState.AGREED or plan_queries.is_accepted_elsewhere(session, contract_id, cue_id):
        return
    covered.accepted_at, covered.accepted_by = contract.agreed_at, AcceptedBy.ADOPTION
    approved_by = session.get_one(Person, person_id).name if person_id else f"the clause {SILENCE}"
    record_of_cue(session, covered, "adopted", None, {"approved_by": approved_by}, rows=rows)
    settle(session, contract_id, person_id, is_by_server=True)


def reopen_cue(session: Session, cue_id: UUID, *, person_id: UUID | None) -> None:
    """Take a cue's share back by a reversing line, where a verdict was reversed or undone."""
    covered = _locked(session, cue_id, None)
    if covered is None or covered.accepted_at is None or covered.cut_at is not None:
        return
    covered.accepted_at = covered.accepted_by = None
    record_of_cue(session, covered, "reopened", person_id)
    settle(session, covered.contract_id, person_id)


def settle_cut(session: Session, cue_id: UUID, *, state: WorkState, person_id: UUID) -> None:
    """Settle a cut cue by the kill fee of the state that the work was in."""
    covered = _locked(session, cue_id, None)
    if covered is not None and covered.cut_at is None:
        _cut(session, covered, state, person_id)
        settle(session, covered.contract_id, person_id)


def cancel_cue(session: Session, covered: ContractCue, *, state: WorkState, person_id: UUID) -> None:
    """Count a cue as cut under its contract alone; callers hold the contract's lock, and settle."""
    _cut(session, covered, state, person_id)


def _cut(session: Session, covered: ContractCue, state: WorkState, person_id: UUID) -> None:
    covered.cut_at = clock.now()
    covered.cut_in = WorkState.ACCEPTED if covered.accepted_at is not None else state
    record_of_cue(session, covered, "cut", person_id, {"state": covered.cut_in.value})


def end_statement(session: Session, contract: Contract, states: Mapping[UUID, WorkState]) -> Statement:
    """Return the statement of a contract if it ends now, by the state of the work on each cue that is not settled."""
    terms, book = terms_of(session, contract), load_ledger_book(session, contract)
    milestones = plan_queries.milestones_of(session, contract.id)
    deposit_minor = sum(milestone.amount_minor for milestone in milestones if milestone.is_deposit)
    is_running = contract.state is ContractState.AGREED
    return statement_of(
        book,
        priced(plan_queries.cues_of(session, contract.id)),
        states,
        rules_of(contract, terms),
        beside_cues_minor=deposit_minor + terms.time_cap_minor,
        deposit_is_set_off=terms.deposit_at_end is DepositAtEnd.SET_OFF,
        time=HourBook(session, contract).entries_at_end(book) if is_running else (),
    )


def open_cues(session: Session, contract: Contract) -> list[ContractCue]:
    """Return the cues of a contract that are neither accepted nor cut."""
    covered = plan_queries.cues_of(session, contract.id)
    return [
        contract_cue for contract_cue in covered if contract_cue.accepted_at is None and contract_cue.cut_at is None
    ]


def settle_end(
    session: Session,
    contract: Contract,
    states: Mapping[UUID, WorkState],
    *,
    person_id: UUID,
    is_by_server: bool,
) -> None:
    """Count every cue that is not settled as cut, and write all that is owed; callers hold the contract's lock."""
    statement = end_statement(session, contract, states)
    now = clock.now()
    for covered in open_cues(session, contract):
        covered.cut_at, covered.cut_in = now, states[covered.cue_id]
    if contract.state is ContractState.AGREED:
        for day in HourBook(session, contract).waiting:
            mark_agreed(session, contract, day, by=None)
    session.flush()
    write(session, contract, statement.entries, person_id=person_id, is_by_server=is_by_server)


def price_round(session: Session, cue_id: UUID, *, number: int, person_id: UUID) -> ExtraRound | None:
    """Note a counted round, and propose its price; None where the contract includes it, or prices none."""
    covered = _locked(session, cue_id, None)
    if covered is None or covered.cut_at is not None:
        return None
    contract = session.get_one(Contract, covered.contract_id)
    covered.change_requested_at = covered.change_requested_at or clock.now()
    terms = terms_of(session, contract)
    if number <= terms.rounds_included or not price_of_round(_priced(covered), terms.extra_round_bp):
        return None
    if any(
        extra_round.cue_id == cue_id and extra_round.number == number
        for extra_round in queries.extra_rounds_of(session, contract.id)
    ):
        return None  # a change order agreed to it beforehand
    proposed = add_round(session, contract, cue_id, number=number, person_id=person_id)
    record_of_cue(session, covered, "round_proposed", person_id, {"round": number})
    return proposed


def add_round(session: Session, contract: Contract, cue_id: UUID, *, number: int, person_id: UUID) -> ExtraRound:
    """Add a round beyond the included ones, to be agreed to."""
    added = ExtraRound(
        studio_id=contract.studio_id,
        project_id=contract.project_id,
        contract_id=contract.id,
        cue_id=cue_id,
        number=number,
        proposed_by=person_id,
    )
    session.add(added)
    session.flush()
    return added


def agree_extra_round(session: Session, actor: Actor, extra_round_id: UUID) -> ExtraRound:
    """Agree to a further round's price, as the studio; it is due at once."""
    proposed, contract = _proposal(session, actor, extra_round_id)
    if contract.designer_id == actor.person:
        raise OtherPartyNeeded("only the studio agrees to the fee", fix="waive it, or wait for the studio")
    if Role.PRODUCER not in actor.roles_in(contract.studio_id):
        raise ProducerNeeded("only a producer of the studio agrees to a price")
    ensure_second_factor_for(session, actor, contract.studio_id, SecondFactorUse.PAYING)
    charge_round(session, contract, proposed, person_id=actor.person)
    return proposed


def charge_round(session: Session, contract: Contract, proposed: ExtraRound, *, person_id: UUID) -> None:
    """Make a round's price due, now that both have agreed to it; callers hold the contract's lock."""
    proposed.agreed_at, proposed.agreed_by = clock.now(), person_id
    covered = next(cue for cue in plan_queries.cues_of(session, contract.id) if cue.cue_id == proposed.cue_id)
    entry = Entry(
        LineKind.EXTRA_ROUND,
        price_of_round(_priced(covered), terms_of(session, contract).extra_round_bp),
        CLAUSES[LineKind.EXTRA_ROUND],
        cue_id=proposed.cue_id,
        milestone_id=covered.milestone_id,
        round_number=proposed.number,
    )
    # After a price change the cue may owe nothing for it.
    write(session, contract, [entry] if entry.amount_minor else [], person_id=person_id)


def drop_extra_round(session: Session, actor: Actor, extra_round_id: UUID) -> ExtraRound:
    """Let a further round go without a price, as the designer."""
    proposed, contract = _proposal(session, actor, extra_round_id)
    if contract.designer_id != actor.person:
        raise OtherPartyNeeded("only the designer can waive the fee of a round", fix="agree to it, or ask for that")
    proposed.dropped_at = clock.now()
    covered = next(cue for cue in plan_queries.cues_of(session, contract.id) if cue.cue_id == proposed.cue_id)
    record_of_cue(session, covered, "round_dropped", actor.person, {"round": proposed.number})
    return proposed


def _proposal(session: Session, actor: Actor, extra_round_id: UUID) -> tuple[ExtraRound, Contract]:
    proposed = queries.extra_round_by_id(session, extra_round_id)
    contract = contract_for(session, actor, proposed.contract_id) if proposed else None
    if proposed is None or contract is None:
        raise ExtraRoundNotFound(f"no extra round {extra_round_id}")
    lock_contract(session, contract.id)
    session.refresh(proposed, ["agreed_at", "dropped_at"])
    if proposed.agreed_at is not None or proposed.dropped_at is not None:
        raise RoundAlreadySettled(
            "this round was agreed to or waived already", fix="this is final; a change order adds another round"
        )
    return proposed, contract


def _locked(session: Session, cue_id: UUID, designer_ids: Collection[UUID] | None) -> ContractCue | None:
    covered = plan_queries.running_cue(session, cue_id, designer_ids)
    if covered is not None:
        lock_contract(session, covered.contract_id)
        session.refresh(covered, ["accepted_at", "accepted_by", "cut_at", "cut_in"])
    return covered


def settle(session: Session, contract_id: UUID, person_id: UUID | None, *, is_by_server: bool = False) -> None:
    """Bring a contract's ledger to what its cues and their states make due; callers hold its lock."""
    session.flush()
    contract = session.get_one(Contract, contract_id)
    terms = terms_of(session, contract)
    rules = rules_of(contract, terms)
    cues = priced(plan_queries.cues_of(session, contract_id))
    book = load_ledger_book(session, contract)
    write(session, contract, settle_shares(book, cues, rules), person_id=person_id, is_by_server=is_by_server)
    status = bonus_status(session, contract, terms) if contract.state is ContractState.AGREED else None
    if status is not None:
        bonus = settle_bonus(book, terms.bonus_minor, is_earned=status.state is BonusState.EARNED)
        write(session, contract, bonus, person_id=person_id, is_by_server=is_by_server, reason=status.because)


def _priced(covered: ContractCue) -> PricedCue:
    (cue,) = priced([covered])
    return cue


def record_of_cue(
    session: Session,
    covered: ContractCue,
    kind: str,
    by: UUID | None,
    facts: Mapping[str, object] | None = None,
    on_behalf_of: UUID | None = None,
    rows: RowChanges | None = None,
) -> None:
    """Record an event of a cue in the contract that covers it; `by` is None for what the server did."""
    prefix = session.get_one(Project, covered.project_id).cue_prefix
    facts = {"cue": cue_label(covered.cue, prefix), "cue_id": str(covered.cue_id), **(facts or {})}
    record.append(session, covered.contract_id, kind, facts, by=by, on_behalf_of=on_behalf_of, rows=rows)
