"""Takes checked and rendered a second, by 1, 2 and 4 workers.

    python -m benchmarks.throughput                      300 takes of 3 s, 48 kHz/24 bit stereo
    python -m benchmarks.throughput --quick              40 takes, 1 and 2 workers
    python -m benchmarks.throughput --database postgresql://…   on PostgreSQL; the database must be empty

From the moment at which all takes are written down to the one at which no job waits or runs: each is checked,
drawn, rendered to two targets, each of them measured and drawn again, and its people are told. CPU time is that of
the workers and of all their children, so it says what a free machine could do where this one is shared.
"""

import argparse
import os
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from uuid import UUID

import numpy as np

from app import rooms
from app.deliveries import service
from app.deliveries.models import Delivery
from app.deliveries.service import Origin
from app.kit import events
from app.kit.db import new_id
from app.kit.runtime import Runtime
from app.projects.models import Project
from app.renders.models import RenderSet
from app.sound_lists.models import Cue, Stem
from app.sound_lists.rules import CueState
from benchmarks import worker_without_judgements
from benchmarks.bulk import filling
from benchmarks.served import Place
from benchmarks.sounds import coloured
from benchmarks.studios import ProjectMaker, make_team
from benchmarks.tables import DOCS, machine, table, write_between
from tests.support.waves import wav_bytes

WITHIN_S = 300.0
MUST_TAKES_S = 20.0
SECONDS, RATE_HZ, BITS = 3, 48_000, 24
TICKS_A_SECOND = os.sysconf("SC_CLK_TCK")
JUDGING = {"with judgements": ("-m", "app", "worker"), "without": worker_without_judgements.COMMAND}


def main() -> None:
    """Measure and write down."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.throughput", description=__doc__.partition("\n")[0])
    parser.add_argument("--quick", action="store_true", help="few takes; nothing is written to docs")
    parser.add_argument("--database", default="", help="an empty PostgreSQL database; SQLite if left out")
    parser.add_argument("--docs", action="store_true", help="write the table into docs/scale.md")
    options = parser.parse_args()
    takes, numbers = (40, (1, 2)) if options.quick else (300, (1, 2, 4))
    rows = []
    with tempfile.TemporaryDirectory(prefix="soundlist-throughput-") as folder:
        place = Place(Path(folder).resolve(), options.database)
        runtime = place.runtime()
        events.connect(rooms.SUBSCRIBERS)
        sounds = [sound(seed) for seed in range(takes + 2 * max(numbers))]
        for judging in reversed(JUDGING):
            for workers in numbers:
                taken_s, cpu_s = run(place, runtime, sounds[takes:], sounds[:takes], workers, JUDGING[judging])
                rows.append([f"{workers}, {judging}", f"{takes / taken_s:.1f}", f"{1000 * cpu_s / takes:.0f}"])
                print(rows[-1], flush=True)
        runtime.close()
    kind = "PostgreSQL" if options.database else "SQLite"
    text = table(["workers", "takes/s", "CPU, ms a take"], rows)
    text = f"{kind}, {takes} takes, {machine()}; {os.getloadavg()[0]:.1f} processes were running.\n\n{text}"
    print(text)
    if options.docs:
        write_between(DOCS / "scale.md", f"throughput {kind.lower()}", text)


def sound(seed: int) -> bytes:
    """Return a file of 3 s, stereo, 48 kHz and 24 bit, like no other."""
    rng = np.random.default_rng(seed)
    samples = coloured(rng, SECONDS * RATE_HZ, 2, 0.05) * np.exp(-np.linspace(0, 6, SECONDS * RATE_HZ))[:, np.newaxis]
    return wav_bytes(samples * (0.5 / np.abs(samples).max()), rate=RATE_HZ, bits=BITS)


def run(
    place: Place, runtime: Runtime, warm: list[bytes], sounds: list[bytes], workers: int, command: tuple[str, ...]
) -> tuple[float, float]:
    """Return wall and CPU seconds from the delivery of all sounds, in a project of their own, to their last job."""
    with filling(runtime.database) as bulk:
        made = ProjectMaker(bulk, make_team(bulk, f"{workers} workers"), takes=0, seed=1).make()
    with ExitStack() as running:
        processes = [
            running.enter_context(place.running_python(*command, name=f"worker-{number}")) for number in range(workers)
        ]

        def done(count: int) -> bool:
            if any(process.poll() is not None for process in processes):
                raise SystemExit("a worker ended by itself:\n" + (place.folder / "worker-0.log").read_text()[-2000:])
            return is_done(runtime, count, made.project_id)

        deliver(runtime, made.project_id, warm, "warm")  # forks what checks run in, imports
        until(lambda: done(len(warm)), "the first takes")
        before = sum(cpu_seconds(process.pid) for process in processes)
        deliver(runtime, made.project_id, sounds, "take")
        begun = time.perf_counter()
        until(lambda: done(len(warm) + len(sounds)), "all takes")
        return time.perf_counter() - begun, sum(cpu_seconds(process.pid) for process in processes) - before


def deliver(runtime: Runtime, project_id: UUID, sounds: list[bytes], name: str) -> None:
    """Put sounds into the store, add a cue for each, and make them takes in one transaction."""
    with runtime.database.writing() as session:
        delivery = session.query(Delivery).filter_by(project_id=project_id).one()
        tenant = {"studio_id": delivery.studio_id, "project_id": project_id}
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


def is_done(runtime: Runtime, takes: int, project_id: UUID) -> bool:
    """Whether so many takes have their game files, and no job waits or runs."""
    if any(lane.waiting or lane.running for lane in runtime.queue.lanes()):
        return False
    with runtime.database.reading() as session:
        studio_id = session.get_one(Project, project_id).studio_id
        done = session.query(RenderSet).filter_by(studio_id=studio_id).count()
    if done != takes:
        raise SystemExit(f"{done} of {takes} takes have their game files, and no job is left to make the others")
    return True


def cpu_seconds(pid: int) -> float:
    """Return what a process and all below it have used, those that ended included."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    below = Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    return sum(map(int, fields[11:15])) / TICKS_A_SECOND + sum(cpu_seconds(int(child)) for child in below)


def until(condition: Callable[[], object], what: str) -> None:
    """Return once it is so; say what was awaited if it never is."""
    deadline = time.monotonic() + WITHIN_S
    while not condition():
        if time.monotonic() > deadline:
            raise SystemExit(f"waited {WITHIN_S:.0f} s for {what}")
        time.sleep(0.05)


if __name__ == "__main__":
    sys.exit(main())
