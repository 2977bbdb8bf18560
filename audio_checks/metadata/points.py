"""The chunks that name places and notes of a sound: `cue `, `smpl` and `inst`.

Sources: Multimedia Programming Interface and Data Specifications 1.0, chapter 3; Multimedia Data
Standards Update (1994) for `smpl` and `inst`.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from audio_checks.system.plural import counted

MOST_POINTS = 10_000


@dataclass(frozen=True)
class CuePoint:
    """A marked place: its number, the frame it stands at, what it is called ("" for nothing), and a region's length."""

    number: int
    frame: int
    label: str = ""
    frames: int = 0  # of a region; 0 for a marker


@dataclass(frozen=True)
class Instrument:
    """A sampler's settings for the sound; a figure that no chunk gives is None.

    Attributes
    ----------
    unity_note : int or None
        MIDI note (0..127) at which it plays at its own pitch.
    fine_tune_cents : float or None
        How far it is to be tuned up, in cents.
    gain_db : int or None
        Suggested gain, in dB.
    notes, velocities : (int, int) or None
        Lowest and highest.
    """

    unity_note: int | None = None
    fine_tune_cents: float | None = None
    gain_db: int | None = None
    notes: tuple[int, int] | None = None
    velocities: tuple[int, int] | None = None


def read_cue(
    payload: bytes, labels: Mapping[int, str], lengths: Mapping[int, int] = MappingProxyType({})
) -> tuple[CuePoint, ...]:
    """Return the cue points in the chunk's order.

    Parameters
    ----------
    payload : bytes
        Of the chunk.
    labels, lengths : mapping
        Of the LIST/adtl chunk, by cue point: texts, and the frames of regions.

    Raises
    ------
    ValueError
        The chunk announces more points than it holds, or too many.
    """
    if len(payload) < 4:
        raise ValueError(f'the "cue " chunk has {len(payload)} bytes; 4 or more are wanted')
    (count,) = struct.unpack_from("<I", payload)
    if count > min((len(payload) - 4) // 24, MOST_POINTS):
        raise ValueError(
            f'the "cue " chunk announces {counted(count, "point")}, more than it holds or than {MOST_POINTS}'
        )
    points = (struct.unpack_from("<2I4s3I", payload, 4 + 24 * index) for index in range(count))
    return tuple(
        CuePoint(number, frame, labels.get(number, ""), lengths.get(number, 0)) for number, _, _, _, _, frame in points
    )


def read_smpl(payload: bytes) -> Instrument:
    """Return the note of a `smpl` chunk; its loops are read with the file's layout.

    Raises
    ------
    ValueError
        The chunk is too short.
    """
    if len(payload) < 36:
        raise ValueError(f'the "smpl" chunk has {len(payload)} bytes; 36 or more are wanted')
    note, fraction = struct.unpack_from("<2I", payload, 12)
    return Instrument(unity_note=note if note < 128 else None, fine_tune_cents=100 * fraction / 2**32)


def read_inst(payload: bytes) -> Instrument:
    """Return the content of an `inst` chunk.

    Raises
    ------
    ValueError
        The chunk is too short.
    """
    if len(payload) < 7:
        raise ValueError(f'the "inst" chunk has {len(payload)} bytes; 7 are wanted')
    note, tune, gain, low_note, high_note, low_velocity, high_velocity = struct.unpack_from("<BbbBBBB", payload)
    return Instrument(
        unity_note=note if note < 128 else None,
        fine_tune_cents=float(tune),
        gain_db=gain,
        notes=(low_note, high_note),
        velocities=(low_velocity, high_velocity),
    )
