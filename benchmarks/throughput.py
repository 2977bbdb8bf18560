"""Takes checked, drawn and rendered a second, by 1, 2 and 4 workers, and what a take costs.

    python -m benchmarks.throughput                      200 takes of 3 s, 48 kHz/24 bit stereo, on SQLite
    python -m benchmarks.throughput --postgres           the same on a PostgreSQL that it starts
    python -m benchmarks.throughput --takes 40 --workers 1 2

From the moment at which all takes are recorded to the one at which no job waits or runs, or at most 40 seconds:
each is checked, drawn, rendered to the one target of the preset for 48 kHz, the game file measured and drawn too;
people are notified of the takes of a few seconds together, of some of them after the end. CPU time says what a free
machine could do where this one is shared: that of the workers, of the processes in which they open sounds, and of
PostgreSQL; what an upload costs the web process is measured before.
"""

import argparse
import os
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from uuid import UUID

import httpx
import numpy as np
from sqlalchemy.orm import joinedload

from app import registry
from app.core.db import new_id
from app.core.runtime import Runtime
from app.deliveries import service
from app.deliveries.models import Delivery
from app.deliveries.service import Origin
from app.projects.models import Project
from app.renders.models import RenderSet
from app.sound_lists.models import Cue, Stem
from app.sound_lists.rules import CueState
from benchmarks import worker_without_judgements
from benchmarks.bulk import filling
from benchmarks.served import Place, cpu_seconds, headers_for, own_cpu_seconds
from benchmarks.sounds import coloured
from benchmarks.studios import Made, ProjectMaker, make_team
from benchmarks.tables import DOCS, machine, table, write_between
from tests.support.postgres import Postgres, running_postgres
from tests.support.waves import wav_bytes

AT_MOST_S = 40.0
WARM_WITHIN_S = 120.0
POLL_EVERY_S = 0.25
UPLOADS = 60
SECONDS, RATE_HZ, BITS = 3, 48_000, 24
JUDGING = {"with judgements": ("-m", "app", "worker"), "without": worker_without_judgements.COMMAND}
HEAD = ["workers", "takes/s", "CPU, ms a take", "worker", "sandbox", "database"]


@dataclass(frozen=True)
class Cost:
    """How many takes were done in how long, and the CPU seconds of it by where they went."""

    takes: int
    taken_s: float
    worker_s: float
    sandbox_s: float
    database_s: float

    def row(self, name: str) -> list[str]:
        """Return the row of the table."""
        parts = (self.worker_s, self.sandbox_s, self.database_s)
        return [
            name,
            f"{self.takes / self.taken_s:.1f}",
            *(f"{1000 * s / self.takes:.0f}" for s in (sum(parts), *parts)),
        ]


def main() -> None:
    """Measure and write down."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.throughput", description=__doc__.partition("\n")[0])
    parser.add_argument("--takes", type=int, default=200, help="to each number of workers")
    parser.add_argument("--workers", type=int, nargs="+", default=[1, 2, 4], help="numbers of workers to try")
    parser.add_argument("--postgres", action="store_true", help="on PostgreSQL in place of SQLite")
    parser.add_argument("--docs", action="store_true", help="write PostgreSQL's table into docs/reference/benchmarks")
    options = parser.parse_args()
    registry.rooms_in_use(is_commercial=True).connect()
    kind = "PostgreSQL" if options.postgres else "SQLite"
    sounds = [sound(seed) for seed in range(options.takes + 2 * max(options.workers))]
    rows: list[list[str]] = []
    with ExitStack() as stack:
        postgres = stack.enter_context(running_postgres(durable=True)) if options.postgres else None
        print(f"{kind}, {options.takes} takes, {machine()}", flush=True)
        with _place(postgres) as place:
            upload_ms = 1000 * upload_cost_s(place, postgres, sounds[:UPLOADS])
        note = f"An upload that becomes a take costs web process and database {upload_ms:.0f} ms of CPU time."
        print(f"{note}\n{' | '.join(HEAD)}", flush=True)
        for judging, command in JUDGING.items():
            for workers in options.workers:
                with _place(postgres) as place:
                    cost = run(place, postgres, sounds[options.takes :], sounds[: options.takes], workers, command)
                rows.append(cost.row(f"{workers}, {judging}"))
                print(" | ".join(rows[-1]), flush=True)
    text = f"{kind}, {options.takes} takes, {machine()}; load average {os.getloadavg()[0]:.1f}. {note}"
    text = f"{text}\n\n{table(HEAD, rows)}"
    print(f"\n{text}")
    if options.docs and options.postgres:
        write_between(DOCS / "reference/benchmarks.md", "throughput", text)


def sound(seed: int) -> bytes:
    """Return a file of 3 s, stereo, 48 kHz and 24 bit, like no other."""
    rng = np.random.default_rng(seed)
    samples = coloured(rng, SECONDS * RATE_HZ, 2, 0.05) * np.exp(-np.linspace(0, 6, SECONDS * RATE_HZ))[:, np.newaxis]
    return wav_bytes(samples * (0.5 / np.abs(samples).max()), rate=RATE_HZ, bits=BITS)


@contextmanager
def _place(postgres: Postgres | None) -> Iterator[Place]:
    """Give a server of its own to a row: nothing that is left of one is done in the next."""
    name = f"throughput_{new_id().hex}"
    with tempfile.TemporaryDirectory(prefix="soundlist-throughput-") as folder:
        yield Place(Path(folder).resolve(), postgres.new_database(name) if postgres else "")
    if postgres:
        postgres.drop_database(name)


def upload_cost_s(place: Place, postgres: Postgres | None, sounds: list[bytes]) -> float:
    """Return the CPU seconds of web process and database for an upload that becomes a take."""
    runtime = place.runtime()
    made = _project(runtime)
    runtime.close()
    with (
        place.serving() as (address, web),
        httpx.Client(base_url=address, headers=headers_for(made.designer_secret), timeout=60) as client,
    ):

        def upload(content: bytes, name: str) -> None:
            named = {"delivery_id": delivery_id, "file_name": name}
            sent = client.put("/v1/uploads", params=named, content=content).raise_for_status()
            body = {"upload_id": sent.json()["upload_id"], "file_name": name}
            client.post(f"/v1/deliveries/{delivery_id}/takes", json=body).raise_for_status()

        opened = client.post(f"/v1/projects/{made.project_id}/deliveries", json={"note": ""}).raise_for_status()
        delivery_id = opened.json()["id"]
        upload(sounds[0], "warm.wav")
        before = cpu_seconds(web.pid) + _database_s(postgres)
        for number, content in enumerate(sounds[1:]):
            upload(content, f"take_{number}.wav")
        return (cpu_seconds(web.pid) + _database_s(postgres) - before) / len(sounds[1:])


def run(
    place: Place,
    postgres: Postgres | None,
    warm: list[bytes],
    sounds: list[bytes],
    workers: int,
    command: tuple[str, ...],
) -> Cost:
    """Return what the takes cost from the delivery of all sounds to their last job, or to the end of the time."""
    runtime = place.runtime()
    project_id = _project(runtime).project_id
    with ExitStack() as running:
        running.callback(runtime.close)
        processes = [
            running.enter_context(place.running_python(*command, name=f"worker-{number}")) for number in range(workers)
        ]

        def spent() -> tuple[float, float, float]:
            own = sum(own_cpu_seconds(process.pid) for process in processes)
            return own, sum(cpu_seconds(process.pid) for process in processes) - own, _database_s(postgres)

        deliver(runtime, project_id, warm, "warm")  # forks what checks run in, imports
        if not _waited(lambda: _is_idle(runtime), WARM_WITHIN_S):
            raise SystemExit(f"the first {len(warm)} takes were not done in {WARM_WITHIN_S:.0f} s")
        deliver(runtime, project_id, sounds, "take")
        begun, before = time.perf_counter(), spent()
        ended = _waited(lambda: _is_idle(runtime), AT_MOST_S)
        taken_s, parts = time.perf_counter() - begun, [now - then for now, then in zip(spent(), before, strict=True)]
        if any(process.poll() is not None for process in processes):
            raise SystemExit("a worker ended by itself:\n" + (place.folder / "worker-0.log").read_text()[-2000:])
        with runtime.database.reading() as session:
            takes = session.query(RenderSet).count() - len(warm)
    if ended and takes != len(sounds):
        raise SystemExit(f"{takes} of {len(sounds)} takes have their game files, and no job is left to make the others")
    return Cost(max(takes, 1), taken_s, *parts)


def _project(runtime: Runtime) -> Made:
    with filling(runtime.database) as bulk:
        return ProjectMaker(bulk, make_team(bulk, "Throughput"), takes=0, seed=1).make()


def deliver(runtime: Runtime, project_id: UUID, sounds: list[bytes], name: str) -> None:
    """Put sounds into the store, add a cue for each, and make them takes in one transaction."""
    with runtime.database.writing() as session:
        of_project = session.query(Delivery).filter_by(project_id=project_id)
        delivery = of_project.options(joinedload(Delivery.designer)).one()
        tenant: dict[str, Any] = {"studio_id": delivery.studio_id, "project_id": project_id}
        first = session.query(Cue).filter_by(project_id=project_id).count() + 1
        project = session.get_one(Project, project_id)
        for number, content in enumerate(sounds, start=first):
            stem, cue_id = f"{name}_{number}", new_id()
            session.add(Cue(id=cue_id, **tenant, number=number, position=number, name=stem, state=CueState.LOCKED))
            session.flush()
            session.add(Stem(**tenant, cue_id=cue_id, variation=1, stem=stem, folded=stem))
            stored = runtime.store.put(project.studio_id, [content])
            session.flush()
            service.add_take(session, delivery, stored.sha256, stored.size_bytes, f"{stem}.wav", Origin())


def _is_idle(runtime: Runtime) -> bool:
    return not any(lane.waiting or lane.running for lane in runtime.queue.lanes())


def _database_s(postgres: Postgres | None) -> float:
    return cpu_seconds(postgres.pid) if postgres else 0.0


def _waited(condition: Callable[[], bool], within_s: float) -> bool:
    """Return once it is so, or the time is over; whether it is so."""
    deadline = time.monotonic() + within_s
    while not (is_so := condition()) and time.monotonic() < deadline:
        time.sleep(POLL_EVERY_S)
    return is_so


if __name__ == "__main__":
    sys.exit(main())
