"""`audio-checks check`: judges files and folders."""

import argparse
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from audio_checks.cli import reporters
from audio_checks.cli.arguments import (
    FOUND,
    OK,
    WRONG,
    UsageError,
    add_fail_level,
    add_paths,
    add_run,
    add_spec,
    found_files,
    progress_over,
    spec_for,
)
from audio_checks.cli.named_list import named_list
from audio_checks.cli.outputs import Outputs
from audio_checks.cli.terminal import BOLD, GREEN, RED, Ink, in_colour, note, say, width
from audio_checks.report.findings import FileReport, Report, printable, with_waivers
from audio_checks.run.baseline import DEFAULT_NAME, add_to_baseline, known_by_its_bytes, read_baseline
from audio_checks.run.discovery import SPEC_NAMES, Found, SpecFinder, dry_stems
from audio_checks.run.workload import CORES, process_count
from audio_checks.spec.delivery_spec import DeliverySpec
from audio_checks.system.plural import counted

if TYPE_CHECKING:
    from audio_checks.fixing.in_place import Change
    from audio_checks.run.changed_since import Changes
    from audio_checks.run.runner import Task

FORMATS = reporters.formats()
MANY_FAILING = 50  # from here on, to begin with a baseline is less work than to fix everything first


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take paths, what they are judged by, what is done about it, and how it is shown."""
    add_paths(parser)
    add_spec(parser)
    parser.add_argument("--target", metavar="NAME", help="judge renders made to this target, not deliveries")
    parser.add_argument("--changed-since", metavar="REF", help="only files that differ from where REF was left")
    parser.add_argument("--allow-empty", action="store_true", help="no audio at all is not a fault")

    fails = parser.add_argument_group("what fails")
    add_fail_level(fails, "what makes the exit code 1")
    fails.add_argument(
        "--require-spec", action="store_true", help="a file without a delivery spec is an error (exit 2)"
    )
    fails.add_argument("--baseline", metavar="FILE", help="findings that are let through, as the server exports them")
    fails.add_argument(
        "--add-baseline", action="store_true", help=f"let through what is found now; kept in FILE, or {DEFAULT_NAME}"
    )

    fixed = parser.add_argument_group("what is put right")
    fixed.add_argument("--fix", action="store_true", help="names, sizes in headers and zero padding, in place")
    fixed.add_argument("--diff", action="store_true", help="show what --fix would change, and change nothing")

    kept = parser.add_argument_group("cache")
    kept.add_argument("--no-cache", action="store_true", help="judge every file, and remember no verdict")
    kept.add_argument("--cache-dir", metavar="DIR", help="where verdicts are cached")
    add_run(parser, FORMATS)


def run(options: argparse.Namespace) -> int:
    """Judge the files, put right what may be, and report on the rest."""
    from audio_checks.run import runner

    outputs = Outputs(options.format, FORMATS)
    if options.diff and options.format:
        raise UsageError("--diff shows what would change in place of a report; leave --format out")
    judging = _Judging(options)
    tasks = judging.tasks()
    entries = judging.entries(tasks)
    left = False
    if options.fix or options.diff:
        changes, left = _planned(judging, tasks, entries)
        if options.diff:
            _show(changes)
            exit_code = _exit_code(judging.with_set_checks(tasks, entries), options.fail_level)
            return max(exit_code, FOUND if changes or left else OK, OK if judging.complete else WRONG)
        done, stayed = _fix_in_place(changes)
        left = left or stayed
        tasks, entries = judging.again(tasks, entries, done)
    entries = judging.with_set_checks(tasks, entries)
    if options.add_baseline:
        entries = _let_through(entries, options)
    report = runner.report_on(entries, judging.specs, [task.spec for task in tasks if task.spec])
    if report.not_run:
        say(f"not run, because this version lacks them: {', '.join(report.not_run)}")
    outputs.write(lambda name, colour: reporters.judged_as(name, report, _style(options, colour=colour)))
    _offer_baseline(report, options)
    return max(_exit_code(entries, options.fail_level), FOUND if left else OK, OK if judging.complete else WRONG)


def _style(options: argparse.Namespace, *, colour: bool) -> reporters.Style:
    on_terminal = colour and sys.stdout.isatty()
    return reporters.Style(colour, options.fail_level, width() if on_terminal else None, summary=not options.quiet)


class _Judging:
    """One run over files: what they are judged by, and what is said of them."""

    def __init__(self, options: argparse.Namespace) -> None:
        begins = options.add_baseline and not Path(options.baseline or DEFAULT_NAME).exists()
        named = options.baseline or (DEFAULT_NAME if options.add_baseline else None)
        self._waived = read_baseline(named) if named and not begins else {}
        self._by_bytes = bool(self._waived) or options.add_baseline
        self._options = options
        self._finder = SpecFinder(options.spec)
        self.sound_list = named_list(options.sound_list) if options.sound_list else None
        self.complete = True  # False when sounds of the change are out of reach
        self.specs: list[DeliverySpec] = []
        self._spec_of: dict[str, DeliverySpec | None] = {}
        self._views: dict[tuple[int, str | None], DeliverySpec] = {}
        self._dry: dict[str, str] = {}  # stems by the files that they are judged with; game files have none
        self._stems: frozenset[str] = frozenset()

    def tasks(self) -> list["Task"]:
        """Return a task for every file that is meant, and say what is doubtful about the specs."""
        from audio_checks.run import runner

        options = self._options
        files = found_files(options, may_be_none=options.allow_empty, default=".")
        self._spec_of = {file.path: spec_for(file.path, self._finder, options) for file in files}
        if options.target is None:
            self._dry = dry_stems((file.path for file in files), self.sound_list)
            self._stems = frozenset(self._dry.values())
        if options.changed_since is not None:
            files = self._changed(files)
        specs = [self._spec_of[file.path] for file in files]
        self.specs = list({id(spec): spec for spec in specs if spec is not None}.values())
        for warning in dict.fromkeys(f"{spec.name}: {text}" for spec in self.specs for text in spec.warnings):
            note(warning)
        if None in specs:
            without = f"no delivery spec for {specs.count(None)} of {_files(len(specs))}"
            if options.require_spec:
                first = runner.printable_path(files[specs.index(None)].path)
                raise UsageError(
                    f"{without}, {first} the first: name one with --spec, or put {SPEC_NAMES[0]} above them"
                )
            note(f"{without}: only their structure is judged")
        tasks = [self._task(file.path, spec) for file, spec in zip(files, specs, strict=True)]
        if reasons := list(self._less_well(tasks)):
            note("; ".join(reasons))
        return tasks

    def _less_well(self, tasks: Sequence["Task"]) -> Iterator[str]:
        """Yield points judged less well because the run was not told more of the sounds."""
        by_spec = [task for task in tasks if task.spec is not None]
        if by_spec and self.sound_list is None:
            yield (
                "no sound list (--list): lengths, loops and variations of cues are not compared,"
                " and a name passes that no cue has"
            )
        if without := sum(task.spec is not None and task.spec.category is None for task in by_spec):
            yield (
                f"no category for {without} of {_files(len(by_spec))} (--category, the list, or [files] of the spec):"
                " the limits of no category hold, and judgements are at their most cautious"
            )

    def _task(self, path: str, spec: DeliverySpec | None) -> "Task":
        from audio_checks.run import runner

        if path in self._stems:
            return runner.Task(path)  # held to its structure alone
        return runner.task_for(
            path,
            spec,
            target=self._options.target,
            category=self._options.category,
            sound_list=self.sound_list,
            views=self._views,
            dry=self._dry.get(path),
            coded=True,
        )

    def _changed(self, files: list[Found]) -> list[Found]:
        """Return the files that the change touches; all, where it touches what they are judged by."""
        from audio_checks.run.changed_since import Changes, spec_files
        from audio_checks.run.runner import printable_path

        options = self._options
        changes = Changes(options.changed_since)
        shared = [Path(path) for path in (options.sound_list, options.baseline) if path and Path(path).exists()]
        of_all: dict[int, bool] = {}
        for spec in {id(spec): spec for spec in self._spec_of.values()}.values():
            rules = [*shared, *(spec_files(self._finder.file_of(spec)) if spec else ())]
            new = [rule for rule in rules if self._is_known(rule, changes) and changes.touch(rule)]
            of_all[id(spec)] = bool(new)
            for rule in new:
                note(f"{rule} differs from {options.changed_since}, so every file that it is about is judged")
        touched = [
            file
            for file in files
            if of_all[id(self._spec_of[file.path])]
            or any(changes.touch(path) for path in (file.path, self._dry.get(file.path)) if path)
        ]
        for folder in changes.absent_submodules(options.paths):
            say(
                f"{printable_path(folder)}: the submodule differs from {options.changed_since} and is not checked out,"
                " so its sounds were not judged: git submodule update --init --recursive"
            )
            self.complete = False
        for warning in changes.notes:
            note(printable(warning))
        if not touched and self.complete:
            note(f"nothing to judge: no audio differs from {options.changed_since}")
        return touched

    @staticmethod
    def _is_known(rule: Path, changes: "Changes") -> bool:
        """Return whether Git knows a file that sounds are judged by; say so where it does not."""
        if waived := changes.knows(rule):
            return waived
        note(f"{rule} is in no Git repository, so it is taken for unchanged")
        return waived

    def entries(self, tasks: Sequence["Task"]) -> list[FileReport]:
        """Return the report of each file: from the cache where nothing changed, checked again elsewhere."""
        entries = self._judged(tasks) if self._options.no_cache else self._recalled(tasks)
        if self._by_bytes:
            entries = [known_by_its_bytes(entry, task.path) for entry, task in zip(entries, tasks, strict=True)]
        return [with_waivers(entry, self._waived) for entry in entries]

    def again(
        self, tasks: list["Task"], entries: list[FileReport], renamed: dict[str, str]
    ) -> tuple[list["Task"], list[FileReport]]:
        """Judge the files again that were put right, under their names of now."""
        for old, new in renamed.items():
            self._spec_of[new] = self._spec_of[old]
        new_tasks = [
            self._task(renamed[task.path], self._spec_of[task.path]) if task.path in renamed else task for task in tasks
        ]
        fresh = iter(self.entries([new for old, new in zip(tasks, new_tasks, strict=True) if old.path in renamed]))
        return new_tasks, [
            next(fresh) if task.path in renamed else entry for task, entry in zip(tasks, entries, strict=True)
        ]

    def with_set_checks(self, tasks: Sequence["Task"], entries: Sequence[FileReport]) -> list[FileReport]:
        """Return the reports on the files, with the findings over all of them together."""
        from audio_checks.run import runner

        return [with_waivers(entry, self._waived) for entry in runner.with_set_checks(tasks, entries)]

    def _recalled(self, tasks: Sequence["Task"]) -> list[FileReport]:
        from audio_checks.run.cache import VerdictCache, default_folder

        options = self._options
        cache = VerdictCache(options.cache_dir or default_folder(), threads=options.jobs or CORES)
        if options.cache_dir and not cache.usable:
            note(f"{options.cache_dir}: verdicts cannot be kept there, so every file is judged")
        cached = cache.recall(tasks)
        unknown = [task for task, entry in zip(tasks, cached, strict=True) if entry is None]
        judged = self._judged(unknown)
        cache.remember(unknown, judged)
        cache.close()
        fresh = iter(judged)
        return [entry or next(fresh) for entry in cached]

    def _judged(self, tasks: Sequence["Task"]) -> list[FileReport]:
        from audio_checks.run import runner

        options = self._options
        jobs = process_count([task.path for task in tasks]) if options.jobs is None else options.jobs
        with progress_over(len(tasks), options) as progress:
            return runner.judge(list(tasks), jobs=jobs, done=lambda entry: progress.step(entry.path))


def _planned(judging: _Judging, tasks: Sequence["Task"], entries: Sequence[FileReport]) -> tuple[list["Change"], bool]:
    """Return the possible fixes; name faults without a fix, and whether there are any."""
    from audio_checks.fixing.in_place import CannotFixInPlace, Repairs

    repairs, left = Repairs(judging.sound_list), False
    changes: list[Change] = []
    for task, entry in zip(tasks, entries, strict=True):
        try:
            change = repairs.planned(task, entry)
        except CannotFixInPlace as error:
            say(f"{entry.path}: left as it is: {error}")
            left = True
        else:
            changes += [change] if change else []
    return changes, left


def _show(changes: Sequence["Change"]) -> None:
    """Print the fixes that would be made."""
    from audio_checks.fixing.in_place import shown

    ink = Ink(in_colour(sys.stdout))
    colours = {"": BOLD, "-": RED, "+": GREEN}
    for sign, words in shown(changes):
        print(ink(printable(f"  {sign} {words}" if sign else words), colours[sign]))
    print(f"{_files(len(changes))} would be put right; nothing was changed" if changes else "nothing to put right")


def _fix_in_place(changes: Sequence["Change"]) -> tuple[dict[str, str], bool]:
    """Make the changes; return the new path of each changed file, and whether one could not be changed."""
    from audio_checks.fixing.in_place import CannotFixInPlace, fix_in_place
    from audio_checks.run.runner import printable_path

    done: dict[str, str] = {}
    for change in changes:
        try:
            fix_in_place(change)
        except CannotFixInPlace as error:
            say(f"{printable_path(change.path)}: left as it is: {error}")
        else:
            done[change.path] = change.new_path
            new_name = (
                [] if change.new_path == change.path else [f"renamed to {printable_path(Path(change.new_path).name)}"]
            )
            note(f"{printable_path(change.path)}: {'; '.join([*new_name, *change.header])}")
    return done, len(done) < len(changes)


def _let_through(entries: list[FileReport], options: argparse.Namespace) -> list[FileReport]:
    """Write down what was found, so that it counts no more."""
    baseline_path = options.baseline or DEFAULT_NAME
    added = add_to_baseline(baseline_path, entries)
    note(
        f"{baseline_path}: {counted(added, 'finding')} let through from now on; read it with --baseline {baseline_path}"
    )
    waived = read_baseline(baseline_path)
    return [with_waivers(entry, waived) for entry in entries]


def _offer_baseline(report: Report, options: argparse.Namespace) -> None:
    """Explain at a first run over a large tree how to check only new files."""
    failing = sum(_fails(entry, options.fail_level) for entry in report.files)
    if failing >= MANY_FAILING and not options.baseline:
        note(
            f"{_files(failing)} at once is much to fix: with --add-baseline this run lets through what is there"
            " already, and only what is new fails from then on"
        )


def _fails(entry: FileReport, fail_level: str) -> bool:
    levels = reporters.Style(fail_level="warning" if fail_level == "warning" else "error").failing
    return any(entry.count(level, waived=False) for level in levels)


def _exit_code(entries: Sequence[FileReport], fail_level: str) -> int:
    """Return 0, 1 for unwaived findings at or above the level, or 2 for a check that broke."""
    if any(entry.verdict == "unjudged" for entry in entries):
        return WRONG
    return FOUND if any(_fails(entry, fail_level) for entry in entries) else OK


def _files(count: int) -> str:
    return counted(count, "file")
