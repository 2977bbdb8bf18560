"""A take's sound is looked for in the studio's other projects and in sound libraries."""

from uuid import UUID

import structlog
from sqlalchemy.orm import Session

from app.builds.libraries.jobs import library_matches
from app.builds.libraries.service import save_library_matches
from app.builds.same_sounds import queries, service
from app.builds.same_sounds.models import MasterFingerprint
from app.conformance import checking
from app.conformance.workspaces import TakeWorkspace
from app.core.jobs.queue import BULK, Payload, job
from app.core.runtime import Runtime
from app.core.storage import BlobAltered, BlobMissing
from app.deliveries.models import Take
from app.deliveries.queries import take_with_cue
from app.deliveries.rules import TakeState
from app.renders.children import children
from app.renders.take_jobs import last_step
from audio_checks import (
    FINGERPRINT_VERSION,
    SandboxFailed,
    SoundSignature,
    Unreadable,
    difference_of,
    likely_sounds,
    sound_signature,
)

log = structlog.get_logger(__name__)
COMPARED_STATES = (TakeState.CONFORMING, TakeState.APPROVED)
EARLIER_AT_ONCE = 50  # takes approved before masters were fingerprinted; each of them asks for the next ones


@job("builds.compare_take")
def compare_take(runtime: Runtime, payload: Payload) -> None:
    """Compare an approved take, and schedule the same for takes approved before masters were fingerprinted."""
    take_id = UUID(payload["take_id"])
    with TakeWorkspace(runtime.store, children()) as workspace:
        compare_checked_take(runtime, take_id, workspace)
    with runtime.database.reading() as session:
        take = take_with_cue(session, take_id)
        earlier = queries.approved_without_fingerprint(session, take.studio_id, EARLIER_AT_ONCE) if take else []
    if take is None or not earlier:
        return
    with runtime.database.writing() as session:
        for earlier_id in earlier:
            runtime.queue.enqueue(
                session,
                "builds.compare_take",
                {"take_id": str(earlier_id)},
                key=f"builds.compare_take:{FINGERPRINT_VERSION}:{earlier_id}",
                studio_id=take.studio_id,
                priority=BULK,
            )


@last_step
def compare_checked_take(runtime: Runtime, take_id: UUID, workspace: TakeWorkspace) -> None:
    """Fingerprint the master of a take that passed its check, and look for it in other projects and in libraries."""
    with runtime.database.reading() as session:
        take = take_with_cue(session, take_id)
        if take is None or take.cue_id is None or take.state not in COMPARED_STATES:
            return
        known = queries.master_fingerprints(session, take.studio_id, [take.master_sha256]).get(take.master_sha256)
    try:
        fingerprint = known or service.new_fingerprint(take.studio_id, take.master_sha256, _signature(take, workspace))
    except (BlobAltered, BlobMissing) as error:
        # Nothing is recorded: once it is restored, the next check or approval compares it.
        log.warning("a master could not be compared", sha256=take.master_sha256, error=str(error))
        return
    with runtime.database.reading() as session:
        elsewhere = _found_elsewhere(session, take.project_id, fingerprint)
        in_libraries = library_matches(session, fingerprint)
    if known and not elsewhere and not in_libraries:
        return
    with runtime.database.writing() as session:
        if not known:
            service.save_master_fingerprint(session, fingerprint)
        service.save_same_sounds(session, take_id, elsewhere)
        save_library_matches(session, take_id, in_libraries)


def _signature(take: Take, workspace: TakeWorkspace) -> SoundSignature | None:
    child = workspace.child(take.delivery_id)
    child.timeout_s = checking.time_for(take.master_bytes)
    try:
        return child.call(sound_signature, str(workspace.master(take.studio_id, take.master_sha256)))
    except (Unreadable, SandboxFailed) as error:
        log.info("a master could not be fingerprinted", sha256=take.master_sha256, error=str(error))
        return None


def _found_elsewhere(session: Session, project_id: UUID, mine: MasterFingerprint) -> list[service.FoundElsewhere]:
    if mine.fingerprint is None:
        return []
    elsewhere = queries.approved_moments_elsewhere(session, mine.studio_id, project_id)
    places = likely_sounds(mine.fingerprint, [moments for _, moments in elsewhere])
    if not places:
        return []
    likely = queries.master_fingerprints(session, mine.studio_id, [elsewhere[index][0] for index in places])
    return [match for other in likely.values() if (match := _compared(mine, other)) is not None]


def _compared(mine: MasterFingerprint, other: MasterFingerprint) -> service.FoundElsewhere | None:
    if mine.fingerprint is None or other.fingerprint is None:
        return None
    difference = difference_of(other.fingerprint, mine.fingerprint)
    if difference is None:
        return None
    return service.FoundElsewhere(
        other.sound_sha256,
        difference,
        has_same_samples=mine.pcm_sha256 == other.pcm_sha256,
        is_resampled=mine.sample_rate_hz != other.sample_rate_hz,
    )
