"""Signed-in browsers: listed and ended by their owner, replaced by the next sign-in, and over after a while."""

from datetime import timedelta
from uuid import UUID

import pytest
from httpx2 import Client
from structlog.testing import capture_logs

from app.accounts.authentication import SESSION_COOKIE
from app.accounts.models import SignIn
from app.accounts.queries import IDLE_FOR
from app.accounts.rules import device_of
from app.core import clock
from tests.app.accounts.test_sign_in import address, sign_in, sign_up, with_csrf
from tests.support.server import RunningServer, World

FIREFOX = "Mozilla/5.0 (X11; Linux x86_64; rv:140.0) Gecko/20100101 Firefox/140.0"


@pytest.fixture
def account(server: RunningServer) -> tuple[Client, str]:
    browser, email = server.browser(), address()
    browser.headers["User-Agent"] = FIREFOX
    assert sign_up(browser, email).status_code == 201
    return with_csrf(browser), email


def elsewhere(server: RunningServer, email: str) -> Client:
    browser = server.browser()
    assert sign_in(browser, email).status_code == 200
    return with_csrf(browser)


def listed(browser: Client) -> list[dict[str, str]]:
    found: list[dict[str, str]] = browser.get("/v1/me/sign-ins").json()
    return found


def test_the_owner_sees_every_browser(server: RunningServer, account: tuple[Client, str]) -> None:
    browser, email = account
    elsewhere(server, email)
    found = listed(browser)
    assert len(found) == 2
    (current,) = [each for each in found if each["is_current"]]
    assert (current["device"], current["place"]) == ("Firefox on Linux", "testclient")


def test_one_is_ended(server: RunningServer, account: tuple[Client, str]) -> None:
    browser, email = account
    other = elsewhere(server, email)
    (other_id,) = [each["id"] for each in listed(browser) if not each["is_current"]]
    assert browser.delete(f"/v1/me/sign-ins/{other_id}").status_code == 204
    assert other.get("/v1/me").status_code == 401
    assert browser.get("/v1/me").status_code == 200
    assert browser.delete(f"/v1/me/sign-ins/{other_id}").json()["code"] == "sign-in-not-found"


def test_all_others_are_ended(server: RunningServer, account: tuple[Client, str]) -> None:
    browser, email = account
    others = [elsewhere(server, email) for _ in range(2)]
    assert browser.delete("/v1/me/sign-ins").status_code == 204
    assert [other.get("/v1/me").status_code for other in others] == [401, 401]
    assert len(listed(browser)) == 1


def test_nobody_ends_the_sign_in_of_another_person(
    server: RunningServer, account: tuple[Client, str], world: World
) -> None:
    (own,) = listed(account[0])
    assert world.producer.delete(f"/v1/me/sign-ins/{own['id']}").status_code == 404
    assert account[0].get("/v1/me").status_code == 200


def test_a_new_sign_in_replaces_the_one_of_the_same_browser(server: RunningServer, account: tuple[Client, str]) -> None:
    browser, email = account
    before = browser.cookies[SESSION_COOKIE]
    assert sign_in(browser, email).status_code == 200
    assert browser.cookies[SESSION_COOKIE] != before
    thief = server.browser()
    thief.cookies.set(SESSION_COOKIE, before)
    assert thief.get("/v1/me").status_code == 401
    assert len(listed(browser)) == 1


def test_a_sign_in_of_another_account_in_the_same_browser_ends_too(
    server: RunningServer, account: tuple[Client, str]
) -> None:
    before = account[0].cookies[SESSION_COOKIE]
    assert sign_up(account[0], address()).status_code == 201
    thief = server.browser()
    thief.cookies.set(SESSION_COOKIE, before)
    assert thief.get("/v1/me").status_code == 401


def set_last_seen(server: RunningServer, sign_in_id: str, ago: timedelta) -> None:
    with server.runtime.database.writing() as session:
        session.get_one(SignIn, UUID(sign_in_id)).last_seen_at = clock.now() - ago


def test_an_idle_browser_is_signed_out(server: RunningServer, account: tuple[Client, str]) -> None:
    browser, _ = account
    (own,) = listed(browser)
    set_last_seen(server, own["id"], IDLE_FOR - timedelta(hours=1))
    assert browser.get("/v1/me").status_code == 200
    set_last_seen(server, own["id"], IDLE_FOR)
    assert browser.get("/v1/me").status_code == 401


def test_use_is_noted_to_within_ten_minutes(server: RunningServer, account: tuple[Client, str]) -> None:
    browser, _ = account
    (own,) = listed(browser)
    set_last_seen(server, own["id"], timedelta(hours=3))
    browser.get("/v1/me")
    (seen,) = listed(browser)
    assert seen["last_seen_at"] > (clock.now() - timedelta(minutes=1)).isoformat()


@pytest.mark.parametrize(
    ("user_agent", "device"),
    [
        (FIREFOX, "Firefox on Linux"),
        ("Mozilla/5.0 (Windows NT 10.0) AppleWebKit/537.36 Chrome/140.0 Safari/537.36 Edg/140.0", "Edge on Windows"),
        ("Mozilla/5.0 (Linux; Android 15) AppleWebKit/537.36 Chrome/140.0 Mobile Safari/537.36", "Chrome on Android"),
        ("Mozilla/5.0 (iPhone; CPU iPhone OS 18_0 like Mac OS X) Version/18.0 Safari/604.1", "Safari on iOS"),
        ("curl/8.5.0", "curl"),
        ("", "Unknown browser"),
    ],
)
def test_a_browser_in_words(user_agent: str, device: str) -> None:
    assert device_of(user_agent) == device


def test_the_log_names_the_account_of_a_sign_in_and_shows_nothing_of_what_was_typed(server: RunningServer) -> None:
    browser, email = server.browser(), address()
    person_id = sign_up(browser, email).json()["id"]
    with capture_logs() as lines:
        sign_in(server.browser(), email)
        for typed in (email, "correct horse battery staple"):
            server.browser().post("/v1/sign-in", json={"email": typed, "password": "not the password"})
    done, refused, unknown = (line for line in lines if line["event"] in ("signed in", "sign-in refused"))
    assert (done["event"], done["person_id"], bool(done["place"])) == ("signed in", person_id, True)
    assert refused["event"] == unknown["event"] == "sign-in refused"
    assert refused["account"] != unknown["account"]
    assert not any(word in str(line) for line in lines for word in (email, "battery", "not the password"))
