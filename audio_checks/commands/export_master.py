"""`audio-checks export-master`: masters handed out with what is known of them."""

import argparse
import os
from pathlib import Path

from audio_checks.arguments import FOUND, OK, UsageError, add_paths, found_files
from audio_checks.errors import RenderRefused, Unreadable
from audio_checks.findings import printable
from audio_checks.sound_list import read_sound_list
from audio_checks.spec import CueFacts


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


def run(options: argparse.Namespace) -> int:
    """Copy every master with its provenance, and say what was refused."""
    from audio_checks import runner
    from audio_checks.provenance import Provenance, export_master

    fields = {}
    for one in options.field:
        name, equals, text = one.partition("=")
        if not equals:
            raise UsageError(f'--field wants NAME=TEXT, as in catId=GUNAuto, not "{one}"')
        fields[name] = text
    sound_list = read_sound_list(Path(options.sound_list)) if options.sound_list else None
    code = OK
    for one in found_files(options):
        slot = sound_list.slot_of_file(one.path) if sound_list else None
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
        out = Path(options.out, Path(one.relative).with_suffix(".wav"))
        out.parent.mkdir(parents=True, exist_ok=True)
        try:
            exported = export_master(one.path, out, provenance)
            line = "; ".join([os.fspath(exported.path), *exported.left])
        except (RenderRefused, Unreadable) as error:
            line, code = f"refused: {error}; {error.fix}", FOUND
        print(printable(f"{runner.legible(one.path)} -> {line}"))
    return code
