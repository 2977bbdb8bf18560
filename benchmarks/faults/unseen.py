"""What no detector is tuned on: the fourth half's sounds, with every known fault put into them and with its own."""

from collections.abc import Mapping

from benchmarks.faults import (
    fourth_unseen_injuries,
    fourth_unseen_sounds,
    injuries,
    once_unseen_injuries,
    second_unseen_injuries,
    third_unseen_injuries,
)
from benchmarks.faults.injuries import Fault
from benchmarks.faults.sounds import Family

FAMILIES: dict[str, Family] = fourth_unseen_sounds.FAMILIES
KNOWN_FAULTS = (
    injuries.FAULTS + once_unseen_injuries.FAULTS + second_unseen_injuries.FAULTS + third_unseen_injuries.FAULTS
)
TRIED: tuple[tuple[tuple[Fault, ...], Mapping[str, Family]], ...] = (
    (KNOWN_FAULTS, FAMILIES),
    (fourth_unseen_injuries.FAULTS, FAMILIES),
)
