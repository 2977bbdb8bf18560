"""What a request may send, over real sockets: heads and bodies that are too large, too slow, or not what they say."""

import json
import select
import socket
import tracemalloc
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import Any

import pytest

from app.accounts import rate_limits
from app.accounts.rules import Audience
from app.core.web import bodies
from app.core.web.bodies import SMALL_BODY_BYTES
from app.routers import ROUTERS
from tests.house.routes import api_routes, policy_of
from tests.support.deliver import open_delivery
from tests.support.listening import listening
from tests.support.server import RunningServer, World

KIB, MIB = 1 << 10, 1 << 20


@pytest.fixture(scope="module")
def port(server: RunningServer) -> Iterator[int]:
    with listening(server.application, lifespan="off", ws="none") as port:
        yield port


@contextmanager
def connected(port: int) -> Iterator[socket.socket]:
    with socket.create_connection(("127.0.0.1", port), timeout=300) as line:
        yield line


def head(method: str, path: str, *headers: str) -> bytes:
    return "\r\n".join([f"{method} {path} HTTP/1.1", "Host: 127.0.0.1:8000", *headers, "", ""]).encode()


def answer_on(line: socket.socket) -> tuple[int, Any, bytes]:
    """Return status, problem and head of the first answer that comes until the server closes."""
    came = b""
    try:
        while piece := line.recv(65_536):
            came += piece
    except ConnectionResetError:
        pass
    first, _, body = came.partition(b"\r\n\r\n")
    problem = json.JSONDecoder().raw_decode(body.decode())[0] if body.startswith(b"{") else None
    return int(first.split()[1]) if first else 0, problem, first.lower()


JSON = "Content-Type: application/json"
TOO_LARGE = "this request may have 256 KiB; this one has "


def test_a_body_that_announces_too_much_is_refused_unread(port: int):
    with connected(port) as line:
        line.sendall(head("POST", "/v1/sign-in", JSON, f"Content-Length: {60 * MIB}") + b'{"email": "')
        status, problem, first = answer_on(line)
    assert (status, problem["code"]) == (413, "body-too-large")
    assert problem["detail"] == f"{TOO_LARGE}60 MiB"
    assert b"connection: close" in first


def test_a_body_without_a_length_is_counted(port: int):
    with connected(port) as line:
        line.sendall(head("POST", "/v1/sign-in", JSON, "Transfer-Encoding: chunked"))
        with suppress(OSError):  # cut
            for _ in range(64):
                line.sendall(b"%x\r\n%s\r\n" % (64 * KIB, b" " * 64 * KIB))
        status, problem, _ = answer_on(line)
    # A client that goes on sending may find the line cut before it reads the answer.
    assert (status, problem and problem["detail"]) in ((413, f"{TOO_LARGE}more"), (0, None))


def test_a_client_that_expects_100_continue_is_refused_at_once(port: int):
    with connected(port) as line:
        line.sendall(head("POST", "/v1/sign-in", JSON, f"Content-Length: {MIB}", "Expect: 100-continue"))
        status, _, first = answer_on(line)
    assert (status, b"100 continue" in first) == (413, False)


def test_a_stranger_is_turned_away_before_a_large_body_is_read(port: int, world: World):
    path = f"/v1/projects/{world.project_id}/sound-list/import"
    with connected(port) as line:
        line.sendall(
            head("POST", path, JSON, f"Content-Length: {4 * MIB}", "Expect: 100-continue", "Connection: close")
        )
        status, problem, first = answer_on(line)
    assert (status, problem["code"], b"100 continue" in first) == (401, "not-signed-in", False)


def test_a_large_sheet_of_a_signed_in_person_is_read(world: World):
    body = {"format": "csv", "text": "name\n" + "Radar ping\n" * 100_000, "dry_run": True}
    answer = world.producer.post(f"/v1/projects/{world.project_id}/sound-list/import", json=body)
    assert answer.status_code != 413
    assert len(json.dumps(body)) > MIB


def test_nobody_unknown_may_send_more_than_the_default_but_a_pdf_to_verify():
    routes = [route for router in ROUTERS for route in api_routes(router.routes)]
    large = [route for route in routes if getattr(route.endpoint, "body_limit", 0) > SMALL_BODY_BYTES]
    assert len(large) > 10
    policies = {route.name: policy_of(route) for route in large}
    for_anyone = [name for name, policy in policies.items() if policy is None or policy.audience is Audience.ANYONE]
    assert for_anyone == ["verify_pdf"]  # it counts the tries of a place, and then reads


def test_a_place_that_verified_too_many_pdfs_is_refused_before_another_is_read(
    port: int, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr(rate_limits, "VERIFICATIONS_FROM_NETWORK", rate_limits.Limit("files verified", 1, 600))
    with connected(port) as line:
        line.sendall(head("POST", "/v1/verify", "Content-Length: 6", "Connection: close") + b"no PDF")
        assert answer_on(line)[0] == 200
    with connected(port) as line:
        line.sendall(head("POST", "/v1/verify", f"Content-Length: {4 * MIB}", "Connection: close"))  # and no body
        status, problem, _ = answer_on(line)
    assert (status, problem["code"]) == (429, "too-many-attempts")


@pytest.mark.slow
def test_a_refused_body_costs_no_more_than_the_limit(port: int):
    much = b" " * 200 * MIB
    tracemalloc.start()
    try:
        with connected(port) as line:
            line.sendall(head("POST", "/v1/sign-in", JSON, f"Content-Length: {200 * MIB}"))
            with pytest.raises(OSError):  # noqa: PT011  a reset or a broken pipe: the line is cut
                line.sendall(much)
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert most < 4 * MIB


def test_a_body_that_trickles_is_cut(port: int, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(bodies, "FIRST_S", 0.3)
    with connected(port) as line:
        line.sendall(head("POST", "/v1/sign-in", JSON, "Content-Length: 200"))
        for _ in range(200):  # the last would be sent after ten seconds, and the whole be refused for what it says
            if select.select([line], [], [], 0.05)[0]:
                break
            line.sendall(b" ")
        status, problem, first = answer_on(line)
    assert (status, problem["code"]) == (408, "body-too-slow")
    assert b"connection: close" in first


def test_a_body_shorter_than_it_says_hurts_nobody(port: int):
    with connected(port) as line:
        line.sendall(head("POST", "/v1/sign-in", JSON, "Content-Length: 100") + b"{}")
        line.shutdown(socket.SHUT_WR)
        answer_on(line)
    with connected(port) as line:
        line.sendall(head("GET", "/healthz", "Connection: close"))
        assert answer_on(line)[0] == 200


def test_what_follows_a_body_is_no_second_request(port: int):
    body = b"{}"
    with connected(port) as line:
        line.sendall(head("POST", "/v1/sign-in", JSON, "Content-Length: 2") + body + b"garbage\r\n\r\n")
        status, _, _ = answer_on(line)
    assert status in (0, 400, 422)  # cut, at the latest once the first was answered


@pytest.mark.parametrize(
    ("body", "words"),
    [
        (b"[" * 250_000, "nested"),
        (b'{"email": ' * 20_000, "nested"),
        (b'{"email": "a\\u0000b", "password": "x"}', "email: the character U+0000 cannot be stored"),
        (b'{"email": "\\ud800", "password": "x"}', "hex escape"),
        (b'{"email": 9999999999999999999, "password": "x"}', "email: a whole number may be 9007199254740991"),
        (b'{"email": 1e999, "password": "x"}', "email: a number may be 1.8e308"),
        (b'{"email": NaN}', "JSON"),
        (b"\xff\xfe", "JSON"),
    ],
)
def test_json_beyond_its_limits_is_refused_with_a_reason(server: RunningServer, body: bytes, words: str):
    answer = server.browser().post("/v1/sign-in", content=body, headers={"Content-Type": "application/json"})
    assert (answer.status_code, words in answer.json()["detail"]) == (422, True), answer.text


JSON_TYPE = {"Content-Type": "application/json"}


def unknown(names: int) -> str:
    return "{" + ",".join(f'"{number}":0' for number in range(names)) + "}"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("write_body", "code"),
    [
        (lambda: unknown(600_000), "too-many-names"),
        (
            lambda: f'{{"format": "csv", "text": "name", "dry_run": true, "mapping": {unknown(600_000)}}}',
            "too-many-names",
        ),
        (lambda: f'{{"cues": [{",".join([unknown(800)] * 1000)}]}}', "too-many-names"),
        (lambda: f'{{"cues": [{",".join([unknown(50)] * 1000)}]}}', "invalid-request"),
    ],
    ids=["names", "names of a table", "objects with many names", "objects with some names"],
)
def test_unknown_names_without_number_hold_nobody_up(world: World, write_body: Callable[[], str], code: str):
    body = write_body()
    path = "sound-list/import" if "mapping" in body else "cues"
    answer = world.producer.post(f"/v1/projects/{world.project_id}/{path}", content=body, headers=JSON_TYPE)
    # Names without number are counted first. A schema that refused 600,000 took 10 s, and answered with 180 MB.
    assert (answer.status_code, len(answer.content) < 20_000) == (422, True), answer.text[:300]
    assert answer.json()["code"] == code


def test_an_honest_body_may_have_many_names():
    body = {
        "cues": [{f"field {number}": {} for number in range(50)}] * 1000,
        "files": dict.fromkeys(map(str, range(9_000))),
    }
    assert bodies.read_json(json.dumps(body).encode()) == body


def test_a_backslash_before_u0000_is_text():
    assert bodies.read_json(b'["\\\\u0000"]') == ["\\u0000"]


def test_an_upload_may_not_send_more_than_any_file_has(world: World):
    answer = world.designer.put(
        "/v1/uploads",
        params={"delivery_id": open_delivery(world), "file_name": "a.wav"},
        headers={"Content-Length": str(6 << 30)},
        content=b"",
    )
    assert (answer.status_code, answer.json()["code"]) == (413, "upload-too-long")
