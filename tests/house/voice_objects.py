"""A voice line with its text, performer and release, as part of one of everything."""

from datetime import date
from uuid import UUID

from sqlalchemy.orm import Session

from app.core import clock
from app.core.uploads import Upload
from app.references.service import upload_scope
from app.sound_lists.models import Cue
from app.voice_lines.models import Casting, Character, Performer, Release, VoiceLine, VoiceText, VoiceTextVersion
from app.voice_lines.rules import SyntheticUse


def add_voice_line(
    session: Session, of: dict[str, UUID], *, sha256: str, file_bytes: int, added_by: UUID
) -> dict[str, UUID | str]:
    """Add a character with one line in one language, and the release of its performer; return ids by path names."""
    character = Character(**of, name="Captain", folded="captain")
    performer = Performer(**of, name="The voice of the captain", folded="the voice of the captain")
    cue = Cue(**of, number=2, position=2, name="en_captain_001", file_name="en_captain_001", category="vo")
    session.add_all([character, performer, cue])
    session.flush()
    named = {"key": "captain_001", "folded": "captain_001", "file_name": "captain_001"}
    line = VoiceLine(**of, **named, character_id=character.id, scene="Bridge", position=1)
    session.add(line)
    session.flush()
    text = VoiceText(**of, line_id=line.id, language="en", cue_id=cue.id, text="Go.", newest_number=1)
    casting = Casting(**of, character_id=character.id, language="en", performer_id=performer.id)
    release = Release(
        **of,
        performer_id=performer.id,
        file_name="release.pdf",
        sha256=sha256,
        file_bytes=file_bytes,
        valid_from=date(2026, 1, 1),
        synthetic_use=SyntheticUse.NO,
        added_by=added_by,
    )
    upload = Upload(
        studio_id=of["studio_id"],
        owner_id=added_by,
        scope=upload_scope(of["project_id"]),
        file_name="release.pdf",
        length=file_bytes,
        sha256=sha256,
        finished_at=clock.now(),
    )
    session.add_all([text, casting, release, upload])
    session.flush()
    session.add(VoiceTextVersion(**of, text_id=text.id, number=1, text="Go.", written_by=added_by))
    return {
        "voice_line_id": line.id,
        "voice_character_id": character.id,
        "voice_release_id": release.id,
        "voice_upload_id": upload.id,
        "language": "en",
    }
