"""The command line: `audio-checks check`, and the commands around it.

Exit codes: 0 all is well; 1 something was found, or could not be read or rendered; 2 the tool was
asked wrongly, found no audio, or broke. 2 outranks 1.
"""

import argparse
import json
import os
import sys
import traceback
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import IO, NoReturn, Self

from audio_checks import check_names, reporters
from audio_checks.baseline import read_baseline
from audio_checks.check_names import Severity
from audio_checks.discovery import Found, NotThere, SpecFinder, audio_files
from audio_checks.errors import AudioChecksError, RenderRefused, SpecError, Unreadable
from audio_checks.findings import FileReport, Report, printable, with_waivers
from audio_checks.findings import schema as report_schema
from audio_checks.sound_list import read_sound_list
from audio_checks.spec import DeliverySpec, new_spec
from audio_checks.spec import schema as spec_schema
from audio_checks.spec_presets import PRESETS
from audio_checks.version import TOOL_VERSION

OK, FOUND, WRONG = 0, 1, 2


class UsageError(Exception):
    """The command was given something it cannot work with."""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        """Say what is wrong without repeating raw control characters, and leave."""
        raise UsageError(f"{message}\n{self.format_usage().strip()}")


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; return its exit code."""
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # its idle threads cost a quarter of a short run
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")
    try:
        options = _parser().parse_args(argv)
        command: Callable[[argparse.Namespace], int] = options.command
        code = command(options)
        sys.stdout.flush()
    except (UsageError, AudioChecksError) as error:
        _say(f"{error.where}: {error}" if isinstance(error, SpecError) and error.where else str(error))
        return WRONG
    except BrokenPipeError:  # whoever read the output has closed it
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return WRONG
    except OSError as error:
        _say(f"{error.filename or 'input or output'}: {error.strerror or error}")
        return WRONG
    except KeyboardInterrupt:
        return 130
    except Exception:  # 1 would say that something is wrong with the files
        _say(f"this is a fault of the tool, not of the files\n{traceback.format_exc().rstrip()}")
        return WRONG
    return code


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="audio-checks", description="Judge game audio against a delivery spec.")
    parser.add_argument("--version", action="version", version=f"audio-checks {TOOL_VERSION}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)

    check = commands.add_parser("check", help="judge files and folders")
    _add_paths(check)
    _add_spec(check)
    check.add_argument("--target", metavar="NAME", help="judge renders made to this target, not deliveries")
    check.add_argument("--format", metavar="F[:OUT]", action="append", help="text, json or jsonl, to a file if named")
    check.add_argument("--fail-level", choices=("error", "warning"), default="error", help="what makes the exit code 1")
    check.add_argument("-j", "--jobs", type=_jobs, default=1, metavar="N", help="processes; 0 is one a core")
    check.add_argument("--allow-empty", action="store_true", help="no audio at all is no fault")
    check.add_argument("--baseline", metavar="FILE", help="waived findings, as the server exports them")
    check.add_argument("--no-progress", action="store_true", help="no progress line on a terminal")
    check.set_defaults(command=_check)

    measure = commands.add_parser("measure", help="every figure, no verdict")
    _add_paths(measure)
    measure.add_argument("--category", metavar="NAME", help="name of the category, for the record")
    measure.add_argument("--format", metavar="F[:OUT]", action="append", help="text, json or jsonl")
    measure.set_defaults(command=_measure)

    render = commands.add_parser("render", help="make game files from masters")
    _add_paths(render)
    _add_spec(render)
    render.add_argument("--target", metavar="NAME", action="append", help="only this target; may be repeated")
    render.add_argument("--out", metavar="DIR", required=True, help="renders go to DIR/TARGET/relative path")
    render.set_defaults(command=_render)

    explain = commands.add_parser("explain", help="why a check is there, and how to mend what it finds")
    explain.add_argument("check", metavar="CHECK", help="name of a check, or code of a finding")
    explain.set_defaults(command=_explain)

    listing = commands.add_parser("list", help="all checks")
    listing.set_defaults(command=_list)

    start = commands.add_parser("new-spec", help="print a commented spec to start from")
    start.add_argument("--preset", choices=PRESETS, default=PRESETS[0])
    start.set_defaults(command=_new_spec)

    schema = commands.add_parser("schema", help="print the JSON Schema of the spec or of the report")
    schema.add_argument("document", choices=("spec", "report"))
    schema.set_defaults(command=_schema)
    return parser


def _add_paths(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("paths", nargs="*", metavar="PATH", help="files and folders")
    parser.add_argument("--files-from", metavar="FILE", help="read more paths from a file, one a line; - is stdin")


def _add_spec(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--spec", metavar="FILE", help="delivery spec; else the nearest audio-checks.toml")
    parser.add_argument("--category", metavar="NAME", help="judge by the limits of this category")
    parser.add_argument("--list", metavar="CSV", dest="sound_list", help="sound list: what each cue asks for")


def _jobs(text: str) -> int:
    jobs = int(text)
    if jobs < 0:
        raise ValueError
    return jobs


def _check(options: argparse.Namespace) -> int:
    from audio_checks import runner

    outputs = Outputs(options.format, reporters.formats())
    waived = read_baseline(options.baseline) if options.baseline else {}
    finder = SpecFinder(options.spec)
    found = _found(options, may_be_none=options.allow_empty)
    sound_list = read_sound_list(Path(options.sound_list)) if options.sound_list else None
    specs = [_spec_of(one.path, finder, options) for one in found]
    tasks = [
        runner.task_for(one.path, spec, target=options.target, category=options.category, sound_list=sound_list)
        for one, spec in zip(found, specs, strict=True)
    ]
    used = list({id(spec): spec for spec in specs if spec is not None}.values())
    for warning in dict.fromkeys(f"{spec.name}: {one}" for spec in used for one in spec.warnings):
        _say(warning)
    if None in specs:
        _say(f"no delivery spec for {specs.count(None)} of {len(specs)} files: only their structure is judged")
    with _Progress(len(tasks), shown=not options.no_progress) as progress:
        entries = runner.judge(tasks, jobs=options.jobs, done=progress.step)
    entries = [with_waivers(entry, waived) for entry in entries]
    report = runner.report_on(entries, used, [task.spec for task in tasks if task.spec])
    if report.not_run:
        _say(f"not run, because this version lacks them: {', '.join(report.not_run)}")
    outputs.write(lambda name, colour: reporters.judged_as(name, report, colour=colour))
    return _exit_code(report, options.fail_level)


def _exit_code(report: Report, fail_level: str) -> int:
    if any(entry.verdict == "unjudged" for entry in report.files):
        return WRONG
    levels: tuple[Severity, ...] = ("error", "warning") if fail_level == "warning" else ("error",)
    failing = any(entry.count(level, waived=False) for entry in report.files for level in levels)
    return FOUND if failing else OK


def _measure(options: argparse.Namespace) -> int:
    from audio_checks import runner

    outputs = Outputs(options.format, reporters.measured_formats())
    entries, code = [], OK
    for one in _found(options):
        shown = runner.legible(one.path)
        try:
            entries.append(runner.measure_file(one.path, category=options.category))
        except Unreadable as error:
            _say(f"{shown}: {error}; {error.fix}")
            entries.append(FileReport(shown, "unreadable", category=options.category))
            code = FOUND
    report = runner.report_on(entries, [])
    outputs.write(lambda name, colour: reporters.measured_as(name, report, colour=colour))
    return code


def _render(options: argparse.Namespace) -> int:
    from audio_checks import runner
    from audio_checks.render_files import RenderRun

    if options.spec is None:
        raise UsageError("renders are made to the targets of a spec: name it with --spec")
    finder = SpecFinder(options.spec)
    found = _found(options)
    sound_list = read_sound_list(Path(options.sound_list)) if options.sound_list else None
    run, code = RenderRun(options.out), OK
    for one in found:
        spec = _spec_of(one.path, finder, options)
        targets = options.target or list(spec.targets if spec else ())
        if spec is None or not targets:
            raise UsageError(f"{options.spec}: the spec names no targets")
        for target in targets:
            task = runner.task_for(one.path, spec, target=target, category=options.category, sound_list=sound_list)
            try:
                line = run.render(task, one.relative)
            except (RenderRefused, Unreadable) as error:
                line, code = f"refused: {error}; {error.fix}", FOUND
            print(printable(f"{runner.legible(one.path)} -> {target}: {line}"))
    return code


def _explain(options: argparse.Namespace) -> int:
    from audio_checks.checks import all_checks

    name = options.check.partition(":")[0]
    check = all_checks().get(name)
    if check is None:
        if name in check_names.DEFAULT_SEVERITY:
            raise UsageError(f"{name}: the name is kept for a check that this version lacks")
        from difflib import get_close_matches

        near = get_close_matches(name, list(all_checks()), n=1, cutoff=0.0)
        raise UsageError(f'no check "{name}"; the nearest is "{near[0]}"')
    parts = check.parts
    print(f"{name}: {parts['summary']}.\n")
    print(f"By default: {check_names.DEFAULT_SEVERITY[name]}\n")
    for title in ("Why", "How to fix", "Source"):
        print(f"{title}: {parts[title.lower()]}\n")
    return OK


def _list(options: argparse.Namespace) -> int:  # noqa: ARG001
    from audio_checks.checks import all_checks

    here = all_checks()
    for name, check in here.items():
        print(f"{name:<14}{check_names.DEFAULT_SEVERITY[name]:<9}{check.summary}")
    later = [name for name in check_names.DEFAULT_SEVERITY if name not in here]
    if later:
        print(f"\nnames kept for checks that this version lacks: {', '.join(later)}")
    return OK


def _new_spec(options: argparse.Namespace) -> int:
    print(new_spec(options.preset), end="")
    return OK


def _schema(options: argparse.Namespace) -> int:
    print(json.dumps(spec_schema() if options.document == "spec" else report_schema(), indent=2))
    return OK


def _found(options: argparse.Namespace, *, may_be_none: bool = False) -> list[Found]:
    paths = list(options.paths)
    if options.files_from is not None:
        paths += _paths_from(options.files_from)
    elif not paths:
        raise UsageError("no path given")
    try:
        found = list(audio_files(paths))
    except NotThere as error:
        raise UsageError(str(error)) from None
    if not found and not may_be_none:
        raise UsageError(
            "no audio found" + ("; --allow-empty says that this is fine" if "allow_empty" in options else "")
        )
    return found


def _paths_from(source: str) -> list[str]:
    try:
        raw = sys.stdin.buffer.read() if source == "-" else Path(source).read_bytes()
    except OSError as error:
        raise UsageError(f"{source}: cannot be read: {error.strerror}") from None
    lines = raw.split(b"\0") if b"\0" in raw else raw.splitlines()
    return [os.fsdecode(line) for line in lines if line]


def _spec_of(path: str, finder: SpecFinder, options: argparse.Namespace) -> DeliverySpec | None:
    """Return the spec of one file; what the command line names must be in it."""
    spec = finder.spec_of(path)
    if options.category is not None and (spec is None or options.category not in spec.categories):
        known = ", ".join(spec.categories) if spec and spec.categories else "none"
        raise UsageError(f'no category "{options.category}"; categories of the spec: {known}')
    if spec is None and options.target is not None:
        raise UsageError(f"--target needs a spec, and there is none for {path}")
    return spec


class Outputs:
    """Where a report goes: formats, each to a file or to stdout."""

    def __init__(self, asked: list[str] | None, known: Sequence[str]) -> None:
        self._places: list[tuple[str, str]] = []
        for one in asked or ["text"]:
            name, _, place = one.partition(":")
            if name not in known:
                raise UsageError(f'no format "{name}"; formats: {", ".join(known)}')
            self._places.append((name, place))
        if len({place for _, place in self._places}) < len(self._places):
            raise UsageError("two formats go to the same place; name a file for one, as in --format json:report.json")

    def write(self, written: Callable[[str, bool], str]) -> None:
        """Write every format; `written` makes the text of one, coloured or not."""
        for name, place in self._places:
            if place:
                try:
                    Path(place).write_text(written(name, False), encoding="utf-8", errors="backslashreplace")
                except OSError as error:
                    raise UsageError(f"{place}: cannot be written: {error.strerror}") from None
            else:
                sys.stdout.write(written(name, _in_colour(sys.stdout)))


def _in_colour(stream: IO[str]) -> bool:
    return stream.isatty() and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"


class _Progress:
    """A line on the terminal that says how far the work is; nothing where there is no terminal."""

    def __init__(self, total: int, *, shown: bool) -> None:
        self._total = total
        self._done = 0
        self._shown = shown and total > 1 and sys.stderr.isatty()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self._shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()

    def step(self, entry: FileReport) -> None:
        """Count one file."""
        self._done += 1
        if self._shown:
            sys.stderr.write(f"\r\x1b[K{self._done}/{self._total} {printable(entry.path)[-60:]}")
            sys.stderr.flush()


def _say(message: str) -> None:
    for line in message.split("\n"):
        print(f"audio-checks: {printable(line)}", file=sys.stderr)


if __name__ == "__main__":
    sys.exit(main())
