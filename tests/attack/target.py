"""The server under attack and its people, and requests whose answers are statuses."""

import random
import socket
from dataclasses import dataclass, field
from typing import Any

import httpx

from app.core.web.concurrency import MAX_WAIT_S
from tests.attack.long_contract import add_two_long_versions
from tests.house.routes import operations
from tests.support.deliver import add_cues, deliver, open_delivery
from tests.support.server import World
from tests.support.waves import sine, wav_bytes

ANSWER_WITHIN_S = MAX_WAIT_S + 10  # who floods a server waits for all that they sent before
NO_ANSWER = 0  # in place of a status: the server closed the line
ODD = ("²", "9" * 20, "9" * 5_000, "-1", "\0", "a\0b", "..", "../../etc/passwd", str(2**31), str(2**63), "{}",
       "é" * 999)  # fmt: skip


@dataclass
class Target:
    """A running server, the people who attack it, and what they know."""

    world: World
    port: int
    numbers: random.Random = field(default_factory=lambda: random.Random(20))

    def __post_init__(self) -> None:
        """Fill a project, so that addresses lead somewhere."""
        operations()  # reads the OpenAPI document once, for as long as an attack may last
        self.cue_ids = [
            cue["id"] for cue in add_cues(self.world, {"name": "Laser fire"}, {"name": "aaaaaaaaaaaaaaaaaaaaaaaa"})
        ]
        self.take_id = deliver(self.world, "laser_fire.wav", wav_bytes(sine(hz=997, seconds=0.2)))["id"]
        self.delivery_id = open_delivery(self.world)
        self.project = f"/v1/projects/{self.world.project_id}"
        with self.world.server.runtime.database.writing() as session:
            self.contract_id = add_two_long_versions(session, self.world)

    def bad_word(self) -> str:
        """Return a value that parsers and databases stumble over."""
        return self.numbers.choice(ODD)


def sent(client: httpx.Client, method: str, path: str, **more: Any) -> int:
    """Return the status of a request, NO_ANSWER where the server closed the line or a client cannot write this."""
    try:
        return client.request(method, path, timeout=ANSWER_WITHIN_S, **more).status_code
    except httpx.TimeoutException:
        raise
    except (httpx.TransportError, httpx.InvalidURL, UnicodeEncodeError, ValueError):
        return NO_ANSWER


def sent_raw(target: Target, head: bytes, body: bytes = b"", *, host: bytes = b"Host: 127.0.0.1\r\n") -> int:
    """Return the status of a request that no client would write."""
    with socket.create_connection(("127.0.0.1", target.port), timeout=ANSWER_WITHIN_S) as line:
        try:
            line.sendall(head + b"\r\n" + host + b"Connection: close\r\n\r\n" + body)
            first = line.makefile("rb").readline().split()
        except TimeoutError:
            raise httpx.ReadTimeout(f"no answer to {head[:80]!r}") from None
        except OSError:
            return NO_ANSWER
    return int(first[1]) if len(first) > 1 and first[1].isdigit() else NO_ANSWER
