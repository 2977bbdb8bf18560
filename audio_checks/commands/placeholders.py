"""`audio-checks placeholders`: stand-ins for the cues of a sound list that have no take yet."""

import argparse
from pathlib import Path

from audio_checks.arguments import FOUND, OK, UsageError, add_paths, found_files
from audio_checks.errors import RenderRefused, Unreadable
from audio_checks.findings import printable
from audio_checks.sound_list import parse_file_name, read_sound_list
from audio_checks.spec import load_spec


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


def run(options: argparse.Namespace) -> int:
    """Make a stand-in for each cue without a take among the paths, and say what stands in for what."""
    from audio_checks.placeholders.make import make_placeholders

    spec = load_spec(options.spec)
    sound_list = read_sound_list(Path(options.sound_list))
    given = options.paths or options.files_from is not None
    found = found_files(options, may_be_none=True) if given else []
    taken = {parse_file_name(one.path).stem for one in found if not _is_stand_in(one.path)}
    for target in options.target or ():
        if target not in spec.targets:
            raise UsageError(f'no target "{target}"; targets of the spec: {", ".join(spec.targets) or "none"}')
    made, code = 0, OK
    for target in options.target or [None]:
        folder = Path(options.out, target) if target else Path(options.out)
        for one in make_placeholders(sound_list, spec, folder, target=target, taken=taken, voice=not options.no_voice):
            if isinstance(one, RenderRefused):
                print(printable(f"refused: {one}; {one.fix}"))
                code = FOUND
                continue
            made += 1
            what = "spoken" if one.is_spoken else "a pattern"
            news = "" if one.is_new else ", as before"
            print(printable(f"{one.number} -> {one.path}: {what}, {one.duration_s:.3f} s{news}"))
    waiting = "stand-in" if made == 1 else "stand-ins"
    print(f"{made} {waiting}; {len(taken)} takes need none")
    return code


def _is_stand_in(path: str) -> bool:
    from audio_checks.runner import is_placeholder

    try:
        return is_placeholder(path)
    except Unreadable:
        return False
