"""Bodies that this room reads and answers."""

from datetime import datetime
from typing import Annotated, Any, Literal
from uuid import UUID

from pydantic import Field, StringConstraints

from app.accounts.schemas import PersonBrief
from app.deliveries.rules import TakeState
from app.kit.http import Schema

Reason = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=5000, pattern="^[^\\x00]*$")]


class FindingRead(Schema):
    """One rule that a file breaks, with its proof."""

    check: str
    code: str
    severity: Literal["error", "warning"]
    message: str
    fix: str
    measured: float | None
    limit: float | None
    unit: str | None
    start_s: float | None
    end_s: float | None
    waived: bool


class WaiverAdd(Schema):
    """Why a returned take is let through."""

    reason: Reason


class WaiverRead(Schema):
    """That the decider let a returned take through, and why."""

    id: UUID
    codes: list[str]
    reason: str
    waived_by: PersonBrief
    created_at: datetime


class CheckRead(Schema):
    """What the newest check says of a take."""

    take_id: UUID
    state: TakeState
    verdict: Literal["conforming", "rejected", "unreadable", "unjudged"]
    spec_version: int
    is_newest_spec: bool = Field(description="The newest spec asks nothing else of this take.")
    tool_version: str
    created_at: datetime
    facts: dict[str, Any] | None
    measurements: dict[str, Any]
    judgements: dict[str, Any]
    findings: list[FindingRead]
    waiver: WaiverRead | None
