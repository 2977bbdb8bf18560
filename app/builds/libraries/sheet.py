"""A sheet of fingerprints that a person posts: read in a child process, into plain values."""

import base64

from app.builds.errors import BadLibrarySheet
from audio_checks import SpecError, sounds_of_manifest

MAX_SHEET_SOUNDS = 10_000
WRITE_IT = "write it by: audio-checks manifest FOLDER --out library.json"

SheetSound = tuple[str, str, int, bytes, bytes]  # path, SHA-256 of the samples, rate in Hz, fingerprint, moments


def parse_library_sheet(content_base64: str) -> list[tuple[str, str, int, bytes, bytes]]:
    """Return the identifying data of each sound of a sheet; raise BadLibrarySheet, with the findings, for others."""
    try:
        text = base64.b64decode(content_base64, validate=True).decode("utf-8-sig")
    except ValueError:
        raise BadLibrarySheet(
            "the file is not text in UTF-8, so it is not a sheet of fingerprints", fix=WRITE_IT
        ) from None
    try:
        sounds = sounds_of_manifest(text)
    except SpecError as error:
        raise BadLibrarySheet(f"the sheet {error.args[0]}", fix=WRITE_IT) from None
    if not sounds:
        raise BadLibrarySheet(
            "no file of the sheet can be recognised: they are silent, or a few milliseconds long", fix=WRITE_IT
        )
    if len(sounds) > MAX_SHEET_SOUNDS:
        raise BadLibrarySheet(
            f"the sheet lists {len(sounds):,} sounds; a sheet may list {MAX_SHEET_SOUNDS:,}",
            fix="write a sheet for each of its folders; they go into one library by its name",
        )
    return [
        (path, signature.pcm_sha256, signature.sample_rate_hz, signature.fingerprint or b"", signature.moments)
        for path, signature in sounds
    ]
