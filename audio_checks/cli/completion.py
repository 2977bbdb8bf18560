"""Completion scripts for shells, made from the commands as they are.

The scripts know commands, options and the words that options take; where a path is wanted, the
shell's own completion of paths goes on working. They are printed by `audio-checks completion`.
"""

import argparse
import re
import shlex
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

PROGRAM = "audio-checks"
PATHS = {"FILE": "file", "CSV": "file", "PATH": "file", "DIR": "folder"}

Kind = Literal["flag", "words", "file", "folder", "text"]


@dataclass(frozen=True)
class Argument:
    """An option, or a place for words (no flags): what it takes, and what it is for."""

    flags: tuple[str, ...]
    kind: Kind
    words: tuple[str, ...]
    what: str
    repeats: bool


@dataclass(frozen=True)
class Command:
    """A command, and what may follow it."""

    name: str
    what: str
    arguments: tuple[Argument, ...]

    @property
    def flags(self) -> list[str]:
        """Every flag of the command."""
        return [flag for argument in self.arguments for flag in argument.flags]


def commands_of(parser: argparse.ArgumentParser, words_of: Callable[[str, str], Sequence[str]]) -> list[Command]:
    """Return the commands of a parser.

    Parameters
    ----------
    parser : ArgumentParser
        With one group of subparsers.
    words_of : callable
        Returns the words that an argument takes, by command and metavar; empty where any text will do.
    """
    (group,) = [action for action in parser._actions if isinstance(action, argparse._SubParsersAction)]
    what = {choices_action.dest: choices_action.help or "" for choices_action in group._choices_actions}
    return [
        Command(name, what[name], tuple(_argument(name, action, words_of) for action in command._actions))
        for name, command in group.choices.items()
    ]


def _argument(command: str, action: argparse.Action, words_of: Callable[[str, str], Sequence[str]]) -> Argument:
    metavar = action.metavar if isinstance(action.metavar, str) else ""
    words = tuple(map(str, action.choices)) if action.choices else tuple(words_of(command, metavar))
    kind: Kind = "text"
    if action.nargs == 0:
        kind = "flag"
    elif words:
        kind = "words"
    elif metavar in PATHS:
        kind = "folder" if PATHS[metavar] == "folder" else "file"
    repeats = isinstance(action, argparse._AppendAction) or action.nargs == "*"
    return Argument(tuple(action.option_strings), kind, words, action.help or "", repeats)


def bash(commands: Sequence[Command]) -> str:
    """Return a script for bash 3.2 and newer."""
    cases = []
    for command in commands:
        values = [
            f"        {'|'.join(argument.flags)}) {_bash_words(argument)};;"
            for argument in command.arguments
            if argument.flags and argument.kind != "flag"
        ]
        places = [argument for argument in command.arguments if not argument.flags and argument.kind == "words"]
        here = " ".join(shlex.quote(word) for place in places for word in place.words)
        cases.append(
            "\n".join(
                [
                    f"    {command.name})",
                    '      case "$before" in',
                    *values,
                    f"        *) words={shlex.quote(here)}; flags={shlex.quote(' '.join(command.flags))};;",
                    "      esac;;",
                ]
            )
        )
    names = " ".join(one.name for one in commands)
    return f"""# Completion of {PROGRAM} for bash. Load it with: eval "$({PROGRAM} completion bash)"
_audio_checks() {{
  local current="${{COMP_WORDS[COMP_CWORD]}}" before="${{COMP_WORDS[COMP_CWORD-1]}}" words="" flags="" command="" place
  for ((place = 1; place < COMP_CWORD; place++)); do
    case "${{COMP_WORDS[place]}}" in -*) ;; *) command="${{COMP_WORDS[place]}}"; break;; esac
  done
  case "$command" in
    "") words={shlex.quote(names)}; flags="--help --version";;
{chr(10).join(cases)}
  esac
  case "$current" in -*) words="$flags";; esac
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o bashdefault -o default -F _audio_checks {PROGRAM}
"""


def _bash_words(argument: Argument) -> str:
    return f"words={shlex.quote(' '.join(argument.words))}" if argument.words else "words=''"


def zsh(commands: Sequence[Command]) -> str:
    """Return a script for zsh; to be loaded, or stored as `_audio-checks` in a folder of `fpath`."""
    listed = "\n".join(f"    {_zsh_text(f'{command.name}:{command.what}')}" for command in commands)
    cases = "\n".join(
        "\n".join(
            [
                f"    {command.name})",
                "      _arguments -s \\",
                " \\\n".join(f"        {_zsh_argument(argument)}" for argument in command.arguments),
                "      ;;",
            ]
        )
        for command in commands
    )
    return f"""#compdef {PROGRAM}
# Completion of {PROGRAM} for zsh. Load it with: eval "$({PROGRAM} completion zsh)"
_audio_checks() {{
  local -a commands
  commands=(
{listed}
  )
  if (( CURRENT == 2 )); then
    _describe -t commands command commands
    _arguments '--help[show help]' '--version[show the version]'
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
{cases}
  esac
}}
if [[ $funcstack[1] == _audio-checks ]]; then
  _audio_checks "$@"
else
  compdef _audio_checks {PROGRAM}
fi
"""


def _zsh_argument(argument: Argument) -> str:
    action = {"file": "_files", "folder": "_files -/", "words": f"({' '.join(argument.words)})"}.get(argument.kind, " ")
    if not argument.flags:
        return _zsh_text(f"{'*' if argument.repeats else ''}:{_zsh_escaped(argument.what)}:{action}")
    value = "" if argument.kind == "flag" else f":value:{action}"
    what = f"[{_zsh_escaped(argument.what)}]{value}"
    if len(argument.flags) == 1:
        return _zsh_text(f"{'*' if argument.repeats else ''}{argument.flags[0]}{what}")
    others = "" if argument.repeats else _zsh_text(f"({' '.join(argument.flags)})")
    star = _zsh_text("*") if argument.repeats else ""
    return f"{others}{star}{{{','.join(argument.flags)}}}{_zsh_text(what)}"


def _zsh_escaped(text: str) -> str:
    return re.sub(r"([\[\]:\\])", r"\\\1", text)


def _zsh_text(text: str) -> str:
    return "'" + text.replace("'", "'\\''") + "'"


def fish(commands: Sequence[Command]) -> str:
    """Return a script for fish."""
    lines = [
        f"# Completion of {PROGRAM} for fish. Load it with: {PROGRAM} completion fish | source",
        f"complete -c {PROGRAM} -n __fish_use_subcommand -l version -d 'show the version'",
    ]
    for command in commands:
        lines.append(
            f"complete -c {PROGRAM} -f -n __fish_use_subcommand -a {_fish_text(command.name)}"
            f" -d {_fish_text(command.what)}"
        )
        inside = _fish_text(f"__fish_seen_subcommand_from {command.name}")
        for argument in command.arguments:
            parts = [f"complete -c {PROGRAM} -n {inside}"]
            parts += [f"-l {flag[2:]}" if flag.startswith("--") else f"-s {flag[1:]}" for flag in argument.flags]
            parts.append(FISH[argument.kind] if argument.flags else "-f" if argument.kind == "words" else "")
            if argument.words:
                parts.append(f"-a {_fish_text(' '.join(argument.words))}")
            if argument.kind == "folder":
                parts.append("-a '(__fish_complete_directories)'")
            parts.append(f"-d {_fish_text(argument.what)}")
            if argument.flags or argument.words:
                lines.append(" ".join(part for part in parts if part))
    return "\n".join(lines) + "\n"


FISH: Mapping[Kind, str] = {"flag": "", "words": "-x", "file": "-r -F", "folder": "-x", "text": "-x"}


def _fish_text(text: str) -> str:
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


SHELLS: Mapping[str, Callable[[Sequence[Command]], str]] = {"bash": bash, "zsh": zsh, "fish": fish}
