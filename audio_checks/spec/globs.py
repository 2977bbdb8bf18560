"""The globs of `[files]`: `*` and `?` stay within one folder, `**` crosses folders."""

import re
from functools import lru_cache
from pathlib import Path, PurePath, PureWindowsPath

from audio_checks.spec.patterns import Pattern
from audio_checks.system.windows import without_long_prefix


def matches(glob: str, path: str | PurePath, folder: PurePath | None) -> bool:
    """Return whether a path matches a glob, which is written with slashes on every system.

    A glob without a slash is about the file's name, in any folder; one with a slash is about the
    path below `folder` (the folder of the spec), or about the path as given when it is outside.
    """
    path = path if isinstance(path, PurePath) else Path(path)
    pattern = _pattern(glob.removeprefix("./"))
    if "/" not in glob:
        return pattern.matches(path.name)
    if folder is not None:
        whole, above = _plain(path), _plain(folder)
        if whole.is_relative_to(above):
            path = whole.relative_to(above)
    return pattern.matches(path.as_posix())


def _plain(path: PurePath) -> PurePath:
    whole = path.absolute() if isinstance(path, Path) else path
    return PureWindowsPath(without_long_prefix(str(whole))) if isinstance(whole, PureWindowsPath) else whole


@lru_cache(maxsize=2_048)
def _pattern(glob: str) -> Pattern:
    parts = re.split(r"(\*\*/|\*\*|\*|\?)", glob)
    meaning = {"**/": "(?:.*/)?", "**": ".*", "*": "[^/]*", "?": "[^/]"}
    return Pattern("".join(meaning.get(part, re.escape(part)) for part in parts), re.DOTALL)
