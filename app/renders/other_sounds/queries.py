"""Sounds of other designers that a project opens to those who are engaged on it."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import ColumnElement, Row, and_, exists, or_, select
from sqlalchemy.orm import Session, aliased

from app.accounts.rules import Actor
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.projects.rules import OPENS_APPROVED, OPENS_WAITING
from app.projects.visibility import project_opens
from app.renders.models import Picture
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState


def opened_takes(actor: Actor) -> ColumnElement[bool]:
    """Admit takes of cues that are not cut, as far as their project lets its designers hear them."""
    approved = and_(Take.state == TakeState.APPROVED, project_opens(actor, Take.project_id, OPENS_APPROVED))
    waiting = and_(Take.state == TakeState.CONFORMING, project_opens(actor, Take.project_id, OPENS_WAITING))
    cue = aliased(Cue)
    listed = exists().where(cue.id == Take.cue_id, cue.state != CueState.CUT)
    return and_(Take.discarded_at.is_(None), listed, or_(approved, waiting))


def other_sounds(
    session: Session, actor: Actor, project_id: UUID, *, palette: bool, before: UUID | None, limit: int
) -> Sequence[Row[Take, Cue, Picture]]:
    """Return takes of other designers that the caller may hear, with cue and picture, the newest first."""
    query = (
        select(Take, Cue, Picture)
        .join(Cue, Cue.id == Take.cue_id)
        .join(Picture, and_(Picture.studio_id == Take.studio_id, Picture.sound_sha256 == Take.master_sha256))
        .where(Take.project_id == project_id, Take.designer_id != actor.person_id, opened_takes(actor))
    )
    if palette:
        query = query.where(Cue.palette)
    if before is not None:
        query = query.where(Take.id < before)
    return session.execute(query.order_by(Take.id.desc()).limit(limit)).all()
