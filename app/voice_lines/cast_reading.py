"""Facts of the whole script, as it is shown: languages, characters, and their performers."""

from collections import Counter, defaultdict
from uuid import UUID

from sqlalchemy.orm import Session

from app.projects.service import ProjectAccess
from app.voice_lines import queries
from app.voice_lines.reading import ScriptReader, may_change
from app.voice_lines.schemas import CastingRead, CharacterRead, VoiceScriptRead


def read_script(session: Session, access: ProjectAccess) -> VoiceScriptRead:
    """Return the settings, the languages and the cast of a project's script."""
    reader = ScriptReader(session, access)
    counts = Counter(line.character_id for line in reader.lines)
    castings: dict[UUID, list[CastingRead]] = defaultdict(list)
    for casting in queries.castings_of(session, access.project.id):
        performer = casting.performer.name if casting.performer else None
        castings[casting.character_id].append(
            CastingRead(
                language=casting.language, performer=performer, directed_by=casting.directed_by, cast_by=casting.cast_by
            )
        )
    return VoiceScriptRead(
        original_language=reader.original_language,
        length_tolerance_percent=reader.tolerance_percent,
        languages=reader.languages,
        characters=[
            CharacterRead(
                id=character.id,
                name=character.name,
                notes=character.notes,
                lines=counts[character.id],
                castings=castings[character.id],
            )
            for character in queries.characters_of(session, access.project.id)
        ],
        lines=len(reader.lines),
        may_change=may_change(access),
    )
