"""Gates between phases: plain functions of counts."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum

from app.dashboards.rules import CueStatus
from app.sound_lists.rules import Phase


class PhaseAct(StrEnum):
    """The act that a phase waits for."""

    DELIVER = "deliver"
    REVIEW = "review"
    ANSWER = "answer"
    APPROVE_PALETTE = "approve_palette"


ACT_OF_STATUS = {
    CueStatus.TO_REVIEW: PhaseAct.REVIEW,
    CueStatus.CHECKING: PhaseAct.REVIEW,
    CueStatus.QUESTION: PhaseAct.ANSWER,
}


@dataclass(frozen=True)
class PhaseCount:
    """The cues of one phase."""

    phase: Phase
    cues: int
    accepted: int
    waits_for_approval: bool = False  # of the palette as a set

    @property
    def is_done(self) -> bool:
        """Whether every sound is accepted, and the palette approved."""
        return self.accepted == self.cues and not self.waits_for_approval


def act_for(status: CueStatus) -> PhaseAct | None:
    """Return the act that a cue in this state waits for; None for an accepted or a cut one."""
    if status in (CueStatus.ACCEPTED, CueStatus.CUT):
        return None
    return ACT_OF_STATUS.get(status, PhaseAct.DELIVER)


def open_phases(counts: Sequence[PhaseCount]) -> frozenset[Phase]:
    """Return the phases whose gate is open, of phases in their order: all before them are done."""
    opened = set()
    for count in counts:
        opened.add(count.phase)
        if not count.is_done:
            break
    return frozenset(opened)
