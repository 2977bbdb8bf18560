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


def packed_project(given_path: Path) -> dict[str, str]:
    """Return a project as the server reads it: its file, and its texts packed; raise Refusal where it is none."""
    project_path = _project_at(given_path)
    root = project_path if project_path.is_dir() else project_path.parent
    is_wanted = _wanted_by(project_path)
    texts: dict[str, str] = {}
    size = 0
    for path in _files(root) if project_path.suffix != ".json" else [project_path.name]:
        content = (root / path).read_bytes() if is_wanted(path) else b""
        if not content or (path.endswith(UNITY_HOLDERS) and project_path.is_dir() and not _names_sounds(content)):
            continue
        size += len(content)
        if size > MAX_BYTES:
            raise Refusal(f"the texts of {project_path} have more than {MAX_BYTES >> 20} MiB; adopt without them")
        texts[path] = content.decode("utf-8-sig", "replace")
    packed = gzip.compress(json.dumps(texts).encode())
    return {"path": "" if project_path.is_dir() else project_path.name, "content_base64": b64encode(packed).decode()}


def _project_at(project_path: Path) -> Path:
    if project_path.is_dir() and not (project_path / "ProjectSettings").is_dir():
        projects = [
            candidate
            for candidate in sorted(project_path.iterdir())
            if candidate.suffix in (".wproj", ".fspro") or candidate.name == "project.godot"
        ]
        if len(projects) != 1:
            raise Refusal(f"{project_path} holds {'more than one project' if projects else 'no project'}; {WANTED}")
        return projects[0]
    is_project_file = project_path.suffix in (".wproj", ".fspro", ".json") or project_path.name == "project.godot"
    if not (project_path.is_dir() or (is_project_file and project_path.is_file())):
        raise Refusal(f"{project_path} is not a project that is known; {WANTED}")
    return project_path


def _wanted_by(project_path: Path) -> Callable[[str], bool]:
    """Return the test of paths below the project's root for texts on the playing of sounds."""
    if project_path.is_dir():
        settings = ("ProjectSettings/AudioManager.asset", "ProjectSettings/ProjectVersion.txt")
        return lambda path: path in settings or path.endswith((*UNITY_HOLDERS, *UNITY_METAS, ".mixer"))
    if project_path.suffix == ".wproj":
        return lambda path: path == project_path.name or path.endswith(".wwu")
    if project_path.suffix == ".fspro":
        return lambda path: path == project_path.name or (path.startswith("Metadata/") and path.endswith(".xml"))
    if project_path.suffix == ".json":
        return lambda path: path == project_path.name
    return lambda path: path == project_path.name or path.endswith((".import", ".tscn", ".tres", ".gd", ".cs"))


def _names_sounds(content: bytes) -> bool:
    return any(word in content for word in UNITY_WORDS)


def _files(root: Path) -> Iterator[str]:
    for folder, names, files in os.walk(root):
        names[:] = sorted(name for name in names if not name.startswith(".") and name not in SKIPPED)
        for name in sorted(files):
            file_path = Path(folder, name)
            if not name.startswith("._") and not file_path.is_symlink():
                yield file_path.relative_to(root).as_posix()
