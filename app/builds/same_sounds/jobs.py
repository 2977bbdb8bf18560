"""The job that looks for a take's sound in the studio's other projects."""

from uuid import UUID

import structlog

from app.builds.same_sounds import queries
from app.builds.same_sounds import service as same_sounds
from app.builds.same_sounds.models import MasterFingerprint
from app.conformance import checking
from app.core.events import publish
from app.core.jobs.queue import BULK, Payload, job
from app.core.runtime import Runtime
from app.core.storage import BlobAltered, BlobMissing
from app.deliveries.queries import take_with_cue
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
EARLIER_AT_ONCE = 50  # takes approved before masters were fingerprinted; each of them asks for the next ones


@job("builds.compare_take")
def compare_take(runtime: Runtime, payload: Payload) -> None:
    """Fingerprint a take's master and look for its sound among the approved ones of the studio's other projects."""
    with runtime.database.reading() as session:
        take = take_with_cue(session, UUID(payload["take_id"]))
        if take is None:
            return
        take_id, project_id = take.id, take.project_id
        studio_id, sha256, size_bytes = take.studio_id, take.master_sha256, take.master_bytes
        is_known = queries.has_master_fingerprint(session, studio_id, sha256)
    if not is_known:
        try:
            known_sounds = _known(runtime, studio_id, sha256, size_bytes)
        except (BlobAltered, BlobMissing) as error:
            # Nothing is recorded: once it is restored, the next check or approval compares it.
            log.warning("a master could not be compared", sha256=sha256, error=str(error))
            return
        with runtime.database.writing() as session:
            same_sounds.save_master_fingerprint(session, studio_id, sha256, known_sounds)
    matches = _found_elsewhere(runtime, studio_id, project_id, sha256)
    with runtime.database.writing() as session:
        if matches:
            same_sounds.save_same_sounds(session, take_id, matches)
        publish(session, "take.fingerprinted", studio_id=studio_id, take_id=take_id)
        for earlier in queries.approved_without_fingerprint(session, studio_id, EARLIER_AT_ONCE):
            runtime.queue.enqueue(
                session,
                "builds.compare_take",
                {"take_id": str(earlier)},
                key=f"builds.compare_take:{FINGERPRINT_VERSION}:{earlier}",
                studio_id=studio_id,
                priority=BULK,
            )


def _known(runtime: Runtime, studio_id: UUID, sha256: str, size_bytes: int) -> SoundSignature | None:
    try:
        with (
            runtime.store.local_copy(studio_id, sha256) as path,
            checking.sandbox().child(timeout_s=checking.time_for(size_bytes), reads=[path]) as child,
        ):
            return child.call(sound_signature, str(path))
    except (Unreadable, SandboxFailed) as error:
        log.info("a master could not be fingerprinted", sha256=sha256, error=str(error))
        return None


def _found_elsewhere(
    runtime: Runtime, studio_id: UUID, project_id: UUID, sha256: str
) -> list[same_sounds.FoundElsewhere]:
    with runtime.database.reading() as session:
        mine = queries.master_fingerprints(session, studio_id, [sha256]).get(sha256)
        if mine is None or mine.fingerprint is None:
            return []
        elsewhere = queries.approved_moments_elsewhere(session, studio_id, project_id)
    places = likely_sounds(mine.fingerprint, [moments for _, moments in elsewhere])
    with runtime.database.reading() as session:
        likely = queries.master_fingerprints(session, studio_id, [elsewhere[index][0] for index in places])
    return [match for other in likely.values() if (match := _compared(mine, other)) is not None]


def _compared(mine: MasterFingerprint, other: MasterFingerprint) -> same_sounds.FoundElsewhere | None:
    if mine.fingerprint is None or other.fingerprint is None:
        return None
    difference = difference_of(other.fingerprint, mine.fingerprint)
    if difference is None:
        return None
    return same_sounds.FoundElsewhere(
        other.sound_sha256,
        difference,
        has_same_samples=mine.pcm_sha256 == other.pcm_sha256,
        is_resampled=mine.sample_rate_hz != other.sample_rate_hz,
    )
