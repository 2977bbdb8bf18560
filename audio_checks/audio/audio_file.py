"""A file to judge: its facts from the header, its figures from one pass over its bytes."""

from __future__ import annotations

import os
from collections.abc import Callable, Hashable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import PurePath
from types import TracebackType
from typing import Any, NamedTuple, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.audio.figures import FAMILIES, FIGURES, Pass
from audio_checks.audio.hashes import Hashes
from audio_checks.audio.measurements import Measurements
from audio_checks.audio.sound_files import open_sound
from audio_checks.measure import buffer_pool
from audio_checks.measure.bits import effective_bits
from audio_checks.metadata import Metadata
from audio_checks.metadata.gather import Gathering

READ_BYTES = 1 << 20
T = TypeVar("T")


class DryStem(NamedTuple):
    """The sound of a file without reverb: its path, and the name that reports give it."""

    path: str | os.PathLike[str]
    name: str


@dataclass(frozen=True)
class Facts:
    """The facts of a file.

    Attributes
    ----------
    container, encoding : str
        "wav", "rf64", "flac", "ogg" or "mp3"; "pcm" or "float", or the codec: "vorbis", "opus", "mp3".
    bit_depth : int
        Bits that count, as the header says; 32 for what a codec keeps, which has none of its own.
    bit_rate_kbps : float or None
        Of what a codec keeps.
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
    bit_rate_kbps: float | None
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
            **({} if self.bit_rate_kbps is None else {"bit_rate_kbps": self.bit_rate_kbps}),
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
    coded : bool
        Whether Ogg Vorbis, Opus and MP3 are decoded, in such a child too.
    dry : DryStem, optional
        The same sound without reverb, for the judgement on reverb to compare it with.

    Raises
    ------
    Unreadable
        When a rule of structure is broken. R7 (finite samples below 385 dBFS) shows only when the file streams.
    SandboxFailed
        When a FLAC could not be unpacked: for want of time, memory or disk, or because its decoder broke.
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        *,
        name: str | None = None,
        flac: bool = True,
        coded: bool = False,
        dry: DryStem | None = None,
    ) -> None:
        self.path = path
        self.dry = dry
        self.name = PurePath(os.fspath(path)).name if name is None else name
        self._sound = open_sound(path, name=name, flac=flac, coded=coded)
        self._file = self._sound.file
        self.layout = self._sound.layout
        self._wanted: set[str] | None = None
        self._figures: dict[str, Any] = {}
        self._errors: dict[str, Exception] = {}
        self._measured: set[str] = set()
        self._hashes: tuple[str, str] | None = None
        self._effective_bits: int | None = None
        self._gathering = Gathering(self.layout.chunks)
        self._cached: dict[Hashable, Any] = {}

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
        """Return harmless oddities of the structure."""
        return self.layout.warnings

    @cached_property
    def facts(self) -> Facts:
        """Return the header's facts; only `effective_bits` streams the file."""
        layout, flac, coded = self.layout, self._sound.flac, self._sound.coded
        return Facts(
            container=coded.container if coded else "flac" if flac else layout.container,
            encoding=coded.encoding if coded else layout.encoding,
            sample_rate_hz=layout.sample_rate_hz,
            bit_depth=layout.bit_depth,
            channels=layout.channels,
            frames=layout.frames,
            duration_s=layout.duration_s,
            chunks=() if coded else flac.blocks if flac else tuple(chunk.id for chunk in layout.chunks),
            bit_rate_kbps=coded.bit_rate_kbps if coded else None,
            _effective_bits=self._bits_in_use,
            _metadata=lambda: self.metadata,
        )

    @cached_property
    def metadata(self) -> Metadata:
        """The file's metadata. Streams the file once."""
        self._hashed()
        metadata = self._gathering.read()
        tagged_stream = self._sound.flac or self._sound.coded
        return (
            metadata
            if tagged_stream is None
            else replace(metadata, fields=metadata.fields | tagged_stream.comment_fields)
        )

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
        """Name the figures to be asked for, before the first one is; without this, all are measured."""
        families = self._wanted or set()
        for figure in figures:
            if figure not in FAMILIES:
                raise ValueError(f"no such figure: {figure}")
            families.add(FAMILIES[figure])
        self._wanted = families

    def measured(self) -> dict[str, Any]:
        """Return every figure of the prepared families, by name. Streams the file once."""
        self._hashed()
        return dict(self._figures)

    @property
    def errors(self) -> dict[str, Exception]:
        """Return errors of unmeasured figures, by figure; empty unless the tool has a bug. Streams the file once."""
        self._hashed()
        return dict(self._errors)

    def figure(self, name: str) -> Any:
        """Return one figure; one that was not prepared costs another pass. Raise the error of one that failed."""
        family = FAMILIES[name]
        if self._hashes is None:
            self._stream(set(FIGURES) if self._wanted is None else self._wanted | {family})
        elif family not in self._measured:
            self._stream({family})
        if name in self._errors:
            raise self._errors[name]
        return self._figures[name]

    def cached(self, key: Hashable, compute: Callable[[], T]) -> T:
        """Return the result of `compute` for this key from the first time it was asked for."""
        if key not in self._cached:
            self._cached[key] = compute()
        value: T = self._cached[key]
        return value

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
        measuring = Pass(layout, families)
        hashes = Hashes()
        gathering = Gathering(layout.chunks)
        self._file.seek(0)
        at = 0
        while at < layout.data_offset and (head := self._file.read(min(layout.data_offset - at, READ_BYTES))):
            hashes.add_around(head)
            gathering.pass_by(at, head)
            at += len(head)
        used, left = 0, layout.frames
        self._file.seek(layout.data_offset)
        piece = measuring.decoder.piece_frames() if measuring.decoder else wav.frames_at_once(layout)
        room = buffer_pool.acquire("bytes", min(left, piece) * layout.frame_bytes)
        while left:
            decoder = measuring.decoder
            frames = min(left, decoder.room() if decoder else piece)
            pieces = self._sound_bytes(room.data, frames, hashes)
            if decoder:
                block, bits = wav.decode_to(decoder, pieces, frames, layout)
            else:
                block, bits = wav.decode(next(pieces), layout)
            used |= bits
            left -= len(block)
            measuring.add(block)
        buffer_pool.release("bytes", room)
        at = layout.data_offset + layout.data_size
        while tail := self._file.read(READ_BYTES):
            hashes.add_around(tail)
            gathering.pass_by(at, tail)
            at += len(tail)
        figures, errors = measuring.result()
        self._figures |= figures
        self._errors |= errors
        self._gathering = gathering
        self._measured |= families
        whole, pcm = hashes.result()
        is_wav = self._sound.flac is None and self._sound.coded is None
        self._hashes = (whole if is_wav else self._sound.original_sha256(), pcm)
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
