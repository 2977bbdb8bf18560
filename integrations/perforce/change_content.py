"""A change-content trigger for Perforce: refuses a changelist whose sounds do not conform.

It is asked after the files have reached the server and before the change is committed. In `p4 triggers`,
on one line, with the Python that audio-checks is installed for:

    audio-checks change-content //depot/game/assets/...
        "/p4/venv/bin/python -I /p4/change_content.py --spec /p4/spec.toml %changelist%"

The user of the trigger's environment (P4PORT, P4USER, a ticket) must be able to read the files. The
tests run this file against a substitute for `p4` that answers as its documents say; it has not been run
against a Perforce server.
"""

import argparse
import io
import marshal
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

from audio_checks.spec.sound_names import AUDIO_SUFFIXES

GONE = {"delete", "move/delete", "purge", "archive"}
ENCODED = {"%40": "@", "%23": "#", "%2A": "*", "%25": "%"}  # how depot paths spell these; the percent sign last


def main() -> int:
    """Judge the sounds of one changelist; print what was found, and return 0 only if they may be submitted."""
    parser = argparse.ArgumentParser(description="Judge the sounds of a changelist that is being submitted.")
    parser.add_argument("change", help="%%changelist%% in the line of p4 triggers")
    parser.add_argument("--spec", required=True, help="delivery spec")
    parser.add_argument("--target", help="judge renders made to this target of the spec")
    parser.add_argument("--list", help="sound list")
    parser.add_argument("--baseline", help="findings that are let through")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="audio-checks-") as folder:
        count = sum(_fetch(depot_path, options.change, Path(folder)) for depot_path in _sounds_of(options.change))
        if not count:
            return 0
        command = [sys.executable, "-I", "-m", "audio_checks.cli", "check", "--no-progress", "--no-cache"]
        for name in ("spec", "target", "list", "baseline"):
            if value := getattr(options, name):
                command += [f"--{name}", value if name == "target" else str(Path(value).absolute())]
        judged = subprocess.run([*command, "."], cwd=folder, capture_output=True, text=True, check=False)
    if judged.returncode == 0:
        return 0
    print(f"{judged.stdout}{judged.stderr}")
    if judged.returncode != 1:
        print("The sounds could not be judged; this is not their fault. Contact the server administrator.")
    return 1


def _sounds_of(change: str) -> Iterator[str]:
    for answer in _p4("files", f"//...@={change}"):
        path = answer["depotFile"]
        if answer["action"] not in GONE and PurePosixPath(path).suffix.lower() in AUDIO_SUFFIXES:
            yield path


def _fetch(depot_path: str, change: str, folder: Path) -> int:
    """Write one file as it is in the change below the folder, under its path in the depot."""
    plain = depot_path
    for code, sign in ENCODED.items():
        plain = plain.replace(code, sign)
    place = folder.joinpath(*(part for part in plain.lstrip("/").split("/") if part not in ("", ".", "..")))
    place.parent.mkdir(parents=True, exist_ok=True)
    for _ in _p4("print", "-q", "-o", str(place), f"{depot_path}@={change}"):
        pass
    return 1


def _p4(*arguments: str) -> Iterator[dict[str, str]]:
    """Yield what Perforce answers, as dictionaries (`p4 -G`); leave with its words when it refuses."""
    asked = subprocess.run(["p4", "-G", *arguments], capture_output=True, check=False)
    stream = io.BytesIO(asked.stdout)
    while True:
        try:
            answer = marshal.load(stream)
        except EOFError:
            break
        facts = {
            key.decode(): value.decode("utf-8", "replace") for key, value in answer.items() if type(value) is bytes
        }
        if facts.get("code") == "error":
            sys.exit(f"p4 {arguments[0]}: {facts.get('data', '').strip()}")
        yield facts
    if asked.returncode != 0:
        sys.exit(f"p4 {arguments[0]}: {asked.stderr.decode(errors='replace').strip() or 'failed'}")


if __name__ == "__main__":
    sys.exit(main())
