"""Loudness that whole mixes are held to, as information: what a programme or half an hour of play should measure.

One effect is not a mix, and is never judged by these; a spec bounds the loudness of files by `[limits] loudness_lufs`.
Sources: EBU R 128 (2023); Sony's Audio Standards Working Group, ASWG-R001, average loudness of at least
30 minutes of representative play.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class LoudnessPreset:
    """The target figures of a whole mix.

    Attributes
    ----------
    loudness_lufs, tolerance_lu : float
        Integrated loudness, and how far it may be off.
    true_peak_dbtp : float
        The highest true peak.
    meant_for : str
        What is to be measured.
    """

    loudness_lufs: float
    tolerance_lu: float
    true_peak_dbtp: float
    meant_for: str

    def against(self, measurements: Mapping[str, Any]) -> dict[str, Any]:
        """Return a mix's relation to it.

        Parameters
        ----------
        measurements : mapping
            With `integrated_lufs` and `true_peak_dbtp`; -inf and None have no distance.

        Returns
        -------
        dict
            The figures wanted, `loudness_off_lu` and `true_peak_over_db` (negative is room), and
            `within`: whether both hold, None where one is unknown.
        """
        off = _apart(measurements.get("integrated_lufs"), self.loudness_lufs)
        over = _apart(measurements.get("true_peak_dbtp"), self.true_peak_dbtp)
        within = None if off is None or over is None else abs(off) <= self.tolerance_lu and over <= 0
        return {
            "loudness_lufs": self.loudness_lufs,
            "tolerance_lu": self.tolerance_lu,
            "loudness_off_lu": off,
            "true_peak_dbtp": self.true_peak_dbtp,
            "true_peak_over_db": over,
            "within": within,
        }


PRESETS: dict[str, LoudnessPreset] = {
    "ebu-r128": LoudnessPreset(-23.0, 0.5, -1.0, "a whole programme, such as a trailer for television"),
    "aswg-home": LoudnessPreset(-24.0, 2.0, -1.0, "30 minutes of play or more, on consoles and PC"),
    "aswg-portable": LoudnessPreset(-18.0, 2.0, -1.0, "30 minutes of play or more, on handhelds and phones"),
}


def _apart(level: float | None, target: float) -> float | None:
    return None if level is None or not math.isfinite(level) else level - target


def in_words(name: str, stands: Mapping[str, Any]) -> str:
    """Return a mix's relation to a preset, as one line."""
    off, over = stands["loudness_off_lu"], stands["true_peak_over_db"]
    if off is None or over is None:
        return f"{name}: too short or too quiet to have a loudness as a mix"
    side = "over" if off > 0 else "under"
    room = f"true peak {over:.1f} dB over {stands['true_peak_dbtp']:g} dBTP" if over > 0 else "true peak within"
    loud = f"{abs(off):.1f} LU {side} {stands['loudness_lufs']:g} LUFS (±{stands['tolerance_lu']:g})"
    return f"{name}: {loud}, {room}"
