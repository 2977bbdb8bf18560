"""Files that the server's own user alone can read."""

import os
import stat
from collections.abc import Iterable
from pathlib import Path

OTHERS = 0o077  # every right of the group and of all others


def keep_new_files_private() -> None:
    """Deny other users all rights to files and folders that this process and its children create."""
    os.umask(OTHERS)


def tighten(paths: Iterable[Path]) -> list[str]:
    """Remove all rights of other users from existing paths; return a line for each where that is not possible."""
    return [line for path in paths if (line := _tighten(path))]


def _tighten(path: Path) -> str | None:
    try:
        mode = stat.S_IMODE(path.stat().st_mode)
    except OSError:  # not there yet, or out of reach: whatever opens it says so
        return None
    if not mode & OTHERS:
        return None
    if mode & stat.S_ISVTX:
        return f"{path} is a folder that all users share (mode {mode:04o}); name a folder of Soundlist's own"
    try:
        path.chmod(mode & ~OTHERS)
    except PermissionError:
        return (
            f"{path} can be read by other users (mode {mode:04o}), and this user does not own it; "
            f"as its owner run: chmod go= {path}"
        )
    return None
