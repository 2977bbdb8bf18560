"""`audio-checks completion SHELL`: a script that completes commands, options and their words."""

import argparse

from audio_checks.cli.arguments import OK
from audio_checks.cli.completion import FOLDER, SHELLS


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the name of a shell."""
    parser.add_argument("shell", choices=SHELLS, help="the shell that the script is for")


def run(options: argparse.Namespace) -> int:
    """Print the script."""
    print((FOLDER / options.shell).read_text(encoding="utf-8"), end="")
    return OK
