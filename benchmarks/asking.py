"""A client that costs little compared with what it measures: HTTP/1.1 over persistent connections, and nothing else."""

import asyncio
import json
from collections import deque
from collections.abc import AsyncIterator, Mapping
from dataclasses import dataclass
from typing import Any, Self
from urllib.parse import urlsplit

KEPT_LINES = 32  # opened at once, and used in turns, as a proxy before several web processes does
MAX_HEAD_BYTES = 1 << 16


class Broken(Exception):
    """A line ended before its answer came."""


class Refused(Exception):
    """The server did not do what was asked."""


@dataclass(frozen=True)
class Answer:
    """What the server said."""

    status: int
    headers: Mapping[str, str]
    body: bytes

    @property
    def is_success(self) -> bool:
        """Whether it did what was asked."""
        return 200 <= self.status < 300

    def ensured(self) -> Self:
        """Return it; raise Refused unless the server did what was asked."""
        if not self.is_success:
            raise Refused(f"{self.status} {self.body[:200].decode(errors='replace')}")
        return self

    def json(self) -> Any:
        """Return what the body says."""
        return json.loads(self.body)


Line = tuple[asyncio.StreamReader, asyncio.StreamWriter]


class Client:
    """A client of a server, with any number of requests at once."""

    def __init__(self, address: str, headers: Mapping[str, str]) -> None:
        self._place = urlsplit(address)
        self._head = {"Host": self._place.netloc} | dict(headers)
        self._unused: deque[Line] = deque()

    async def open(self) -> None:
        """Open the lines that are kept."""
        self._unused.extend([await self._line() for _ in range(KEPT_LINES)])

    def close(self) -> None:
        """Close every line that is not in use."""
        while self._unused:
            self._unused.popleft()[1].close()

    async def ask(
        self,
        method: str,
        path: str,
        body: bytes = b"",
        *,
        headers: Mapping[str, str] | None = None,
        pieces: AsyncIterator[bytes] | None = None,
    ) -> Answer:
        """Ask once; a body that comes in pieces is sent as it comes, and its length is among the headers."""
        fields = self._head | ({} if pieces else {"Content-Length": str(len(body))}) | dict(headers or {})
        head = "".join([f"{method} {path} HTTP/1.1\r\n", *(f"{name}: {value}\r\n" for name, value in fields.items())])
        reader, writer = line = self._unused.popleft() if self._unused else await self._line()
        try:
            writer.write(head.encode() + b"\r\n" + body)
            async for piece in pieces or _nothing():
                writer.write(piece)
                await writer.drain()
            answer = await _answer(reader)
        except (OSError, asyncio.IncompleteReadError) as error:
            writer.close()
            raise Broken(f"{method} {path}: {error!r}") from None
        except BaseException:
            writer.close()
            raise
        if answer.headers.get("connection") == "close":
            writer.close()
        else:
            self._unused.append(line)
        return answer

    async def ask_json(self, method: str, path: str, body: Any) -> Answer:
        """Ask once with a body of JSON."""
        return await self.ask(method, path, json.dumps(body).encode(), headers={"Content-Type": "application/json"})

    async def _line(self) -> Line:
        assert self._place.hostname is not None
        return await asyncio.open_connection(self._place.hostname, self._place.port, limit=MAX_HEAD_BYTES)


async def _nothing() -> AsyncIterator[bytes]:
    for piece in ():
        yield piece


async def _answer(reader: asyncio.StreamReader) -> Answer:
    first, *lines = (await reader.readuntil(b"\r\n\r\n")).decode("latin-1").rstrip().split("\r\n")
    fields = (line.partition(":") for line in lines)
    headers = {name.strip().lower(): value.strip() for name, _, value in fields}
    body = await reader.readexactly(int(headers.get("content-length", 0)))
    return Answer(int(first.split(" ")[1]), headers, body)
