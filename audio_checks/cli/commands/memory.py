"""`audio-checks memory`: what a sound list will take in memory, against the budgets of the spec."""

import argparse
import json
from collections.abc import Iterator

from audio_checks.cli.arguments import FORMAT_HELP, FOUND, OK, UsageError
from audio_checks.cli.named_list import named_list
from audio_checks.cli.outputs import Outputs
from audio_checks.report.findings import printable
from audio_checks.run.memory_budget import Memory, MemoryUse, memory_use, requested_sizes
from audio_checks.spec.delivery_spec import load_spec
from audio_checks.system.plural import counted

FORMATS = ("text", "json")
KIB = 1024


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take a spec, a sound list and targets."""
    parser.add_argument("--spec", metavar="FILE", required=True, help="delivery spec that names targets")
    parser.add_argument("--list", metavar="CSV", dest="sound_list", required=True, help="sound list with durations")
    parser.add_argument("--target", metavar="NAME", action="append", help="only this target; may be repeated")
    parser.add_argument("--format", metavar="F[:OUT]", action="append", help=FORMAT_HELP.format(", ".join(FORMATS)))
    parser.add_argument("-q", "--quiet", action="store_true", help="only the budgets that are exceeded")


def run(options: argparse.Namespace) -> int:
    """Print each target's memory, by category; 1 when a budget is exceeded."""
    spec = load_spec(options.spec)
    sounds = requested_sizes(named_list(options.sound_list).cues)
    names = options.target or list(spec.targets)
    if not names:
        raise UsageError(f"{options.spec}: the spec names no targets")
    memory_uses = [memory_use(spec, name, sounds) for name in names]
    Outputs(options.format, FORMATS).write(
        lambda name, _: (
            f"{json.dumps({'targets': [memory.to_dict() for memory in memory_uses]}, indent=1)}\n"
            if name == "json"
            else "".join(f"{line}\n" for memory in memory_uses for line in _lines(memory, quiet=options.quiet))
        )
    )
    uses = [use for memory in memory_uses for use in (memory.total, *memory.categories)]
    return FOUND if any((use.over_bytes or 0) > 0 for use in uses) else OK


def _lines(memory: Memory, *, quiet: bool) -> Iterator[str]:
    if not quiet or (memory.total.over_bytes or 0) > 0:
        yield f"{memory.target}: {_in_words(memory.total)}"
    for use in memory.categories:
        if not quiet or (use.over_bytes or 0) > 0:
            yield printable(f"  {use.category or 'no category'}: {_in_words(use)}")


def _in_words(use: MemoryUse) -> str:
    files = counted(use.files, "file")
    words = f"{files}, {use.memory_bytes / KIB:,.0f} KiB in memory, {use.disk_bytes / KIB:,.0f} KiB on disk"
    if use.over_bytes is not None and use.budget_bytes is not None:
        room = f"{abs(use.over_bytes) / KIB:,.0f} KiB {'over' if use.over_bytes > 0 else 'under'}"
        words += f", {room} the budget of {use.budget_bytes / KIB:,.0f} KiB"
    if use.unknown_files:
        words += f"; {counted(use.unknown_files, 'more has', 'more have')} no duration yet"
    return words
