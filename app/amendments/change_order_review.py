"""The effects of a change order on a contract as it stands, and its faults."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.clauses.facts import format_long_date
from app.agreements.clauses.figures import other_amounts, prose_errors
from app.agreements.clauses.terms import MoneyTerms
from app.agreements.models import Contract, ContractCue, Milestone
from app.agreements.plan import queries as plan_queries
from app.agreements.plan.queries import agreed_terms, terms_of
from app.agreements.plan.validation import check_plan, resolved, worsened
from app.amendments import schemas
from app.amendments.caps import Caps
from app.amendments.rules import Difference, Planned, changed_plan, warnings_of
from app.amendments.work import work_states
from app.core import clock
from app.core.money import money, part_of
from app.core.plural import day_in_words
from app.money import overview
from app.money.ledger.book import price_of_round
from app.money.ledger.service import cue_label, load_ledger_book, priced
from app.money.schemas import AdviceRead
from app.sound_lists.models import Cue
from app.sound_lists.queries import cues_of as listed_cues
from app.sound_lists.rules import CueState


@dataclass
class Review:
    """The effects of a change order on a contract as it stands now, and its faults."""

    difference: schemas.DifferenceRead | None = None
    problems: list[str] = field(default_factory=list)


class Reviewer:
    """A contract's plan, cues and terms, for its change orders to be held against."""

    def __init__(self, session: Session, contract: Contract) -> None:
        self.session, self.contract = session, contract
        self.terms: MoneyTerms = terms_of(session, contract)
        self.milestones: dict[UUID, Milestone] = {
            milestone.id: milestone for milestone in plan_queries.milestones_of(session, contract.id)
        }
        self.covered: dict[UUID, ContractCue] = {cue.cue_id: cue for cue in plan_queries.cues_of(session, contract.id)}
        self.prefix = contract.project.cue_prefix
        self.caps = Caps(session, contract, self.terms)

    @cached_property
    def listed(self) -> dict[UUID, Cue]:
        """The cues of the project's list, by id."""
        return {cue.id: cue for cue in listed_cues(self.session, self.contract.project_id)}

    def money(self, amount_minor: int) -> str:
        """Return an amount in the contract's currency."""
        return money(amount_minor, self.contract.currency)

    def is_done(self, milestone_id: UUID) -> bool:
        """Whether a milestone has cues and all of them are settled."""
        milestone_cues = [
            contract_cue for contract_cue in self.covered.values() if contract_cue.milestone_id == milestone_id
        ]
        return bool(milestone_cues) and all(
            contract_cue.accepted_at or contract_cue.cut_at for contract_cue in milestone_cues
        )

    def round_minor(self, covered: ContractCue) -> int:
        """Return the cost of a further round of a cue by the contract."""
        (cue,) = priced([covered])
        return price_of_round(cue, self.terms.extra_round_bp)

    def review(self, changes: Sequence[schemas.Change]) -> Review:
        """Return the effects of changes; with a problem there is no difference."""
        problems: list[str] = []
        named: set[tuple[str, UUID]] = set()
        for change in changes:
            about: tuple[str, UUID] | None = None
            if change.kind == "move_date":
                about = ("milestone", change.milestone_id)
            elif change.kind == "set_caps":
                about = ("caps", self.contract.id)
            elif change.kind != "add_work":
                about = ("cue", change.cue_id)
            if about is not None and about in named:
                problems.append("one cue, date or cap is named by two changes; leave one of them out")
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
                return ["there is no such milestone in this contract; name one that is not a deposit"]
            if change.kind != "add_work" and self.is_done(milestone.id):
                return [f"{milestone.name} is complete; {self._open_milestone()}"]
        if change.kind == "move_date":
            return self._problems_of_date(change)
        if change.kind == "add_cue":
            return self._problems_of_added(change.cue_id)
        if change.kind == "add_work":
            return self._problems_of_work(change)
        if change.kind == "set_caps":
            return self.caps.problems(change)
        covered = self.covered.get(change.cue_id)
        if covered is None:
            return ["the contract does not cover that cue; add it instead"]
        name = cue_label(covered.cue, self.prefix)
        if covered.cut_at is not None:
            return [self._cut(covered.cue, name)]
        if covered.accepted_at is not None:
            return [f"{name} is accepted, and its price stands; add work to its milestone instead"]
        if change.kind == "add_round" and not self.round_minor(covered):
            return [f"the contract names no price of a further round of {name}; change the price of the cue instead"]
        return []

    def _problems_of_work(self, change: schemas.AddWork) -> list[str]:
        problems = list(prose_errors(change.text, agreed_terms(self.session, self.contract)))
        if others := other_amounts(change.text, change.amount_minor, self.contract.currency):
            problems.append(
                f"“{others[0]}” is typed, and the work costs {self.money(change.amount_minor)}; "
                "leave the amount out of the text, or enter it as the price"
            )
        return problems

    def _problems_of_date(self, change: schemas.MoveDate) -> list[str]:
        name = self.milestones[change.milestone_id].name
        if change.due_on < clock.now().date():
            return [f"{day_in_words(change.due_on)} is over; give {name} a day to come"]
        if change.due_on == self.milestones[change.milestone_id].due_on:
            return [f"{name} is due on {day_in_words(change.due_on)} already; give it another day"]
        return []

    def _problems_of_added(self, cue_id: UUID) -> list[str]:
        cue = self.listed.get(cue_id)
        if cue is None:
            return [f"there is no cue {cue_id} in this project; put it on the sound list first"]
        name = cue_label(cue, self.prefix)
        if cue.state is CueState.CUT:
            return [self._cut(cue, name)]
        covered = self.covered.get(cue_id)
        if covered is not None and covered.cut_at is not None:
            return [self._cut(cue, name)]
        if covered is not None and covered.accepted_at is not None:
            return [f"the contract covers {name}, which is accepted; add work to its milestone instead"]
        if covered is not None:
            return [f"the contract covers {name} already; change its price instead"]
        taken = plan_queries.covered_elsewhere(self.session, self.contract.id, [cue_id])
        return [f"{title} covers {name}; take it out of that one first" for _, title in taken]

    def _open_milestone(self) -> str:
        is_any_open = any(
            not milestone.is_deposit and not self.is_done(milestone.id) for milestone in self.milestones.values()
        )
        return "name a milestone that is open" if is_any_open else "sign another contract for more cues"

    def _cut(self, cue: Cue, name: str) -> str:
        if cue.state is CueState.CUT:
            return f"{name} was cut from the list; put a new cue on it instead"
        return f"{name} was cut under this contract; sign another contract for it"

    def _difference(self, changes: Sequence[schemas.Change]) -> schemas.DifferenceRead:
        before = self.plan()
        after = changed_plan(
            before, [difference for difference in map(self._difference_of, changes) if difference is not None]
        )
        states = work_states(self.session, self.contract)
        gone = {change.cue_id for change in changes if change.kind == "cut_cue"}
        not_owed = sum(
            (self.covered[cue_id].amount_minor or 0)
            - part_of(self.covered[cue_id].amount_minor or 0, self.terms.kill_fees.of(states[cue_id]))
            for cue_id in gone
        )
        beside = sum(self.round_minor(self.covered[change.cue_id]) for change in changes if change.kind == "add_round")
        beside += sum(change.amount_minor for change in changes if change.kind == "add_work")
        beside += sum(self.caps.added_minor(change) for change in changes if change.kind == "set_caps")
        figures = overview.figures(self.session, self.contract, load_ledger_book(self.session, self.contract))
        price = figures.agreed_minor - figures.saved_minor
        added = sum(new.amount_minor - old.amount_minor for old, new in zip(before, after, strict=True))
        cues = sum(1 for contract_cue in self.covered.values() if contract_cue.cut_at is None)
        advice_before = check_plan([planned.payment for planned in before], self.contract.currency)
        advice_after = check_plan([planned.payment for planned in after], self.contract.currency)
        terms = agreed_terms(self.session, self.contract)
        warnings = warnings_of(
            before,
            after,
            plan_queries.today_of(self.session, self.contract),
            more_work=self._with_more_work(changes),
            rush_days=_number(terms, "rush_days"),
            rush_bp=_number(terms, "rush_bp"),
        )
        return schemas.DifferenceRead(
            changes=[self.sentence(change) for change in changes],
            cues_before=cues,
            cues_after=cues - len(gone) + sum(1 for change in changes if change.kind == "add_cue"),
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
            warnings=[AdviceRead.model_validate(warning) for warning in warnings],
            advice=[AdviceRead.model_validate(advice) for advice in worsened(advice_before, advice_after)],
            advice_gone=[AdviceRead.model_validate(advice) for advice in resolved(advice_before, advice_after)],
        )

    def _with_more_work(self, changes: Sequence[schemas.Change]) -> set[UUID]:
        """Return the milestones to which changes add work that is no cue of theirs."""
        rounds = {self.covered[change.cue_id].milestone_id for change in changes if change.kind == "add_round"}
        return rounds | {change.milestone_id for change in changes if change.kind == "add_work"}

    def plan(self) -> list[Planned]:
        """Return the milestones as they stand; cues that were cut no longer count."""
        kept_milestone_ids = [
            contract_cue.milestone_id for contract_cue in self.covered.values() if contract_cue.cut_at is None
        ]
        return [
            Planned(
                milestone.id,
                milestone.name,
                milestone.amount_minor,
                milestone.due_on,
                kept_milestone_ids.count(milestone.id),
                milestone.is_deposit,
            )
            for milestone in self.milestones.values()
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
                return (
                    f"{cue_label(cue, self.prefix)} is added to {milestone.name} at {self.money(change.price_minor)}."
                )
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
                was_on = f" instead of {format_long_date(milestone.due_on)}" if milestone.due_on else ""
                return f"{milestone.name} is due on {format_long_date(change.due_on)}{was_on}."
            case "add_work":
                name = self.milestones[change.milestone_id].name
                price = change.amount_minor
                return f"{change.text}: {self.money(price)} beside the cues of {name}, due when both have agreed."
            case "set_caps":
                return self.caps.sentence(change)

    def _name(self, change: schemas.CutCue | schemas.RepriceCue | schemas.AddRound) -> str:
        return cue_label(self.covered[change.cue_id].cue, self.prefix)


def _number(terms: Mapping[str, object], name: str) -> int:
    value = terms.get(name)
    return value if isinstance(value, int) else 0
