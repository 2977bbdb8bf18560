"""Places of a project's tree, and what the writers of all engines share."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from uuid import NAMESPACE_OID, uuid5

Place = tuple[str, int]
Gains = Mapping[Place, float]
IN_CONTAINER, IN_MIXER, IN_BUS = 4, 16, 32


def guid(*names: object) -> str:
    """Return one and the same id for a name."""
    return str(uuid5(NAMESPACE_OID, "/".join(map(str, names)))).upper()


def put_file(root: Path, path: str, text: str) -> None:
    place = root / path
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_text(text, encoding="utf-8")


def factor(gain_db: float | None) -> str:
    return f"{10 ** ((gain_db or 0.0) / 20):.9g}"
