"""References: added, replaced by newer versions, changed, taken off the board, and opened."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import timedelta
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.quotas.service import QuotaKind, ensure_quota
from app.accounts.rules import Actor
from app.core import clock
from app.core.errors import FieldProblem
from app.core.events import publish
from app.core.storage import Store
from app.core.uploads import FinishedUpload, finished_upload
from app.projects.errors import ProjectNotFound
from app.projects.service import ProjectAccess, project_access
from app.references import queries
from app.references.errors import NoPreview, ReferenceInvalid, ReferenceNotFound, ReferenceUnopened
from app.references.models import Reference, ReferenceOpening, ReferenceVersion
from app.references.rules import (
    EXCERPT_CHARS,
    HEAD_BYTES,
    PreviewState,
    ReferenceKind,
    ensure_range,
    host_of,
    text_in,
    type_of,
)
from app.sound_lists.errors import CueNotFound
from app.sound_lists.queries import cue_by_id

ONE_OPENING = timedelta(minutes=10)  # within it a player's requests, and a second look, are one opening
SCOPE = "references:"  # of uploads, before the id of their project


@dataclass(frozen=True)
class Content:
    """The content for a version: a finished upload, or a link."""

    upload_id: UUID | None
    url: str | None


def ensure_may_upload(session: Session, actor: Actor, project_id: UUID, length: int) -> UUID:
    """Return the studio that an upload of a reference belongs to; raise unless the caller may add it there."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    studio_id = access.project.studio_id
    ensure_quota(session, studio_id, QuotaKind.REFERENCE_BYTES, queries.kept_reference_bytes, added=length)
    return studio_id


def upload_scope(project_id: UUID) -> str:
    """Return the scope of uploads that become references of a project."""
    return f"{SCOPE}{project_id}"


def ensure_may_continue(session: Session, actor: Actor, scope: str) -> None:
    """Raise unless the caller still may add references where an upload of that scope began."""
    project_access(session, actor, UUID(scope.removeprefix(SCOPE))).ensure_may_speak()


def on_board(
    session: Session,
    actor: Actor,
    project_id: UUID,
    *,
    cue_id: UUID | None,
    only_words: bool,
    before: UUID | None,
    limit: int,
) -> tuple[ProjectAccess, Sequence[ReferenceVersion]]:
    """Return the references of a project, of one cue and its category, or those that show words; newest first."""
    access = project_access(session, actor, project_id)
    pinned_to = None
    if cue_id is not None:
        cue = cue_by_id(session, cue_id)
        if cue is None or cue.project_id != project_id:
            raise CueNotFound(f"no cue {cue_id}")
        pinned_to = queries.PinnedTo(cue.id, cue.category)
    return access, queries.newest_versions(
        session, project_id, pinned_to=pinned_to, only_words=only_words, before=before, limit=limit
    )


def add(
    session: Session, actor: Actor, project_id: UUID, *, content: Content, facts: Mapping[str, Any], store: Store
) -> ReferenceVersion:
    """Put a file or a link on the board; `facts` are the columns of Reference that people write."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    _ensure_pin(session, project_id, facts)
    reference = Reference(
        studio_id=access.project.studio_id,
        project_id=project_id,
        newest_number=1,
        added_by=actor.person,
        **facts,
    )
    version = _version_of(session, actor, reference, content, store)
    ensure_range(version.kind, reference.start_s, reference.end_s)
    return _added(session, reference, version)


def add_version(
    session: Session, actor: Actor, reference_id: UUID, *, content: Content, store: Store
) -> ReferenceVersion:
    """Replace the file or link of a reference; the older versions stay, and its caption, terms and pin."""
    _ensure_may_change(session, actor, reference_id)
    reference = _locked(session, reference_id)
    version = _version_of(session, actor, reference, content, store)
    ensure_range(version.kind, reference.start_s, reference.end_s)
    reference.newest_number += 1
    version.number = reference.newest_number
    return _added(session, reference, version)


def change(session: Session, actor: Actor, reference_id: UUID, changes: Mapping[str, Any]) -> ReferenceVersion:
    """Change caption, terms, range or pin; a new pin replaces the old one."""
    version = _ensure_may_change(session, actor, reference_id)
    reference = _locked(session, reference_id)
    if changes.get("cue_id") is not None or changes.get("category") is not None:
        changes = {"cue_id": None, "category": None, **changes}
    _ensure_pin(session, reference.project_id, changes)
    for name, value in changes.items():
        setattr(reference, name, value)
    ensure_range(version.kind, reference.start_s, reference.end_s)
    session.flush()
    return _seen_by_id(session, reference_id)


def remove(session: Session, actor: Actor, reference_id: UUID) -> None:
    """Take a reference off the board; its versions and the record of who opened them stay."""
    _ensure_may_change(session, actor, reference_id)
    reference = _locked(session, reference_id)
    reference.removed_at, reference.removed_by = clock.now(), actor.person
    session.flush()


def versions_of(session: Session, actor: Actor, reference_id: UUID) -> Sequence[ReferenceVersion]:
    """Return the versions of a reference within the caller's sight, newest first."""
    _reference_seen(session, actor, _seen_by_id(session, reference_id))
    return queries.versions_of(session, reference_id)


def version_seen(session: Session, actor: Actor, version_id: UUID) -> ReferenceVersion:
    """Return a version within the caller's sight."""
    version = queries.version_by_id(session, version_id)
    if version is None:
        raise ReferenceNotFound(f"no version {version_id} of a reference")
    try:
        project_access(session, actor, version.project_id)
    except ProjectNotFound:
        raise ReferenceNotFound(f"no version {version_id} of a reference") from None
    return version


def record_opening(session: Session, actor: Actor, version_id: UUID) -> None:
    """Record that the caller opens a version; what they opened minutes ago is not recorded again."""
    version = version_seen(session, actor, version_id)
    last = queries.last_opened_at(session, version_id, actor.person)
    if last is None or clock.now() - last >= ONE_OPENING:
        opening = ReferenceOpening(
            studio_id=version.studio_id, project_id=version.project_id, version_id=version_id, person_id=actor.person
        )
        session.add(opening)
        session.flush()


def opened_file(session: Session, actor: Actor, version_id: UUID) -> ReferenceVersion:
    """Return a version that has a file, and whose opening by the caller is on record."""
    version = version_seen(session, actor, version_id)
    if version.sha256 is None:
        raise ReferenceNotFound("this reference is a link; it has no file")
    if queries.last_opened_at(session, version_id, actor.person) is None:
        raise ReferenceUnopened(
            "who opens a reference is recorded first, and this was not",
            fix=f"send POST /v1/reference-versions/{version_id}/openings, then ask again",
        )
    return version


def drawn(sha256: str | None) -> str:
    """Return the hash of a preview; raise NoPreview where there is none."""
    if sha256 is None:
        raise NoPreview("no preview is drawn of this")
    return sha256


def openings_of(
    session: Session, actor: Actor, project_id: UUID, *, reference_id: UUID | None, before: UUID | None, limit: int
) -> Sequence[ReferenceOpening]:
    """Return to the team who opened what, newest first."""
    project_access(session, actor, project_id).ensure_may_speak()
    return queries.openings(session, project_id, reference_id=reference_id, before=before, limit=limit)


def access_to(session: Session, actor: Actor, version: ReferenceVersion) -> ProjectAccess:
    """Return the caller's access to the project of a version."""
    return project_access(session, actor, version.project_id)


def reference_to_change(session: Session, actor: Actor, reference_id: UUID) -> tuple[ProjectAccess, ReferenceVersion]:
    """Return the newest version of a reference that the caller may change, and their access to its project."""
    version = _ensure_may_change(session, actor, reference_id)
    return access_to(session, actor, version), version


def _seen_by_id(session: Session, reference_id: UUID) -> ReferenceVersion:
    version = queries.newest_version(session, reference_id)
    if version is None:
        raise ReferenceNotFound(f"no reference {reference_id}")
    return version


def _reference_seen(session: Session, actor: Actor, version: ReferenceVersion) -> ProjectAccess:
    try:
        return project_access(session, actor, version.project_id)
    except ProjectNotFound:
        raise ReferenceNotFound(f"no reference {version.reference_id}") from None


def _ensure_may_change(session: Session, actor: Actor, reference_id: UUID) -> ReferenceVersion:
    version = _seen_by_id(session, reference_id)
    _reference_seen(session, actor, version).ensure_may_speak()
    return version


def _locked(session: Session, reference_id: UUID) -> Reference:
    reference = queries.reference_locked(session, reference_id)
    if reference is None:  # removed between two of our statements
        raise ReferenceNotFound(f"no reference {reference_id}")
    return reference


def _ensure_pin(session: Session, project_id: UUID, facts: Mapping[str, Any]) -> None:
    cue_id, category = facts.get("cue_id"), facts.get("category")
    if cue_id is not None and category is not None:
        raise _invalid("category", "pin it to a cue or to a category, not to both")
    if cue_id is not None:
        cue = cue_by_id(session, cue_id)
        if cue is None or cue.project_id != project_id:
            raise CueNotFound(f"no cue {cue_id}")
    if category is not None and not queries.has_category(session, project_id, category):
        raise _invalid("category", f"no cue of this list has the category {category}")


def _version_of(
    session: Session, actor: Actor, reference: Reference, content: Content, store: Store
) -> ReferenceVersion:
    if (content.upload_id is None) == (content.url is None):
        raise _invalid("url", "send a file or an address, one of the two")
    of_both = {"studio_id": reference.studio_id, "project_id": reference.project_id, "added_by": actor.person}
    if content.upload_id is None:
        url = content.url or ""
        return ReferenceVersion(
            **of_both, number=1, kind=ReferenceKind.LINK, media_type="text/uri-list", file_name=host_of(url), url=url,
            excerpt="", preview=PreviewState.NONE,
        )  # fmt: skip
    scope = upload_scope(reference.project_id)
    upload = finished_upload(session, content.upload_id, owner_id=actor.person, scope=scope)
    return _version_of_file(of_both, upload, _head(store, reference.studio_id, upload))


def _version_of_file(of_both: Mapping[str, Any], upload: FinishedUpload, head: bytes) -> ReferenceVersion:
    if not upload.size_bytes:
        raise _invalid("upload_id", "this file is empty")
    file_type = type_of(head)
    is_picture = file_type.kind is ReferenceKind.PICTURE
    return ReferenceVersion(
        **of_both,
        number=1,
        kind=file_type.kind,
        media_type=file_type.media_type,
        file_name=upload.file_name,
        sha256=upload.sha256,
        file_bytes=upload.size_bytes,
        excerpt=(text_in(head) or "")[:EXCERPT_CHARS] if file_type.kind is ReferenceKind.TEXT else "",
        preview=PreviewState.PENDING if is_picture else PreviewState.NONE,
    )


def _head(store: Store, studio_id: UUID, upload: FinishedUpload) -> bytes:
    end = min(HEAD_BYTES, upload.size_bytes)
    return b"".join(store.stream(studio_id, upload.sha256, 0, end)) if end else b""


def _added(session: Session, reference: Reference, version: ReferenceVersion) -> ReferenceVersion:
    session.add(reference)
    session.flush()
    version.reference_id = reference.id
    session.add(version)
    session.flush()
    if version.preview is PreviewState.PENDING:
        publish(session, "reference.added", studio_id=reference.studio_id, version_id=version.id)
    session.expire(version)
    return _seen_by_id(session, reference.id)


def _invalid(where: str, message: str) -> ReferenceInvalid:
    return ReferenceInvalid(message, errors=[FieldProblem(where=where, message=message)])
