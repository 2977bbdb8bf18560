"""What a project kept apart consists of, and how its files are written."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

Gains = Mapping[str, float]  # in dB, by place


@dataclass(frozen=True)
class Apart:
    """How a project is written, the sounds that each of its places moves, and what the level of others depends on."""

    write: Callable[[Path, Gains], Path]
    moved: dict[str, tuple[str, ...]]
    depends: dict[str, tuple[str, ...]]  # by sound; "" where nothing but constants counts
    standing: Gains = field(default_factory=dict)  # of places that are not at 0 dB where nothing is planted


def put(root: Path, path: str, text: str) -> None:
    """Write a file of a project, and the folders above it."""
    place = root / path
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_text(text, encoding="utf-8")
