"""The job that makes a preview reel."""

import contextlib
import tempfile
from pathlib import Path
from typing import Any
from uuid import UUID

import numpy as np
import structlog

from app.core import kill_points
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.core.storage import BlobAltered, BlobMissing
from app.renders import queries
from app.renders.children import in_child, retried, sandbox
from app.renders.reels import service as reels
from app.renders.reels import sound as reel_sound
from audio_checks import (
    SandboxFailed,
    synthesize_speech,
)

log = structlog.get_logger(__name__)
NO_REEL = "the reel could not be made; that is our fault; the versions are not affected. Try again"


@job("renders.make_reel")
def make_reel(runtime: Runtime, payload: Payload) -> None:
    """Put the previews of a cue's takes in a row, each behind its slate."""
    reel_id = UUID(payload["reel_id"])
    with runtime.database.reading() as session:
        reel = queries.reel_by_id(session, reel_id)
    if reel is None or reel.sha256 is not None:
        return
    slates = None
    if reel.with_slates:
        slates = _slates(reel.takes, of_set=payload["sets"] == 1, speaks=payload["speaks"] == 1)
    with tempfile.TemporaryDirectory(prefix="soundlist-") as folder, contextlib.ExitStack() as copies:
        out = Path(folder, "reel.wav")
        try:
            paths = [
                str(copies.enter_context(runtime.store.local_copy(reel.studio_id, take["preview_sha256"])))
                for take in reel.takes
            ]
            made = retried(
                in_child(
                    sandbox(),
                    [Path(path) for path in paths],
                    [Path(folder)],
                    reel_sound.make_reel,
                    paths,
                    slates,
                    str(out),
                    gap_ms=reel.gap_ms,
                    crossfade_ms=reel.crossfade_ms,
                )
            )
        except (SandboxFailed, BlobAltered, BlobMissing) as error:
            log.error("a reel failed", reel_id=str(reel_id), error=str(error))
            with runtime.database.writing() as session:
                reels.refuse(session, reel_id, NO_REEL)
            return
        blob = runtime.store.put_file(reel.studio_id, out)
    kill_points.point("renders.before_reel")
    with runtime.database.writing() as session:
        is_spoken = slates is not None and all(slate.speech is not None for slate in slates)
        reels.keep(session, reel_id, blob, **made, is_spoken=is_spoken)


def _slates(takes: list[dict[str, Any]], *, of_set: bool, speaks: bool) -> list[reel_sound.Slate]:
    """Return the slates that announce the takes; all are beeped where one cannot be spoken."""
    # Outside of the child, which may start no other program: these words are our own, not a stranger's.
    slates = [reel_sound.Slate(take["variation"] if of_set else 0, take["number"], None) for take in takes]
    if not speaks:
        return slates
    spoken_slates = []
    for slate in slates:
        words = f"variation {slate.variation}, version {slate.version}" if of_set else f"version {slate.version}"
        spoken = synthesize_speech(words, reel_sound.SPEECH_RATE_HZ, None)
        if spoken is None:
            return slates
        speech = np.round(spoken * 32_767).astype("<i2").tobytes()
        spoken_slates.append(slate._replace(speech=speech))
    return spoken_slates
