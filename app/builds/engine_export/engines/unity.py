"""Unity: import settings by category, and a prefab for each event.

Source: Unity, Scripting API of AssetPostprocessor, AudioImporter, PrefabUtility and JsonUtility, 2021.3 to 6000.

Settings are applied when a sound is first imported. What a team changes later is kept.
"""

from collections.abc import Collection, Sequence

from app.builds.engine_export.cues import ExportedCue
from app.builds.engine_export.document import DOCUMENT, document, script

FOLDER = "Soundlist"


def import_files(cues: Sequence[ExportedCue], _known_paths: Collection[str] = ()) -> dict[str, bytes]:
    """Return the scripts and the document that they read, below Assets where the game files are."""
    in_project = all(file.path.startswith("Assets/") for cue in cues for file in cue.files)
    root = f"Assets/{FOLDER}" if in_project else FOLDER
    return {
        f"{root}/SoundlistSet.cs": script("SoundlistSet.cs"),
        f"{root}/Editor/SoundlistImporter.cs": script("SoundlistImporter.cs"),
        f"{root}/Editor/{DOCUMENT}": document(cues),
    }
