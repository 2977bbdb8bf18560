"""Numbers with their nouns, and days, in sentences that people read."""

from datetime import date


def counted(count: int, singular: str, many: str | None = None) -> str:
    """Return a number with its noun: 0 files, 1 file, 2 files; `many` where the plural is no added s."""
    return f"{count:,} {singular if count == 1 else many or f'{singular}s'}"


def verb(count: int, singular: str, many: str) -> str:
    """Return the form of a verb, or of another word, that agrees with a number."""
    return singular if count == 1 else many


def day_in_words(day: date) -> str:
    """Return a day as sentences name it: 20 November 2026."""
    return f"{day.day} {day:%B %Y}"
