"""`audio-checks completion SHELL`: a script that completes commands, options and their words."""

import argparse
from collections.abc import Sequence
from importlib import import_module

from audio_checks.cli.arguments import OK
from audio_checks.cli.completion import SHELLS, commands_of


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the name of a shell."""
    parser.add_argument("shell", choices=tuple(SHELLS), help="the shell that the script is for")


def run(options: argparse.Namespace) -> int:
    """Print the script."""
    from audio_checks.cli import parser_of

    print(SHELLS[options.shell](commands_of(parser_of(), _words_of)), end="")
    return OK


def _words_of(command: str, metavar: str) -> Sequence[str]:
    from audio_checks.cli import COMMANDS
    from audio_checks.spec import check_names

    if metavar == "CHECK":
        here = check_names.present()
        return [name for name in check_names.DEFAULT_SEVERITY if name in here]
    if metavar == "F[:OUT]":
        formats: Sequence[str] = import_module(COMMANDS[command][0]).FORMATS
        return formats
    return ()
