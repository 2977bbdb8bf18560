"""The split of one plan over two designers, stated without a database."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from uuid import UUID

from app.agreements.clauses.rules import Clause
from app.agreements.errors import BadDraft, BadSplit, WrongState
from app.agreements.plan.amounts import split
from app.agreements.plan.planned import PlannedMilestone
from app.agreements.rules import KIND_WORDS, ContractKind
from app.core.money import BASIS_POINTS, money, percent

CLAUSE = "joint"  # the key of the library's clause


@dataclass(frozen=True)
class Share:
    """A designer's share of a price: a part of it in basis points, or an amount."""

    share_bp: int | None = None
    share_minor: int | None = None

    @property
    def has_figure(self) -> bool:
        """Whether a share was entered."""
        return self.share_bp is not None or self.share_minor is not None

    def of(self, whole_minor: int, currency: str) -> int:
        """Return the share as an amount; it and the rest add up to the whole.

        Raises BadSplit unless there is one figure, and it is not above the whole.
        """
        if (self.share_bp is None) == (self.share_minor is None):
            raise BadSplit("a share is a percentage or an amount", fix="enter one of them")
        if self.share_bp is not None:
            return split(whole_minor, [self.share_bp, BASIS_POINTS - self.share_bp])[0]
        share_minor = self.share_minor or 0
        if share_minor > whole_minor:
            raise BadSplit(
                f"the share is {money(share_minor, currency)}, and both are paid {money(whole_minor, currency)}",
                fix="enter less, or raise the amounts of the plan first",
            )
        return share_minor


def divide(
    plan: Sequence[PlannedMilestone], second_cue_ids: Collection[UUID]
) -> tuple[list[PlannedMilestone], list[PlannedMilestone]]:
    """Divide a plan between two designers: the second has the named cues, and each milestone's amount follows its cues.

    A milestone is split by the prices of its cues, or equally; a deposit by what each is paid beside it. What is left
    after rounding down goes to the largest remainders, so the two plans add up to the one. Milestones without cues stay
    with the first designer. Raises BadSplit unless each designer has a cue of the plan.
    """
    planned_ids = {cue.cue_id for planned in plan for cue in planned.cues}
    if not second_cue_ids or not planned_ids > set(second_cue_ids):
        raise BadSplit(
            f"{len(planned_ids & set(second_cue_ids))} of the plan's {len(planned_ids)} cues are the second designer's",
            fix="plan the milestones of the whole work, then choose some of their cues for the second designer",
        )
    parts: tuple[list[PlannedMilestone], list[PlannedMilestone]] = ([], [])
    for planned in plan:
        if not planned.cues:
            parts[0].append(planned)
            continue
        shares = split(planned.whole_minor, [cue.price_minor or 0 for cue in planned.cues])
        for is_second, part in enumerate(parts):
            of_part = [
                (cue, share)
                for cue, share in zip(planned.cues, shares, strict=True)
                if (cue.cue_id in second_cue_ids) == bool(is_second)
            ]
            if of_part:
                amount_minor = sum(share for _, share in of_part)
                part.append(replace(planned, amount_minor=amount_minor, cues=[cue for cue, _ in of_part]))
    first, second = parts
    beside = [sum(planned.whole_minor for planned in part if not planned.is_deposit) for part in parts]
    for index, planned in enumerate(first):
        if planned.is_deposit:
            first_minor, second_minor = split(planned.whole_minor, beside)
            first[index] = replace(planned, amount_minor=first_minor)
            second.insert(index, replace(planned, amount_minor=second_minor))
    return first, second


def ensure_one_currency(currency: str, other_currency: str) -> None:
    """Raise BadDraft unless both contracts of joint work are in one currency."""
    if currency != other_currency:
        raise BadDraft(
            f"nothing was sent; one contract of this joint work is in {currency}, the other in {other_currency}",
            fix="bring both into one currency in their drafts, then send them",
        )


def ensure_single(kind: ContractKind) -> None:
    """Raise WrongState for a contract that two designers cannot divide."""
    if kind is not ContractKind.SINGLE:
        raise WrongState(
            f"a {KIND_WORDS[kind]} is between the studio and one designer",
            fix="begin a single contract, and divide that between the two designers",
        )


def ensure_stands_alone(joint_id: UUID | None) -> None:
    """Raise WrongState for a contract that is divided already."""
    if joint_id is not None:
        raise WrongState(
            "this contract is divided between two designers already",
            fix="change the split, or move cues from one plan to the other",
        )


def shares_in_words(amounts_minor: Sequence[int]) -> list[str]:
    """Return amounts as parts of their sum, which add up to 100 %; empty where there is no sum."""
    if not any(amounts_minor):
        return ["" for _ in amounts_minor]
    return [percent(share_bp) for share_bp in split(BASIS_POINTS, amounts_minor)]


def with_clause(clauses: Sequence[Clause], clause: Clause, *, stands: bool) -> list[Clause]:
    """Return clauses in which the one on joint work stands, or does not; it is added where it is missing and needed."""
    changed = [replace(each, stands=stands) if each.key == clause.key else each for each in clauses]
    is_missing = all(each.key != clause.key for each in changed)
    return [*changed, replace(clause, stands=True)] if stands and is_missing else changed
