"""The number of its bits that a file makes use of."""

from __future__ import annotations


def effective_bits(used: int, container_bits: int) -> int:
    """Return the bits that samples make use of, the sign included.

    Parameters
    ----------
    used : int
        All samples as signed integers of the container's width, or-ed together.
    container_bits : int
        8, 16, 24 or 32; 24-bit samples are in the upper bytes of 32.

    Returns
    -------
    int
        0 for digital silence. A file padded from 16 to 24 bits gives 16.
    """
    width = 32 if container_bits == 24 else container_bits
    used &= (1 << width) - 1
    if not used:
        return 0
    lowest = (used & -used).bit_length() - 1
    return width - lowest
