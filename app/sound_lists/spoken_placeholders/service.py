"""Placeholders that a person says into a microphone: recorded for a cue, replaced, removed."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.core.events import publish
from app.core.storage import Store
from app.sound_lists import queries
from app.sound_lists.errors import CueIsCut, SpokenPlaceholderMissing
from app.sound_lists.models import Cue, SpokenPlaceholder
from app.sound_lists.rules import CueState
from app.sound_lists.service import visible_cue


def ensure_may_say(session: Session, actor: Actor, cue_id: UUID) -> Cue:
    """Return a cue that the caller may say a placeholder for; raise for any other."""
    access, cue = visible_cue(session, actor, cue_id)
    access.ensure_may_speak()
    if cue.state is CueState.CUT:
        raise CueIsCut("this cue is cut; the game plays no placeholder for it")
    return cue


def save_spoken_placeholder(
    session: Session, actor: Actor, cue_id: UUID, *, content: bytes, duration_s: float, store: Store
) -> SpokenPlaceholder:
    """Keep the recording spoken for a cue in place of an earlier one, and have its placeholder files made of it."""
    cue = ensure_may_say(session, actor, cue_id)
    queries.lock_list(session, cue.project_id)
    stored = store.put(cue.studio_id, [content])
    recording = queries.spoken_placeholder(session, cue_id)
    if recording is None:
        recording = SpokenPlaceholder(studio_id=cue.studio_id, project_id=cue.project_id, cue_id=cue_id)
        session.add(recording)
    recording.sha256, recording.file_bytes, recording.duration_s = stored.sha256, stored.size_bytes, duration_s
    recording.recorded_by, recording.recorded_at = actor.person, clock.now()
    session.flush()
    session.expire(recording)
    _publish(session, cue)
    return get_spoken_placeholder(session, actor, cue_id)


def get_spoken_placeholder(session: Session, actor: Actor, cue_id: UUID) -> SpokenPlaceholder:
    """Return a cue's spoken placeholder in the caller's sight; raise SpokenPlaceholderMissing without one."""
    visible_cue(session, actor, cue_id)
    recording = queries.spoken_placeholder(session, cue_id)
    if recording is None:
        raise SpokenPlaceholderMissing("no person said a placeholder for this cue")
    return recording


def remove_said(session: Session, actor: Actor, cue_id: UUID) -> None:
    """Remove the spoken placeholder of a cue; its placeholder files are made without it again."""
    cue = ensure_may_say(session, actor, cue_id)
    session.delete(get_spoken_placeholder(session, actor, cue_id))
    session.flush()
    _publish(session, cue)


def _publish(session: Session, cue: Cue) -> None:
    publish(session, "placeholder.said", studio_id=cue.studio_id, project_id=cue.project_id, cue_id=str(cue.id))
