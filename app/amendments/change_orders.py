"""Change orders: proposed by either party, read as a difference, and in force when both have accepted the text."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from uuid import UUID

from pydantic import TypeAdapter
from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import Actor
from app.agreements import plan_queries, record
from app.agreements.access import party_of, visible_contract
from app.agreements.documents import TextPdf, sha256_of
from app.agreements.errors import NotYourContract
from app.agreements.facts import in_words
from app.agreements.models import Contract, ContractCue, Milestone
from app.agreements.plan_check import check_plan
from app.agreements.plan_queries import agreed_terms, terms_of
from app.agreements.queries import newest_version
from app.agreements.rules import ORDERS, ContractKind, ContractState, Party
from app.agreements.schemas import BlockRead
from app.agreements.terms import MoneyTerms
from app.agreements.text import blocks_of
from app.amendments import queries, schemas
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
from app.amendments.rules import ChangeOrderState, Difference, Planned, changed_plan, warnings_of
from app.amendments.signing import locked_for_party, sign
from app.amendments.work import work_states
from app.kit import clock
from app.kit.events import publish
from app.kit.money import money, part_of
from app.money import overview
from app.money import queries as money_queries
from app.money.ledger import called, load_ledger_book, priced, write
from app.money.ledger_book import CLAUSES, Entry, price_of_round
from app.money.models import ExtraRound
from app.money.rules import LineKind
from app.money.schemas import AdviceRead
from app.money.settlement import charge_round, settle, take_out
from app.reviews.queries import round_counts
from app.sound_lists.models import Cue
from app.sound_lists.queries import cues_of as listed_cues
from app.sound_lists.rules import CueState

CHANGES: TypeAdapter[list[schemas.Change]] = TypeAdapter(list[schemas.Change])


@dataclass
class Review:
    """What a change order would do to a contract as it stands now, and what is wrong with it."""

    difference: schemas.DifferenceRead | None = None
    problems: list[str] = field(default_factory=list)


class Reviewer:
    """A contract's plan, cues and terms, for its change orders to be held against."""

    def __init__(self, session: Session, contract: Contract) -> None:
        self.session, self.contract = session, contract
        self.terms: MoneyTerms = terms_of(session, contract)
        self.milestones: dict[UUID, Milestone] = {
            one.id: one for one in plan_queries.milestones_of(session, contract.id)
        }
        self.covered: dict[UUID, ContractCue] = {one.cue_id: one for one in plan_queries.cues_of(session, contract.id)}
        self.listed: dict[UUID, Cue] = {cue.id: cue for cue in listed_cues(session, contract.project_id)}
        self.prefix = contract.project.cue_prefix

    def money(self, amount_minor: int) -> str:
        """Return an amount in the contract's currency."""
        return money(amount_minor, self.contract.currency)

    def is_done(self, milestone_id: UUID) -> bool:
        """Whether a milestone has cues and all of them are settled."""
        own = [one for one in self.covered.values() if one.milestone_id == milestone_id]
        return bool(own) and all(one.accepted_at or one.cut_at for one in own)

    def round_minor(self, covered: ContractCue) -> int:
        """Return what a further round of a cue costs by the contract."""
        (cue,) = priced([covered])
        return price_of_round(cue, self.terms.extra_round_bp)

    def review(self, changes: Sequence[schemas.Change]) -> Review:
        """Return what changes would do; with a problem there is no difference."""
        problems: list[str] = []
        named: set[tuple[str, UUID]] = set()
        for change in changes:
            about: tuple[str, UUID] | None = None
            if change.kind == "move_date":
                about = ("milestone", change.milestone_id)
            elif change.kind != "add_work":
                about = ("cue", change.cue_id)
            if about is not None and about in named:
                problems.append("one cue or milestone is named by two changes; leave one of them out")
            if about is not None:
                named.add(about)
            problems += self._problems(change)
        if problems:
            return Review(problems=list(dict.fromkeys(problems)))
        return Review(self._difference(changes))

    def _problems(self, change: schemas.Change) -> list[str]:
        if change.kind in ("add_cue", "move_date", "add_work"):
            milestone = self.milestones.get(change.milestone_id)
            if milestone is None or milestone.is_deposit:
                return ["there is no such milestone in this contract; name one that is no deposit"]
            if change.kind != "add_work" and self.is_done(milestone.id):
                return [f"{milestone.name} is complete; name a milestone that is open"]
        if change.kind == "move_date":
            return self._problems_of_date(change)
        if change.kind == "add_cue":
            return self._problems_of_added(change.cue_id)
        if change.kind == "add_work":
            return []
        covered = self.covered.get(change.cue_id)
        if covered is None:
            return ["the contract does not cover that cue; add it instead"]
        name = called(covered.cue, self.prefix)
        if covered.cut_at is not None:
            return [f"{name} was cut under this contract; sign another contract for it"]
        if covered.accepted_at is not None:
            return [f"{name} is accepted, and its price stands; add work to its milestone instead"]
        if change.kind == "add_round" and not self.round_minor(covered):
            return [f"the contract names no price of a further round of {name}; change the price of the cue instead"]
        return []

    def _problems_of_date(self, change: schemas.MoveDate) -> list[str]:
        name = self.milestones[change.milestone_id].name
        if change.due_on < clock.now().date():
            return [f"{change.due_on} is over; give {name} a day to come"]
        if change.due_on == self.milestones[change.milestone_id].due_on:
            return [f"{name} is due on {change.due_on} already; leave this change out"]
        return []

    def _problems_of_added(self, cue_id: UUID) -> list[str]:
        cue = self.listed.get(cue_id)
        if cue is None:
            return [f"there is no cue {cue_id} in this project; put it on the sound list first"]
        name = called(cue, self.prefix)
        if cue.state is CueState.CUT:
            return [f"{name} was cut from the list; put a new cue on it instead"]
        if cue_id in self.covered:
            is_cut = self.covered[cue_id].cut_at is not None
            return [
                f"{name} was cut under this contract; sign another contract for it"
                if is_cut
                else f"the contract covers {name} already; change its price instead"
            ]
        taken = plan_queries.covered_elsewhere(self.session, self.contract.id, [cue_id])
        return [f"{title} covers {name}; take it out of that one first" for _, title in taken]

    def _difference(self, changes: Sequence[schemas.Change]) -> schemas.DifferenceRead:
        before = self.plan()
        after = changed_plan(before, [one for one in map(self._difference_of, changes) if one is not None])
        states = work_states(self.session, self.contract)
        gone = {change.cue_id for change in changes if change.kind == "cut_cue"}
        not_owed = sum(
            (self.covered[cue_id].amount_minor or 0)
            - part_of(self.covered[cue_id].amount_minor or 0, self.terms.kill_fees.of(states[cue_id]))
            for cue_id in gone
        )
        beside = sum(self.round_minor(self.covered[one.cue_id]) for one in changes if one.kind == "add_round")
        beside += sum(one.amount_minor for one in changes if one.kind == "add_work")
        figures = overview.figures(self.session, self.contract, load_ledger_book(self.session, self.contract))
        price = figures.agreed_minor - figures.saved_minor
        added = sum(new.amount_minor - old.amount_minor for old, new in zip(before, after, strict=True))
        cues = sum(1 for one in self.covered.values() if one.cut_at is None)
        advice_before = check_plan([one.payment for one in before], self.contract.currency)
        advice_after = check_plan([one.payment for one in after], self.contract.currency)
        terms = agreed_terms(self.session, self.contract)
        warnings = warnings_of(
            before,
            after,
            clock.now().date(),
            rush_days=_number(terms, "rush_days"),
            rush_bp=_number(terms, "rush_bp"),
        )
        return schemas.DifferenceRead(
            changes=[self.sentence(change) for change in changes],
            cues_before=cues,
            cues_after=cues - len(gone) + sum(1 for one in changes if one.kind == "add_cue"),
            price_before_minor=price,
            price_after_minor=price + added + beside - not_owed,
            milestones=[
                schemas.ChangedMilestone(
                    name=old.name,
                    is_deposit=old.is_deposit,
                    amount_before_minor=old.amount_minor,
                    amount_after_minor=new.amount_minor,
                    due_before=old.due_on,
                    due_after=new.due_on,
                )
                for old, new in zip(before, after, strict=True)
            ],
            warnings=[AdviceRead(**asdict(one)) for one in warnings],
            advice=[AdviceRead(**asdict(one)) for one in advice_after],
            advice_gone=[AdviceRead(**asdict(one)) for one in advice_before if one not in advice_after],
        )

    def plan(self) -> list[Planned]:
        """Return the milestones as they stand; cues that were cut count no more."""
        wanted = [one.milestone_id for one in self.covered.values() if one.cut_at is None]
        return [
            Planned(one.id, one.name, one.amount_minor, one.due_on, wanted.count(one.id), one.is_deposit)
            for one in self.milestones.values()
        ]

    def _difference_of(self, change: schemas.Change) -> Difference | None:
        match change.kind:
            case "add_cue":
                return Difference(change.milestone_id, change.price_minor, cues=1)
            case "cut_cue":
                return Difference(self.covered[change.cue_id].milestone_id, cues=-1)
            case "reprice_cue":
                covered = self.covered[change.cue_id]
                return Difference(covered.milestone_id, change.price_minor - (covered.amount_minor or 0))
            case "move_date":
                return Difference(change.milestone_id, due_on=change.due_on)
        return None

    def sentence(self, change: schemas.Change) -> str:
        """Return a change in words."""
        match change.kind:
            case "add_cue":
                cue, milestone = self.listed[change.cue_id], self.milestones[change.milestone_id]
                return f"{called(cue, self.prefix)} is added to {milestone.name} at {self.money(change.price_minor)}."
            case "cut_cue":
                return f"{self._name(change)} is taken out; it is owed by the state of its work when both have agreed."
            case "reprice_cue":
                was = self.covered[change.cue_id].amount_minor or 0
                return f"{self._name(change)} costs {self.money(change.price_minor)} instead of {self.money(was)}."
            case "add_round":
                price = self.round_minor(self.covered[change.cue_id])
                return f"A further round of {self._name(change)} costs {self.money(price)}."
            case "move_date":
                milestone = self.milestones[change.milestone_id]
                was_on = f" instead of {in_words(milestone.due_on)}" if milestone.due_on else ""
                return f"{milestone.name} is due on {in_words(change.due_on)}{was_on}."
            case "add_work":
                name = self.milestones[change.milestone_id].name
                price = change.amount_minor
                return f"{change.text}: {self.money(price)} beside the cues of {name}, due when both have agreed."

    def _name(self, change: schemas.CutCue | schemas.RepriceCue | schemas.AddRound) -> str:
        return called(self.covered[change.cue_id].cue, self.prefix)


def _number(terms: Mapping[str, object], name: str) -> int:
    value = terms.get(name)
    return value if isinstance(value, int) else 0


def change_orders(session: Session, actor: Actor, contract_id: UUID) -> schemas.ChangeOrdersRead:
    """Return the change orders of a contract, and the milestones and cues that one may name."""
    contract = visible_contract(session, actor, contract_id)
    reviewer, party = Reviewer(session, contract), party_of(actor, contract)
    in_force = contract.kind in ORDERS and contract.state is ContractState.AGREED
    wanted = [cue.id for cue in reviewer.listed.values() if cue.state is not CueState.CUT]
    elsewhere = {name for name, _ in plan_queries.covered_elsewhere(session, contract.id, wanted)}
    return schemas.ChangeOrdersRead(
        project_id=contract.project_id,
        contract_id=contract.id,
        title=contract.title,
        currency=contract.currency,
        my_party=party,
        may_propose=in_force and party is not None,
        extra_round_bp=reviewer.terms.extra_round_bp,
        orders=[_read(session, reviewer, one, party) for one in queries.change_orders_of(session, contract.id)],
        milestones=[
            schemas.OrderMilestone(id=one.id, name=one.name, due_on=one.due_on)
            for one in reviewer.milestones.values()
            if not one.is_deposit and not reviewer.is_done(one.id)
        ],
        cues=[
            schemas.OrderCue(
                cue=overview.brief(one.cue, reviewer.prefix),
                price_minor=one.amount_minor or 0,
                round_minor=reviewer.round_minor(one),
            )
            for one in reviewer.covered.values()
            if one.accepted_at is None and one.cut_at is None
        ],
        cues_to_add=[
            overview.brief(cue, reviewer.prefix)
            for cue in reviewer.listed.values()
            if cue.state is not CueState.CUT and cue.id not in reviewer.covered and cue.name not in elsewhere
        ],
    )


def preview(
    session: Session, actor: Actor, contract_id: UUID, changes: Sequence[schemas.Change]
) -> schemas.ChangePreview:
    """Return what changes would do, and what is wrong with them; nothing is saved."""
    contract = visible_contract(session, actor, contract_id)
    if party_of(actor, contract) is None:
        raise NotYourContract("only a producer of the studio and the contract's designer change it")
    _ensure_in_force(contract)
    review = Reviewer(session, contract).review(changes)
    return schemas.ChangePreview(difference=review.difference, problems=review.problems)


def propose(session: Session, actor: Actor, contract_id: UUID, order: schemas.ChangeOrderAdd) -> ChangeOrder:
    """Put a change order before both parties; raise BadChangeOrder with every problem that it has."""
    contract, party = locked_for_party(session, actor, contract_id)
    _ensure_in_force(contract)
    reviewer = Reviewer(session, contract)
    review = reviewer.review(order.changes)
    if review.problems:
        raise BadChangeOrder(
            "; ".join(review.problems[:5]),
            errors=[{"where": "changes", "message": problem} for problem in review.problems],
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
        changes=CHANGES.dump_python(list(order.changes), mode="json"),
        text="",
        text_sha256="",
        proposer=session.get_one(Person, actor.person),
    )
    proposed.text = _text(reviewer, proposed, review)
    proposed.text_sha256 = sha256_of(proposed.text)
    session.add(proposed)
    session.flush()
    facts = {
        "change_order": proposed.number,
        "changes": review.difference.changes if review.difference else [],
        "reason": proposed.reason,
        "text_sha256_of_amendment": proposed.text_sha256,
        "begins": "before both agree, at the proposer's risk" if proposed.begins_at_once else "when both agree",
    }
    record.append(session, contract.id, "change_proposed", facts, by=actor.person)
    publish(session, "change_order.proposed", studio_id=contract.studio_id, contract_id=contract.id, party=party.value)
    return proposed


def accept(
    session: Session,
    actor: Actor,
    contract_id: UUID,
    number: int,
    *,
    name: str,
    text_sha256: str,
    address: str,
    proof_needed: bool,
) -> None:
    """Say yes to a change order for the caller's party; with the second yes it is in force.

    Raises ChangeOrderStale where what it changes has changed since.
    """
    contract, party = locked_for_party(session, actor, contract_id)
    order = _open(session, contract, number)
    _ensure_in_force(contract)
    reviewer = Reviewer(session, contract)
    review = reviewer.review(CHANGES.validate_python(order.changes))
    if review.problems or _text(reviewer, order, review) != order.text:
        why = review.problems[0] if review.problems else "the plan that it changes is another one now"
        raise ChangeOrderStale(
            f"this change order fits no longer: {why}",
            fix="the party that proposed it withdraws it and proposes another, the other party refuses it",
        )
    are_both = sign(
        session,
        actor,
        contract,
        party,
        kind="change_accepted",
        facts={"change_order": number},
        text_sha256=order.text_sha256,
        seen_sha256=text_sha256,
        name=name,
        address=address,
        proof_needed=proof_needed,
    )
    if are_both:
        _apply(session, reviewer, order, review, person_id=actor.person)


def _apply(session: Session, reviewer: Reviewer, order: ChangeOrder, review: Review, *, person_id: UUID) -> None:
    contract = reviewer.contract
    order.state, order.closed_at = ChangeOrderState.AGREED, clock.now()
    session.flush()
    facts = {
        "change_order": order.number,
        "changes": review.difference.changes if review.difference else [],
        "text_sha256_of_amendment": order.text_sha256,
    }
    record.append(session, contract.id, "changed", facts, by=person_id)
    states = work_states(session, contract)
    position = max((one.position for one in reviewer.covered.values()), default=0)
    entries: list[Entry] = []
    for change in CHANGES.validate_python(order.changes):
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
                take_out(session, reviewer.covered[change.cue_id], state=states[change.cue_id], person_id=person_id)
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
    write(session, contract, entries, person_id=person_id)
    settle(session, contract.id, person_id)
    publish(session, "change_order.agreed", studio_id=contract.studio_id, contract_id=contract.id)


def _agree_round(session: Session, reviewer: Reviewer, cue_id: UUID, *, person_id: UUID) -> None:
    """Agree to a cue's next round: the one that was proposed, else the one after those included and counted."""
    contract = reviewer.contract
    known = [one for one in money_queries.extra_rounds_of(session, contract.id) if one.cue_id == cue_id]
    proposed = next((one for one in known if one.agreed_at is None and one.dropped_at is None), None)
    if proposed is None:
        counted = round_counts(session, [cue_id]).get(cue_id, 0)
        number = max([reviewer.terms.rounds_included, counted, *(one.number for one in known)]) + 1
        proposed = ExtraRound(
            studio_id=contract.studio_id,
            project_id=contract.project_id,
            contract_id=contract.id,
            cue_id=cue_id,
            number=number,
            proposed_by=person_id,
        )
        session.add(proposed)
        session.flush()
    charge_round(session, contract, proposed, person_id=person_id)


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
    """Return the text of a change order as PDF."""
    contract = visible_contract(session, actor, contract_id)
    order = _known(session, contract, number)
    return TextPdf.of(change_order_title(order.number, contract.title), order.text)


def _close(session: Session, order: ChangeOrder, state: ChangeOrderState, reason: str, *, by: UUID | None) -> None:
    order.state, order.closed_at, order.close_reason = state, clock.now(), reason
    session.flush()
    facts = {"change_order": order.number, "reason": reason}
    record.append(session, order.contract_id, f"change_{state.value}", facts, by=by)


def _known(session: Session, contract: Contract, number: int) -> ChangeOrder:
    order = queries.change_order_by_number(session, contract.id, number)
    if order is None:
        raise ChangeOrderNotFound(f"this contract has no change order {number}")
    return order


def _open(session: Session, contract: Contract, number: int) -> ChangeOrder:
    order = _known(session, contract, number)
    if order.state is not ChangeOrderState.PROPOSED:
        raise ChangeOrderClosed(f"change order {number} was {order.state} already", fix="propose another one")
    return order


def _ensure_in_force(contract: Contract) -> None:
    if contract.kind not in ORDERS:
        is_framework = contract.kind is ContractKind.FRAMEWORK
        raise NotInForce(
            "this contract orders no work, so no change order can change it",
            fix="propose it to the batch that has the cues" if is_framework else "sign another one",
        )
    if contract.state is not ContractState.AGREED:
        is_ended = contract.state is ContractState.ENDED
        raise NotInForce(
            "this contract has ended" if is_ended else "this contract is not signed by both yet",
            fix="sign another contract" if is_ended else "edit its draft; a sent one is recalled first",
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


def _read(session: Session, reviewer: Reviewer, order: ChangeOrder, party: Party | None) -> schemas.ChangeOrderRead:
    is_open = order.state is ChangeOrderState.PROPOSED
    review = reviewer.review(CHANGES.validate_python(order.changes)) if is_open else Review()
    given = queries.acceptances_of(session, reviewer.contract.id, order.text_sha256)
    is_party = is_open and party is not None
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
        signed=[schemas.SignedRead.model_validate(one) for one in given],
        may=schemas.ChangeOrderMay(
            agree=is_party and not review.problems and party not in {one.party for one in given},
            refuse=is_party and party is not order.party,
            withdraw=is_party and party is order.party,
        ),
    )


def lapse_open(session: Session, contract: Contract) -> None:
    """Close what is proposed when a contract ends; callers hold its lock."""
    for order in queries.change_orders_of(session, contract.id):
        if order.state is ChangeOrderState.PROPOSED:
            _close(session, order, ChangeOrderState.LAPSED, "the contract ended", by=None)
