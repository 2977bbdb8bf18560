"""Sounds that a designer may hear of the other designers of a project."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.deliveries.rules import TakeState
from app.deliveries.schemas import CueBrief
from app.projects.service import project_access
from app.renders.other_sounds.queries import other_sounds
from app.renders.schemas import OtherSound
from app.renders.service import sound_places
from app.sound_lists.rules import label


def sounds_of_others(
    session: Session, actor: Actor, project_id: UUID, *, palette: bool, before: UUID | None, limit: int
) -> list[OtherSound]:
    """Return the sounds of other designers that the caller may hear, the newest first; raise DesignerNeeded for others.

    Neither who made them nor the names of their files are among the facts.
    """
    access = project_access(session, actor, project_id)
    access.ensure_designer()
    rows = other_sounds(session, actor, project_id, palette=palette, before=before, limit=limit)
    return [
        OtherSound(
            **sound_places(picture, picture.thumb),
            id=take.id,
            cue=CueBrief(id=cue.id, label=label(access.project.cue_prefix, cue.number), name=cue.name),
            category=cue.category,
            variation=take.variation,
            variations=cue.variations,
            is_palette=cue.palette,
            is_approved=take.state is TakeState.APPROVED,
        )
        for take, cue, picture in rows
    ]
