"""How the review queue answers where 5,000 versions wait, on SQLite and on PostgreSQL.

python -m benchmarks.long_queue           both databases, one after the other; about three minutes
… --docs                                  and write the table into docs/reference/benchmarks.md
"""

from urllib.parse import quote

import httpx
import sqlalchemy as sa

from app import logs
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from benchmarks.both_databases import Times, options_of, places, times_of, write_down
from benchmarks.bulk import analyse, bare, filling
from benchmarks.served import Place, headers_for
from benchmarks.studios import Made, ProjectMaker, make_team

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


def measure(place: Place, made: Made) -> Times:
    """Return how each page answers."""
    with (
        place.serving() as (address, process),
        httpx.Client(base_url=address, headers=headers_for(made.approver_secret), timeout=60) as client,
    ):
        first = client.get(QUEUE.format(project=made.project_id)).raise_for_status().json()
        cursor = quote(first["next"])
        paths = {name: path.format(project=made.project_id, cursor=cursor) for name, path in PAGES.items()}
        return times_of(client, paths, process.pid)


def main() -> None:
    """Fill, ask, and write down."""
    options = options_of("benchmarks.long_queue", __doc__)
    logs.configure()
    times = {}
    with places() as by_name:
        for name, place in by_name.items():
            made, waiting = fill(place)
            times[name] = measure(place, made)
    about = f"{waiting:,} versions of {made.waiting_cues:,} cues wait"
    write_down(times, about, "long queue", in_docs=options.docs)


if __name__ == "__main__":
    main()
