"""Events: a lower room publishes without knowing the subscribers.

A subscriber is a durable job, or a function that runs at once in the publisher's transaction, for what must hold when
the request is answered.
"""

from collections.abc import Callable, Collection, Mapping
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.core.db import new_id
from app.core.jobs.queue import BULK, NORMAL, queue_of

Handler = Callable[[Session, Mapping[str, Any]], None]

_subscribers: Mapping[str, tuple[str, ...]] = {}
_handlers: Mapping[str, tuple[Handler, ...]] = {}
_low_priority: Collection[str] = ()


class UnknownEvent(Exception):
    """app/registry.py names no subscribers for this event."""


def connect(
    subscribers: Mapping[str, tuple[str, ...]],
    *,
    handlers: Mapping[str, tuple[Handler, ...]],
    low_priority: Collection[str] = (),
) -> None:
    """Set the jobs that each event starts, its handlers, and the jobs that have low priority whatever the event's."""
    global _subscribers, _handlers, _low_priority  # set once, when the process starts
    _subscribers, _handlers, _low_priority = subscribers, handlers, low_priority


def publish(
    session: Session,
    event: str,
    *,
    studio_id: UUID | None,
    priority: int = NORMAL,
    delay_s: float = 0,
    once: str | None = None,
    **facts: UUID | str | int | list[str] | None,
) -> UUID:
    """Call the event's handlers, write one job per subscriber into the caller's transaction, and return the event's id.

    `studio_id` is whose work it is; None for what concerns one person's account alone. Events that give the same
    word to `once` are one: the first starts the jobs.
    """
    if event not in _subscribers:
        raise UnknownEvent(event)
    event_id = new_id()
    payload: dict[str, Any] = {"event": event, "event_id": str(event_id)}
    payload["studio_id"] = str(studio_id) if studio_id else None
    payload |= {name: str(value) if isinstance(value, UUID) else value for name, value in facts.items()}
    for handle in _handlers.get(event, ()):
        handle(session, payload)
    for subscriber in _subscribers[event]:
        queue_of(session).enqueue(
            session,
            subscriber,
            payload,
            key=f"{once or event_id}:{subscriber}",
            studio_id=studio_id,
            priority=BULK if subscriber in _low_priority else priority,
            delay_s=delay_s,
        )
    return event_id
