"""Events: what a lower room tells without knowing who listens; one durable job per subscriber."""

from collections.abc import Collection, Mapping
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.kit.db import new_id
from app.kit.queue import BULK, NORMAL, queue_of

_subscribers: Mapping[str, tuple[str, ...]] = {}
_patient: Collection[str] = ()


class UnknownEvent(Exception):
    """Nobody has said in app/rooms.py who listens to this event."""


def connect(subscribers: Mapping[str, tuple[str, ...]], *, patient: Collection[str] = ()) -> None:
    """Say which jobs each event starts, and which of them nobody waits for, however urgent the event is."""
    global _subscribers, _patient  # said once, when the process starts
    _subscribers, _patient = subscribers, patient


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
    """Write one job per subscriber into the caller's transaction, and return the event's id.

    `studio_id` is whose work it is; None for what concerns one person's account alone. Events that give the same
    word to `once` are one: the first starts the jobs.
    """
    if event not in _subscribers:
        raise UnknownEvent(event)
    event_id = new_id()
    payload: dict[str, Any] = {"event": event, "event_id": str(event_id)}
    payload["studio_id"] = str(studio_id) if studio_id else None
    payload |= {name: str(value) if isinstance(value, UUID) else value for name, value in facts.items()}
    for subscriber in _subscribers[event]:
        queue_of(session).enqueue(
            session,
            subscriber,
            payload,
            key=f"{once or event_id}:{subscriber}",
            studio_id=studio_id,
            priority=BULK if subscriber in _patient else priority,
            delay_s=delay_s,
        )
    return event_id
