"""Answers about next steps."""

from datetime import date, datetime
from uuid import UUID

from pydantic import Field

from app.core.web.http import Schema
from app.dashboards.rules import AwaitedKind, NextStepKind


class NextStep(Schema):
    """Something that the caller is the one to do, and what it is about."""

    kind: NextStepKind
    count: int = 1
    subject: str = Field(default="", description="A title, an invoice's number or a person's name.")
    who: str = Field(default="", description="The other side, where there is one.")
    what: str = Field(default="", description="What happens on a day that a contract names.")
    day: date | None = None
    since: datetime | None = None
    contract_id: UUID | None = None
    posting_id: UUID | None = None
    amount_minor: int | None = None
    currency: str | None = None


class Awaited(Schema):
    """Something that another person is to do, for which the caller waits."""

    kind: AwaitedKind
    who: str
    person_id: UUID | None = None
    picture: str | None = Field(default=None, description="The address of the person's picture.")
    count: int = 1
    subject: str = ""
    since: datetime | None
    contract_id: UUID | None = None


class NextSteps(Schema):
    """The caller's next steps in a project, the first thing first, and the people they wait for."""

    steps: list[NextStep]
    awaited: list[Awaited] = Field(description="The longest wait first.")
