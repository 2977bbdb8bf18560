"""Scenes of approved sounds whose previews are real, drawn without their masters being checked and rendered."""

from typing import Any
from uuid import UUID

import numpy as np
from numpy.typing import NDArray

from app.builds.audits.models import AuditedSound, BuildAudit
from app.builds.audits.rules import AuditStatus
from app.core.db import new_id
from app.deliveries.rules import TakeState
from app.renders.models import Picture
from tests.app.reviews.making import Stage, add_take
from tests.support.server import World
from tests.support.waves import noise, wav_bytes

Samples = NDArray[np.float64]
THUMB = {"points": 1, "min": [-9], "max": [9], "rms": [3]}


def drawn_take(stage: Stage, cue_id: UUID | None, samples: Samples, *, rate: int = 48_000, **facts: Any) -> UUID:
    """Deliver a version that waits, with a preview of these samples."""
    world = stage.world
    content = wav_bytes(samples, rate=rate, bits=16)
    stored = world.server.runtime.store.put(world.studio_id, [content])
    sha256 = f"{new_id().hex}{new_id().hex}"

    def add(session: Any) -> UUID:
        take_id = add_take(
            session, world, stage.delivery_id, cue_id, facts.pop("variation", 1), master_sha256=sha256,
            is_drawn=False, **facts,
        )  # fmt: skip
        picture = Picture(
            studio_id=world.studio_id,
            sound_sha256=sha256,
            duration_s=len(samples) / rate,
            thumb=THUMB,
            preview_sha256=stored.sha256,
            preview_media_type="audio/wav",
        )
        session.add(picture)
        return take_id

    made: UUID = world.server.in_database(add)
    return made


def approved(stage: Stage, name: str, samples: Samples | None = None, **facts: Any) -> tuple[UUID, UUID]:
    """Put a cue on the list with its approved version; return both ids."""
    cue_id = stage.cue(name, **facts)
    sound = noise(dbfs=-20.0, seconds=0.5, seed=hash(name) % 1_000) if samples is None else samples
    return cue_id, drawn_take(stage, cue_id, sound, state=TakeState.APPROVED)


def add_audit(world: World, gains: dict[UUID, float], label: str = "Build 481") -> None:
    """Post an audit that says how loud a build plays cues."""

    def add(session: Any) -> None:
        of = {"studio_id": world.studio_id, "project_id": world.project_id}
        audit = BuildAudit(**of, label=label, sounds=len(gains), drifted=0, new_drifts=0, unread=[])
        session.add(audit)
        session.flush()
        for place, (cue_id, gain_db) in enumerate(gains.items()):
            session.add(
                AuditedSound(
                    **of, audit_id=audit.id, place=place, path=f"{place}.wav", cue_id=cue_id, status=AuditStatus.SAME,
                    played_status=AuditStatus.SAME, has_drifted=False, gain_db=gain_db, file_db=0.0,
                    property_db=gain_db, message="", moves=[], depends=[], events=[],
                )
            )  # fmt: skip

    world.server.in_database(add)


def opened_scene(world: World, take_id: UUID, *, settled: bool = True) -> dict[str, Any]:
    """Open the scene of a version as a reviewer, and again once all is measured."""
    answer = world.reviewer.post(f"/v1/takes/{take_id}/scene")
    assert answer.status_code == 200, answer.text
    if settled:
        world.server.wait_for_jobs()
        answer = world.reviewer.post(f"/v1/takes/{take_id}/scene")
    body: dict[str, Any] = answer.json()
    return body


def masking(world: World, take_id: UUID, **levels: float) -> dict[str, Any]:
    """Ask which bands are heard, in the scene as it is or among some lanes."""
    lanes = [f"{name}:{level}" for name, level in levels.items()]
    answer = world.reviewer.get(f"/v1/takes/{take_id}/masking", params={"lane": lanes} if lanes else None)
    assert answer.status_code == 200, answer.text
    body: dict[str, Any] = answer.json()
    return body
