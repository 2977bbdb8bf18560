"""FMOD Studio: a script for its Scripts folder, which makes events of the pack's sounds.

Source: FMOD, "Scripting API Reference" of 2.02 and 2.03. The pack is unpacked beside the project's `.fspro` file.
"""

from collections.abc import Collection, Sequence

from app.builds.engine_export.cues import ExportedCue
from app.builds.engine_export.document import DOCUMENT, document, script


def import_files(cues: Sequence[ExportedCue], _known_paths: Collection[str] = ()) -> dict[str, bytes]:
    """Return the script and the document that it reads."""
    return {"Scripts/soundlist_import.js": script("fmod_import.js"), DOCUMENT: document(cues)}
