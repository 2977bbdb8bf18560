"""Unreal: a script for the editor's Python, which imports the pack's sounds and makes cues of them.

Source: Epic, Unreal Python API 5.1 to 5.7: AssetImportTask, EditorAssetLibrary, SoundCueFactoryNew.
"""

from collections.abc import Collection, Sequence

from app.builds.engine_export.cues import ExportedCue
from app.builds.engine_export.document import DOCUMENT, document, script


def import_files(cues: Sequence[ExportedCue], _known_paths: Collection[str] = ()) -> dict[str, bytes]:
    """Return the script and the document that it reads."""
    return {"soundlist_import.py": script("unreal_import.py"), DOCUMENT: document(cues)}
