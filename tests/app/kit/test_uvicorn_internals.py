"""What we use of uvicorn beside its documentation is there in the pinned version, and in one module."""

import asyncio
import inspect
import re
import tomllib
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import Any

import pytest
import uvicorn
from uvicorn.protocols.http.flow_control import FlowControl
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol, RequestResponseCycle
from uvicorn.server import ServerState

ROOT = Path(__file__).parents[3]
PRIVATE = re.compile(r"uvicorn\.(protocols|server)|uvicorn\.Server|handle_exit|server_state|HttpToolsProtocol")
USED: dict[Callable[..., Any], tuple[str, ...]] = {  # what is overridden or called, and the parameters that it has
    HttpToolsProtocol.connection_made: ("transport",),
    HttpToolsProtocol.connection_lost: ("exc",),
    HttpToolsProtocol.data_received: ("data",),
    HttpToolsProtocol.on_message_begin: (),
    HttpToolsProtocol.on_url: ("url",),
    HttpToolsProtocol.on_header: ("name", "value"),
    HttpToolsProtocol.on_headers_complete: (),
    HttpToolsProtocol.on_message_complete: (),
    HttpToolsProtocol.on_response_complete: (),
    HttpToolsProtocol.send_400_response: ("msg",),
    FlowControl.resume_reading: (),
    uvicorn.Server.handle_exit: ("sig", "frame"),
    uvicorn.Server.run: ("sockets",),
    uvicorn.Server.shutdown: ("sockets",),
}


async def nothing(*_: Any) -> None:
    """Answer nothing."""


def test_one_exact_version_is_pinned_and_installed():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    assert f"uvicorn=={version('uvicorn')}" in project["optional-dependencies"]["server"]


@pytest.mark.parametrize("used", USED, ids=lambda used: used.__qualname__)
def test_each_takes_the_parameters_that_we_pass(used: Callable[..., Any]):
    assert [name for name in inspect.signature(used).parameters if name != "self"] == list(USED[used])


async def _protocol() -> HttpToolsProtocol:
    config = uvicorn.Config(nothing, interface="asgi3")
    config.load()
    return HttpToolsProtocol(config=config, server_state=ServerState(), app_state={})


def test_a_protocol_has_the_attributes_that_we_read():
    protocol = asyncio.run(_protocol())
    for name in ("loop", "transport", "flow", "cycle", "timeout_keep_alive"):
        assert hasattr(protocol, name), name
    protocol.on_message_begin()
    assert (protocol.url, protocol.headers) == (b"", [])
    assert "response_complete" in inspect.signature(RequestResponseCycle.__init__).parameters or (
        "self.response_complete = False" in inspect.getsource(RequestResponseCycle.__init__)
    )


def test_a_server_has_the_attributes_that_we_read():
    server = uvicorn.Server(uvicorn.Config(nothing, interface="asgi3"))
    assert (server.started, server.server_state.connections) == (False, set())
    assert "self.servers" in inspect.getsource(uvicorn.Server.startup)


def test_nothing_else_touches_them():
    touching = [
        str(path.relative_to(ROOT)) for path in (ROOT / "app").rglob("*.py") if PRIVATE.search(path.read_text())
    ]
    assert touching == ["app/kit/uvicorn_internals.py"]
