"""Over TLS our cookies are bound to the host by their name."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from anyio.from_thread import start_blocking_portal
from httpx2 import Client

from app.core.runtime import Runtime
from app.core.web.host_cookies import PREFIX, bound, unbound
from app.main import create_app
from app.migrate import migrate
from app.settings import Settings
from tests.support.server import RunningServer

SIGN_UP = {
    "email": "producer@studio.example", "name": "Producer", "password": "correct horse battery", "studio_name": "Night"
}  # fmt: skip


@pytest.fixture(scope="module")
def behind_tls(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RunningServer]:
    """The application of people who reach it over TLS."""
    folder: Path = tmp_path_factory.mktemp("host_cookies")
    settings = Settings(data_dir=folder, secret_key="only for tests", base_url="https://sounds.example", sign_up="open")
    runtime = Runtime.of(settings)
    migrate(runtime.database)
    with start_blocking_portal() as portal:
        yield RunningServer(runtime, create_app(runtime), portal)
    runtime.database.dispose()


def browser_of(server: RunningServer) -> Client:
    browser = server.browser()
    browser.base_url = "https://sounds.example"
    return browser


@pytest.mark.slow
def test_a_session_lives_in_cookies_bound_to_the_host(behind_tls):
    browser = browser_of(behind_tls)
    answer = browser.post("/v1/sign-up", json=SIGN_UP)
    assert answer.status_code == 201
    given = answer.headers.get_list("set-cookie")
    assert len(given) == 3
    for cookie in given:
        assert cookie.startswith(f"{PREFIX}soundlist_")
        words = {word.strip().lower() for word in cookie.split(";")[1:]}
        assert {"secure", "path=/"} <= words
        assert not any(word.startswith("domain") for word in words)
    assert browser.get("/v1/me").status_code == 200

    signing_out = browser.post("/v1/sign-out", headers={"X-CSRF-Token": browser.cookies[f"{PREFIX}soundlist_csrf"]})
    assert signing_out.status_code == 204
    assert not [name for name in browser.cookies if name.endswith(("session", "csrf"))]


@pytest.mark.slow
def test_a_cookie_that_a_neighbour_could_have_set_signs_nobody_in(behind_tls):
    browser = browser_of(behind_tls)
    browser.post("/v1/sign-up", json=SIGN_UP | {"email": "other@studio.example"})
    secret = browser.cookies[f"{PREFIX}soundlist_session"]
    neighbour = browser_of(behind_tls)
    assert neighbour.get("/v1/me", headers={"Cookie": f"soundlist_session={secret}"}).status_code == 401
    assert neighbour.get("/v1/me", headers={"Cookie": f"{PREFIX}soundlist_session={secret}"}).status_code == 200


@pytest.mark.parametrize(
    ("set_cookie", "sent"),
    [
        ("soundlist_session=a; Path=/", "__Host-soundlist_session=a; Path=/; Secure"),
        ("soundlist_session=a; Secure; Path=/", "__Host-soundlist_session=a; Secure; Path=/"),
        ("other=soundlist_session; Path=/", "other=soundlist_session; Path=/"),
    ],
)
def test_what_is_set(set_cookie, sent):
    assert bound(set_cookie) == sent


@pytest.mark.parametrize(
    ("cookies", "known"),
    [
        ("__Host-soundlist_session=a; theme=dark", "soundlist_session=a; theme=dark"),
        ("soundlist_session=b; __Host-soundlist_session=a", "soundlist_session=a"),
        ("=;=;;", "=; ="),
        ("soundlist_session=b", ""),
    ],
)
def test_what_comes_back(cookies, known):
    assert unbound(cookies) == known
