"""The path of a file in its repository, as CI services and code scanners expect it.

Paths of Windows are understood on any system when they are asked about as such: drive letters, UNC
shares, and the prefix of long paths (two backslashes, a question mark, a backslash).
"""

import ntpath
import os
import posixpath
from pathlib import Path, PurePath, PureWindowsPath
from types import ModuleType
from urllib.parse import quote

from audio_checks.system.windows import without_long_prefix

SAFE = "/!$&'()+,;=@~"  # what a path segment of a URI may hold besides letters, digits and -._~ (RFC 3986, 3.3)


def repository_root() -> Path:
    """Return GITHUB_WORKSPACE, or the nearest folder with a .git above the current one, or the current one."""
    if workspace := os.environ.get("GITHUB_WORKSPACE"):
        return Path(workspace).resolve()  # as the current folder is given
    here = Path.cwd()
    return next((folder for folder in (here, *here.parents) if (folder / ".git").exists()), here)


def in_repository(path: str, root: PurePath, here: PurePath | None = None) -> str | None:
    """Return a path below the root with slashes, or None for one outside it.

    Parameters
    ----------
    path : str
        As it was given: absolute, or relative to `here`.
    root, here : PurePath
        Absolute, of the system that the path is of; `here` is the current folder unless it is named.
    """
    rules, whole = _absolute(path, root, here)
    above = rules.join(_absolute(str(root), root, here)[1], "")
    if not rules.normcase(whole).startswith(rules.normcase(above)):
        return None
    return whole[len(above) :].replace(rules.sep, "/")


def uri_of(path: str, root: PurePath, here: PurePath | None = None) -> tuple[str, bool]:
    """Return the URI reference of a file, and whether it is relative to the root; see `in_repository`."""
    inside = in_repository(path, root, here)
    if inside is not None:
        return quote(inside, safe=SAFE, errors="surrogatepass"), True
    rules, whole = _absolute(path, root, here)
    if rules is ntpath:
        return PureWindowsPath(whole).as_uri(), False
    return "file://" + quote(whole, safe=SAFE, errors="surrogatepass"), False


def _absolute(path: str, root: PurePath, here: PurePath | None) -> tuple[ModuleType, str]:
    """Return the rules of the root's system, and a path by them: absolute, without `.` and `..`, by its text alone."""
    above = str(here or os.getcwd())
    if isinstance(root, PureWindowsPath):
        return ntpath, ntpath.normpath(ntpath.join(above, without_long_prefix(path)))
    return posixpath, posixpath.normpath(posixpath.join(above, path))
