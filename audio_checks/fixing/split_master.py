"""One file of several sounds, split into its parts: at its regions, at its markers, or at its silences."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import BinaryIO, Literal

import numpy as np

from audio_checks import wav
from audio_checks.errors import SplitRefused, Unreadable
from audio_checks.fixing.samples import stretch
from audio_checks.measure.pauses import SHORTEST_S, Pauses
from audio_checks.metadata import CuePoint
from audio_checks.metadata.moving import MOST_BYTES, Move, bytes_outside_data, carried
from audio_checks.render.carried_chunks import metadata_of

SHORTEST_PAUSE_S = SHORTEST_S  # as the check `internal-silence` counts them
HEAD_S, TAIL_S = 0.002, 0.02  # of the silence around a sound, which goes along with it
MOST_PARTS = 100
FoundBy = Literal["regions", "markers", "silence"]
Stretch = tuple[int, int, str]  # first frame, the one after the last, and the text of its marker


@dataclass(frozen=True)
class SoundPart:
    """One part: from frame `first` up to, and without, frame `end`, its marker's text, and the file that holds it."""

    first: int
    end: int
    label: str
    file_name: str


@dataclass(frozen=True)
class SplitMaster:
    """The parts of a master in their order, how they were found, and the rate that counts their frames."""

    found_by: FoundBy
    sample_rate_hz: int
    parts: tuple[SoundPart, ...]


def split_master(
    path: str | os.PathLike[str], out: str | os.PathLike[str], *, shortest_pause_s: float = SHORTEST_PAUSE_S
) -> SplitMaster:
    """Write each part of a master into a folder as a file of its own.

    Regions are cut where they are marked. Between markers, and without any between pauses, a part is what sounds,
    with 2 ms of the silence before it and 20 ms of that after it, as far as there is so much; what is silent is left
    out. Samples, format and chunks are those of the master, byte for byte: nothing is faded, no level moved. Cue
    points, regions and loops go with the part in which they lie.

    Parameters
    ----------
    path : path
        A WAV or RF64 file; it is only read.
    out : path
        A folder that exists.
    shortest_pause_s : float
        Shorter silence is part of a sound. It counts only where the file has fewer than two markers.

    Raises
    ------
    SplitRefused
        `split:one-sound`, `split:too-many`, `split:large-chunks`, and `split:unreadable` for another file than WAV.
    """
    try:
        with wav.open_regular(path) as file:
            layout = wav.read_layout(file)
            found_by, stretches = _parts(file, layout, shortest_pause_s)
            _ensure_splittable(layout, found_by, len(stretches), shortest_pause_s)
            parts = [_written(file, layout, Path(out), number, part) for number, part in enumerate(stretches, 1)]
    except Unreadable as error:
        raise SplitRefused(str(error), "split:unreadable", error.fix) from error
    return SplitMaster(found_by, layout.sample_rate_hz, tuple(parts))


def _parts(file: BinaryIO, layout: wav.WavLayout, pause_s: float) -> tuple[FoundBy, list[Stretch]]:
    points = sorted(metadata_of(file, layout).cue_points, key=lambda point: point.frame)
    regions = list(_regions(points, layout.frames))
    if len(regions) > 1:
        return "regions", regions
    pauses = Pauses(layout.sample_rate_hz, layout.channels, layout.frames)
    for block in wav.blocks(file, layout):
        pauses.add(block)
    if len({point.frame for point in points}) > 1:
        return "markers", list(_sounding(file, layout, _between(points, layout.frames), pauses.threshold))
    pieces = _with_pauses(pauses.sounds(pause_s), layout.frames)
    return "silence", list(_sounding(file, layout, pieces, pauses.threshold))


def _regions(points: list[CuePoint], frames: int) -> Iterator[Stretch]:
    for point in points:
        end = min(point.frame + point.frames, frames)
        if point.frames and point.frame < end:
            yield point.frame, end, point.label


def _between(points: list[CuePoint], frames: int) -> Iterator[Stretch]:
    labels = {point.frame: point.label for point in reversed(points) if point.frame < frames}
    for first, end in pairwise([*sorted({0, *labels}), frames]):
        yield first, end, labels.get(first, "")


def _with_pauses(sounds: list[tuple[int, int]], frames: int) -> Iterator[Stretch]:
    """Yield the sounds with the silence around them, each half of a pause with its neighbour."""
    middles = [(end + first) // 2 for (_, end), (first, _) in pairwise(sounds)]
    for first, end in pairwise([0, *middles, frames]):
        yield first, end, ""


def _sounding(file: BinaryIO, layout: wav.WavLayout, pieces: Iterable[Stretch], threshold: float) -> Iterator[Stretch]:
    head, tail = (round(seconds * layout.sample_rate_hz) for seconds in (HEAD_S, TAIL_S))
    for first, end, label in pieces:
        edges = _edges(file, layout, first, end, threshold)
        if edges is not None:
            yield max(first, edges[0] - head), min(end, edges[1] + tail), label


def _edges(file: BinaryIO, layout: wav.WavLayout, first: int, end: int, threshold: float) -> tuple[int, int] | None:
    """Return the first frame of a stretch that is no silence, and the one after the last; None where all is."""
    start, sounding = first, []
    for block in stretch(file, layout, first, end):
        loud = np.flatnonzero(np.abs(block).max(axis=1) >= threshold) if threshold else np.empty(0, np.int64)
        sounding += [start + int(frame) for frame in loud[[0, -1]]] if len(loud) else []
        start += len(block)
    return (sounding[0], sounding[-1] + 1) if sounding else None


def _ensure_splittable(layout: wav.WavLayout, found_by: FoundBy, parts: int, shortest_pause_s: float) -> None:
    if parts < 2:
        words = {
            "silence": f"it holds one sound: no silence of {shortest_pause_s:g} s or more inside, and no two markers",
            "markers": "there is sound on one side of its markers only",
        }
        raise SplitRefused(
            words.get(found_by, "it holds one region"),
            "split:one-sound",
            "ask for shorter silences, or set a marker where each sound begins",
        )
    if parts > MOST_PARTS:
        raise SplitRefused(
            f"it has {parts} parts, and {MOST_PARTS} at most are made of a file",
            "split:too-many",
            "ask for longer silences, or take out markers",
        )
    if bytes_outside_data(layout) > MOST_BYTES:
        raise SplitRefused(
            f"it carries more than {MOST_BYTES >> 20} MiB beside its sound, and each part would carry them too",
            "split:large-chunks",
            "leave out what the file need not carry, such as pictures, and deliver it again",
        )


def _written(file: BinaryIO, layout: wav.WavLayout, out: Path, number: int, part: Stretch) -> SoundPart:
    first, end, label = part
    move = Move(first, end - first, changed=True, new_depth=None, only_inside=True)
    before, after = carried(file, layout, move)
    name = f"part_{number:03}.wav"
    wav.copy_stretch(file, layout, out / name, first, end, chunks=before, chunks_after=after)
    return SoundPart(first, end, label, name)
