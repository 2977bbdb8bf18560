"""`audio-checks measure`: every figure and judgement, no verdict."""

import argparse

from audio_checks import reporters
from audio_checks.arguments import FOUND, OK, WRONG, add_paths, found_files
from audio_checks.errors import Unreadable
from audio_checks.findings import FileReport
from audio_checks.loudness_presets import PRESETS
from audio_checks.outputs import FORMAT_HELP, Outputs
from audio_checks.terminal import say

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
        help=f"set a whole mix beside {', '.join(PRESETS)}; may be repeated",
    )
    parser.add_argument("--kind", choices=KINDS, help="what the sounds are, so that judgements know")
    parser.add_argument(
        "--dry",
        metavar="FILE",
        help="the same sound without reverb, a dry stem or an earlier take, to judge beside",
    )
    parser.add_argument("--format", metavar="F[:OUT]", action="append", help=FORMAT_HELP.format(", ".join(FORMATS)))


def run(options: argparse.Namespace) -> int:
    """Measure the files, and say of each that cannot be read why."""
    from audio_checks import runner

    outputs = Outputs(options.format, FORMATS)
    entries, code = [], OK
    for one in found_files(options):
        shown = runner.legible(one.path)
        try:
            entries.append(
                runner.measure_file(
                    one.path, category=options.category, kind=options.kind, dry=options.dry, presets=options.preset
                )
            )
        except Unreadable as error:
            say(f"{shown}: {error}; {error.fix}")
            entries.append(FileReport(shown, "unreadable", category=options.category))
            code = max(code, FOUND)
        except Exception as error:  # one file's trouble must not cost the others their figures
            entries.append(runner.broken(shown, error, options.category))
        for failed in entries[-1].unjudged:
            say(f"{shown}: unjudged by {failed.check}: {failed.message}; this is a fault of the tool")
            code = WRONG
    report = runner.report_on(entries, [])
    outputs.write(lambda name, colour: reporters.measured_as(name, report, reporters.Style(colour)))
    return code
