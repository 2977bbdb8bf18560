"""Answers about effort and size."""

from datetime import date
from typing import Literal

from pydantic import Field

from app.core.web.http import Schema
from app.dashboards.effort.rules import Basis, Fit


class EffortLine(Schema):
    """The hours of the cues of one category that are estimated in one way."""

    category: str
    cues: int
    files: int = Field(description="Variations counted.")
    low_h: float
    high_h: float
    basis: Basis
    based_on: int = Field(description="Accepted cues whose logged hours it is based on; 0 for our usual figures.")


class Effort(Schema):
    """Hours that cues are likely to take, and the days on which they can be done."""

    cues: int
    files: int
    low_h: float
    high_h: float
    concepts: int = Field(description="Cues that are an idea still: their hours are the least certain.")
    lines: list[EffortLine]
    weekly_hours: float
    weekly_hours_from: Literal["given", "roster", "assumed"]
    begin_on: date
    earliest_on: date | None = Field(description="With the least hours; null where it is over five years away.")
    latest_on: date | None = Field(description="With the most hours; null where it is over five years away.")
    due_on: date | None
    fit: Fit | None = Field(description="Impossible: due before the earliest day. Null without a due day.")


class SizeLineRead(Schema):
    """The cues of one category that the brief leads to."""

    scene: str = Field(description="Empty: of the whole game.")
    category: str
    low_cues: int
    high_cues: int
    low_h: float
    high_h: float


class SizeEstimate(Schema):
    """Cues and hours that the answers of the brief lead to, before there is a list."""

    low_cues: int
    high_cues: int
    low_h: float
    high_h: float
    lines: list[SizeLineRead]
    unknown: list[str] = Field(description="Categories of the brief that no starter kit has: not counted.")
    listed_cues: int = Field(description="Cues that the list has now; cut ones are not counted.")
