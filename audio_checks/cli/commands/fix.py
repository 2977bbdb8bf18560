"""`audio-checks fix`: fixed copies of masters."""

import argparse
import json

from audio_checks.cli.arguments import (
    FOUND,
    OK,
    WRONG,
    add_fail_level,
    add_paths,
    add_run,
    add_spec,
    found_files,
    needed_spec_for,
    out_folder,
    progress_over,
)
from audio_checks.cli.named_list import named_list
from audio_checks.cli.outputs import Outputs
from audio_checks.run.discovery import SpecFinder, without_dry_stems
from audio_checks.run.workload import process_count
from audio_checks.spec.check_names import Severity

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
    """Fix every file into the folder, and report what was done and what is left."""
    from audio_checks.cli.fix_report import report_text
    from audio_checks.fixing.files import FixRun

    outputs = Outputs(options.format, FORMATS)
    finder = SpecFinder(options.spec)
    sound_list = named_list(options.sound_list) if options.sound_list else None
    files = without_dry_stems(found_files(options), sound_list)
    fixing = FixRun(out_folder(options), options.target, options.category, sound_list)
    specs = [(file, needed_spec_for(file.path, finder, options)) for file in files]
    jobs = process_count([file.path for file in files]) if options.jobs is None else options.jobs
    with progress_over(len(files), options) as progress:
        fixing.fix_all(specs, jobs=jobs, done=progress.step)
    outputs.write(
        lambda name, colour: (
            report_text(fixing, colour=colour, summary=not options.quiet)
            if name == "text"
            else f"{json.dumps(fixing.to_json(), indent=2)}\n"
        )
    )
    if any(file.is_our_fault for file in fixing.files):
        return WRONG
    levels: tuple[Severity, ...] = ("error", "warning") if options.fail_level == "warning" else ("error",)
    return FOUND if any(file.left(level) for file in fixing.files for level in levels) else OK
