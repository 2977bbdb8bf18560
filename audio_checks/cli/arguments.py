"""The arguments that several commands take, and what they mean: paths, a spec, a number of processes."""

import argparse
import codecs
import os
import re
import sys
from collections.abc import Sequence
from pathlib import Path

from audio_checks.cli.progress import Progress
from audio_checks.cli.terminal import say
from audio_checks.errors import AudioChecksError
from audio_checks.run.discovery import Found, PathNotFound, SpecFinder, audio_files
from audio_checks.spec.delivery_spec import DeliverySpec

OK, FOUND, WRONG = 0, 1, 2
LONG_ENOUGH_TO_TELL = 8  # bytes of a text whose encoding is guessed
FORMAT_HELP = "{}; to a file if one is named; may be repeated"


class UsageError(AudioChecksError):
    """The command was given something it cannot work with."""


def add_paths(parser: argparse.ArgumentParser) -> None:
    """Take paths, on the line or from a file."""
    parser.add_argument("paths", nargs="*", metavar="PATH", help="files and folders")
    parser.add_argument("--files-from", metavar="FILE", help="read more paths from a file, one a line; - is stdin")


def add_spec(parser: argparse.ArgumentParser) -> None:
    """Take a spec, a category and a sound list."""
    parser.add_argument("--spec", metavar="FILE", help="delivery spec; else the nearest audio-checks.toml")
    parser.add_argument("--category", metavar="NAME", help="judge by the limits of this category")
    parser.add_argument("--list", metavar="CSV", dest="sound_list", help="sound list: what each cue asks for")


def add_run(parser: argparse.ArgumentParser, formats: Sequence[str] = (), *, jobs: bool = True) -> None:
    """Take the options of every command over files: formats, the number of processes, and its verbosity."""
    shown = parser.add_argument_group("how it runs, and what is shown")
    if formats:
        shown.add_argument("--format", metavar="F[:OUT]", action="append", help=FORMAT_HELP.format(", ".join(formats)))
    if jobs:
        shown.add_argument("-j", "--jobs", type=number_of_jobs, metavar="N", help="processes; 0 is one a core")
    shown.add_argument("--no-progress", action="store_true", help="no progress line on a terminal")
    shown.add_argument(
        "-q", "--quiet", action="store_true", help="only what was found or refused: no summary, notes or progress"
    )


def add_fail_level(parser: argparse._ActionsContainer, what: str) -> None:
    """Take the mildest severity that fails."""
    parser.add_argument("--fail-level", choices=("error", "warning"), default="error", help=what)


def progress_over(count: int, options: argparse.Namespace) -> Progress:
    """Return the progress line of a run, unless the command line asks for none."""
    return Progress(count, shown=not (options.no_progress or options.quiet))


def out_folder(options: argparse.Namespace) -> Path:
    """Return the folder of `--out`; UsageError for "-", since several files do not fit standard output."""
    if options.out == "-":
        raise UsageError("--out wants a folder: standard output (-) has room for one text, not for sound files")
    return Path(options.out)


def number_of_jobs(text: str) -> int:
    """Return a number of processes, as `-j` takes it."""
    if not re.fullmatch(r"[0-9]{1,4}", text, re.ASCII):
        raise argparse.ArgumentTypeError(f'wanted a whole number, 0 for one process a core, found "{text[:40]}"')
    return int(text)


def found_files(options: argparse.Namespace, *, may_be_none: bool = False, default: str | None = None) -> list[Found]:
    """Return the files that the given paths mean; UsageError when there is none to find, or no path at all.

    Afterwards `options.paths` has every path, those from `--files-from` and the default too.
    """
    paths = list(options.paths)
    if options.files_from is not None:
        paths += _paths_from(options.files_from)
    elif not paths:
        if default is None:
            raise UsageError("no path given: name files or folders, . is this folder")
        paths = [default]
    options.paths = paths
    if "-" in paths:
        raise UsageError(
            "- is standard input, and a sound read from there has no name to judge: write it to a file first;"
            " --files-from - reads paths from standard input, and ./- is a file of that name"
        )
    unvisited: list[str] = []
    try:
        files = list(audio_files(paths, unvisited))
    except PathNotFound as error:
        raise UsageError(str(error)) from None
    for folder in unvisited:
        say(folder)
    if not files and (unvisited or not may_be_none):
        raise UsageError(
            "no audio found"
            + ("; --allow-empty says that this is fine" if "allow_empty" in options and not unvisited else "")
        )
    return files


def _paths_from(source: str) -> list[str]:
    """Return the paths of a list: one a line or separated by NUL, in UTF-8 or UTF-16."""
    try:
        raw = sys.stdin.buffer.read() if source == "-" else Path(source).read_bytes()
    except OSError as error:
        raise UsageError(f"{source}: cannot be read: {error.strerror}") from None
    encoding = _wide_encoding(raw)  # Windows PowerShell writes UTF-16 for >
    if encoding is not None:
        try:
            raw = raw.decode(encoding).encode("utf-8", "surrogatepass")
        except UnicodeDecodeError as error:
            raise UsageError(
                f"{source}: is UTF-16 text that is damaged at byte {error.start} ({error.reason}); write it as UTF-8"
            ) from None
    raw = raw.removeprefix(codecs.BOM_UTF8)
    lines = raw.split(b"\0") if b"\0" in raw else raw.splitlines()
    return [os.fsdecode(line) for line in lines if line]


def _wide_encoding(raw: bytes) -> str | None:
    """Return the encoding of a text of UTF-16, with or without a byte order mark; None for any other."""
    if raw.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return "utf-16"
    for encoding, high_bytes in (("utf-16-le", raw[1::2]), ("utf-16-be", raw[::2])):
        # Letters of ASCII have a zero in every second byte. NUL between paths is far rarer than that.
        if len(raw) > LONG_ENOUGH_TO_TELL and high_bytes.count(0) > len(high_bytes) * 0.8:
            return encoding
    return None


def needed_spec_for(path: str, finder: SpecFinder, options: argparse.Namespace) -> DeliverySpec:
    """Return the spec of one file; UsageError where there is none, or where it lacks what the command line names."""
    spec = spec_for(path, finder, options)
    if spec is None:
        raise UsageError(f"no delivery spec for {path}: name one with --spec, or put an audio-checks.toml above it")
    return spec


def spec_for(path: str, finder: SpecFinder, options: argparse.Namespace) -> DeliverySpec | None:
    """Return the spec of one file; UsageError when it lacks what the command line names."""
    spec = finder.spec_of(path)
    if options.category is not None and (spec is None or options.category not in spec.categories):
        category_names = ", ".join(spec.categories) if spec and spec.categories else "none"
        raise UsageError(f'no category "{options.category}"; categories of the spec: {category_names}')
    if spec is None and options.target is not None:
        raise UsageError(f"--target needs a spec, and there is none for {path}")
    return spec
