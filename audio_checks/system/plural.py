"""Numbers with their nouns, in sentences that people read."""


def counted(count: int, one: str, many: str | None = None) -> str:
    """Return a number with its noun.

    Parameters
    ----------
    count : int
        How many.
    one : str
        The noun for one, such as "file".
    many : str, optional
        The noun for none and for several, where it is no added s.

    Returns
    -------
    str
        0 files, 1 file, 1,200 files.
    """
    return f"{count:,} {one if count == 1 else many or f'{one}s'}"


def verb(count: int, one: str, many: str) -> str:
    """Return the form of a verb that agrees with a number.

    Parameters
    ----------
    count : int
        How many do it.
    one, many : str
        The forms for one and for others, such as "is" and "are".

    Returns
    -------
    str
        One of the two.
    """
    return one if count == 1 else many
