"""Rules of build reports and of the commands for CI, stated without a database."""

import json
import shlex
from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Any
from urllib.parse import urlencode

from app.builds.errors import ReportInvalid

MAX_REPORT_CHARS = 50_000_000
# Python is there wherever audio-checks is.
COMPOSE = (
    "import json, sys; label, commit, target = sys.argv[1:]; "
    'json.dump({"label": label, "commit": commit, "target": target, "report": json.load(sys.stdin)}, sys.stdout)'
)


class PackState(StrEnum):
    """Whether a pack can be handed out."""

    SEALING = "sealing"
    SEALED = "sealed"
    REFUSED = "refused"


class FileKind(StrEnum):
    """The kind of a file in a pack."""

    GAME = "game"
    PLACEHOLDER = "placeholder"
    MASTER = "master"
    KEY = "key"  # documentation key, engine export and sums: made for the pack and kept with it


@dataclass(frozen=True)
class Changes:
    """The differences of two packs of a target, by path, each in order."""

    new: list[str]
    changed: list[str]
    gone: list[str]
    same: int


def changes_between(before: Mapping[str, str], after: Mapping[str, str]) -> Changes:
    """Return the change of each path; a file is the same while its mark is."""
    kept = [path for path in after if path in before]
    return Changes(
        new=[path for path in after if path not in before],
        changed=[path for path in kept if before[path] != after[path]],
        gone=[path for path in before if path not in after],
        same=sum(before[path] == after[path] for path in kept),
    )


def sums(sha256_by_path: Mapping[str, str]) -> bytes:
    """Return the input of `sha256sum --check`."""
    return "".join(f"{sha256}  {path}\n" for path, sha256 in sha256_by_path.items()).encode()


def ensure_storable(report: Mapping[str, Any]) -> None:
    """Raise ReportInvalid for a report that no JSON document can hold, or that is too large to keep."""
    try:
        text = json.dumps(report, allow_nan=False)
        text.encode()
    except (ValueError, RecursionError):
        raise ReportInvalid("the report holds what JSON cannot: NaN, an infinity, or too many levels") from None
    if len(text) > MAX_REPORT_CHARS:
        raise ReportInvalid(f"the report has {len(text):,} characters; at most {MAX_REPORT_CHARS:,} are kept")
    if "\\u0000" in text:
        raise ReportInvalid("the report holds a zero character")


def is_refused(entry: Mapping[str, Any]) -> bool:
    """Whether a file of a report breaks a build: by a verdict that no waiver lifts."""
    if entry["verdict"] != "rejected":
        return bool(entry["verdict"] != "conforming")
    return any(finding["severity"] == "error" and not finding.get("waived") for finding in entry["findings"])


def warnings_in(entry: Mapping[str, Any]) -> int:
    """Return the number of warning findings of a file that are not let through."""
    return sum(finding["severity"] == "warning" and not finding.get("waived") for finding in entry["findings"])


def ci_command(base_url: str, project_id: str, target: str) -> str:
    """Return the one line by which a game's CI does the same as by `ci_lines`."""
    auth = '-H "Authorization: Bearer $SOUNDLIST_TOKEN"'
    source = f"--server {shlex.quote(base_url)} --project {project_id} --target {shlex.quote(target)}"
    return (
        f"curl -fsSO {auth} {base_url}/v1/projects/{project_id}/soundlist.pyz"
        f" && python3 -I soundlist.pyz ci {source} assets/"
    )


def ci_lines(base_url: str, project_id: str, target: str) -> list[str]:
    """Return the shell lines by which a game's CI checks its audio, posts the report, and audits it."""
    project = f"{base_url}/v1/projects/{project_id}"
    auth = '-H "Authorization: Bearer $SOUNDLIST_TOKEN"'
    fetched = (("spec.toml", "spec.toml"), ("sound-list.csv", "sounds.csv"), ("baseline.json", "baseline.json"))
    quoted = shlex.quote(target)
    manifest = f"{project}/manifest.json?{urlencode({'target': target})}"
    return [
        "set -euo pipefail",
        *(f"curl -fsS {auth} -o {name} {project}/{path}" for path, name in fetched),
        f"audio-checks check --spec spec.toml --list sounds.csv --target {quoted} --baseline baseline.json "
        "--format text --format json:report.json assets/ || status=$?",
        f'python3 -c \'{COMPOSE}\' "${{BUILD:-unnamed}}" "${{COMMIT:-}}" {quoted} < report.json | '
        f"curl -fsS {auth} -H 'Content-Type: application/json' --data-binary @- -o posted.json {project}/builds",
        # Refused with 409 while newly approved sounds are fingerprinted.
        f"curl -fsS --retry 5 --retry-all-errors {auth} -o manifest.json {shlex.quote(manifest)}",
        "audio-checks audit --manifest manifest.json --baseline baseline.json --allow unknown --format text "
        "--format json:audit.json assets/ || drifted=$?",
        f'python3 -c \'{COMPOSE}\' "${{BUILD:-unnamed}}" "${{COMMIT:-}}" {quoted} < audit.json | '
        f"curl -fsS {auth} -H 'Content-Type: application/json' --data-binary @- -o audited.json {project}/audits",
        'exit "${status:-${drifted:-0}}"',
    ]
