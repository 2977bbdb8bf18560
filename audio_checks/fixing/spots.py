"""The sound around each repair, before and after, on one axis of time: what a person looks at before they agree."""

import os
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, BinaryIO

from audio_checks import wav
from audio_checks.fixing.fixed import FixedMaster, Repair
from audio_checks.fixing.samples import stretch
from audio_checks.measure.waveform import Waveform, WaveShape

POINTS = 480  # across half a wide screen
AROUND_LEVEL_S = 0.015  # on each side of a peak: some periods of all but the lowest sounds
AROUND_CUT_S = 0.03  # of the sound beside a cut, at least
AROUND_CUT_SHARE = 0.15  # of what was cut


@dataclass(frozen=True)
class Spot:
    """One stretch of master and copy.

    Attributes
    ----------
    kind : str
        The repair that it shows: "gain", "head", "tail" or "offset".
    start_s, end_s : float
        Of the stretch, in the master.
    after_start_s, after_end_s : float
        What of it is left in the copy, by the time of the master.
    before, after : WaveShape
        Of the stretch in the master, and of what is left of it in the copy; full scale ±1.0.
    """

    kind: str
    start_s: float
    end_s: float
    after_start_s: float
    after_end_s: float
    before: WaveShape
    after: WaveShape

    def to_dict(self) -> dict[str, Any]:
        """Return the spot as plain values."""
        return {
            "kind": self.kind,
            "start_s": self.start_s,
            "end_s": self.end_s,
            "after_start_s": self.after_start_s,
            "after_end_s": self.after_end_s,
            "before": self.before.to_dict(),
            "after": self.after.to_dict(),
        }


def repair_spots(path: str | os.PathLike[str], fixed: FixedMaster, points: int = POINTS) -> tuple[Spot, ...]:
    """Return the stretches of master and copy at which a repair can be seen.

    Parameters
    ----------
    path : path
        The master.
    fixed : FixedMaster
        What `fix_master` made of it.
    points : int
        Across a stretch; one of fewer frames gets a point a frame.

    Returns
    -------
    tuple of Spot
        Empty without a copy, and where only name, header or depth were put right.

    Raises
    ------
    Unreadable
        When master or copy became shorter meanwhile.
    """
    if fixed.path is None or fixed.before.facts is None:
        return ()
    with wav.open_regular(path) as master, wav.open_regular(fixed.path) as copy:
        pair = _Pair(master, copy, fixed.cut_frames[0], points)
        return tuple(pair.spots(fixed.repairs))


class _Pair:
    """A master and its copy, whose frames lie `cut` earlier."""

    def __init__(self, master: BinaryIO, copy: BinaryIO, cut: int, points: int) -> None:
        self._master, self._copy = master, copy
        self._before, self._after = wav.read_layout(master), wav.read_layout(copy)
        self._cut = cut
        self._points = points

    def spots(self, repairs: tuple[Repair, ...]) -> Iterator[Spot]:
        rate, whole = self._before.sample_rate_hz, self._before.frames
        around = round(AROUND_LEVEL_S * rate)
        for repair in repairs:
            if repair.start_s is None or repair.end_s is None:
                continue
            first, end = round(repair.start_s * rate), round(repair.end_s * rate)
            beside = max(round(AROUND_CUT_S * rate), round(AROUND_CUT_SHARE * (end - first)))
            if repair.kind == "offset":
                yield self._spot(repair.kind, first, min(end, first + 2 * round(AROUND_CUT_S * rate)))
            elif repair.kind == "gain":
                yield self._spot(repair.kind, first - around, first + around)
            elif repair.kind == "head":
                yield self._spot(repair.kind, 0, end + beside)
            elif repair.kind == "tail":
                yield self._spot(repair.kind, first - beside, whole)

    def _spot(self, kind: str, first: int, end: int) -> Spot:
        rate = self._before.sample_rate_hz
        first, end = max(first, 0), min(end, self._before.frames)
        left_first = max(first, self._cut)
        left_end = max(left_first, min(end, self._cut + self._after.frames))
        left_points = max(1, round(self._points * (left_end - left_first) / (end - first)))
        return Spot(
            kind=kind,
            start_s=first / rate,
            end_s=end / rate,
            after_start_s=left_first / rate,
            after_end_s=left_end / rate,
            before=_shape(self._master, self._before, first, end, self._points),
            after=_shape(self._copy, self._after, left_first - self._cut, left_end - self._cut, left_points),
        )


def _shape(file: BinaryIO, layout: wav.WavLayout, first: int, end: int, points: int) -> WaveShape:
    shape = Waveform(layout.sample_rate_hz, layout.channels, end - first, points)
    for block in stretch(file, layout, first, end):
        shape.add(block)
    return shape.result()
