"""Changes since both signed, as recorded, that no change order or dismissal has settled."""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from datetime import date, datetime
from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.clauses.facts import format_long_date
from app.agreements.models import ContractCue
from app.agreements.plan.queries import agreed_terms, covered_elsewhere
from app.agreements.rules import WorkState
from app.amendments import offer_queries, schemas
from app.amendments.change_order_review import Reviewer
from app.amendments.models import ChangeOrder
from app.amendments.offer_rules import (
    DUE,
    PRICED_FACTS,
    ListChange,
    OfferKind,
    day_after_answer,
    earlier_day,
    facts_in_words,
    net_change,
    without_answers,
)
from app.amendments.rules import ChangeOrderState
from app.money import queries as money_queries
from app.money.ledger.service import cue_label
from app.projects.models import Spec
from app.projects.specs.service import read_spec
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState

SETTLING = (ChangeOrderState.PROPOSED, ChangeOrderState.AGREED)  # a refused or withdrawn order settles nothing
NO_RULE_OF_CATEGORIES = frozenset({"name", "format"})  # of a spec; files are judged by the other tables
Settler = tuple[str, UUID]  # a kind of change, and the cue or milestone that it names


@dataclass(frozen=True)
class Offer:
    """A change order that would say what changed; `key` names the change that it is about for good."""

    key: str
    kind: OfferKind
    text: str
    who: str
    at: datetime
    change: schemas.OfferedChange
    settlers: frozenset[Settler] = frozenset()  # a change order that has one of these since then has settled it


@dataclass
class SettledOffers:
    """The offers of a contract that are settled for one party."""

    orders: Sequence[ChangeOrder]
    settled: set[str] = field(default_factory=set)  # dismissed by this party, or taken up by a change order
    dismissed: dict[str, schemas.OfferDismissed] = field(default_factory=dict)  # by the other party

    def has_order(self, settlers: frozenset[Settler], since: datetime) -> bool:
        """Whether a change order that is proposed or in force has named it since then."""
        return any(
            order.state in SETTLING
            and order.proposed_at >= since
            and any(_names(change) in settlers for change in order.changes)
            for order in self.orders
        )

    def revision_of(self, kind: OfferKind, cue_id: UUID) -> int:
        """Return the last revision of the list whose offers about a cue are settled."""
        start = f"{kind}:{cue_id}:"
        return max((int(key.removeprefix(start)) for key in self.settled if key.startswith(start)), default=0)

    def spec_version(self) -> int:
        """Return the last version of the delivery spec whose offers are settled."""
        start = f"{OfferKind.SPEC}:"
        return max((int(key.removeprefix(start)) for key in self.settled if key.startswith(start)), default=0)


class Found:
    """A collector of the changes since a contract was signed."""

    def __init__(self, session: Session, reviewer: Reviewer, settled: SettledOffers) -> None:
        self._session, self._reviewer, self._settled_offers = session, reviewer, settled
        self._contract = reviewer.contract
        self._running = [
            contract_cue
            for contract_cue in reviewer.covered.values()
            if contract_cue.cut_at is None and contract_cue.cue.state is not CueState.CUT
        ]
        self._open = [contract_cue for contract_cue in self._running if contract_cue.accepted_at is None]

    def all(self) -> Iterator[Offer]:
        """Yield offers that no change order or dismissal has settled."""
        agreed_at = self._contract.agreed_at
        if agreed_at is None:
            return
        for offer in (
            *self._rounds(),
            *self._of_list(agreed_at),
            *self._specs(agreed_at),
            *self._added(agreed_at),
            *self._cut(),
            *self._references(agreed_at),
        ):
            is_settled = offer.key in self._settled_offers.settled or self._settled_offers.has_order(
                offer.settlers, offer.at
            )
            if not is_settled:
                yield offer

    def _name(self, cue: Cue) -> str:
        return cue_label(cue, self._reviewer.prefix)

    def _open_milestone(self, milestone_id: UUID | None = None) -> UUID | None:
        """Return a milestone that work can be added to: the wanted one where it is open, else the first."""
        open_ = [
            milestone.id
            for milestone in self._reviewer.milestones.values()
            if not milestone.is_deposit and not self._reviewer.is_done(milestone.id)
        ]
        return milestone_id if milestone_id in open_ else next(iter(open_), None)

    def _work(self, text: str, milestone_id: UUID | None = None) -> schemas.OfferedChange:
        return schemas.OfferedChange(kind="add_work", milestone_id=self._open_milestone(milestone_id), text=text)

    def _rounds(self) -> Iterator[Offer]:
        """Yield rounds beyond those included: as Money proposes them, or at a price to name where the text has none."""
        session, contract = self._session, self._contract
        names = {contract_cue.cue_id: self._name(contract_cue.cue) for contract_cue in self._open}
        if self._reviewer.terms.extra_round_bp:
            proposed = money_queries.extra_rounds_of(session, contract.id)
            waiting = {
                (round_.cue_id, round_.number)
                for round_ in proposed
                if round_.agreed_at is None and round_.dropped_at is None
            }
        elif "rounds_included" in agreed_terms(session, contract):
            waiting = None
        else:
            return
        included = self._reviewer.terms.rounds_included
        for cue_id, number, at, who in offer_queries.rounds_beyond(session, names.keys(), included):
            if waiting is not None and (cue_id, number) not in waiting:
                continue
            priced = "" if waiting is None else " Money offers it too: agreed to once, it is settled in both places."
            yield Offer(
                f"{OfferKind.ROUND}:{cue_id}:{number}",
                OfferKind.ROUND,
                f"Round {number} of {names[cue_id]} was sent; the price includes {included}.{priced}",
                who,
                at,
                schemas.OfferedChange(kind="add_round" if waiting is not None else "reprice_cue", cue_id=cue_id),
                frozenset({("add_round", cue_id), ("reprice_cue", cue_id), ("cut_cue", cue_id)}),
            )

    def _of_list(self, agreed_at: datetime) -> Iterator[Offer]:
        """Yield cues that were described differently, are needed earlier, or had a question answered late."""
        covered = {covered_cue.cue_id: covered_cue for covered_cue in self._running}
        began = offer_queries.work_began(self._session, self._contract, covered.keys())
        changes: dict[UUID, list[ListChange]] = defaultdict(list)
        list_changes = offer_queries.list_changes_since(
            self._session, self._contract.project_id, covered.keys(), agreed_at
        )
        for change in list_changes:
            changes[change.cue_id].append(change)
        answers: dict[UUID, list[str]] = defaultdict(list)
        for question in offer_queries.answered_since(self._session, self._contract, agreed_at):
            contract_cue = covered.get(question.cue_id)
            if contract_cue is None or question.answered_at is None:
                continue
            answers[contract_cue.cue_id].append(f"{question.text} {question.answer}")
            who = question.answerer.name if question.answerer else ""
            if contract_cue.accepted_at is None:
                yield from self._answered(contract_cue, question.id, question.asked_at, question.answered_at, who)
        for cue_id, of_cue in changes.items():
            contract_cue = covered[cue_id]
            if cue_id in began:
                of_work = [change for change in of_cue if change.at > began[cue_id]]
                yield from self._described(contract_cue, list(without_answers(of_work, answers[cue_id])))
            if contract_cue.accepted_at is None:
                yield from self._needed(contract_cue, of_cue)

    def _unsettled(
        self, kind: OfferKind, cue_id: UUID, changes: Sequence[ListChange], settlers: frozenset[Settler]
    ) -> list[ListChange]:
        """Return the changes of a cue after the last one that a change order or a dismissal has settled."""
        settled = self._settled_offers.revision_of(kind, cue_id)
        return [
            change
            for change in changes
            if change.revision > settled and not self._settled_offers.has_order(settlers, change.at)
        ]

    def _described(self, contract_cue: ContractCue, changes: Sequence[ListChange]) -> Iterator[Offer]:
        settlers: frozenset[Settler] = frozenset(
            {("reprice_cue", contract_cue.cue_id), ("cut_cue", contract_cue.cue_id)}
        )
        unsettled = self._unsettled(OfferKind.DESCRIBED, contract_cue.cue_id, changes, settlers)
        differences = net_change(unsettled, list(PRICED_FACTS))
        if not differences:
            return
        last = [change for change in unsettled if any(fact in change.after for fact in differences)][-1]
        name = self._name(contract_cue.cue)
        is_open = contract_cue.accepted_at is None
        text = f"{name} changed after work on it began"
        yield Offer(
            f"{OfferKind.DESCRIBED}:{contract_cue.cue_id}:{last.revision}",
            OfferKind.DESCRIBED,
            f"{text}{'' if is_open else ' and it was accepted'}: {facts_in_words(differences)}.",
            last.by,
            last.at,
            schemas.OfferedChange(kind="reprice_cue", cue_id=contract_cue.cue_id)
            if is_open
            else self._work(f"{name}, as it is described now", contract_cue.milestone_id),
            settlers,
        )

    def _needed(self, contract_cue: ContractCue, changes: Sequence[ListChange]) -> Iterator[Offer]:
        settlers: frozenset[Settler] = frozenset(
            {("move_date", contract_cue.milestone_id), ("cut_cue", contract_cue.cue_id)}
        )
        unsettled = self._unsettled(OfferKind.NEEDED, contract_cue.cue_id, changes, settlers)
        milestone = self._reviewer.milestones[contract_cue.milestone_id]
        moved = earlier_day(unsettled, milestone.due_on)
        if moved is None:
            return
        was_on, is_on = moved
        last = [change for change in unsettled if DUE in change.after][-1]
        yield Offer(
            f"{OfferKind.NEEDED}:{contract_cue.cue_id}:{last.revision}",
            OfferKind.NEEDED,
            f"{self._name(contract_cue.cue)} is needed on {format_long_date(is_on)} "
            f"instead of {format_long_date(was_on)}.",
            last.by,
            last.at,
            schemas.OfferedChange(kind="move_date", milestone_id=contract_cue.milestone_id, due_on=is_on),
            settlers,
        )

    def _answered(
        self, contract_cue: ContractCue, question_id: UUID, asked_at: datetime, answered_at: datetime, who: str
    ) -> Iterator[Offer]:
        milestone = self._reviewer.milestones[contract_cue.milestone_id]
        days = [day for day in (contract_cue.cue.due_on, milestone.due_on) if day is not None]
        due_on: date | None = min(days, default=None)
        moved = day_after_answer(due_on, asked_at, answered_at) if due_on else None
        if due_on is None or moved is None:
            return
        yield Offer(
            f"{OfferKind.ANSWERED}:{question_id}",
            OfferKind.ANSWERED,
            f"A question on {self._name(contract_cue.cue)} was answered after {format_long_date(due_on)}, "
            "when it was due.",
            who,
            answered_at,
            schemas.OfferedChange(kind="move_date", milestone_id=contract_cue.milestone_id, due_on=moved),
            frozenset({("move_date", contract_cue.milestone_id), ("cut_cue", contract_cue.cue_id)}),
        )

    def _specs(self, agreed_at: datetime) -> Iterator[Offer]:
        """Yield the newest delivery spec where it asks something else of open cues than the one that was settled."""
        held, newer = offer_queries.specs_since(self._session, self._contract.project_id, agreed_at)
        settled = self._settled_offers.spec_version()
        before = next((spec for spec in reversed(newer) if spec.version <= settled), held)
        if not newer or before is None or newer[-1].sha256 == before.sha256:
            return
        last = newer[-1]
        touched = [
            contract_cue.cue for contract_cue in self._open if _asks_else(before, last, contract_cue.cue.category)
        ]
        if not touched:
            return
        cues = self._name(touched[0]) if len(touched) == 1 else f"{len(touched)} cues of this contract"
        yield Offer(
            f"{OfferKind.SPEC}:{last.version}",
            OfferKind.SPEC,
            f"Version {last.version} of the delivery spec asks something else of {cues} than version {before.version}.",
            last.author.name,
            last.created_at,
            self._work(f"Work for version {last.version} of the delivery spec"),
        )

    def _added(self, agreed_at: datetime) -> Iterator[Offer]:
        """Yield cues that the list gained in the categories of the contract, and that no contract covers."""
        categories = {planned_cue.cue.category for planned_cue in self._reviewer.covered.values()}
        gained = [
            cue
            for cue in offer_queries.cues_listed_since(self._session, self._contract.project_id, agreed_at)
            if cue.category in categories and cue.state is not CueState.CUT and cue.id not in self._reviewer.covered
        ]
        if not gained:
            return
        elsewhere = {
            name
            for name, _ in covered_elsewhere(self._session, self._contract.id, [gained_cue.id for gained_cue in gained])
        }
        who = offer_queries.who_listed(self._session, [cue.id for cue in gained])
        for cue in gained:
            if cue.name in elsewhere:
                continue
            where = f" in the category {cue.category}" if cue.category else ""
            yield Offer(
                f"{OfferKind.ADDED}:{cue.id}",
                OfferKind.ADDED,
                f"{self._name(cue)} was added to the list{where}.",
                who.get(cue.id, ""),
                cue.created_at,
                schemas.OfferedChange(kind="add_cue", cue_id=cue.id, milestone_id=self._open_milestone()),
                frozenset({("add_cue", cue.id)}),
            )

    def _cut(self) -> Iterator[Offer]:
        """Yield cues that were cut in work, where no clause of the contract says what that owes."""
        fees = self._reviewer.terms.kill_fees
        for contract_cue in self._reviewer.covered.values():
            state = contract_cue.cut_in
            if contract_cue.cut_at is None or state is None or state is WorkState.NOT_BEGUN or fees.of(state):
                continue
            name = self._name(contract_cue.cue)
            yield Offer(
                f"{OfferKind.CUT}:{contract_cue.cue_id}",
                OfferKind.CUT,
                f"{name} was cut after work on it began, and no clause of the contract says what that owes.",
                "",
                contract_cue.cut_at,
                self._work(f"Work on {name} until it was cut", contract_cue.milestone_id),
            )

    def _references(self, agreed_at: datetime) -> Iterator[Offer]:
        """Yield references that the studio added for an open cue, or its category, after work on it began."""
        session, contract = self._session, self._contract
        began = offer_queries.work_began(session, contract, [contract_cue.cue_id for contract_cue in self._open])
        for version in offer_queries.references_since(session, contract, agreed_at):
            reference = version.reference
            late = [
                contract_cue
                for contract_cue in self._open
                if contract_cue.cue_id in began
                and began[contract_cue.cue_id] < version.added_at
                and (reference.cue_id == contract_cue.cue_id or reference.category == contract_cue.cue.category)
            ]
            if not late:
                continue
            cues = self._name(late[0].cue) if len(late) == 1 else f"{len(late)} cues of {reference.category}"
            title = reference.caption or version.file_name
            yield Offer(
                f"{OfferKind.REFERENCE}:{version.id}",
                OfferKind.REFERENCE,
                f"The reference {title} was added after work on {cues} began.",
                version.author.name,
                version.added_at,
                schemas.OfferedChange(kind="reprice_cue", cue_id=late[0].cue_id)
                if len(late) == 1
                else self._work(f"Work for the reference {title}"),
                frozenset({("reprice_cue", late[0].cue_id), ("cut_cue", late[0].cue_id)} if len(late) == 1 else ()),
            )


def _names(change: dict[str, str]) -> Settler | None:
    """Return the settler named by a change of an order, as offers are settled by it."""
    about = change.get("milestone_id") if change["kind"] == "move_date" else change.get("cue_id")
    return (change["kind"], UUID(about)) if about else None


def _asks_else(before: Spec, after: Spec, category: str) -> bool:
    """Whether two versions of a spec differ in what they ask of a category's sounds."""
    old, new = (read_spec(spec.toml).for_category(category).tables for spec in (before, after))
    return any(old.get(key) != new.get(key) for key in (old.keys() | new.keys()) - NO_RULE_OF_CATEGORIES)
