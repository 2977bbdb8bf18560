"""Milestones as the sound list suggests them: one for each day on which sounds are needed, else for each category."""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import date
from uuid import UUID

from app.agreements.amounts import split
from app.kit.money import BASIS_POINTS

DEPOSIT_BP = 2_500  # where the studio has no custom of its own
REST = "Other sounds"


@dataclass(frozen=True)
class WantedCue:
    """A cue that no contract covers yet."""

    cue_id: UUID
    category: str
    due_on: date | None


@dataclass(frozen=True)
class ProposedMilestone:
    """A milestone to begin from; without a price of the whole it has no amount."""

    name: str
    due_on: date | None
    cue_ids: Sequence[UUID]
    amount_minor: int | None = None
    is_deposit: bool = False


def propose_milestones(
    cues: Sequence[WantedCue], *, total_minor: int | None = None, deposit_bp: int = DEPOSIT_BP
) -> list[ProposedMilestone]:
    """Return milestones over all cues: those of a day in order, then those without a day by category, in list order.

    The price of the whole, where it is given, is a deposit and shares by the number of cues.
    """
    groups: dict[tuple[date | None, str], list[WantedCue]] = {}
    for cue in cues:
        groups.setdefault((cue.due_on, "" if cue.due_on else cue.category), []).append(cue)
    dated = sorted((day, found) for (day, _), found in groups.items() if day is not None)
    undated = [(category, found) for (day, category), found in groups.items() if day is None]
    parts: list[tuple[str, date | None, list[WantedCue]]] = [
        (_day_name(day, found), day, found) for day, found in dated
    ]
    parts += [(_called(category) if category else REST, None, found) for category, found in undated]
    deposit_minor = (total_minor or 0) * deposit_bp // BASIS_POINTS if parts else 0
    shares: Sequence[int | None] = [None] * len(parts)
    if total_minor is not None and parts:
        shares = split(total_minor - deposit_minor, [len(found) for _, _, found in parts])
    deposit = [ProposedMilestone("Deposit", None, [], deposit_minor, is_deposit=True)] if deposit_minor else []
    return deposit + [
        ProposedMilestone(name, day, [cue.cue_id for cue in found], share)
        for (name, day, found), share in zip(parts, shares, strict=True)
    ]


def _day_name(day: date, cues: Sequence[WantedCue]) -> str:
    categories = {cue.category for cue in cues}
    what = _called(*categories) if len(categories) == 1 and "" not in categories else "Sounds"
    return f"{what}, {day.day} {day:%B}"


def _called(category: str) -> str:
    words = category.replace("-", " ").replace("_", " ")
    return words.upper() if len(words) <= 3 else words[:1].upper() + words[1:]
