"""Differences of a sound from the same sound elsewhere, in words."""

from collections.abc import Iterable

GAIN_DB = 0.5  # a codec or another rate changes the level by less


def words_of_same_sound(*, has_same_samples: bool, gain_db: float, is_trimmed: bool, is_resampled: bool) -> str:
    """Return the changes made to a sound, seen from the take in question."""
    if has_same_samples:
        return "the same samples"
    words = ["the same sound"]
    if abs(gain_db) >= GAIN_DB:
        words.append(f"{abs(gain_db):.1f} dB {'louder' if gain_db > 0 else 'quieter'}")
    if is_trimmed:
        words.append("with another start or end")
    if is_resampled:
        words.append("at another sample rate")
    return ", ".join(words)


def is_named(library: str, declared: Iterable[str]) -> bool:
    """Return whether a declaration names a library, whatever its capitals and blanks."""
    return _plain(library) in {_plain(name) for name in declared}


def _plain(name: str) -> str:
    return " ".join(name.casefold().split())
