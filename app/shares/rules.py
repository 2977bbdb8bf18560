"""A guest link's contents and times, a session's person in control and its playhead: without a database."""

import base64
import hashlib
import hmac
from collections.abc import Collection, Iterable, Sequence
from datetime import datetime, timedelta
from enum import StrEnum
from typing import NamedTuple
from uuid import UUID

from app.deliveries.rules import TakeState

MAX_SOUNDS = 500  # of one link or playlist
VISIT_LASTS = timedelta(hours=12)
KEYS_FALL_AFTER = timedelta(seconds=10)  # without a report of the holder's page
MAX_QUERY_CHARS = 2_000
MAX_VIEWS = 50  # of one person in one project


class SharedKind(StrEnum):
    """The source of a guest link."""

    CUES = "cues"  # one cue, or those that a filter gave
    PALETTE = "palette"  # approved sounds of the palette
    APPROVED = "approved"  # every accepted sound, as a pack holds them
    PLAYLIST = "playlist"


class LinkState(StrEnum):
    """Whether a guest link opens, and why not."""

    OPEN = "open"
    REVOKED = "revoked"
    EXPIRED = "expired"
    FULL = "full"  # opened as often as it may be


class ViewedPage(StrEnum):
    """The page whose filter a saved view is."""

    SOUND_LIST = "sound_list"
    REVIEW_QUEUE = "review_queue"  # shared by the team of the project


def link_secret(server_key: str, link_id: UUID) -> str:
    """Return the secret of a link's address: it follows from id and server key, so that no database holds it."""
    mac = hmac.digest(server_key.encode(), b"guest link" + link_id.bytes, hashlib.sha256)
    return base64.urlsafe_b64encode(mac).rstrip(b"=").decode()


def link_state(
    now: datetime, *, revoked_at: datetime | None, expires_at: datetime | None, max_openings: int | None, openings: int
) -> LinkState:
    """Return whether a link opens once more."""
    if revoked_at is not None:
        return LinkState.REVOKED
    if expires_at is not None and now >= expires_at:
        return LinkState.EXPIRED
    if max_openings is not None and openings >= max_openings:
        return LinkState.FULL
    return LinkState.OPEN


def visit_is_over(
    now: datetime, opened_at: datetime, *, revoked_at: datetime | None, expires_at: datetime | None
) -> bool:
    """Whether a visit ends: its time is up, or its link was revoked or has expired since."""
    return revoked_at is not None or now >= opened_at + VISIT_LASTS or (expires_at is not None and now >= expires_at)


class Candidate(NamedTuple):
    """A take that may be heard for its variation."""

    take_id: UUID
    cue_id: UUID
    variation: int
    number: int
    state: TakeState


def heard_takes(candidates: Iterable[Candidate]) -> list[UUID]:
    """Return the take that is heard of each variation, in the order given: the approved one, else the newest."""
    best: dict[tuple[UUID, int], Candidate] = {}
    for candidate in candidates:
        best_so_far = best.setdefault((candidate.cue_id, candidate.variation), candidate)
        if (candidate.state is TakeState.APPROVED, candidate.number) > (
            best_so_far.state is TakeState.APPROVED,
            best_so_far.number,
        ):
            best[candidate.cue_id, candidate.variation] = candidate
    return [best_candidate.take_id for best_candidate in best.values()]


def holder_now(now: datetime, holder_id: UUID | None, seen: Sequence[tuple[UUID, datetime]]) -> UUID | None:
    """Return the person in control: nobody once the holder's page has not reported for ten seconds."""
    return holder_id if holder_id in present_now(now, seen) else None


def present_now(now: datetime, seen: Sequence[tuple[UUID, datetime]]) -> Collection[UUID]:
    """Return the people in a session, by the last reports of their pages."""
    return {person_id for person_id, seen_at in seen if now - seen_at < KEYS_FALL_AFTER}


def is_elsewhere(now: datetime, page_id: UUID | None, playing_page_id: UUID | None, seen_at: datetime) -> bool:
    """Whether another page of the same person plays a session, and still reports."""
    return page_id != playing_page_id and now - seen_at < KEYS_FALL_AFTER


def playhead_s(now: datetime, position_s: float, set_at: datetime, *, is_playing: bool) -> float:
    """Return the position of a session's playhead."""
    return position_s + (now - set_at).total_seconds() if is_playing else position_s
