"""`audio-checks explain CHECK`: why a check is there, and how to fix what it finds."""

import argparse
import sys
import textwrap
from typing import TYPE_CHECKING

from audio_checks.cli.arguments import OK, UsageError
from audio_checks.cli.terminal import BOLD, DIM, RED, YELLOW, Ink, in_colour, width
from audio_checks.spec import check_names

if TYPE_CHECKING:
    from audio_checks.checks import Check

SEVERITY_COLOURS = {"error": RED, "warning": YELLOW}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the name of a check."""
    parser.add_argument("check", metavar="CHECK", help="name of a check, or code of a finding")


def run(options: argparse.Namespace) -> int:
    """Print the parts of the check's docstring."""
    from audio_checks.checks import all_checks

    name = options.check.partition(":")[0]
    check = all_checks().get(name) or _by_judgement(name)
    if check is None:
        raise UsageError(_unknown(name, list(all_checks())))
    name = check.name
    ink = Ink(in_colour(sys.stdout))
    level = check_names.DEFAULT_SEVERITY[name]
    print(f"{ink(name, BOLD)}  {ink(level, SEVERITY_COLOURS[level])} {ink('by default', DIM)}")
    print(_wrapped(f"{check.parts['summary']}.", "  "))
    for title in ("Why", "How to fix", "Source"):
        print(f"\n{ink(title, BOLD)}\n{_wrapped(check.parts[title.lower()], '  ')}")
    return OK


def _by_judgement(name: str) -> "Check | None":
    """Return the check that makes findings of a judgement: `reverb` is judged by `baked-reverb`."""
    from audio_checks.checks import all_checks

    return next((check for check in all_checks().values() if check.judgement == name), None)


def _unknown(name: str, names: list[str]) -> str:
    if name in check_names.DEFAULT_SEVERITY:
        return f"{name}: the name is kept for a check that this version lacks"
    from difflib import get_close_matches

    near = [known_name for known_name in names if name in known_name] or get_close_matches(name, names, n=1, cutoff=0.0)
    nearest = " and ".join(f'"{candidate}"' for candidate in near[:3])
    return f'no check "{name}"; the nearest {"is" if len(near) == 1 else "are"} {nearest}; audio-checks list names all'


def _wrapped(text: str, indent: str) -> str:
    sentence = f"{text[:1].upper()}{text[1:]}"
    return textwrap.fill(sentence, width(), initial_indent=indent, subsequent_indent=indent, break_on_hyphens=False)
