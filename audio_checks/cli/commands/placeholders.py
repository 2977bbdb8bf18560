"""`audio-checks placeholders`: placeholders for the cues of a sound list that have no take yet."""

from __future__ import annotations

import argparse
import json
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING

from audio_checks.cli.arguments import FOUND, OK, UsageError, add_paths, add_run, found_files, out_folder, progress_over
from audio_checks.cli.named_list import named_list
from audio_checks.cli.outputs import Outputs
from audio_checks.errors import RenderRefused, Unreadable
from audio_checks.report.findings import printable
from audio_checks.spec.delivery_spec import load_spec
from audio_checks.spec.sound_names import parse_file_name
from audio_checks.system.plural import counted

if TYPE_CHECKING:
    from audio_checks.placeholders.make import Placeholder

FORMATS = ("text", "json")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take a sound list, a spec, a folder, and where the takes are."""
    add_paths(parser)
    parser.add_argument("--list", metavar="CSV", dest="sound_list", required=True, help="sound list")
    parser.add_argument("--spec", metavar="FILE", required=True, help="delivery spec that they keep to")
    parser.add_argument(
        "--target", metavar="NAME", action="append", help="game files of this target, in DIR/NAME; may be repeated"
    )
    parser.add_argument("--out", metavar="DIR", required=True, help="where they go")
    parser.add_argument("--no-voice", action="store_true", help="patterns only, even where espeak-ng is installed")
    add_run(parser, FORMATS, jobs=False)


def run(options: argparse.Namespace) -> int:
    """Make a placeholder file for each cue without a take among the paths, and list them."""
    from audio_checks.placeholders.make import make_placeholders

    spec = load_spec(options.spec)
    sound_list = named_list(options.sound_list)
    given = options.paths or options.files_from is not None
    files = found_files(options, may_be_none=True) if given else []
    taken = {
        parse_file_name(sound_list.listed_name(file.path)).stem for file in files if not _is_placeholder(file.path)
    }
    for target in options.target or ():
        if target not in spec.targets:
            raise UsageError(f'no target "{target}"; targets of the spec: {", ".join(spec.targets) or "none"}')
    out, outputs = out_folder(options), Outputs(options.format, FORMATS)
    names = options.target or [None]
    results: list[Placeholder | RenderRefused] = []
    with progress_over(len(names) * len(sound_list.cues), options) as progress:
        for target in names:
            folder = out / target if target else out
            for make_placeholder in make_placeholders(
                sound_list, spec, folder, target=target, taken=taken, voice=not options.no_voice
            ):
                results.append(make_placeholder)
                progress.step("" if isinstance(make_placeholder, RenderRefused) else str(make_placeholder.path))
    outputs.write(lambda name, _: _as(name, results, len(taken), quiet=options.quiet))
    return FOUND if any(isinstance(outcome, RenderRefused) for outcome in results) else OK


def _as(name: str, results: Sequence[Placeholder | RenderRefused], taken: int, *, quiet: bool) -> str:
    made = [placeholder for placeholder in results if not isinstance(placeholder, RenderRefused)]
    refused = [refusal for refusal in results if isinstance(refusal, RenderRefused)]
    if name == "json":
        document = {
            "placeholders": [{**vars(placeholder), "path": os.fspath(placeholder.path)} for placeholder in made],
            "refused": [{"code": refusal.code, "message": str(refusal), "fix": refusal.fix} for refusal in refused],
            "taken": taken,
        }
        return f"{json.dumps(document, indent=1)}\n"
    lines = []
    for outcome in results:
        if isinstance(outcome, RenderRefused):
            lines.append(f"refused: {outcome}; {outcome.fix}")
        elif not quiet:
            what = "synthesize_speech" if outcome.is_spoken else "a pattern"
            lines.append(
                f"{outcome.number} -> {outcome.path}: {what}, {outcome.duration_s:.3f} s"
                f"{'' if outcome.is_new else ', as before'}"
            )
    if not quiet:
        lines.append(f"{counted(len(made), 'placeholder')}; {counted(taken, 'take needs', 'takes need')} none")
    return "".join(f"{printable(line)}\n" for line in lines)


def _is_placeholder(path: str) -> bool:
    from audio_checks.run.runner import is_placeholder

    try:
        return is_placeholder(path)
    except Unreadable:
        return False
