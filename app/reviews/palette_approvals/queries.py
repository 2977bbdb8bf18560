"""The palette of a project and its approval."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session, joinedload

from app.reviews.models import PaletteApproval
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState


def palette_cues(session: Session, project_id: UUID) -> Sequence[Cue]:
    """Return the cues of a palette that are not cut, in list order."""
    palette = select(Cue).where(Cue.project_id == project_id, Cue.palette, Cue.state != CueState.CUT)
    return session.scalars(palette.order_by(Cue.position, Cue.number)).all()


def newest_approval(session: Session, project_id: UUID) -> PaletteApproval | None:
    """Return the newest approval of a palette, with its approver."""
    approvals = select(PaletteApproval).where(PaletteApproval.project_id == project_id)
    newest = approvals.options(joinedload(PaletteApproval.approver)).order_by(PaletteApproval.id.desc())
    return session.scalar(newest.limit(1))
