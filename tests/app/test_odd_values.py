"""Values that databases and parsers stumble over are refused in words, wherever they come in."""

from uuid import uuid4

import pytest
from httpx2 import Client

from app.accounts.authentication import CSRF_HEADER
from tests.support.server import World

NUL = "the character U+0000"


def project(world: World, rest: str) -> str:
    return f"/v1/projects/{world.project_id}/{rest}"


@pytest.mark.parametrize("typed", ["²", "SW-²", "9" * 11, str(2**31), str(2**63), "9" * 5_000, "1" + "0" * 400])
def test_a_search_for_an_odd_number_finds_nothing(world: World, typed: str):
    answer = world.producer.get(project(world, "find"), params={"q": typed})
    assert answer.status_code in (200, 422), answer.text
    assert answer.status_code == 422 or answer.json()["hits"] == []


@pytest.mark.parametrize("cursor", ["²", "9" * 11, str(2**63), "9" * 5_000, "-1", "a.b.c"])
@pytest.mark.parametrize(
    "path", ["sound-list", "sound-list/progress", "spec/versions", "sound-list/revisions", "builds"]
)
def test_an_odd_cursor_is_refused(world: World, path: str, cursor: str):
    answer = world.producer.get(project(world, path), params={"cursor": cursor})
    assert (answer.status_code, answer.json()["code"]) in ((422, "bad-cursor"), (422, "invalid-request")), answer.text


@pytest.mark.parametrize("cursor", [f"{'9' * 19}.a", f"{2**63}.a", "².a", "1.", "9" * 5_000])
def test_an_odd_cursor_of_jobs_is_refused(world: World, cursor: str):
    answer = world.producer.get(f"/v1/studios/{world.studio_id}/jobs", params={"cursor": cursor})
    assert (answer.status_code, answer.json()["code"]) == (422, "bad-cursor")


def test_a_date_at_the_end_of_time_is_no_cursor(world: World):
    for instant in ("9999-12-31T23:59:59-14:00", "0001-01-01T00:00:00+14:00"):
        answer = world.producer.get(project(world, "change-requests"), params={"cursor": f"{instant}.{uuid4()}"})
        assert answer.status_code in (200, 422), answer.text


@pytest.mark.parametrize("number", [2**31, 2**63, 2**64, -1, "²"])
def test_an_odd_number_in_an_address_is_refused(world: World, number: int | str):
    for path in (f"spec/versions/{number}/spec.toml", f"sound-list/revisions/compare?from={number}&to={number}"):
        assert world.producer.get(project(world, path)).status_code in (404, 422), path


def test_a_nul_in_an_address_is_refused(world: World):
    for path in ("find?q=a%00b", "pack?target=%00", "jobs/%00/retry", "%00", "sound-list?%00=1"):
        answer = world.producer.get(project(world, path))
        assert (answer.status_code, answer.json()["code"]) == (400, "bad-address"), path
        assert NUL in answer.json()["detail"]
    assert world.producer.post(f"/v1/studios/{world.studio_id}/jobs/a%00b/retry").json()["code"] == "bad-address"


def build(label: str, target: str = "game") -> dict[str, object]:
    report = {"schema_version": 1, "tool": {"name": "x", "version": "1"}, "spec": None, "files": [], "summary": {}}
    return {"label": label, "target": target, "report": report}


def test_a_nul_in_a_body_is_refused(world: World):
    asked: list[tuple[str, dict[str, object], str]] = [
        (project(world, "builds"), build("1.0\0"), "label"),
        (project(world, "builds"), build("1.0", "ga\0me"), "target"),
        (project(world, "packs"), {"target": "\0"}, "target"),
        (
            f"/v1/invoices/{uuid4()}/payments",
            {"amount_minor": 1, "reference": "\0", "paid_on": "2026-11-20"},
            "reference",
        ),
    ]
    for path, body, field in asked:
        answer = world.producer.post(path, json=body)
        assert (answer.status_code, answer.json()["code"]) == (422, "unstorable"), path
        assert answer.json()["errors"][0]["where"].endswith(field)


def test_half_a_character_in_a_body_is_refused(world: World):
    body = b'{"name": "\\ud800"}'
    answer = world.producer.put("/v1/me", content=body, headers={"Content-Type": "application/json"})
    assert (answer.status_code, answer.json()["code"]) == (422, "invalid-request")


@pytest.mark.parametrize("origin", ["http://[::1", "http://[v1.x]", "null", "http://127.0.0.1:99999999"])
def test_an_odd_origin_is_another_page(world: World, origin: str):
    answer = world.producer.put("/v1/me", json={"name": "Ida"}, headers={"Origin": origin})
    assert (answer.status_code, answer.json()["code"]) == (403, "csrf-mismatch")
    assert world.producer.headers[CSRF_HEADER]


def test_an_address_of_5000_letters_is_a_page_or_nothing(nobody: Client):
    for path in ("/" + "a" * 5_000, "/" + "a/" * 2_500, "/assets/" + "a" * 5_000):
        assert nobody.get(path).status_code in (200, 404), path[:20]


@pytest.fixture
def nobody(world: World) -> Client:
    return world.nobody
