"""The commands of `soundlist` with their options, as Typer and the client's own parser have them."""

import argparse
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from typing import Any

import typer
from typer.core import TyperGroup, TyperOption

from app.client.commands import parser as client_parser

AnyCommand = Any  # a command of Typer, whose type is private
PROGRAM = "soundlist"
HELP = "show the help"


@dataclass(frozen=True)
class Argument:
    """An option of a command: its flags, what it is for, whether a value follows, and which are allowed."""

    flags: tuple[str, ...]
    help: str
    takes_value: bool = False
    values: tuple[str, ...] = ()


@dataclass(frozen=True)
class Command:
    """A command or group of commands, by its words from the name of the program on."""

    path: tuple[str, ...]
    help: str
    arguments: tuple[Argument, ...]
    below: tuple["Command", ...] = ()

    @property
    def line(self) -> str:
        """The words as they are typed."""
        return " ".join(self.path)

    def all(self) -> Iterator["Command"]:
        """Yield it and every command below it."""
        yield self
        for command in self.below:
            yield from command.all()


def command_tree(cli: typer.Typer) -> Command:
    """Return the program with all its commands."""
    (group,) = [action for action in client_parser()._actions if isinstance(action, argparse._SubParsersAction)]
    return _of_typer(typer.main.get_command(cli), (PROGRAM,), group.choices)


def _of_typer(command: AnyCommand, path: tuple[str, ...], clients: dict[str, argparse.ArgumentParser]) -> Command:
    of_client = clients.get(path[-1]) if len(path) > 1 else None
    if of_client is not None:
        return _of_parser(of_client, path, command.get_short_help_str(200))
    arguments = [_argument(param) for param in command.params if isinstance(param, TyperOption) and not param.hidden]
    below = command.commands.items() if isinstance(command, TyperGroup) else ()
    return Command(
        path,
        command.get_short_help_str(200),
        (*arguments, Argument(("--help",), HELP)),
        tuple(_of_typer(one, (*path, name), {} if len(path) > 1 else clients) for name, one in below),
    )


def _argument(param: TyperOption) -> Argument:
    annotation = param.type_descriptor.annotation
    is_choice = isinstance(annotation, type) and issubclass(annotation, Enum)
    values = tuple(str(one.value) for one in annotation) if is_choice else ()
    return Argument(tuple(param.opts), param.help or "", not param.is_flag, values)


def _of_parser(parser: argparse.ArgumentParser, path: tuple[str, ...], what: str) -> Command:
    arguments = tuple(
        Argument(
            tuple(action.option_strings), action.help or "", action.nargs != 0, tuple(map(str, action.choices or ()))
        )
        for action in parser._actions
        if action.option_strings
    )
    groups = [action for action in parser._actions if isinstance(action, argparse._SubParsersAction)]
    below = [
        _of_parser(group.choices[choices_action.dest], (*path, choices_action.dest), choices_action.help or "")
        for group in groups
        for choices_action in group._choices_actions
    ]
    return Command(path, what, arguments, tuple(below))
