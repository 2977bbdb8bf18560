"""The headers for browsers and caches on every answer of every route."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from anyio.from_thread import start_blocking_portal
from httpx2 import Headers

from app.core.runtime import Runtime
from app.core.web.http import SAFE_METHODS
from app.main import create_app
from app.migrate import migrate
from app.settings import Settings
from tests.house.objects import House
from tests.house.routes import ask, operations
from tests.support.server import RunningServer

EXPECTED = {
    "x-content-type-options": "nosniff",
    "x-frame-options": "DENY",
    "referrer-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "strict-transport-security": "max-age=31536000",
}


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RunningServer]:
    """The application as it is behind TLS, with a built frontend."""
    folder = tmp_path_factory.mktemp("headers")
    frontend = folder / "frontend"
    for name in (
        "index.html",
        "docs/index.html",
        "help/index.html",
        "help/how-to/review.html",
        "assets/index-1a2b.js",
        "mark.svg",
    ):
        (frontend / name).parent.mkdir(parents=True, exist_ok=True)
        (frontend / name).write_text(f"<!doctype html>{name}")
    runtime = Runtime.of(
        Settings(data_dir=folder, secret_key="only for tests", base_url="https://sounds.example", frontend_dir=frontend)
    )
    migrate(runtime.database)
    with start_blocking_portal() as portal:
        yield RunningServer(runtime, create_app(runtime), portal)
    runtime.database.dispose()


def wrong(headers: Headers) -> dict[str, str | None]:
    """Return the headers that are not as every answer's are; the policy is that of an answer of the API."""
    found = {name: headers.get(name) for name, wanted in EXPECTED.items() if headers.get(name) != wanted}
    policy = headers.get("content-security-policy", "")
    if "sandbox" not in policy and policy != "default-src 'none'; frame-ancestors 'none'":
        found["content-security-policy"] = policy
    return found


def wrong_of_page(headers: Headers) -> dict[str, str | None]:
    """Return the headers that are not as those of a page are."""
    found = wrong(headers)
    policy = found.pop("content-security-policy", "") or ""
    if not ("script-src 'self'" in policy and "frame-ancestors 'none'" in policy and "object-src 'none'" in policy):
        found["content-security-policy"] = policy
    if headers.get("cross-origin-opener-policy") != "same-origin":
        found["cross-origin-opener-policy"] = headers.get("cross-origin-opener-policy")
    if "camera=()" not in headers.get("permissions-policy", ""):
        found["permissions-policy"] = headers.get("permissions-policy")
    return found


@pytest.mark.slow
def test_no_answer_of_the_api_is_kept_by_a_shared_cache(served: RunningServer):
    house = House(served)
    kept = set()
    for operation in sorted(operations(), key=lambda one: one.method not in SAFE_METHODS):
        for client in (house.producer, house.designer, house.nobody):
            answer = ask(client, house, operation)
            assert wrong(answer.headers) == {}, operation.name
            caching = answer.headers["cache-control"]
            assert caching == "no-store" or caching.startswith("private, "), operation.name
            if "immutable" in caching:
                kept.add(operation.name)
    assert kept
    assert not {name for name in kept if "master" in name or "download" in name}, kept


@pytest.mark.slow
@pytest.mark.parametrize(
    ("path", "status", "caching"),
    [
        ("/", 200, "no-cache"),
        ("/projects/1", 200, "no-cache"),
        ("/docs", 200, "no-cache"),
        ("/help/how-to/review.html", 200, "no-cache"),
        ("/mark.svg", 200, "no-cache"),
        ("/assets/index-1a2b.js", 200, "public, max-age=31536000, immutable"),
        ("/assets/nothing.js", 404, "no-store"),
        ("/v1/nothing", 404, "no-store"),
        ("/v1/openapi.json", 200, "no-store"),
        ("/healthz", 200, "no-store"),
        ("/metrics", 404, "no-store"),
        ("/a%00b", 400, "no-store"),
        ("/" + "a" * 5_000, 200, "no-cache"),
    ],
)
def test_pages_and_files_say_how_long_they_are_kept(served: RunningServer, path: str, status: int, caching: str):
    answer = served.browser().get(path)
    assert (answer.status_code, answer.headers["cache-control"]) == (status, caching)
    if path.startswith("/v1/"):
        assert wrong(answer.headers) == {}
    elif path.startswith("/assets/"):  # a worker may load what its page may: of our own
        assert wrong(answer.headers) == {"content-security-policy": "default-src 'self'; frame-ancestors 'none'"}
    else:
        assert wrong_of_page(answer.headers) == {}


def test_the_documentation_is_a_page_of_our_own(served: RunningServer):
    assert served.browser().get("/docs").text == "<!doctype html>docs/index.html"
    for path in (Path(__file__).resolve().parents[2] / "frontend" / "docs").iterdir():
        assert "https://" not in path.read_text()


def test_the_guides_are_pages_of_our_own(served: RunningServer):
    browser = served.browser()
    sent_on = browser.get("/help", follow_redirects=False)
    assert (sent_on.status_code, sent_on.headers["location"]) == (307, "/help/")
    assert browser.get("/help/").text == "<!doctype html>help/index.html"
    page = browser.get("/help/how-to/review.html")
    assert page.text == "<!doctype html>help/how-to/review.html"
    assert wrong_of_page(page.headers) == {}


@pytest.mark.slow
def test_signing_out_clears_what_the_browser_kept(served: RunningServer):
    answer = House(served).producer.post("/v1/sign-out")
    assert (answer.status_code, answer.headers["clear-site-data"]) == (204, '"cache", "storage"')


@pytest.mark.slow
def test_a_fault_carries_the_headers_too(served: RunningServer, monkeypatch: pytest.MonkeyPatch):
    def broken(*_: object) -> None:
        raise ZeroDivisionError

    house = House(served)
    monkeypatch.setattr("app.accounts.authentication.authenticate_request", broken)
    answer = house.nobody.get("/v1/me")
    assert (answer.status_code, answer.headers["cache-control"], wrong_of_page(answer.headers)) == (500, "no-store", {})
