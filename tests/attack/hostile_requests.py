"""Requests as an attacker writes them: every route, with values that parsers, databases and arithmetic stumble over.

`hostile_requests(seed, routes, ids)` yields them without end. `python -m tests.attack.hostile_requests` sends many to
the whole application as every role, and prints each way in which it answered with a 500.
"""

import argparse
import base64
import json
import random
import sys
import tempfile
import traceback
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import quote, unquote

from anyio.from_thread import start_blocking_portal
from httpx2 import Client

from app import logs
from app.core.runtime import Runtime
from app.main import create_app
from app.migrate import migrate
from app.settings import Settings
from tests.house.objects import House
from tests.house.routes import TUS, Named, Operation, document, example, operations
from tests.support.postgres import running_postgres
from tests.support.server import RunningServer

MAX_SHOWN = 40
ENDLESS = {"watch_changes"}  # its answer goes on; tests/app/dashboards/test_events.py sends it odd headers
HOUSE_LIFETIME = 500  # requests; they end contracts and delete things
ROLES = ("nobody", "producer", "approver", "reviewer", "designer", "stranger", "build")
PAGES = ("/", "/assets/{path}", "/healthz", "/readyz", "/metrics", "/docs", "/v1/openapi.json", "/v1/{path}", "/{path}")

TEXTS = (
    "", " ", "\0", "a\0b", "\ud800", "a\udfffb", "\u202e\u05d0\u05d1", "\ufeff", "\u0130", "²", "٣", "½", "Ⅷ", "𝟙",
    "-1", "0", "1e309", "NaN", "Infinity", "null", "true", "[]", "{}", "%00", "%ED%A0%80", "%s%n", "{0.__class__}",
    "..", "../../../etc/passwd", "..\\..\\windows", "/etc/passwd", "C:\\", "a/b", "//", ".", "~", "CON", "a" * 300,
    "a" * 5_000, "é" * 3_000, "9" * 20, "9" * 400, "9" * 5_000, "-" + "9" * 400, "0x10", "1_000", " 1 ", "+1", "1.5",
    str(2**31), str(2**63), str(2**64), "'; DROP TABLE x; --", "' OR 1=1 --", "<script>alert(1)</script>", "=1+1",
    "\r\nX: y", "\t", "\x7f", "\x1b[2J", "00000000-0000-0000-0000-000000000000", "0001-01-01", "9999-12-31",
    "2026-02-30", "9999-12-31T23:59:59.999999+14:00",
    "0001-01-01T00:00:00+14:00.00000000-0000-0000-0000-000000000000", "a@b",
    "a" * 64 + "@example.test", "a@" + "b" * 250, "-00:00", "1.2", f"{2**31}.{2**31}", f"{2**63}.{2**63}",
    f"{'9' * 19}.a",
    "²." + "²", "1.", ".1", "." * 1_000, "((((a+)+)+)+)$" + "a" * 40, "format = 1", "a." * 2_000 + "a = 1",
)  # fmt: skip
NUMBERS = (
    0, -0.0, -1, 1, 2, 1.5, 2**15, 2**31 - 1, 2**31, -(2**31) - 1, 2**53, 2**63 - 1, 2**63, -(2**63) - 1, 2**64,
    10**400,
    1e308, -1e308, 5e-324, 0.1,
)  # fmt: skip
ODD_VALUES: tuple[Any, ...] = (None, True, False, [], {}, [[]], [None], {"": ""}, {"a": {"b": [1, {"c": None}]}})
RAW_BODIES = (
    b"", b"{", b"nonsense", b"null", b"[]", b"0", b'""', b"[" * 100_000, b'{"a":' * 30_000, b"\xff\xfe\x00",
    b"\xef\xbb\xbf{}",
    b'{"a": NaN}', b'{"a": 1e999}', b'{"a": "\\ud800"}', b'{"a": "\\u0000"}', b'{"\\u0000": 1}', b"9" * 5_000, b'"\\',
    b'{"a": 1, "a": 2}', b" " * 300_000, b"[" + b"0," * 60_000 + b"0]", b"{}" + b"\0",
)  # fmt: skip
HEADERS: tuple[tuple[str, Sequence[str]], ...] = (
    ("Range", ("bytes=0-", "bytes=-1", "bytes=-0", "bytes=5-2", "bytes=" + "9" * 5_000 + "-", "bytes=0-" + "9" * 5_000,
               "bytes=-" + "9" * 5_000, "bytes=0-0,1-1", "bytes=" + ",".join(["0-"] * 500), "items=0-1", "bytes=²-",
               "x")),
    ("If-None-Match", ("*", '"', 'W/"a"', '"' + "a" * 5_000 + '"', "é")),
    ("If-Range", ('"a"', "Wed, 99 Foo 2026", "é")),
    ("If-Modified-Since", ("Wed, 99 Foo 2026", "Thu, 01 Jan 1970 00:00:00 GMT", "9" * 5_000)),
    ("Origin", ("http://[::1", "null", "http://", "é", "http://127.0.0.1:99999999", "http://[v1.x]",
                "http://evil.example")),
    ("Host", ("", "[::1", "a" * 300, "127.0.0.1:99999999", "127.0.0.1:²", "evil.example", "é")),
    ("Cookie", ("soundlist_session=", "soundlist_session=é", 'soundlist_session="\\377"', "=;=;;", "a" * 8_000,
                "soundlist_demo_part=designer", "; ".join(["a=b"] * 500))),
    ("Authorization", ("Bearer", "Bearer ", "Bearer é", "Basic !!!!", "Bearer slt_" + "a" * 5_000, "²")),
    ("X-CSRF-Token", ("", "é", "a" * 5_000)),
    ("Idempotency-Key", ("", "a", "é", "a" * 5_000, "same")),
    ("Content-Type", ("", "application/json; charset=utf-16", "text/plain", "multipart/form-data", "é", "application/",
                      "application/x-www-form-urlencoded", "application/offset+octet-stream",
                      "application/json;" * 200)),
    ("Content-Length", ("-1", "²", "9" * 30, "abc")),
    ("Content-Encoding", ("gzip", "br", "é")),
    ("Accept", ("", "*/*;q=é", "application/xml")),
    ("X-Request-ID", ("", "\t", "a" * 5_000, "é")),
    ("X-Forwarded-For", ("²", "1.2.3.4, , é", "a" * 5_000)),
    ("Upload-Length", ("-1", "²", "9" * 18, "9" * 5_000, "0", "1e3")),
    ("Upload-Offset", ("-1", "²", "9" * 18, "9" * 5_000, "1")),
    ("Upload-Checksum", ("sha256", "sha256 é", "md5 aaaa", "sha256 ====", "sha1 " + "A" * 5_000)),
    ("Upload-Metadata", ("", ",,,", "delivery_id", "delivery_id é", "file_name AA==", "delivery_id AA==,file_name /w==",
                         ",".join(["a b"] * 1_000))),
    ("Upload-Defer-Length", ("1", "²")),
    ("Tus-Resumable", ("0.2.2", "²", "")),
    ("Repr-Digest", ("sha-256=:AAAA:", "sha-256=:é:", "sha-256=" + ":" * 1_000)),
    ("X-Content-SHA256", ("0" * 64, "g" * 64, "²" * 64, "")),
)  # fmt: skip


@dataclass(frozen=True)
class HostileRequest:
    """One request: what is on the request line, its headers in bytes, and its body."""

    route: str
    method: str
    target: str  # percent-encoded
    headers: tuple[tuple[bytes, bytes], ...]
    body: bytes

    def __str__(self) -> str:
        headers = {name.decode(): value[:80].decode("latin-1") for name, value in self.headers}
        return f"{self.route}: {self.method} {self.target[:200]} {headers} {self.body[:200]!r}"


def hostile_requests(seed: int, routes: Sequence[Operation], ids: Mapping[str, Any]) -> Iterator[HostileRequest]:
    """Yield requests without end: one seed, one sequence; `ids` fills path parameters with things that exist."""
    writer = _Writer(random.Random(seed), ids)
    ending = [route for route in routes if route.name not in ENDLESS]
    while True:
        yield writer.request(ending)


class _Writer:
    def __init__(self, chance: random.Random, ids: Mapping[str, Any]) -> None:
        self._chance = chance
        self._ids = ids

    def request(self, routes: Sequence[Operation]) -> HostileRequest:
        if self._chance.random() < 0.04:
            path = self._chance.choice(PAGES).format(path=self._quoted(self._chance.choice(TEXTS)))
            method = self._chance.choice(("GET", "GET", "HEAD", "POST", "OPTIONS", "TRACE"))
            return HostileRequest("page", method, path, tuple(self._headers({})), b"")
        route = self._chance.choice(routes)
        said = document()["paths"][route.path][route.method.lower()]
        path = "/".join(self._segment(part) for part in route.path.split("/"))
        query = self._query(said)
        headers: dict[str, str] = {}
        body = self._body(said, headers)
        if "uploads" in route.path:
            self._prepare_upload(headers)
        method = route.method if self._chance.random() < 0.98 else self._chance.choice(("PUT", "PATCH", "QUERY", "x"))
        return HostileRequest(route.name, method, path + query, tuple(self._headers(headers)), body)

    def _segment(self, part: str) -> str:
        if not part.startswith("{"):
            return part
        name = part[1:-1]
        if name in self._ids and self._chance.random() < 0.9:
            return str(self._ids[name])
        return self._quoted(self._text() or "x").replace("/", "%2F")

    def _query(self, said: Mapping[str, Any]) -> str:
        pairs = []
        for parameter in said.get("parameters", ()):
            if parameter["in"] != "query" or (not parameter.get("required") and self._chance.random() < 0.5):
                continue
            name = parameter["name"]
            for _ in range(self._chance.choice((1, 1, 1, 2, 40))):
                value = self._ids.get(name) if self._chance.random() < 0.5 else None
                pairs.append(f"{name}={self._quoted(str(value if value is not None else self._text()))}")
        if self._chance.random() < 0.05:
            pairs.append(f"{self._quoted(self._text())}={self._quoted(self._text())}")
        return "?" + "&".join(pairs) if pairs else ""

    def _body(self, said: Mapping[str, Any], headers: dict[str, str]) -> bytes:
        content = said.get("requestBody", {}).get("content", {})
        if not content:
            return b"x" if self._chance.random() < 0.02 else b""
        json_type = content.get("application/json")
        if json_type is None:
            return self._chance.choice((b"", b"the bytes of a sound", b"\0" * 10_000))
        headers["Content-Type"] = "application/json"
        if self._chance.random() < 0.05:
            return self._chance.choice(RAW_BODIES)
        value = self._value(json_type["schema"], "")
        for _ in range(self._chance.choice((0, 1, 1, 1, 2, 3))):
            value = self._spoilt(value)
        return json.dumps(value).encode("utf-8", "surrogatepass")

    def _value(self, schema: Mapping[str, Any], name: str, depth: int = 0) -> Any:
        """Return a value that the schema accepts, with optional fields now and then."""
        if "$ref" in schema:
            return self._value(document()["components"]["schemas"][schema["$ref"].rpartition("/")[2]], name, depth)
        if "anyOf" in schema:
            return self._value(self._chance.choice(schema["anyOf"]), name, depth)
        if "enum" in schema:
            return self._chance.choice(schema["enum"])
        match schema.get("type"):
            case "object" if "properties" in schema:
                required = schema.get("required", ())
                return {
                    key: self._value(one, key, depth + 1)
                    for key, one in schema["properties"].items()
                    if key in required or self._chance.random() < 0.5
                }
            case "object" | None:
                return {}
            case "null":
                return None
            case "array":
                count = max(schema.get("minItems", 0), self._chance.choice((0, 1, 2)) if depth < 4 else 0)
                return [self._value(schema["items"], name.removesuffix("s"), depth + 1) for _ in range(count)]
            case "string" if schema.get("format") in ("date", "date-time"):
                return "2026-11-20" if schema["format"] == "date" else "2026-11-20T10:00:00Z"
            case _:
                return self._filled(example(dict(schema), name))

    def _filled(self, value: Any) -> Any:
        return str(self._ids.get(value.name, "x")) if isinstance(value, Named) else value

    def _spoilt(self, value: Any) -> Any:
        """Return the value with something hostile at one place in it."""
        if isinstance(value, dict) and value and self._chance.random() < 0.95:
            key = self._chance.choice(list(value))
            if self._chance.random() < 0.05:
                return {**value, self._text(): value[key]}
            return {**value, key: self._spoilt(value[key])}
        if isinstance(value, list) and value and self._chance.random() < 0.7:
            place = self._chance.randrange(len(value))
            return [*value[:place], self._spoilt(value[place]), *value[place + 1 :]]
        if self._chance.random() < 0.15:
            return self._chance.choice(ODD_VALUES)
        likely = NUMBERS if isinstance(value, int | float) and not isinstance(value, bool) else TEXTS
        return self._chance.choice(likely if self._chance.random() < 0.8 else (TEXTS, NUMBERS)[likely is TEXTS])

    def _prepare_upload(self, headers: dict[str, str]) -> None:
        name = self._text().encode("utf-8", "surrogatepass")
        values = {"delivery_id": str(self._ids.get("delivery_id", "")).encode(), "file_name": name}
        if self._chance.random() < 0.3:
            values["take_id"] = str(self._ids.get("take_id", "")).encode()
        pairs = ",".join(f"{key} {base64.b64encode(value).decode()}" for key, value in values.items())
        headers |= TUS | {
            "Upload-Metadata": pairs[:30_000],
            "Upload-Length": self._chance.choice(("0", "20", "100")),
        }
        headers["Upload-Offset"] = self._chance.choice(("0", "20"))
        headers["Content-Type"] = "application/offset+octet-stream"

    def _headers(self, headers: dict[str, str]) -> Iterator[tuple[bytes, bytes]]:
        while self._chance.random() < 0.25:
            name, values = self._chance.choice(HEADERS)
            headers[name] = self._chance.choice(values)
        for name, value in headers.items():
            yield name.encode(), value.encode()

    def _text(self) -> str:
        return self._chance.choice(TEXTS)

    @staticmethod
    def _quoted(text: str) -> str:
        return quote(text.encode("utf-8", "surrogatepass"), safe="%" if "%" in text else "")


@dataclass
class Outcome:
    """The outcome of many requests."""

    statuses: Counter[int]
    failures: dict[str, tuple[int, str]]  # where the code failed → how often, and the first request


def send_to_application(server: RunningServer, seed: int, count: int) -> Outcome:
    """Send hostile requests to the application in this process, each as some role."""
    outcome = Outcome(Counter(), {})
    chance = random.Random(f"roles {seed}")
    for begun in range(0, count, HOUSE_LIFETIME):
        server.forget_tries()
        house = House(server)
        clients = {role: getattr(house, role) for role in ROLES if role != "build"}
        clients["build"] = house.build(house.own_secret)
        ids = {**house.ids, "secret": house.links["invitations"], "upload_id": house.ids["upload_id"]}
        requests = hostile_requests(seed * 1_000_003 + begun, operations(), ids)
        for _ in range(min(HOUSE_LIFETIME, count - begun)):
            request = next(requests)
            status, failure = _sent(server, clients[chance.choice(ROLES)], request)
            outcome.statuses[status] += 1
            if failure:
                times, first = outcome.failures.get(failure, (0, str(request)))
                outcome.failures[failure] = (times + 1, first)
    return outcome


def _sent(server: RunningServer, client: Client, request: HostileRequest) -> tuple[int, str]:
    """Return the status of an answer, and where the application failed if it did; no client tidies the request."""
    path, _, query = request.target.partition("?")
    cookies = "; ".join(f"{name}={value}" for name, value in client.cookies.items())
    given = {"host": "127.0.0.1:8000", **dict(client.headers), **({"cookie": cookies} if cookies else {})}
    odd = {name.lower(): value for name, value in request.headers}
    headers = {name.encode().lower(): value.encode() for name, value in given.items()} | odd
    if request.body:
        headers.setdefault(b"content-length", str(len(request.body)).encode())
    scope = {
        "type": "http", "asgi": {"version": "3.0", "spec_version": "2.3"}, "http_version": "1.1", "scheme": "http",
        "method": request.method, "path": unquote(path), "raw_path": path.encode(), "query_string": query.encode(),
        "root_path": "", "headers": list(headers.items()), "client": ("127.0.0.1", 1), "server": ("127.0.0.1", 8000),
    }  # fmt: skip
    statuses: list[int] = []

    async def ask() -> None:
        messages = [{"type": "http.request", "body": request.body, "more_body": False}, {"type": "http.disconnect"}]

        async def receive() -> Any:
            return messages.pop(0) if len(messages) > 1 else messages[0]

        async def send(message: Any) -> None:
            if message["type"] == "http.response.start":
                statuses.append(message["status"])

        await server.application(scope, receive, send)

    try:
        server.portal.call(ask)
    except Exception as error:
        where = traceback.extract_tb(error.__traceback__)
        ours = [frame for frame in where if "/app/" in frame.filename] or list(where)
        return 500, f"{type(error).__name__}: {str(error)[:200]} at {ours[-1].filename}:{ours[-1].lineno}"
    status = statuses[0] if statuses else 0
    is_broken = status >= 500 and not (path == "/readyz" and status == 503)  # no worker runs here
    return status, f"{status} of {request.route}" if is_broken else ""


@contextmanager
def running_application(database: str) -> Iterator[RunningServer]:
    """Run the whole application in this process, on a database of its own; without a worker."""
    with tempfile.TemporaryDirectory() as folder, start_blocking_portal() as portal:
        if database == "postgres":
            with running_postgres() as postgres:
                yield from _wired(Path(folder), postgres.new_database("attack"), portal)
        else:
            yield from _wired(Path(folder), "", portal)


def _wired(folder: Path, database_url: str, portal: Any) -> Iterator[RunningServer]:
    runtime = Runtime.of(
        Settings(data_dir=folder, database_url=database_url, secret_key="only for tests", sign_up="open")
    )
    migrate(runtime.database)
    yield RunningServer(runtime, create_app(runtime), portal)
    runtime.close()


def main() -> int:
    """Send them, print what failed, and return how many ways of failing there are."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--requests", type=int, default=50_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--database", choices=("sqlite", "postgres"), default="sqlite")
    asked = parser.parse_args()
    logs.configure("CRITICAL")
    with running_application(asked.database) as server:
        outcome = send_to_application(server, asked.seed, asked.requests)
    reported = ", ".join(f"{status}: {times:,}" for status, times in sorted(outcome.statuses.items()))
    lines = [f"{sum(outcome.statuses.values()):,} requests on {asked.database}, seed {asked.seed}: {reported}"]
    worst = sorted(outcome.failures.items(), key=lambda one: -one[1][0])[:MAX_SHOWN]
    lines += [f"\n{times} × {failure}\n  {first}" for failure, (times, first) in worst]
    sys.stdout.write("\n".join(lines) + "\n")
    return min(len(outcome.failures), 100)


if __name__ == "__main__":
    sys.exit(main())
