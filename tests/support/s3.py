"""A real S3 server for tests, and a line to it that can be made to fail."""

import itertools
import os
import re
import socket
import socketserver
import subprocess
import threading
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import httpx

from app.core.storage.signing import Key, Signer
from app.settings import BucketAddress

ROOT = Path(__file__).resolve().parents[2]
KEY = Key("soundlist-tests", "only for tests")
REGION = "us-east-1"
READ_BYTES = 1 << 18
STARTS_WITHIN_S = 240.0
BUILT_WITHIN_S = 900.0
_numbers = itertools.count(1)
_folders: dict[str, Path] = {}  # of the servers that run, by endpoint


@dataclass(frozen=True)
class S3Server:
    """A running server; every test has buckets of its own."""

    endpoint: str
    folder: Path
    client: httpx.Client

    def new_bucket(self) -> str:
        """Make a bucket and return its name."""
        name = f"sounds-{next(_numbers)}"
        answer = self.client.put(self.signer().url("PUT", f"/{name}", expires_in_s=60))
        assert answer.status_code == 200, answer.text
        return name

    def signer(self) -> Signer:
        """Return what signs as the server's owner."""
        return Signer(self.endpoint, REGION, KEY)

    def address(self, bucket: str, prefix: str = "", endpoint: str | None = None) -> BucketAddress:
        """Return where a bucket is; behind another endpoint if one is given."""
        reached_at = endpoint or self.endpoint
        return BucketAddress(bucket, prefix, REGION, reached_at, reached_at)

    def settings(self, **more: Any) -> dict[str, Any]:
        """Return the settings of a server that stores in a new bucket."""
        return {
            "store_url": f"s3://{self.new_bucket()}/studio/sounds?endpoint={self.endpoint}&region={REGION}",
            "aws_access_key_id": KEY.id,
            "aws_secret_access_key": KEY.secret,
            **more,
        }


@contextmanager
def run_s3(folder: Path) -> Iterator[S3Server]:
    """Run the server that the set-up builds, with its files in a folder."""
    data, sidecar = folder / "data", folder / "sidecar"
    data.mkdir(parents=True)
    sidecar.mkdir()
    endpoint = f"http://127.0.0.1:{free_port()}"
    options = ["--quiet", "--region", REGION, "--port", endpoint.removeprefix("http://"), "--health", "/health"]
    command = [s3_program(), *options, "posix", "--sidecar", str(sidecar), str(data)]
    keys = {"ROOT_ACCESS_KEY": KEY.id, "ROOT_SECRET_KEY": KEY.secret}
    with run_program(command, f"{endpoint}/health", folder / "log", keys), httpx.Client() as client:
        _folders[endpoint] = data
        yield S3Server(endpoint, data, client)


def s3_program() -> str:
    """Return the server that the set-up builds; where it is being built, wait for it."""
    ran = subprocess.run([ROOT / ".ci/s3"], stdout=subprocess.PIPE, text=True, check=True, timeout=BUILT_WITHIN_S)
    return ran.stdout.strip()


@contextmanager
def run_program(command: list[str], health_url: str, log: Path, environment: dict[str, str]) -> Iterator[None]:
    """Run a server from the time that it is well until the block ends."""
    with log.open("wb") as said:
        process = subprocess.Popen(command, stdout=said, stderr=said, env=os.environ | environment)
    try:
        deadline = time.monotonic() + STARTS_WITHIN_S
        while not _answers(health_url):
            assert process.poll() is None, f"it ended at once: {log.read_text()}"
            assert time.monotonic() < deadline, f"it does not answer after {STARTS_WITHIN_S} s: {log.read_text()}"
            time.sleep(0.02)
        yield
    finally:
        process.kill()
        process.wait()


def _answers(url: str) -> bool:
    try:
        return httpx.get(url).status_code == httpx.codes.OK
    except httpx.TransportError:
        return False


def folder_of(endpoint: str) -> Path:
    """Return where a server keeps its buckets: an object is a file named by its key."""
    return _folders[endpoint]


def free_port() -> int:
    """Return a port of this machine that nobody listens on."""
    with closing(socket.socket()) as free:
        free.bind(("127.0.0.1", 0))
        return int(free.getsockname()[1])


@dataclass
class Fault:
    """What goes wrong with the next requests of a kind."""

    kind: str  # "503", "refused", "silent", "cut off", "truncated", "lost answer", "slow"
    times: int = 1
    method: str = "[A-Z]+"
    path: str = ".*"  # with its query
    after_bytes: int = 100  # of the answer's body, before it is cut off
    hits: int = 0

    def takes(self, method: str, path: str) -> bool:
        """Say whether a request is to fail, and count it."""
        if self.hits >= self.times or not re.fullmatch(self.method, method) or not re.search(self.path, path):
            return False
        self.hits += 1
        return True


@dataclass
class FaultyLine:
    """A line to an HTTP server, one request a connection, that fails as it is set to."""

    server: S3Server
    endpoint: str
    faults: list[Fault] = field(default_factory=list)
    asked: list[tuple[str, str]] = field(default_factory=list)
    released: threading.Event = field(default_factory=threading.Event)

    def fail(self, kind: str, **how: Any) -> Fault:
        """Let the next requests of a kind fail."""
        fault = Fault(kind, **how)
        self.faults.append(fault)
        return fault

    def carry(self, near: socket.socket) -> None:
        """Carry one request to the server and its answer back, unless a fault takes it."""
        head, rest = _head(near)
        if not head:
            return
        method, path = head.split(b" ", 2)[:2]
        self.asked.append((method.decode(), path.decode()))
        fault = next((fault for fault in self.faults if fault.takes(method.decode(), path.decode())), None)
        kind = fault.kind if fault else ""
        if kind == "refused":
            return
        body = rest + _exactly(near, _length(head) - len(rest))
        if kind == "cut off":
            self._far_end(_closing(head) + body[: len(body) // 2])
            return
        if kind == "silent":
            self.released.wait(30)
            return
        if kind == "503":
            near.sendall(b"HTTP/1.1 503 Service Unavailable\r\nContent-Length: 0\r\nConnection: close\r\n\r\n")
            return
        with self._connected() as far:
            far.sendall(_closing(head) + body)
            answered, rest = _head(far)
            if kind == "lost answer":
                return
            near.sendall(answered)
            if fault and kind == "truncated":
                near.sendall((rest + _exactly(far, fault.after_bytes))[: fault.after_bytes])
                return
            near.sendall(rest)
            while piece := far.recv(READ_BYTES // 4):
                if kind == "slow":
                    time.sleep(0.03)
                near.sendall(piece)

    def _connected(self) -> socket.socket:
        host, _, port = self.server.endpoint.removeprefix("http://").partition(":")
        return socket.create_connection((host, int(port)))

    def _far_end(self, half: bytes) -> None:
        """Let the server have half of a request, and nothing more."""
        with self._connected() as far:
            far.sendall(half)
            far.shutdown(socket.SHUT_WR)
            _exactly(far, READ_BYTES)


@contextmanager
def faulty_line(server: S3Server) -> Iterator[FaultyLine]:
    """Open a line to a server that can be made to fail."""

    class Carry(socketserver.BaseRequestHandler):
        def handle(self) -> None:
            with suppress(ConnectionError):
                line.carry(self.request)

    class Listener(socketserver.ThreadingTCPServer):
        daemon_threads = True
        request_queue_size = 128

    with Listener(("127.0.0.1", 0), Carry) as listener:
        line = FaultyLine(server, f"http://127.0.0.1:{listener.server_address[1]}")
        thread = threading.Thread(target=listener.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        try:
            yield line
        finally:
            line.released.set()
            listener.shutdown()
            thread.join()


def _head(line: socket.socket) -> tuple[bytes, bytes]:
    """Return a message's head and the part of its body that came with it."""
    received = b""
    while b"\r\n\r\n" not in received:
        piece = line.recv(READ_BYTES)
        if not piece:
            return b"", b""
        received += piece
    head, _, rest = received.partition(b"\r\n\r\n")
    return head + b"\r\n\r\n", rest


def _exactly(line: socket.socket, length: int) -> bytes:
    received = bytearray()
    while len(received) < length and (piece := line.recv(min(READ_BYTES, length - len(received)))):
        received += piece
    return bytes(received)


def _length(head: bytes) -> int:
    found = re.search(rb"\r\ncontent-length: *([0-9]+)", head, re.IGNORECASE)
    return int(found[1]) if found else 0


def _closing(head: bytes) -> bytes:
    """Return a request's head that asks for one answer and no more."""
    kept = re.sub(rb"\r\nconnection:[^\r]*", b"", head, flags=re.IGNORECASE)
    return kept[:-2] + b"Connection: close\r\n\r\n"
