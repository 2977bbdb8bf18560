"""The bodies that compare a sound with others."""

from typing import Self
from uuid import UUID

from pydantic import Field

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema
from app.deliveries.models import Take
from app.deliveries.schemas import CueBrief, ShownName
from app.reviews.palette_fit.rules import FitBasis, Measure, Stands


class FitPoint(Schema):
    """An approved cue that a sound is compared with; several variations count as the one in their middle."""

    cue: CueBrief
    is_palette: bool
    value: float


class MeasureFit(Schema):
    """The position of a sound among others by one measure."""

    measure: Measure
    unit: str = Field(description="Of loudness LUFS; of spectrum and timbre the dB from the middle of the others.")
    value: float
    middle: float = Field(description="Of the others.")
    lowest: float
    highest: float
    stands: Stands
    others: list[FitPoint]


class SoundsLike(Schema):
    """An approved sound of another cue that is near in timbre."""

    cue: CueBrief
    take_id: UUID
    distance_db: float = Field(description="Between the two timbres; 0 is the same.")


class TakeFitRead(Schema):
    """A take compared with the approved sounds of its category, or of the palette if those are too few."""

    take_id: UUID
    file_name: ShownName
    cue: CueBrief | None
    basis: FitBasis | None = Field(description="What it is compared with; null where it is not.")
    category: str
    says: str = Field(examples=["Stands apart: louder than all of them, by 4.2 LU."])
    is_apart: bool
    measures: list[MeasureFit]
    first_delivery_id: UUID | None = Field(
        description="Its delivery, where that is the first of a designer who takes over."
    )
    sounds_like: list[SoundsLike] = Field(
        description="The nearest approved sounds by timbre, one a cue, the nearest first; "
        "timbres are measured once the list has a palette. Empty in the comparison of a delivery.",
    )

    @classmethod
    def nothing(
        cls, take: Take, says: str, *, cue: CueBrief | None = None, first_delivery_id: UUID | None = None
    ) -> Self:
        """Return that nothing can be compared, and why."""
        return cls(
            take_id=take.id,
            file_name=take.file_name,
            cue=cue,
            basis=None,
            category="",
            says=says,
            is_apart=False,
            measures=[],
            first_delivery_id=first_delivery_id,
            sounds_like=[],
        )


class DeliveryShift(Schema):
    """The distance of a delivery from earlier work by one measure."""

    measure: Measure
    unit: str
    compared: int
    apart: int = Field(description="How many of these are out of range.")
    shift: float = Field(description="The median distance above the others' median.")


class DeliveryFitRead(Schema):
    """A delivery compared with other designers' approved sounds."""

    delivery_id: UUID
    project_id: UUID
    number: int
    designer: PersonBrief
    is_first: bool = Field(description="The designer delivered nothing to this project before.")
    made_before_by: list[str]
    takes: list[TakeFitRead]
    shifts: list[DeliveryShift]
