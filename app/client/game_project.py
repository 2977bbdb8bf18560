"""The texts of a game's project that say how its sounds are played, packed to be sent."""

import gzip
import json
import os
from base64 import b64encode
from collections.abc import Callable, Iterator
from pathlib import Path

from app.client.errors import Refusal

MAX_BYTES = 64 << 20
SKIPPED = frozenset({"Library", "Temp", "Logs", "obj", "node_modules"})
UNITY_HOLDERS = (".unity", ".prefab", ".asset", ".playable", ".controller")
UNITY_METAS = tuple(
    f"{ending}.meta" for ending in (*UNITY_HOLDERS, ".mixer", ".wav", ".ogg", ".mp3", ".aif", ".aiff", ".flac", ".opus")
)
UNITY_WORDS = (b"AudioSource", b"8300000", b"PrefabInstance", b"AudioRandomContainer")
WANTED = (
    "name a .wproj of Wwise, a .fspro of FMOD Studio, the folder of a Unity project, a project.godot, or the JSON "
    "file that export_sounds.py writes in Unreal"
)


def packed_project(place: Path) -> dict[str, str]:
    """Return a project as the server reads it: its file, and its texts packed; raise Refusal where it is none."""
    place = _project_at(place)
    root = place if place.is_dir() else place.parent
    is_wanted = _wanted_by(place)
    texts: dict[str, str] = {}
    size = 0
    for path in _files(root) if place.suffix != ".json" else [place.name]:
        content = (root / path).read_bytes() if is_wanted(path) else b""
        if not content or (path.endswith(UNITY_HOLDERS) and place.is_dir() and not _names_sounds(content)):
            continue
        size += len(content)
        if size > MAX_BYTES:
            raise Refusal(f"the texts of {place} have more than {MAX_BYTES >> 20} MiB; adopt without them")
        texts[path] = content.decode("utf-8-sig", "replace")
    packed = gzip.compress(json.dumps(texts).encode())
    return {"path": "" if place.is_dir() else place.name, "content_base64": b64encode(packed).decode()}


def _project_at(place: Path) -> Path:
    if place.is_dir() and not (place / "ProjectSettings").is_dir():
        found = [
            one for one in sorted(place.iterdir()) if one.suffix in (".wproj", ".fspro") or one.name == "project.godot"
        ]
        if len(found) != 1:
            raise Refusal(f"{place} holds {'more than one project' if found else 'no project'}; {WANTED}")
        return found[0]
    known = place.suffix in (".wproj", ".fspro", ".json") or place.name == "project.godot"
    if not (place.is_dir() or (known and place.is_file())):
        raise Refusal(f"{place} is not a project that is known; {WANTED}")
    return place


def _wanted_by(place: Path) -> Callable[[str], bool]:
    """Return the test of paths below the project's root for texts on the playing of sounds."""
    if place.is_dir():
        settings = ("ProjectSettings/AudioManager.asset", "ProjectSettings/ProjectVersion.txt")
        return lambda path: path in settings or path.endswith((*UNITY_HOLDERS, *UNITY_METAS, ".mixer"))
    if place.suffix == ".wproj":
        return lambda path: path == place.name or path.endswith(".wwu")
    if place.suffix == ".fspro":
        return lambda path: path == place.name or (path.startswith("Metadata/") and path.endswith(".xml"))
    if place.suffix == ".json":
        return lambda path: path == place.name
    return lambda path: path == place.name or path.endswith((".import", ".tscn", ".tres", ".gd", ".cs"))


def _names_sounds(content: bytes) -> bool:
    return any(word in content for word in UNITY_WORDS)


def _files(root: Path) -> Iterator[str]:
    for folder, names, files in os.walk(root):
        names[:] = sorted(name for name in names if not name.startswith(".") and name not in SKIPPED)
        for name in sorted(files):
            place = Path(folder, name)
            if not name.startswith("._") and not place.is_symlink():
                yield place.relative_to(root).as_posix()
