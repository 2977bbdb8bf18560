"""Where a file lies in its repository: the names that CI services and code scanners find it by.

Paths of Windows are understood on any system when they are asked about as such: drive letters, UNC
shares, and the prefix of long paths (two backslashes, a question mark, a backslash).
"""

import os
from pathlib import Path, PurePath, PurePosixPath, PureWindowsPath
from urllib.parse import quote

from audio_checks.windows import without_long_prefix

SAFE = "/!$&'()+,;=@~"  # what a path segment of a URI may hold besides letters, digits and -._~ (RFC 3986, 3.3)


def repository_root() -> Path:
    """Return GITHUB_WORKSPACE, or the nearest folder with a .git above the current one, or the current one."""
    if workspace := os.environ.get("GITHUB_WORKSPACE"):
        return Path(workspace)
    here = Path.cwd()
    return next((one for one in (here, *here.parents) if (one / ".git").exists()), here)


def in_repository(path: str, root: PurePath, here: PurePath | None = None) -> str | None:
    """Return a path below the root with slashes, or None for one that lies elsewhere.

    Parameters
    ----------
    path : str
        As it was given: absolute, or relative to `here`.
    root, here : PurePath
        Absolute, of the system that the path is of; `here` is the current folder unless it is named.
    """
    whole, above = _absolute(path, root, here), _absolute(str(root), root, here)
    return whole.relative_to(above).as_posix() if whole.is_relative_to(above) else None


def uri_of(path: str, root: PurePath, here: PurePath | None = None) -> tuple[str, bool]:
    """Return the URI reference of a file, and whether it is relative to the root; see `in_repository`."""
    inside = in_repository(path, root, here)
    if inside is not None:
        return quote(inside, safe=SAFE, errors="surrogatepass"), True
    whole = _absolute(path, root, here)
    if isinstance(whole, PureWindowsPath):
        return whole.as_uri(), False
    return "file://" + quote(str(whole), safe=SAFE, errors="surrogatepass"), False


def _absolute(path: str, root: PurePath, here: PurePath | None) -> PurePath:
    """Return a path of the root's system, absolute and without `.` and `..`, by its text alone."""
    if isinstance(root, PureWindowsPath):
        whole: PurePath = PureWindowsPath(here or Path.cwd()) / without_long_prefix(path)
    else:
        whole = PurePosixPath(here or Path.cwd()) / path
    parts: list[str] = []
    for part in whole.parts[1:]:
        if part != "..":
            parts.append(part)
        elif parts:
            parts.pop()
    return type(whole)(whole.parts[0], *parts)
