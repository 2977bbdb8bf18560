"""The bodies of playlists and their sessions."""

from datetime import datetime
from typing import Annotated, Literal
from uuid import UUID

from pydantic import Field

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema
from app.deliveries.rules import TakeState
from app.renders.schemas import SoundBrief
from app.shares.rules import MAX_SOUNDS
from app.shares.schemas import Title

MOST = 2**53 - 1
Number = Annotated[int, Field(ge=0, le=MOST)]
PlaceS = Annotated[float, Field(ge=0, le=86_400, allow_inf_nan=False)]
TakeIds = Annotated[list[UUID], Field(max_length=MAX_SOUNDS)]


class PlaylistAdd(Schema):
    """A playlist to make, of takes or of the takes of cues; each at most once."""

    name: Title
    take_ids: TakeIds = Field([])
    cue_ids: list[UUID] = Field(
        [], max_length=MAX_SOUNDS, description="Of each variation the approved version, else the newest that waits."
    )


class PlaylistChange(Schema):
    """The changes of a playlist; fields that are left out stay."""

    edition: Number = Field(description="As it was read; a playlist that changed since is answered 409.")
    name: Title = ""
    take_ids: TakeIds = Field([], description="Every take, in the new order.")


class PlaylistBrief(Schema):
    """A playlist in the list of a project."""

    id: UUID
    name: str
    takes: int
    made_by: PersonBrief
    created_at: datetime


class PlaylistTake(SoundBrief):
    """One take of a playlist, with what is needed to play it."""

    take_id: UUID
    cue_id: UUID
    cue_label: str
    cue_name: str
    category: str
    variation: int | None = Field(description="Null where the cue has but one.")
    number: int
    label: str | None = Field(description="What it is among alternates; designers see those of their own alone.")
    state: TakeState
    may_approve: bool = Field(description="Whether the caller approves this cue today.")
    is_heard: bool | None = Field(description="By the caller; null for designers, of whom nothing is recorded.")


class PositionSet(Schema):
    """The caller's stopping place."""

    take_id: UUID
    at_s: PlaceS


class PlaylistRead(Schema):
    """A playlist with the takes in order that the caller hears, and where the caller stopped."""

    id: UUID
    project_id: UUID
    name: str
    edition: int
    made_by: PersonBrief
    takes: list[PlaylistTake]
    position: PositionSet | None
    may_share: bool = Field(description="Whether the caller may change it, and make guest links.")
    may_join: bool = Field(description="Whether the caller may join its session, as all of the team may.")


PageId = Annotated[
    UUID | None,
    Field(
        description="A page of the caller's own choice of id: of several pages of one person one plays and has keys."
    ),
]


class LiveRead(Schema):
    """The common playback in a session."""

    sequence: int
    holder: PersonBrief | None = Field(description="Who has control; null while it is free.")
    is_holder: bool = Field(description="Whether the caller holds them, on this page.")
    is_elsewhere: bool = Field(description="Whether another page of the caller's plays the session; this one does not.")
    take_id: UUID | None
    is_playing: bool
    position_s: float = Field(description="Where the playhead stood at `server_ms`.")
    server_ms: int = Field(description="The server's clock, in milliseconds of Unix time, when this was answered.")
    present: list[PersonBrief]


class LiveMove(Schema):
    """The holder's move: play, pause, seek or go to another take."""

    sequence: Number = Field(description="As it was read; a playhead that moved since is answered 409.")
    take_id: UUID
    is_playing: bool
    position_s: PlaceS
    page_id: PageId = None


class LiveReport(Schema):
    """That a page is open; sent every few seconds, as presence ends ten seconds after the last report."""

    leaves: bool = False
    takes_over: bool = Field(False, description="Play here, and fall silent on the caller's other page.")
    page_id: PageId = None


class LiveKeys(Schema):
    """The keys, taken while they are free or on another page of one's own, handed to another person, or put down."""

    act: Literal["take", "give", "drop"]
    person_id: UUID | None = Field(None, description="Who gets them, of `give`.")
    page_id: PageId = None
