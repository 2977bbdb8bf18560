"""The `bext` chunk of a broadcast wave: who made the sound, when, and how loud they say it is.

Source: EBU Tech 3285, version 2.
"""

from __future__ import annotations

import struct

from audio_checks.metadata.text import text_of

FIXED_BYTES = 602  # before the coding history
FIELDS = (
    "Description",
    "Originator",
    "OriginatorReference",
    "OriginationDate",
    "OriginationTime",
    "TimeReference",
    "Version",
    "UMID",
    "LoudnessValue",
    "LoudnessRange",
    "MaxTruePeakLevel",
    "MaxMomentaryLoudness",
    "MaxShortTermLoudness",
    "CodingHistory",
)
_TEXTS = tuple(zip(FIELDS[:5], (256, 32, 32, 10, 8), strict=True))
_LEVELS = FIELDS[8:13]
_UNSET_LEVEL = 0x7FFF
_LEVELS_SINCE, _UMID_SINCE = 2, 1  # versions


def read_bext(payload: bytes) -> dict[str, str]:
    """Return the fields that the chunk fills, in the chunk's order.

    Parameters
    ----------
    payload : bytes
        Of the chunk.

    Returns
    -------
    dict of str
        Named as in the standard. `TimeReference` (in samples since midnight) and `Version` are always
        there; levels read in LUFS, LU or dBTP with two decimals.

    Raises
    ------
    ValueError
        The chunk is shorter than the standard's fixed part.
    """
    if len(payload) < FIXED_BYTES:
        raise ValueError(f'the "bext" chunk has {len(payload)} bytes; {FIXED_BYTES} or more are wanted')
    fields: dict[str, str] = {}
    at = 0
    for name, width in _TEXTS:
        fields[name] = text_of(payload[at : at + width])
        at += width
    time_reference, version = struct.unpack_from("<QH", payload, at)
    fields["TimeReference"], fields["Version"] = str(time_reference), str(version)
    umid = payload[at + 10 : at + 74]
    if version >= _UMID_SINCE and any(umid):
        fields["UMID"] = (umid if any(umid[32:]) else umid[:32]).hex()
    if version >= _LEVELS_SINCE:
        levels = struct.unpack_from("<5h", payload, at + 74)
        told = zip(_LEVELS, levels, strict=True)
        fields |= {name: f"{level / 100:.2f}" for name, level in told if level != _UNSET_LEVEL}
    fields["CodingHistory"] = text_of(payload[FIXED_BYTES:])
    return {name: text for name, text in fields.items() if text}
