"""What earlier packs handed over."""

from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.builds.handoff.cues import Handoff
from app.builds.models import PackedFile, SealedPack
from app.builds.rules import FileKind, PackState


def handed_paths(session: Session, project_id: UUID, target: str, handoff: Handoff) -> set[str]:
    """Return the game files that a target's sealed packs with a hand-off contain."""
    found = session.scalars(
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
    return set(found)
