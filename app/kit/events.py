"""Events: what a lower room tells without knowing who listens; one durable job per subscriber."""

from collections.abc import Mapping
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.kit.db import new_id
from app.kit.queue import NORMAL, JobQueue

_queue: JobQueue | None = None
_subscribers: Mapping[str, tuple[str, ...]] = {}


class UnknownEvent(Exception):
    """Nobody has said in app/rooms.py who listens to this event."""


def connect(queue: JobQueue, subscribers: Mapping[str, tuple[str, ...]]) -> None:
    """Say where events go: the queue they become jobs in, and the jobs that each event starts."""
    global _queue, _subscribers
    _queue, _subscribers = queue, subscribers


def publish(
    session: Session,
    event: str,
    *,
    studio_id: UUID | None,
    priority: int = NORMAL,
    delay_s: float = 0,
    **facts: UUID | str | int | list[str] | None,
) -> UUID:
    """Write one job per subscriber into the caller's transaction, and return the event's id.

    `studio_id` is whose work it is; None for what concerns one person's account alone.
    """
    if _queue is None or event not in _subscribers:
        raise UnknownEvent(event)
    event_id = new_id()
    payload: dict[str, Any] = {"event": event, "event_id": str(event_id)}
    payload["studio_id"] = str(studio_id) if studio_id else None
    payload |= {name: str(value) if isinstance(value, UUID) else value for name, value in facts.items()}
    for subscriber in _subscribers[event]:
        _queue.enqueue(
            session,
            subscriber,
            payload,
            key=f"{event_id}:{subscriber}",
            studio_id=studio_id,
            priority=priority,
            delay_s=delay_s,
        )
    return event_id
