"""Milestones as the sound list suggests them: parts by the days on which sounds are needed, at least two weeks apart.

What is proposed draws no warning of `plan_check`: the price includes the deposit, every part has a day and cues, the
parts rise, and the largest is the last. Where three parts or more are possible, none is over 30 % of the price.
"""

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import date, timedelta
from uuid import UUID

from app.core.money import BASIS_POINTS

DEPOSIT_BP = 2_000  # where the studio has no custom of its own
REST = "Other sounds"
APART = timedelta(days=14)  # from one part to the next
FEWEST_PARTS, MOST_PARTS = 3, 6  # of a plan whose cues and days allow them
LARGEST_PART_BP = 3_000  # of the price
LAST_OVER_EVEN_BP = 12_000  # of an even part, where the last one may be that large
MAX_NAME_CHARS = 200


@dataclass(frozen=True)
class WantedCue:
    """A cue that no contract covers yet; what it was offered for says how heavy it is in a part."""

    cue_id: UUID
    category: str
    due_on: date | None
    weight: int = 1


@dataclass(frozen=True)
class ProposedMilestone:
    """A milestone to begin from; without a price of the whole it has no amount."""

    name: str
    due_on: date | None
    cue_ids: Sequence[UUID]
    amount_minor: int | None = None
    is_deposit: bool = False


@dataclass(frozen=True)
class _Part:
    due_on: date
    cues: Sequence[WantedCue]


def propose_milestones(
    cues: Sequence[WantedCue],
    *,
    today: date,
    begins_on: date | None = None,
    ends_on: date | None = None,
    total_minor: int | None = None,
    deposit_bp: int = DEPOSIT_BP,
) -> list[ProposedMilestone]:
    """Return milestones over all cues, in the order of their days; cues without a day are needed by the last one.

    `begins_on` is the first day of work, today where it is past or not given. `ends_on` is the last day of work where
    no cue has one. The price of the whole, where it is given, includes the deposit.
    """
    parts = _parts(cues, today=max(today, begins_on or today), ends_on=ends_on)
    amounts: Sequence[int | None] = [None] * len(parts)
    deposit: list[ProposedMilestone] = []
    if total_minor is not None and parts:
        deposit_minor = math.ceil(total_minor * deposit_bp / BASIS_POINTS)
        if len(parts) == 2:
            deposit_minor += (total_minor - deposit_minor) % 2  # so that neither half is larger
        amounts = _rising(total_minor, total_minor - deposit_minor, len(parts))
        if deposit_minor:
            deposit = [ProposedMilestone("Deposit", None, [], deposit_minor, is_deposit=True)]
    return deposit + [
        ProposedMilestone(name, part.due_on, [cue.cue_id for cue in part.cues], amount)
        for name, part, amount in zip(_names(parts), parts, amounts, strict=True)
    ]


def _rising(total_minor: int, left_minor: int, parts: int) -> list[int]:
    """Return the payment of each part: even amounts, the last one larger where it stays within its bounds."""
    even = left_minor // parts
    last = even
    if parts > 2:
        most = total_minor * LARGEST_PART_BP // BASIS_POINTS
        last = max(even, min(most, even * LAST_OVER_EVEN_BP // BASIS_POINTS))
    earlier = [min(even, (left_minor - last) // (parts - 1))] * (parts - 1) if parts > 1 else []
    return [*earlier, left_minor - sum(earlier)]  # what is left after rounding down is in the last one


def _parts(cues: Sequence[WantedCue], *, today: date, ends_on: date | None) -> list[_Part]:
    if not cues:
        return []
    days = [cue.due_on for cue in cues if cue.due_on]
    last_day = max([*days, *([ends_on] if ends_on else [])], default=None)
    if last_day is None:
        last_day = today + APART * min(FEWEST_PARTS, len(cues))
    by_day: dict[date, list[WantedCue]] = {}
    for cue in cues:
        by_day.setdefault(cue.due_on or last_day, []).append(cue)
    parts = [_Part(day, by_day[day]) for day in sorted(by_day)]
    parts = list(_apart(parts))
    part_count = min(max((last_day - today) // APART, FEWEST_PARTS), MOST_PARTS, len(cues))
    while len(parts) < part_count and (more := _parted(parts, today, part_count)) is not None:
        parts = more
    return parts


def _apart(parts: Sequence[_Part]) -> Iterator[_Part]:
    """Yield parts that are at least two weeks apart: what is needed sooner after another is one part with it."""
    waiting: _Part | None = None
    for part in parts:
        if waiting is None:
            waiting = part
        elif part.due_on - waiting.due_on < APART:
            waiting = _Part(part.due_on, [*waiting.cues, *part.cues])
        else:
            yield waiting
            waiting = part
    if waiting is not None:
        yield waiting


def _parted(parts: Sequence[_Part], today: date, part_count: int) -> list[_Part] | None:
    """Return parts with the heaviest that can be in several, the earlier ones due before it; None where none can be."""
    for index in sorted(range(len(parts)), key=lambda at: -sum(cue.weight for cue in parts[at].cues)):
        part = parts[index]
        room_days = (part.due_on - (parts[index - 1].due_on if index else today)).days
        if len(part.cues) < 2 or (index and room_days < 2):
            continue
        count = min(part_count - len(parts) + 1, len(part.cues), max(room_days // APART.days, 2))
        apart_days = max(min(APART.days, room_days // count), 1)
        shares = _shared(part.cues, count)
        days = [part.due_on - timedelta(days=apart_days * (count - 1 - at)) for at in range(count)]
        made = [_Part(day, cues) for day, cues in zip(days, shares, strict=True)]
        return [*parts[:index], *made, *parts[index + 1 :]]
    return None


def _shared(cues: Sequence[WantedCue], count: int) -> list[Sequence[WantedCue]]:
    """Return cues in order in so many shares, each with one at least, as even by weight as their order allows."""
    shares: list[Sequence[WantedCue]] = []
    left = list(cues)
    for others in range(count - 1, 0, -1):
        aim, so_far, at = sum(cue.weight for cue in left) / (others + 1), left[0].weight, 1
        while at < len(left) - others and so_far + left[at].weight <= aim:
            so_far += left[at].weight
            at += 1
        shares.append(left[:at])
        left = left[at:]
    return [*shares, left]


def _names(parts: Sequence[_Part]) -> list[str]:
    """Return a name for each part: its categories, numbered where several have the same. Days move, and stand apart."""
    plain = [_name(part) for part in parts]
    seen = Counter[str]()
    names: list[str] = []
    for name in plain:
        seen[name] += 1
        names.append(name if plain.count(name) == 1 else f"{name}, part {seen[name]}")
    return names


def _name(part: _Part) -> str:
    categories = list(dict.fromkeys(cue.category for cue in part.cues))
    what = (
        " and ".join(_called(category) if category else REST for category in categories)
        if len(categories) <= 2
        else "Sounds"
    )
    return what[: MAX_NAME_CHARS - 20]


def _called(category: str) -> str:
    words = category.replace("-", " ").replace("_", " ")
    return words.upper() if len(words) <= 3 else words[:1].upper() + words[1:]
