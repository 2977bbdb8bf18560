"""Liveness, readiness and metrics of a process."""

import threading
import time
from collections.abc import Callable, Mapping
from datetime import timedelta

import structlog
from fastapi import APIRouter, Request, Response
from fastapi.responses import JSONResponse
from sqlalchemy import text
from sqlalchemy.exc import SQLAlchemyError

from app.core import metrics
from app.core.errors import NotFound, Refused
from app.core.runtime import Runtime
from app.core.storage import StoreUnready
from app.core.web.http import problems, runtime_of

WORKER_SILENT_AFTER = timedelta(seconds=20)
CACHE_FOR_S = 1.0  # the readiness test writes to the disk, and anyone may request it
router = APIRouter(tags=["health"])
log = structlog.get_logger(__name__)


class NotReady(Exception):
    """A part of the server cannot do its work: says what was found and how to fix it, and nothing secret."""


Probe = Callable[[Runtime], None]  # raises NotReady


class NoMetricsHere(NotFound):
    """No token is set, so this port serves no metrics."""


class MetricsTokenNeeded(Refused):
    """The figures want their token."""

    status = 401


class Readiness:
    """Tries every part, at most once a second however many ask."""

    def __init__(self, runtime: Runtime, probes: Mapping[str, Probe]) -> None:
        self._runtime = runtime
        self._probes = probes
        self._lock = threading.Lock()
        self._tried_at = -CACHE_FOR_S
        self._parts: dict[str, str] = {}

    def parts(self) -> dict[str, str]:
        """Return the state of each part: "ok", or what is wrong with it in words."""
        with self._lock:
            if time.monotonic() - self._tried_at >= CACHE_FOR_S:
                self._parts = {name: tried(probe, self._runtime) for name, probe in self._probes.items()}
                self._tried_at = time.monotonic()
            return self._parts


def tried(probe: Probe, runtime: Runtime) -> str:
    """Return "ok", or what a probe says is wrong."""
    try:
        probe(runtime)
    except NotReady as error:
        return str(error)
    except SQLAlchemyError:
        return "cannot be known while the database does not answer"
    except Exception:
        log.exception("a probe failed", probe=getattr(probe, "__name__", "probe"))
        return "could not be tried; the log says why"
    return "ok"


def database(runtime: Runtime) -> None:
    """Raise NotReady unless the database answers."""
    try:
        with runtime.database.reading() as session:
            session.execute(text("SELECT 1"))
    except SQLAlchemyError as error:
        log.warning("the database does not answer", error=str(getattr(error, "orig", None) or error))
        raise NotReady(
            "the database does not answer; see that what SOUNDLIST_DATABASE_URL names is there and may be used"
        ) from None


def store(runtime: Runtime) -> None:
    """Raise NotReady unless the store takes bytes and gives them back."""
    try:
        runtime.store.ensure_ready()
    except StoreUnready as error:
        metrics.STORE_ERRORS.labels("probe").inc()
        log.warning("the store cannot be used", error=str(error))
        raise NotReady(str(error)) from None


def worker(runtime: Runtime) -> None:
    """Raise NotReady unless a worker has sent a heartbeat recently."""
    if not runtime.queue.heartbeats(within=WORKER_SILENT_AFTER):
        silent_s = WORKER_SILENT_AFTER.total_seconds()
        raise NotReady(f"no worker has sent a heartbeat for {silent_s:.0f} s; start one with: soundlist worker")


PROBES: Mapping[str, Probe] = {"database": database, "store": store, "worker": worker}


@router.get("/healthz", include_in_schema=False)
def alive() -> dict[str, str]:
    """Answer that the process is running."""
    return {"status": "alive"}


@router.get("/readyz", include_in_schema=False)
def ready(request: Request) -> Response:
    """Answer whether every part is there, each by trying."""
    readiness: Readiness = request.app.state.readiness
    return _readiness_answer(readiness.parts())


@router.get("/readyz/web", include_in_schema=False)
def web_ready(request: Request) -> Response:
    """Answer whether this process can serve people, for load balancers; without workers it can, and uploads wait."""
    readiness: Readiness = request.app.state.readiness
    parts = {name: state for name, state in readiness.parts().items() if name != "worker"}
    return _readiness_answer(parts)


def _readiness_answer(parts: Mapping[str, str]) -> Response:
    is_ready = all(state == "ok" for state in parts.values())
    return JSONResponse({"status": "ready" if is_ready else "not ready", **parts}, 200 if is_ready else 503)


@router.get("/metrics", include_in_schema=False, responses=problems(NoMetricsHere, MetricsTokenNeeded))
def figures(request: Request) -> Response:
    """Return this process's metrics for Prometheus, if the request carries the token."""
    runtime = runtime_of(request)
    token = runtime.settings.metrics_token.get_secret_value()
    if not token:
        raise NoMetricsHere(
            "metrics are not served here",
            fix="set SOUNDLIST_METRICS_TOKEN, or SOUNDLIST_METRICS_PORT for a separate port",
        )
    if not metrics.is_authorized(request.headers.get("authorization", ""), token):
        raise MetricsTokenNeeded("send the token of SOUNDLIST_METRICS_TOKEN as a bearer")
    return Response(metrics.exposition(request.app.state.collectors), media_type=metrics.CONTENT_TYPE)
