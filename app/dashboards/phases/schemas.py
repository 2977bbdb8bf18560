"""What the endpoint of phases answers."""

from uuid import UUID

from pydantic import Field

from app.core.web.http import Schema
from app.dashboards.phases.rules import PhaseAct
from app.reviews.palette_approvals.schemas import PaletteApprovalRead
from app.sound_lists.rules import Phase


class PhaseAwaited(Schema):
    """A person who must act before a phase is done."""

    who: str | None = Field(description="Null: no designer has the cues yet.")
    act: PhaseAct
    count: int = Field(description="Cues; 1 for the palette as a set.")


class PhaseRead(Schema):
    """A phase of the production that has cues."""

    phase: Phase
    cues: int = Field(description="Cut ones are not counted.")
    accepted: int
    is_open: bool = Field(description="Every phase before it is done.")
    is_done: bool
    awaited: list[PhaseAwaited]


class PhasesRead(Schema):
    """The phases of a production that have cues, in order."""

    phases: list[PhaseRead]
    palette_approval: PaletteApprovalRead | None = Field(description="Null while the palette is not approved as a set.")
    may_approve_palette: bool = Field(description="The caller can approve the palette now.")
    closed_cue_ids: list[UUID] = Field(description="Cues of phases that are not open: work on them is early.")
