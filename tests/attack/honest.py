"""An honest person at work while a server is attacked: `python -m tests.attack.honest`.

In a process of its own, so that what attackers compute in Python is not taken for the server's slowness. Reads one line
of JSON, works until its input ends, and writes a line of JSON for each visit.
"""

import json
import select
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import httpx

ROOT = Path(__file__).resolve().parents[2]
PAUSE_S = 0.05
GIVES_UP_S = 60.0
STARTS_WITHIN_S = 60.0


@dataclass(frozen=True)
class Visit:
    """One request, on the clock that all processes share."""

    path: str
    begun_s: float
    took_s: float
    problem: str = ""


@contextmanager
def honest_person(client: httpx.Client, pages: list[str], comments: str, notes: Path) -> Iterator[None]:
    """Let a signed-in person read pages and write comments as long as the block lasts; see `visits`."""
    reported = {
        "base_url": str(client.base_url),
        "cookies": dict(client.cookies),
        "headers": dict(client.headers),
        "pages": pages,
        "comments": comments,
    }
    with (
        notes.open("w") as output,
        subprocess.Popen(
            [sys.executable, "-m", __name__], cwd=ROOT, stdin=subprocess.PIPE, stdout=output, text=True
        ) as process,
    ):
        assert process.stdin is not None
        process.stdin.write(json.dumps(reported) + "\n")
        process.stdin.flush()
        deadline = time.monotonic() + STARTS_WITHIN_S
        while not visits(notes) and time.monotonic() < deadline:
            time.sleep(0.05)
        yield
        process.stdin.close()


def visits(notes: Path) -> list[Visit]:
    """Return the visits that a person wrote down."""
    lines = notes.read_text().splitlines(keepends=True)
    return [Visit(**json.loads(line)) for line in lines if line.endswith("\n")]


def work(reported: dict[str, Any]) -> None:
    """Visit one page after the other until the input ends; every fifth visit is a comment."""
    number = 0
    with httpx.Client(
        base_url=reported["base_url"], cookies=reported["cookies"], headers=reported["headers"], timeout=GIVES_UP_S
    ) as client:
        while not select.select([sys.stdin], [], [], PAUSE_S)[0]:
            path, problem = reported["pages"][number % len(reported["pages"])], ""
            begun_s = time.monotonic()
            try:
                if number % 5 == 4:
                    path = reported["comments"]
                    answer = client.post(path, json={"text": f"Comment {number}", "start_s": 0.1})
                else:
                    answer = client.get(path)
                if answer.status_code >= 400:
                    problem = f"was answered with {answer.status_code}"
            except httpx.TransportError as error:
                problem = f"was not answered: {type(error).__name__}"
            visit = Visit(path, begun_s, time.monotonic() - begun_s, problem)
            sys.stdout.write(json.dumps(asdict(visit)) + "\n")
            sys.stdout.flush()
            number += 1


if __name__ == "__main__":
    work(json.loads(sys.stdin.readline()))
