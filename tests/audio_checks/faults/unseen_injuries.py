"""The faults that no detector is tuned on, for the sounds of `unseen_sounds`. None are written yet, as there."""

from tests.audio_checks.faults.injuries import Fault

FAULTS: tuple[Fault, ...] = ()
