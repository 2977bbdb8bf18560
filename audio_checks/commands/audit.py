"""`audio-checks audit`: compare the sounds of a game build with those that were approved."""

import argparse
import json

from audio_checks import reporters
from audio_checks.arguments import FOUND, OK, UsageError, add_paths, add_run
from audio_checks.audit.build import audit_build, listen_to
from audio_checks.audit.heard import Heard
from audio_checks.audit.manifest import read_manifest
from audio_checks.audit.report import Audit
from audio_checks.audit.statuses import STATUSES
from audio_checks.audit.words import as_findings, in_words
from audio_checks.commands.manifest import heard_below
from audio_checks.discovery import NotThere, audio_files
from audio_checks.outputs import Outputs

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
    audit = audit_build(approved, heard_below(options))
    allowed = tuple(dict.fromkeys(options.allow))
    outputs.write(lambda name, colour: _as(name, audit, allowed, colour=colour))
    return FOUND if audit.drifted(allowed) else OK


def _as(name: str, audit: Audit, allowed: tuple[str, ...], *, colour: bool) -> str:
    if name == "json":
        return json.dumps(audit.to_dict(), indent=1) + "\n"
    if name == "text":
        return in_words(audit, allowed=allowed, colour=colour)
    return reporters.judged_as(name, as_findings(audit, allowed), reporters.Style(colour))


def _ensure_of_the_manifest(approved: list[Heard], folder: str, manifest: str) -> None:
    """Raise UsageError when a folder of approved files is not what the manifest lists."""
    try:
        files = [(one.path, one.relative.replace("\\", "/")) for one in audio_files([folder])]
    except NotThere as error:
        raise UsageError(str(error)) from None
    there = {one.path: one for one in listen_to(files)}
    for one in approved:
        if one.path not in there:
            raise UsageError(f"{folder}: {one.path} is in {manifest}, and not there; make the manifest anew")
        other = there[one.path]
        if (other.pcm_sha256, other.fingerprint) != (one.pcm_sha256, one.fingerprint):
            raise UsageError(f"{folder}: {one.path} is not what {manifest} lists; make the manifest anew")
