"""An application behind a real socket; tests/app/core/test_serving.py is about the server itself."""

import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import uvicorn

from tests.support.waiting import until


@contextmanager
def listening(application: Any, **options: Any) -> Iterator[int]:
    """Serve an application in this process for as long as the block lasts, and give its port; options are uvicorn's."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        server = uvicorn.Server(uvicorn.Config(application, log_config=None, timeout_graceful_shutdown=1, **options))
        thread = threading.Thread(target=server.run, kwargs={"sockets": [listener]}, daemon=True)
        thread.start()
        try:
            until(lambda: server.started or not thread.is_alive())
            assert server.started, "it ended before it served"
            yield listener.getsockname()[1]
        finally:
            server.should_exit = True
            thread.join(timeout=10)
