"""Sound libraries that a studio and its designers register by fingerprints, and the takes that equal their files."""

from collections.abc import Sequence
from dataclasses import dataclass
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Role
from app.builds.errors import LibraryFull, LibraryNotFound
from app.builds.libraries import queries
from app.builds.libraries.models import LibraryMatch, LibrarySound, SoundLibrary
from app.builds.libraries.schemas import SoundLibraryRead
from app.builds.libraries.sheet import SheetSound
from app.core import clock
from app.core.db import bypass_row_policies, insert_all_if_absent
from app.core.events import publish
from app.deliveries.models import Take
from app.projects.errors import ProducerNeeded
from app.projects.service import ProjectAccess, project_access
from audio_checks import FINGERPRINT_VERSION, Difference

MAX_LIBRARY_SOUNDS = 20_000  # of all libraries of a studio


@dataclass(frozen=True)
class LibraryFound:
    """A file of a library that holds the same sound as a take, and how the take differs."""

    library_id: UUID
    path: str
    difference: Difference
    has_same_samples: bool
    is_resampled: bool


def access_to_register(session: Session, actor: Actor, project_id: UUID) -> ProjectAccess:
    """Return the caller's access to a project; raise ProducerNeeded for who registers no library in its studio."""
    access = project_access(session, actor, project_id)
    if not access.is_producer and (access.is_team or access.engagement is None):
        raise ProducerNeeded("only producers of the studio and the project's designers register sound libraries")
    return access


def libraries(session: Session, actor: Actor, project_id: UUID) -> list[SoundLibraryRead]:
    """Return the libraries of the project's studio to its team, and to a designer their own."""
    access = project_access(session, actor, project_id)
    rows = queries.libraries_of(session, access.project.studio_id, access.only_designer_id)
    return [_read(library, actor) for library in rows]


def _read(library: SoundLibrary, actor: Actor) -> SoundLibraryRead:
    return SoundLibraryRead.model_validate(
        {
            **{name: getattr(library, name) for name in ("id", "name", "licence", "sounds", "person", "added_at")},
            "may_remove": _may_remove(library, actor),
        }
    )


def _may_remove(library: SoundLibrary, actor: Actor) -> bool:
    return actor.person_id == library.person_id or Role.PRODUCER in actor.roles_in(library.studio_id)


def add_library_sheet(
    session: Session, actor: Actor, project_id: UUID, *, name: str, licence: str, sounds: Sequence[SheetSound]
) -> SoundLibraryRead:
    """Add the sounds of a sheet to the caller's library of that name, begun where there is none.

    Files that the library has already stay as they are. Raises LibraryFull beyond what a studio may keep.
    """
    studio_id = access_to_register(session, actor, project_id).project.studio_id
    with bypass_row_policies(session):  # a designer does not see the studio's other libraries, and they count too
        kept = queries.count_library_sounds(session, studio_id=studio_id)
    if kept + len(sounds) > MAX_LIBRARY_SOUNDS:
        raise LibraryFull(
            f"the studio has {kept:,} sounds of libraries, and this sheet lists {len(sounds):,}; "
            f"{MAX_LIBRARY_SOUNDS:,} are kept",
            fix="remove a library that is not used, or write a sheet of the folders that are",
        )
    library = queries.library_by_name(session, studio_id, actor.person, name)
    if library is None:
        library = SoundLibrary(studio_id=studio_id, person_id=actor.person, name=name)
        session.add(library)
    library.licence, library.added_at = licence or library.licence or "", clock.now()
    session.flush()
    rows = [
        {
            "library_id": library.id,
            "path": path,
            "studio_id": studio_id,
            "person_id": actor.person,
            "fingerprint_version": FINGERPRINT_VERSION,
            "pcm_sha256": pcm_sha256,
            "sample_rate_hz": sample_rate_hz,
            "fingerprint": fingerprint,
            "moments": moments,
        }
        for path, pcm_sha256, sample_rate_hz, fingerprint, moments in sounds
    ]
    insert_all_if_absent(session, LibrarySound, rows, unique=("library_id", "path"))
    library.sounds = queries.count_library_sounds(session, library_id=library.id)
    session.flush()
    session.refresh(library, ["person"])
    publish(session, "library.added", studio_id=studio_id, library_id=library.id)
    return _read(library, actor)


def remove_library(session: Session, actor: Actor, library_id: UUID) -> None:
    """Forget a library with its fingerprints, and that takes equal its files."""
    library = queries.library_by_id(session, library_id)
    is_seen = library is not None and (actor.roles_in(library.studio_id) or library.person_id == actor.person_id)
    if library is None or not is_seen:
        raise LibraryNotFound(f"no sound library {library_id}")
    if not _may_remove(library, actor):
        raise ProducerNeeded("only a producer of the studio, or who registered a library, removes it")
    session.delete(library)
    session.flush()


def save_library_matches(session: Session, take_id: UUID, matches: Sequence[LibraryFound]) -> None:
    """Record the files of libraries that a take equals, unless their library was removed."""
    if not matches:
        return
    take = session.get_one(Take, take_id)
    rows = [
        {
            "take_id": take.id,
            "library_id": library.id,
            "path": match.path,
            "studio_id": take.studio_id,
            "project_id": take.project_id,
            "name": library.name,
            "licence": library.licence,
            "score": match.difference.score,
            "gain_db": match.difference.gain_db,
            "has_same_samples": match.has_same_samples,
            "is_trimmed": match.difference.is_trimmed,
            "is_resampled": match.is_resampled,
            "found_at": clock.now(),
        }
        for match in matches
        if (library := queries.library_by_id(session, match.library_id)) is not None
    ]
    if rows:
        insert_all_if_absent(session, LibraryMatch, rows, unique=("take_id", "library_id", "path"))
