"""`audio-checks fix`: repaired copies of masters."""

import argparse
import json
from pathlib import Path

from audio_checks.arguments import (
    FOUND,
    OK,
    WRONG,
    UsageError,
    add_fail_level,
    add_paths,
    add_run,
    add_spec,
    found_files,
    out_folder,
    progress_over,
    spec_for,
)
from audio_checks.check_names import Severity
from audio_checks.discovery import SpecFinder, without_dry_stems
from audio_checks.outputs import Outputs
from audio_checks.sound_list import read_sound_list
from audio_checks.workload import worth

FORMATS = ("text", "json")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take masters, a spec, a target and a folder."""
    add_paths(parser)
    add_spec(parser)
    parser.add_argument("--target", metavar="NAME", help="fix renders made to this target, not deliveries")
    parser.add_argument("--out", metavar="DIR", required=True, help="copies go to DIR/relative path")
    add_fail_level(parser, "what, once left, makes the exit code 1")
    add_run(parser, FORMATS)


def run(options: argparse.Namespace) -> int:
    """Mend every file into the folder, and say what was done, and what no mend answers."""
    from audio_checks.mend_files import MendRun

    if options.spec is None:
        raise UsageError("a repair answers a spec: name it with --spec")
    outputs = Outputs(options.format, FORMATS)
    finder = SpecFinder(options.spec)
    sound_list = read_sound_list(Path(options.sound_list)) if options.sound_list else None
    found = without_dry_stems(found_files(options), sound_list)
    mending = MendRun(out_folder(options), options.target, options.category, sound_list)
    specs = [(one, spec_for(one.path, finder, options)) for one in found]
    jobs = worth([one.path for one in found]) if options.jobs is None else options.jobs
    with progress_over(len(found), options) as progress:
        mending.mend_all([(one, spec) for one, spec in specs if spec], jobs=jobs, done=progress.step)
    outputs.write(
        lambda name, colour: (
            mending.to_text(colour=colour, summary=not options.quiet)
            if name == "text"
            else f"{json.dumps(mending.to_json(), indent=2)}\n"
        )
    )
    if any(one.is_our_fault for one in mending.files):
        return WRONG
    levels: tuple[Severity, ...] = ("error", "warning") if options.fail_level == "warning" else ("error",)
    return FOUND if any(one.left(level) for one in mending.files for level in levels) else OK
