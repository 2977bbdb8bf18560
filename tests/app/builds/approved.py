"""Sounds delivered, checked, rendered and approved, as users do it, for the tests of this room."""

from typing import Any
from zlib import crc32

import numpy as np

from tests.support.deliver import add_cues, deliver, open_delivery
from tests.support.server import World
from tests.support.waves import noise, wav_bytes

RATE = 44_100


def sound(seed: int, *, rate: int = RATE, seconds: float = 0.25) -> bytes:
    """A short burst that conforms: 24 bit, mono, well below full scale, without silent edges."""
    fade = np.minimum(1.0, np.linspace(0, 20, round(seconds * rate)))[:, np.newaxis]
    return wav_bytes(noise(dbfs=-24, seconds=seconds, rate=rate, seed=seed) * fade, rate=rate, bits=24)


def approve(
    world: World, cues: list[dict[str, Any]], *, delivery_id: str | None = None, **more: Any
) -> dict[str, bytes]:
    """Deliver and approve a sound for every stem of cues; return the masters by stem."""
    delivery_id = delivery_id or open_delivery(world)
    stems = [stem for cue in cues for stem in cue["stems"]]
    masters = {stem: sound(crc32(stem.encode()), **more) for stem in stems}  # no two alike: those are one take
    takes = {stem: deliver(world, f"{stem}.wav", master, delivery_id=delivery_id) for stem, master in masters.items()}
    world.server.wait_for_jobs()
    for take in takes.values():
        given = world.approver.post(f"/v1/takes/{take['id']}/verdict", json={"kind": "approve", "note": ""})
        assert given.status_code == 200, given.text
    world.server.wait_for_jobs()
    return masters


def accepted_list(world: World) -> dict[str, bytes]:
    """A list with a set of two and a single sound accepted, and one cue that nobody delivered; the masters by stem."""
    cues = add_cues(
        world,
        {"name": "Laser fire", "variations": 2, "category": "weapon", "description": "=bright, thin"},
        {"name": "UI confirm", "file_name": "ui_confirm"},
        {"name": "Warp in"},
    )
    return approve(world, cues[:2])
