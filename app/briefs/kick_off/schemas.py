"""Bodies of decisions, and the vision of the brief."""

from datetime import date, datetime
from uuid import UUID

from pydantic import Field

from app.accounts.schemas import Line, PersonBrief
from app.briefs.schemas import Asked
from app.core.web.http import Schema


class DecisionWrite(Schema):
    """A decision of the talks before a contract."""

    decided_on: date
    attended: Line = Field(description="Who attended, by name; everyone in the project reads it.")
    text: Asked = Field(description="It names questions of the brief and cues by their numbers: question 4, SW-014.")


class DecisionRead(DecisionWrite):
    """A decision, and whether it can be changed."""

    id: UUID
    author: PersonBrief
    created_at: datetime
    signed_at: datetime | None = Field(description="Since then it stands in the record of a contract, and stays.")


class Vision(Schema):
    """The feel of the game's sound in the words of the brief."""

    text: str | None = Field(description="Null while the brief does not say it.")
