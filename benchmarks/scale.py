"""How screens answer as projects and the server grow.

    python -m benchmarks.scale --keep DIR             a project of 100,000 takes on a server of 1,000,000, on SQLite
    python -m benchmarks.scale --keep DIR --postgresql    the same on PostgreSQL, a server of its own in the folder
    python -m benchmarks.scale --quick                a hundredth of it, in a minute
    … --docs                                          and write the main rows and the picture into docs

The whole table, and the indexes by which rows are found, are printed only.

Filling comes first and takes minutes; what is filled once in a folder that is kept is asked again and again.
"""

import argparse
import json
import os
import random
import statistics
import tempfile
import time
from collections.abc import Iterable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from urllib.parse import quote
from uuid import UUID

import httpx
import sqlalchemy as sa
from fastapi.testclient import TestClient

from app import logs
from app.core import clock
from app.core.db import Base
from app.main import create_app
from app.row_security import condition
from benchmarks.bulk import analyse, bare, filling
from benchmarks.growth import draw_growth
from benchmarks.plans import heard, indexes_used, whole_reads
from benchmarks.screens import SCREENS, WORDS, Screen, sign_in
from benchmarks.served import Place, cpu_now_s, cpu_since_s, headers_for
from benchmarks.studios import Made, ProjectMaker, Team, make_team, others
from benchmarks.tables import DOCS, machine, table, write_between
from tests.support.postgres import Postgres

DATABASE = "scale"
FILLED = "filled.json"
LIMIT_MS = 100.0
HELD = ("review queue", "sound list", "where its cues stand", "search")  # to the limit; drawn, and asked first
IN_DOCS = (*HELD, "today", "desk")
FURTHER = ", further pages"
BITE_BYTES = 2**20
WARM_UP = 3
ASKS = 50  # of one screen in one project
LEAST, LEAST_OF_OTHERS, MAX_DURATION_S = (
    20,
    5,
    2.0,
)  # asks of a slow one: of those that are held to the limit, of others
LARGE_ROWS = 10_000
TURNS = 3  # with and without policies


@dataclass(frozen=True)
class Size:
    """How much to make."""

    projects: tuple[int, ...]  # takes
    server: int  # takes in all


FULL = Size((1_000, 3_000, 10_000, 30_000, 100_000), 1_000_000)
QUICK = Size((1_000, 3_000), 10_000)


def fill(place: Place, size: Size) -> list[Made]:
    """Make the projects that are measured and those of others around them."""
    runtime, begun, takes_made = place.runtime(), time.monotonic(), 0
    with bare(runtime.database):
        with filling(runtime.database) as bulk:

            def make(studio: str, takes: int, seed: int) -> Made:
                nonlocal takes_made
                if studio not in teams:
                    teams[studio] = make_team(bulk, studio)
                made = ProjectMaker(bulk, teams[studio], takes=takes, seed=seed).make()
                takes_made += made.takes
                print(f"{time.monotonic() - begun:6.0f} s  {takes_made:>9,} takes", flush=True)
                return made

            teams: dict[str, Team] = {}
            # each in a studio of its own: a queue of all projects is then of that size
            measured = [make(f"Measured {takes}", takes, takes) for takes in size.projects]
            for network_of, takes in others(size.server - sum(size.projects)):
                make(f"Other {network_of}", takes, takes + network_of)
        print(f"{time.monotonic() - begun:6.0f} s  {bulk.written:>9,} rows; indexes next", flush=True)
    analyse(runtime.database)
    print(f"{time.monotonic() - begun:6.0f} s  filled", flush=True)
    runtime.close()
    return measured


def filled(place: Place, size: Size) -> list[Made]:
    """Return the projects that are measured, made now or by an earlier run in the same folder."""
    kept = place.folder / FILLED
    if not kept.exists():
        made = fill(place, size)
        kept.write_text(json.dumps([asdict(each) for each in made], default=str))
    ids = ("studio_id", "project_id")
    return [Made(**each | {key: UUID(each[key]) for key in ids}) for each in json.loads(kept.read_text())]


@contextmanager
def placed(kept: Path | None, *, postgresql: bool) -> Iterator[tuple[Place, Postgres | None]]:
    """Give a place to fill, and the PostgreSQL server that was started in it where one is wanted."""
    with ExitStack() as stack:
        folder = kept or Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="soundlist-scale-")))
        folder.mkdir(parents=True, exist_ok=True)
        folder = folder.resolve()
        if not postgresql:
            yield Place(folder), None
            return
        folder.chmod(0o755)  # the server runs as a user of its own
        (folder / "postgresql").mkdir(exist_ok=True)
        server = Postgres(folder / "postgresql", durable=True)
        server.start()
        stack.callback(server.stop)
        url = server.url(DATABASE) if server.has_database(DATABASE) else server.new_database(DATABASE)
        yield Place(folder, url), server


def into_memory(folder: Path) -> None:
    """Read every file once, so that the system holds it: a server that runs has its database there, not on the disk."""
    for path in folder.rglob("*"):
        if path.is_file():
            with path.open("rb") as file:
                while file.read(BITE_BYTES):
                    pass


@dataclass(frozen=True)
class Asked:
    """How long the answers to one request took, those of a warm server."""

    wall_s: list[float]
    cpu_s: list[float]

    def __str__(self) -> str:
        return f"{p95_ms(self.wall_s):.0f} ({p95_ms(self.cpu_s):.0f})"


def p95_ms(times_s: Sequence[float]) -> float:
    """Return the time within which 95 of 100 were done."""
    return 1000 * statistics.quantiles(times_s, n=20)[-1]


class Server:
    """A web process that is asked, and what it and its database spend on it."""

    def __init__(self, address: str, web_pid: int, database_pid: int | None) -> None:
        self._address = address
        self._web_pid = web_pid
        self._database_pid = database_pid

    def ask(self, screen: Screen, made: Made, *, least: int, further: bool = False) -> Asked:
        """Ask for one screen again and again; for pages anywhere in the list where further ones are wanted."""
        dice, times, cursors = random.Random(7), Asked([], []), []
        with httpx.Client(base_url=self._address, headers=headers_for(screen.secret(made)), timeout=60) as client:
            for turn in range(WARM_UP + ASKS):
                if turn >= WARM_UP + least and sum(times.wall_s) > MAX_DURATION_S:
                    break
                address = screen.address(made).format(words=dice.choice(WORDS))
                if further and cursors:
                    address += f"{'&' if '?' in address else '?'}cursor={quote(dice.choice(cursors))}"
                spent, begun = cpu_now_s(self._web_pid, self._database_pid), time.perf_counter()
                answer = client.get(address)
                wall_s = time.perf_counter() - begun
                cpu_s = cpu_since_s(spent, self._web_pid, self._database_pid)
                if answer.status_code != httpx.codes.OK:
                    raise SystemExit(f"{address}: {answer.status_code} {answer.text[:300]}")
                if further and (following := answer.json().get("next")):
                    cursors.append(following)
                if turn >= WARM_UP:
                    times.wall_s.append(wall_s)
                    times.cpu_s.append(cpu_s)
        return times


def ask_all(server: Server, made: Sequence[Made], names: Iterable[str]) -> dict[str, list[Asked]]:
    """Return what screens took, by project, and print each as it is known."""
    measured: dict[str, list[Asked]] = {}
    for name in names:
        screen, least = SCREENS[name], LEAST if name in HELD else LEAST_OF_OTHERS
        for further in (False, True) if screen.paged else (False,):
            line = name + FURTHER * further
            measured[line] = [server.ask(screen, each, least=least, further=further) for each in made]
            print(f"{line:40} {'  '.join(f'{each!s:>11}' for each in measured[line])}", flush=True)
    return measured


def plans(place: Place, made: Made) -> tuple[dict[str, set[str]], dict[str, set[str]]]:
    """Return the large tables that screens read from one end to the other, and by which indexes they find the rest."""
    runtime, whole, found = place.runtime(), {}, {}
    browser = TestClient(create_app(runtime), base_url="http://127.0.0.1:8000")
    with runtime.database.reading() as session:
        large = {
            name
            for name, table in Base.metadata.tables.items()
            if len(session.execute(sa.select(sa.literal(1)).select_from(table).limit(LARGE_ROWS)).all()) == LARGE_ROWS
        }
    for name, screen in SCREENS.items():
        asking = sign_in(browser, runtime.settings, screen.secret(made))
        with heard(runtime.database.engine) as statements:
            asking.get(screen.address(made).format(words=WORDS[0])).raise_for_status()
        with runtime.database.engine.connect() as connection:
            if tables := set().union(*(whole_reads(connection, each, large) for each in statements)):
                whole[name] = tables
            found[name] = set().union(*(indexes_used(connection, each, large) for each in statements))
    runtime.close()
    return whole, found


def in_docs(name: str) -> bool:
    """Return whether docs/reference/benchmarks.md shows this row of the table."""
    return name in IN_DOCS


def policies_cost(place: Place, server: Server, made: Made) -> dict[str, tuple[float, float]]:
    """Return the median CPU seconds of each held screen with row policies and without, asked in turns."""
    runtime = place.runtime()
    spent: dict[str, tuple[list[float], list[float]]] = {name: ([], []) for name in HELD}
    for _ in range(TURNS):
        for network_of, verb in enumerate(("ENABLE", "DISABLE")):
            with runtime.database.writing() as session:
                for table in Base.metadata.sorted_tables:
                    if condition(table) is not None:
                        session.execute(sa.text(f"ALTER TABLE {table.name} {verb} ROW LEVEL SECURITY"))
            for name in HELD:
                spent[name][network_of].extend(server.ask(SCREENS[name], made, least=LEAST).cpu_s)
        measured = ", ".join(
            f"{name} {statistics.median(held) / statistics.median(free):.2f}" for name, (held, free) in spent.items()
        )
        print(f"with row policies, times as much CPU as without: {measured}", flush=True)
    with runtime.database.writing() as session:
        for table in Base.metadata.sorted_tables:
            if condition(table) is not None:
                session.execute(sa.text(f"ALTER TABLE {table.name} ENABLE ROW LEVEL SECURITY"))
    runtime.close()
    return {name: (statistics.median(held), statistics.median(free)) for name, (held, free) in spent.items()}


def main() -> None:
    """Fill, ask, and write down."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.scale", description=__doc__.partition("\n")[0])
    parser.add_argument("--quick", action="store_true", help="small sizes; nothing is written to docs")
    parser.add_argument("--postgresql", action="store_true", help="on a PostgreSQL server of its own; else on SQLite")
    parser.add_argument(
        "--docs", action="store_true", help="write the main rows and the picture into docs/reference/benchmarks.md"
    )
    parser.add_argument("--keep", type=Path, help="a folder to keep the data in, or to find it in")
    options = parser.parse_args()
    logs.configure()
    kind, size = ("PostgreSQL" if options.postgresql else "SQLite"), QUICK if options.quick else FULL
    with placed(options.keep, postgresql=options.postgresql) as (place, database):
        made = filled(place, size)
        into_memory(place.folder)
        whole, found = plans(place, made[-1])
        print("read from one end to the other:", whole or "no large table", flush=True)
        with place.serving() as (address, process):
            server = Server(address, process.pid, database.pid if database else None)
            measured = ask_all(server, made, HELD)
            cost = policies_cost(place, server, made[-1]) if database else {}
            measured |= ask_all(server, made, [name for name in SCREENS if name not in HELD])
    print(table(["screen", "indexes used"], [[name, ", ".join(sorted(found[name]))] for name in HELD]))
    head = ["p95, ms: wall (CPU)", *(f"{each.takes:,} takes, {each.cues:,} cues" for each in made)]
    print(table(head, [[name, *times] for name, times in measured.items()]))
    text = table(head[:1] + head[1::2], [[name, *times[::2]] for name, times in measured.items() if in_docs(name)])
    if cost:
        ratios = ", ".join(f"{name} {held / free:.2f}" for name, (held, free) in cost.items())
        text += f"\n\nCPU time with row policies, as a multiple of the time without: {ratios}."
    slow = [
        name
        for name, times in measured.items()
        if name.removesuffix(FURTHER) in HELD and p95_ms(times[-1].wall_s) > LIMIT_MS
    ]
    print(f"over {LIMIT_MS:.0f} ms of those that must not be: {', '.join(slow) or 'none'}")
    if not options.docs or options.quick:
        return
    load = ", ".join(f"{each:.1f}" for each in os.getloadavg())
    note = f"{kind}, {size.server:,} takes on the server; {machine()}; {clock.now():%-d %B %Y}, load {load} at the end."
    write_between(DOCS / "reference/benchmarks.md", f"screens {kind.lower()}", f"{note}\n\n{text}")
    draw_growth(
        DOCS / "pictures" / f"growth_{kind.lower()}.svg",
        title=f"CPU time of an answer, p95, {kind}",
        takes=[each.takes for each in made],
        times_ms={name: [p95_ms(each.cpu_s) for each in measured[name]] for name in HELD},
        limit_ms=LIMIT_MS,
    )


if __name__ == "__main__":
    main()
