"""How screens answer as projects and the server grow.

    python -m benchmarks.scale                      a project of 100,000 takes on a server of 1,000,000
    python -m benchmarks.scale --quick              a tenth of a hundredth of it, in a minute
    python -m benchmarks.scale --database postgresql://…   the same on PostgreSQL; the database must be empty

Figures are those of a client on the same machine, over HTTP, one request at a time: from the first byte sent to the
last byte of the answer. The tables and the picture go to docs/scale.md.
"""

import argparse
import random
import statistics
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import httpx

from benchmarks.bulk import filling
from benchmarks.served import Place, headers_for
from benchmarks.studios import Made, ProjectMaker, make_team, others
from benchmarks.tables import DOCS, machine, table, write_between

LIMIT_MS = 100.0
WARM_UP = 5
TYPED = ("laser", "door close", "SC-77", "water", "too bright", "wing_land", "zzz", "metal hull", "music", "step")


@dataclass(frozen=True)
class Size:
    """How much to make and how often to ask."""

    projects: tuple[int, ...]  # takes
    server: int  # takes in all
    asks: int


FULL = Size((1_000, 3_000, 10_000, 30_000, 100_000), 1_000_000, 200)
QUICK = Size((1_000, 3_000), 10_000, 40)
Ask = Callable[[httpx.Client, Made, random.Random], httpx.Response]


def _first_page(path: str) -> Ask:
    return lambda client, made, _dice: client.get(path.format(project=made.project_id))


def _any_page(path: str) -> Ask:
    """Ask for a page somewhere in the list: the cursor of a page that was answered before."""
    cursors: dict[str, list[str]] = {}

    def ask(client: httpx.Client, made: Made, dice: random.Random) -> httpx.Response:
        address = path.format(project=made.project_id)
        known = cursors.setdefault(address, [])
        answer = client.get(address, params={"cursor": dice.choice(known)} if known else {})
        if answer.status_code == httpx.codes.OK and (following := answer.json().get("next")):
            known.append(following)
        return answer

    return ask


def _find(client: httpx.Client, made: Made, dice: random.Random) -> httpx.Response:
    return client.get(f"/v1/projects/{made.project_id}/find", params={"q": dice.choice(TYPED)})


SCREENS: dict[str, Ask] = {
    "review queue, first page": _first_page("/v1/review-queue?project_id={project}"),
    "review queue, further pages": _any_page("/v1/review-queue?project_id={project}"),
    "review queue of all projects": _first_page("/v1/review-queue"),
    "sound list, first page": _first_page("/v1/projects/{project}/sound-list"),
    "sound list, further pages": _any_page("/v1/projects/{project}/sound-list"),
    "where its cues stand, first page": _first_page("/v1/projects/{project}/sound-list/standing"),
    "where its cues stand, further pages": _any_page("/v1/projects/{project}/sound-list/standing"),
    "search": _find,
}


def p95_ms(times_s: list[float]) -> float:
    """Return the time within which 95 of 100 answers came."""
    return 1000 * statistics.quantiles(times_s, n=20)[-1]


def ask_screens(address: str, made: Made, asks: int) -> dict[str, float]:
    """Return the p95 of every screen, in milliseconds."""
    dice, told = random.Random(7), {}
    with httpx.Client(base_url=address, headers=headers_for(made.decider_secret), timeout=60) as client:
        for name, ask in SCREENS.items():
            times = []
            for turn in range(WARM_UP + asks):
                begun = time.perf_counter()
                answer = ask(client, made, dice)
                taken = time.perf_counter() - begun
                if answer.status_code != httpx.codes.OK:
                    raise SystemExit(f"{name}: {answer.status_code} {answer.text[:300]}")
                if turn >= WARM_UP:
                    times.append(taken)
            told[name] = p95_ms(times)
    return told


def fill(place: Place, size: Size) -> list[Made]:
    """Make the projects that are measured and those of others around them."""
    runtime, begun = place.runtime(), time.monotonic()
    with filling(runtime.database) as bulk:
        made = [  # each in a studio of its own: a queue of all projects is then of that size
            ProjectMaker(bulk, make_team(bulk, f"Measured {takes}"), takes=takes, seed=takes).make()
            for takes in size.projects
        ]
        studios = {}
        for place_of, takes in others(size.server - sum(size.projects)):
            if place_of not in studios:
                studios[place_of] = make_team(bulk, f"Other {place_of}")
            ProjectMaker(bulk, studios[place_of], takes=takes, seed=takes + place_of).make()
    print(f"{bulk.written:,} rows in {time.monotonic() - begun:.0f} s", flush=True)
    runtime.close()
    return made


@contextmanager
def _folder(kept: Path | None) -> Iterator[Path]:
    if kept is not None:
        kept.mkdir(parents=True, exist_ok=True)
        yield kept
        return
    with tempfile.TemporaryDirectory(prefix="soundlist-scale-") as folder:
        yield Path(folder)


def main() -> None:
    """Make, ask, and write down."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.scale", description=__doc__.partition("\n")[0])
    parser.add_argument("--quick", action="store_true", help="small sizes; nothing is written to docs")
    parser.add_argument("--database", default="", help="an empty PostgreSQL database; SQLite if left out")
    parser.add_argument("--keep", type=Path, help="a folder to keep the data in")
    options = parser.parse_args()
    size = QUICK if options.quick else FULL
    with _folder(options.keep) as folder:
        place = Place(folder.resolve(), options.database)
        made = fill(place, size)
        with place.serving() as (address, _):
            told = [ask_screens(address, each, size.asks) for each in made]
    head = ["p95, ms", *(f"{each.takes:,} takes, {each.cues:,} cues" for each in made)]
    text = table(head, [[name, *(f"{one[name]:.0f}" for one in told)] for name in SCREENS])
    print(text)
    kind = "PostgreSQL" if options.database else "SQLite"
    if not options.quick:
        note = f"{kind}, {size.server:,} takes on the server, {machine()}."
        write_between(DOCS / "scale.md", f"screens {kind.lower()}", f"{note}\n\n{text}")
    slow = [name for name in SCREENS if told[-1][name] > LIMIT_MS]
    print(f"over {LIMIT_MS:.0f} ms: {', '.join(slow) or 'none'}")


if __name__ == "__main__":
    main()
