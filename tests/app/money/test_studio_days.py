"""Invoices have their day, and are late, by the calendar of the studio's time zone."""

from datetime import date, timedelta
from zoneinfo import ZoneInfo

import pytest
from sqlalchemy.orm import Session

from app.accounts.models import Studio
from app.core import clock
from tests.app.money.agreed import Agreed, deposit, milestone
from tests.support.server import World

EAST, WEST = "Pacific/Kiritimati", "Etc/GMT+12"  # 14 hours before UTC, and 12 behind it


def other_day_than_utc() -> str:
    """Return a time zone in which it is another day than in UTC now, whatever the time."""
    return WEST if clock.now().hour < 11 else EAST


def today_in(zone: str) -> date:
    return clock.now().astimezone(ZoneInfo(zone)).date()


def set_zone(world: World, zone: str) -> None:
    def put(session: Session) -> None:
        session.get_one(Studio, world.studio_id).time_zone = zone

    world.server.in_database(put)


def test_an_invoice_has_the_studios_day(world: World) -> None:
    zone = other_day_than_utc()
    set_zone(world, zone)
    agreed = Agreed(world)
    agreed.agree(deposit(25_000), milestone("Alpha", agreed.cue("radar_ping"), amount_minor=75_000))
    before = today_in(zone)
    invoice = agreed.invoice()
    assert date.fromisoformat(invoice["issued_on"]) in (before, today_in(zone))
    assert date.fromisoformat(invoice["due_on"]) - date.fromisoformat(invoice["issued_on"]) == timedelta(days=14)
    paid = world.producer.post(
        f"/v1/invoices/{invoice['id']}/payments",
        json={"amount_minor": 100, "reference": "T-1", "paid_on": today_in(zone).isoformat()},
    )
    assert paid.status_code == 201, paid.text


@pytest.mark.slow
def test_an_invoice_is_late_by_the_studios_day(world: World) -> None:
    set_zone(world, WEST)
    agreed = Agreed(world, terms={"payment_days": 0})
    agreed.agree(deposit(25_000), milestone("Alpha", agreed.cue("radar_ping"), amount_minor=75_000))
    invoice = agreed.invoice()
    assert invoice["state"] == "open", "its day is not over where the studio is"
    set_zone(world, EAST)  # there it is a day later, at every time of the day
    late = world.producer.get(f"/v1/invoices/{invoice['id']}").json()
    assert late["state"] == "late"
