"""The globs of `[files]`: `*` and `?` stay within one folder, `**` crosses folders."""

import re
from functools import lru_cache
from pathlib import Path


def matches(glob: str, path: str | Path, folder: Path | None) -> bool:
    """Tell whether a path matches a glob.

    A glob without a slash is about the file's name, in any folder; one with a slash is about the
    path below `folder` (the folder of the spec), or about the path as given when it lies elsewhere.
    """
    path = Path(path)
    pattern = _regex(glob.removeprefix("./"))
    if "/" not in glob:
        return pattern.fullmatch(path.name) is not None
    if folder is not None and path.absolute().is_relative_to(folder):
        path = path.absolute().relative_to(folder)
    return pattern.fullmatch(path.as_posix()) is not None


@lru_cache(maxsize=256)
def _regex(glob: str) -> re.Pattern[str]:
    parts = re.split(r"(\*\*/|\*\*|\*|\?)", glob)
    meaning = {"**/": "(?:.*/)?", "**": ".*", "*": "[^/]*", "?": "[^/]"}
    return re.compile("".join(meaning.get(part, re.escape(part)) for part in parts), re.DOTALL)
