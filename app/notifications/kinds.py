"""Kinds of notices: the events on which one is written, and the news that its topics are.

A kind is a job in a module of this package whose name ends in `jobs`: it says who gets the notice, and in which words.
"""

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from app.core.jobs.queue import Handler, job
from app.notifications.preferences.rules import News


@dataclass(frozen=True)
class NoticeKind:
    """The job that writes a kind of notice, its module, and the events that start it."""

    job: str
    module: str
    events: tuple[str, ...]


_kinds: dict[str, NoticeKind] = {}
_news: dict[str, News] = {}


def notice(*events: str, topics: Mapping[str, News] = MappingProxyType({})) -> Callable[[Handler], Handler]:
    """Make a function the job of a kind of notice, by its name; `topics` are the first words of its notices' topics."""

    def made(function: Handler) -> Handler:
        declare_topics(topics)
        name = f"notifications.{function.__name__}"
        _kinds[name] = NoticeKind(name, function.__module__, events)
        return job(name)(function)

    return made


def declare_topics(topics: Mapping[str, News]) -> None:
    """Declare the news of topics."""
    _news.update(topics)


def news_of(topic: str) -> News:
    """Return the kind of news of a notice's topic."""
    return _news[topic.partition(":")[0]]


def subscribers_of(modules: Collection[str]) -> dict[str, tuple[str, ...]]:
    """Return by event the jobs of the kinds in some modules."""
    subscribers: dict[str, tuple[str, ...]] = {}
    for kind in _kinds.values():
        if kind.module in modules:
            for event in kind.events:
                subscribers[event] = (*subscribers.get(event, ()), kind.job)
    return subscribers
