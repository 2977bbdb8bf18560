"""The server's response times under 200 uploads at once and 50 requests a second.

    python -m benchmarks.load                     5 minutes, on a PostgreSQL and an S3 server that it starts
    python -m benchmarks.load --seconds 60 --uploads 50 --rate 20

Each of the 200 uploads lasts 20 seconds, as over a line of 350 kbit/s, becomes a take that is checked and drawn,
and is followed by the next. Requests come at fixed times whether or not earlier ones are answered, and are timed from
then: waiting counts. They are those of a working day in a project of 10,000 takes: lists, queue, search, single
takes, comments and verdicts. Two web processes for each core and one worker share the machine with database, store and
the clients.
"""

import argparse
import asyncio
import itertools
import os
import random
import statistics
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import AsyncIterator, Callable, Coroutine, Mapping
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from subprocess import Popen
from typing import Any
from urllib.parse import urlencode
from uuid import UUID

import sqlalchemy as sa

from app.conformance.models import CheckRun
from app.core.runtime import Runtime
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState
from benchmarks.asking import Answer, Broken, Client, Refused
from benchmarks.bulk import analyse, filling
from benchmarks.served import Place, cpu_now_s, cpu_seconds, cpu_since_s, headers_for, memory_bytes, own_cpu_seconds
from benchmarks.studios import Made, ProjectMaker, make_team
from benchmarks.tables import DOCS, machine, table, write_between
from benchmarks.throughput import sound
from tests.support.deliver import BYTES, TUS, metadata
from tests.support.postgres import running_postgres
from tests.support.s3 import run_s3

P95_MS = 250.0
TAKES = 10_000
UPLOAD_S = 20.0
PIECES = 20
POLL_EVERY_S = 2.0
SAY_EVERY_S = 30.0
APPROVES_EVERY = 5  # rounds of requests of each kind: the approver decides once a second, and some 450 takes wait
CALM_S = 5.0  # before anything is timed
WARM_UP, ALONE = 6, 15  # answers of each kind before the load; psycopg prepares a statement at its sixth time
TYPED = ("laser", "door close", "SC-77", "water", "too bright", "wing_land", "zzz", "metal hull", "music", "step")
WEB_PROCESSES = 2 * (os.cpu_count() or 1)  # as docs/reference/settings.md says
WORKER_NICENESS = 19  # as in deploy/systemd: people who wait for an answer go first
HEADER_BYTES, SAMPLE_BYTES = 44, 3
Answered = Coroutine[Any, Any, Answer]


@dataclass
class Outcome:
    """The results: seconds by kind of request, what went wrong, and memory as it went."""

    times_s: dict[str, list[float]] = field(default_factory=lambda: defaultdict(list))
    by_minute_s: dict[int, list[float]] = field(default_factory=lambda: defaultdict(list))  # by when they were due
    begun: float = 0.0
    wrong: list[str] = field(default_factory=list)
    memory_bytes: dict[str, list[int]] = field(default_factory=lambda: defaultdict(list))
    alone_s: dict[str, float] = field(default_factory=dict)  # CPU of web process and database, by kind
    takes: int = 0

    def add(self, kind: str, taken_s: float, answer: Answer | Exception) -> None:
        """Note one answer."""
        self.times_s[kind].append(taken_s)
        self.by_minute_s[int((time.perf_counter() - taken_s - self.begun) // 60)].append(taken_s)
        if isinstance(answer, Exception):
            self.wrong.append(f"{kind}: {answer!r}")
        elif not answer.is_success:
            self.wrong.append(f"{kind}: {answer.status} {answer.body[:200].decode()}")


class People:
    """The clients: a designer who delivers, and the approver's side that reads and decides."""

    def __init__(self, address: str, made: Made, to_approve: list[UUID], takes: list[UUID], outcome: Outcome) -> None:
        secrets = (made.designer_secret, made.approver_secret)
        self.designer, self.approver = (Client(address, headers_for(secret)) for secret in secrets)
        self._project = f"/v1/projects/{made.project_id}"
        self._project_id = made.project_id
        self._takes = takes
        self._to_approve = iter(to_approve)
        self._dice = random.Random(1)
        self._names = itertools.count(1)
        self.outcome = outcome

    async def ask(self, kind: str, due: float) -> None:
        """Ask once, timed from when it was due."""
        try:
            answer: Answer | Exception = await self.kinds[kind](self)
        except Broken as error:
            answer = error
        self.outcome.add(kind, time.perf_counter() - due, answer)

    async def cost_alone_s(self, web_pid: int, database_pid: int) -> None:
        """Record the CPU time of one answer of each kind without other load: the median of a few."""
        for kind, ask in self.kinds.items():
            costs = []
            for _ in range(WARM_UP + ALONE):
                before = cpu_now_s(web_pid, database_pid)
                (await ask(self)).ensured()
                costs.append(cpu_since_s(before, web_pid, database_pid))
            self.outcome.alone_s[kind] = statistics.median(costs[WARM_UP:])
            print(f"{kind:20} {1000 * self.outcome.alone_s[kind]:6.1f} ms of CPU alone", flush=True)

    async def deliver(self, content: bytes, until: float) -> None:
        """Send files, one after the other, each in many pieces over its time."""
        await asyncio.sleep(self._dice.random() * UPLOAD_S)
        delivery_id = ""
        while time.perf_counter() < until:
            try:
                if not delivery_id:
                    opened = await self.designer.ask_json("POST", f"{self._project}/deliveries", {"note": "load"})
                    delivery_id = str(opened.ensured().json()["id"])
                await self._deliver_one(delivery_id, f"load_{next(self._names)}.wav", unlike(content, self._dice))
            except (Broken, Refused) as error:
                self.outcome.wrong.append(f"upload: {error!r}")

    async def _deliver_one(self, delivery_id: str, name: str, content: bytes) -> None:
        named = metadata(delivery_id=delivery_id, file_name=name)
        headers = TUS | {"Upload-Length": str(len(content)), "Upload-Metadata": named}
        begun = (await self.designer.ask("POST", "/v1/uploads", headers=headers)).ensured()
        location = begun.headers["location"]
        headers = TUS | BYTES | {"Upload-Offset": "0", "Content-Length": str(len(content))}
        sent = await self.designer.ask("PATCH", location, headers=headers, pieces=in_pieces(content))
        body = {"upload_id": location.rpartition("/")[2], "file_name": name}
        due = time.perf_counter()
        made = await self.designer.ask_json("POST", f"/v1/deliveries/{delivery_id}/takes", body)
        self.outcome.add("a finished upload becomes a take", time.perf_counter() - due, made)
        if sent.is_success and made.is_success:
            self.outcome.takes += 1
        else:
            self.outcome.wrong.append(f"upload: {sent.status} {sent.body[:200].decode()}")

    def _get(self, path: str, **params: str) -> Answered:
        return self.approver.ask("GET", f"{path}?{urlencode(params)}" if params else path)

    def _take(self) -> str:
        return f"/v1/takes/{self._dice.choice(self._takes)}"

    def _find(self) -> Answered:
        return self._get(f"{self._project}/find", q=self._dice.choice(TYPED))

    def _comment(self) -> Answered:
        return self.approver.ask_json("POST", f"{self._take()}/comments", {"text": "a little shorter", "start_s": 0.5})

    def _approve(self) -> Answered:
        return self.approver.ask_json("POST", f"/v1/takes/{next(self._to_approve)}/verdict", {"kind": "approve"})

    kinds: dict[str, Callable[["People"], Answered]] = {  # noqa: RUF012 - of the class, and never changed
        "review queue": lambda self: self._get("/v1/review-queue", project_id=str(self._project_id)),
        "sound list": lambda self: self._get(f"{self._project}/sound-list"),
        "where cues stand": lambda self: self._get(f"{self._project}/sound-list/progress"),
        "search": _find,
        "deliveries": lambda self: self.designer.ask("GET", f"{self._project}/deliveries"),
        "a take": lambda self: self._get(self._take()),
        "its sounds": lambda self: self._get(f"{self._take()}/sounds"),
        "its comments": lambda self: self._get(f"{self._take()}/comments"),
        "comment": _comment,
        "approve": _approve,
    }


def unlike(content: bytes, dice: random.Random) -> bytes:
    """Return the same sound, but for the last bits of some samples: no other is like it, and none is known yet."""
    changed = bytearray(content)
    for place in range(64):
        changed[HEADER_BYTES + SAMPLE_BYTES * place] = dice.randrange(256)
    return bytes(changed)


async def in_pieces(content: bytes) -> AsyncIterator[bytes]:
    """Yield a file as a slow line does."""
    size = -(-len(content) // PIECES)
    for start in range(0, len(content), size):
        yield content[start : start + size]
        await asyncio.sleep(UPLOAD_S / PIECES)


async def load(
    people: People, *, seconds: float, uploads: int, rate: float, watch: Callable[[], None], pids: Mapping[str, int]
) -> dict[str, float]:
    """Measure without load, then run the load; return the CPU time of each process under it, in seconds."""
    for client in (people.designer, people.approver):
        await client.open()
    await people.cost_alone_s(pids["web"], pids["database"])
    content = sound(1)
    pids = {**pids, "client": os.getpid()}
    before = {name: own_cpu_s(name, pid) for name, pid in pids.items()}
    begun = people.outcome.begun = time.perf_counter()
    until = begun + seconds
    deliveries = [asyncio.create_task(people.deliver(content, until)) for _ in range(uploads)]
    asked: set[asyncio.Task[None]] = set()

    async def watching() -> None:
        last_said, used_s = begun, before
        while time.perf_counter() < until:
            watch()
            await asyncio.sleep(POLL_EVERY_S)
            if (now := time.perf_counter()) - last_said >= SAY_EVERY_S:
                now_s = {name: own_cpu_s(name, pid) for name, pid in pids.items()}
                cores = {name: (now_s[name] - used_s[name]) / (now - last_said) for name in pids}
                print(
                    f"{now - begun:4.0f} s: cores", *(f"{name} {used:.2f}" for name, used in cores.items()), flush=True
                )
                last_said, used_s = now, now_s

    watched = asyncio.create_task(watching())
    kinds = list(people.kinds)
    for number in range(int(seconds * rate)):
        due = begun + number / rate
        await asyncio.sleep(max(0.0, due - time.perf_counter()))
        rounds, place = divmod(number, len(kinds))
        kind = kinds[place] if kinds[place] != "approve" or rounds % APPROVES_EVERY == 0 else "a take"
        task = asyncio.create_task(people.ask(kind, due))
        asked.add(task)
        task.add_done_callback(asked.discard)
    await asyncio.gather(*asked, watched, *deliveries)
    for client in (people.designer, people.approver):
        client.close()
    return {name: own_cpu_s(name, pid) - before[name] for name, pid in pids.items()}


def own_cpu_s(name: str, pid: int) -> float:
    """Return what a process has used: the client by itself, since all others are below it."""
    return own_cpu_seconds(pid) if name == "client" else cpu_seconds(pid)


def main() -> None:
    """Load the server, and print the report."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.load", description=__doc__.partition("\n")[0])
    parser.add_argument("--seconds", type=float, default=300.0)
    parser.add_argument("--uploads", type=int, default=200, help="at once")
    parser.add_argument("--rate", type=float, default=50.0, help="requests a second")
    parser.add_argument("--docs", action="store_true", help="write the table into docs/reference/benchmarks.md")
    options = parser.parse_args()
    outcome = Outcome()
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="soundlist-load-"))).resolve()
        postgres = stack.enter_context(running_postgres(durable=True))
        store = stack.enter_context(run_s3(folder / "s3")).settings()
        named = {name if name.startswith("aws") else f"soundlist_{name}": value for name, value in store.items()}
        place = Place(folder, postgres.new_database("load"), {name.upper(): value for name, value in named.items()})
        runtime = place.runtime()
        stack.callback(runtime.close)
        made, to_approve, takes = fill(runtime)
        wanted = WARM_UP + ALONE + int(options.seconds * options.rate) // (len(People.kinds) * APPROVES_EVERY) + 1
        if wanted > len(to_approve):
            parser.error(f"so long a run approves {wanted} takes, and {len(to_approve)} wait; ask for fewer --seconds")
        address, web = stack.enter_context(place.serving(processes=WEB_PROCESSES))
        worker = stack.enter_context(place.running("worker", name="worker"))
        os.setpriority(os.PRIO_PROCESS, worker.pid, WORKER_NICENESS)
        time.sleep(CALM_S)
        print(f"{options.uploads} uploads at once, {options.rate:g} requests/s, {options.seconds:g} s …", flush=True)
        processes = {"web": web, "worker": worker}
        pids = {name: process.pid for name, process in processes.items()} | {"database": postgres.pid}
        checked = checked_takes(runtime)
        people = People(address, made, to_approve, takes, outcome)
        watch = watcher(outcome, processes)
        loading = load(
            people, seconds=options.seconds, uploads=options.uploads, rate=options.rate, watch=watch, pids=pids
        )
        spent = asyncio.run(loading)
        checked = checked_takes(runtime) - checked
    text = report(outcome, options, spent, checked)
    print(text)
    if options.docs:
        write_between(DOCS / "reference/benchmarks.md", "load", text)
    if outcome.wrong:
        raise SystemExit("\n".join([f"{len(outcome.wrong)} errors; the first of them:", *outcome.wrong[:5]]))


def fill(runtime: Runtime) -> tuple[Made, list[UUID], list[UUID]]:
    """Make a project; return it, the takes that may be approved, and takes of every kind."""
    with filling(runtime.database) as bulk:
        made = ProjectMaker(bulk, make_team(bulk, "Load"), takes=TAKES, seed=1).make()
    analyse(runtime.database)
    with runtime.database.reading() as session:
        rows = session.execute(
            sa.select(Take.id, Take.state, Take.cue_id, Take.variation, Cue.state.label("cue_state")).join(
                Cue, Cue.id == Take.cue_id, isouter=True
            )
        ).all()
    waiting = {
        (row.cue_id, row.variation): row.id
        for row in rows
        if row.state is TakeState.CONFORMING and row.cue_state is not CueState.CUT
    }
    return made, list(waiting.values()), [row.id for row in rows if row.state is not TakeState.RECEIVED]


def checked_takes(runtime: Runtime) -> int:
    """Return how often takes were checked; what is sent here fits no cue, so that no game file is made of it."""
    with runtime.database.reading() as session:
        return session.query(CheckRun).count()


def watcher(outcome: Outcome, processes: dict[str, Popen[bytes]]) -> Callable[[], None]:
    """Return what notes the memory of each process and all below it."""

    def watch() -> None:
        for name, process in processes.items():
            outcome.memory_bytes[name].append(memory_bytes(process.pid))

    return watch


def report(outcome: Outcome, options: argparse.Namespace, cpu_s: dict[str, float], checked: int) -> str:
    """Return what was found, as Markdown."""
    rows = [[*_row(kind, times), _alone(outcome, kind)] for kind, times in outcome.times_s.items()]
    whole = [taken for times in outcome.times_s.values() for taken in times]
    rows.append([*_row("all", whole), ""])
    growth = ", ".join(f"{name} {_growth(sizes)}" for name, sizes in outcome.memory_bytes.items())
    spent = ", ".join(f"{name} {1000 * seconds / len(whole):.0f}" for name, seconds in cpu_s.items())
    met = "met" if _p_ms(whole, 95) <= P95_MS and not outcome.wrong else "not met"
    minutes = ", ".join(f"{_p_ms(times, 95):.0f}" for _, times in sorted(outcome.by_minute_s.items()))
    lines = (
        f"{options.uploads} uploads at once, {options.rate:g} requests/s, {options.seconds:g} s, {machine()};"
        f" load average {os.getloadavg()[0]:.1f}.",
        f"{outcome.takes} files arrived, {checked} takes were checked meanwhile; {len(outcome.wrong)} errors.",
        f"p95 by minute, ms: {minutes}.",
        f"Memory, first and last quarter: {growth}.",
        f"CPU time per request, uploads and jobs included, ms: {spent}.",
        f"The limit, a p95 of {P95_MS:.0f} ms without an error, was {met}.",
    )
    return " ".join(lines) + "\n\n" + table(["ms", "requests", "p50", "p95", "p99", "CPU alone"], rows)


def _alone(outcome: Outcome, kind: str) -> str:
    return f"{1000 * outcome.alone_s[kind]:.0f}" if kind in outcome.alone_s else ""


def _row(kind: str, times_s: list[float]) -> list[object]:
    return [kind, len(times_s), *(f"{_p_ms(times_s, part):.0f}" for part in (50, 95, 99))]


def _p_ms(times_s: list[float], part: int) -> float:
    return 1000 * (statistics.quantiles(times_s, n=100)[part - 1] if len(times_s) > 1 else sum(times_s))


def _growth(sizes: list[int]) -> str:
    quarter = max(1, len(sizes) // 4)
    first, last = (statistics.median(part) / 2**20 for part in (sizes[:quarter], sizes[-quarter:]))
    return f"{first:.0f} and {last:.0f} MiB"


if __name__ == "__main__":
    sys.exit(main())
