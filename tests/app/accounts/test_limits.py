"""Guesses are slowed down for the person who guesses, and for no one else: behind proxies and over processes too."""

import dataclasses
import time
from types import SimpleNamespace
from uuid import uuid4

import pytest
from httpx2 import Client

from app.accounts import rate_limits
from app.accounts.authentication import (
    DEVICE_COOKIE,
    SESSION_COOKIE,
    RequestCredentials,
    caller_key,
    device_cookie,
    device_for,
)
from app.accounts.errors import TooManyAttempts
from app.accounts.rate_limits import Limit
from app.accounts.rules import network_of
from app.core.db import Database
from app.main import create_app
from tests.app.accounts.test_sign_in import address, sign_in, sign_up, with_csrf
from tests.support import client as clients
from tests.support.server import RunningServer, World

PROXY = "10.9.0.2"


def behind_proxy(server: RunningServer, visitor: str, *, proxy: str = PROXY, trusted: str = "10.9.0.0/24") -> Client:
    """A browser whose requests come through a proxy, which appends the visitor's address as proxies do."""
    settings = server.runtime.settings.model_copy(update={"trusted_proxies": (trusted,)})
    application = create_app(dataclasses.replace(server.runtime, settings=settings))
    client = clients.browser(application, server.portal, (proxy, 50_000))
    client.headers["X-Forwarded-For"] = f"203.0.113.99, {visitor}"  # the left one is whatever the visitor sent
    return client


@pytest.fixture
def account(server: RunningServer) -> str:
    email = address()
    assert sign_up(server.browser(), email).status_code == 201
    return email


def wrong_guesses(browser: Client, email: str, count: int) -> list[int]:
    return [sign_in(browser, email, f"guess {n} of many").status_code for n in range(count)]


@pytest.mark.slow
def test_an_attacker_behind_the_proxy_holds_up_no_one_else(server: RunningServer, account: str) -> None:
    attacker = behind_proxy(server, "198.51.100.7")
    assert wrong_guesses(attacker, account, 12)[-1] == 429
    assert sign_in(behind_proxy(server, "198.51.100.8"), account).status_code == 200


@pytest.mark.slow
def test_what_an_untrusted_peer_says_of_the_visitor_counts_for_nothing(server: RunningServer, account: str) -> None:
    for n in range(12):  # a new address each time, from one peer that is not a proxy of ours
        browser = behind_proxy(server, f"198.51.100.{n}", proxy="192.0.2.1")
        status = sign_in(browser, account, f"guess {n}").status_code
    assert status == 429


def test_the_own_browser_may_sign_in_while_others_guess(server: RunningServer, account: str) -> None:
    own = behind_proxy(server, "198.51.100.20")
    assert sign_in(own, account).status_code == 200
    with server.runtime.database.writing() as session:
        for _ in range(rate_limits.SIGN_INS_TO_ACCOUNT.burst):
            rate_limits.count_attempt(session, rate_limits.SIGN_INS_TO_ACCOUNT, account)
    stranger = sign_in(behind_proxy(server, "198.51.100.21"), account)
    assert (stranger.status_code, 0 < int(stranger.headers["Retry-After"]) <= 30) == (429, True)
    assert sign_in(own, account).status_code == 200


def test_a_device_is_known_for_its_account_alone(server: RunningServer) -> None:
    settings = server.runtime.settings
    cookie = device_cookie(settings, "ada@studio.example")
    assert device_for(settings, cookie, "ada@studio.example") is not None
    for forged in (cookie[:-1] + ("0" if cookie[-1] != "0" else "1"), "", ".", "x.y", cookie.partition(".")[0]):
        assert device_for(settings, forged, "ada@studio.example") is None
    assert device_for(settings, cookie, "bo@studio.example") is None


def test_the_device_cookie_is_out_of_reach_of_scripts(server: RunningServer) -> None:
    answer = sign_up(server.browser(), address())
    (line,) = [line for line in answer.headers.get_list("set-cookie") if line.startswith(f"{DEVICE_COOKIE}=")]
    assert "httponly" in line.lower()


@pytest.mark.slow
def test_a_device_guesses_no_faster_than_others(server: RunningServer, account: str) -> None:
    browser = server.browser()
    assert sign_in(browser, account).status_code == 200
    assert wrong_guesses(browser, account, 11) == [401] * 10 + [429]


def test_processes_count_together(server: RunningServer, account: str) -> None:
    second = Database(server.runtime.database.url)
    try:
        limit = Limit("of a test", 3, 3600)
        for database in (server.runtime.database, second, server.runtime.database):
            with database.writing() as session:
                rate_limits.count_attempt(session, limit, account)
        with second.writing() as session, pytest.raises(TooManyAttempts) as refused:
            rate_limits.count_attempt(session, limit, account)
        assert 3500 < refused.value.retry_after_s <= 3600
    finally:
        second.dispose()


@pytest.fixture
def clock_s(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """The time that limits go by, which moves when the test moves it."""
    reading = [time.time()]
    monkeypatch.setattr(rate_limits, "time", SimpleNamespace(time=lambda: reading[0]))
    return reading


def test_after_the_first_tries_one_comes_back_at_a_time(
    server: RunningServer, account: str, clock_s: list[float]
) -> None:
    limit = Limit("of a test", 2, 40)

    def tries() -> bool:
        with server.runtime.database.writing() as session:
            try:
                rate_limits.count_attempt(session, limit, account)
            except TooManyAttempts:
                return False
        return True

    assert [tries() for _ in range(3)] == [True, True, False]
    clock_s[0] += 39
    assert not tries()
    clock_s[0] += 2
    assert [tries() for _ in range(2)] == [True, False]


def test_what_holds_nobody_is_cleared_away(server: RunningServer, account: str, clock_s: list[float]) -> None:
    with server.runtime.database.writing() as session:
        rate_limits.count_attempt(session, Limit("short", 2, 60), account)
        rate_limits.count_attempt(session, Limit("long", 1, 3600), account)
    clock_s[0] += 120
    with server.runtime.database.writing() as session:
        rate_limits.delete_expired(session)
        rate_limits.count_attempt(session, Limit("short", 1, 60), account)
        with pytest.raises(TooManyAttempts):
            rate_limits.count_attempt(session, Limit("long", 1, 3600), account)


@pytest.mark.parametrize(
    ("address", "place"),
    [
        ("192.0.2.7", "192.0.2.7"),
        ("::ffff:192.0.2.7", "192.0.2.7"),
        ("2001:db8:1:2:3:4:5:6", "2001:db8:1:2::/64"),
        ("2001:db8:1:2:ffff::1", "2001:db8:1:2::/64"),
        ("2001:db8:1:3::1", "2001:db8:1:3::/64"),
        ("testclient", "testclient"),
    ],
)
def test_an_ipv6_subscriber_is_one_place(address: str, place: str) -> None:
    assert network_of(address) == place


def test_evidence_of_a_sign_in_names_the_visitor_and_not_the_proxy(server: RunningServer, account: str) -> None:
    browser = behind_proxy(server, "198.51.100.30")
    sign_in(browser, account)
    (current,) = [each for each in browser.get("/v1/me/sign-ins").json() if each["is_current"]]
    assert current["place"] == "198.51.100.30"


def key_of(browser: Client | None = None, *, cookie: str = "", bearer: str = "", address: str = "192.0.2.1") -> str:
    """Return by whom a request counts: with a browser's cookie, another cookie, a token, or nothing."""
    secret = browser.cookies[SESSION_COOKIE] if browser else cookie
    headers = {"authorization": f"bEARER  {bearer} "} if bearer else {}
    return caller_key(RequestCredentials("GET", headers, {SESSION_COOKIE: secret}, address))


def test_a_person_has_one_turn_in_all_their_browsers_and_from_everywhere(server: RunningServer, account: str) -> None:
    browsers = [server.browser() for _ in range(3)]
    for browser in browsers:
        assert sign_in(browser, account).status_code == 200
        assert browser.get("/v1/me").status_code == 200
    keys = {key_of(browser, address=address) for browser in browsers for address in ("192.0.2.1", "198.51.100.1")}
    assert len(keys) == 1
    assert keys.pop().startswith("person ")
    other = server.browser()
    assert sign_up(other, address()).status_code == 201
    assert other.get("/v1/me").status_code == 200
    assert key_of(other) != key_of(browsers[0])


def test_who_sends_another_secret_each_time_counts_as_their_network() -> None:
    keys = {key_of(cookie=f"made up {number}") for number in range(20)}
    keys |= {key_of(bearer=f"slt_made_up_{number}") for number in range(20)}
    assert keys == {key_of()} == {"network 192.0.2.1"}
    assert key_of(address="198.51.100.1") != key_of()
    assert key_of(address="2001:db8:1:2::1") == key_of(cookie="made up", address="2001:db8:1:2:ffff::9")


def test_a_secret_that_is_good_no_more_counts_as_its_network(server: RunningServer, account: str) -> None:
    browser, elsewhere = server.browser(), server.browser()
    assert sign_in(browser, account).status_code == sign_in(elsewhere, account).status_code == 200
    assert browser.get("/v1/me").status_code == 200
    with_csrf(elsewhere).delete("/v1/me/sign-ins")
    assert browser.get("/v1/me").status_code == 401
    assert key_of(browser) == key_of()


def test_the_builds_of_a_project_have_one_turn(world: World) -> None:
    tokens = f"/v1/projects/{world.project_id}/tokens"
    body = {"name": "CI", "scopes": ["spec:read"]}
    secrets = [world.producer.post(tokens, json=body).json()["secret"] for _ in range(2)]
    for secret in secrets:
        headers = {"Authorization": f"Bearer {secret}"}
        assert world.nobody.get(f"/v1/projects/{world.project_id}/spec", headers=headers).status_code == 200
    assert {key_of(bearer=secret) for secret in secrets} == {f"project {world.project_id}"}


def test_mails_are_counted_for_the_mailbox_behind_an_address(server: RunningServer) -> None:
    reset, name = "/v1/password-resets", uuid4().hex
    statuses = [
        server.browser().post(reset, json={"email": f"{name}+{number}@studio.example"}).status_code
        for number in range(rate_limits.MAILS_TO_ADDRESS.burst + 1)
    ]
    assert statuses == [202] * rate_limits.MAILS_TO_ADDRESS.burst + [429]
    assert server.browser().post(reset, json={"email": f"{name}x@studio.example"}).status_code == 202


def test_invitations_are_counted_for_the_mailbox_whoever_sends_them(world: World) -> None:
    name, most = uuid4().hex, rate_limits.INVITATIONS_TO_MAILBOX.burst
    senders = (
        (world.producer, f"/v1/studios/{world.studio_id}/invitations", {"roles": ["reviewer"]}),
        (world.approver, f"/v1/projects/{world.project_id}/invitations", {"kind": "contract"}),
    )
    statuses = []
    for number in range(most + 1):
        by, path, body = senders[number % 2]
        statuses.append(by.post(path, json={**body, "email": f"{name}+{number}@studio.example"}).status_code)
    assert statuses == [201] * most + [429]
    by, path, body = senders[0]
    assert by.post(path, json={**body, "email": f"{name}x@studio.example"}).status_code == 201
