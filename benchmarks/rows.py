"""One figure of ours, with its limit, the best possible value, and that of another tool on the same files."""

from collections.abc import Iterable
from dataclasses import asdict, dataclass, replace
from typing import Any, Literal

from benchmarks.tables import table

HEAD = ("what", "must", "stretch", "reached", "ours", "peer")


@dataclass(frozen=True)
class Row:
    """A line of the table.

    `reached` is a ratio to a peer or a figure in `unit`; `better` says which way is good. Without `must` the row
    is there to be known. What could not be measured here says why in `missing`.
    """

    what: str
    reached: float | None
    unit: str = "×"
    must: float | None = None
    stretch: float | None = None
    better: Literal["more", "less"] = "more"
    ours: str = ""
    peer: str = ""
    missing: str = ""

    @property
    def met(self) -> bool | None:
        """Whether the must is met; None where there is none, or no figure."""
        if self.reached is None or self.must is None:
            return None
        return self.reached >= self.must if self.better == "more" else self.reached <= self.must

    def cells(self) -> list[str]:
        """Return the line's cells."""
        sign = "≥" if self.better == "more" else "≤"
        reached = f"not measured: {self.missing}" if self.reached is None else f"{self.reached:.3g} {self.unit}"
        if self.met is not None:
            reached = f"**{reached}**" if self.met else f"**{reached}, not met**"
        bounds = [f"{sign} {bound:g} {self.unit}" if bound is not None else "" for bound in (self.must, self.stretch)]
        return [self.what, *bounds, reached, self.ours, self.peer]


def markdown(rows: Iterable[Row]) -> str:
    """Return rows as a table."""
    return table(HEAD, [row.cells() for row in rows])


def promised(rows: Iterable[Row]) -> list[Row]:
    """Return the rows with a must, each with its first two peers."""
    return [replace(row, peer="; ".join(row.peer.split("; ")[:2])) for row in rows if row.must is not None]


def plain(rows: Iterable[Row]) -> list[dict[str, Any]]:
    """Return rows as JSON has them."""
    return [asdict(row) | {"met": row.met} for row in rows]
