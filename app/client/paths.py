"""Paths that a server or a lock file names: hostile until each part was looked at."""

import hashlib
import os
import re
import stat
import unicodedata
from collections.abc import Iterable
from pathlib import Path

from app.client.errors import Refusal

LOCK_NAME = "soundlist.lock"
MAX_PATH_CHARS = 1_000
MAX_PART_BYTES = 255  # what file systems take
# Windows reads these as devices, with any ending and in any folder.
DEVICES = re.compile(r"(con|prn|aux|nul|conin\$|conout\$|(com|lpt)[0-9\u00b9\u00b2\u00b3])(\..*)?", re.IGNORECASE)
FORBIDDEN = set('<>:"|?*\\')  # drive letters, streams, patterns, and the other separator
OURS = {LOCK_NAME, "soundlist.toml", ".git", ".hg", ".svn", ".p4config", ".p4ignore", ".gitattributes", ".gitmodules"}
BLOCK_BYTES = 1 << 20
LFS_POINTER = re.compile(
    rb"version https://git-lfs\.github\.com/spec/v1\n(?:.*\n)*?oid sha256:([0-9a-f]{64})\n(?:.*\n)*"
)
LFS_POINTER_BYTES = 1_024


def ensure_harmless(path: str) -> str:
    """Return a path of a game file; raise Refusal for one that could lead out of the folder, or to no plain file."""
    if reason := _why_harmful(path):
        raise Refusal(f"{path!r} is not a path for a game file: {reason}; nothing was written")
    return path


def _why_harmful(path: str) -> str | None:
    if not path or len(path) > MAX_PATH_CHARS:
        return "it is empty or too long"
    parts = path.split("/")
    for part in parts:
        if part in ("", ".", ".."):
            return "it is absolute, or has an empty part, . or .."
        if len(os.fsencode(part)) > MAX_PART_BYTES if _is_encodable(part) else True:
            return "a part is too long for a file system, or is not text"
        if FORBIDDEN & set(part) or any(unicodedata.category(sign).startswith("C") for sign in part):
            return "it has a character that some system takes for something else"
        if part[-1] in ". " or part[0] == " ":
            return "a part begins or ends with a space, or ends with a dot"
        if DEVICES.fullmatch(part):
            return "Windows takes it for a device"
        if part.casefold() in OURS or part.casefold().startswith(".soundlist-"):
            return "that name is used by the tools themselves"
    return None


def _is_encodable(part: str) -> bool:
    try:
        part.encode()
    except UnicodeEncodeError:
        return False
    return True


def ensure_distinct(paths: Iterable[str]) -> None:
    """Raise Refusal where two paths are one file on a system that ignores case, or one is the folder of another."""
    paths_by_folded: dict[str, str] = {}
    for path in paths:
        key = folded(path)
        if key in paths_by_folded:
            raise Refusal(f"{paths_by_folded[key]!r} and {path!r} are one file on some systems; nothing was written")
        paths_by_folded[key] = path
    for key, path in paths_by_folded.items():
        parts = key.split("/")
        for count in range(1, len(parts)):
            if (folder := "/".join(parts[:count])) in paths_by_folded:
                raise Refusal(f"{paths_by_folded[folder]!r} is a file and the folder of {path!r}; nothing was written")


def folded(path: str) -> str:
    """Return a key equal for two paths that are one file where case and the composition of letters do not count."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFC", path).casefold())


def place_of(root: Path, path: str) -> Path:
    """Return the place of a game file; raise Refusal where a link on the way leads out of the folder."""
    target = root.joinpath(*path.split("/"))
    inside, folder = root.resolve(), target.parent
    while not os.path.lexists(folder):
        folder = folder.parent
    if folder.resolve() != inside and inside not in folder.resolve().parents:
        raise Refusal(f"{path!r} leads out of {root} by a link")
    if not folder.is_dir():
        raise Refusal(f"{folder} is a file, where the folder of {path!r} should be")
    return target


def part_of(target: Path, path: str, sha256: str) -> Path:
    """Return the place of an unfinished download: beside its final place, so that it is moved by a rename."""
    return target.with_name(f".soundlist-{hashlib.sha256(path.encode()).hexdigest()[:8]}-{sha256[:24]}.part")


def sha256_of(path: Path) -> str:
    """Return the hash of a file."""
    digest = hashlib.sha256()
    with path.open("rb") as file:
        while block := file.read(BLOCK_BYTES):
            digest.update(block)
    return digest.hexdigest()


def content_sha256(path: Path) -> str | None:
    """Return the hash of what is at a place, None where nothing is; of a pointer of Git LFS, what it points to.

    A link, a folder or a device gives an empty text, which is the hash of nothing.
    """
    try:
        status = path.lstat()
    except FileNotFoundError:
        return None
    if not stat.S_ISREG(status.st_mode):
        return ""
    if status.st_size <= LFS_POINTER_BYTES and (pointed := LFS_POINTER.fullmatch(path.read_bytes())):
        return pointed[1].decode()
    return sha256_of(path)


def is_read_only(path: Path) -> bool:
    """Whether nobody may write to a file, as source control marks one that is not checked out."""
    return path.exists() and not path.stat().st_mode & (stat.S_IWUSR | stat.S_IWGRP | stat.S_IWOTH)
