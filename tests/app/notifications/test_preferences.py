"""Mail as each person wishes it: how often, when not, and by one click no more."""

import re
from collections.abc import Iterator
from datetime import UTC, datetime, time, timedelta
from email import message_from_bytes, policy
from uuid import UUID

import pytest

from app.core import clock
from app.notifications import mail_jobs, queries
from app.notifications.models import Mail
from app.notifications.preferences import service as preferences
from app.notifications.preferences.rules import Cadence, News, Preferences, send_after
from tests.support.deliver import add_cues
from tests.support.server import World
from tests.support.smtp import MailServer, mail_server

MINUTE = timedelta(minutes=1)
NEVER = {"sounds": "never", "talk": "never", "mentions": "never", "list": "never", "hiring": "never"}


@pytest.fixture
def mails(world: World) -> Iterator[MailServer]:
    with mail_server(world.server) as server:
        yield server


def at(text: str) -> datetime:
    return datetime.fromisoformat(text).replace(tzinfo=UTC)


BERLIN = Preferences(time_zone="Europe/Berlin", quiet_from=time(20), quiet_until=time(7, 30))


@pytest.mark.parametrize(
    ("wishes", "cadence", "now", "wanted"),
    [
        (Preferences(), "at_once", "2026-11-26 23:59:30", "2026-11-27 00:00:30"),
        (Preferences(), "hourly", "2026-11-26 10:20:15", "2026-11-26 11:00:00"),
        (Preferences(), "hourly", "2026-11-26 11:00:00", "2026-11-26 12:00:00"),
        (Preferences(), "daily", "2026-11-26 07:59:59", "2026-11-26 08:00:00"),
        (Preferences(), "daily", "2026-11-26 08:00:00", "2026-11-27 08:00:00"),
        # An hour east of UTC in winter, two in summer.
        (BERLIN, "daily", "2026-11-26 07:30:00", "2026-11-27 07:00:00"),
        (BERLIN, "daily", "2026-07-26 05:30:00", "2026-07-26 06:00:00"),
        (BERLIN, "at_once", "2026-11-26 18:30:00", "2026-11-26 18:31:00"),
        (BERLIN, "at_once", "2026-11-26 19:00:00", "2026-11-27 06:30:00"),
        (BERLIN, "at_once", "2026-11-27 01:00:00", "2026-11-27 06:30:00"),
        (BERLIN, "at_once", "2026-11-27 06:29:00", "2026-11-27 06:30:00"),
        (BERLIN, "hourly", "2026-11-26 18:30:00", "2026-11-27 06:30:00"),
        # Half an hour beside the full hours of UTC.
        (Preferences(time_zone="Asia/Kolkata"), "hourly", "2026-11-26 10:20:00", "2026-11-26 10:30:00"),
        # Quiet over the lunch break alone.
        (
            Preferences(quiet_from=time(12), quiet_until=time(13)),
            "at_once",
            "2026-11-26 12:10:00",
            "2026-11-26 13:00:00",
        ),
        (
            Preferences(quiet_from=time(12), quiet_until=time(13)),
            "at_once",
            "2026-11-26 13:10:00",
            "2026-11-26 13:11:00",
        ),
        # The night in which Berlin's clocks skip 2:30.
        (
            Preferences(time_zone="Europe/Berlin", daily_at=time(2, 30)),
            "daily",
            "2026-03-28 23:00:00",
            "2026-03-29 01:30:00",
        ),
    ],
)
def test_when_a_mail_is_sent(wishes: Preferences, cadence: str, now: str, wanted: str):
    assert send_after(wishes, Cadence(cadence), at(now), MINUTE) == at(wanted)


def save(world: World, **wanted: object) -> None:
    body = {"cadences": {}, "time_zone": "UTC", "daily_at": "08:00"} | wanted
    answer = world.designer.put("/v1/me/mail-preferences", json=body)
    assert answer.status_code == 200, answer.text


def answer_a_question(world: World, text: str) -> str:
    """Have the designer's question answered, of which they are mailed; return their address."""
    (cue,) = add_cues(world, {"name": f"coolant_{text}"})
    asked = world.designer.post(f"/v1/cues/{cue['id']}/questions", json={"text": "A drop, or a tool?"})
    world.approver.post(f"/v1/questions/{asked.json()['id']}/answer", json={"text": text}).raise_for_status()
    world.server.wait_for_jobs()
    return f"{world.designer_id}@example.test"


def answers(mails: MailServer, address: str) -> list[str]:
    """Return the mails in which an address received answers; the cues that were added are news too."""
    return [text for text in mails.texts_for(address) if "A drop, or a tool?" in text]


def test_what_was_saved_is_read_and_what_was_not_is_mailed_at_once(world: World):
    fresh = world.designer.get("/v1/me/mail-preferences").json()
    assert set(fresh["cadences"]) == {"sounds", "talk", "mentions", "list", "contracts", "hiring"}
    assert set(fresh["cadences"].values()) == {"at_once"}
    save(world, cadences={"talk": "daily"}, time_zone="Europe/Berlin", quiet_from="20:00", quiet_until="07:30")
    saved = world.designer.get("/v1/me/mail-preferences").json()
    assert saved["cadences"] == fresh["cadences"] | {"talk": "daily"}
    assert (saved["time_zone"], saved["quiet_from"], saved["quiet_until"]) == ("Europe/Berlin", "20:00:00", "07:30:00")
    assert world.approver.get("/v1/me/mail-preferences").json() == fresh


@pytest.mark.parametrize(
    ("wanted", "words"),
    [
        ({"time_zone": "Berlin"}, 'there is no time zone "Berlin"'),
        ({"quiet_from": "20:00"}, "a begin or an end alone"),
        ({"quiet_from": "20:00", "quiet_until": "20:00"}, "at the same time"),
        ({"cadences": {"contracts": "never"}}, "can't be turned off"),
    ],
)
def test_what_can_not_be_is_refused_in_words(world: World, wanted: dict[str, object], words: str):
    body = {"cadences": {}, "time_zone": "UTC", "daily_at": "08:00"} | wanted
    answer = world.designer.put("/v1/me/mail-preferences", json=body)
    assert answer.status_code == 422, answer.text
    assert words in answer.json()["detail"]


@pytest.mark.slow
def test_news_of_a_day_is_one_mail_the_next_morning(world: World, mails: MailServer, monkeypatch: pytest.MonkeyPatch):
    save(world, cadences={"talk": "daily"})
    address = answer_a_question(world, "a_tool")
    answer_a_question(world, "a_bell")
    assert answers(mails, address) == []
    in_two_days = clock.now() + timedelta(days=2)
    monkeypatch.setattr(clock, "now", lambda: in_two_days)
    (text,) = answers(mails, address)
    assert text.index("a_tool") < text.index("a_bell")
    assert text.count("Shield Wing: your question is answered") == 2
    assert text.count("/sound-list/cues/") == 2, "each piece of news has its link"


@pytest.mark.slow
def test_what_is_turned_off_is_not_mailed_and_contracts_are(world: World, mails: MailServer):
    save(world, cadences=NEVER)
    address = answer_a_question(world, "a_tool")
    assert answers(mails, address) == []
    database = world.server.runtime.database
    with database.reading() as session:
        cadences = preferences.read(session, world.designer_id).cadence(News.CONTRACTS)
    assert cadences is Cadence.AT_ONCE


@pytest.mark.slow
def test_the_link_of_a_mail_turns_its_news_off_without_signing_in(world: World, mails: MailServer):
    address = answer_a_question(world, "a_tool")
    (text,) = answers(mails, address)
    (token,) = re.findall(r"Fewer mails like this: \S+/mails/(\S+)", text)
    path = f"/v1/mail-choices/{token}"
    shown = world.nobody.get(path).json()
    assert (shown["email"], shown["news"], shown["cadence"], shown["can_stop"]) == (address, ["talk"], "at_once", True)
    assert world.nobody.put(path, json={"cadence": "daily"}).json()["cadence"] == "daily"
    assert world.designer.get("/v1/me/mail-preferences").json()["cadences"]["talk"] == "daily"
    assert world.nobody.put(path, json={"cadence": "never"}).json()["cadence"] == "never"
    answer_a_question(world, "a_bell")
    assert len(answers(mails, address)) == 1


@pytest.mark.slow
def test_a_mail_program_stops_mails_by_one_click(world: World, mails: MailServer):
    address = answer_a_question(world, "a_tool")
    mails.texts_for(address)
    received = [message_from_bytes(each.content or b"", policy=policy.default) for each in mails.received]
    (message,) = [each for each in received if "your question is answered" in each["Subject"]]
    assert message["List-Unsubscribe-Post"] == "List-Unsubscribe=One-Click"
    (path,) = re.findall(r"<https?://[^/]+(/v1/mail-choices/\S+/stop)>", message["List-Unsubscribe"])
    form = {"content-type": "application/x-www-form-urlencoded"}
    assert world.nobody.post(path, content="List-Unsubscribe=One-Click", headers=form).status_code == 204
    assert world.designer.get("/v1/me/mail-preferences").json()["cadences"]["talk"] == "never"


@pytest.mark.slow
def test_what_waits_is_dropped_once_it_is_turned_off(world: World, mails: MailServer):
    world.server.runtime.settings.digest_delay_s = 3_600.0
    address = answer_a_question(world, "a_tool")
    with world.server.runtime.database.reading() as session:
        (waiting,) = [mail for mail in queries.pending_for(session, address) if mail.news == News.TALK]
    save(world, cadences=NEVER)
    mail_jobs.send_mail(world.server.runtime, {"mail_id": str(waiting.id)})
    assert answers(mails, address) == []
    with world.server.runtime.database.reading() as session:
        assert session.get(Mail, waiting.id) is None


@pytest.mark.slow
def test_no_one_else_can_make_a_link(world: World):
    secret = world.server.runtime.settings.secret_key.get_secret_value()
    good = preferences.link_token(secret, world.designer_id, News.TALK)
    forged = (
        preferences.link_token("another server", world.designer_id, News.TALK),
        preferences.link_token(secret, UUID(int=7), News.TALK),
        *(good[:place] + ("A" if good[place] != "A" else "B") + good[place + 1 :] for place in range(0, len(good), 3)),
        good[:10],
        "~~",
        "é",
    )
    assert world.nobody.get(f"/v1/mail-choices/{good}").status_code == 200
    for token in forged:
        assert world.nobody.get(f"/v1/mail-choices/{token}").status_code == 404, token
        assert world.nobody.post(f"/v1/mail-choices/{token}/stop").status_code == 404, token


def test_the_link_of_a_contracts_mail_makes_it_daily_and_does_not_stop_it(world: World):
    secret = world.server.runtime.settings.secret_key.get_secret_value()
    path = f"/v1/mail-choices/{preferences.link_token(secret, world.designer_id, News.CONTRACTS)}"
    assert world.nobody.get(path).json()["can_stop"] is False
    assert world.nobody.post(f"{path}/stop").status_code == 422
    assert world.nobody.put(path, json={"cadence": "daily"}).json()["cadence"] == "daily"


def test_the_link_of_a_days_news_is_about_all_that_may_be_turned_off(world: World):
    secret = world.server.runtime.settings.secret_key.get_secret_value()
    path = f"/v1/mail-choices/{preferences.link_token(secret, world.designer_id, None)}"
    assert world.nobody.get(path).json()["news"] == ["sounds", "talk", "mentions", "list", "hiring"]
    assert world.nobody.post(f"{path}/stop").status_code == 204
    cadences = world.designer.get("/v1/me/mail-preferences").json()["cadences"]
    assert cadences == {**NEVER, "contracts": "at_once"}
