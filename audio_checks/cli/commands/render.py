"""`audio-checks render`: game files from masters."""

from __future__ import annotations

import argparse
import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from audio_checks.cli.arguments import (
    FOUND,
    OK,
    UsageError,
    add_fail_level,
    add_paths,
    add_run,
    add_spec,
    found_files,
    needed_spec_for,
    out_folder,
    progress_over,
)
from audio_checks.cli.named_list import named_list
from audio_checks.cli.outputs import Outputs
from audio_checks.report.findings import printable
from audio_checks.run.discovery import SpecFinder, without_dry_stems
from audio_checks.run.workload import process_count

if TYPE_CHECKING:
    from audio_checks.render.files import Outcome

FORMATS = ("text", "json")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take masters, a spec, targets and a folder."""
    add_paths(parser)
    add_spec(parser)
    parser.add_argument("--target", metavar="NAME", action="append", help="only this target; may be repeated")
    parser.add_argument("--out", metavar="DIR", required=True, help="renders go to DIR/TARGET/relative path")
    parser.add_argument("--replace", action="store_true", help="let a game file that differs replace an earlier one")
    add_fail_level(parser, "what makes the exit code 1: what is refused, or what is made with a warning too")
    add_run(parser, FORMATS)


def run(options: argparse.Namespace) -> int:
    """Render every master to every target, and say what was made or refused."""
    from audio_checks.render.files import RenderRun
    from audio_checks.run import runner

    outputs = Outputs(options.format, FORMATS)
    finder = SpecFinder(options.spec)
    sound_list = named_list(options.sound_list) if options.sound_list else None
    files = without_dry_stems(found_files(options), sound_list)
    tasks, targets_of = [], []
    for file in files:
        spec = needed_spec_for(file.path, finder, options)
        targets = options.target or list(spec.targets)
        if not targets:
            raise UsageError(f"{finder.file_of(spec)}: the spec names no targets")
        for target in targets:
            task = runner.task_for(file.path, spec, target=target, category=options.category, sound_list=sound_list)
            tasks.append((task, file.relative))
            targets_of.append(target)
    run = RenderRun(out_folder(options), replaces=options.replace)
    jobs = process_count([task.path for task, _ in tasks]) if options.jobs is None else options.jobs
    with progress_over(len(tasks), options) as progress:
        outcomes = run.render_all(
            tasks,
            jobs=jobs,
            done=lambda outcome: progress.step(str(outcome.rendered.path if outcome.rendered else outcome.refusal)),
        )
    results = [
        _Result(runner.printable_path(task.path), target, outcome)
        for (task, _), target, outcome in zip(tasks, targets_of, outcomes, strict=True)
    ]
    outputs.write(
        lambda name, _: (
            f"{json.dumps({'renders': [outcome.to_dict() for outcome in results]}, indent=1)}\n"
            if name == "json"
            else "".join(
                f"{printable(outcome.line)}\n" for outcome in results if outcome.is_worth_saying or not options.quiet
            )
        )
    )
    return FOUND if any(outcome.fails(options.fail_level) for outcome in results) else OK


@dataclass(frozen=True)
class _Result:
    """The statement on one render."""

    master: str
    target: str
    outcome: Outcome

    @property
    def is_worth_saying(self) -> bool:
        """Whether a quiet run says it: what was refused, or made with a warning."""
        return self.outcome.rendered is None or bool(self.outcome.rendered.warnings)

    @property
    def line(self) -> str:
        """Return the render, or the obstacle, in one line."""
        rendered, refusal = self.outcome.rendered, self.outcome.refusal
        if rendered is None:
            return f"{self.master} -> {self.target}: refused: {refusal}; {refusal.fix if refusal else ''}"
        from audio_checks.render.files import in_words

        same = "" if self.outcome.is_new else "; as before"
        return f"{self.master} -> {self.target}: {rendered.path}, {in_words(rendered)}{same}"

    def to_dict(self) -> dict[str, Any]:
        """Return the entry of the JSON document."""
        from audio_checks.run.runner import printable_path

        entry: dict[str, Any] = {"master": self.master, "target": self.target}
        if (rendered := self.outcome.rendered) is not None:
            return entry | {"path": printable_path(rendered.path), "is_new": self.outcome.is_new, **rendered.to_dict()}
        if (refusal := self.outcome.refusal) is not None:
            entry["refused"] = {"code": refusal.code, "message": str(refusal), "fix": refusal.fix}
        return entry

    def fails(self, level: str) -> bool:
        """Whether this makes the exit code 1."""
        if self.outcome.rendered is None:
            return True
        return level == "warning" and bool(self.outcome.rendered.warnings)
