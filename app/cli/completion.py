"""Completion of `soundlist` in a shell: a script of commands and options, which starts no Python at a key.

Where a path or any other text is wanted, the shell's own completion of paths goes on working.
"""

import shlex
from collections.abc import Callable, Iterable, Mapping, Sequence
from enum import StrEnum
from typing import Annotated

import typer

from app.cli.command_tree import PROGRAM, Command, command_tree
from app.cli.groups import cli


class Shell(StrEnum):
    """A shell that a script is printed for."""

    BASH = "bash"
    ZSH = "zsh"
    FISH = "fish"


def print_completion(context: typer.Context, shell: Shell | None) -> None:
    """Print the script for a shell, and end."""
    if shell is not None and not context.resilient_parsing:
        typer.echo(SCRIPTS[shell](command_tree(cli)), nl=False)
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
) -> None:
    """Take the options of the program itself; the callback of each does what it asks for."""


def bash(program: Command) -> str:
    """Return a script for bash 3.2 and newer."""
    commands = list(program.all())
    words = "\n".join(
        f"    {_quoted(command.line)}) words={_quoted(_names(command))}; flags={_quoted(_flags(command))};;"
        for command in commands
    )
    return f"""# Completion of {PROGRAM} for bash.
_soundlist_completion() {{
  local current="${{COMP_WORDS[COMP_CWORD]}}" before="${{COMP_WORDS[COMP_CWORD-1]}}" command={PROGRAM} place
  local words="" flags=""
  for ((place = 1; place < COMP_CWORD; place++)); do
    case "$command ${{COMP_WORDS[place]}}" in
      {_patterns(commands[1:])}) command="$command ${{COMP_WORDS[place]}}";;
    esac
  done
  case "$command" in
{words}
  esac
  case "$current" in -*) words="$flags";; esac
  case "$command $before" in
{_values(commands, _in_bash)}
  esac
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o bashdefault -o default -F _soundlist_completion {PROGRAM}
"""


def zsh(program: Command) -> str:
    """Return a script for zsh; to be loaded, or stored as `_soundlist` in a folder of `fpath`."""
    commands = list(program.all())
    words = "\n".join(
        f"    {_quoted(command.line)})\n"
        f"      offered=({_described((below.path[-1], below.help) for below in command.below)})\n"
        f"      flags=({_described((flag, given.help) for given in command.arguments for flag in given.flags)});;"
        for command in commands
    )
    return f"""#compdef {PROGRAM}
# Completion of {PROGRAM} for zsh.
_soundlist() {{
  local command={PROGRAM} word
  local -a offered flags
  for word in "${{(@)words[2,CURRENT-1]}}"; do
    case "$command $word" in
      {_patterns(commands[1:])}) command="$command $word";;
    esac
  done
  case "$command $words[CURRENT-1]" in
{_values(commands, _in_zsh)}
  esac
  case "$command" in
{words}
  esac
  if [[ "$words[CURRENT]" == -* ]]; then
    _describe -o option flags
  elif (( $#offered )); then
    _describe command offered
  else
    _files
  fi
}}
if [[ $funcstack[1] == _soundlist ]]; then
  _soundlist "$@"
else
  compdef _soundlist {PROGRAM}
fi
"""


def fish(program: Command) -> str:
    """Return a script for fish."""
    commands = list(program.all())
    known = " ".join(_fish(one.line) for one in commands[1:])
    lines = [
        f"# Completion of {PROGRAM} for fish.",
        "function __soundlist_at",
        f"  set -l command {PROGRAM}",
        "  for word in (commandline -opc)[2..]",
        f'    contains -- "$command $word" {known}; and set command "$command $word"',
        "  end",
        '  test "$command" = "$argv[1]"',
        "end",
    ]
    for command in commands:
        condition = _fish(f'__soundlist_at "{command.line}"')
        begin = f"complete -c {PROGRAM} -n {condition}"
        lines += [f"{begin} -f -a {_fish(below.path[-1])} -d {_fish(below.help)}" for below in command.below]
        for argument in command.arguments:
            flags = " ".join(f"-l {flag[2:]}" if flag.startswith("--") else f"-s {flag[1:]}" for flag in argument.flags)
            values = f" -x -a {_fish(' '.join(argument.values))}" if argument.values else " -r" * argument.takes_value
            lines.append(f"{begin} {flags}{values} -d {_fish(argument.help)}")
    return "\n".join(lines) + "\n"


def _names(command: Command) -> str:
    return " ".join(below.path[-1] for below in command.below)


def _flags(command: Command) -> str:
    return " ".join(flag for argument in command.arguments for flag in argument.flags)


def _patterns(commands: list[Command]) -> str:
    return "|".join(_quoted(command.line) for command in commands)


def _values(commands: list[Command], offer: Callable[[Sequence[str]], str]) -> str:
    """Return the cases of options that a value follows: what is offered for it, nothing of ours for a free text."""
    return "\n".join(
        f"    {'|'.join(_quoted(f'{command.line} {flag}') for flag in argument.flags)}) {offer(argument.values)};;"
        for command in commands
        for argument in command.arguments
        if argument.takes_value
    )


def _in_bash(values: Sequence[str]) -> str:
    return f"words={_quoted(' '.join(values))}"


def _in_zsh(values: Sequence[str]) -> str:
    return f"compadd -- {' '.join(map(_quoted, values))}; return" if values else "_files; return"


def _described(words: Iterable[tuple[str, str]]) -> str:
    return " ".join(_quoted(f"{word}:{what}") for word, what in words)


def _quoted(text: str) -> str:
    return shlex.quote(text)


def _fish(text: str) -> str:
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


SCRIPTS: Mapping[Shell, Callable[[Command], str]] = {Shell.BASH: bash, Shell.ZSH: zsh, Shell.FISH: fish}
