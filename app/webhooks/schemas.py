"""Requests and answers of this room."""

from datetime import datetime
from typing import Annotated
from uuid import UUID

from pydantic import Field

from app.core.outgoing import MAX_URL_CHARS
from app.core.web.http import Schema
from app.webhooks.rules import CallState, WebhookEvent, WebhookForm

Address = Annotated[
    str,
    Field(min_length=1, max_length=MAX_URL_CHARS, pattern="^[^\\x00]*$", description="Of a public host, by https."),
]
Events = Annotated[list[WebhookEvent], Field(min_length=1, max_length=len(WebhookEvent))]


class WebhookAdd(Schema):
    """An address that is called when something happens."""

    url: Address
    form: WebhookForm = WebhookForm.JSON
    events: Events
    project_id: UUID | None = Field(None, description="Null: every project of the studio.")


class WebhookChange(Schema):
    """Changes to a webhook; fields that are left out stay."""

    url: Address | None = None
    events: Events | None = None
    enabled: bool | None = Field(None, description="True lets a disabled webhook be called again.")


class WebhookProject(Schema):
    """The project that a webhook is called for."""

    id: UUID
    name: str


class WebhookRead(Schema):
    """An address that is called, and how it fares."""

    id: UUID
    url: str
    form: WebhookForm
    events: list[WebhookEvent]
    project: WebhookProject | None
    created_at: datetime
    failing_since: datetime | None
    disabled_at: datetime | None
    old_secret_until: datetime | None = Field(description="Until then messages are signed by the old secret too.")


class WebhookSecretRead(WebhookRead):
    """A webhook with its secret, which is shown this once."""

    secret: str


class WebhooksRead(Schema):
    """A studio's webhooks."""

    items: list[WebhookRead]
    projects: list[WebhookProject] = Field(description="Those that a webhook can be called for.")
    may_be_localhost: bool = Field(description="Whether this server calls its own machine too, for trying things out.")


class WebhookAttemptRead(Schema):
    """One sending of a message, with what was answered."""

    tried_at: datetime
    took_ms: int
    status: int | None = Field(description="Null where nothing was answered.")
    answer: str = Field(description="The first 1,000 bytes of it.")
    problem: str = Field(description="Empty where the message was taken.")


class WebhookCallRead(Schema):
    """One message to one address, with what was answered last."""

    id: UUID
    event: WebhookEvent
    state: CallState
    tries: int
    created_at: datetime
    tried_at: datetime | None
    next_at: datetime | None
    took_ms: int | None
    status: int | None
    answer: str = Field(description="The first 1,000 bytes of it.")
    problem: str
    body: str
    attempts: list[WebhookAttemptRead] = Field(description="Each sending, the first one first; kept with the message.")
