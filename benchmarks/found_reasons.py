"""How the page Reasons and the search for reasons answer in a list of 5,000 cues, on SQLite and on PostgreSQL.

python -m benchmarks.found_reasons        both databases, one after the other; about four minutes
… --docs                                  and write the table into docs/large-teams.md
"""

import argparse
import os

import httpx
import sqlalchemy as sa

from app import logs
from app.reviews.models import GivenReason
from benchmarks.bulk import analyse, bare, filling
from benchmarks.long_queue import places
from benchmarks.served import Place, headers_for
from benchmarks.studios import Made, ProjectMaker, make_team
from benchmarks.tables import DOCS, machine, table, write_between
from benchmarks.team_screens import ask

TAKES = 46_000  # for 5,000 cues
REASONS = "/v1/projects/{project}/reasons"
VERSIONS = REASONS + "/versions?kind=pick&reason=Cleanest"
FIND = "/v1/projects/{project}/find?q="
PAGES = {
    "reasons": REASONS,
    "reasons of a designer": REASONS + "?designer_id={designer}",
    "reasons of a category": REASONS + "?category=weapon",
    "versions with a reason": VERSIONS,
    "versions with a reason, of a designer": VERSIONS + "&designer_id={designer}",
    "versions with a reason, of a category": VERSIONS + "&category=weapon",
    "search for a reason": FIND + "too%20long",
    "search for a label": FIND + "layered",
    "search for what nothing has": FIND + "zzz",
    "search for a reason in all projects": "/v1/find?q=too%20long",
}
OF_DESIGNERS = {"a designer's own reasons": REASONS, "a designer's search for a reason": FIND + "too%20long"}
Times = dict[str, tuple[float, float, float]]


def fill(place: Place) -> tuple[Made, int]:
    """Make a project with reasons and labels; return it, and how many reasons were given."""
    runtime = place.runtime()
    with bare(runtime.database), filling(runtime.database) as bulk:
        made = ProjectMaker(bulk, make_team(bulk, "Found reasons"), takes=TAKES, seed=11).make()
    analyse(runtime.database)
    with runtime.database.reading() as session:
        given = select_given(session)
    runtime.close()
    return made, given


def select_given(session: sa.orm.Session) -> int:
    """Count the reasons that were given."""
    return session.scalar(sa.select(sa.func.count()).select_from(GivenReason)) or 0


def measure(place: Place, made: Made) -> Times:
    """Return the median, the 95th percentile and the CPU time of each page, in ms."""
    times = {}
    with place.serving() as (address, process):
        for secret, pages in ((made.approver_secret, PAGES), (made.designer_secret, OF_DESIGNERS)):
            with httpx.Client(base_url=address, headers=headers_for(secret), timeout=60) as client:
                designer = client.get(REASONS.format(project=made.project_id)).raise_for_status().json()["designers"]
                names = {"project": made.project_id, "designer": designer[0]["id"] if designer else None}
                for name, path in pages.items():
                    median, p95, cpu, size = ask(client, path.format(**names), process.pid)
                    print(f"{name:42} {median:6.0f} {p95:6.0f} {cpu:6.0f} ms {size:>9,} bytes", flush=True)
                    times[name] = (median, p95, cpu)
    return times


def main() -> None:
    """Fill, ask, and write down."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.found_reasons", description=__doc__.partition("\n")[0])
    parser.add_argument("--docs", action="store_true", help="write the table into docs/large-teams.md")
    options = parser.parse_args()
    logs.configure()
    times = {}
    with places() as by_name:
        for name, place in by_name.items():
            made, given = fill(place)
            times[name] = measure(place, made)
    head = ["ms", *(f"{name} {figure}" for name in times for figure in ("p50", "p95", "CPU"))]
    rows = [[page, *(f"{one:.0f}" for name in times for one in times[name][page])] for page in (*PAGES, *OF_DESIGNERS)]
    load = f"load {', '.join(f'{one:.1f}' for one in os.getloadavg())} at the end"
    about = f"One web process; {made.cues:,} cues, {made.takes:,} takes, {given:,} reasons given; {machine()}; {load}."
    text = f"{about}\n\n{table(head, rows)}"
    print(text)
    if options.docs:
        write_between(DOCS / "large-teams.md", "found reasons", text)


if __name__ == "__main__":
    main()
