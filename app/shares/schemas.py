"""The bodies of guest links and visits."""

from datetime import datetime
from typing import Annotated
from uuid import UUID

from pydantic import Field

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema
from app.renders.schemas import ThumbRead
from app.shares.rules import MAX_SOUNDS, LinkState, SharedKind

NO_NUL = "^[^\\x00]*$"  # PostgreSQL takes none in text
Title = Annotated[str, Field(min_length=1, max_length=200, pattern=NO_NUL)]
GuestName = Annotated[str, Field(min_length=1, max_length=80, pattern=NO_NUL)]
Password = Annotated[str, Field(min_length=1, max_length=200, pattern=NO_NUL)]
Said = Annotated[str, Field(min_length=1, max_length=10_000, pattern=NO_NUL)]
Seconds = Annotated[float, Field(ge=0, allow_inf_nan=False)]
Openings = Annotated[int, Field(ge=1, le=1_000_000)]


class GuestLinkAdd(Schema):
    """A guest link to make. What it shares is fixed now: later versions and cues are not added to it."""

    kind: SharedKind
    title: Title = Field(description="What guests read above the sounds.")
    cue_ids: list[UUID] = Field([], max_length=MAX_SOUNDS, description="Of kind `cues`: one, or those of a filter.")
    playlist_id: UUID | None = Field(None, description="Of kind `playlist`.")
    password: Password | None = None
    may_comment: bool = False
    has_beeps: bool = Field(False, description="Whether the sounds have a quiet beep every four seconds.")
    expires_at: datetime | None = None
    max_openings: Openings | None = None


class GuestLinkChange(Schema):
    """Changes to a guest link; fields that are left out stay."""

    expires_at: datetime | None = None
    max_openings: Openings | None = None
    may_comment: bool = False


class GuestLinkRead(Schema):
    """A guest link as the team sees it."""

    id: UUID
    kind: SharedKind
    title: str
    state: LinkState
    sounds: int
    has_password: bool
    may_comment: bool
    has_beeps: bool
    expires_at: datetime | None
    max_openings: int | None
    openings: int
    plays: int
    made_by: PersonBrief
    created_at: datetime
    revoked_at: datetime | None
    is_own: bool = Field(description="Whether the caller made it, and so may have its address shown again.")


class GuestLinkAddress(Schema):
    """The address of a guest link, which opens it for everyone who has it."""

    url: str


class GuestLinkMade(Schema):
    """A guest link just made, with its address."""

    link: GuestLinkRead
    url: str


class SoundPlayed(Schema):
    """The number of plays of one sound in a visit."""

    place: int
    cue_name: str
    variation: int
    plays: int
    last_at: datetime


class GuestVisitRead(Schema):
    """One opening of a link: who, by the name that they typed, when, and what they played."""

    id: UUID
    guest_name: str
    opened_at: datetime
    played: list[SoundPlayed]


class GuestAccess(Schema):
    """A guest's view before the sounds: whether a password is asked for."""

    needs_password: bool


class GuestVisitAdd(Schema):
    """A guest who opens a link."""

    guest_name: GuestName
    password: Password | None = None


class GuestSoundRead(Schema):
    """One sound of a link as a guest sees it."""

    place: int
    name: str
    variation: int | None = Field(description="Null where the cue has but one.")
    duration_s: float | None
    thumb: ThumbRead | None
    is_ready: bool = Field(description="Whether it can be played now; a copy with beeps takes a moment to be made.")


class GuestRoom(Schema):
    """Everything behind a guest link."""

    title: str
    guest_name: str
    may_comment: bool
    has_beeps: bool
    sounds: list[GuestSoundRead]


class GuestVisitMade(Schema):
    """A visit that began; its secret stands in the addresses of what the guest plays and writes."""

    visit: str
    room: GuestRoom


class GuestCommentAdd(Schema):
    """Advice of a guest on a sound."""

    text: Said
    start_s: Seconds | None = None
    end_s: Seconds | None = None


class GuestCommentRead(Schema):
    """Advice as it was kept."""

    text: str
    start_s: float | None
    end_s: float | None
    created_at: datetime
