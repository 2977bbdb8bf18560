"""Response times and the delay of the playhead while 50 people are in the live sessions of five playlists.

    python -m benchmarks.live                     5 minutes, on a PostgreSQL server that it starts
    python -m benchmarks.live --seconds 60 --people 20

Every person has a page open: it follows the stream of changes, reports presence every three seconds, and reads the
session again at each change. In each session one person has control, and moves the playhead every five seconds.
Delay is from the moment of that act until another person's page has the new place. All sessions are in one project, so
each change reaches every page.
"""

import argparse
import asyncio
import os
import statistics
import sys
import tempfile
import time
from collections import defaultdict
from contextlib import ExitStack
from pathlib import Path
from urllib.parse import urlsplit

import sqlalchemy as sa

from app.accounts.models import Membership, Person
from app.accounts.rules import Role
from app.core.db import new_id
from app.core.runtime import Runtime
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from benchmarks.asking import Answer, Broken, Client
from benchmarks.bulk import analyse, filling
from benchmarks.load import P95_MS, WEB_PROCESSES
from benchmarks.served import Place, headers_for
from benchmarks.studios import Made, ProjectMaker, make_team, sign_in
from benchmarks.tables import DOCS, machine, table, write_between
from tests.support.postgres import running_postgres

SESSIONS = 5
REPORT_EVERY_S, MOVE_EVERY_S = 3.0, 5.0
PLAYLIST_TAKES = 40
TAKES = 1_000


class Outcome:
    """The results: milliseconds by kind, and what went wrong."""

    def __init__(self) -> None:
        self.times_ms: dict[str, list[float]] = defaultdict(list)
        self.wrong: list[str] = []
        self.moved_at: dict[tuple[str, int], float] = {}  # when the holder moved the playhead, by session and sequence


class Listener:
    """One person's page in a session."""

    def __init__(self, address: str, secret: str, playlist_id: str, takes: list[str], outcome: Outcome) -> None:
        self._place = urlsplit(address)
        self._headers = headers_for(secret)
        self._client = Client(address, self._headers)
        self._live = f"/v1/playlists/{playlist_id}/live"
        self._playlist_id, self._takes, self._outcome = playlist_id, takes, outcome
        self._sequence = 0
        self._changed = asyncio.Event()

    async def follow(self, until: float) -> None:
        """Note each change that the server sends."""
        reader, writer = await asyncio.open_connection(self._place.hostname, self._place.port)
        fields = "".join(f"{name}: {value}\r\n" for name, value in self._headers.items())
        writer.write(f"GET /v1/events HTTP/1.1\r\nHost: {self._place.netloc}\r\n{fields}\r\n".encode())
        try:
            async with asyncio.timeout_at(asyncio.get_running_loop().time() + until - time.perf_counter()):
                while line := await reader.readline():
                    if line.startswith(b"event: change"):
                        self._changed.set()
            self._outcome.wrong.append("a stream of changes ended")
        except TimeoutError:
            pass
        finally:
            writer.close()

    async def read(self, until: float) -> None:
        """Read the session whenever something changed."""
        while (left_s := until - time.perf_counter()) > 0:
            try:
                await asyncio.wait_for(self._changed.wait(), left_s)
            except TimeoutError:
                return
            self._changed.clear()
            answer = await self._ask("read the session", "GET", self._live)
            sequence = answer.json()["sequence"] if answer else self._sequence
            moved_at = self._outcome.moved_at.get((self._playlist_id, sequence))
            if sequence > self._sequence and moved_at is not None:
                self._outcome.times_ms["delay of the playhead"].append(1000 * (time.perf_counter() - moved_at))
            self._sequence = max(self._sequence, sequence)

    async def report(self, until: float, first_s: float) -> None:
        """Say every few seconds that the page is open."""
        await asyncio.sleep(first_s)
        while time.perf_counter() < until:
            await self._ask("report presence", "PUT", f"{self._live}/presence", {"leaves": False})
            await asyncio.sleep(REPORT_EVERY_S)

    async def lead(self, until: float, first_s: float) -> None:
        """Take the keys, and go from sound to sound."""
        await asyncio.sleep(REPORT_EVERY_S + first_s)
        taken = await self._ask("take the keys", "PUT", f"{self._live}/keys", {"act": "take"})
        sequence = taken.json()["sequence"] if taken else 0
        for number in range(10_000):
            if time.perf_counter() + MOVE_EVERY_S > until:
                return
            self._outcome.moved_at[self._playlist_id, sequence + 1] = time.perf_counter()
            body = {"sequence": sequence, "take_id": self._takes[number % len(self._takes)]}
            moved = await self._ask(
                "move the playhead", "PUT", f"{self._live}/playhead", body | {"is_playing": True, "position_s": 0.0}
            )
            sequence = self._sequence = moved.json()["sequence"] if moved else sequence
            await asyncio.sleep(MOVE_EVERY_S)

    async def _ask(self, kind: str, method: str, path: str, body: object = None) -> Answer | None:
        begun = time.perf_counter()
        try:
            asked = self._client.ask(method, path) if body is None else self._client.ask_json(method, path, body)
            answer = await asked
        except Broken as error:
            self._outcome.wrong.append(f"{kind}: {error!r}")
            return None
        self._outcome.times_ms[kind].append(1000 * (time.perf_counter() - begun))
        if not answer.is_success:
            self._outcome.wrong.append(f"{kind}: {answer.status} {answer.body[:200].decode()}")
            return None
        return answer


async def sessions(address: str, made: Made, secrets: list[str], takes: list[str], seconds: float) -> Outcome:
    """Make the playlists, let all join, and return what was measured."""
    outcome, listeners = Outcome(), []
    producer = Client(address, headers_for(made.producer_secret))
    for number in range(SESSIONS):
        chosen = takes[number * PLAYLIST_TAKES : (number + 1) * PLAYLIST_TAKES]
        added = await producer.ask_json(
            "POST", f"/v1/projects/{made.project_id}/playlists", {"name": f"Session {number}", "take_ids": chosen}
        )
        playlist_id = added.ensured().json()["id"]
        listeners += [Listener(address, secret, playlist_id, chosen, outcome) for secret in secrets[number::SESSIONS]]
    until = time.perf_counter() + seconds
    doing = []
    for place, one in enumerate(listeners):
        spread = place / len(listeners)
        doing += [one.follow(until), one.read(until), one.report(until, REPORT_EVERY_S * spread)]
        if place % (len(listeners) // SESSIONS) == 0:
            doing.append(one.lead(until, MOVE_EVERY_S * spread))
    await asyncio.gather(*doing)
    return outcome


def fill(runtime: Runtime, people: int) -> tuple[Made, list[str], list[str]]:
    """Make a project and its team; return it, the secrets of so many people, and takes that can be heard."""
    with filling(runtime.database) as bulk:
        team = make_team(bulk, "Live")
        made = ProjectMaker(bulk, team, takes=TAKES, seed=1).make()
        secrets = []
        for number in range(people):
            person_id = new_id()
            bulk.add(Person, id=person_id, email=f"{person_id}@live.example", name=f"Listener {number}")
            bulk.add(Membership, studio_id=made.studio_id, person_id=person_id, roles=[Role.REVIEWER])
            secrets.append(sign_in(bulk, person_id))
    analyse(runtime.database)
    with runtime.database.reading() as session:
        heard = sa.select(Take.id).where(Take.state.in_((TakeState.APPROVED, TakeState.CONFORMING)))
        takes = [str(take_id) for take_id in session.scalars(heard.limit(SESSIONS * PLAYLIST_TAKES))]
    return made, secrets, takes


def report(outcome: Outcome, options: argparse.Namespace) -> str:
    """Return what was found, as Markdown."""
    rows = [
        [kind, len(times), *(f"{_p(times, part):.0f}" for part in (50, 95, 99))]
        for kind, times in outcome.times_ms.items()
    ]
    asked = [taken for kind, times in outcome.times_ms.items() if kind != "delay of the playhead" for taken in times]
    met = "met" if _p(asked, 95) <= P95_MS and not outcome.wrong else "not met"
    head = (
        f"{options.people} people in {SESSIONS} sessions, {options.seconds:g} s, {machine()}; load average"
        f" {os.getloadavg()[0]:.1f}. {len(asked) / options.seconds:.0f} requests a second; {len(outcome.wrong)} errors."
        f" The limit, a p95 of {P95_MS:.0f} ms without an error, was {met}."
    )
    return f"{head}\n\n{table(['ms', 'times', 'p50', 'p95', 'p99'], rows)}"


def _p(times_ms: list[float], part: int) -> float:
    return statistics.quantiles(times_ms, n=100)[part - 1] if len(times_ms) > 1 else sum(times_ms)


def main() -> None:
    """Run the sessions, and print the report."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.live", description=__doc__.partition("\n")[0])
    parser.add_argument("--seconds", type=float, default=300.0)
    parser.add_argument("--people", type=int, default=50)
    parser.add_argument("--docs", action="store_true", help="write the table into docs/reference/benchmarks.md")
    options = parser.parse_args()
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="soundlist-live-"))).resolve()
        postgres = stack.enter_context(running_postgres(durable=True))
        place = Place(folder, postgres.new_database("live"))
        runtime = place.runtime()
        stack.callback(runtime.close)
        made, secrets, takes = fill(runtime, options.people)
        address, _ = stack.enter_context(place.serving(processes=WEB_PROCESSES))
        outcome = asyncio.run(sessions(address, made, secrets, takes, options.seconds))
    text = report(outcome, options)
    print(text)
    if options.docs:
        write_between(DOCS / "reference/benchmarks.md", "live", text)
    if outcome.wrong:
        raise SystemExit("\n".join([f"{len(outcome.wrong)} errors; the first of them:", *outcome.wrong[:5]]))


if __name__ == "__main__":
    sys.exit(main())
