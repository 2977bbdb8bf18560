"""Inputs and answers of this room."""

from datetime import datetime, time
from uuid import UUID

from pydantic import Field

from app.core.web.http import Schema
from app.notifications.preferences.rules import Cadence, News
from app.notifications.rules import MailState


class MailRead(Schema):
    """One mail of the studio's outbox."""

    id: UUID
    recipient: str
    subject: str
    text: str
    link: str | None
    created_at: datetime
    sent_at: datetime | None
    failure: str | None


class MailedLinkRead(Schema):
    """The state of the mail with a secret link: of an invitation, or of a candidate of a posting."""

    of_id: UUID = Field(description="The invitation or the candidate that the link is for.")
    mail_id: UUID
    recipient: str
    state: MailState
    created_at: datetime
    sent_at: datetime | None
    failure: str | None = Field(description="Why the mail server refused it last.")
    link: str | None = Field(description="To be copied where no mail server delivers it, for those who may invite.")


class MailedLinksRead(Schema):
    """The mails with secret links of a project, the newest of each, and whether a server takes them."""

    can_send: bool
    links: list[MailedLinkRead]


class OutboxRead(Schema):
    """The studio's mails, and whether a server takes them."""

    can_send: bool
    mails: list[MailRead]


class MailPreferencesSave(Schema):
    """The mails that the caller wants, and their times; times are those of the time zone."""

    cadences: dict[News, Cadence] = Field(description="By kind of news; what is missing is mailed at once.")
    time_zone: str = Field(max_length=64, examples=["Europe/Berlin"])
    daily_at: time = Field(description="When the mail of the day is sent.")
    quiet_from: time | None = Field(None, description="From then on nothing is sent, until quiet_until.")
    quiet_until: time | None = None


class MailPreferencesRead(MailPreferencesSave):
    """The caller's mails, and their times: every kind of news by name."""


class MailChoiceRead(Schema):
    """The choice changed by a mail's link: the mail frequency of some news to its reader."""

    email: str
    news: list[News]
    cadence: Cadence | None = Field(description="None where these kinds are mailed differently.")
    can_stop: bool


class MailChoiceSave(Schema):
    """The mail frequency of the link's news from now on."""

    cadence: Cadence


class InAppNoticeRead(Schema):
    """One piece of news for the caller."""

    id: UUID
    news: News
    subject: str
    text: str
    path: str = Field(description="Of the page that it is about.")
    created_at: datetime
    read_at: datetime | None


class UnreadRead(Schema):
    """The number of the caller's unread notices."""

    unread: int = Field(description="100 where there are more than 99.")


class NoticesMark(Schema):
    """Notices that the caller has read."""

    ids: list[UUID] = Field([], max_length=200)
    up_to: UUID | None = Field(None, description="This notice and all before it; what came since stays unread.")
