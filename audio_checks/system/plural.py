"""Numbers with their nouns, in sentences that people read."""


def counted(count: int, singular: str, many: str | None = None) -> str:
    """Return a number with its noun.

    Parameters
    ----------
    count : int
        How many.
    singular : str
        The noun for one, such as "file".
    many : str, optional
        The noun for none and for several, where it is no added s.

    Returns
    -------
    str
        0 files, 1 file, 1,200 files.
    """
    return f"{count:,} {singular if count == 1 else many or f'{singular}s'}"


def verb(count: int, singular: str, many: str) -> str:
    """Return the form of a verb that agrees with a number.

    Parameters
    ----------
    count : int
        How many do it.
    singular, many : str
        The forms for one and for others, such as "is" and "are".

    Returns
    -------
    str
        One of the two.
    """
    return singular if count == 1 else many
