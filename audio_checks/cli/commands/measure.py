"""`audio-checks measure`: every figure and judgement, no verdict."""

import argparse
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from audio_checks.cli import reporters
from audio_checks.cli.arguments import FOUND, OK, WRONG, add_paths, add_run, found_files, progress_over
from audio_checks.cli.outputs import Outputs
from audio_checks.cli.terminal import say
from audio_checks.errors import Unreadable
from audio_checks.report.findings import FileReport
from audio_checks.run.workload import CORES, process_count, size_of
from audio_checks.spec.loudness_presets import PRESETS

FORMATS = reporters.measured_formats()
KINDS = ("event", "natural-decay", "ambience", "voice", "music")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take paths and formats."""
    add_paths(parser)
    parser.add_argument("--category", metavar="NAME", help="name of the category, for the record")
    parser.add_argument(
        "--preset",
        metavar="NAME",
        action="append",
        choices=PRESETS,
        default=[],
        help=f"compare a whole mix with {', '.join(PRESETS)}; may be repeated",
    )
    parser.add_argument("--kind", choices=KINDS, help="what the sounds are, so that judgements know")
    parser.add_argument(
        "--dry",
        metavar="FILE",
        help="the same sound without reverb (a dry stem or an earlier take) for comparison",
    )
    add_run(parser, FORMATS)


def run(options: argparse.Namespace) -> int:
    """Measure the files, and say of each that cannot be read why."""
    from audio_checks.run import runner

    outputs = Outputs(options.format, FORMATS)
    order = _Order(options.category, options.kind, options.dry, tuple(options.preset))
    tasks = [(file.path, order) for file in found_files(options, default=".")]
    jobs = process_count([path for path, _ in tasks]) if options.jobs is None else options.jobs or CORES
    with progress_over(len(tasks), options) as progress:
        measured = _measured(tasks, jobs, lambda measured_file: progress.step(measured_file.entry.path))
    code = OK
    for measurement in measured:
        if measurement.trouble:
            say(f"{measurement.entry.path}: {measurement.trouble}")
            code = max(code, FOUND)
        for failed in measurement.entry.unjudged:
            say(f"{measurement.entry.path}: unjudged by {failed.check}: {failed.message}; this is a fault of the tool")
            code = WRONG
    report = runner.report_on([measurement.entry for measurement in measured], [])
    outputs.write(lambda name, colour: reporters.measured_as(name, report, reporters.Style(colour)))
    return code


@dataclass(frozen=True)
class _Order:
    """The settings shared by all files of a run."""

    category: str | None
    kind: str | None
    dry: str | None
    presets: tuple[str, ...]


class _Measured(NamedTuple):
    """The entry of one file, and why it cannot be read."""

    entry: FileReport
    trouble: str = ""


def _measured(tasks: list[tuple[str, _Order]], jobs: int, done: Callable[[_Measured], None]) -> list[_Measured]:
    if jobs > 1 and len(tasks) > 1:
        from audio_checks.run.processes import in_processes  # costs what a single file need not pay

        return in_processes(
            _measure_all,
            tasks,
            workers=min(jobs, len(tasks)),
            size=lambda task: size_of(task[0]),
            died=_died,
            done=done,
        )
    measured = []
    for path, order in tasks:
        measured.append(_measure(path, order))
        done(measured[-1])
    return measured


def _measure_all(tasks: list[tuple[str, _Order]]) -> list[_Measured]:
    return [_measure(path, order) for path, order in tasks]


def _measure(path: str, order: _Order) -> _Measured:
    from audio_checks.run import runner

    try:
        return _Measured(
            runner.measure_file(path, category=order.category, kind=order.kind, dry=order.dry, presets=order.presets)
        )
    except Unreadable as error:
        entry = FileReport(runner.printable_path(path), "unreadable", category=order.category)
        return _Measured(entry, f"{error}; {error.fix}")
    except Exception as error:  # one file's trouble must not cost the others their figures
        return _Measured(runner.broken(runner.printable_path(path), error, order.category))


def _died(task: tuple[str, _Order], error: BaseException) -> _Measured:
    from audio_checks.run import runner

    return _Measured(runner.broken(runner.printable_path(task[0]), error, task[1].category))
