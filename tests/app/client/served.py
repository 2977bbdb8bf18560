"""A project's approved sounds behind a real socket, and the client's commands run against it."""

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from app.client.commands import main
from tests.app.builds.test_builds import token
from tests.support.listening import listening
from tests.support.server import World

RunDesk = Callable[..., tuple[int, str, str]]  # arguments of `soundlist desk`; its code, output and errors
PATHS = ["laser_fire_01.wav", "laser_fire_02.wav", "ui_confirm.wav"]


class Line:
    """The network between client and server: what it does to answers, and what was asked."""

    def __init__(self, application: Any) -> None:
        self._application = application
        self.asked: list[tuple[str, str]] = []  # path and range of each request
        self.cut_after: list[int] = []  # bytes of the next downloads that arrive before the connection breaks
        self.change_file: Callable[[bytes], bytes] | None = None
        self.change_listing: Callable[[dict[str, Any]], object] | None = None
        self.redirect_files_to = ""
        self.busy = 0  # so many requests are refused

    @property
    def downloads(self) -> list[str]:
        """The ranges of the downloads so far; empty for whole files."""
        return [asked for path, asked in self.asked if "/game-files/" in path and "origins" not in path]

    async def __call__(self, scope: Any, receive: Any, send: Any) -> None:
        path = scope["path"]
        headers = {name.decode(): value.decode() for name, value in scope["headers"]}
        self.asked.append((path, headers.get("range", "")))
        is_file = "/game-files/" in path and "origins" not in path
        if self.busy:
            self.busy -= 1
            await send({"type": "http.response.start", "status": 503, "headers": [(b"retry-after", b"0")]})
            await send({"type": "http.response.body"})
        elif is_file and self.redirect_files_to:
            headers = [(b"location", self.redirect_files_to.encode())]
            await send({"type": "http.response.start", "status": 307, "headers": headers})
            await send({"type": "http.response.body"})
        elif path.endswith("/game-files") and self.change_listing:
            await self._application(scope, receive, self._listing(send))
        elif is_file:
            await self._application(scope, receive, self._file(send))
        else:
            await self._application(scope, receive, send)

    def _listing(self, send: Any) -> Any:
        parts: list[bytes] = []
        started: list[Any] = []

        async def changed(message: Any) -> None:
            if message["type"] == "http.response.start":
                started.append(message)
                return
            parts.append(message.get("body", b""))
            if message.get("more_body"):
                return
            said = json.loads(b"".join(parts))
            assert self.change_listing
            self.change_listing(said)
            content = json.dumps(said).encode()
            head = [(b"content-type", b"application/json"), (b"content-length", str(len(content)).encode())]
            await send(started[0] | {"headers": head})
            await send({"type": "http.response.body", "body": content})

        return changed

    def _file(self, send: Any) -> Any:
        left = self.cut_after.pop(0) if self.cut_after else None

        async def changed(message: Any) -> None:
            nonlocal left
            if message["type"] == "http.response.body":
                body = message.get("body", b"")
                if self.change_file:
                    message = message | {"body": self.change_file(body)}
                if left is not None:
                    await send(message | {"body": body[:left], "more_body": True})
                    left -= min(left, len(body))
                    if left == 0:
                        raise ConnectionAbortedError("the line was cut")
                    return
            await send(message)

        return changed


class Client:
    """The commands as a person of the game team gives them."""

    def __init__(self, world: World, line: Line, port: int, capsys: pytest.CaptureFixture[str]) -> None:
        self.world, self.line, self.port, self._capsys = world, line, port, capsys
        self.source = ["--server", f"http://127.0.0.1:{port}", "--project", str(world.project_id)]
        self.out = self.err = ""

    def pull(self, folder: Path, *options: str) -> int:
        """Pull into a folder, and remember what was printed."""
        return self._run(["pull", str(folder), *self.source, *options])

    def why(self, name: str, *options: str) -> int:
        """Ask where a file comes from, and remember what was printed."""
        return self._run(["why", name, *self.source, *options])

    def adopt(self, folder: Path, *options: str) -> int:
        """Send a folder to be adopted, and remember what was printed."""
        return self._run(["adopt", str(folder), *self.source, *options])

    def _run(self, arguments: list[str]) -> int:
        self._capsys.readouterr()
        try:
            code = main(arguments)
        except SystemExit as end:  # of argparse
            code = int(end.code or 0)
        self.out, printed = self._capsys.readouterr()
        # Without the log of the server's jobs, which run in this process.
        self.err = "".join(line for line in printed.splitlines(keepends=True) if not line.startswith('{"'))
        return code


@contextmanager
def client_of(
    world: World, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *scopes: str
) -> Iterator[Client]:
    """Serve a world over a socket, with a token in the environment."""
    secret = (
        token(world, *(scopes or ("manifest:read", "rights:read"))).headers["Authorization"].removeprefix("Bearer ")
    )
    monkeypatch.setenv("SOUNDLIST_TOKEN", secret)
    monkeypatch.setattr("app.client.server.RETRY_DELAYS_S", (0.0, 0.0, 0.0))
    monkeypatch.setattr("app.client.downloads.RETRY_DELAYS_S", (0.0, 0.0, 0.0))
    line = Line(world.server.application)
    with listening(line, lifespan="off", log_level="critical") as port:
        yield Client(world, line, port, capsys)


def files_in(folder: Path) -> dict[str, bytes]:
    """Every file below a folder, the lock file aside."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and path.name != "soundlist.lock"
    }


def states_of(folder: Path) -> dict[str, tuple[int, int, int]]:
    """The identity, size and time of change of everything below a folder."""
    return {str(path): (path.stat().st_ino, path.stat().st_size, path.stat().st_mtime_ns) for path in folder.rglob("*")}
