"""`soundlist ci`: a game's build is checked against what its project asks for, and the reports are posted.

Spec, sound list, baseline and manifest come from the server. `audio-checks` does the judging, as a program of
its own: the client has the standard library alone.
"""

import argparse
import importlib.util
import json
import os
import shutil
import subprocess
import sys
import time
import tomllib
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from app.client.errors import DONE, REFUSED, Refusal, ServerUnreachable
from app.client.server import Server
from app.client.settings import TOKEN, read_source
from app.client.source_control import program
from app.client.terminal import shown, warn

FETCHED = {"spec.toml": "spec.toml", "sounds.csv": "sound-list.csv", "baseline.json": "baseline.json"}
MANIFEST_WAITS_S = (5.0, 10.0, 20.0, 30.0)  # while newly approved sounds are fingerprinted
LABELS = ("BUILD", "GITHUB_RUN_NUMBER", "CI_PIPELINE_IID", "BUILD_BUILDNUMBER", "BUILD_NUMBER")
COMMITS = ("COMMIT", "GITHUB_SHA", "CI_COMMIT_SHA", "BUILD_SOURCEVERSION", "GIT_COMMIT", "P4_CHANGELIST")
MAX_LABEL_CHARS = 200
INSTALLING = "pip install audio-checks into the environment of this job; docs/how-to/ci.md says from where"


def add_arguments(command: argparse.ArgumentParser) -> None:
    """Add this command's own arguments."""
    command.add_argument("folder", nargs="?", default=".", help="the game's sounds; this folder if left out")
    numbers = ", ".join(LABELS[:3])
    command.add_argument("--label", help=f"what to call the build; else {numbers}, another CI's number or the time")
    command.add_argument("--commit", help=f"its commit; else {', '.join(COMMITS[:3])} or another CI's")
    command.add_argument(
        "--fail-level", choices=("error", "warning"), default="error", help="what makes the exit code 1"
    )
    command.add_argument("--changed-since", metavar="REF", help="check only what differs from where REF was left")
    command.add_argument(
        "--format", metavar="F:OUT", action="append", default=[], help="one more report of the check, as audio-checks"
    )
    command.add_argument("--no-audit", action="store_true", help="check the files; compare none with what was approved")
    command.add_argument("--no-post", action="store_true", help="keep the reports off the server")


def run_ci(options: argparse.Namespace) -> int:
    """Check and audit a game's sounds, post both reports, and return the worse exit code."""
    judge = audio_checks_command()
    source = read_source(
        Path(),
        None,
        server=options.server,
        project=options.project,
        target=options.target,
        allow_http=options.allow_http,
    )
    run = _Run(options, Server(source), judge)
    try:
        return run.all(source.target)
    except ServerUnreachable as error:
        raise Refusal(f"the server cannot be reached: {error}") from None


def audio_checks_command() -> list[str]:
    """Return the command that starts `audio-checks`: beside this Python, on PATH, or a module of this Python."""
    beside = shutil.which("audio-checks", path=str(Path(sys.executable).parent))
    if beside is not None:
        return [beside]
    try:
        return [program("audio-checks")]
    except Refusal:
        if importlib.util.find_spec("audio_checks") is None:
            raise Refusal(f"audio-checks is not installed here, and does the judging: {INSTALLING}") from None
    return [sys.executable, "-I", "-m", "audio_checks.cli"]


def _now_in_words() -> str:
    return time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime())


class _Run:
    """One build of a game."""

    def __init__(self, options: argparse.Namespace, server: Server, judge: Sequence[str]) -> None:
        self._options, self._server, self._judge = options, server, list(judge)
        self._label = (options.label or _first_set(LABELS) or _now_in_words())[:MAX_LABEL_CHARS]
        self._commit = (options.commit or _first_set(COMMITS) or "")[:MAX_LABEL_CHARS]

    def all(self, target: str | None) -> int:
        """Do everything, in a folder for the while."""
        options = self._options
        with TemporaryDirectory(prefix="soundlist-") as temporary:
            folder = Path(temporary)
            for name, path in FETCHED.items():
                (folder / name).write_bytes(self._server.file_of_project(path))
            target = target or _first_target(folder / "spec.toml")
            rules = ["--spec", str(folder / "spec.toml"), "--list", str(folder / "sounds.csv")]
            rules += ["--target", target] if target else []
            rules += ["--fail-level", options.fail_level]
            rules += ["--changed-since", options.changed_since] if options.changed_since else []
            rules += [part for output in options.format for part in ("--format", output)]
            code = self._judged("check", rules, folder, target)
            if options.no_audit or target is None:
                return code
            (folder / "manifest.json").write_bytes(self._manifest(target))
            audit = ["--manifest", str(folder / "manifest.json"), "--allow", "unknown"]
            return max(code, self._judged("audit", audit, folder, target))

    def _judged(self, command: str, rules: Sequence[str], folder: Path, target: str | None) -> int:
        """Run a command of `audio-checks` over the folder, post its report, and return its exit code."""
        report = folder / f"{command}.json"
        baseline = ["--baseline", str(folder / "baseline.json")]
        shown_and_kept = ["--format", "text", "--format", f"json:{report}"]
        environment = {name: value for name, value in os.environ.items() if name != TOKEN}
        sys.stdout.flush()
        done = subprocess.run(
            [*self._judge, command, *rules, *baseline, *shown_and_kept, "--", self._options.folder],
            env=environment,
            check=False,
        )
        if done.returncode not in (DONE, 1) and not report.exists():
            return REFUSED  # it said why
        if not self._options.no_post:
            self._post("builds" if command == "check" else "audits", target, json.loads(report.read_bytes()))
        return done.returncode if done.returncode in (DONE, 1) else REFUSED

    def _post(self, where: str, target: str | None, report: Any) -> None:
        body = {"label": self._label, "commit": self._commit, "target": target or "", "report": report}
        self._server.send_to_project(where, body)

    def _manifest(self, target: str) -> bytes:
        """Return the manifest of what is approved, once every sound of it is known."""
        for wait_s in (*MANIFEST_WAITS_S, None):
            try:
                return self._server.file_of_project("manifest.json", target=target)
            except Refusal as refusal:
                if wait_s is None or "listened to" not in str(refusal):
                    raise
                warn(f"soundlist ci: {shown(str(refusal))}")
                time.sleep(wait_s)
        raise AssertionError("the last try returns or raises")


def _first_set(variables: Sequence[str]) -> str:
    return next((os.environ[name].strip() for name in variables if os.environ.get(name, "").strip()), "")


def _first_target(spec: Path) -> str | None:
    try:
        targets = tomllib.loads(spec.read_text(encoding="utf-8")).get("targets", {})
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise Refusal(f"the server's delivery spec cannot be read: {error}") from None
    return next(iter(targets), None)
