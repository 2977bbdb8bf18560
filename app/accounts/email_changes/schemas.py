"""Bodies and answers of changes of an account's address."""

from datetime import datetime

from pydantic import Field

from app.accounts.schemas import Email
from app.core.web.http import Schema


class EmailChangeAdd(Schema):
    """The address that an account is to have."""

    email: Email


class EmailChangeRead(Schema):
    """A change of the caller's address that waits for its confirmations."""

    new_email: str
    old_confirmed: bool = Field(description="Whether the link that was mailed to the present address was followed.")
    new_confirmed: bool = Field(description="Whether the link that was mailed to the new address was followed.")
    expires_at: datetime


class EmailChangeShown(Schema):
    """The view of a change for the holder of a mailed link."""

    new_email: str
    is_new_end: bool = Field(description="Whether the link was mailed to the new address.")
    is_confirmed: bool = Field(description="Whether this end is confirmed already.")
    expires_at: datetime
