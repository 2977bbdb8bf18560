"""A plan while it is written: milestones with their cues."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from datetime import date
from uuid import UUID


@dataclass(frozen=True)
class PlannedCue:
    """A cue of a planned milestone."""

    cue_id: UUID
    price_minor: int | None = None
    estimate_min: int | None = None


@dataclass(frozen=True)
class PlannedMilestone:
    """A milestone as it is planned; without an amount, its cues' prices add up to it."""

    name: str
    amount_minor: int | None
    due_on: date | None
    is_deposit: bool = False
    tax_bp: int | None = None
    cues: Sequence[PlannedCue] = field(default_factory=tuple)

    @property
    def whole_minor(self) -> int:
        """Return the milestone's payment."""
        if self.amount_minor is not None:
            return self.amount_minor
        return sum(cue.price_minor or 0 for cue in self.cues)
