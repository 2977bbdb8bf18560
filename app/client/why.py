"""`soundlist why`: which cue a file is for, who approved it, which contract pays it, and what it was made from."""

import argparse
import json
from pathlib import Path
from typing import Any

from app.client.errors import DONE, NOT_AS_APPROVED, UNREACHABLE, Refusal, ServerUnreachable
from app.client.lock import Entry, Lock, matching, read_lock
from app.client.paths import LOCK_NAME, content_sha256, place_of
from app.client.server import Server
from app.client.settings import read_source
from app.client.terminal import say, shown, warn

FORMAT = 1
ONLINE = {  # what only the server knows, in the order that it is shown
    "cue_name": "cue",
    "approved_by": "approved by",
    "approved_on": "approved on",
    "contract": "contract",
    "designer": "designer",
    "libraries": "libraries and licences",
    "own_recordings": "own recordings",
    "from_scratch": "from scratch",
    "generated": "generated",
    "performers": "performers",
    "note": "note on sources",
    "open_points": "open points",
    "spec_version": "delivery spec",
    "version": "version of the sound",
    "master": "master",
    "is_current": "accepted now",
}
IN_FOLDER = {None: "not in the folder", True: "as it was pulled", False: "changed since it was pulled"}


def why(options: argparse.Namespace) -> int:
    """Print the origin of a file; return the exit code."""
    folder, name = _folder_and_name(options.folder, options.name)
    root = next((parent for parent in (folder, *folder.parents) if (parent / LOCK_NAME).is_file()), None)
    lock = read_lock(root) if root else None
    entries = _entries(root, lock, name)
    items = [_from_lock(root, lock, entry) for entry in entries] if root and lock else []
    sounds, problem = ([], "--offline was given") if options.offline else _ask(options, folder, lock, entries, name)
    if isinstance(sounds, Refusal):
        raise sounds
    if items and sounds:
        items = [item | origin for item, origin in zip(items, sounds, strict=True)]
    items = items or sounds
    if not items and not problem:
        raise Refusal(f'no approved file is called "{name}"')
    _report(items, problem, as_json=options.format == "json")
    if not items:
        warn(f'"{shown(name)}" is not in {LOCK_NAME}')
        return UNREACHABLE if problem != "--offline was given" else NOT_AS_APPROVED
    return UNREACHABLE if problem and not options.offline else DONE


def _folder_and_name(folder: Path | None, name: str) -> tuple[Path, str]:
    """Return the folder to search for the lock file, and the name in it: a path of a file here, or a plain name."""
    if folder is None and Path(name).exists():
        path = Path(name).resolve().parent / Path(name).name
        return path.parent, str(path)
    return (folder or Path()).resolve(), name


def _entries(root: Path | None, lock: Lock | None, name: str) -> list[Entry]:
    if root is None or lock is None:
        return []
    if Path(name).is_absolute() and root in Path(name).parents:
        name = Path(name).relative_to(root).as_posix()
    return matching(lock.entries.values(), name)


def _from_lock(root: Path, lock: Lock, entry: Entry) -> dict[str, Any]:
    content = content_sha256(place_of(root, entry.path))
    return {
        "path": entry.path,
        "cue": entry.cue,
        "target": lock.target,
        "take_id": entry.take,
        "sha256": entry.sha256,
        "in_folder": None if content is None else content == entry.sha256,
    }


def _ask(
    options: argparse.Namespace, folder: Path, lock: Lock | None, entries: list[Entry], name: str
) -> tuple[Any, str]:
    """Return the server's answer on each entry, and the reason for none."""
    try:
        source = read_source(
            folder, lock, server=options.server, project=options.project, target=options.target,
            allow_http=options.allow_http,
        )  # fmt: skip
        server = Server(source)
        asked: list[tuple[str, str | None]] = [(entry.path, entry.take) for entry in entries]
        asked = asked or [(Path(name).name, None)]
        origins: list[Any] = []
        for asked_name, take in asked:
            target = lock.target if lock and take else source.target
            answer = server.of_project("game-files/origins", name=asked_name, take=take, target=target)
            if not isinstance(answer, list) or not all(isinstance(row, dict) for row in answer):
                raise Refusal("the server's answer is not understood; is this program too old?")
            rows = [_checked(row) for row in answer]
            origins += (rows or [{}])[:1] if take else rows
        return origins, ""
    except ServerUnreachable as error:
        return [], f"the server cannot be reached: {error}"
    except Refusal as refusal:
        return ([], str(refusal)) if entries else (refusal, "")


def _checked(row: dict[str, Any]) -> dict[str, Any]:
    known_keys = {*ONLINE, "path", "cue", "target", "take_id", "variation", "master_sha256"}
    return {
        key: value for key, value in row.items() if key in known_keys and isinstance(value, str | int | bool | None)
    }


def _report(items: list[dict[str, Any]], problem: str, *, as_json: bool) -> None:
    if as_json:
        unknown = [{**item, "only_online": [key for key in ONLINE if key not in item]} for item in items]
        say(json.dumps({"format_version": FORMAT, "problem": problem or None, "files": unknown}, indent=2))
        return
    for index, item in enumerate(items):
        if index:
            say()
        say(shown(str(item["path"])))
        rows = [("cue", f"{item['cue']} {item.get('cue_name', '')}".rstrip()), ("target", item["target"])]
        rows += [(word, item[key]) for key, word in ONLINE.items() if key in item and key != "cue_name"]
        if "in_folder" in item:
            rows.append(("in this folder", IN_FOLDER[item["in_folder"]]))
        for word, value in rows:
            shown_value = "yes" if value is True else "no" if value is False else value
            say(f"  {word:<24}{shown(str(shown_value)) if shown_value not in ('', None) else 'not stated'}")
        if lacking := [word for key, word in ONLINE.items() if key not in item]:
            say(f"  {'known online only':<24}{', '.join(lacking)}")
    if problem:
        warn(f"The server was not asked, or did not answer: {shown(problem)}")
