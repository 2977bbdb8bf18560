"""The metrics of this room."""

from collections.abc import Iterator

from prometheus_client.core import GaugeMetricFamily
from prometheus_client.registry import Collector

from app.kit import clock
from app.kit.runtime import Runtime
from app.operations import blob_queries
from app.operations.models import BlobState


class ScrubFigures(Collector):
    """Gauges of the newest pass over all stored files, read from the database at each scrape."""

    def __init__(self, runtime: Runtime) -> None:
        self._runtime = runtime

    def collect(self) -> Iterator[GaugeMetricFamily]:
        """Yield how many blobs are missing, altered and orphaned, and the age of the newest finished pass."""
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
