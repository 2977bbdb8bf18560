"""Builds and what packs are made of, read from the database; callers have checked who looks."""

from collections import defaultdict
from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import func, select
from sqlalchemy.orm import Session, defer, undefer

from app.builds.models import Build
from app.renders.models import Render
from app.sound_lists.models import Cue, Stem
from app.sound_lists.rules import CueState

IDS_AT_ONCE = 500


def builds_of(session: Session, project_id: UUID, *, before: UUID | None, limit: int) -> Sequence[Build]:
    """Return builds without their reports, the newest first."""
    query = select(Build).where(Build.project_id == project_id)
    if before is not None:
        query = query.where(Build.id < before)
    return session.scalars(query.options(defer(Build.report)).order_by(Build.id.desc()).limit(limit)).all()


def build_by_id(session: Session, build_id: UUID) -> Build | None:
    """Return a build with its report."""
    return session.scalar(select(Build).where(Build.id == build_id).options(undefer(Build.report)))


def stems_of_project(session: Session, project_id: UUID) -> dict[tuple[UUID, int], str]:
    """Return the stem of each cue and variation."""
    rows = session.execute(select(Stem.cue_id, Stem.variation, Stem.stem).where(Stem.project_id == project_id))
    return {(cue_id, variation): stem for cue_id, variation, stem in rows}


def wanted_cues(session: Session, project_id: UUID) -> int:
    """Return how many cues of the list are not cut."""
    query = select(func.count()).where(Cue.project_id == project_id, Cue.state != CueState.CUT)
    return session.scalar(query) or 0


def render_hashes(session: Session, take_ids: Collection[UUID]) -> dict[UUID, list[str]]:
    """Return the sample hashes of every game file ever made of takes."""
    found: dict[UUID, list[str]] = defaultdict(list)
    wanted = list(take_ids)
    for start in range(0, len(wanted), IDS_AT_ONCE):
        rows = session.execute(
            select(Render.take_id, Render.pcm_sha256)
            .where(Render.take_id.in_(wanted[start : start + IDS_AT_ONCE]), Render.pcm_sha256.is_not(None))
            .order_by(Render.id)
        )
        for take_id, pcm_sha256 in rows:
            found[take_id].append(str(pcm_sha256))
    return found
