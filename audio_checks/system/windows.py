"""Paths of Windows: which need the prefix that lifts the limit of 260 characters, and what they are without it."""

import ntpath
import os

LONG, LONG_UNC = "\\\\?\\", "\\\\?\\UNC\\"
LIMIT = 248  # of a folder; a file may have twelve characters more


def reachable(path: str, *, windows: bool = os.name == "nt") -> str:
    r"""Return a path that the system opens, however long it is.

    On Windows a long path is only understood whole, with backslashes, and behind `\\?\`; everywhere
    else, and where it is short, the path is returned as it is.
    """
    return unlimited(path, windows=windows) if windows and len(ntpath.abspath(path)) >= LIMIT else path


def unlimited(path: str, *, windows: bool = os.name == "nt") -> str:
    """Return a folder's path below which paths of any length are reachable."""
    if not windows or path.startswith(LONG):
        return path
    whole = ntpath.abspath(path)
    return LONG_UNC + whole[2:] if whole.startswith("\\\\") else LONG + whole


def without_long_prefix(path: str) -> str:
    r"""Return a path of Windows as people write it: `\\?\C:\a` is `C:\a`, and `\\?\UNC\server\share` its share."""
    if path.startswith(LONG_UNC):
        return "\\\\" + path[len(LONG_UNC) :]
    return path.removeprefix(LONG)
