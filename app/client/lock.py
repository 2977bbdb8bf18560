"""`soundlist.lock`: which approved sounds a folder holds. One sorted line a file, so that Git merges two of them."""

import os
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from app.client.errors import Refusal
from app.client.paths import LOCK_NAME, ensure_distinct, ensure_harmless

FORMAT = 1
HEAD = f"soundlist.lock\t{FORMAT}"
ABOUT = "# One line a file: path, sha256, cue, take, sound. soundlist pull writes this file."
SHA256, SOUND, TAKE = re.compile(r"[0-9a-f]{64}"), re.compile(r"[0-9a-f]{16}"), re.compile(r"[0-9a-f-]{36}")
PROJECT, TARGET = re.compile(r"[0-9a-f-]{36}"), re.compile(r"\S(?:[^\t]*\S)?")
CUE = re.compile(r"[^\t]{1,100}")
MARKERS = ("<<<<<<<", "=======", ">>>>>>>", "|||||||")
MAX_BYTES = 64 << 20


@dataclass(frozen=True)
class Entry:
    """One game file as it was pulled."""

    path: str
    sha256: str
    cue: str
    take: str  # the id of the approved version
    sound: str  # equal for files with the same samples, format and loop

    @property
    def line(self) -> str:
        """The entry's line."""
        return "\t".join((self.path, self.sha256, self.cue, self.take, self.sound))


@dataclass(frozen=True)
class Lock:
    """A folder's contents."""

    project: str
    target: str
    entries: dict[str, Entry]  # by path

    @property
    def text(self) -> str:
        """The content of the lock file."""
        lines = [HEAD, ABOUT, f"project\t{self.project}", f"target\t{self.target}"]
        entries = sorted(self.entries.values(), key=lambda entry: entry.path)
        return "".join(f"{line}\n" for line in [*lines, *(entry.line for entry in entries)])


def read_lock(root: Path) -> Lock | None:
    """Return a folder's lock, None where it has none; raise Refusal with the line that is damaged."""
    path = root / LOCK_NAME
    try:
        with path.open("rb") as file:
            content = file.read(MAX_BYTES + 1)
    except FileNotFoundError:
        return None
    except OSError as error:
        raise Refusal(f"{path} cannot be read: {error.strerror}") from None
    if len(content) > MAX_BYTES:
        raise Refusal(f"{path} is larger than {MAX_BYTES >> 20} MiB; it is not a lock file")
    try:
        return parse(content.decode(), path)
    except UnicodeDecodeError as error:
        raise _damaged(path, content[: error.start].count(b"\n") + 1, "is not UTF-8") from None


def parse(text: str, path: Path) -> Lock:
    """Return the lock that a text is; raise Refusal with the line that is damaged."""
    lines = text.replace("\r\n", "\n").split("\n")
    if lines[-1] == "":
        lines.pop()
    for number, line in enumerate(lines, 1):
        if line.startswith(MARKERS):
            raise _damaged(path, number, "is a marker of a merge conflict")
    if not lines or not lines[0].startswith("soundlist.lock\t"):
        raise _damaged(path, 1, f'is not "soundlist.lock", a tab and the number of the format, {FORMAT}')
    if lines[0] != HEAD:
        raise Refusal(f"{path}, line 1: its format is newer than this program reads ({FORMAT}); update the program")
    heads: dict[str, str] = {}
    entries: dict[str, Entry] = {}
    for number, line in enumerate(lines[1:], 2):
        if line.startswith("#"):
            continue
        fields = line.split("\t")
        if len(fields) == 2 and fields[0] in ("project", "target") and fields[0] not in heads:
            heads[fields[0]] = fields[1]
            continue
        entry = _entry(fields)
        if entry is None:
            raise _damaged(path, number, "is not a path, sha256, cue, take and sound, separated by tabs")
        if entry.path in entries:
            raise _damaged(path, number, f"names {entry.path} a second time")
        try:
            ensure_harmless(entry.path)
        except Refusal as refusal:
            raise _damaged(path, number, f"is refused: {refusal}") from None
        entries[entry.path] = entry
    if not PROJECT.fullmatch(heads.get("project", "")) or not TARGET.fullmatch(heads.get("target", "")):
        raise _damaged(path, 3, "and the next do not name project and target")
    ensure_distinct(entries)
    return Lock(heads["project"], heads["target"], entries)


def _entry(fields: list[str]) -> Entry | None:
    if len(fields) != 5:
        return None
    path, sha256, cue, take, sound = fields
    values_by_key = ((SHA256, sha256), (CUE, cue), (TAKE, take), (SOUND, sound))
    return (
        Entry(path, sha256, cue, take, sound)
        if all(pattern.fullmatch(text) for pattern, text in values_by_key)
        else None
    )


def _damaged(path: Path, number: int, what: str) -> Refusal:
    return Refusal(
        f"{path}, line {number} {what}. Take one side whole, for example by `git checkout --ours {LOCK_NAME}`, "
        "or remove the file, and pull again: files that are as approved are not written again"
    )


def write_lock(root: Path, lock: Lock) -> bool:
    """Write a folder's lock, whole or not at all, unless it is the same; return whether it was written."""
    path, content = root / LOCK_NAME, lock.text.encode()
    if path.exists() and path.read_bytes() == content:
        return False
    new = root / f".soundlist-{os.getpid()}.lock"
    try:
        with new.open("wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        new.replace(path)
    finally:
        new.unlink(missing_ok=True)
    return True


def matching(entries: Iterable[Entry], name: str) -> list[Entry]:
    """Return the entries that a path, a file name, its stem or a cue's number names."""
    matches = []
    for entry in entries:
        file_name = entry.path.rpartition("/")[2]
        if name in (entry.path, file_name, file_name.rpartition(".")[0], entry.cue):
            matches.append(entry)
    return sorted(matches, key=lambda match: match.path)
