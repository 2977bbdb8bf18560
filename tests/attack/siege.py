"""A real server under attack: each attack alone, then all at once, while an honest person works and is timed."""

import os
import random
import threading
import time
from collections import Counter
from collections.abc import Callable, Collection, Iterator
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import cast

import httpx

from tests.attack.attacks import ATTACKS, every_route
from tests.attack.honest import Visit, honest_person, visits
from tests.attack.target import NO_ANSWER, Target
from tests.kill.processes import ProcessServer, Zygote
from tests.support.server import RunningServer, World

WEB_PROCESSES = 2
ATTACKERS = 3
HONEST_WITHIN_S = 3.0
GROWTH_MIB = 120.0  # of all web processes and their children together, while one attack runs, and after everything
POLL_EVERY_S = 0.02
RETURNS_WITHIN_S = 20.0
IDLE_S = 3.0
WARM_UPS = 8  # of some process
WARM_UP_EVERY_S = 15.0  # a long siege knows every route before it begins
NOTES = "honest.jsonl"
MAX_ROUNDS = 100_000
ATTACK_LASTS_S = 20.0  # then its other requests are left out


@dataclass
class Result:
    """The outcome of one attack."""

    name: str
    statuses: Counter[int] = field(default_factory=Counter)
    slowest_s: float = 0.0
    growth_mib: float = 0.0
    deaths: int = 0
    unanswered: bool = False

    @property
    def faults(self) -> list[str]:
        """Return what must not have happened."""
        faults = [f"{count} answers of {status}" for status, count in self.statuses.items() if status == 500]
        if self.deaths:
            faults.append(f"{self.deaths} processes died")
        if self.unanswered:
            faults.append("a request got no answer in time")
        if self.growth_mib > GROWTH_MIB:
            faults.append(f"memory grew by {self.growth_mib:.0f} MiB, limit {GROWTH_MIB:.0f}")
        return faults


@dataclass(frozen=True)
class Run:
    """When an attack ran."""

    name: str
    begun_s: float
    ended_s: float


@dataclass
class Siege:
    """The outcome of all of them."""

    results: dict[str, Result]
    visits: list[Visit] = field(default_factory=list)  # of the honest person
    runs: list[Run] = field(default_factory=list)
    begun_s: float = 0.0
    left_mib: float = 0.0  # more memory than before, after everything
    open_files: list[str] = field(default_factory=list)

    @property
    def faults(self) -> list[str]:
        """Return everything that must not have happened, in words."""
        faults = [f"{result.name}: {fault}" for result in self.results.values() for fault in result.faults]
        # A machine that is slow without any attack is not blamed on the attack.
        limit_s = max(HONEST_WITHIN_S, 3 * self.idle_s)
        for visit in self.visits:
            if visit.problem:
                faults.append(f"an honest {visit.path} {visit.problem}, {self._during(visit)}")
            elif visit.took_s > limit_s:
                faults.append(
                    f"an honest {visit.path} took {visit.took_s:.1f} s, limit {limit_s:.0f} s, {self._during(visit)}"
                )
        if not self.visits:
            faults.append("no honest request was answered")
        if self.left_mib > GROWTH_MIB:
            faults.append(f"{self.left_mib:.0f} MiB of memory did not come back, limit {GROWTH_MIB:.0f}")
        return faults + [f"other users can read {path}" for path in self.open_files]

    @property
    def idle_s(self) -> float:
        """The honest person's slowest answer before anything began."""
        return max((visit.took_s for visit in self.visits if visit.begun_s < self.begun_s), default=0.0)

    def _during(self, visit: Visit) -> str:
        ended_s = visit.begun_s + visit.took_s
        names = {run.name for run in self.runs if run.begun_s < ended_s and run.ended_s > visit.begun_s}
        return f"during {', '.join(sorted(names)) or 'no attack'}"


def lay_siege(
    zygote: Zygote,
    folder: Path,
    *,
    seconds: float,
    database_url: str = "",
    names: Collection[str] = ATTACKS,
    report: Callable[[str], object] = id,
) -> Siege:
    """Attack a new server for so long, each attack at least once, and return its outcome.

    `report` is given a line for each attack that was tried alone. What an attack left the server to do may still go
    on in the next one, and counts there.
    """
    server = ProcessServer(zygote, folder, database_url=database_url)
    try:
        begun = time.monotonic()
        world = World(cast(RunningServer, server))
        watched = Watched(server)
        target = Target(world, server.port)
        siege = Siege({name: Result(name) for name in names})
        _warm_up(target, rounds=int(seconds / WARM_UP_EVERY_S))
        watched.begin()
        with watched.memory(), _at_work(target, folder):
            time.sleep(IDLE_S)
            siege.begun_s = time.monotonic()
            for name in names:
                before_mib = watched.settled_mib()
                siege.runs.append(_attack(target, siege.results[name], watched))
                siege.results[name].growth_mib = max(0.0, watched.peak_mib - before_mib)
                report(row(siege.results[name]))
            _all_at_once(target, siege, watched, begun + seconds)
        siege.visits = visits(folder / NOTES)
        siege.left_mib = watched.left_mib()
        siege.open_files = [str(path) for path in (folder / "data").rglob("*") if path.stat().st_mode & 0o077]
        return siege
    finally:
        server.close()


class Watched:
    """The processes of a server: whether they live, and what memory they have."""

    def __init__(self, server: ProcessServer) -> None:
        self._server = server
        self._web = server.serve(web_processes=WEB_PROCESSES)
        self._worker = server.work()
        self._lock = threading.Lock()
        self._known = set(self._pids())
        self.peak_mib = 0.0
        self._before_mib = self.mib()

    def begin(self) -> None:
        """Take the memory of now for that before the attack."""
        self._before_mib = self.mib()

    def deaths(self) -> int:
        """Return how many processes died since the last look; start again what ended as a whole."""
        with self._lock:
            here = set(self._pids())
            deaths = len(self._known - here)
            if self._web.poll() is not None:
                deaths += 1
                self._web = self._server.serve(web_processes=WEB_PROCESSES)
            if self._worker.poll() is not None:
                deaths += 1
                self._worker = self._server.work()
            self._known = set(self._pids())
            return deaths

    def mib(self) -> float:
        """Return what the web processes and all below them have for themselves."""
        return sum(private_mib(pid) for pid in processes_below(self._web.pid))

    def settled_mib(self) -> float:
        """Return the memory now, from where the peak is counted again."""
        self.peak_mib = now = self.mib()
        return now

    def left_mib(self) -> float:
        """Return what has not come back, once it has or will not."""
        deadline = time.monotonic() + RETURNS_WITHIN_S
        while (left := self.mib() - self._before_mib) > GROWTH_MIB and time.monotonic() < deadline:
            time.sleep(0.5)
        return left

    @contextmanager
    def memory(self) -> Iterator[None]:
        """Look for the peak of memory as long as the block lasts."""
        over = threading.Event()

        def look() -> None:
            while not over.wait(POLL_EVERY_S):
                self.peak_mib = max(self.peak_mib, self.mib())

        looking = threading.Thread(target=look, name="memory")
        looking.start()
        try:
            yield
        finally:
            over.set()
            looking.join()

    def _pids(self) -> list[int]:
        """Return the web processes: the first one, and those that it forked to answer."""
        return [self._web.pid, *_children(self._web.pid)]


def _warm_up(target: Target, *, rounds: int) -> None:
    """Use what a process loads, starts and keeps when it is used first: what stays of that is not a leak.

    A process that has answered every route keeps some 330 compiled statements and what they load: 70 MiB.
    """
    for _ in range(WARM_UPS):
        with target.world.signed_in(target.world.producer_id) as producer:  # a connection of its own, to some process
            for path in (target.project, f"{target.project}/sound-list", f"{target.project}/documentation-key.pdf"):
                producer.get(path)
            body = {"dry_run": True, "format": "csv", "text": "name\nDoor\n"}
            producer.post(f"{target.project}/sound-list/import", json=body)
            producer.post("/v1/sign-in", json={"email": "nobody@example.test", "password": "not the right one"})
    for _ in range(rounds):
        for _status in every_route(target):
            pass


def _at_work(target: Target, folder: Path) -> AbstractContextManager[None]:
    """Let the approver work as long as the block lasts."""
    pages = [target.project, f"{target.project}/sound-list", "/v1/review-queue", f"/v1/takes/{target.take_id}"]
    client = target.world.signed_in(target.world.approver_id)
    return honest_person(client, pages, f"/v1/takes/{target.take_id}/comments", folder / NOTES)


def _attack(target: Target, result: Result, watched: Watched) -> Run:
    begun = last = time.monotonic()
    try:
        for status in ATTACKS[result.name](target):
            result.statuses[status] += 1
            now = time.monotonic()
            result.slowest_s, last = max(result.slowest_s, now - last), now
            if now - begun > ATTACK_LASTS_S:
                break
    except httpx.TimeoutException:
        result.unanswered = True
        result.slowest_s = max(result.slowest_s, time.monotonic() - last)
    except (httpx.TransportError, OSError):
        result.statuses[NO_ANSWER] += 1
    result.slowest_s = max(result.slowest_s, 0.0 if result.statuses else time.monotonic() - begun)
    result.deaths += watched.deaths()
    return Run(result.name, begun, time.monotonic())


def _all_at_once(target: Target, siege: Siege, watched: Watched, until: float) -> None:
    """Let several attackers do whatever comes to their minds."""
    rounds = iter(range(MAX_ROUNDS))
    taking = threading.Lock()

    def attack(seed: int) -> None:
        chosen = random.Random(seed)
        names = list(siege.results)
        while time.monotonic() < until:
            with taking:
                if next(rounds, None) is None:
                    return
            siege.runs.append(_attack(target, siege.results[chosen.choice(names)], watched))

    attackers = [threading.Thread(target=attack, args=(seed,), name=f"attacker {seed}") for seed in range(ATTACKERS)]
    for attacker in attackers:
        attacker.start()
    for attacker in attackers:
        attacker.join()


def row(result: Result) -> str:
    """Return the outcome of one attack, as a line of a table."""
    answers = ", ".join(f"{status or 'none'} × {count}" for status, count in sorted(result.statuses.items()))
    verdict = "; ".join(result.faults) or "held"
    return f"| {result.name} | {answers} | {result.slowest_s:.1f} s | +{result.growth_mib:.0f} MiB | {verdict} |"


def table(siege: Siege) -> str:
    """Return the outcomes, an attack a line."""
    lines = ["| attack | answers | slowest | memory | |", "|---|---|---|---|---|"]
    lines += map(row, siege.results.values())
    slowest = max((visit.took_s for visit in siege.visits), default=0.0)
    lines.append(
        f"\n{len(siege.visits)} honest requests: slowest {slowest:.2f} s, "
        f"{siege.idle_s:.2f} s before anything began; {siege.left_mib:.0f} MiB did not come back."
    )
    return "\n".join(lines)


def _children(pid: int) -> list[int]:
    try:
        return [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]
    except OSError:
        return []


def processes_below(pid: int) -> list[int]:
    """Return a process and all below it; a thread other than its first may have forked some."""
    found, todo = [], [pid]
    while todo:
        one = todo.pop()
        found.append(one)
        try:
            threads = os.listdir(f"/proc/{one}/task")
        except OSError:
            continue
        for thread in threads:
            try:
                todo += map(int, Path(f"/proc/{one}/task/{thread}/children").read_text().split())
            except OSError:
                continue
    return found


def private_mib(pid: int) -> float:
    """Return the memory that a process has for itself."""
    try:
        lines = Path(f"/proc/{pid}/status").read_text().splitlines()
    except OSError:
        return 0.0
    return sum(int(line.split()[1]) for line in lines if line.startswith("RssAnon:")) / 1024
