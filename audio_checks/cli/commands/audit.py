"""`audio-checks audit`: compare the sounds of a game build with those that were approved."""

import argparse
import json

from audio_checks.audit.build import audit_build, fingerprint_files
from audio_checks.audit.fingerprinted import FingerprintedFile
from audio_checks.audit.manifest import read_manifest
from audio_checks.audit.report import Audit
from audio_checks.audit.statuses import STATUSES
from audio_checks.cli import reporters
from audio_checks.cli.arguments import FOUND, OK, UsageError, add_paths, add_run
from audio_checks.cli.audit_text import as_findings, in_words
from audio_checks.cli.commands.manifest import fingerprints_below
from audio_checks.cli.outputs import Outputs
from audio_checks.run.discovery import PathNotFound, audio_files

FORMATS = ("text", "json", "junit", "github")
ALLOWED = tuple(status for status in STATUSES if status != "same")


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
        help="what is no drift, such as re-encoded where the engine packs sounds; may be repeated",
    )
    add_run(parser, FORMATS)


def run(options: argparse.Namespace) -> int:
    """Compare, and say what differs: 0 all the same, 1 something drifted."""
    outputs = Outputs(options.format, FORMATS)
    approved = read_manifest(options.manifest)
    if options.approved is not None:
        _ensure_of_the_manifest(approved, options.approved, options.manifest)
    audit = audit_build(approved, fingerprints_below(options))
    allowed = tuple(dict.fromkeys(options.allow))
    outputs.write(lambda name, colour: _as(name, audit, allowed, colour=colour))
    return FOUND if audit.drifted(allowed) else OK


def _as(name: str, audit: Audit, allowed: tuple[str, ...], *, colour: bool) -> str:
    if name == "json":
        return json.dumps(audit.to_dict(), indent=1) + "\n"
    if name == "text":
        return in_words(audit, allowed=allowed, colour=colour)
    return reporters.judged_as(name, as_findings(audit, allowed), reporters.Style(colour))


def _ensure_of_the_manifest(approved: list[FingerprintedFile], folder: str, manifest: str) -> None:
    """Raise UsageError when a folder of approved files is not what the manifest lists."""
    try:
        files = [(one.path, one.relative.replace("\\", "/")) for one in audio_files([folder])]
    except PathNotFound as error:
        raise UsageError(str(error)) from None
    there = {one.path: one for one in fingerprint_files(files)}
    for one in approved:
        if one.path not in there:
            raise UsageError(f"{folder}: {one.path} is in {manifest}, but does not exist; write a new manifest")
        other = there[one.path]
        if (other.pcm_sha256, other.fingerprint) != (one.pcm_sha256, one.fingerprint):
            raise UsageError(f"{folder}: {one.path} is not the file that {manifest} lists; write a new manifest")
