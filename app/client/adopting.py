"""`soundlist adopt`: sends a folder of shipped sounds, and prints what happens to each file."""

import argparse
import hashlib
import os
import zipfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from app.client.errors import DONE, Refusal
from app.client.game_project import packed_project
from app.client.headers import HEAD_BYTES, format_of
from app.client.server import Server
from app.client.settings import read_source
from app.client.terminal import Progress, counted, say, shown
from app.client.zipped import unpacked

SOUNDS = frozenset(
    {".wav", ".wave", ".bwf", ".flac", ".aif", ".aiff", ".aifc", ".caf", ".w64"}
    | {".ogg", ".oga", ".opus", ".mp3", ".m4a", ".wma"}
)
MAX_FILES = 10_000
SENT_AT_ONCE = 4
SHOWN = 20  # lines of each kind
BLOCK_BYTES = 1 << 20


def adopt(options: argparse.Namespace) -> int:
    """Send a folder or a ZIP, or say with `--dry-run` what would happen to it; return the exit code."""
    named: Path = options.folder
    if named.is_dir():
        return _adopt(named.resolve(), named.resolve(), options)
    if not zipfile.is_zipfile(named):
        raise Refusal(f"{named} is neither a folder nor a ZIP; name the one that holds the game's sounds")
    with unpacked(named, SOUNDS, MAX_FILES) as root:
        return _adopt(root, named.resolve().parent, options)


def _adopt(root: Path, settings: Path, options: argparse.Namespace) -> int:
    """Send a folder's contents, by the settings that are in another one or above it."""
    source = read_source(
        settings, None, server=options.server, project=options.project, target=None, allow_http=options.allow_http
    )
    files = {path: root / path for path in _sounds(root)}
    if not files:
        raise Refusal(f"{root} holds no sounds")
    if len(files) > MAX_FILES:
        raise Refusal(f"{root} holds {len(files):,} sounds; adopt folders with at most {MAX_FILES:,}, one by one")
    with ThreadPoolExecutor(SENT_AT_ONCE) as pool:
        listed = list(pool.map(lambda item: _listed(*item), files.items()))
    body: dict[str, Any] = {"folder": root.name or "Sounds", "files": listed}
    if options.game_project is not None:
        body["project"] = packed_project(options.game_project)
    server = Server(source)
    if options.dry_run:
        _print_plan(server.send_to_project("adoption-plan", body))
        say("Nothing was sent.")
        return DONE
    opened = server.send_to_project("adoptions", body)
    _print_plan(opened["plan"])
    sent = _send(server, opened, files)
    say(f"{counted(sent, 'file was', 'files were')} sent. A producer or the approver adopts them here:")
    say(f"{source.server}/projects/{source.project}/sound-list/adopt?adoption={opened['id']}")
    return DONE


def _sounds(root: Path) -> Iterator[str]:
    """Yield the paths of sounds, with slashes; hidden files and what links lead to are left out."""
    for folder, names, files in os.walk(root):
        names[:] = sorted(name for name in names if not name.startswith("."))
        for name in sorted(files):
            path = Path(folder, name)
            if path.suffix.lower() in SOUNDS and not name.startswith(".") and not path.is_symlink():
                yield path.relative_to(root).as_posix()


def _listed(path: str, file_path: Path) -> dict[str, Any]:
    digest, size = hashlib.sha256(), 0
    with file_path.open("rb") as file:
        head = file.read(HEAD_BYTES)
        block = head
        while block:
            digest.update(block)
            size += len(block)
            block = file.read(BLOCK_BYTES)
    return {"path": path, "sha256": digest.hexdigest(), "size_bytes": size, **format_of(head)._asdict()}


def _send(server: Server, opened: dict[str, Any], files: dict[str, Path]) -> int:
    """Send the files that the server does not have yet; return their number."""
    missing = [path for path in opened["missing"] if path in files]
    progress = Progress(len(missing), sum(files[path].stat().st_size for path in missing))

    def send(path: str) -> None:
        content = files[path].read_bytes()
        server.upload(content, {"adoption_id": opened["id"], "file_name": path.rpartition("/")[2]})
        progress.add_bytes(len(content))
        progress.add_file()

    try:
        with ThreadPoolExecutor(SENT_AT_ONCE) as pool:
            list(pool.map(send, missing))
    finally:
        progress.end()
    return len(missing)


def _print_plan(plan: dict[str, Any]) -> None:
    categories = plan["categories"]
    say(
        f"{counted(plan['files'], 'file')} {'becomes' if plan['files'] == 1 else 'become'} "
        f"{counted(len(plan['cues']), 'cue')} in {counted(len(categories), 'category', 'categories')}, "
        f"{plan['sets']} of them {'a set' if plan['sets'] == 1 else 'sets'}"
    )
    for name, count in categories.items():
        say(f"  {shown(name) or 'no category':<24}  {count}")
    if (project := plan.get("project")) is not None:
        say(f"{shown(project['name'])} plays {project['played']} of them")
        _print_files("of the project, not read", [(path, "") for path in project["unread"]])
    _print_files("unusual", [(oddity["path"], oddity["message"]) for oddity in plan["oddities"]])
    _print_files("the same bytes", [(paths[0], "also " + ", ".join(paths[1:])) for paths in plan["duplicates"]])
    _print_files("not adopted", [(skipped["path"], skipped["message"]) for skipped in plan["skipped"]])


def _print_files(head: str, remarks: list[tuple[str, str]]) -> None:
    if not remarks:
        return
    say(f"{head}: {len(remarks)}")
    for path, message in remarks[:SHOWN]:
        say(f"  {shown(path)}: {shown(message)}")
    if len(remarks) > SHOWN:
        say(f"  and {len(remarks) - SHOWN} more")
