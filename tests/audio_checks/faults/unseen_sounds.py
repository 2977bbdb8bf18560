"""The families of sounds that no detector is tuned on. None are written yet since the second ones became known."""

from tests.audio_checks.faults.sounds import Family

FAMILIES: dict[str, Family] = {}
