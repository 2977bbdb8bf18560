"""`audio-checks audit`: compare the sounds of a game build with those that were approved."""

import argparse
import json
from pathlib import Path

from audio_checks.audit.accepted import DEFAULT_NAME, accept, read_accepted, with_accepted
from audio_checks.audit.build import audit_build, fingerprint_files
from audio_checks.audit.fingerprinted import FingerprintedFile
from audio_checks.audit.manifest import read_manifest
from audio_checks.audit.played import LIMIT_DB, with_project
from audio_checks.audit.report import Audit
from audio_checks.audit.statuses import NO_DRIFT, STATUSES
from audio_checks.cli import reporters
from audio_checks.cli.arguments import FOUND, OK, UsageError, add_paths, add_run
from audio_checks.cli.audit_text import as_findings, in_words
from audio_checks.cli.commands.manifest import fingerprints_below
from audio_checks.cli.outputs import Outputs
from audio_checks.cli.terminal import note
from audio_checks.middleware.project import read_project, sound_folder
from audio_checks.run.discovery import PathNotFound, audio_files

FORMATS = ("text", "json", "junit", "github")
UNREAD = "unread"  # a file of the project that cannot be read
ALLOWED = (*(status for status in STATUSES if status not in NO_DRIFT), UNREAD)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take a manifest, the folder of the build, and what may differ."""
    add_paths(parser)
    parser.add_argument("--manifest", metavar="FILE", required=True, help="approved sounds; see `manifest`")
    parser.add_argument("--approved", metavar="DIR", help="the approved files: make sure that they are the manifest's")
    parser.add_argument(
        "--allow",
        metavar="STATUS",
        action="append",
        choices=ALLOWED,
        default=[],
        help="what is not drift, such as re-encoded where the engine packs sounds; may be repeated",
    )
    parser.add_argument(
        "--project",
        metavar="PATH",
        help="the game's project: .wproj, .fspro, project.godot, a Unity project's folder, or an export of Unreal's;"
        " without a build's folder, the project's own sounds are compared",
    )
    parser.add_argument(
        "--level-limit",
        metavar="DB",
        type=_decibels,
        default=LIMIT_DB,
        help=f"how far the level in the game may be from the approved one; {LIMIT_DB}",
    )
    accepted = parser.add_argument_group("accepted drift")
    accepted.add_argument("--baseline", metavar="FILE", help="drift that is let through, with its reason and day")
    accepted.add_argument(
        "--add-baseline", action="store_true", help=f"let through what drifts now; kept in FILE, or {DEFAULT_NAME}"
    )
    accepted.add_argument("--reason", metavar="TEXT", help="why, for --add-baseline")
    add_run(parser, FORMATS)


def run(options: argparse.Namespace) -> int:
    """Compare, and say what differs: 0 all the same, 1 something drifted."""
    outputs = Outputs(options.format, FORMATS)
    approved = read_manifest(options.manifest)
    if options.approved is not None:
        _ensure_of_the_manifest(approved, options.approved, options.manifest)
    if options.add_baseline and not (options.reason or "").strip():
        raise UsageError("--add-baseline wants a --reason: accepted drift says why")
    project = read_project(options.project) if options.project is not None else None
    if project is not None and not options.paths and options.files_from is None:
        options.paths = [str(sound_folder(project))]
    audit = audit_build(approved, fingerprints_below(options), by_ends=project is not None)
    if project is not None:
        audit = with_project(audit, approved, project, limit_db=options.level_limit)
    allowed = tuple(dict.fromkeys(options.allow))
    if options.baseline is not None and (Path(options.baseline).exists() or not options.add_baseline):
        audit = with_accepted(audit, read_accepted(options.baseline))
    if options.add_baseline:
        baseline_path = options.baseline or DEFAULT_NAME
        added = accept(baseline_path, audit, allowed, options.reason)
        note(f"{baseline_path}: {added} drifts let through from now on; read it with --baseline {baseline_path}")
        audit = with_accepted(audit, read_accepted(baseline_path))
    outputs.write(lambda name, colour: _as(name, audit, allowed, colour=colour))
    unread = project is not None and project.unread and UNREAD not in allowed
    return FOUND if unread or audit.drifted(allowed) else OK


def _decibels(text: str) -> float:
    limit_db = float(text)
    if not 0 < limit_db <= 100:
        raise ValueError
    return limit_db


def _as(name: str, audit: Audit, allowed: tuple[str, ...], *, colour: bool) -> str:
    if name == "json":
        return json.dumps(audit.to_dict(), indent=1) + "\n"
    if name == "text":
        return in_words(audit, allowed=allowed, colour=colour)
    return reporters.judged_as(name, as_findings(audit, allowed), reporters.Style(colour))


def _ensure_of_the_manifest(approved: list[FingerprintedFile], folder: str, manifest: str) -> None:
    """Raise UsageError when a folder of approved files is not what the manifest lists."""
    try:
        files = [(audio_file.path, audio_file.relative.replace("\\", "/")) for audio_file in audio_files([folder])]
    except PathNotFound as error:
        raise UsageError(str(error)) from None
    there = {fingerprint_file.path: fingerprint_file for fingerprint_file in fingerprint_files(files)}
    for file in approved:
        if file.path not in there:
            raise UsageError(f"{folder}: {file.path} is in {manifest}, but does not exist; write a new manifest")
        other = there[file.path]
        if (other.pcm_sha256, other.fingerprint) != (file.pcm_sha256, file.fingerprint):
            raise UsageError(f"{folder}: {file.path} is not the file that {manifest} lists; write a new manifest")
