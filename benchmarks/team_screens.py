"""How the screens of brief, list, references, hiring and voice lines answer in a large project, on SQLite.

python -m benchmarks.team_screens                 5,000 cues, 500 people on the roster; about three minutes
python -m benchmarks.team_screens --keep DIR      what was filled once in a folder is asked again
… --docs                                          and write the table into docs/reference/benchmarks.md
"""

import argparse
import json
import os
import statistics
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import date, timedelta
from pathlib import Path
from typing import Any

import httpx

from app import logs
from app.accounts.models import Membership, Person
from app.accounts.rules import Role
from app.core import clock
from app.core.db import new_id
from app.hiring.models import Bid, BusyRange, Candidate, Posting, RosterEntry, Score
from app.hiring.rules import DEFAULT_HEADINGS, AskedScope, BidState, PostingPhase, PostingState
from app.references.models import Reference, ReferenceOpening, ReferenceVersion
from app.references.rules import PreviewState, ReferenceKind
from benchmarks.bulk import Bulk, bare, filling
from benchmarks.served import Place, cpu_now_s, cpu_since_s, headers_for
from benchmarks.studios import CATEGORIES, Made, ProjectMaker, Team, make_team
from benchmarks.tables import DOCS, machine, table, write_between

TAKES = 40_000  # for 5,000 cues
ROSTER, BIDS, REFERENCES, LINES, OPENINGS = 500, 12, 500, 500, 5_000
TEAM_SIZE = 500 - 6  # people of the studio besides those that make_team adds
FILLED = "team_screens.json"
SHOWN = 3  # the slowest, in the docs
WARM_UP, ASKS = 3, 40
DAYS = timedelta(days=90)
SCREENS = {
    "brief": "/v1/projects/{project}/brief",
    "coverage of the brief": "/v1/projects/{project}/sound-list/coverage",
    "sound list": "/v1/projects/{project}/sound-list",
    "sound list, a page of 500": "/v1/projects/{project}/sound-list?limit=500",
    "clarity": "/v1/projects/{project}/clarity",
    "people of cues": "/v1/projects/{project}/cue-people",
    "category of a new cue": "/v1/projects/{project}/category-guess?name=door%20slam",
    "references board": "/v1/projects/{project}/references",
    "references of a cue": "/v1/projects/{project}/references?cue_id={cue}",
    "who opened references": "/v1/projects/{project}/reference-openings",
    "roster": "/v1/studios/{studio}/roster",
    "roster, by words": "/v1/studios/{studio}/roster?q=creature",
    "roster, by free days": "/v1/studios/{studio}/roster?free_from={from_on}&free_to={to_on}",
    "a designer on the roster": "/v1/roster/{entry}",
    "a designer's work here": "/v1/roster/{entry}/work",
    "postings": "/v1/projects/{project}/postings",
    "a posting": "/v1/postings/{posting}",
    "comparison of bids": "/v1/postings/{posting}/bids",
    "voice lines": "/v1/projects/{project}/voice-lines?language=en",
    "pick-ups": "/v1/projects/{project}/pick-ups?language=en",
    "hours": "/v1/projects/{project}/hours",
}


def fill(place: Place) -> dict[str, str]:
    """Make a project with everything that these screens show; return the names in their addresses."""
    runtime = place.runtime()
    today = clock.now().date()
    with bare(runtime.database), filling(runtime.database) as bulk:
        team = make_team(bulk, "Team screens")
        made = ProjectMaker(bulk, team, takes=TAKES, seed=5).make()
        people = _add_people(bulk, team)
        entries = [_add_entry(bulk, team, at, today) for at in range(ROSTER)]
        posting = _add_posting(bulk, team, made, today)
        _add_bids(bulk, team, made, posting, people, today)
        _add_references(bulk, team, made, people)
    runtime.close()
    return {
        "project": str(made.project_id), "studio": str(made.studio_id), "secret": made.producer_secret,
        "entry": str(entries[0]), "posting": str(posting), "cues": str(made.cues),
        "from_on": today.isoformat(), "to_on": (today + DAYS).isoformat(),
    }  # fmt: skip


def _add_people(bulk: Bulk, team: Team) -> list[Any]:
    people = []
    for at in range(TEAM_SIZE):
        person_id = new_id()
        bulk.add(Person, id=person_id, email=f"{person_id}@team.example", name=f"Person {at}")
        if at >= BIDS:  # those who bid are not members
            bulk.add(Membership, studio_id=team.studio_id, person_id=person_id, roles=[Role.REVIEWER])
        people.append(person_id)
    return people


def _add_entry(bulk: Bulk, team: Team, at: int, today: date) -> Any:
    entry_id = new_id()
    bulk.add(
        RosterEntry, id=entry_id, studio_id=team.studio_id, name=f"Designer {at}", email=f"designer{at}@roster.example",
        specialities=[CATEGORIES[at % len(CATEGORIES)], CATEGORIES[(at + 3) % len(CATEGORIES)]], services=[],
        languages=["en", "de"], credits="Three games in space, one on a farm", links=[], weekly_hours=30,
        added_by=team.producer_id,
    )  # fmt: skip
    for place in range(6):
        begins = today + timedelta(days=20 * place + at % 20)
        bulk.add(BusyRange, studio_id=team.studio_id, entry_id=entry_id, from_on=begins, to_on=begins + timedelta(9))
    return entry_id


def _add_posting(bulk: Bulk, team: Team, made: Made, today: date) -> Any:
    posting_id = new_id()
    lines = [{"key": one, "label": one, "cues": made.cues // len(CATEGORIES), "files": 9} for one in CATEGORIES]
    bulk.add(
        Posting, id=posting_id, studio_id=team.studio_id, project_id=made.project_id, title="All sounds",
        phase=PostingPhase.PRODUCTION, state=PostingState.OPEN, currency="USD", budget_minor=9_000_000,
        scope=AskedScope.ALL, categories=[], cue_ids=[], lines=lines, headings=list(DEFAULT_HEADINGS),
        work_from_on=today, work_to_on=today + DAYS, created_by=team.producer_id,
    )  # fmt: skip
    return posting_id


def _add_bids(bulk: Bulk, team: Team, made: Made, posting_id: Any, people: list[Any], today: date) -> None:
    tenant = {"studio_id": team.studio_id, "project_id": made.project_id}
    for at, person_id in enumerate(people[:BIDS]):
        lines = [
            {"key": one, "kind": "asked", "unit": "per_cue", "quantity_hundredths": 100, "price_minor": 9_000 + at}
            for one in CATEGORIES
        ]
        dates = {"from_on": today.isoformat(), "to_on": (today + DAYS).isoformat()}
        content = {"lines": lines, "hours_hundredths": 16_000, "note": "", **dates}
        bid_id = new_id()
        bulk.add(Candidate, **tenant, posting_id=posting_id, email=f"{person_id}@team.example", person_id=person_id,
                 expires_at=clock.now() + DAYS, joined_at=clock.now())  # fmt: skip
        bulk.add(Bid, id=bid_id, **tenant, posting_id=posting_id, designer_id=person_id, state=BidState.SENT,
                 content=content, sent=content, sent_at=clock.now())  # fmt: skip
        for scorer in (team.producer_id, team.approver_id, *people[BIDS : BIDS + 8]):
            scores = dict.fromkeys(DEFAULT_HEADINGS, 1 + at % 5)
            bulk.add(Score, bid_id=bid_id, person_id=scorer, **tenant, scores=scores)


def _add_references(bulk: Bulk, team: Team, made: Made, people: list[Any]) -> None:
    """Add references to the project, and openings of them."""
    tenant = {"studio_id": team.studio_id, "project_id": made.project_id}
    versions = []
    for at in range(REFERENCES):
        reference_id, version_id = new_id(), new_id()
        bulk.add(Reference, id=reference_id, **tenant, category=CATEGORIES[at % len(CATEGORIES)] if at % 3 else None,
                 caption=f"Like this {at}", terms="", newest_number=1, added_by=team.producer_id)  # fmt: skip
        bulk.add(ReferenceVersion, id=version_id, **tenant, reference_id=reference_id, number=1,
                 kind=ReferenceKind.LINK, media_type="text/uri-list", file_name="example.test",
                 url=f"https://example.test/{at}", excerpt="", preview=PreviewState.NONE,
                 added_by=team.producer_id)  # fmt: skip
        versions.append(version_id)
    for at in range(OPENINGS):
        bulk.add(ReferenceOpening, **tenant, version_id=versions[at % REFERENCES], person_id=people[at % len(people)])


def complete(address: str, names: dict[str, str]) -> None:
    """Add a script in two languages by a request, and the id of a cue to what addresses name."""
    with _client(address, names) as client:
        project = f"/v1/projects/{names['project']}"
        rows = [
            f"line_{at:04}\tCaptain\tHold the line, number {at}.\tHalte die Linie, Nummer {at}." for at in range(LINES)
        ]
        body = {"format": "paste", "text": "\n".join(["id\tcharacter\ten\tde", *rows]), "dry_run": False}
        client.post(f"{project}/voice-lines/import", json=body).raise_for_status()
        names["cue"] = client.get(f"{project}/sound-list").raise_for_status().json()["cues"][0]["id"]


@contextmanager
def _client(address: str, names: dict[str, str]) -> Iterator[httpx.Client]:
    with httpx.Client(base_url=address, headers=headers_for(names["secret"]), timeout=60) as client:
        yield client


def ask(client: httpx.Client, path: str, web_pid: int) -> tuple[float, float, float, int]:
    """Return the median and the 95th percentile of an answer and the web process's CPU time, in ms, and its bytes."""
    taken = []
    for at in range(WARM_UP + ASKS):
        if at == WARM_UP:
            spent = cpu_now_s(web_pid, None)
        begun = time.perf_counter()
        answer = client.get(path).raise_for_status()
        if at >= WARM_UP:
            taken.append(1000 * (time.perf_counter() - begun))
    cpu_ms = 1000 * cpu_since_s(spent, web_pid, None) / ASKS
    return statistics.median(taken), statistics.quantiles(taken, n=20)[-1], cpu_ms, len(answer.content)


def main() -> None:
    """Fill, ask, and write down."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.team_screens", description=__doc__.partition("\n")[0])
    parser.add_argument("--docs", action="store_true", help="write the table into docs/reference/benchmarks.md")
    parser.add_argument("--keep", type=Path, help="a folder to keep the data in, or to find it in")
    options = parser.parse_args()
    logs.configure()
    with tempfile.TemporaryDirectory(prefix="soundlist-team-") as scratch:
        place = Place((options.keep or Path(scratch)).resolve())
        place.folder.mkdir(parents=True, exist_ok=True)
        kept = place.folder / FILLED
        is_new = not kept.exists()
        names = fill(place) if is_new else json.loads(kept.read_text())
        with place.serving() as (address, process):
            if is_new:
                complete(address, names)
                kept.write_text(json.dumps(names))
            rows = []
            with _client(address, names) as client:
                for name, path in SCREENS.items():
                    median, p95, cpu, size = ask(client, path.format(**names), process.pid)
                    rows.append([name, *(f"{one:.0f}" for one in (median, p95, cpu, size / 1000))])
                    print(f"{name:32} {median:6.0f} {p95:6.0f} {cpu:6.0f} ms {size:>9,} bytes", flush=True)
    head = ["ms", "p50", "p95", "CPU", "kB"]
    load = f"load {', '.join(f'{one:.1f}' for one in os.getloadavg())} at the end"
    cues = int(names["cues"]) + 2 * LINES  # a cue for each line and language
    about = f"SQLite, one web process; {cues:,} cues, {TAKES:,} takes; {machine()}; {load}."
    text = f"{about}\n\n{table(head, rows)}"
    print(text)
    if options.docs:
        slowest = sorted(rows, key=lambda row: -float(row[2]))[:SHOWN]
        text = f"{about}\n\n{table(['ms, the slowest three', 'p95', 'CPU'], [[row[0], *row[2:4]] for row in slowest])}"
        write_between(DOCS / "reference/benchmarks.md", "team screens", text)


if __name__ == "__main__":
    main()
