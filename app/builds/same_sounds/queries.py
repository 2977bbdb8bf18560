"""Fingerprints of masters and the same sounds in other projects, read from the database; callers check access."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import exists, select
from sqlalchemy.orm import Session, aliased, joinedload

from app.builds.same_sounds.models import MasterFingerprint, SameSound
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.projects.models import Project
from audio_checks import FINGERPRINT_VERSION


def master_fingerprints(session: Session, studio_id: UUID, sha256s: Collection[str]) -> dict[str, MasterFingerprint]:
    """Return the fingerprints of masters by their hash, those of this version."""
    rows = session.scalars(
        select(MasterFingerprint).where(
            MasterFingerprint.studio_id == studio_id,
            in_array(MasterFingerprint.sound_sha256, sha256s),
            MasterFingerprint.fingerprint_version == FINGERPRINT_VERSION,
        )
    )
    return {row.sound_sha256: row for row in rows}


def has_master_fingerprint(session: Session, studio_id: UUID, sha256: str) -> bool:
    """Whether a master was fingerprinted by this version."""
    fingerprints = select(MasterFingerprint.sound_sha256).where(
        MasterFingerprint.studio_id == studio_id,
        MasterFingerprint.sound_sha256 == sha256,
        MasterFingerprint.fingerprint_version == FINGERPRINT_VERSION,
    )
    return session.scalar(fingerprints) is not None


def approved_moments_elsewhere(session: Session, studio_id: UUID, project_id: UUID) -> list[tuple[str, bytes]]:
    """Return hash and moments of each master that is approved in another project of the studio."""
    approved = exists().where(
        Take.studio_id == studio_id,
        Take.project_id != project_id,
        Take.state == TakeState.APPROVED,
        Take.master_sha256 == MasterFingerprint.sound_sha256,
    )
    rows = session.execute(
        select(MasterFingerprint.sound_sha256, MasterFingerprint.moments).where(
            MasterFingerprint.studio_id == studio_id,
            MasterFingerprint.fingerprint_version == FINGERPRINT_VERSION,
            MasterFingerprint.fingerprint.is_not(None),
            approved,
        )
    )
    return [(sha256, moments) for sha256, moments in rows]


def approved_takes_elsewhere(
    session: Session, studio_id: UUID, project_id: UUID, sha256s: Collection[str]
) -> Sequence[Take]:
    """Return the approved takes of some masters in other projects of the studio."""
    return session.scalars(
        select(Take).where(
            Take.studio_id == studio_id,
            Take.project_id != project_id,
            Take.state == TakeState.APPROVED,
            in_array(Take.master_sha256, sha256s),
        )
    ).all()


def approved_without_fingerprint(session: Session, studio_id: UUID, limit: int) -> Sequence[UUID]:
    """Return approved takes of a studio whose masters this version has not fingerprinted."""
    has_fingerprint = exists().where(
        MasterFingerprint.studio_id == studio_id,
        MasterFingerprint.sound_sha256 == Take.master_sha256,
        MasterFingerprint.fingerprint_version == FINGERPRINT_VERSION,
    )
    return session.scalars(
        select(Take.id)
        .where(Take.studio_id == studio_id, Take.state == TakeState.APPROVED, ~has_fingerprint)
        .order_by(Take.id)
        .limit(limit)
    ).all()


def same_sounds_of(session: Session, take_ids: Collection[UUID]) -> list[tuple[SameSound, Take, Project]]:
    """Return the approved takes of other projects that hold the same sounds, with their cues and projects."""
    other = aliased(Take)
    rows = session.execute(
        select(SameSound, other, Project)
        .join(other, other.id == SameSound.other_take_id)
        .join(Project, Project.id == other.project_id)
        .where(in_array(SameSound.take_id, take_ids), other.state == TakeState.APPROVED)
        .options(joinedload(other.cue))
        .order_by(Project.name, other.id)
    )
    return [(same, take, project) for same, take, project in rows]
