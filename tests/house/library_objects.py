"""A sound library with a file that a take equals, as part of one of everything; and a sheet that is accepted."""

import base64
from uuid import UUID

from sqlalchemy.orm import Session

from app.builds.libraries.models import LibraryMatch, LibrarySound, SoundLibrary
from audio_checks import FINGERPRINT_VERSION
from audio_checks.audit.fingerprint import PIECE_BYTES, pieces_of
from audio_checks.audit.fingerprinted import FingerprintedFile
from audio_checks.audit.manifest import manifest_text

FRAMES, RATE = 24_000, 48_000
PACKED = bytes(index % 251 for index in range(PIECE_BYTES * pieces_of(FRAMES, RATE)))
SOUND = FingerprintedFile("doors/door.wav", "a" * 64, RATE, 24, 1, FRAMES, None, -3.0, -20.0, PACKED)
SHEET_BASE64 = base64.b64encode(manifest_text([SOUND]).encode()).decode()


def add_library(session: Session, of: dict[str, UUID], *, take_id: UUID, person_id: UUID) -> dict[str, UUID]:
    """Add a library that a designer registered; return its id by the name in paths."""
    by = {"studio_id": of["studio_id"], "person_id": person_id}
    library = SoundLibrary(**by, name="Doors", licence="Site licence", sounds=1)
    session.add(library)
    session.flush()
    session.add_all(
        [
            LibrarySound(
                **by, library_id=library.id, path="door.wav", fingerprint_version=FINGERPRINT_VERSION,
                pcm_sha256="0" * 64, sample_rate_hz=48_000, fingerprint=PACKED, moments=b"",
            ),
            LibraryMatch(
                **of, take_id=take_id, library_id=library.id, path="door.wav", name="Doors", licence="Site licence",
                score=0.99, gain_db=0.0, has_same_samples=True, is_trimmed=False, is_resampled=False,
            ),
        ]
    )  # fmt: skip
    session.flush()
    return {"library_id": library.id}
