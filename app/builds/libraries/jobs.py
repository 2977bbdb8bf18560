"""The jobs that look for files of sound libraries in takes."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.builds.libraries import queries
from app.builds.libraries import service as libraries
from app.builds.libraries.models import LibrarySound
from app.builds.libraries.queries import SoundKey
from app.builds.libraries.service import LibraryFound
from app.builds.same_sounds.models import MasterFingerprint
from app.core.jobs.queue import BULK, Payload, job
from app.core.runtime import Runtime
from audio_checks import difference_of, likely_sounds

TAKES_AT_ONCE = 200  # that one job compares with a new sheet; it asks for the next ones
Moments = tuple[Sequence[SoundKey], list[bytes]]


def library_matches(session: Session, fingerprint: MasterFingerprint) -> list[LibraryFound]:
    """Return the files of the studio's libraries that hold a fingerprinted sound."""
    return _found(session, fingerprint, queries.library_moments(session, fingerprint.studio_id))


@job("builds.compare_library")
def compare_library(runtime: Runtime, payload: Payload) -> None:
    """Look for the files of a library in the takes that were fingerprinted, some takes after others."""
    library_id = UUID(payload["library_id"])
    after = UUID(payload["after"]) if "after" in payload else None
    with runtime.database.reading() as session:
        library = queries.library_by_id(session, library_id)
        if library is None:
            return
        studio_id, size = library.studio_id, library.sounds
        moments = queries.library_moments(session, studio_id, library_id)
        takes = queries.takes_with_fingerprints(session, studio_id, after, TAKES_AT_ONCE)
        matches_by_take = {take_id: _found(session, fingerprint, moments) for take_id, fingerprint in takes}
    with runtime.database.writing() as session:
        for take_id, matches in matches_by_take.items():
            if matches:
                libraries.save_library_matches(session, take_id, matches)
        if len(takes) == TAKES_AT_ONCE:
            last = takes[-1][0]
            runtime.queue.enqueue(
                session,
                "builds.compare_library",
                {"library_id": str(library_id), "after": str(last)},
                key=f"builds.compare_library:{library_id}:{size}:{last}",
                studio_id=studio_id,
                priority=BULK,
            )


def _found(session: Session, mine: MasterFingerprint, moments: Moments) -> list[LibraryFound]:
    """Return the files that hold the same sound, of the likeliest."""
    if mine.fingerprint is None:
        return []
    keys, of_sounds = moments
    likely = (queries.library_sound(session, keys[index]) for index in likely_sounds(mine.fingerprint, of_sounds))
    return [match for sound in likely if sound is not None and (match := _compared(mine, sound)) is not None]


def _compared(mine: MasterFingerprint, other: LibrarySound) -> LibraryFound | None:
    difference = difference_of(other.fingerprint, mine.fingerprint or b"")
    if difference is None:
        return None
    return LibraryFound(
        other.library_id,
        other.path,
        difference,
        has_same_samples=mine.pcm_sha256 == other.pcm_sha256,
        is_resampled=mine.sample_rate_hz != other.sample_rate_hz,
    )
