"""A take's sound looked for among the approved sounds of the studio's other projects."""

from collections.abc import Sequence
from dataclasses import dataclass
from uuid import UUID

from sqlalchemy import delete
from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.builds.libraries import queries as library_queries
from app.builds.libraries.models import LibraryMatch
from app.builds.same_sounds import queries
from app.builds.same_sounds.models import MasterFingerprint, SameSound
from app.builds.same_sounds.rules import is_named, words_of_same_sound
from app.builds.same_sounds.schemas import LibraryMatchRead, SameSoundRead, SameSoundsRead
from app.core import clock
from app.core.db import insert_all_if_absent, insert_if_absent, row_of
from app.deliveries.errors import TakeNotFound
from app.deliveries.models import Take
from app.deliveries.service import take_for
from app.deliveries.sources.service import sources_of
from app.projects.errors import NdaNeeded
from app.projects.models import Project
from app.sound_lists.rules import label
from audio_checks import FINGERPRINT_VERSION, Difference, SoundSignature


@dataclass(frozen=True)
class FoundElsewhere:
    """A master of another project that holds the same sound, and how the sound in question differs."""

    sha256: str
    difference: Difference
    has_same_samples: bool
    is_resampled: bool


def new_fingerprint(studio_id: UUID, sha256: str, signature: SoundSignature | None) -> MasterFingerprint:
    """Return the fingerprint of a master; of one that could not be read, where there is no signature."""
    return MasterFingerprint(
        studio_id=studio_id,
        sound_sha256=sha256,
        fingerprint_version=FINGERPRINT_VERSION,
        pcm_sha256=signature.pcm_sha256 if signature else None,
        sample_rate_hz=signature.sample_rate_hz if signature else 0,
        fingerprint=signature.fingerprint if signature else None,
        moments=signature.moments if signature else b"",
    )


def save_master_fingerprint(session: Session, fingerprint: MasterFingerprint) -> None:
    """Record a master's fingerprint once, in place of one made by another version."""
    session.execute(
        delete(MasterFingerprint).where(
            MasterFingerprint.studio_id == fingerprint.studio_id,
            MasterFingerprint.sound_sha256 == fingerprint.sound_sha256,
            MasterFingerprint.fingerprint_version != FINGERPRINT_VERSION,
        )
    )
    insert_if_absent(session, MasterFingerprint, row_of(fingerprint), unique=("studio_id", "sound_sha256"))


def save_same_sounds(session: Session, take_id: UUID, matches: Sequence[FoundElsewhere]) -> None:
    """Record the takes that hold the same sound, for both sides, unless they are no longer approved."""
    if not matches:
        return
    by_hash = {found_match.sha256: found_match for found_match in matches}
    take = session.get_one(Take, take_id)
    rows = []
    for other in queries.approved_takes_elsewhere(session, take.studio_id, take.project_id, by_hash):
        match = by_hash[other.master_sha256]
        rows += [
            _row(take, other, match, match.difference.gain_db),
            _row(other, take, match, -match.difference.gain_db),
        ]
    if rows:
        insert_all_if_absent(session, SameSound, rows, unique=("take_id", "other_take_id"))


def _row(take: Take, other: Take, match: FoundElsewhere, gain_db: float) -> dict[str, object]:
    return {
        "take_id": take.id,
        "other_take_id": other.id,
        "studio_id": take.studio_id,
        "project_id": take.project_id,
        "score": match.difference.score,
        "gain_db": gain_db,
        "has_same_samples": match.has_same_samples,
        "is_trimmed": match.difference.is_trimmed,
        "is_resampled": match.is_resampled,
        "found_at": clock.now(),
    }


def same_sounds_of_take(session: Session, actor: Actor, take_id: UUID) -> SameSoundsRead:
    """Return the other places of a take's sound that the caller may see: a designer sees only takes of their own."""
    take, access = take_for(session, actor, take_id)
    is_compared = None
    if access.is_team:
        is_compared = queries.has_master_fingerprint(session, take.studio_id, take.master_sha256)
    sounds = [
        _read(same, other, project)
        for same, other, project in queries.same_sounds_of(session, [take_id])
        if _is_visible(session, actor, other.id)
    ]
    return SameSoundsRead(
        take_id=take_id, is_compared=is_compared, sounds=sounds, libraries=_of_libraries(session, [take])[take_id]
    )


def _of_libraries(session: Session, takes: Sequence[Take]) -> dict[UUID, list[LibraryMatchRead]]:
    """Return the equal files of registered libraries by take, and whether its sources name the library."""
    stated = sources_of(session, takes)
    by_take: dict[UUID, list[LibraryMatchRead]] = {take.id: [] for take in takes}
    for library_match in library_queries.library_matches_of(session, by_take):
        sources = stated.get(library_match.take_id)
        by_take[library_match.take_id].append(
            LibraryMatchRead(
                library=library_match.name,
                licence=library_match.licence,
                file=library_match.path,
                words=_words(library_match),
                gain_db=library_match.gain_db,
                score=library_match.score,
                is_declared=is_named(
                    library_match.name, [library.name for library in sources.libraries] if sources else ()
                ),
            )
        )
    return by_take


def library_files_in_words(session: Session, takes: Sequence[Take]) -> dict[UUID, str]:
    """Return the equal files of libraries by take, for a clearance sheet; the caller has checked access."""
    return {
        take_id: "; ".join(
            f"{match.file} of {match.library}{f' ({match.licence})' if match.licence else ''}, {match.words}, "
            + ("declared" if match.is_declared else "not declared")
            for match in matches
        )
        for take_id, matches in _of_libraries(session, takes).items()
        if matches
    }


def _is_visible(session: Session, actor: Actor, take_id: UUID) -> bool:
    try:
        take_for(session, actor, take_id)
    except (TakeNotFound, NdaNeeded):
        return False
    return True


def _read(same: SameSound, other: Take, project: Project) -> SameSoundRead:
    return SameSoundRead(
        take_id=other.id,
        project_id=project.id,
        project_name=project.name,
        cue=_named(other, project),
        version=other.number,
        words=_words(same),
        gain_db=same.gain_db,
        score=same.score,
    )


def same_sounds_in_words(session: Session, takes: Sequence[Take]) -> dict[UUID, str]:
    """Return the other uses of each take's sound, for a clearance sheet; the caller has checked access."""
    words_by_take: dict[UUID, list[str]] = {}
    for same, other, project in queries.same_sounds_of(session, [take.id for take in takes]):
        words_by_take.setdefault(same.take_id, []).append(f"{project.name}: {_named(other, project)}, {_words(same)}")
    return {take_id: "; ".join(words) for take_id, words in words_by_take.items()}


def _named(take: Take, project: Project) -> str:
    return f"{label(project.cue_prefix, take.cue.number)} {take.cue.name}" if take.cue else take.file_name


def _words(same: SameSound | LibraryMatch) -> str:
    return words_of_same_sound(
        has_same_samples=same.has_same_samples,
        gain_db=same.gain_db,
        is_trimmed=same.is_trimmed,
        is_resampled=same.is_resampled,
    )
