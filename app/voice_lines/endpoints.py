"""The endpoints of this room."""

import base64
from typing import Annotated, Any
from uuid import UUID

from fastapi import APIRouter, Depends, Query, Request, Response

from app.accounts.rules import Actor, Audience, Scope
from app.accounts.web.policies import allows
from app.core.parsing_queue import ParsingBusy, parse_request
from app.core.web.bodies import LARGE_BODY_BYTES, accepts_body
from app.core.web.downloads import downloads, file_response
from app.core.web.http import DbSession, problems
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.projects.service import ensure_speaks_in, project_access
from app.sound_lists.errors import CueNotFound
from app.sound_lists.people.service import known_people
from app.sound_lists.queries import cues_of, own_columns
from app.sound_lists.service import visible_cue
from app.sound_lists.sheets.export import sound_list_csv
from app.sound_lists.sheets.rules import Sheet, SheetOptions
from app.voice_lines import line_sheets, queries, service
from app.voice_lines.cast_reading import read_script
from app.voice_lines.errors import (
    CharacterNotFound,
    ScriptUnreadable,
    SpeakerMissing,
    VoiceLineInvalid,
    VoiceLineNotFound,
    VoiceTextChanged,
)
from app.voice_lines.imports import import_script
from app.voice_lines.reading import ScriptReader, line_of_cue
from app.voice_lines.rules import LineState
from app.voice_lines.schemas import (
    CastingChange,
    CharacterChange,
    PickUpsRead,
    ScriptAsk,
    ScriptRead,
    VoiceLineChange,
    VoiceLineRead,
    VoiceLines,
    VoiceScriptRead,
    VoiceSettingsChange,
    VoiceTextChange,
)
from app.voice_lines.script_text import read_script_bytes, read_script_text

router = APIRouter(prefix="/v1", tags=["voice lines"])
MAY_SEE: Actor = allows(Audience.PROJECT)
TEAM: Actor = allows(Audience.TEAM)
SentScript = tuple[ScriptAsk, Sheet]
XLSX = "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet"
CSV = "text/csv; charset=utf-8"
InLanguage = Annotated[str | None, Query(max_length=40, description="A tag such as de; empty: the original language.")]
OfLanguage = Annotated[str | None, Query(max_length=40, description="Only those of this language.")]
OfCharacter = Annotated[UUID | None, Query(description="Only those of this character.")]


@router.get(
    "/projects/{project_id}/sound-list.csv",
    **downloads("text/csv", ProjectNotFound),
)
def export_sound_list(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT, build=Scope.LIST_READ)
) -> Response:
    """Return the list as the CSV that `audio-checks check --list` and spreadsheets read."""
    access = project_access(session, actor, project_id)
    text = sound_list_csv(
        cues_of(session, project_id),
        own_columns(session, project_id),
        known_people(session, access),
        access.project.cue_prefix,
        queries.languages_by_cue(session, project_id),
    )
    return file_response(text, CSV, "sounds.csv")


@router.get("/projects/{project_id}/voice-script", responses=problems(ProjectNotFound))
def get_voice_script(project_id: UUID, session: DbSession, actor: Actor = MAY_SEE) -> VoiceScriptRead:
    """Return the languages, the characters and the cast of the script."""
    return read_script(session, project_access(session, actor, project_id))


@router.put("/projects/{project_id}/voice-settings", responses=problems(ProjectNotFound, TeamNeeded, VoiceLineInvalid))
def change_voice_settings(
    project_id: UUID, body: VoiceSettingsChange, session: DbSession, actor: Actor = TEAM
) -> VoiceScriptRead:
    """Set the original language, and how far a length may be from the original's before it is marked."""
    access = service.change_settings(
        session,
        actor,
        project_id,
        original_language=body.original_language,
        tolerance_percent=body.length_tolerance_percent,
    )
    return read_script(session, access)


@router.get("/projects/{project_id}/voice-lines", responses=problems(ProjectNotFound, VoiceLineInvalid))
def list_voice_lines(
    project_id: UUID,
    session: DbSession,
    language: InLanguage = None,
    state: LineState | None = None,
    character: OfCharacter = None,
    search: Annotated[str, Query(max_length=200)] = "",
    start: Annotated[int, Query(ge=0, le=1_000_000, description="`next` of the page before.")] = 0,
    actor: Actor = MAY_SEE,
) -> VoiceLines:
    """Return the lines of the script in one language, in the order of the script."""
    reader = ScriptReader(session, project_access(session, actor, project_id))
    tag = service.tag_of(language) if language else reader.original_language
    return reader.page(tag, state=state, character_id=character, search=search, start=start)


async def _parsed(project_id: UUID, body: ScriptAsk, request: Request) -> SentScript:
    is_sheet = body.format != "script"
    if body.text is not None:
        arguments: tuple[Any, ...] = (read_script_text, body.text, is_sheet, body.format == "paste")
    elif body.content_base64 is None:
        raise ScriptUnreadable("nothing was sent; give text or content_base64")
    else:
        try:
            options = SheetOptions(body.tab, body.encoding, keep_hidden=body.keep_hidden)
            arguments = (read_script_bytes, base64.b64decode(body.content_base64, validate=True), is_sheet, options)
        except ValueError:
            raise ScriptUnreadable("content_base64 is not base64") from None
    parsed = await parse_request(
        request, *arguments, refusal=ScriptUnreadable, permit=ensure_speaks_in, whose=project_id
    )
    return body, Sheet(*parsed)


@router.post(
    "/projects/{project_id}/voice-lines/import",
    responses=problems(ProjectNotFound, TeamNeeded, ScriptUnreadable, SpeakerMissing, VoiceLineInvalid, ParsingBusy),
)
@accepts_body(LARGE_BODY_BYTES)
def import_voice_lines(
    project_id: UUID,
    actor: Annotated[Actor, TEAM],
    sent: Annotated[SentScript, Depends(_parsed)],
    session: DbSession,
) -> ScriptRead:
    """Read a script into the project; rows with an error are left out and named."""
    body, sheet = sent
    language = service.tag_of(body.language)
    return import_script(session, actor, project_id, sheet, body, language=language)


@router.get(
    "/projects/{project_id}/voice-lines.csv",
    **downloads("text/csv", ProjectNotFound),
)
def export_voice_lines(project_id: UUID, session: DbSession, actor: Actor = MAY_SEE) -> Response:
    """Return the script in all its languages as the CSV that the import reads."""
    reader = ScriptReader(session, project_access(session, actor, project_id))
    text = line_sheets.script_csv({language: reader.in_language(language) for language in reader.languages})
    return _file(text, CSV, "voice-lines.csv")


@router.get("/projects/{project_id}/pick-ups", responses=problems(ProjectNotFound, VoiceLineInvalid))
def list_pick_ups(
    project_id: UUID,
    session: DbSession,
    language: OfLanguage = None,
    character: OfCharacter = None,
    actor: Actor = MAY_SEE,
) -> PickUpsRead:
    """Return the next session's pick-ups and reasons: no take yet, returned, change requested, or the text changed."""
    return _pick_ups(session, actor, project_id, language, character)


@router.get(
    "/projects/{project_id}/pick-ups.csv",
    **downloads("text/csv", ProjectNotFound, VoiceLineInvalid),
)
def export_pick_ups_csv(
    project_id: UUID,
    session: DbSession,
    language: OfLanguage = None,
    character: OfCharacter = None,
    actor: Actor = MAY_SEE,
) -> Response:
    """Return the pick-up list as CSV."""
    lines = _pick_ups(session, actor, project_id, language, character).lines
    return _file(line_sheets.pick_up_csv(lines), CSV, "pick-ups.csv")


@router.get(
    "/projects/{project_id}/pick-ups.xlsx",
    **downloads(XLSX, ProjectNotFound, VoiceLineInvalid),
)
def export_pick_ups_xlsx(
    project_id: UUID,
    session: DbSession,
    language: OfLanguage = None,
    character: OfCharacter = None,
    actor: Actor = MAY_SEE,
) -> Response:
    """Return the pick-up list as a workbook, ready to print."""
    lines = _pick_ups(session, actor, project_id, language, character).lines
    return _file(line_sheets.pick_up_xlsx(lines), XLSX, "pick-ups.xlsx")


@router.get("/cues/{cue_id}/voice-line", responses=problems(CueNotFound))
def get_voice_line_of_cue(cue_id: UUID, session: DbSession, actor: Actor = MAY_SEE) -> VoiceLineRead | None:
    """Return the voice line that a cue is for; null for a cue that is none."""
    access, _ = visible_cue(session, actor, cue_id)
    return line_of_cue(session, access, cue_id)


@router.patch("/voice-lines/{voice_line_id}", status_code=204, responses=problems(VoiceLineNotFound, TeamNeeded))
def change_voice_line(voice_line_id: UUID, body: VoiceLineChange, session: DbSession, actor: Actor = TEAM) -> None:
    """Change scene or direction of a line."""
    service.change_line(session, actor, voice_line_id, body.model_dump(exclude_unset=True))


@router.put(
    "/voice-lines/{voice_line_id}/texts/{language}",
    status_code=204,
    responses=problems(VoiceLineNotFound, TeamNeeded, VoiceTextChanged, VoiceLineInvalid),
)
def change_voice_text(
    voice_line_id: UUID, language: str, body: VoiceTextChange, session: DbSession, actor: Actor = TEAM
) -> None:
    """Change the spoken text; takes that exist become stale, unless they are said to fit."""
    service.change_text(
        session,
        actor,
        voice_line_id,
        language,
        words=body.text,
        number=body.text_version,
        takes_fit=body.takes_fit,
    )


@router.patch("/voice-characters/{voice_character_id}", responses=problems(CharacterNotFound, TeamNeeded))
def change_voice_character(
    voice_character_id: UUID, body: CharacterChange, session: DbSession, actor: Actor = TEAM
) -> VoiceScriptRead:
    """Describe the intended voice of a character."""
    return read_script(session, service.change_character(session, actor, voice_character_id, body.notes))


@router.put(
    "/voice-characters/{voice_character_id}/castings/{language}",
    responses=problems(CharacterNotFound, TeamNeeded, VoiceLineInvalid),
)
def cast_voice_character(
    voice_character_id: UUID, language: str, body: CastingChange, session: DbSession, actor: Actor = TEAM
) -> VoiceScriptRead:
    """Name a character's performer in a language, the session director, and the person who casts."""
    tag = service.tag_of(language)
    return read_script(session, service.cast(session, actor, voice_character_id, tag, **body.model_dump()))


def _pick_ups(
    session: DbSession, actor: Actor, project_id: UUID, language: str | None, character: UUID | None
) -> PickUpsRead:
    reader = ScriptReader(session, project_access(session, actor, project_id))
    return reader.pick_ups(service.tag_of(language) if language else None, character)


def _file(content: str | bytes, media_type: str, name: str) -> Response:
    return file_response(content, media_type, name)
