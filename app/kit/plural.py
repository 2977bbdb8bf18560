"""A number with its noun, in sentences that people read."""


def counted(count: int, one: str, many: str | None = None) -> str:
    """Return a number with its noun: 0 files, 1 file, 2 files; `many` where the plural is no added s."""
    return f"{count:,} {one if count == 1 else many or f'{one}s'}"


def verb(count: int, one: str, many: str) -> str:
    """Return the form of a verb, or of another word, that agrees with a number."""
    return one if count == 1 else many
