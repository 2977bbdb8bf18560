"""The metrics of a process for Prometheus, gauges that are read from the database and the disk at each scrape."""

import shutil
from collections.abc import Iterator

from prometheus_client.core import GaugeMetricFamily
from prometheus_client.registry import Collector

from app.core import clock
from app.core.backups import newest_backup
from app.core.metrics import PoolFigures, ServerFigures
from app.core.runtime import Runtime
from app.notifications.queries import unsent_mails
from app.operations.models import BlobState
from app.operations.scrubbing import queries as blob_queries


class OutboxFigures(Collector):
    """The gauges of mails that are not sent."""

    def __init__(self, runtime: Runtime) -> None:
        self._runtime = runtime

    def collect(self) -> Iterator[GaugeMetricFamily]:
        """Yield the number of unsent mails, and the time that the oldest of them has been due."""
        mails = GaugeMetricFamily(
            "soundlist_mails", "Mails that wait to be sent, or that the mail server refused.", labels=["state"]
        )
        oldest = GaugeMetricFamily("soundlist_mail_oldest_seconds", "How long the oldest unsent mail has been due.")
        with self._runtime.database.reading() as session:
            waiting, failed, due_at = unsent_mails(session)
        mails.add_metric(["waiting"], waiting)
        mails.add_metric(["failed"], failed)
        oldest.add_metric([], max(0.0, (clock.now() - due_at).total_seconds()) if due_at else 0.0)
        yield from (mails, oldest)


class BackupFigures(Collector):
    """The gauges of the newest backup; none before the first."""

    def __init__(self, runtime: Runtime) -> None:
        self._runtime = runtime

    def collect(self) -> Iterator[GaugeMetricFamily]:
        """Yield the age of the newest backup, and how many damaged blobs it left out."""
        age = GaugeMetricFamily("soundlist_backup_age_seconds", "How long ago the newest backup was finished.")
        damaged = GaugeMetricFamily("soundlist_backup_damaged_blobs", "Blobs that it left out as damaged.")
        with self._runtime.database.reading() as session:
            backup = newest_backup(session)
        if backup is not None:
            age.add_metric([], (clock.now() - backup.finished_at).total_seconds())
            damaged.add_metric([], backup.damaged_blobs)
        yield from (age, damaged)


class ScrubFigures(Collector):
    """Gauges of the newest pass over all stored files, read from the database at each scrape."""

    def __init__(self, runtime: Runtime) -> None:
        self._runtime = runtime

    def collect(self) -> Iterator[GaugeMetricFamily]:
        """Yield the numbers of missing, altered and orphaned blobs, and the age of the newest finished pass."""
        blobs = GaugeMetricFamily(
            "soundlist_damaged_blobs", "Stored files that are missing, altered, or named by no row.", labels=["state"]
        )
        age = GaugeMetricFamily(
            "soundlist_scrub_age_seconds", "Time since the newest pass over all stored files came to its end."
        )
        with self._runtime.database.reading() as session:
            damaged = blob_queries.damaged_counts(session)
            scrub = blob_queries.newest_scrub(session, finished=True)
        for state in BlobState:
            blobs.add_metric([state.value], damaged.get(state.value, 0))
        if scrub is not None and scrub.finished_at is not None:
            blobs.add_metric(["orphaned"], scrub.orphaned)
            age.add_metric([], (clock.now() - scrub.finished_at).total_seconds())
        yield from (blobs, age)


class DiskFigures(Collector):
    """The gauges of the disks that this process writes to."""

    def __init__(self, runtime: Runtime) -> None:
        self._runtime = runtime

    def collect(self) -> Iterator[GaugeMetricFamily]:
        """Yield the free bytes of the data folder, and of the store unless that is a bucket."""
        free = GaugeMetricFamily("soundlist_disk_free_bytes", "Bytes that a folder's disk has left.", labels=["folder"])
        free.add_metric(["data"], shutil.disk_usage(self._runtime.settings.data_dir).free)
        store_bytes = self._runtime.store.free_bytes()
        if store_bytes is not None:
            free.add_metric(["store"], store_bytes)
        yield free


def process_collectors(runtime: Runtime) -> tuple[Collector, ...]:
    """Return the collectors of one process: its connections and its disks."""
    return PoolFigures(runtime.database), DiskFigures(runtime)


def web_collectors(runtime: Runtime) -> tuple[Collector, ...]:
    """Return the collectors of a web process, which also reports on the whole server."""
    server = (ServerFigures(runtime), OutboxFigures(runtime), BackupFigures(runtime), ScrubFigures(runtime))
    return *server, *process_collectors(runtime)
