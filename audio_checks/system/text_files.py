"""Text files that people write: specs, sound lists, baselines. Like sounds, they come from trees of strangers.

Each is bounded before it is parsed.
"""

import os
import re
import stat
import tomllib
from pathlib import Path
from typing import Any

from audio_checks.errors import SpecError
from audio_checks.system.windows import reachable

MOST_BYTES = 32 << 20
MOST_TOML_CHARACTERS = 1_000_000
MOST_KEY_PARTS = 16  # of a dotted key: tomllib takes the square of them in time and memory
MOST_DEPTH = 16  # of arrays and inline tables within one another
LONGEST_WORD = 200  # of what stands outside quotes: keys, numbers, dates

# Each alternative keeps what it has matched (possessive), so that the scan is linear in the text.
_TOKEN = re.compile(
    r"""
      (?P<skipped> \#[^\n]*+
        | \"{3}(?:[^"\\]++|\\.|"{1,2}(?!"))*+(?:\"{3}|\Z) | '{3}(?:[^']++|'{1,2}(?!'))*+(?:'{3}|\Z)
        | "(?:[^"\\\n]++|\\[^\n])*+"? | '[^'\n]*+'? )
    | (?P<word> [A-Za-z0-9_+:-]++ )
    | (?P<mark> [\[\]{}.,=\n] )
    """,
    re.VERBOSE | re.DOTALL,
)


def read_text(path: Path, *, fix: str = "", most_bytes: int = MOST_BYTES) -> str:
    """Return the text of a UTF-8 file, without a byte order mark.

    Raises
    ------
    SpecError
        The file cannot be read, is not a regular file, is too large, or is not UTF-8; `fix` then says how to
        make it so. What the file holds is not repeated.
    """
    content = read_bytes(path, most_bytes=most_bytes)
    try:
        return content.decode("utf-8-sig").replace("\r\n", "\n").replace("\r", "\n")
    except UnicodeDecodeError:
        raise SpecError("; ".join(["is not UTF-8 text", *([fix] if fix else [])]), where=str(path)) from None


def read_bytes(path: Path, *, most_bytes: int = MOST_BYTES) -> bytes:
    """Return the bytes of a regular file; raise SpecError where it cannot be read or is too large."""
    try:
        return _content(path, most_bytes)
    except (OSError, ValueError) as error:
        raise SpecError(f"cannot be read: {getattr(error, 'strerror', None) or error}", where=str(path)) from None


def _content(path: Path, most_bytes: int) -> bytes:
    """Return a file's bytes without waiting for a FIFO or reading a device without end."""
    flags = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
    with os.fdopen(os.open(reachable(os.fspath(path)), flags), "rb") as file:
        if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
            raise SpecError("is not a regular file but a pipe or a device", where=str(path))
        content = file.read(most_bytes + 1)
    if len(content) > most_bytes:
        raise SpecError(f"is larger than {most_bytes >> 20} MiB", where=str(path))
    return content


def read_toml(text: str, where: str) -> dict[str, Any]:
    """Return the tables of a TOML text whose size, depth and keys are bounded.

    Raises
    ------
    SpecError
        The text is not TOML, or passes a bound.
    """
    _ensure_bounded(text, where)
    try:
        return tomllib.loads(text)
    except (ValueError, OverflowError, RecursionError) as error:  # TOMLDecodeError is a ValueError
        raise SpecError(f"is not TOML: {error}", where=where) from None


def _ensure_bounded(text: str, where: str) -> None:
    """Raise SpecError for TOML that would take the parser long; itself linear in the text."""
    if len(text) > MOST_TOML_CHARACTERS:
        raise SpecError(f"has {len(text):,} characters; at most {MOST_TOML_CHARACTERS:,} are read", where=where)
    depth, dots = 0, 0
    for token in _TOKEN.finditer(text):
        mark = token["mark"]
        if mark == ".":
            dots += 1
        elif mark:
            dots = 0
            depth = max(0, depth + (mark in "[{") - (mark in "]}"))
        if dots >= MOST_KEY_PARTS:
            fault = f"a key has more than {MOST_KEY_PARTS} parts with dots between them"
        elif depth > MOST_DEPTH:
            fault = f"arrays and tables lie more than {MOST_DEPTH} deep in one another"
        elif token["word"] and len(token["word"]) > LONGEST_WORD:
            fault = f"a key or number has {len(token['word']):,} characters; at most {LONGEST_WORD} are read"
        else:
            continue
        line = text.count("\n", 0, token.start()) + 1
        raise SpecError(f"is not read: {fault} (line {line})", where=where)
