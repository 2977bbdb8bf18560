"""Releases of performers: added with their dates, taken off, and what is not covered by one."""

from collections import Counter, defaultdict
from collections.abc import Mapping
from datetime import date
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.core import clock
from app.core.plural import counted, verb
from app.core.uploads import finished_upload
from app.projects.service import ProjectAccess, project_access
from app.references.service import upload_scope
from app.sound_lists.queries import lock_list
from app.sound_lists.rules import tidy_line, tidy_text
from app.voice_lines import queries
from app.voice_lines.errors import ReleaseNotFound
from app.voice_lines.models import Casting, Release
from app.voice_lines.reading import ScriptReader, may_change
from app.voice_lines.rules import LineState, Validity, is_covered
from app.voice_lines.schemas import PerformerRead, ReleaseRead, ReleasesRead
from app.voice_lines.service import access_or, invalid, performer_named

MAX_RELEASE_BYTES = 50_000_000


def add_release(
    session: Session, actor: Actor, project_id: UUID, *, performer: str, upload_id: UUID, facts: Mapping[str, Any]
) -> ProjectAccess:
    """File a signed release of a performer; `facts` are its dates, its word on synthetic use, and a note."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    upload = finished_upload(session, upload_id, owner_id=actor.person, scope=upload_scope(project_id))
    if not 0 < upload.size_bytes <= MAX_RELEASE_BYTES:
        raise invalid(
            "upload_id", f"a release has 1 to {MAX_RELEASE_BYTES:,} bytes; this file has {upload.size_bytes:,}"
        )
    if facts["valid_until"] is not None and facts["valid_until"] < facts["valid_from"]:
        raise invalid("valid_until", "the last day is before the first; wanted the same day or a later one")
    name = tidy_line(performer)
    if not name:
        raise invalid("performer", "enter the name of the performer")
    lock_list(session, project_id)
    release = Release(
        studio_id=access.project.studio_id,
        project_id=project_id,
        performer_id=performer_named(session, access, name).id,
        file_name=upload.file_name,
        sha256=upload.sha256,
        file_bytes=upload.size_bytes,
        added_by=actor.person,
        **{**facts, "note": tidy_text(facts["note"])},
    )
    session.add(release)
    session.flush()
    return access


def remove_release(session: Session, actor: Actor, release_id: UUID) -> None:
    """Take a release off the list; its file and record stay."""
    release, access = _seen(session, actor, queries.release_by_id(session, release_id, locked=True), release_id)
    access.ensure_may_speak()
    release.removed_at, release.removed_by = clock.now(), actor.person
    session.flush()


def release_seen(session: Session, actor: Actor, release_id: UUID) -> Release:
    """Return a release within the caller's sight."""
    release, _ = _seen(session, actor, queries.release_by_id(session, release_id), release_id)
    return release


def releases_read(session: Session, access: ProjectAccess) -> ReleasesRead:
    """Return each performer with their parts and releases, and how many approved lines no release covers today."""
    project_id, today = access.project.id, clock.now().date()
    castings = queries.castings_of(session, project_id)
    names = {character.id: character.name for character in queries.characters_of(session, project_id)}
    approved = _approved_lines(session, access)
    releases = defaultdict(list)
    for release in queries.releases_of(session, project_id):
        releases[release.performer_id].append(release)
    parts: dict[UUID, list[Casting]] = defaultdict(list)
    for casting in castings:
        if casting.performer_id is not None:
            parts[casting.performer_id].append(casting)
    performers = []
    for performer in queries.performers_of(session, project_id):
        of_them, own_parts = releases[performer.id], parts[performer.id]
        lines = sum(approved[part.character_id, part.language] for part in own_parts)
        if of_them or own_parts:
            performers.append(
                PerformerRead(
                    name=performer.name,
                    parts=[f"{names[part.character_id]}, {part.language}" for part in own_parts],
                    approved_lines=lines,
                    releases=[_read(performer_release, today) for performer_release in of_them],
                    warning=_warning(of_them, lines, today),
                )
            )
    cast = {
        (set_casting.character_id, set_casting.language)
        for set_casting in castings
        if set_casting.performer_id is not None
    }
    return ReleasesRead(
        performers=performers,
        lines_without_performer=sum(lines for part, lines in approved.items() if part not in cast),
        may_change=may_change(access),
    )


def _approved_lines(session: Session, access: ProjectAccess) -> Counter[tuple[UUID, str]]:
    """Return the number of approved lines, by character and language."""
    reader = ScriptReader(session, access)
    every = (line for language in reader.languages for line in reader.in_language(language))
    return Counter((line.character.id, line.language) for line in every if line.state is LineState.APPROVED)


def _warning(releases: list[Release], lines: int, today: date) -> str:
    if not lines:
        return ""
    count = f"{counted(lines, 'approved line')} {verb(lines, 'has', 'have')}"
    if not releases:
        return f"{count} no release"
    dates = [Validity(release.valid_from, release.valid_until) for release in releases]
    if not is_covered(dates, today):
        return f"{count} no release that is valid today"
    return ""


def _read(release: Release, today: date) -> ReleaseRead:
    shown = ("id", "file_name", "file_bytes", "valid_from", "valid_until", "synthetic_use", "note", "added_at")
    return ReleaseRead(
        **{name: getattr(release, name) for name in shown},
        is_valid=is_covered([Validity(release.valid_from, release.valid_until)], today),
        added_by=PersonBrief.model_validate(release.adder),
    )


def _seen(session: Session, actor: Actor, release: Release | None, release_id: UUID) -> tuple[Release, ProjectAccess]:
    missing = ReleaseNotFound(f"no release {release_id}")
    if release is None:
        raise missing
    return release, access_or(session, actor, release.project_id, missing)
