"""Adopts a folder of generated sounds on a real server with one worker: time and CPU of each part.

python -m benchmarks.adopting --files 5000
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import httpx
import numpy as np
import soundfile

from app.accounts.rules import Scope
from app.projects.tokens import issue_token
from benchmarks.bulk import filling
from benchmarks.served import Place, cpu_seconds, headers_for
from benchmarks.studios import Made, ProjectMaker, make_team

RATE_HZ = 44_100
LENGTH_S = (0.1, 0.9)  # of a sound, evenly spread
FOLDERS = 40
CODED_SHARE = 5  # every fifth file is Ogg Vorbis
SPEC = """\
format = 1
[accept]
containers = ["wav", "ogg"]
[limits]
true_peak_dbtp = 0.0
[targets.game]
sample_rate_hz = 44100
bit_depth = 16
keep_coded = true
"""
POLL_S = 2.0
PATIENCE_S = 3_600.0


def main() -> None:
    """Adopt, and print a table."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.adopting", description=__doc__.partition("\n")[0])
    parser.add_argument("--files", type=int, default=500)
    options = parser.parse_args()
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="soundlist-adopting-"))).resolve()
        write_sounds(folder / "game", options.files)
        place = Place(folder)
        made, token = fill(place)
        address, web = stack.enter_context(place.serving())
        worker = stack.enter_context(place.running("worker", name="worker"))
        client = stack.enter_context(
            httpx.Client(base_url=address, headers=headers_for(made.producer_secret), timeout=300)
        )
        pids = {"web": web.pid, "worker": worker.pid}
        project = f"/v1/projects/{made.project_id}"
        spec = client.get(f"{project}/spec").json()
        body = {"toml": SPEC, "based_on_version": spec["version"]}
        client.put(f"{project}/spec", json=body).raise_for_status()
        print("| part | wall s | CPU s: client | web | worker |\n|---|---|---|---|---|")
        with measured("read and sent by `soundlist adopt`", pids):
            command = [sys.executable, "-m", "app.client.commands", "adopt", str(folder / "game"), "--server", address]
            environment = os.environ | {"SOUNDLIST_TOKEN": token}
            command += ["--project", str(made.project_id)]
            sent = subprocess.run(command, env=environment, check=True, capture_output=True, text=True)
        adoption_id = sent.stdout.strip().rpartition("adoption=")[2]
        with measured("adopted", pids):
            client.post(f"/v1/adoptions/{adoption_id}/adopt").raise_for_status()
        with measured("checked, drawn and rendered", pids):
            wait_until_rendered(client, adoption_id)
        with measured("undone", pids):
            client.post(f"/v1/adoptions/{adoption_id}/undo").raise_for_status()
    print(f"{options.files} files; load average {os.getloadavg()[0]:.1f}")


def fill(place: Place) -> tuple[Made, str]:
    """Make a project and a token that may send to it."""
    runtime = place.runtime()
    with filling(runtime.database) as bulk:
        made = ProjectMaker(bulk, make_team(bulk, "Adopting"), takes=1, seed=1).make()
    with runtime.database.writing() as session:
        token = issue_token(session, made.project_id, name="adopting", scopes=[Scope.DELIVERIES_WRITE])
    runtime.close()
    return made, token


def write_sounds(root: Path, count: int) -> None:
    """Write fading noises of different lengths, none like another."""
    dice = np.random.default_rng(1)
    for number in range(count):
        folder = root / f"kind{number % FOLDERS:02}"
        folder.mkdir(parents=True, exist_ok=True)
        frames = round(dice.uniform(*LENGTH_S) * RATE_HZ)
        samples = dice.normal(0, 0.05, (frames, 1)) * np.linspace(1, 0, frames)[:, None]
        ending = "ogg" if number % CODED_SHARE == 0 else "wav"
        soundfile.write(folder / f"sound{number:05}.{ending}", samples, RATE_HZ)


def wait_until_rendered(client: httpx.Client, adoption_id: str) -> None:
    """Return once each adopted sound has its check and its game file."""
    deadline = time.monotonic() + PATIENCE_S
    while time.monotonic() < deadline:
        found = client.get(f"/v1/adoptions/{adoption_id}").json()
        if found["rendered"] == found["takes"]:
            return
        time.sleep(POLL_S)
    raise SystemExit("the worker did not get through in time")


@contextmanager
def measured(part: str, pids: dict[str, int]) -> Iterator[None]:
    """Print the time of a block, and the CPU time of the client and of each process of the server."""
    own, before, began = os.times(), {name: cpu_seconds(pid) for name, pid in pids.items()}, time.monotonic()
    yield
    now, wall_s = os.times(), time.monotonic() - began
    client_s = now.children_user + now.children_system - own.children_user - own.children_system
    spent = [f"{cpu_seconds(pid) - before[name]:.0f}" for name, pid in pids.items()]
    print(f"| {part} | {wall_s:.0f} | {client_s:.0f} | " + " | ".join(spent) + " |", flush=True)


if __name__ == "__main__":
    main()
