"""Two texts, compared, as they are answered."""

from typing import Literal

from pydantic import ConfigDict

from app.core.web.http import Schema


class RunRead(Schema):
    """Words in both texts, in the earlier alone, or in the later alone."""

    model_config = ConfigDict(str_strip_whitespace=False)

    is_in: Literal["both", "earlier", "later"]
    text: str


class ComparedRead(Schema):
    """One line of a comparison."""

    kind: Literal["head", "text", "item", "table"]
    change: Literal["same", "changed", "added", "removed"]
    runs: list[RunRead]


class ComparisonRead(Schema):
    """Two versions word by word."""

    from_version: int
    to_version: int
    lines: list[ComparedRead]
