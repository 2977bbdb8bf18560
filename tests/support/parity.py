"""The same sounds by the same specs, judged by the server, the command line and Python: what each says of them."""

from __future__ import annotations

import json
import sqlite3
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from uuid import UUID

import httpx

import audio_checks
from app.accounts.authentication import CSRF_HEADER
from tests.support.any_sound import any_sound
from tests.support.deliver import deliver, open_delivery
from tests.support.listening import listening
from tests.support.server import RunningServer, World

ALONE = """
[checks]
duplicate = "off"      # over several files together: the server says so of a delivery, not of a take
variation-set = "off"
reverb-set = "off"
"""
SPECS = {
    "44k1": audio_checks.new_spec("44k1").replace("[checks]", ALONE.strip()),
    "48k": audio_checks.new_spec("48k").replace("[checks]", ALONE.strip()),
    "everything": f"""
format = 1
name = "everything"
[accept]
containers = ["wav"]
encodings = ["pcm", "float"]
sample_rates_hz = "any"
bit_depths = "any"
channels = "any"
duration_s = {{ min = 0.01, max = 15.0 }}
[limits]
sample_peak_dbfs = -0.1
true_peak_dbtp = -1.0
dc_offset_percent = 1.0
silence_below_dbfs = -90.0
head_silence_ms = 5
tail_silence_ms = 100
mono_loss_db = 6.0
loudness_lufs = {{ min = -40.0, max = -10.0 }}
noise_floor_dbfs = -60.0
[engine]
adds = ["reverb"]
{ALONE}
baked-reverb = "error"
reversed = "error"
upsampled = "error"
lossy = "error"
click = "error"
dropout = "error"
clipping = "error"
hum = "error"
""",
    "nothing": f'format = 1\nname = "nothing"\n{ALONE}',
    "peaks": f'format = 1\nname = "peaks"\n[limits]\nsample_peak_dbfs = -6.0\ntrue_peak_dbtp = -6.0\n{ALONE}',
    "reverb": f'format = 1\nname = "reverb"\n[engine]\nadds = ["reverb"]\n{ALONE}\nreversed = "warning"\n',
}
PROOF = ("code", "severity", "measured", "limit", "unit", "start_s", "end_s", "message", "fix")
Said = dict[str, dict[str, Any]]  # by file name


def write_sounds(folder: Path, seeds: Sequence[int], *, longest_s: float) -> list[Path]:
    """Write the sounds of some seeds into a folder."""
    folder.mkdir(exist_ok=True)
    paths = [folder / f"sound_{seed}.wav" for seed in seeds]
    for path, seed in zip(paths, seeds, strict=True):
        path.write_bytes(any_sound(seed, longest_s=longest_s).content)
    return paths


def said_by_python(paths: Sequence[Path], toml: str) -> Said:
    """Return what `check_files` says."""
    report = audio_checks.check_files(paths, audio_checks.parse_spec(toml))
    return {Path(entry.path).name: _said(json.loads(json.dumps(entry.to_dict()))) for entry in report.files}


def said_by_command(folder: Path, toml: str, *arguments: str) -> Said:
    """Return what `audio-checks check` says of the files of a folder."""
    spec, report = folder.with_name("spec.toml"), folder.with_name("report.json")
    spec.write_text(toml, encoding="utf-8")
    command = [sys.executable, "-P", "-m", "audio_checks.cli", "check", "--spec", str(spec), *arguments]
    done = subprocess.run([*command, "--format", f"json:{report}", str(folder)], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        raise AssertionError(done.stderr)
    entries = json.loads(report.read_text(encoding="utf-8"))["files"]
    return {Path(entry["path"]).name: _said(entry) for entry in entries}


def remembered(cache: Path) -> int:
    """Return how many verdicts a cache holds."""
    with sqlite3.connect(cache / "verdicts.sqlite") as database:
        (count,) = database.execute("SELECT count(*) FROM verdicts").fetchone()
    return int(count)


class WorldOverTcp(World):
    """People whose requests go to a port, as those of browsers and scripts do."""

    def __init__(self, server: RunningServer, address: str) -> None:
        super().__init__(server)
        self._address = address

    def signed_in(self, person_id: UUID) -> httpx.Client:
        """Return a client that is signed in as this person."""
        browser = super().signed_in(person_id)
        headers = {CSRF_HEADER: browser.headers[CSRF_HEADER]}
        return httpx.Client(base_url=self._address, cookies=dict(browser.cookies), headers=headers, timeout=300)


@contextmanager
def world_over_tcp(server: RunningServer) -> Iterator[World]:
    """Listen on a port, and yield a studio whose people ask there."""
    with listening(server.application, lifespan="off") as port:
        yield WorldOverTcp(server, f"http://127.0.0.1:{port}")


class Server:
    """Takes of all sounds on a server, checked again by each spec that is saved."""

    def __init__(self, world: World, paths: Sequence[Path]) -> None:
        self._world = world
        delivery_id = open_delivery(world)
        self._takes = {
            path.name: str(deliver(world, path.name, path.read_bytes(), delivery_id=delivery_id)["id"])
            for path in paths
        }
        world.server.wait_for_jobs(3600)

    def said(self, toml: str) -> Said:
        """Return what the server says by a spec."""
        path = f"/v1/projects/{self._world.project_id}/spec"
        now = self._world.producer.get(path).json()
        body = {"toml": toml, "note": "", "based_on_version": now["version"]}
        saved = self._world.producer.put(path, json=body)
        if saved.status_code != 200:
            raise AssertionError(saved.text)
        self._world.server.wait_for_jobs(3600)
        said = {}
        for name, take_id in self._takes.items():
            answer = self._world.designer.get(f"/v1/takes/{take_id}/check")
            if answer.status_code != 200 or not answer.json()["is_newest_spec"]:
                raise AssertionError(f"{name} is not checked by this spec: {answer.text[:300]}")
            said[name] = _said(answer.json())
        return said


def _said(entry: Mapping[str, Any]) -> dict[str, Any]:
    return {
        "verdict": entry["verdict"],
        "findings": [{key: finding[key] for key in PROOF} for finding in entry["findings"]],
        "facts": entry["facts"],
        "measurements": entry["measurements"],
        "judgements": entry["judgements"],
    }


def differences(one: Said, other: Said) -> Iterator[str]:
    """Yield where two say different things of a file; a figure or judgement that only one was asked for is none."""
    for name in sorted(one.keys() | other.keys()):
        if name not in one or name not in other:
            yield f"{name}: only one says anything"
            continue
        mine, theirs = one[name], other[name]
        for key in ("verdict", "facts", "findings"):
            if mine[key] != theirs[key]:
                yield f"{name}: {key}: {mine[key]} and {theirs[key]}"
        for key in ("measurements", "judgements"):
            for figure in mine[key].keys() & theirs[key].keys():
                if mine[key][figure] != theirs[key][figure]:
                    yield f"{name}: {figure}: {mine[key][figure]} and {theirs[key][figure]}"
