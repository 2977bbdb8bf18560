"""Events and signals: a lower room publishes or sends without knowing who listens.

An event has a name and facts in JSON. Its subscribers are durable jobs, and handlers that run at once in the
publisher's transaction. A signal is an object of a class, for rows that only the transaction has, and for questions
that higher rooms answer; its receivers run at once, and their answers are returned.
"""

from collections.abc import Callable, Collection, Mapping
from typing import Any, Generic, TypeVar
from uuid import UUID

from sqlalchemy.orm import Session

from app.core.db import new_id
from app.core.jobs.queue import BULK, NORMAL, queue_of

Answer = TypeVar("Answer", covariant=True)
Handler = Callable[[Session, Mapping[str, Any]], None]
Receiver = Callable[[Session, Any], Any]


class Signal(Generic[Answer]):
    """Something that a room does, or asks, in its transaction; receivers subscribe to its class."""


_subscribers: Mapping[str, tuple[str, ...]] = {}
_handlers: Mapping[str, tuple[Handler, ...]] = {}
_receivers: Mapping[type[Signal[Any]], tuple[Receiver, ...]] = {}
_low_priority: Collection[str] = ()


class UnknownEvent(Exception):
    """app/registry.py names no subscribers for this event."""


def connect(
    subscribers: Mapping[str, tuple[str, ...]],
    *,
    handlers: Mapping[str, tuple[Handler, ...]],
    receivers: Mapping[type[Signal[Any]], tuple[Receiver, ...]],
    low_priority: Collection[str] = (),
) -> None:
    """Set the jobs and handlers of each event, the receivers of signals, and the jobs of low priority."""
    global _subscribers, _handlers, _receivers, _low_priority  # set once, when the process starts
    _subscribers, _handlers, _receivers, _low_priority = subscribers, handlers, receivers, low_priority


def send(session: Session, signal: Signal[Answer]) -> list[Answer]:
    """Call the receivers of a signal in the caller's transaction, and return their answers."""
    return [receive(session, signal) for receive in _receivers.get(type(signal), ())]


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
