"""The Prometheus metrics of a process; rooms add their own collectors.

Counters of this process grow while it runs. Gauges of the whole server (jobs by state, workers) are
read from the database at each scrape, and are the same on every web process.
"""

import hmac
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from datetime import timedelta
from typing import TYPE_CHECKING, Any
from wsgiref.simple_server import WSGIRequestHandler, WSGIServer, make_server

from prometheus_client import CONTENT_TYPE_LATEST, REGISTRY, CollectorRegistry, Counter, Gauge, Histogram
from prometheus_client.core import GaugeMetricFamily
from prometheus_client.exposition import generate_latest
from prometheus_client.registry import Collector
from sqlalchemy.pool import QueuePool

from app.core import clock

if TYPE_CHECKING:
    from app.core.db import Database
    from app.core.runtime import Runtime
    from app.settings import Settings

CONTENT_TYPE = CONTENT_TYPE_LATEST
WORKERS_SHOWN = timedelta(hours=1)  # stopped workers disappear after this time
REQUEST_BUCKETS_S = (0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 10.0, 30.0)
PORT_LOOK_EVERY_S = 1.0
JOB_BUCKETS_S = (0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 15.0, 60.0, 300.0)

REQUESTS = Counter("soundlist_requests", "Requests answered.", ["method", "route", "status"])
REQUEST_S = Histogram(
    "soundlist_request_seconds",
    "From the request's head to the end of its answer.",
    ["method", "route"],
    buckets=REQUEST_BUCKETS_S,
)
IN_FLIGHT = Gauge("soundlist_requests_in_flight", "Requests that are being answered.")
JOBS = Counter("soundlist_jobs_run", "Runs of jobs, by how they ended: done or parked.", ["job", "outcome"])
JOB_S = Histogram(
    "soundlist_job_seconds", "How long a run of a job took, its tries included.", ["job"], buckets=JOB_BUCKETS_S
)
JOB_FAILURES = Counter("soundlist_job_failures", "Tries of jobs that failed.", ["job"])
UPLOADED = Counter("soundlist_upload_bytes", "Bytes of files that came in whole.")
STORE_ERRORS = Counter("soundlist_store_errors", "Failed operations of the store.", ["operation"])


class ServerFigures(Collector):
    """Gauges that are read from the database at each scrape."""

    def __init__(self, runtime: "Runtime") -> None:
        self._runtime = runtime

    def collect(self) -> Iterator[GaugeMetricFamily]:
        """Yield jobs by state, the age of each worker's heartbeat, and the connection pool."""
        jobs = GaugeMetricFamily("soundlist_jobs", "Jobs that wait, run or gave up.", labels=["job", "state"])
        oldest = GaugeMetricFamily(
            "soundlist_job_oldest_seconds", "How long the oldest job of that name waits to be run.", labels=["job"]
        )
        now = clock.now()
        for count in self._runtime.queue.counts():
            jobs.add_metric([count.name, count.state], count.jobs)
            if count.state == "waiting":
                oldest.add_metric([count.name], max(0.0, (now - count.oldest_at).total_seconds()))
        beats = GaugeMetricFamily(
            "soundlist_worker_silent_seconds", "Time since a worker's last heartbeat.", labels=["worker"]
        )
        for heartbeat in self._runtime.queue.heartbeats(within=WORKERS_SHOWN):
            beats.add_metric([heartbeat.worker_id], (now - heartbeat.beat_at).total_seconds())
        yield from (jobs, oldest, beats)


class PoolFigures(Collector):
    """The gauges of this process's connection pool."""

    def __init__(self, database: "Database") -> None:
        self._database = database

    def collect(self) -> Iterator[GaugeMetricFamily]:
        """Yield the numbers of connections in use and of idle ones."""
        pool = self._database.engine.pool
        family = GaugeMetricFamily(
            "soundlist_database_connections", "Connections of this process to the database.", labels=["state"]
        )
        if isinstance(pool, QueuePool):
            family.add_metric(["in use"], pool.checkedout())
            family.add_metric(["idle"], pool.checkedin())
        yield family


def exposition(collectors: Iterable[Collector]) -> bytes:
    """Return this process's counters, and the current values of the collectors."""
    registry = CollectorRegistry()
    for collector in collectors:
        registry.register(collector)
    return generate_latest(REGISTRY) + generate_latest(registry)


def is_authorized(authorization: str, token: str) -> bool:
    """Whether a request's Authorization header carries the token."""
    scheme, _, sent = authorization.partition(" ")
    return scheme.lower() == "bearer" and hmac.compare_digest(sent.strip().encode(), token.encode())


class _SilentHandler(WSGIRequestHandler):
    def log_message(self, format: str, *args: Any) -> None:  # noqa: A002  named so by http.server
        """Log nothing: scrapes come every few seconds."""


class CannotListen(Exception):
    """The metrics port cannot be opened."""


class MetricsServer:
    """A separate listener for metrics, for a process with no HTTP server or a public one."""

    def __init__(self, host: str, port: int, token: str, collectors: Iterable[Collector]) -> None:
        self._token = token
        self._collectors = tuple(collectors)
        try:
            self._server: WSGIServer = make_server(host, port, self._answer, handler_class=_SilentHandler)
        except OSError as error:
            raise CannotListen(
                f"metrics cannot be served at {host}:{port} ({error.strerror}); "
                "each process on a machine needs its own SOUNDLIST_METRICS_PORT"
            ) from None
        self._thread = threading.Thread(target=self._server.serve_forever, args=[0.1], name="metrics", daemon=True)

    @property
    def port(self) -> int:
        """The port in use; with port 0 the system chose it."""
        return self._server.server_port

    def start(self) -> None:
        """Answer from now on."""
        self._thread.start()

    def stop(self) -> None:
        """Close the port."""
        self._server.shutdown()
        self._server.server_close()
        self._thread.join()

    def _answer(self, environ: dict[str, Any], start_response: Callable[..., Any]) -> list[bytes]:
        status, content_type, body = "200 OK", "text/plain", b""
        if environ.get("PATH_INFO") == "/healthz":
            body = b"alive\n"
        elif environ.get("PATH_INFO") != "/metrics":
            status, body = "404 Not Found", b"only /metrics and /healthz are here\n"
        elif self._token and not is_authorized(environ.get("HTTP_AUTHORIZATION", ""), self._token):
            status, body = "401 Unauthorized", b"send the token of SOUNDLIST_METRICS_TOKEN as a bearer\n"
        else:
            content_type, body = CONTENT_TYPE, exposition(self._collectors)
        headers = [("Content-Type", content_type), ("Content-Length", str(len(body)))]
        start_response(status, headers)
        return [body]


@contextmanager
def listening(settings: "Settings", collectors: Iterable[Collector]) -> Iterator[None]:
    """Serve metrics on a separate port for the length of the block, if the settings name one."""
    if settings.metrics_port is None:
        yield
        return
    server = _server(settings, collectors, process_index=0)
    server.start()
    try:
        yield
    finally:
        server.stop()


def listen_beside_others(settings: "Settings", collectors: Iterable[Collector]) -> None:
    """Serve metrics of one of several web processes, on the first port from the one in the settings that is free.

    While a process replaces another there is none, and it waits for that port.
    """

    def listen() -> None:
        while True:
            for process_index in range(settings.web_processes):
                with suppress(CannotListen):
                    _server(settings, collectors, process_index=process_index).start()
                    return
            time.sleep(PORT_LOOK_EVERY_S)

    if settings.metrics_port is not None:
        threading.Thread(target=listen, name="metrics port", daemon=True).start()


def _server(settings: "Settings", collectors: Iterable[Collector], *, process_index: int) -> MetricsServer:
    return MetricsServer(
        settings.metrics_host,
        (settings.metrics_port or 0) + process_index,
        settings.metrics_token.get_secret_value(),
        collectors,
    )
