"""The files of earlier packs, and the sounds that an adopted game plays already."""

from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.builds.engine_export.cues import Handoff
from app.builds.models import PackedFile, SealedPack
from app.builds.rules import FileKind, PackState
from app.deliveries.models import Adoption
from app.reviews.models import GameLevel


def handed_paths(session: Session, project_id: UUID, target: str, handoff: Handoff) -> set[str]:
    """Return the game files that a target's sealed packs with an engine export contain."""
    paths = session.scalars(
        select(PackedFile.path)
        .join(SealedPack, SealedPack.id == PackedFile.pack_id)
        .where(
            SealedPack.project_id == project_id,
            SealedPack.target == target,
            SealedPack.handoff == handoff,
            SealedPack.state == PackState.SEALED,
            PackedFile.kind.in_((FileKind.GAME, FileKind.PLACEHOLDER)),
        )
        .distinct()
    )
    return set(paths)


def cues_of_the_game(session: Session, project_id: UUID, handoff: Handoff) -> set[UUID]:
    """Return the cues that the adopted game plays already, where its project is one of the export's engine."""
    adoptions = select(Adoption.game["engine"].as_string()).where(
        Adoption.project_id == project_id,
        Adoption.game.is_not(None),
        Adoption.adopted_at.is_not(None),
        Adoption.undone_at.is_(None),
    )
    if handoff not in session.scalars(adoptions).all():
        return set()
    return set(session.scalars(select(GameLevel.cue_id).where(GameLevel.project_id == project_id).distinct()))
