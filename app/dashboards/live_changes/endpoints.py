"""Server-sent events: open pages are notified which rooms of which projects changed, and reload what they show."""

import json
import time
from collections.abc import AsyncIterator
from typing import Annotated, Any
from uuid import UUID

from fastapi import APIRouter, Header, Query, Request
from fastapi.responses import StreamingResponse
from starlette.concurrency import run_in_threadpool

from app.accounts.authentication import SESSION_COOKIE, sha256_of
from app.accounts.errors import NotSignedIn
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows, demo_role
from app.core.change_feed import ChangeFeed, TooManyStreams, Viewer
from app.core.db import new_id
from app.core.web.http import database_of, problems
from app.core.web.serving import IS_LEAVING
from app.dashboards.live_changes.queries import PersonsSight, sights_of

BEAT_S = 15.0  # proxies and browsers keep a connection on which something comes
MAX_DURATION_S = 3_600
RETRY_MS = 2_000  # after which a browser connects again
HEADERS = {
    "Cache-Control": "private, no-store, no-transform",  # a proxy that compresses would hold events back
    "X-Accel-Buffering": "no",  # nginx: pass on each event as it comes
}
EVENT_STREAM: dict[int | str, dict[str, Any]] = {
    200: {
        "content": {"text/event-stream": {"schema": {"type": "string"}}},
        "description": "`open` says whether all since Last-Event-ID follows; `change` has `project_id` (null: the "
        "studio itself), `studio_id` and `rooms`; `beat` comes every 15 s.",
    }
}

router = APIRouter(prefix="/v1", tags=["dashboards"])


@router.get("/events", response_class=StreamingResponse, responses=EVENT_STREAM | problems(TooManyStreams))
async def watch_changes(
    request: Request,
    actor: Annotated[Actor, allows(Audience.PERSON)],
    last_event_id: Annotated[str | None, Header(max_length=100)] = None,
    seconds: Annotated[int, Query(ge=0, le=MAX_DURATION_S, description="How long to go on.")] = MAX_DURATION_S,
) -> StreamingResponse:
    """Send at once which rooms of the caller's projects changed, and nothing of what changed in them."""
    viewer, sight = await run_in_threadpool(_viewer, request, actor)
    feed: ChangeFeed = request.app.state.change_feed
    is_leaving = getattr(request.state, IS_LEAVING, bool)
    feed.ensure_stream_limit(viewer.person_id)
    return StreamingResponse(
        _events(feed, viewer, sight, is_leaving, _id_in(last_event_id), seconds), media_type="text/event-stream",
        headers=HEADERS,
    )  # fmt: skip


def _viewer(request: Request, actor: Actor) -> tuple[Viewer, PersonsSight]:
    is_demo = demo_role(request) is not None
    viewer = Viewer(actor.person, None if is_demo else sha256_of(request.cookies.get(SESSION_COOKIE, "")))
    sight = sights_of(database_of(request), {viewer}).get(viewer)
    if sight is None:
        raise NotSignedIn("you are not signed in; sign in to continue")
    return viewer, sight


async def _events(
    feed: ChangeFeed, viewer: Viewer, sight: PersonsSight, is_leaving: Any, last_seen: UUID | None, seconds: int
) -> AsyncIterator[str]:
    ends_at = time.monotonic() + seconds
    with feed.watching(viewer, sight, is_leaving) as stream:
        is_complete = last_seen is not None and await feed.replay(stream, last_seen)
        yield f"retry: {RETRY_MS}\n" + _event("open", resumed=is_complete)
        while not stream.is_over:
            left_s = ends_at - time.monotonic()
            changed = await stream.next(max(0.0, min(BEAT_S, left_s)))
            for scope, rooms in changed.items():
                yield _event("change", **scope._asdict(), rooms=sorted(rooms))
            if not changed and not stream.is_over:
                if left_s <= 0:
                    return
                yield _event("beat")


def _event(name: str, **data: Any) -> str:
    return f"id: {new_id()}\nevent: {name}\ndata: {json.dumps(data, default=str)}\n\n"


def _id_in(text: str | None) -> UUID | None:
    try:
        return UUID(text) if text else None
    except ValueError:
        return None
