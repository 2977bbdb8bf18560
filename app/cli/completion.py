"""Completion of `soundlist` in a shell: a script by shtab of commands and options, which starts no Python at a key."""

import argparse
from collections.abc import Mapping
from enum import Enum, StrEnum
from pathlib import Path
from typing import Annotated, Any, get_args

import typer
from typer.core import TyperGroup, TyperOption

from app.cli.groups import PROGRAM, cli
from app.client.commands import parser as client_parser

AnyCommand = Any  # a command of Typer, whose type is private


class Shell(StrEnum):
    """A shell that a script is printed for."""

    BASH = "bash"
    ZSH = "zsh"
    FISH = "fish"


def print_completion(context: typer.Context, shell: Shell | None) -> None:
    """Print the script for a shell, and end."""
    if shell is not None and not context.resilient_parsing:
        import shtab

        typer.echo(shtab.complete(parser(), shell))
        raise typer.Exit


def print_version(asked: bool) -> None:
    """Print the version, which is that of the checks too, and end."""
    if asked:
        from audio_checks import TOOL_VERSION  # not for every command: it loads numpy

        typer.echo(f"{PROGRAM} {TOOL_VERSION}")
        raise typer.Exit


@cli.callback(help="The Soundlist server.")
def take_arguments(
    completion: Annotated[
        Shell | None,
        typer.Option(
            "--show-completion",
            help="Print a script for completion in a shell.",
            is_eager=True,
            callback=print_completion,
        ),
    ] = None,
    version: Annotated[
        bool, typer.Option("--version", help="Print the version.", is_eager=True, callback=print_version)
    ] = False,
) -> None:
    """Take the options of the program itself; the callback of each does what it asks for."""


def parser() -> argparse.ArgumentParser:
    """Return the commands of the program as shtab reads them: those of Typer, and the client's own."""
    (group,) = [action for action in client_parser()._actions if isinstance(action, argparse._SubParsersAction)]
    program = argparse.ArgumentParser(PROGRAM)
    _add_command(program, typer.main.get_command(cli), group.choices)
    _complete_paths(program)
    return program


def _add_command(
    parser: argparse.ArgumentParser, command: AnyCommand, clients: Mapping[str, argparse.ArgumentParser]
) -> None:
    for param in command.params:
        is_option = isinstance(param, TyperOption)
        annotation = param.type_descriptor.annotation
        kind = next(iter(get_args(annotation)), annotation)  # of each value, where there are several
        options: dict[str, Any] = {"help": _text(param.help or "")}
        if is_option and param.is_flag:
            options["action"] = "store_true"
        elif isinstance(kind, type) and issubclass(kind, Enum):
            options["choices"] = [member.value for member in kind]
        elif kind is Path:
            options["type"] = Path
        if param.nargs < 0:
            options["nargs"] = "*"
        parser.add_argument(*(param.opts if is_option else [param.name]), **options)
    if isinstance(command, TyperGroup):
        group = parser.add_subparsers()
        for name, child in command.commands.items():
            help_ = _text(child.get_short_help_str(200))
            if name in clients:
                group.add_parser(name, help=help_, parents=[clients[name]], add_help=False)
            else:
                _add_command(group.add_parser(name, help=help_), child, {})


def _text(help_: str) -> str:
    return help_.replace("%", "%%")


def _complete_paths(parser: argparse.ArgumentParser) -> None:
    import shtab

    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for child in action.choices.values():
                _complete_paths(child)
        elif action.type is Path or not (action.option_strings or action.choices):  # as shells do for any word
            action.complete = shtab.FILE  # type: ignore[attr-defined]
