"""How the review queue answers where 5,000 versions wait, on SQLite and on PostgreSQL.

python -m benchmarks.long_queue           both databases, one after the other; about three minutes
… --docs                                  and write the table into docs/large-teams.md
"""

import argparse
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import quote

import httpx
import sqlalchemy as sa

from app import logs
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from benchmarks.bulk import analyse, bare, filling
from benchmarks.served import Place, headers_for
from benchmarks.studios import Made, ProjectMaker, make_team
from benchmarks.tables import DOCS, machine, table, write_between
from benchmarks.team_screens import ask
from tests.support.postgres import running_postgres

TAKES = 20_000  # of which a quarter waits
QUEUE = "/v1/review-queue?project_id={project}&own=true"
COUNT = "/v1/review-queue/count?project_id={project}&own=true"
PAGES = {
    "review queue, urgent cues first": QUEUE,
    "the page after the urgent ones": QUEUE + "&cursor={cursor}",
    "review queue of all projects": "/v1/review-queue?own=true",
    "how many wait": COUNT,
    "review queue, not heard": QUEUE + "&unheard=true",
    "review queue, by words that nothing has": QUEUE + "&q=zzz",
    "how many wait, by words that nothing has": COUNT + "&q=zzz",
    "next steps": "/v1/projects/{project}/next-steps",
}


def fill(place: Place) -> tuple[Made, int]:
    """Make a project in which the newest version of every cue waits; return it, and how many versions wait."""
    runtime = place.runtime()
    with bare(runtime.database), filling(runtime.database) as bulk:
        team = make_team(bulk, "Long queue")
        made = ProjectMaker(bulk, team, takes=TAKES, seed=7, newest=((TakeState.CONFORMING, 1),)).make()
    analyse(runtime.database)
    with runtime.database.reading() as session:
        waiting = select_waiting(session)
    runtime.close()
    return made, waiting


def select_waiting(session: sa.orm.Session) -> int:
    """Count the takes that wait for review."""
    return session.scalar(sa.select(sa.func.count()).where(Take.state == TakeState.CONFORMING)) or 0


@contextmanager
def places() -> Iterator[dict[str, Place]]:
    """Give a folder with SQLite, and one with a database on a PostgreSQL server of its own."""
    with tempfile.TemporaryDirectory(prefix="soundlist-queue-") as scratch, running_postgres(durable=True) as server:
        folders = {name: Path(scratch) / name for name in ("SQLite", "PostgreSQL")}
        for folder in folders.values():
            folder.mkdir()
        yield {
            "SQLite": Place(folders["SQLite"]),
            "PostgreSQL": Place(folders["PostgreSQL"], server.new_database("queue")),
        }


def measure(place: Place, made: Made) -> dict[str, tuple[float, float, float]]:
    """Return the median, the 95th percentile and the CPU time of each page, in ms."""
    times = {}
    with (
        place.serving() as (address, process),
        httpx.Client(base_url=address, headers=headers_for(made.approver_secret), timeout=60) as client,
    ):
        first = client.get(QUEUE.format(project=made.project_id)).raise_for_status().json()
        for name, path in PAGES.items():
            asked = path.format(project=made.project_id, cursor=quote(first["next"]))
            median, p95, cpu, size = ask(client, asked, process.pid)
            print(f"{name:42} {median:6.0f} {p95:6.0f} {cpu:6.0f} ms {size:>9,} bytes", flush=True)
            times[name] = (median, p95, cpu)
    return times


def main() -> None:
    """Fill, ask, and write down."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.long_queue", description=__doc__.partition("\n")[0])
    parser.add_argument("--docs", action="store_true", help="write the table into docs/large-teams.md")
    options = parser.parse_args()
    logs.configure()
    times = {}
    with places() as by_name:
        for name, place in by_name.items():
            made, waiting = fill(place)
            times[name] = measure(place, made)
    head = ["ms", *(f"{name} {figure}" for name in times for figure in ("p50", "p95", "CPU"))]
    rows = [[page, *(f"{one:.0f}" for name in times for one in times[name][page])] for page in PAGES]
    load = f"load {', '.join(f'{one:.1f}' for one in os.getloadavg())} at the end"
    about = f"One web process; {waiting:,} versions of {made.waiting_cues:,} cues wait; {machine()}; {load}."
    text = f"{about}\n\n{table(head, rows)}"
    print(text)
    if options.docs:
        write_between(DOCS / "large-teams.md", "long queue", text)


if __name__ == "__main__":
    main()
