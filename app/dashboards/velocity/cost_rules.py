"""Costs of a project's sounds, and the share of orders changed after work began: figures of plain values."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Any
from uuid import UUID

from app.dashboards.velocity.rules import FEW

WORDS = ("description", "use", "trigger")
FACTS = ("duration_s", "loop", "reverb", "variations")


@dataclass(frozen=True)
class OrderedCue:
    """A cue under one agreed contract."""

    cue_id: UUID
    currency: str
    amount_minor: int
    is_kept: bool  # accepted, and not cut
    is_churned: bool  # cut or rewritten after work began


@dataclass(frozen=True)
class Churn:
    """The part of the order that was cut or rewritten after work began."""

    ordered: int
    churned: int
    churned_minor: int

    @property
    def share(self) -> float | None:
        """The share of the ordered cues; None: too few were ordered."""
        return self.churned / self.ordered if self.ordered >= FEW else None


@dataclass(frozen=True)
class EstimateError:
    """The estimates of accepted cues against the time that was logged for them."""

    cues: int
    estimated_min: int
    logged_min: int

    @property
    def percent(self) -> float:
        """Return the percentage by which logged time exceeds the estimates; below zero it took less."""
        return 100 * (self.logged_min - self.estimated_min) / self.estimated_min


@dataclass(frozen=True)
class OverEstimate:
    """The open cues whose logged time exceeds their estimate already."""

    cues: int
    over_min: int


def wants_another_sound(before: Mapping[str, Any], after: Mapping[str, Any]) -> bool:
    """Whether a change of a cue says that another sound is wanted; what was only added to its words does not."""
    if not before:  # the cue was added
        return False
    if any(fact in after and before.get(fact) != after[fact] for fact in FACTS):
        return True
    return any(not _begins_with(after[fact], before.get(fact)) for fact in WORDS if fact in after)


def _begins_with(text: str | None, beginning: str | None) -> bool:
    return " ".join((text or "").split()).startswith(" ".join((beginning or "").split()).rstrip("."))


def churned_since(began_at: datetime | None, changed_at: Collection[datetime]) -> bool:
    """Whether a cue was rewritten after work on it began; None: it has not begun."""
    return began_at is not None and any(at > began_at for at in changed_at)


def churn(cues: Collection[OrderedCue]) -> Churn:
    """Return the churn of ordered cues; one under two contracts is one cue, with both amounts."""
    churned = [cue for cue in cues if cue.is_churned]
    return Churn(
        ordered=len({cue.cue_id for cue in cues}),
        churned=len({cue.cue_id for cue in churned}),
        churned_minor=sum(cue.amount_minor for cue in churned),
    )


def kept_sounds(cues: Collection[OrderedCue]) -> int:
    """Return the number of kept cues."""
    return len({cue.cue_id for cue in cues if cue.is_kept})


def per_kept_minor(spent_minor: int, kept: int) -> int | None:
    """Return the cost of a kept sound in whole minor units, halves up; None while none is kept."""
    return (2 * spent_minor + kept) // (2 * kept) if kept else None


def estimate_error(pairs: Sequence[tuple[int, int]]) -> EstimateError | None:
    """Sum (estimated, logged) minutes up; None: too few pairs."""
    if len(pairs) < FEW:
        return None
    return EstimateError(len(pairs), sum(estimated for estimated, _ in pairs), sum(logged for _, logged in pairs))


def over_estimate(open_pairs: Sequence[tuple[int, int]]) -> OverEstimate | None:
    """Sum up by how much open cues exceed their estimates, of (estimated, logged) minutes; None: none does."""
    over = [logged - estimated for estimated, logged in open_pairs if logged > estimated]
    return OverEstimate(len(over), sum(over)) if over else None
