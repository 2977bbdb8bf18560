"""Bodies and answers of accounts."""

from datetime import date, datetime
from typing import Annotated
from uuid import UUID

from pydantic import ConfigDict, Field, StringConstraints

from app.accounts.rules import MAX_ADDRESS_LENGTH, MAX_PASSWORD_LENGTH, MAX_TOKEN_DAYS, Role
from app.core.web.http import Schema

# One line, without control characters or marks that turn the direction of writing: it appears in mails and lists.
_ONE_LINE = "^[^\\x00-\\x1f\\x7f-\\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069]*$"
Line = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=120, pattern=_ONE_LINE)]
MaybeLine = Annotated[str, StringConstraints(strip_whitespace=True, max_length=120, pattern=_ONE_LINE)]
Prose = Annotated[str, StringConstraints(strip_whitespace=True, max_length=5000, pattern="^[^\\x00]*$")]
Email = Annotated[str, StringConstraints(strip_whitespace=True, max_length=MAX_ADDRESS_LENGTH)]
Password = Annotated[str, StringConstraints(max_length=MAX_PASSWORD_LENGTH)]
SetupCode = Annotated[str, StringConstraints(max_length=40)]


class PersonBrief(Schema):
    """A person's id and name, and their picture."""

    id: UUID
    name: str
    picture: str | None = Field(None, description="The address of the picture; null where there is none.")


class PersonRead(Schema):
    """The caller's own account."""

    id: UUID
    name: str
    email: str
    email_verified_at: datetime | None = Field(
        description="Since when it is known that the account's holder reads this address."
    )


class StudioBrief(Schema):
    """A studio, by name."""

    id: UUID
    name: str


class HolidayRead(Schema):
    """A day on which a studio does not work."""

    day: date
    name: str
    created_at: datetime = Field(description="Cues that waited before are not delayed by it.")


class HolidayAdd(Schema):
    """A day on which a studio does not work."""

    day: date
    name: Line


MAX_HOLIDAYS = 500


class CalendarSave(Schema):
    """The calendar of a studio."""

    time_zone: Line = Field(examples=["Europe/Berlin"], description="Of the IANA list.")
    holidays: list[HolidayAdd] = Field([], max_length=MAX_HOLIDAYS, description="Besides Saturdays and Sundays.")


class CalendarRead(Schema):
    """The calendar of a studio, by which working days are counted."""

    time_zone: str
    holidays: list[HolidayRead]


class InvoiceDetailsSave(Schema):
    """A party's details on electronic invoices, to save; a field may stay empty."""

    name: MaybeLine = Field("", description="By which the party trades.")
    street: MaybeLine = ""
    postal_code: MaybeLine = ""
    city: MaybeLine = ""
    country_code: MaybeLine = Field("", examples=["DE"], description="ISO 3166-1 alpha-2.")
    vat_id: MaybeLine = Field("", examples=["DE123456789"], description="With its country in front.")
    tax_number: MaybeLine = Field("", description="Of the local tax office, where there is no VAT ID.")
    account_number: MaybeLine = Field("", description="IBAN, or the number of an account without one.")
    no_tax_reason: MaybeLine = Field("", description="Why no tax is charged, where none is.")


class InvoiceDetailsRead(InvoiceDetailsSave):
    """A party's present details on electronic invoices."""


class SessionRead(Schema):
    """Whether the caller is signed in, and whether this is the demo, which needs no sign-in."""

    signed_in: bool
    demo: bool
    person: PersonBrief | None


class DemoPart(Schema):
    """The role that the demo's visitor plays, and the others on offer."""

    part: str
    parts: list[str]


class _WithPassword(Schema):
    model_config = ConfigDict(str_strip_whitespace=False)  # a password's spaces are part of it


class SignUpAdd(_WithPassword):
    """A new account and its studio."""

    email: Email
    name: Line
    password: Password
    studio_name: Line | None = Field(None, description="Without one the studio is named after the person.")
    setup_code: SetupCode | None = Field(
        None, description="Printed by `soundlist serve`; for a server's first account."
    )


class SignUpRequest(Schema):
    """The address of a new account, on a server that mails a link first."""

    email: Email
    setup_code: SetupCode | None = Field(
        None, description="Printed by `soundlist serve`; for a server's first account."
    )


class SignUpFinish(_WithPassword):
    """The rest of a new account, and its studio."""

    name: Line
    password: Password
    studio_name: Line | None = Field(None, description="Without one the studio is named after the person.")


class SignUpShown(Schema):
    """The address that a mailed link opens an account for."""

    email: str


class SignUpMode(Schema):
    """The way for a person to get an account here."""

    open: bool = Field(description="Whether anyone may sign up now; otherwise people are invited.")
    by_mail: bool = Field(description="Whether the address is verified by a mailed link first.")
    setup_code: bool = Field(description="Whether the account is the server's first and needs its set-up code.")


class SignInRead(Schema):
    """One browser in which the caller is signed in."""

    id: UUID
    device: str = Field(description="Browser and system, as the browser names them; empty if unknown.")
    place: str = Field(description="Network address that it signed in from.")
    is_current: bool
    created_at: datetime
    last_seen_at: datetime = Field(description="To within ten minutes.")
    expires_at: datetime


class DeskTokenAdd(Schema):
    """The caller's name for a desk token, the machine that it is for, and its lifetime."""

    name: Line
    days: int = Field(MAX_TOKEN_DAYS, ge=1, le=MAX_TOKEN_DAYS, description="How long it works.")


class DeskTokenRead(Schema):
    """One of the caller's keys for `soundlist desk`, without its secret."""

    id: UUID
    name: str
    created_at: datetime
    last_used_at: datetime | None = Field(description="To within a minute; null: never used.")
    expires_at: datetime


class DeskTokenMade(DeskTokenRead):
    """A new key with its secret, which is shown this once."""

    secret: str


class SignInAdd(_WithPassword):
    """Address and password, and the second factor where the account asks for one."""

    email: Email
    password: Password
    code: str | None = Field(
        default=None, max_length=40, description="Of the authenticator app, or a recovery code; asked for by a 401."
    )


class ResetAdd(Schema):
    """Whose password was forgotten."""

    email: Email


class NewPassword(_WithPassword):
    """The password to be."""

    password: Password


class PasswordChange(_WithPassword):
    """The password that is and the one to be."""

    current: Password
    new: Password


class NameChange(Schema):
    """The name to be."""

    name: Line


class StudioAdd(Schema):
    """A new studio."""

    name: Line


class StudioChange(Schema):
    """The new name of a studio."""

    name: Line


class MemberRead(Schema):
    """A member of the studio."""

    person: PersonBrief
    email: str
    roles: list[Role]
    since: datetime


class RolesChange(Schema):
    """A member's new role."""

    roles: list[Role] = Field(min_length=1)
    hand_over_to: UUID | None = Field(
        default=None, description="Who becomes the approver where the member may no longer approve."
    )


class StudioInvitationAdd(Schema):
    """The address to invite, and the role."""

    email: Email
    roles: list[Role] = Field(min_length=1)


class StudioInvitationRead(Schema):
    """An invitation that waits for its answer."""

    id: UUID
    email: str
    roles: list[Role]
    approves_project_id: UUID | None = Field(description="The project that they become the approver of on joining.")
    inviter: PersonBrief
    created_at: datetime
    expires_at: datetime


class StudioInvitationShown(Schema):
    """The invitation of a link's holder."""

    studio_name: str
    email: str
    roles: list[Role]
    invited_by_name: str
    has_account: bool
    expires_at: datetime


class InvitationAccept(_WithPassword):
    """For a new account: name and password. For an account that is not signed in: its password."""

    name: Line | None = None
    password: Password | None = None


class JoinedStudio(Schema):
    """A person who joined a studio."""

    person: PersonRead
    studio: StudioBrief
