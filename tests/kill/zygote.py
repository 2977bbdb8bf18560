"""Starts `soundlist …` processes by forking one that has imported everything: an import costs two seconds.

Speaks JSON lines: {"start": arguments, "environment": …, "log": path} answers a process id, {"poll": id} its
return code, or null while it lives. The kills are real: each process is one of its own.
"""

import json
import os
import signal
import sys
from typing import Any

import granian.server.mp  # noqa: F401  what serving imports when it starts

from app import main, migrate, registry, row_security, worker  # noqa: F401
from app.cli import cli
from app.core.permissions import keep_new_files_private


def start(arguments: list[str], environment: dict[str, str], log: str) -> None:
    """Become `soundlist` with these arguments; called in the forked child."""
    os.environ.clear()
    os.environ.update(environment)
    output = os.open(log, os.O_WRONLY | os.O_CREAT | os.O_APPEND)
    for stream in (1, 2):
        os.dup2(output, stream)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    signal.set_wakeup_fd(-1)
    keep_new_files_private()
    cli(arguments)


def poll(pid: int) -> int | None:
    """Return how a child ended, None while it lives."""
    ended, status = os.waitpid(pid, os.WNOHANG)
    return os.waitstatus_to_exitcode(status) if ended else None


def serve() -> None:
    """Answer requests until the input ends."""
    for line in sys.stdin:
        request: dict[str, Any] = json.loads(line)
        if "poll" in request:
            answer = poll(request["poll"])
        else:
            pid = os.fork()
            if pid == 0:
                start(request["start"], request["environment"], request["log"])
            answer = pid
        print(json.dumps(answer), flush=True)  # noqa: T201


if __name__ == "__main__":
    for module in registry.rooms_in_use(is_commercial=True).job_modules:
        __import__(module)
    print("ready", flush=True)  # noqa: T201
    serve()
