"""Whether the process lives, and whether it can do its work."""

import os
import tempfile
from collections.abc import Callable
from datetime import timedelta
from typing import Any

from fastapi import APIRouter, Request, Response
from fastapi.responses import JSONResponse
from sqlalchemy import func, select, text

from app.kit import clock
from app.kit.http import runtime_of
from app.kit.queue import Heartbeat
from app.kit.runtime import Runtime

WORKER_SILENT_AFTER = timedelta(seconds=20)
router = APIRouter(tags=["health"])


@router.get("/healthz", include_in_schema=False)
def alive() -> dict[str, str]:
    """Answer that the process lives."""
    return {"status": "alive"}


@router.get("/readyz", include_in_schema=False)
def ready(request: Request) -> Response:
    """Answer whether database, store and worker are there, each by trying."""
    runtime = runtime_of(request)
    parts = {name: _tried(probe, runtime) for name, probe in PROBES.items()}
    is_ready = all(part == "ok" for part in parts.values())
    return JSONResponse({"status": "ready" if is_ready else "not ready", **parts}, 200 if is_ready else 503)


def _tried(probe: Callable[[Runtime], Any], runtime: Runtime) -> str:
    try:
        probe(runtime)
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    return "ok"


def _database(runtime: Runtime) -> None:
    with runtime.database.reading() as session:
        session.execute(text("SELECT 1"))


def _store(runtime: Runtime) -> None:
    runtime.store.root.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryFile(dir=runtime.store.root) as file:
        file.write(b"ready?")
        os.fsync(file.fileno())


def _worker(runtime: Runtime) -> None:
    with runtime.database.reading() as session:
        last = session.scalar(select(func.max(Heartbeat.beat_at)))
    if last is None or clock.now() - last > WORKER_SILENT_AFTER:
        raise RuntimeError(f"no worker has said that it lives since {last}")


PROBES: dict[str, Callable[[Runtime], None]] = {"database": _database, "store": _store, "worker": _worker}
