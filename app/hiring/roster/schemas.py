"""Bodies of the roster: designers on file, their availability, and what an import would do."""

from datetime import date, datetime
from typing import Annotated, Literal
from uuid import UUID

from pydantic import Field, StringConstraints

from app.accounts.schemas import Email, Line, PersonBrief, Prose
from app.core.web.http import Schema
from app.hiring.roster.columns import RosterField
from app.hiring.roster.rules import MAX_RANGES, Exclusivity, RateUnit, RosterService, WeekState
from app.hiring.rules import PostingState
from app.hiring.schemas import BusyRangeWrite, Currency, Day, Minor, Revision

Word = Annotated[Line, Field(max_length=60)]
Words = Annotated[list[Word], Field(max_length=30)]


class RosterLink(Schema):
    """An address where work of a designer can be heard or read."""

    title: Annotated[str, StringConstraints(strip_whitespace=True, max_length=120, pattern="^[^\\x00]*$")] = ""
    url: Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=2000)]


class RosterRate(Schema):
    """A designer's asking rate, as the studio knows it."""

    amount_minor: Minor
    currency: Currency
    unit: RateUnit


class RosterEntryWrite(Schema):
    """A designer to keep on file."""

    name: Line
    email: Email
    specialities: Words = Field(default_factory=list, description="Such as weapons, creatures, ambience.")
    services: Annotated[list[RosterService], Field(max_length=10)] = Field(default_factory=list)
    languages: Words = Field(default_factory=list)
    equipment: Prose = ""
    credits: Prose = ""
    referees: Prose = Field(default="", description="People who can recommend them.")
    links: Annotated[list[RosterLink], Field(max_length=20)] = Field(default_factory=list)
    exclusivity: Exclusivity = Exclusivity.UNKNOWN
    weekly_hours: Annotated[int, Field(ge=1, le=168)] | None = Field(
        default=None, description="How many hours a week they can give, as they say."
    )
    available_from_on: Day | None = None
    notes: Prose = ""
    rate: RosterRate | None = Field(
        default=None, description="Read and written by producers; null from others leaves it as it is."
    )


class RosterEntryChange(RosterEntryWrite):
    """An entry as it should be."""

    revision: Revision = Field(description="The revision that was read.")


class BusyRangesWrite(Schema):
    """The days that were typed; those of a calendar file stay."""

    ranges: Annotated[list[BusyRangeWrite], Field(max_length=MAX_RANGES)]


class LoanFacts(Schema):
    """A piece of equipment that the studio lends."""

    item: Line
    lent_on: Day
    due_on: Day | None = Field(None, description="The day by which it goes back.")
    returned_on: Day | None = Field(None, description="Null: it is still lent.")


class LoansWrite(Schema):
    """All loans to a designer, as they should be."""

    loans: Annotated[list[LoanFacts], Field(max_length=MAX_RANGES)]


class BusyRangeRead(BusyRangeWrite):
    """Days that are taken, and whether a calendar file says so."""

    is_from_calendar: bool


class CalendarFile(Schema):
    """A calendar file (.ics) that a designer sent."""

    file_name: Line
    content_base64: Annotated[str, Field(max_length=2_800_000)]


class ReelSoundAdd(Schema):
    """A finished upload that becomes a sound of the reel."""

    upload_id: UUID
    title: Line


class ReelSoundRead(Schema):
    """A sound of a reel; play it from /v1/reel-sounds/{id}/file."""

    id: UUID
    title: str
    file_name: str
    media_type: str
    file_bytes: int


class RosterRow(Schema):
    """A designer on file, as the list shows them."""

    id: UUID
    name: str
    email: str
    specialities: list[str]
    services: list[RosterService]
    languages: list[str]
    exclusivity: Exclusivity
    weekly_hours: int | None
    free_from_on: date = Field(description="The first day from today on that is not booked.")
    weeks: list[WeekState] = Field(description="This week and the eleven after it.")
    clashes: list[BusyRangeWrite] = Field(description="What is taken in the days that were asked about.")
    rate: RosterRate | None = Field(description="For producers only.")
    reel: list[ReelSoundRead]
    works_here: bool = Field(
        description="Whether a designer with this proven address works, or worked, for the studio."
    )


class ValueCount(Schema):
    """A value that people on file have, and how many."""

    value: str
    count: int


class RosterRead(Schema):
    """One page of the roster by name, and what it can be filtered by."""

    items: list[RosterRow]
    next: str | None
    found: int = Field(description="How many match the search, on all pages.")
    total: int
    first_week_on: date = Field(description="The Monday of the first week that is shown.")
    specialities: list[ValueCount]
    services: list[ValueCount]
    languages: list[ValueCount]


class RosterEntryRead(Schema):
    """A designer on file."""

    id: UUID
    studio_id: UUID
    name: str
    email: str
    specialities: list[str]
    services: list[RosterService]
    languages: list[str]
    equipment: str
    credits: str
    referees: str
    links: list[RosterLink]
    exclusivity: Exclusivity
    weekly_hours: int | None
    available_from_on: date | None
    notes: str
    rate: RosterRate | None = Field(description="For producers only.")
    may_see_rate: bool
    revision: int
    free_from_on: date
    first_week_on: date
    weeks: list[WeekState]
    busy: list[BusyRangeRead]
    calendar_name: str | None = Field(description="The calendar file that was read last.")
    calendar_read_at: datetime | None
    calendar_to_on: date | None = Field(description="Its events were followed to this day.")
    loans: list[LoanFacts]
    reel: list[ReelSoundRead]
    designer: PersonBrief | None = Field(
        description="The account with this proven address, where it works or worked for the studio."
    )
    added_at: datetime
    changed_at: datetime


class PostingChoice(Schema):
    """A posting that a designer on file can be asked about."""

    id: UUID
    project_id: UUID
    project_name: str
    title: str
    state: PostingState
    work_from_on: date | None
    work_to_on: date | None
    clashes: list[BusyRangeWrite]
    is_asked: bool


class RosterInvite(Schema):
    """People on file to ask for a bid."""

    entry_ids: Annotated[list[UUID], Field(min_length=1, max_length=50)]


class RosterImportAsk(Schema):
    """A sheet of designers, and how to read it."""

    format: Literal["csv", "xlsx", "paste"]
    content_base64: str | None = Field(None, max_length=7_100_000, description="The file's bytes; for csv and xlsx.")
    text: str | None = Field(None, max_length=5_300_000, description="What was pasted, or a CSV as text.")
    mapping: dict[str, RosterField] | None = Field(
        None, description="Column → field; columns not named here are read as guessed."
    )
    dry_run: bool = Field(description="Only say what would happen.")


class RosterImportColumn(Schema):
    """A column of the sheet, and what it is read as."""

    name: str
    samples: list[str]
    field: RosterField


class RosterImportRow(Schema):
    """The result for one row; an empty cell leaves what is on file."""

    row: int = Field(description="Its number in the sheet, as the spreadsheet shows it.")
    action: Literal["add", "change", "same"]
    name: str
    email: str
    changed: list[RosterField] = Field(description="What it changes of a person who is on file.")


class RosterImportFault(Schema):
    """The error in one cell."""

    row: int
    column: str | None
    message: str


class RosterImportRead(Schema):
    """The content of a sheet, its errors, and whether it was imported: all of it or nothing."""

    header_row: int | None
    columns: list[RosterImportColumn]
    rows: list[RosterImportRow]
    errors: list[RosterImportFault]
    added: int
    changed: int
    same: int
    imported: bool
