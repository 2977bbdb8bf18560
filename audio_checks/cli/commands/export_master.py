"""`audio-checks export-master`: masters handed out with what is known of them."""

import argparse
import json
from pathlib import Path
from typing import Any

from audio_checks.cli.arguments import FOUND, OK, UsageError, add_paths, add_run, found_files, out_folder, progress_over
from audio_checks.cli.named_list import named_list
from audio_checks.cli.outputs import Outputs
from audio_checks.errors import RenderRefused, Unreadable
from audio_checks.report.findings import printable
from audio_checks.run.discovery import Found
from audio_checks.spec.delivery_spec import CueFacts
from audio_checks.spec.sound_list import SoundList

FORMATS = ("text", "json")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take masters, what is known of them, and a folder."""
    add_paths(parser)
    parser.add_argument("--out", metavar="DIR", required=True, help="copies go to DIR/relative path")
    parser.add_argument("--list", metavar="CSV", dest="sound_list", help="sound list: number, name and use of each cue")
    parser.add_argument("--project", metavar="NAME", default="", help="what they were made for")
    parser.add_argument("--studio", metavar="NAME", default="", help="whose game it is")
    parser.add_argument("--originator", metavar="NAME", default="", help="who made them")
    parser.add_argument("--made-on", metavar="DAY", default="", help="when, as in 2026-11-21")
    parser.add_argument(
        "--field", metavar="NAME=TEXT", action="append", default=[], help="one more field of ASWG-G006; may be repeated"
    )
    add_run(parser, FORMATS, jobs=False)


def run(options: argparse.Namespace) -> int:
    """Copy every master with its provenance, and say what was refused."""
    from audio_checks.run import runner

    fields = {}
    for field in options.field:
        name, equals, text = field.partition("=")
        if not equals:
            raise UsageError(f'--field wants NAME=TEXT, as in catId=GUNAuto, not "{field}"')
        fields[name] = text
    sound_list = named_list(options.sound_list) if options.sound_list else None
    outputs, folder = Outputs(options.format, FORMATS), out_folder(options)
    files = found_files(options)
    exports: list[dict[str, Any]] = []
    with progress_over(len(files), options) as progress:
        for file in files:
            exports.append(
                {"master": runner.printable_path(file.path)} | _exported(file, folder, sound_list, fields, options)
            )
            progress.step(file.relative)
    outputs.write(lambda name, _: _as(name, exports, quiet=options.quiet))
    return FOUND if any("refused" in export for export in exports) else OK


def _exported(
    file: Found, folder: Path, sound_list: SoundList | None, fields: dict[str, str], options: argparse.Namespace
) -> dict[str, Any]:
    """Copy one master, and return what happened to it."""
    from audio_checks.render.provenance import Provenance, export_master
    from audio_checks.run import runner

    slot = sound_list.slot_of_file(file.path) if sound_list else None
    cue = slot[0] if slot else CueFacts("")
    looped = {"isLoop": "true"} if cue.loop else {}
    try:
        provenance = Provenance(
            project=options.project,
            studio=options.studio,
            originator=options.originator,
            number=cue.number,
            name=cue.name,
            notes=cue.more.get("description", ""),
            made_on=options.made_on,
            fields=looped | fields,
        )
    except ValueError as error:
        raise UsageError(str(error)) from None
    out = folder / Path(file.relative).with_suffix(".wav")
    out.parent.mkdir(parents=True, exist_ok=True)
    try:
        exported = export_master(file.path, out, provenance)
    except (RenderRefused, Unreadable) as error:
        return {"refused": {"code": error.code, "message": str(error), "fix": error.fix}}
    return {"path": runner.printable_path(exported.path), "left": list(exported.left)}


def _as(name: str, exports: list[dict[str, Any]], *, quiet: bool) -> str:
    if name == "json":
        return f"{json.dumps({'masters': exports}, indent=1)}\n"
    lines = []
    for export in exports:
        if refused := export.get("refused"):
            lines.append(f"{export['master']} -> refused: {refused['message']}; {refused['fix']}")
        elif export["left"] or not quiet:
            lines.append(f"{export['master']} -> {'; '.join([export['path'], *export['left']])}")
    return "".join(f"{printable(line)}\n" for line in lines)
