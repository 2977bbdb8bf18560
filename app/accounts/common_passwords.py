"""The most common passwords of ten characters or more, as lists of leaked ones have them.

The file holds those among the most common million of SecLists (MIT), and its longer ones of letters alone; in lower
case, without spaces, hyphens, dots and underscores, one a line.
"""

import lzma
import unicodedata
from functools import cache
from pathlib import Path

FILE = Path(__file__).with_suffix(".txt.xz")
_LEFT_OUT = str.maketrans("", "", " -_.")


def is_common(password: str) -> bool:
    """Whether a password is a common one, however it is spelt, and whatever stands before and after its letters."""
    plain = unicodedata.normalize("NFKC", password).casefold().translate(_LEFT_OUT)
    return any(f"\n{text}\n".encode() in _listed() for text in (plain, plain.strip("0123456789!?*#$&+=@")))


@cache
def _listed() -> bytes:
    return b"\n" + lzma.decompress(FILE.read_bytes())
