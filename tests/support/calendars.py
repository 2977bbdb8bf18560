"""Reads calendars behind their secret addresses, as a calendar program does."""

from httpx2 import Client
from icalendar import Calendar

from tests.support.server import World


def calendar_of(world: World, by: Client) -> str:
    """Make a person's calendar link of the project, and return its path."""
    made = by.post(f"/v1/projects/{world.project_id}/calendar")
    assert made.status_code == 201, made.text
    url = str(made.json()["url"])
    return url[url.index("/v1/") :]


def events_at(world: World, path: str) -> list[tuple[str, str, str]]:
    """Return the day, the summary and the description of each event, as nobody in particular reads them."""
    answer = world.nobody.get(path)
    assert answer.status_code == 200, answer.text
    assert answer.headers["content-type"].startswith("text/calendar")
    events = Calendar.from_ical(answer.content).walk("VEVENT")
    assert len({str(event["UID"]) for event in events}) == len(events)
    return [
        (event["DTSTART"].dt.isoformat(), str(event["SUMMARY"]), str(event.get("DESCRIPTION", ""))) for event in events
    ]


def events_of(world: World, by: Client) -> list[tuple[str, str, str]]:
    """Return the events of a new calendar of a person."""
    return events_at(world, calendar_of(world, by))
