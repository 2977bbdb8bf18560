"""Completion scripts for shells, made from the commands as they are, by shtab.

They know commands, options, the words that options take, and where a path is wanted. `make completions` writes them
into the package, so `audio-checks completion` prints them where shtab is not installed.
"""

import argparse
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path

FOLDER = Path(__file__).with_name("completions")
SHELLS = ("bash", "zsh", "fish")
FILES, FOLDERS = ("FILE", "CSV", "PATH"), ("DIR",)  # the metavars of arguments that are paths


def scripts() -> dict[str, str]:
    """Return the script for each shell; needs shtab."""
    import shtab

    from audio_checks.cli import parser_of

    parser = parser_of()
    (group,) = [action for action in parser._actions if isinstance(action, argparse._SubParsersAction)]
    for name, command in group.choices.items():
        for action in command._actions:
            metavar = action.metavar if isinstance(action.metavar, str) else ""
            action.choices = action.choices or _words(name, metavar) or None
            if ":" in metavar:
                action.metavar = metavar.partition("[:")[0]  # zsh parts its fields at colons
            if metavar in FILES + FOLDERS:
                path = shtab.FILE if metavar in FILES else shtab.DIRECTORY
                action.complete = path  # read by shtab
    return {shell: shtab.complete(parser, shell) for shell in SHELLS}


def _words(command: str, metavar: str) -> Sequence[str]:
    from audio_checks.cli import COMMANDS
    from audio_checks.spec import check_names

    if metavar == "CHECK":
        present = check_names.present()
        return [name for name in check_names.DEFAULT_SEVERITY if name in present]
    if metavar == "F[:OUT]":
        formats: Sequence[str] = import_module(COMMANDS[command][0]).FORMATS
        return formats
    return ()


if __name__ == "__main__":
    for shell, script in scripts().items():
        (FOLDER / shell).write_text(script, encoding="utf-8")
