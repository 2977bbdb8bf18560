"""How long files take that were judged before: `python -m benchmarks.unchanged` prints a table.

Every row is one cold run of the command line over the same 10,000 short sounds, wall seconds.
"""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from audio_checks.spec.delivery_spec import new_spec
from tests.support.waves import noise, wav_bytes

FILES = 10_000
MAX_UNCHANGED_S = 2.0


def make(folder: Path) -> None:
    """Write the sounds, each of its own bytes, in a hundred folders."""
    for number in range(FILES):
        place = folder / f"group_{number % 100:02}" / f"sound_{number:05}.wav"
        place.parent.mkdir(exist_ok=True)
        place.write_bytes(wav_bytes(noise(seconds=0.1, seed=number, dbfs=-20), bits=16, rate=44_100))


def run(folder: Path) -> float:
    """Return the wall seconds of one run."""
    environment = {**os.environ, "AUDIO_CHECKS_CACHE_DIR": str(folder.parent / "verdicts")}
    began_s = time.perf_counter()
    command = [sys.executable, "-m", "audio_checks.cli", "check", "--fail-level", "error", str(folder)]
    said = subprocess.run(command, check=False, env=environment, capture_output=True, text=True)
    passed_s = time.perf_counter() - began_s
    if said.returncode == 2 or f"{FILES} files: " not in said.stdout:
        raise SystemExit(said.stdout[-2000:] + said.stderr[-2000:])
    return passed_s


def main() -> None:
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "sounds"
        folder.mkdir()
        make(folder)
        (folder / "audio-checks.toml").write_text(new_spec())
        rows = [
            ("judged for the first time", run(folder)),
            ("unchanged", run(folder)),
            ("unchanged, again", run(folder)),
        ]
        for path in folder.rglob("*.wav"):
            os.utime(path)
        rows.append(("same bytes, new times, as after a checkout", run(folder)))
        moved = folder.rename(folder.with_name("moved"))
        rows.append(("same bytes, another folder", run(moved)))
    print(f"| {FILES:,} files | wall s |\n|---|---|")
    for what, seconds in rows:
        print(f"| {what} | {seconds:.2f} |")
    print(f"\nUnchanged files must take {MAX_UNCHANGED_S:.0f} s at most.")


if __name__ == "__main__":
    main()
