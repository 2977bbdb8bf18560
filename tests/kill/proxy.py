"""Reverse proxies before several web processes: Caddy, and one that never sends a request twice."""

import asyncio
import re
from collections.abc import AsyncIterator, Iterator, Sequence
from contextlib import asynccontextmanager, contextmanager
from pathlib import Path

import httpx
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from tests.support.listening import listening
from tests.support.s3 import free_port, run_program

ROOT = Path(__file__).resolve().parents[2]
CADDY = ROOT / ".make" / "caddy"  # says where it is
CHECK_EVERY_S = 0.2
TRY_FOR_S = 20.0
UNUSED_FOR_S = 15.0
METHODS = ["GET", "HEAD", "POST", "PUT", "PATCH", "DELETE"]


class Proxy:
    """Takes turns among those whose /readyz says that they are ready."""

    def __init__(self, ports: Sequence[int]) -> None:
        self._ports = list(ports)
        self._healthy = set(ports)
        self._turn = 0
        lines = httpx.Limits(max_keepalive_connections=20, keepalive_expiry=UNUSED_FOR_S)
        self._client = httpx.AsyncClient(timeout=30, limits=lines)

    async def forward(self, request: Request) -> Response:
        """Hand a request on; to another only where no line could be opened, since then nothing was sent."""
        body = await request.body()
        headers = [(name, value) for name, value in request.headers.raw if name != b"connection"]
        deadline = asyncio.get_running_loop().time() + TRY_FOR_S
        while asyncio.get_running_loop().time() < deadline:
            self._turn += 1
            port = self._ports[self._turn % len(self._ports)]
            if port not in self._healthy:
                await asyncio.sleep(0.01)
                continue
            address = f"http://127.0.0.1:{port}{request.url.path}?{request.url.query}"
            try:
                answer = await self._client.request(request.method, address, content=body, headers=headers)
            except httpx.ConnectError:
                await asyncio.sleep(0.05)
                continue
            except httpx.TransportError as error:
                return Response(f"the line to {port} broke: {error!r}", 502)
            kept = {name: value for name, value in answer.headers.items() if name in ("content-type", "location")}
            return Response(answer.content, answer.status_code, kept)
        return Response("nobody answers", 502)

    async def check(self) -> None:
        """Ask each process now and then whether it is ready."""
        while True:
            for port in self._ports:
                try:
                    ready = (await self._client.get(f"http://127.0.0.1:{port}/readyz")).status_code == 200
                except httpx.TransportError:
                    ready = False
                (self._healthy.add if ready else self._healthy.discard)(port)
            await asyncio.sleep(CHECK_EVERY_S)


@contextmanager
def running_proxy(ports: Sequence[int]) -> Iterator[int]:
    """Run a proxy before these ports, and give its own."""
    proxy = Proxy(ports)

    @asynccontextmanager
    async def checking(_app: Starlette) -> AsyncIterator[None]:
        checks = asyncio.create_task(proxy.check())
        yield
        checks.cancel()

    app = Starlette(routes=[Route("/{path:path}", proxy.forward, methods=METHODS)], lifespan=checking)
    with listening(app, access_log=False) as port:
        yield port


@contextmanager
def running_caddy(ports: Sequence[int], folder: Path) -> Iterator[int]:
    """Run Caddy with our Caddyfile before these ports, without names and certificates, and give its own port."""
    containers = re.compile(r"dynamic a web 8000 \{.*?\}", re.DOTALL)
    here = "to " + " ".join(f"127.0.0.1:{port}" for port in ports)
    written, replaced = containers.subn(here, (ROOT / "deploy" / "Caddyfile").read_text())
    assert replaced == 1
    port, ready_port = free_port(), free_port()
    config = folder / "Caddyfile"
    written = written.replace("\tservers {", "\tadmin off\n\tservers {", 1)
    config.write_text(f"{written}\nhttp://127.0.0.1:{ready_port} {{\n\trespond 200\n}}\n")
    sites = {
        "SOUNDLIST_DOMAIN": f"http://127.0.0.1:{port}",
        "SOUNDLIST_FILES_DOMAIN": f"http://127.0.0.1:{free_port()}",
        "HOME": str(folder),
    }
    command = [CADDY.read_text().strip(), "run", "--adapter", "caddyfile", "--config", str(config)]
    with run_program(command, f"http://127.0.0.1:{ready_port}", folder / "caddy.log", sites):
        yield port
