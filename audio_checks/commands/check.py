"""`audio-checks check`: judges files and folders."""

import argparse
from pathlib import Path

from audio_checks import reporters
from audio_checks.arguments import FOUND, OK, WRONG, add_paths, add_spec, found_files, number_of_jobs, spec_for
from audio_checks.baseline import read_baseline
from audio_checks.check_names import Severity
from audio_checks.discovery import SpecFinder
from audio_checks.findings import Report, with_waivers
from audio_checks.outputs import FORMAT_HELP, Outputs
from audio_checks.progress import Progress
from audio_checks.sound_list import read_sound_list
from audio_checks.terminal import say


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take paths, what they are judged by, and how the report is shown."""
    add_paths(parser)
    add_spec(parser)
    parser.add_argument("--target", metavar="NAME", help="judge renders made to this target, not deliveries")
    parser.add_argument(
        "--format", metavar="F[:OUT]", action="append", help=FORMAT_HELP.format(", ".join(reporters.formats()))
    )
    parser.add_argument(
        "--fail-level", choices=("error", "warning"), default="error", help="what makes the exit code 1"
    )
    parser.add_argument("-j", "--jobs", type=number_of_jobs, default=1, metavar="N", help="processes; 0 is one a core")
    parser.add_argument("--allow-empty", action="store_true", help="no audio at all is no fault")
    parser.add_argument("--baseline", metavar="FILE", help="waived findings, as the server exports them")
    parser.add_argument("--no-progress", action="store_true", help="no progress line on a terminal")


def run(options: argparse.Namespace) -> int:
    """Judge the files and report on them."""
    from audio_checks import runner

    outputs = Outputs(options.format, reporters.formats())
    waived = read_baseline(options.baseline) if options.baseline else {}
    finder = SpecFinder(options.spec)
    found = found_files(options, may_be_none=options.allow_empty)
    sound_list = read_sound_list(Path(options.sound_list)) if options.sound_list else None
    specs = [spec_for(one.path, finder, options) for one in found]
    tasks = [
        runner.task_for(one.path, spec, target=options.target, category=options.category, sound_list=sound_list)
        for one, spec in zip(found, specs, strict=True)
    ]
    used = list({id(spec): spec for spec in specs if spec is not None}.values())
    for warning in dict.fromkeys(f"{spec.name}: {one}" for spec in used for one in spec.warnings):
        say(warning)
    if None in specs:
        say(f"no delivery spec for {specs.count(None)} of {len(specs)} files: only their structure is judged")
    with Progress(len(tasks), shown=not options.no_progress) as progress:
        entries = runner.judge(tasks, jobs=options.jobs, done=lambda entry: progress.step(entry.path))
    entries = [with_waivers(entry, waived) for entry in entries]
    report = runner.report_on(entries, used, [task.spec for task in tasks if task.spec])
    if report.not_run:
        say(f"not run, because this version lacks them: {', '.join(report.not_run)}")
    outputs.write(lambda name, colour: reporters.judged_as(name, report, reporters.Style(colour, options.fail_level)))
    return exit_code(report, options.fail_level)


def exit_code(report: Report, fail_level: str) -> int:
    """Return 0, 1 for findings at or above the level that nobody waived, or 2 for a check that broke."""
    if any(entry.verdict == "unjudged" for entry in report.files):
        return WRONG
    levels: tuple[Severity, ...] = ("error", "warning") if fail_level == "warning" else ("error",)
    failing = any(entry.count(level, waived=False) for entry in report.files for level in levels)
    return FOUND if failing else OK
