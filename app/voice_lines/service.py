"""The script as people change it: texts, directions, settings, and who speaks, directs and casts."""

from collections.abc import Mapping
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.core.errors import FieldProblem, NotFound
from app.projects.errors import ProjectNotFound
from app.projects.service import ProjectAccess, project_access
from app.sound_lists.queries import lock_list
from app.sound_lists.rules import folded, tidy_line, tidy_text
from app.voice_lines import queries
from app.voice_lines.errors import CharacterNotFound, VoiceLineInvalid, VoiceLineNotFound, VoiceTextChanged
from app.voice_lines.imports import new_version
from app.voice_lines.models import Casting, Character, Performer, VoiceLine, VoiceSettings, VoiceText
from app.voice_lines.rules import language_tag


def tag_of(text: str, where: str = "language") -> str:
    """Return the language tag that a request names; raise VoiceLineInvalid where it names none."""
    tag = language_tag(text)
    if tag is None:
        raise invalid(where, f'"{text[:40]}" is not a language; wanted a tag such as en, de or pt-BR')
    return tag


def change_settings(
    session: Session, actor: Actor, project_id: UUID, *, original_language: str, tolerance_percent: int
) -> ProjectAccess:
    """Set the original language, and by how much a length may differ from the original's before it is marked."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    lock_list(session, project_id)
    settings = queries.settings_of(session, project_id)
    if settings is None:
        settings = VoiceSettings(studio_id=access.project.studio_id, project_id=project_id)
        session.add(settings)
    settings.original_language = tag_of(original_language, "original_language")
    settings.tolerance_percent = tolerance_percent
    session.flush()
    return access


def change_line(session: Session, actor: Actor, line_id: UUID, changes: Mapping[str, Any]) -> VoiceLine:
    """Change scene or direction of a line."""
    line = line_seen(session, actor, line_id, to_change=True)
    if "scene" in changes:
        line.scene = tidy_line(changes["scene"])
    if "direction" in changes:
        line.direction = tidy_line(changes["direction"])
    session.flush()
    return line


def change_text(
    session: Session, actor: Actor, line_id: UUID, language: str, *, words: str, number: int, takes_fit: bool
) -> VoiceLine:
    """Give a line new words in a language; takes that exist become stale, unless they are said to fit."""
    line = line_seen(session, actor, line_id, to_change=True)
    text = _text_locked(session, line_id, language)
    if text.newest_number != number:
        raise VoiceTextChanged(
            f"the text is at version {text.newest_number} now; this change was made from version {number}",
            fix="read the line again, then change it",
        )
    tidied = tidy_text(words)
    if not tidied:
        raise invalid("text", "enter what is spoken")
    version = new_version(text, tidied, actor.person) if tidied != text.text else queries.newest_version(session, text)
    if takes_fit:
        version.takes_fit_at, version.takes_fit_by = clock.now(), actor.person
    session.add(version)
    session.flush()
    return line


def change_character(session: Session, actor: Actor, character_id: UUID, notes: str) -> ProjectAccess:
    """Describe an intended voice."""
    access, character = _character_to_change(session, actor, character_id)
    character.notes = tidy_text(notes)
    session.flush()
    return access


def cast(
    session: Session, actor: Actor, character_id: UUID, language: str, *, performer: str, directed_by: str, cast_by: str
) -> ProjectAccess:
    """Name a character's performer in a language, the session director, and the person who casts."""
    access, character = _character_to_change(session, actor, character_id)
    lock_list(session, access.project.id)
    casting = queries.casting_of(session, character_id, language)
    if casting is None:
        of = {"studio_id": character.studio_id, "project_id": character.project_id}
        casting = Casting(**of, character_id=character_id, language=language)
        session.add(casting)
    name = tidy_line(performer)
    casting.performer_id = performer_named(session, access, name).id if name else None
    casting.directed_by, casting.cast_by = tidy_line(directed_by), tidy_line(cast_by)
    session.flush()
    session.expire(casting)
    return access


def performer_named(session: Session, access: ProjectAccess, name: str) -> Performer:
    """Return the performer of that name in the locked list of a project; a new one where there is none."""
    key, project = folded(name), access.project
    same_performer = next(
        (performer for performer in queries.performers_of(session, project.id) if performer.folded == key), None
    )
    if same_performer is None:
        same_performer = Performer(studio_id=project.studio_id, project_id=project.id, name=name, folded=key)
        session.add(same_performer)
        session.flush()
    return same_performer


def line_seen(session: Session, actor: Actor, line_id: UUID, *, to_change: bool = False) -> VoiceLine:
    """Return a line within the caller's sight; with `to_change`, raise unless they act for the team."""
    line = queries.line_by_id(session, line_id)
    missing = VoiceLineNotFound(f"no voice line {line_id}")
    if line is None:
        raise missing
    access = access_or(session, actor, line.project_id, missing)
    if to_change:
        access.ensure_may_speak()
    return line


def access_or(session: Session, actor: Actor, project_id: UUID, missing: NotFound) -> ProjectAccess:
    """Return the caller's access to a project; raise `missing` where they do not see it."""
    try:
        return project_access(session, actor, project_id)
    except ProjectNotFound:
        raise missing from None


def invalid(where: str, message: str) -> VoiceLineInvalid:
    """Return the refusal of one field."""
    return VoiceLineInvalid(message, errors=[FieldProblem(where=where, message=message)])


def _text_locked(session: Session, line_id: UUID, language: str) -> VoiceText:
    text = queries.text_locked(session, line_id, language)
    if text is None:
        raise VoiceLineNotFound(f"voice line {line_id} has no text in {language}")
    return text


def _character_to_change(session: Session, actor: Actor, character_id: UUID) -> tuple[ProjectAccess, Character]:
    character = queries.character_by_id(session, character_id)
    missing = CharacterNotFound(f"no character {character_id}")
    if character is None:
        raise missing
    access = access_or(session, actor, character.project_id, missing)
    access.ensure_may_speak()
    return access, character
