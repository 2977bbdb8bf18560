"""`audio-checks render`: game files from masters."""

import argparse
import json
from pathlib import Path
from typing import Any

from audio_checks.arguments import FOUND, OK, UsageError, add_paths, add_spec, found_files, spec_for
from audio_checks.discovery import SpecFinder, without_dry_stems
from audio_checks.errors import RenderRefused, Unreadable
from audio_checks.findings import printable
from audio_checks.sound_list import read_sound_list


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take masters, a spec, targets and a folder."""
    add_paths(parser)
    add_spec(parser)
    parser.add_argument("--target", metavar="NAME", action="append", help="only this target; may be repeated")
    parser.add_argument("--out", metavar="DIR", required=True, help="renders go to DIR/TARGET/relative path")
    parser.add_argument("--replace", action="store_true", help="let a game file that differs replace an earlier one")
    parser.add_argument("--format", choices=("text", "json"), default="text", help="text, or the loss reports as JSON")


def run(options: argparse.Namespace) -> int:
    """Render every master to every target, and say what was made or refused."""
    from audio_checks import runner
    from audio_checks.render_files import RenderRun, in_words

    if options.spec is None:
        raise UsageError("renders are made to the targets of a spec: name it with --spec")
    finder = SpecFinder(options.spec)
    sound_list = read_sound_list(Path(options.sound_list)) if options.sound_list else None
    found = without_dry_stems(found_files(options), sound_list)
    run, code = RenderRun(options.out, replaces=options.replace), OK
    told: list[dict[str, Any]] = []
    for one in found:
        spec = spec_for(one.path, finder, options)
        targets = options.target or list(spec.targets if spec else ())
        if spec is None or not targets:
            raise UsageError(f"{options.spec}: the spec names no targets")
        for target in targets:
            task = runner.task_for(one.path, spec, target=target, category=options.category, sound_list=sound_list)
            entry: dict[str, Any] = {"master": runner.legible(one.path), "target": target}
            try:
                rendered, is_new = run.render(task, one.relative)
                entry |= {"path": runner.legible(rendered.path), "is_new": is_new, **rendered.to_dict()}
                line = f"{rendered.path}, {in_words(rendered)}{'' if is_new else '; as before'}"
            except (RenderRefused, Unreadable) as error:
                entry["refused"] = {"code": error.code, "message": str(error), "fix": error.fix}
                line, code = f"refused: {error}; {error.fix}", FOUND
            told.append(entry)
            if options.format == "text":
                print(printable(f"{entry['master']} -> {target}: {line}"))
    if options.format == "json":
        print(json.dumps({"renders": told}, indent=1))
    return code
