"""How pages answer on SQLite and on PostgreSQL: where each is served, the times of its pages, the table of both."""

import argparse
import os
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

import httpx

from benchmarks.served import Place
from benchmarks.tables import DOCS, machine, table, write_between
from benchmarks.team_screens import SHOWN, ask
from tests.support.postgres import running_postgres

Times = dict[str, tuple[float, float, float]]
"""By page: the median, the 95th percentile and the CPU time of an answer, in ms."""


def options_of(module: str, purpose: str) -> argparse.Namespace:
    """Read the options of a benchmark: whether its table goes into the docs."""
    parser = argparse.ArgumentParser(prog=f"python -m {module}", description=purpose.partition("\n")[0])
    parser.add_argument("--docs", action="store_true", help="write the table into docs/reference/benchmarks.md")
    return parser.parse_args()


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


def times_of(client: httpx.Client, paths: Mapping[str, str], web_pid: int) -> Times:
    """Ask for each page, by its name, and print how it answered."""
    times = {}
    for name, path in paths.items():
        median, p95, cpu, size = ask(client, path, web_pid)
        print(f"{name:42} {median:6.0f} {p95:6.0f} {cpu:6.0f} ms {size:>9,} bytes", flush=True)
        times[name] = (median, p95, cpu)
    return times


def write_down(times: Mapping[str, Times], about: str, section: str, *, in_docs: bool) -> None:
    """Print the table of both databases, and write it into its section of docs/reference/benchmarks.md where wanted."""
    head = ["ms", *(f"{database} {figure}" for database in times for figure in ("p50", "p95", "CPU"))]
    pages = next(iter(times.values()))
    rows = [[page, *(f"{ms:.0f}" for by_page in times.values() for ms in by_page[page])] for page in pages]
    load = f"load {', '.join(f'{one:.1f}' for one in os.getloadavg())} at the end"
    text = f"One web process; {about}; {machine()}; {load}.\n\n{table(head, rows)}"
    print(text)
    if in_docs:
        slowest = sorted(pages, key=lambda page: -max(by_page[page][1] for by_page in times.values()))[:SHOWN]
        head = ["ms, the slowest three", *(f"{database} {figure}" for database in times for figure in ("p95", "CPU"))]
        rows = [[page, *(f"{ms:.0f}" for by_page in times.values() for ms in by_page[page][1:])] for page in slowest]
        text = f"One web process; {about}; {machine()}; {load}.\n\n{table(head, rows)}"
        write_between(DOCS / "reference/benchmarks.md", section, text)
