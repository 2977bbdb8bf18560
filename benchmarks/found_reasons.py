"""How the page Reasons and the search for reasons answer in a list of 5,000 cues, on SQLite and on PostgreSQL.

python -m benchmarks.found_reasons        both databases, one after the other; about four minutes
… --docs                                  and write the table into docs/reference/benchmarks.md
"""

import httpx
import sqlalchemy as sa

from app import logs
from app.reviews.models import GivenReason
from benchmarks.both_databases import Times, options_of, places, times_of, write_down
from benchmarks.bulk import analyse, bare, filling
from benchmarks.served import Place, headers_for
from benchmarks.studios import Made, ProjectMaker, make_team

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
    """Return how each page answers, to the approver and to a designer."""
    times: Times = {}
    with place.serving() as (address, process):
        for secret, pages in ((made.approver_secret, PAGES), (made.designer_secret, OF_DESIGNERS)):
            with httpx.Client(base_url=address, headers=headers_for(secret), timeout=60) as client:
                designer = client.get(REASONS.format(project=made.project_id)).raise_for_status().json()["designers"]
                names = {"project": made.project_id, "designer": designer[0]["id"] if designer else None}
                times |= times_of(client, {name: path.format(**names) for name, path in pages.items()}, process.pid)
    return times


def main() -> None:
    """Fill, ask, and write down."""
    options = options_of("benchmarks.found_reasons", __doc__)
    logs.configure()
    times = {}
    with places() as by_name:
        for name, place in by_name.items():
            made, given = fill(place)
            times[name] = measure(place, made)
    about = f"{made.cues:,} cues, {made.takes:,} takes, {given:,} reasons given"
    write_down(times, about, "found reasons", in_docs=options.docs)


if __name__ == "__main__":
    main()
