"""Python's own parser of patterns, which has no public name; no other module touches it.

`re._parser` gives the same trees in CPython 3.11 to 3.14, as `tests/audio_checks/test_pattern_syntax.py` shows for the
version that runs it. Before a later version is named in pyproject.toml that test passes on it.
"""

from __future__ import annotations

from re import _parser  # type: ignore[attr-defined]
from typing import Any

MAXREPEAT = _parser.MAXREPEAT  # of a repeat without an end


def parse(pattern: str, flags: int) -> Any:
    """Return the tree of a pattern: pairs of an operation and its argument; raise re.error for what is none."""
    return _parser.parse(pattern, flags)
