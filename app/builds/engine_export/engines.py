"""The hand-off of each engine."""

from collections.abc import Collection, Sequence

from app.builds.engine_export.cues import ExportedCue, Handoff
from app.builds.engine_export.fmod import fmod_files
from app.builds.engine_export.godot import godot_files
from app.builds.engine_export.unity import unity_files
from app.builds.engine_export.unreal import unreal_files
from app.builds.engine_export.wwise import wwise_files


def handoff_files(handoff: Handoff, cues: Sequence[ExportedCue], known_paths: Collection[str]) -> dict[str, bytes]:
    """Return the files of a hand-off by their paths in the pack, the same bytes for the same cues.

    `known_paths` are the game files of earlier packs with this hand-off, and those that the adopted game plays.
    """
    if not cues:
        return {}
    match handoff:
        case Handoff.WWISE:
            return wwise_files(cues, known_paths)
        case Handoff.FMOD:
            return fmod_files(cues)
        case Handoff.UNITY:
            return unity_files(cues)
        case Handoff.UNREAL:
            return unreal_files(cues)
        case Handoff.GODOT:
            return godot_files(cues)
    return {}
