"""`audio-checks new-spec`: a commented spec to start from."""

import argparse
from pathlib import Path

from audio_checks.cli.arguments import OK, UsageError, add_run, progress_over
from audio_checks.cli.terminal import note
from audio_checks.spec import target_presets
from audio_checks.spec.delivery_spec import new_spec
from audio_checks.spec.presets import PRESETS
from audio_checks.system.plural import counted

LOWEST_ACCEPTED_HZ = 44_100  # of the preset 44k1


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the name of a preset, and those of engines."""
    parser.add_argument("--preset", choices=PRESETS, help="what it accepts and renders to")
    parser.add_argument(
        "--targets",
        metavar="NAME",
        action="append",
        default=[],
        choices=tuple(target_presets.TARGET_PRESETS),
        help=f"render for {', '.join(target_presets.TARGET_PRESETS)}; may be repeated",
    )
    parser.add_argument("--from", metavar="FOLDER", dest="folder", help="measure it from the sounds that are there")
    add_run(parser)


def run(options: argparse.Namespace) -> int:
    """Print the spec."""
    if options.folder is not None:
        if options.preset or options.targets:
            raise UsageError("--from measures what is there; leave --preset and --targets out")
        print(_measured(options), end="")
        return OK
    rates = [target_presets.TARGET_PRESETS[target].sample_rate_hz for target in options.targets]
    fitting = "48k" if max(rates, default=0) > LOWEST_ACCEPTED_HZ else "44k1"  # nothing is converted up
    print(new_spec(options.preset or fitting, targets=options.targets), end="")
    return OK


def _measured(options: argparse.Namespace) -> str:
    from audio_checks.report.findings import printable
    from audio_checks.run.discovery import PathNotFound, audio_files
    from audio_checks.run.measured_spec import spec_from
    from audio_checks.run.workload import process_count

    try:
        paths = [audio_file.path for audio_file in audio_files([options.folder])]
    except PathNotFound as error:
        raise UsageError(str(error)) from None
    if not paths:
        raise UsageError(f"{options.folder}: no audio found")
    jobs = process_count(paths) if options.jobs is None else options.jobs
    with progress_over(len(paths), options) as progress:
        made = spec_from(
            paths, name=Path(options.folder).resolve().name, jobs=jobs, done=lambda file: progress.step(file.path)
        )
    for path, why in made.unreadable:
        note(printable(f"{path}: cannot be read, and is not measured: {why}"))
    note(
        f"{counted(made.measured, 'file')} measured; by this spec none has an error,"
        f" {made.warned} {'has' if made.warned == 1 else 'have'} a warning"
    )
    return made.text
