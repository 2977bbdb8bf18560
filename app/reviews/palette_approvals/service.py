"""One act: the approver approves the palette once each of its sounds is accepted."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core.plural import counted
from app.projects.approval.service import ensure_may_approve
from app.projects.queries import lock_project
from app.projects.service import project_access
from app.reviews.errors import PaletteIncomplete
from app.reviews.models import PaletteApproval
from app.reviews.palette_approvals import queries
from app.reviews.queries import accepted_takes
from app.sound_lists.rules import label

ANY_CATEGORY = ""  # the palette is of many: the project's approver decides


def approve_palette(session: Session, actor: Actor, project_id: UUID) -> PaletteApproval:
    """Approve the palette as a set; raise PaletteIncomplete while it is empty or a sound of it is not accepted."""
    access = project_access(session, actor, project_id)
    ensure_may_approve(session, access, ANY_CATEGORY)
    lock_project(session, project_id)
    palette = queries.palette_cues(session, project_id)
    if not palette:
        raise PaletteIncomplete("no cue is marked as palette", fix="mark the reference sounds in the sound list")
    accepted = {cue.id for cue, _, _ in accepted_takes(session, project_id)}
    missing = [label(access.project.cue_prefix, cue.number) for cue in palette if cue.id not in accepted]
    if missing:
        raise PaletteIncomplete(
            f"{counted(len(missing), 'sound', 'sounds')} of the palette without an accepted version: "
            f"{', '.join(missing)}",
            fix="approve a version of each, then the palette",
        )
    approval = PaletteApproval(
        studio_id=access.project.studio_id,
        project_id=project_id,
        approved_by=actor.person,
        cue_ids=[str(cue.id) for cue in palette],
    )
    session.add(approval)
    session.flush()
    session.refresh(approval, ["approver"])
    return approval
