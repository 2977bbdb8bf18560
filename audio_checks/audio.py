"""A file to judge: its facts from the header, its figures from one pass over its bytes."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import PurePath
from types import TracebackType
from typing import Any, Protocol, Self

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.beside import DryStem, judged_beside
from audio_checks.hashes import Hashes
from audio_checks.judge import Judgement, judge
from audio_checks.measure import spare
from audio_checks.measure.bits import effective_bits
from audio_checks.measure.codec_frames import CodecFrames
from audio_checks.measure.cuts import Cuts
from audio_checks.measure.decay import Decay
from audio_checks.measure.edges import Edges
from audio_checks.measure.faults import DETECTORS, Faults
from audio_checks.measure.levels import Levels
from audio_checks.measure.likeness import Likeness
from audio_checks.measure.loudness import Loudness, channel_weights
from audio_checks.measure.phase import Phase
from audio_checks.measure.seam import Seam
from audio_checks.measure.spectrum import Spectrum
from audio_checks.measure.steps import Steps
from audio_checks.measure.survey import Survey
from audio_checks.measure.true_peak import TruePeak
from audio_checks.measurements import Measurements
from audio_checks.metadata import Metadata
from audio_checks.metadata.gather import Gathering
from audio_checks.sound_files import open_sound

READ_BYTES = 1 << 20


class Accumulator(Protocol):
    """Something that measures while a file streams by."""

    def add(self, block: NDArray[np.float64], /) -> None:
        """Take the next samples, shape (n, channels); the array holds others when `add` is called again."""

    def result(self) -> dict[str, Any]:
        """Return the figures, by name."""


def _size(layout: wav.WavLayout) -> tuple[int, int, int]:
    return layout.sample_rate_hz, layout.channels, layout.frames


def _step(layout: wav.WavLayout) -> float:
    return 2.0 ** (1 - layout.bit_depth) if layout.encoding == "pcm" else 0.0


def _loudness(layout: wav.WavLayout) -> Accumulator:
    return Loudness(*_size(layout), weights=channel_weights(layout.channels, layout.channel_mask))


def _seam(layout: wav.WavLayout) -> Accumulator:
    return Seam(*_size(layout), loop=(layout.loops[0].start, layout.loops[0].end) if layout.loops else None)


FIGURES: dict[str, tuple[str, ...]] = {
    "levels": Levels.FIGURES,
    "true_peak": TruePeak.FIGURES,
    "loudness": Loudness.FIGURES,
    "edges": Edges.FIGURES,
    "cuts": Cuts.FIGURES,
    **DETECTORS,
    "phase": Phase.FIGURES,
    "steps": Steps.FIGURES,
    "likeness": Likeness.FIGURES,
    "spectrum": Spectrum.FIGURES,
    "decay": Decay.FIGURES,
    "seam": Seam.FIGURES,
    "codec_frames": CodecFrames.FIGURES,
}
"""Families of figures; each family has one accumulator, but all that look for faults share one."""

MAKERS: dict[str, Callable[[wav.WavLayout, Survey], Accumulator]] = {
    "levels": lambda layout, survey: Levels(*_size(layout), survey=survey),
    "true_peak": lambda layout, survey: TruePeak(*_size(layout), survey=survey),
    "loudness": lambda layout, _: _loudness(layout),
    "edges": lambda layout, survey: Edges(*_size(layout), survey=survey),
    "cuts": lambda layout, survey: Cuts(*_size(layout), step=_step(layout), survey=survey),
    "phase": lambda layout, survey: Phase(*_size(layout), survey=survey),
    "steps": lambda layout, _: Steps(*_size(layout), step=_step(layout)),
    "likeness": lambda layout, _: Likeness(*_size(layout)),
    "spectrum": lambda layout, _: Spectrum(*_size(layout), step=_step(layout)),
    "decay": lambda layout, _: Decay(*_size(layout)),
    "seam": lambda layout, _: _seam(layout),
    "codec_frames": lambda layout, _: CodecFrames(*_size(layout), step=_step(layout)),
}
"""How each family's accumulator is made for a file; what a block's survey finds serves all of them."""

PART_FRAMES = 1 << 17
IN_PARTS = frozenset({"codec_frames", "decay", "likeness", "spectrum"})
"""Families that transform what they are given: that takes many times its memory, so they are given parts of a block."""


class InParts:
    """Hands blocks on in parts of PART_FRAMES."""

    def __init__(self, accumulator: Accumulator) -> None:
        self._accumulator = accumulator

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        for start in range(0, len(block), PART_FRAMES):
            self._accumulator.add(block[start : start + PART_FRAMES])

    def result(self) -> dict[str, Any]:
        """Return the figures, by name."""
        return self._accumulator.result()


FAMILIES = {figure: family for family, figures in FIGURES.items() for figure in figures}


def accumulators_of(layout: wav.WavLayout, families: Iterable[str]) -> list[Accumulator]:
    """Return new accumulators for what a file has, one for each family but one for all faults."""
    survey = Survey()
    wanted = sorted(families)
    accumulators: list[Accumulator] = []
    for family in wanted:
        if family in MAKERS:
            made = MAKERS[family](layout, survey)
            accumulators.append(InParts(made) if family in IN_PARTS else made)
    if detectors := [family for family in wanted if family in DETECTORS]:
        accumulators.append(Faults(*_size(layout), step=_step(layout), detectors=detectors, survey=survey))
    return accumulators


@dataclass(frozen=True)
class Facts:
    """What a file is.

    Attributes
    ----------
    container, encoding : str
        "wav", "rf64" or "flac"; "pcm" or "float".
    bit_depth : int
        Bits that count, as the header says.
    chunks : tuple of str
        The ids in their order; of FLAC the names of its metadata blocks.
    """

    container: str
    encoding: str
    sample_rate_hz: int
    bit_depth: int
    channels: int
    frames: int
    duration_s: float
    chunks: tuple[str, ...]
    _effective_bits: Callable[[], int | None] = field(repr=False, compare=False)
    _metadata: Callable[[], Metadata] = field(repr=False, compare=False)

    @property
    def effective_bits(self) -> int | None:
        """Bits that the samples make use of, the sign included; None for float. Streams the file once."""
        return self._effective_bits()

    def to_dict(self) -> dict[str, Any]:
        """Return the facts as the report lists them, metadata only where there is some. Streams the file once."""
        metadata = self._metadata().to_dict()
        return {
            "container": self.container,
            "encoding": self.encoding,
            "sample_rate_hz": self.sample_rate_hz,
            "bit_depth": self.bit_depth,
            "effective_bits": self.effective_bits,
            "channels": self.channels,
            "frames": self.frames,
            "duration_s": self.duration_s,
            "chunks": list(self.chunks),
            **({"metadata": metadata} if metadata else {}),
        }


class AudioFile:
    """A WAV or FLAC file, opened and found readable by its header.

    Parameters
    ----------
    path : path
        A regular file.
    name : str, optional
        The file name as delivered, when it differs from the path's.
    flac : bool
        Whether FLAC is read; it is unpacked to a WAV for that, in a throw-away child.

    Raises
    ------
    Unreadable
        When a rule of structure is broken. R7 (finite samples) shows only when the file streams.
    SandboxFailed
        When a FLAC could not be unpacked: for want of time, memory or disk, or because its decoder broke.
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        *,
        name: str | None = None,
        flac: bool = True,
        dry: DryStem | None = None,
    ) -> None:
        self.path = path
        self._dry = dry
        self.name = PurePath(os.fspath(path)).name if name is None else name
        self._sound = open_sound(path, name=name, flac=flac)
        self._file = self._sound.file
        self.layout = self._sound.layout
        self._wanted: set[str] | None = None
        self._figures: dict[str, Any] = {}
        self._measured: set[str] = set()
        self._hashes: tuple[str, str] | None = None
        self._effective_bits: int | None = None
        self._gathering = Gathering(self.layout.chunks)
        self._judgements: dict[tuple[str, str | None], Judgement] = {}

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Close the file; what was measured stays."""
        self._sound.close()
        for ring in ("facts", "measurements"):  # both lead back to the file, which would wait for the garbage collector
            self.__dict__.pop(ring, None)

    @property
    def stem(self) -> str:
        """The name without its ending."""
        return PurePath(self.name).stem

    @property
    def warnings(self) -> tuple[wav.StructureWarning, ...]:
        """What is odd about the structure, and harmless."""
        return self.layout.warnings

    @cached_property
    def facts(self) -> Facts:
        """What the header says; only `effective_bits` streams the file."""
        layout, flac = self.layout, self._sound.flac
        return Facts(
            container="flac" if flac else layout.container,
            encoding=layout.encoding,
            sample_rate_hz=layout.sample_rate_hz,
            bit_depth=layout.bit_depth,
            channels=layout.channels,
            frames=layout.frames,
            duration_s=layout.duration_s,
            chunks=flac.blocks if flac else tuple(chunk.id for chunk in layout.chunks),
            _effective_bits=self._bits_in_use,
            _metadata=lambda: self.metadata,
        )

    @cached_property
    def metadata(self) -> Metadata:
        """What the file says of itself beside its sound. Streams the file once."""
        self._hashed()
        metadata = self._gathering.read()
        if self._sound.flac is None:
            return metadata
        return replace(metadata, fields=metadata.fields | self._sound.flac.comment_fields)

    @cached_property
    def measurements(self) -> Measurements:
        """The figures; the first one asked for streams the file."""
        return Measurements(self)

    @property
    def sha256(self) -> str:
        """SHA-256 of the whole file, in hexadecimal. Streams the file once."""
        return self._hashed()[0]

    @property
    def pcm_sha256(self) -> str:
        """SHA-256 of the samples as the `data` chunk of a WAV holds them, in hexadecimal. Streams the file once."""
        return self._hashed()[1]

    def blocks(self) -> Iterator[NDArray[np.float64]]:
        """Yield the samples once more from the beginning, shape (n, channels), full scale ±1.0."""
        return wav.blocks(self._file, self.layout)

    def prepare(self, figures: Iterable[str]) -> None:
        """Say which figures will be asked for, before the first one is; without this, all are measured."""
        wanted = self._wanted or set()
        for figure in figures:
            if figure not in FAMILIES:
                raise ValueError(f"no such figure: {figure}")
            wanted.add(FAMILIES[figure])
        self._wanted = wanted

    def measured(self) -> dict[str, Any]:
        """Return every figure of the prepared families, by name. Streams the file once."""
        self._hashed()
        return dict(self._figures)

    def figure(self, name: str) -> Any:
        """Return one figure; one that was not prepared costs another pass."""
        family = FAMILIES[name]
        if self._hashes is None:
            self._stream(set(FIGURES) if self._wanted is None else self._wanted | {family})
        elif family not in self._measured:
            self._stream({family})
        return self._figures[name]

    def judgement(self, name: str, kind: str | None = None) -> Judgement:
        """Return a judgement by its name, for a kind of sound; made once. See `audio_checks.judge`.

        Reverb is judged beside the dry stem where there is one.
        """
        if (name, kind) not in self._judgements:
            judged = judge(name, self, kind)
            if name == "reverb" and self._dry is not None:
                judged = judged_beside(judged, self.path, self._dry)
            self._judgements[name, kind] = judged
        return self._judgements[name, kind]

    def _hashed(self) -> tuple[str, str]:
        if self._hashes is None:
            self._stream(set(FIGURES) if self._wanted is None else self._wanted)
        if self._hashes is None:
            raise AssertionError("streaming leaves the hashes behind")
        return self._hashes

    def _bits_in_use(self) -> int | None:
        self._hashed()
        return self._effective_bits

    def _stream(self, families: set[str]) -> None:
        """Read every byte once, for the hashes and the accumulators."""
        layout = self.layout
        accumulators = accumulators_of(layout, families)
        hashes = Hashes()
        gathering = Gathering(layout.chunks)
        self._file.seek(0)
        at = 0
        while at < layout.data_offset and (head := self._file.read(min(layout.data_offset - at, READ_BYTES))):
            hashes.add_around(head)
            gathering.pass_by(at, head)
            at += len(head)
        decoder = next((one for one in accumulators if isinstance(one, Faults)), None)
        used, left, most = 0, layout.frames, wav.frames_at_once(layout)
        self._file.seek(layout.data_offset)
        piece = decoder.piece_frames() if decoder else most
        room = spare.taken("bytes", min(left, piece) * layout.frame_bytes)
        while left:
            frames = min(left, decoder.room() if decoder else most)
            pieces = self._sound_bytes(room.data, frames, hashes)
            if decoder:
                block, bits = wav.decode_to(decoder, pieces, frames, layout)
            else:
                block, bits = wav.decode(next(pieces), layout)
            used |= bits
            left -= len(block)
            for accumulator in accumulators:
                accumulator.add(block)
        spare.give_back("bytes", room)
        at = layout.data_offset + layout.data_size
        while tail := self._file.read(READ_BYTES):
            hashes.add_around(tail)
            gathering.pass_by(at, tail)
            at += len(tail)
        for accumulator in accumulators:
            self._figures.update(accumulator.result())
        self._gathering = gathering
        self._measured |= families
        whole, pcm = hashes.result()
        self._hashes = (whole if self._sound.flac is None else self._sound.original_sha256(), pcm)
        self._effective_bits = effective_bits(used, layout.container_bits) if layout.encoding == "pcm" else None

    def _sound_bytes(self, room: memoryview, frames: int, hashes: Hashes) -> Iterator[memoryview]:
        """Yield the bytes of the next frames in pieces as large as the room for them, each hashed."""
        left = frames * self.layout.frame_bytes
        while left:
            piece = room[:left]
            wav.fill(self._file, piece)
            hashes.add_sound(piece)
            yield piece
            left -= len(piece)
