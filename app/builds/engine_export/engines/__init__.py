"""The import files of each engine: a module here is an engine, and `import_files` in it makes them."""

from collections.abc import Collection, Sequence
from importlib import import_module

from app.builds.engine_export.cues import ExportedCue, Handoff


def handoff_files(handoff: Handoff, cues: Sequence[ExportedCue], known_paths: Collection[str]) -> dict[str, bytes]:
    """Return the import files of an engine by their paths in the pack, the same bytes for the same cues.

    `known_paths` are the game files of earlier packs with this export, and those that the adopted game plays.
    """
    if not cues or handoff is Handoff.NONE:
        return {}
    files: dict[str, bytes] = import_module(f"{__name__}.{handoff}").import_files(cues, known_paths)
    return files
