"""Sound libraries, their fingerprints and matches, read from the database; callers check access."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import func, select
from sqlalchemy.orm import Session, joinedload

from app.builds.libraries.models import LibraryMatch, LibrarySound, SoundLibrary
from app.builds.same_sounds.models import MasterFingerprint
from app.core.in_array import in_array
from app.deliveries.models import Take
from audio_checks import FINGERPRINT_VERSION

SoundKey = tuple[UUID, str]  # library and path


def libraries_of(session: Session, studio_id: UUID, person_id: UUID | None) -> Sequence[SoundLibrary]:
    """Return the libraries of a studio by name; those of one person where one is given."""
    query = select(SoundLibrary).where(SoundLibrary.studio_id == studio_id).options(joinedload(SoundLibrary.person))
    if person_id is not None:
        query = query.where(SoundLibrary.person_id == person_id)
    return session.scalars(query.order_by(SoundLibrary.name, SoundLibrary.id)).all()


def library_by_id(session: Session, library_id: UUID) -> SoundLibrary | None:
    """Return a library without asking who looks."""
    return session.get(SoundLibrary, library_id)


def library_by_name(session: Session, studio_id: UUID, person_id: UUID, name: str) -> SoundLibrary | None:
    """Return the library that a person registered under a name, locked."""
    return session.scalar(
        select(SoundLibrary)
        .where(SoundLibrary.studio_id == studio_id, SoundLibrary.person_id == person_id, SoundLibrary.name == name)
        .with_for_update(key_share=True)
    )


def count_library_sounds(session: Session, *, studio_id: UUID | None = None, library_id: UUID | None = None) -> int:
    """Return the number of sounds of a library, or of all libraries of a studio."""
    query = select(func.count()).select_from(LibrarySound)
    if studio_id is not None:
        query = query.where(LibrarySound.studio_id == studio_id)
    if library_id is not None:
        query = query.where(LibrarySound.library_id == library_id)
    return session.scalar(query) or 0


def library_moments(
    session: Session, studio_id: UUID, library_id: UUID | None = None
) -> tuple[list[SoundKey], list[bytes]]:
    """Return the keys and moments of a studio's library sounds; of one library where one is given."""
    query = select(LibrarySound.library_id, LibrarySound.path, LibrarySound.moments).where(
        LibrarySound.studio_id == studio_id, LibrarySound.fingerprint_version == FINGERPRINT_VERSION
    )
    if library_id is not None:
        query = query.where(LibrarySound.library_id == library_id)
    rows = session.execute(query.order_by(LibrarySound.library_id, LibrarySound.path)).all()
    return [(library, path) for library, path, _ in rows], [moments for _, _, moments in rows]


def library_sound(session: Session, key: SoundKey) -> LibrarySound | None:
    """Return one file of a library."""
    return session.get(LibrarySound, key)


def takes_with_fingerprints(
    session: Session, studio_id: UUID, after: UUID | None, limit: int
) -> Sequence[tuple[UUID, MasterFingerprint]]:
    """Return takes of a studio by id, after one, with what their masters are recognised by."""
    query = (
        select(Take.id, MasterFingerprint)
        .join(
            MasterFingerprint,
            (MasterFingerprint.studio_id == Take.studio_id) & (MasterFingerprint.sound_sha256 == Take.master_sha256),
        )
        .where(
            Take.studio_id == studio_id,
            MasterFingerprint.fingerprint_version == FINGERPRINT_VERSION,
            MasterFingerprint.fingerprint.is_not(None),
        )
    )
    if after is not None:
        query = query.where(Take.id > after)
    return [(take_id, fingerprint) for take_id, fingerprint in session.execute(query.order_by(Take.id).limit(limit))]


def library_matches_of(session: Session, take_ids: Collection[UUID]) -> Sequence[LibraryMatch]:
    """Return the files of libraries that takes equal."""
    return session.scalars(
        select(LibraryMatch)
        .where(in_array(LibraryMatch.take_id, take_ids))
        .order_by(LibraryMatch.take_id, LibraryMatch.name, LibraryMatch.path)
    ).all()
