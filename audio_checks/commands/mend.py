"""`audio-checks mend`: repaired copies of masters."""

import argparse
import json
from pathlib import Path

from audio_checks.arguments import FOUND, OK, WRONG, UsageError, add_paths, add_spec, found_files, spec_for
from audio_checks.check_names import Severity
from audio_checks.discovery import SpecFinder, without_dry_stems
from audio_checks.outputs import FORMAT_HELP, Outputs
from audio_checks.progress import Progress
from audio_checks.sound_list import read_sound_list

FORMATS = ("text", "json")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take masters, a spec, a target and a folder."""
    add_paths(parser)
    add_spec(parser)
    parser.add_argument("--target", metavar="NAME", help="mend renders made to this target, not deliveries")
    parser.add_argument("--out", metavar="DIR", required=True, help="copies go to DIR/relative path")
    parser.add_argument(
        "--format",
        metavar="F[:OUT]",
        action="append",
        help=FORMAT_HELP.format("text (by default) or json"),
    )
    parser.add_argument("--no-progress", action="store_true", help="no progress line on a terminal")
    parser.add_argument(
        "--fail-level", choices=("error", "warning"), default="error", help="what, once left, makes the exit code 1"
    )


def run(options: argparse.Namespace) -> int:
    """Mend every file into the folder, and say what was done, and what no mend answers."""
    from audio_checks.mend_files import MendRun

    if options.spec is None:
        raise UsageError("a mend answers a spec: name it with --spec")
    outputs = Outputs(options.format, FORMATS)
    finder = SpecFinder(options.spec)
    sound_list = read_sound_list(Path(options.sound_list)) if options.sound_list else None
    found = without_dry_stems(found_files(options), sound_list)
    mending = MendRun(Path(options.out), options.target, options.category, sound_list)
    with Progress(len(found), shown=not options.no_progress) as progress:
        for one in found:
            spec = spec_for(one.path, finder, options)
            if spec is not None:
                mending.mend(one, spec)
            progress.step(one.relative)
    outputs.write(
        lambda name, colour: (
            mending.to_text(colour=colour) if name == "text" else f"{json.dumps(mending.to_json(), indent=2)}\n"
        )
    )
    if any(one.is_our_fault for one in mending.files):
        return WRONG
    levels: tuple[Severity, ...] = ("error", "warning") if options.fail_level == "warning" else ("error",)
    return FOUND if any(one.left(level) for one in mending.files for level in levels) else OK
