"""The bodies of the search."""

from datetime import datetime
from typing import Literal
from uuid import UUID

from pydantic import Field

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema
from app.deliveries.schemas import CueBrief


class VersionFeedback(Schema):
    """A version that was given a reason or a label, and who said it."""

    variation: int
    number: int | None = Field(description="Null where the version has no cue any more.")
    by: PersonBrief | None
    on_behalf_of: PersonBrief | None
    at: datetime | None


class Found(Schema):
    """One hit of the search."""

    kind: Literal["cue", "file", "person", "contract", "change_reason", "pick_reason", "label", "comment", "question"]
    title: str
    text: str = Field(description="Its use, its state, an address, or the words in which the typed ones were found.")
    cue: CueBrief | None = Field(default=None, description="Null for people, contracts and files without a cue.")
    take_id: UUID | None = None
    contract_id: UUID | None = None
    start_s: float | None = None
    said: VersionFeedback | None = Field(default=None, description="Of reasons and labels alone.")


class FindResult(Schema):
    """The results of a search, best first."""

    hits: list[Found]


class FoundElsewhere(Found):
    """One hit in another project."""

    project_id: UUID
    project_name: str


class FindElsewhereResult(Schema):
    """The results of a search through all other projects, those of the newest project first."""

    hits: list[FoundElsewhere]
