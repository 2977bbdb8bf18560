"""Detection of a project's engine or middleware, and its reading."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path, PurePosixPath

from audio_checks.middleware.fmod import read_fmod
from audio_checks.middleware.godot import read_godot
from audio_checks.middleware.reading import ProjectRefused
from audio_checks.middleware.unity import read_unity
from audio_checks.middleware.unreal import read_unreal
from audio_checks.middleware.values import Project
from audio_checks.middleware.wwise import read_wwise

WANTED = (
    "wanted a .wproj of Wwise, a .fspro of FMOD Studio, the folder of a Unity project, a project.godot, or the JSON"
    " file that integrations/unreal/export_sounds.py writes"
)


def read_project(path: str | Path) -> Project:
    """Return the sound files that a game plays, with their gain.

    Parameters
    ----------
    path : str or Path
        The project's file, or the folder that holds it.

    Raises
    ------
    ProjectRefused
        There is no such project, or more than one in the folder.
    """
    project_path = Path(path)
    if not project_path.exists():
        raise ProjectRefused(f"{project_path}: does not exist; {WANTED}")
    if project_path.is_dir():
        project_path = _project_in(project_path)
    name = project_path.name.lower()
    if name.endswith(".wproj"):
        return read_wwise(project_path)
    if name.endswith(".fspro"):
        return read_fmod(project_path)
    if name == "project.godot":
        return read_godot(project_path.parent)
    if project_path.is_dir():
        return read_unity(project_path)
    if name == "projectversion.txt":
        return read_unity(project_path.parent.parent)
    if name.endswith(".json"):
        return read_unreal(project_path)
    raise ProjectRefused(f"{project_path}: is not a project that is known; {WANTED}")


def read_project_texts(path: str, texts: Mapping[str, str]) -> Project:
    """Return the result of `read_project` for a project whose texts were sent; nothing is read from a disk.

    Parameters
    ----------
    path : str
        The project's file from its root, such as "Game.wproj"; empty for a Unity project, which is its folder.
    texts : mapping of str to str
        The project's texts by their paths from its root, with slashes.

    Raises
    ------
    ProjectRefused
        There is no such project among the texts.
    """
    name = PurePosixPath(path).name.lower()
    if path and path not in texts:
        raise ProjectRefused(f"{path}: was not sent; {WANTED}")
    if name.endswith(".wproj"):
        return read_wwise(Path(path), texts)
    if name.endswith(".fspro"):
        return read_fmod(Path(path), texts)
    if name == "project.godot":
        return read_godot(Path(), texts)
    if name.endswith(".json"):
        return read_unreal(Path(path), texts)
    if not path and any(file.startswith("Assets/") for file in texts):
        return read_unity(Path(), texts)
    raise ProjectRefused(f"{path or 'what was sent'}: is not a project that is known; {WANTED}")


def sound_folder(project: Project) -> Path:
    """Return the folder below which a project's sound files are kept."""
    root = Path(project.root)
    inner = {"wwise": "Originals", "fmod": "Assets", "unity": "Assets"}.get(project.engine, "")
    return root / inner if inner and (root / inner).is_dir() else root


def _project_in(folder: Path) -> Path:
    """Return the project that stands in a folder; a Unity project is its folder."""
    if (folder / "Assets").is_dir() and (folder / "ProjectSettings").is_dir():
        return folder
    files = [path for path in sorted(folder.iterdir()) if not path.name.startswith("._")]  # which macOS leaves
    projects = [file for file in files if file.suffix.lower() in (".wproj", ".fspro") or file.name == "project.godot"]
    if len(projects) != 1:
        which = (
            f"more than one project: {', '.join(candidate.name for candidate in projects[:4])}"
            if projects
            else "no project"
        )
        raise ProjectRefused(f"{folder}: holds {which}; {WANTED}")
    return projects[0]
