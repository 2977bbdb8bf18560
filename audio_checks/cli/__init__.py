"""The command line: `audio-checks check`, and the commands around it.

Exit codes: 0 all is well; 1 something was found, or could not be read or rendered; 2 the tool was
asked wrongly, found no audio, or broke. 2 outranks 1.
"""

import argparse
import os
import re
import sys
import traceback
from collections.abc import Callable, Iterable, Sequence
from difflib import get_close_matches
from importlib import import_module
from typing import NoReturn

from audio_checks.cli.arguments import WRONG, UsageError
from audio_checks.cli.terminal import say, set_quiet
from audio_checks.errors import AudioChecksError, SpecError
from audio_checks.version import TOOL_VERSION

COMMANDS = {
    "check": ("audio_checks.cli.commands.check", "judge files and folders"),
    "measure": ("audio_checks.cli.commands.measure", "every figure, no verdict"),
    "render": ("audio_checks.cli.commands.render", "make game files from masters"),
    "fix": ("audio_checks.cli.commands.fix", "make fixed copies, and report what cannot be fixed"),
    "export-master": ("audio_checks.cli.commands.export_master", "copy masters with what is known of them written in"),
    "placeholders": ("audio_checks.cli.commands.placeholders", "make placeholders for cues that have no take"),
    "memory": ("audio_checks.cli.commands.memory", "what a sound list will take in memory, by target"),
    "manifest": ("audio_checks.cli.commands.manifest", "write the fingerprints of approved sounds to a file"),
    "audit": ("audio_checks.cli.commands.audit", "compare a game build with the approved sounds"),
    "explain": ("audio_checks.cli.commands.explain", "why a check exists, and how to fix what it finds"),
    "list": ("audio_checks.cli.commands.list", "all checks"),
    "new-spec": ("audio_checks.cli.commands.new_spec", "print a commented spec to start from"),
    "schema": ("audio_checks.cli.commands.schema", "print the JSON Schema of a document"),
    "completion": ("audio_checks.cli.commands.completion", "print a script that completes commands in a shell"),
}
"""Every command: the module that has it, and what it does."""
FORMER_NAMES = {"mend": "fix"}


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        """State the error without repeating raw control characters, and leave."""
        if "ignored explicit argument" in message:
            message += "; a name that begins with - comes after --"
        if unknown := re.match(r"argument COMMAND: invalid choice: '(.*?)' \(", message):
            command_names = ", ".join(COMMANDS)
            message = (
                f'no command "{unknown[1]}"; the nearest is {_nearest(unknown[1], COMMANDS)}; commands: {command_names}'
            )
        raise UsageError(f"{message}\n{self.format_usage().strip()}")


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; return its exit code."""
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # its idle threads cost a quarter of a short run
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):  # a file or a program on Windows would get another encoding than CI reads
            stream.reconfigure(encoding=None if stream.isatty() else "utf-8", errors="backslashreplace")
    arguments = list(sys.argv[1:] if argv is None else argv)
    arguments[:1] = [FORMER_NAMES.get(name, name) for name in arguments[:1]]
    try:
        options = options_of(arguments)
        set_quiet(getattr(options, "quiet", False))
        command: Callable[[argparse.Namespace], int] = options.run
        code = command(options)
        sys.stdout.flush()
    except AudioChecksError as error:
        say(f"{error.where}: {error}" if isinstance(error, SpecError) and error.where else str(error))
        return WRONG
    except BrokenPipeError:  # the reader of the output has closed it
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return WRONG
    except OSError as error:
        say(f"{error.filename or 'input or output'}: {error.strerror or error}")
        return WRONG
    except KeyboardInterrupt:
        return 130
    except Exception:  # 1 would say that something is wrong with the files
        say(f"this is a fault of the tool, not of the files\n{traceback.format_exc().rstrip()}")
        return WRONG
    return code


def options_of(arguments: Sequence[str]) -> argparse.Namespace:
    """Return the options of a command line; UsageError for one that cannot be understood."""
    options, unknown = parser_of([name for name in COMMANDS if name in arguments]).parse_known_args(arguments)
    if unknown:
        option_names = [name for action in options.parser._actions for name in action.option_strings if len(name) > 2]
        near = [
            f"{argument.partition('=')[0]}; the nearest is {_nearest(argument.partition('=')[0], option_names)}"
            if argument.startswith("--")
            else argument
            for argument in unknown
        ]
        options.parser.error(f"unrecognized arguments: {', '.join(near)}; a name that begins with - comes after --")
    return options


def _nearest(word: str, names: Iterable[str]) -> str:
    return get_close_matches(word[:60], list(names), n=1, cutoff=0.0)[0]


def parser_of(names: Sequence[str] = tuple(COMMANDS)) -> argparse.ArgumentParser:
    """Return the parser of the command line; only the named commands are loaded, the others known by name."""
    parser = _Parser(prog="audio-checks", description="Judge game audio against a delivery spec.")
    parser.add_argument("--version", action="version", version=f"audio-checks {TOOL_VERSION}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for name, (module, what) in COMMANDS.items():
        command = commands.add_parser(name, help=what, description=f"{what[0].upper()}{what[1:]}.")
        if name in names:
            home = import_module(module)
            home.add_arguments(command)
            command.set_defaults(run=home.run, parser=command)
    return parser
