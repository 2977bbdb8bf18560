"""All that detectors are tuned on: faults in the families of sounds that they were written for, clicks in all."""

from collections.abc import Mapping

from benchmarks.faults import (
    injuries,
    once_unseen_injuries,
    once_unseen_sounds,
    second_unseen_injuries,
    second_unseen_sounds,
    sounds,
    third_unseen_injuries,
    third_unseen_sounds,
    training_sounds,
)
from benchmarks.faults.injuries import Fault
from benchmarks.faults.sounds import Family

FIRST_FAMILIES: dict[str, Family] = sounds.FAMILIES | once_unseen_sounds.FAMILIES
FAMILIES = FIRST_FAMILIES | second_unseen_sounds.FAMILIES | third_unseen_sounds.FAMILIES
CLICK_FAMILIES = FIRST_FAMILIES | training_sounds.FAMILIES
CLICKS = tuple(fault for fault in injuries.FAULTS + once_unseen_injuries.FAULTS if fault.check == "click")
TRIED: tuple[tuple[tuple[Fault, ...], Mapping[str, Family]], ...] = (
    (tuple(fault for fault in injuries.FAULTS if fault not in CLICKS), sounds.FAMILIES),
    (tuple(fault for fault in once_unseen_injuries.FAULTS if fault not in CLICKS), once_unseen_sounds.FAMILIES),
    (CLICKS, CLICK_FAMILIES),
    (second_unseen_injuries.FAULTS, second_unseen_sounds.FAMILIES),
    (third_unseen_injuries.FAULTS, third_unseen_sounds.FAMILIES),
)
