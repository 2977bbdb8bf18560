"""The bodies of spoken placeholders."""

from datetime import datetime
from uuid import UUID

from pydantic import Field

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema

MAX_RECORDING_CHARS = 4_000_000  # in base64: 10 s at 48 kHz and 24 bit take half of it in mono, all of it in stereo


class RecordingAdd(Schema):
    """The recording spoken for a cue."""

    content_base64: str = Field(max_length=MAX_RECORDING_CHARS, description="A WAV file of at most 10 s.")


class SpokenPlaceholderRead(Schema):
    """The recording spoken for a cue, trimmed and at one level."""

    cue_id: UUID
    sha256: str
    duration_s: float
    recorded_by: PersonBrief
    recorded_at: datetime
