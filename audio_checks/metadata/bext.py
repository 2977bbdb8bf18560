"""The `bext` chunk of a broadcast wave: who made the sound, when, and how loud they say it is.

Sources: EBU Tech 3285, version 2; EBU R 98 (coding history).
"""

from __future__ import annotations

import struct
from collections.abc import Mapping

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
_VERSION_AT, LEVELS_AT = 346, 412
_LEVEL_FIELDS = struct.Struct("<5h")  # hundredths
_MEASURED_AS = (
    *("integrated_lufs", "loudness_range_lu", "true_peak_dbtp"),
    *("max_momentary_lufs", "max_short_term_lufs"),
)
_MOST_HUNDREDTHS = 9_999


def updated_levels(payload: bytes, figures: Mapping[str, float | None]) -> bytes | None:
    """Return the loudness fields of a copy whose samples are others: measured values, where the chunk has any.

    Parameters
    ----------
    payload : bytes
        Of the chunk, as the master has it.
    figures : mapping of str to float or None
        Measured of the copy, by their names in the report; None and -inf for silence.

    Returns
    -------
    bytes or None
        Five fields of 16 bits, in hundredths of LUFS, LU and dBTP, for `LEVELS_AT`. A field that says
        nothing stays empty, and so does one that cannot hold its figure (99.99 at most). None where the
        chunk has no such fields, or none of them is set.
    """
    if len(payload) < FIXED_BYTES or struct.unpack_from("<H", payload, _VERSION_AT)[0] < _LEVELS_SINCE:
        return None
    stored = _LEVEL_FIELDS.unpack_from(payload, LEVELS_AT)
    if all(level == _UNSET_LEVEL for level in stored):
        return None
    measured = (_hundredths(figures[name]) for name in _MEASURED_AS)
    return _LEVEL_FIELDS.pack(
        *(_UNSET_LEVEL if old == _UNSET_LEVEL else new for old, new in zip(stored, measured, strict=True))
    )


def _hundredths(level: float | None) -> int:
    if level is None or not abs(level) * 100 <= _MOST_HUNDREDTHS:
        return _UNSET_LEVEL
    return round(level * 100)


def coding_history_line(sample_rate_hz: int, bit_depth: int, channels: int) -> str:
    """Return the line that EBU R 98 asks of each step of a sound's way, without its end."""
    mode = {1: ",M=mono", 2: ",M=stereo"}.get(channels, "")
    return f"A=PCM,F={sample_rate_hz},W={bit_depth}{mode}"


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
        fields[name] = text_of(payload[at : at + width], is_fixed=True)
        at += width
    time_reference, version = struct.unpack_from("<QH", payload, at)
    fields["TimeReference"], fields["Version"] = str(time_reference), str(version)
    umid = payload[at + 10 : at + 74]
    if version >= _UMID_SINCE and any(umid):
        fields["UMID"] = (umid if any(umid[32:]) else umid[:32]).hex()
    if version >= _LEVELS_SINCE:
        levels = struct.unpack_from("<5h", payload, at + 74)
        stored = zip(_LEVELS, levels, strict=True)
        fields |= {name: f"{level / 100:.2f}" for name, level in stored if level != _UNSET_LEVEL}
    fields["CodingHistory"] = text_of(payload[FIXED_BYTES:])
    return {name: text for name, text in fields.items() if text}
