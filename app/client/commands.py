"""The commands of the client and their options."""

import argparse
import io
import sys
from collections.abc import Sequence
from pathlib import Path

from app.client import ci, desk
from app.client.adopting import adopt
from app.client.errors import REFUSED, UNREACHABLE, Refusal, ServerUnreachable
from app.client.fmod_studio import PORT, import_in_studio
from app.client.pulling import pull
from app.client.terminal import shown, warn
from app.client.why import why

INTERRUPTED = 130
CODES = """exit codes:
  0  the folder is as approved
  1  it is not: files were kept, failed or would change, or --no-placeholders refuses
  2  asked wrongly, the lock file is damaged, or the server refuses
  3  the server cannot be reached; what is here was compared with the lock file
"""
CI_CODES = """exit codes, as those of audio-checks:
  0  everything conforms, and is as approved
  1  something was found at or above --fail-level, or differs from what was approved
  2  asked wrongly, audio-checks is missing or failed, or the server refuses or cannot be reached
"""
DESK_CODES = """exit codes:
  0  every server answered
  2  asked wrongly, or a server refuses the token; the rest is shown
  3  a server cannot be reached; the rest is shown
"""


def main(arguments: Sequence[str]) -> int:
    """Run a command of the client; return the exit code."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # a console may lack letters of a cue's name
            stream.reconfigure(errors="backslashreplace")
    options = parser().parse_args(arguments)
    try:
        code: int = options.run(options)
        return code
    except Refusal as refusal:
        warn(f"soundlist {options.command}: {shown(str(refusal))}")
        return REFUSED
    except ServerUnreachable as error:
        what = "FMOD Studio" if options.command == "fmod" else "the server"
        warn(f"soundlist {options.command}: {what} cannot be reached: {shown(str(error))}")
        return UNREACHABLE
    except OSError as error:
        where = f"{error.filename}: " if error.filename else ""
        warn(f"soundlist {options.command}: {shown(str(where))}{error.strerror or error}")
        return REFUSED
    except KeyboardInterrupt:
        warn("interrupted; downloads go on from here when you pull again")
        return INTERRUPTED


def parser() -> argparse.ArgumentParser:
    """Return the parser of the commands."""
    whole = argparse.ArgumentParser(prog="soundlist", allow_abbrev=False)
    commands = whole.add_subparsers(dest="command", required=True)
    pulling = commands.add_parser(
        "pull",
        help="write the approved sounds that changed into a folder of the game",
        description="Write the approved sounds that changed into a folder of the game.",
        epilog=CODES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    pulling.set_defaults(run=pull)
    pulling.add_argument("folder", nargs="?", type=Path, default=Path(), help="the folder; this one if left out")
    _add_source(pulling)
    pulling.add_argument("--no-placeholders", action="store_true", help="the release gate: refuse while one is left")
    pulling.add_argument("--prune", action="store_true", help="remove pulled files that are no longer approved")
    pulling.add_argument("--force", action="store_true", help="overwrite files that were changed here")
    pulling.add_argument("--dry-run", action="store_true", help="print what would be done, and change nothing")
    pulling.add_argument("--p4", action="store_true", help="open files in Perforce for edit, add and delete")
    pulling.add_argument("--lfs-lock", action="store_true", help="lock files that change in Git LFS")
    pulling.add_argument(
        "--changelist", action="store_true", help="draft a description with the cues; with --p4, make the changelist"
    )
    adopting = commands.add_parser(
        "adopt",
        help="send a folder of shipped sounds, to become cues with approved takes",
        description="Send a folder of shipped sounds. A producer or the approver then adopts it on the page that is "
        "printed, and each sound becomes an approved take of a cue.",
        allow_abbrev=False,
    )
    adopting.set_defaults(run=adopt, target=None)
    adopting.add_argument("folder", type=Path, help="the folder, or a ZIP, of the game's sounds")
    adopting.add_argument("--server", metavar="URL", help="the server; else as soundlist.toml says")
    adopting.add_argument("--project", metavar="ID", help="the project; else as soundlist.toml says")
    adopting.add_argument(
        "--game-project",
        type=Path,
        metavar="PATH",
        help="what plays the sounds: a .wproj, a .fspro, the folder of a Unity project, a project.godot, or what "
        "export_sounds.py wrote in Unreal; its texts are sent",
    )
    adopting.add_argument("--allow-http", action="store_true", help="send the token unencrypted to another machine")
    adopting.add_argument("--dry-run", action="store_true", help="print what would happen to each file; send no sound")
    importing = commands.add_parser(
        "fmod",
        help="have the FMOD Studio that runs on this machine import an unpacked pack",
        description="Have the FMOD Studio that runs on this machine import the pack that is unpacked beside its "
        "project. It wants the script server of FMOD Studio, which Preferences, Interface switches on.",
        allow_abbrev=False,
    )
    importing.set_defaults(run=import_in_studio)
    importing.add_argument("folder", nargs="?", type=Path, default=Path(), help="of the .fspro; this one if left out")
    importing.add_argument("--port", type=int, default=PORT, help=f"of the script server; {PORT} if left out")
    building = commands.add_parser(
        "ci",
        help="check and audit a game's sounds as its CI does, and post the reports",
        description="Check a game's sounds by the project's spec, sound list and baseline, compare them with what was "
        "approved, and post both reports. audio-checks, which must be installed, does the judging.",
        epilog=CI_CODES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    building.set_defaults(run=ci.run_ci)
    ci.add_arguments(building)
    _add_source(building)
    asking = commands.add_parser(
        "why",
        help="say which cue, approval, contract and sources a file has",
        description="Say which cue, approval, contract and sources a file has.",
        allow_abbrev=False,
    )
    asking.set_defaults(run=why)
    asking.add_argument("name", metavar="FILE_OR_NAME", help="a file, its name with or without its ending, or a cue")
    asking.add_argument("--folder", type=Path, help="the folder that was pulled into; this one or one above it")
    _add_source(asking)
    asking.add_argument("--offline", action="store_true", help="ask the lock file alone")
    asking.add_argument("--format", choices=("text", "json"), default="text", help="text, or JSON for programs")
    _add_desk(commands)
    return whole


def _add_desk(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    desk_parser = commands.add_parser(
        "desk",
        help="list what you owe on all servers, what is due soonest first",
        description="List what you owe as a sound designer on all servers, what is due soonest first.",
        epilog=DESK_CODES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    desk_parser.set_defaults(run=desk.desk)
    how = desk_parser.add_mutually_exclusive_group()
    how.add_argument("--format", choices=("text", "json"), default="text", help="a table, or JSON for programs")
    how.add_argument(
        "--page", nargs="?", const="", metavar="FILE", help="a page in one file, opened; with FILE it is written there"
    )
    desk_parser.add_argument("--server", metavar="NAME", help="only this server")
    actions = desk_parser.add_subparsers(dest="action")
    adding = actions.add_parser("add", help="keep a server with your token", allow_abbrev=False)
    adding.set_defaults(run=desk.add)
    adding.add_argument("address", metavar="URL", help="https://…; the token is asked for, or comes by SOUNDLIST_TOKEN")
    adding.add_argument("--name", help="what to call it; its host if left out")
    actions.add_parser("list", help="list the servers", allow_abbrev=False).set_defaults(run=desk.list_servers)
    removing = actions.add_parser("remove", help="forget a server and its token", allow_abbrev=False)
    removing.set_defaults(run=desk.remove)
    removing.add_argument("name", metavar="NAME")


def _add_source(command: argparse.ArgumentParser) -> None:
    command.add_argument("--server", metavar="URL", help="the server; else as soundlist.toml says")
    command.add_argument("--project", metavar="ID", help="the project; else as soundlist.toml or the lock file says")
    command.add_argument("--target", metavar="NAME", help="the render target; else the first of the spec")
    command.add_argument("--allow-http", action="store_true", help="send the token unencrypted to another machine")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
