"""`audio-checks list`: all checks."""

import argparse
import sys

from audio_checks.cli.arguments import OK
from audio_checks.cli.commands.explain import SEVERITY_COLOURS
from audio_checks.cli.terminal import BOLD, DIM, Ink, in_colour
from audio_checks.spec import check_names


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take nothing."""


def run(options: argparse.Namespace) -> int:
    """Print every check, its severity by default, and what holds."""
    from audio_checks.checks import all_checks

    ink, here = Ink(in_colour(sys.stdout)), all_checks()
    columns = max(map(len, here)) + 2
    for name, check in here.items():
        level = check_names.DEFAULT_SEVERITY[name]
        padding = " " * (columns - len(name))
        print(f"{ink(name, BOLD)}{padding}{ink(f'{level:<9}', SEVERITY_COLOURS[level])}{check.summary}")
    later = [name for name in check_names.DEFAULT_SEVERITY if name not in here]
    if later:
        print(ink(f"\nnames kept for checks that this version lacks: {', '.join(later)}", DIM))
    return OK
