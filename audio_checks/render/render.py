"""A game file from a master: one stream from the master's bytes to the file's, measured as it is written."""

import hashlib
import math
import os
import struct
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, BinaryIO, Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.errors import RenderRefused
from audio_checks.measure.levels import Levels
from audio_checks.measure.loudness import Loudness, channel_weights
from audio_checks.measure.seam import Seam
from audio_checks.measure.true_peak import TruePeak
from audio_checks.render.channels import mixing_gains
from audio_checks.render.dither import DITHERED_TO_BITS, Dither, ensure_shapeable, quantised
from audio_checks.render.resample import (
    ensure_downwards,
    frames_after,
    loop_fit_frames,
    position_after,
    resample_blocks,
)
from audio_checks.sound_files import OpenSound, open_sound

RENDERER_VERSION = "2"  # changes when the same master and target give other bytes
TOLERANCE_DB = 0.05  # as for checks: what they would let pass is not touched
ATTEMPTS = 12  # the second settles it but for a step of rounding; at 8 bit that step may take a few more
LOOP_KINDS = {"forward": 0, "alternating": 1, "backward": 2}
READ_BYTES = 1 << 20


class RenderTarget(Protocol):
    """What a render is made to: the `Target` of a delivery spec."""

    @property
    def sample_rate_hz(self) -> int:
        """Frames per second of the game file."""

    @property
    def bit_depth(self) -> int:
        """Bits a sample."""

    @property
    def encoding(self) -> Literal["pcm", "float"]:
        """How samples are written."""

    @property
    def channels(self) -> Literal["master", 1, 2]:
        """Channels wanted; "master" keeps the master's."""

    @property
    def dither(self) -> Dither:
        """Noise added where bits are lost."""

    @property
    def over_peak(self) -> Literal["attenuate", "refuse"]:
        """What happens to a file whose peaks exceed the limits."""


@dataclass(frozen=True)
class SeamFigures:
    """A loop's seam against the sound around it, in dB: step of level, change of slope."""

    step_db: float
    slope_db: float


@dataclass(frozen=True)
class Rendered:
    """A game file that was made, and how.

    Attributes
    ----------
    measurements : dict
        Figures of the new file, named as in the report: levels, true peak, loudness.
    attenuation_db : float
        By how much it was lowered to keep the peak limits; 0 when it was not.
    recalculated : bool
        Whether samples were resampled, mixed or lowered; if not, they are the master's own, rounded
        at most, and the bit depth is no higher than the master's.
    loop_points : tuple of (int, int)
        First and last frame of each loop written to the file.
    loop_fit_frames : float
        By how many frames a loop was lengthened (+) or shortened (−) to become whole.
    seam_before, seam_after : SeamFigures or None
        Of the master and of the file, for loops.
    master_sha256, sha256, pcm_sha256 : str
        Digest of the master's bytes, of the file's, and of the file's samples.
    """

    path: Path
    sample_rate_hz: int
    bit_depth: int
    encoding: Literal["pcm", "float"]
    channels: int
    frames: int
    measurements: dict[str, Any]
    attenuation_db: float
    recalculated: bool
    dither: Dither
    loop: bool
    loop_points: tuple[tuple[int, int], ...]
    loop_fit_frames: float
    seam_before: SeamFigures | None
    seam_after: SeamFigures | None
    master_sha256: str
    sha256: str
    pcm_sha256: str
    renderer_version: str = RENDERER_VERSION

    @property
    def duration_s(self) -> float:
        """Length in seconds."""
        return self.frames / self.sample_rate_hz

    def to_dict(self) -> dict[str, Any]:
        """Return everything but the path as plain values, −inf as None."""
        plain: dict[str, Any] = _without_infinity(asdict(self) | {"duration_s": self.duration_s})
        del plain["path"]
        return plain


@dataclass(frozen=True)
class Recipe:
    """What to do with a master, once its header is known."""

    sample_rate_hz: int
    bit_depth: int
    encoding: Literal["pcm", "float"]
    gains: NDArray[np.float64] | None  # from the master's channels to the file's; None leaves them
    dither: Dither
    refuse_over_peak: bool = False
    sample_peak_limit_dbfs: float | None = None
    true_peak_limit_dbtp: float | None = None
    tolerance_db: float = TOLERANCE_DB
    loop: bool = False
    loop_points: tuple[tuple[int, int], ...] | None = None  # None keeps the master's


def render_master(
    path: str | os.PathLike[str],
    target: RenderTarget,
    out_path: str | os.PathLike[str],
    *,
    loop: bool = False,
    loop_points: tuple[int, int] | None = None,
    sample_peak_limit_dbfs: float | None = None,
    true_peak_limit_dbtp: float | None = None,
    tolerance_db: float = TOLERANCE_DB,
) -> Rendered:
    """Make the game file of a target from a master; the master is only read.

    The file carries sound and loop points, and nothing of who made it. It is written whole or not
    at all. The same master and target give the same bytes.

    Parameters
    ----------
    path, out_path : path
        The master, and the WAV file to write.
    target : RenderTarget
        Rate, depth, encoding, channels, dither, and what to do with peaks over the limits.
    loop : bool
        The whole file loops: it is filtered across its seam and fitted to whole frames.
    loop_points : (int, int), optional
        First and last frame of a loop within the master, in place of its own `smpl` chunk.
    sample_peak_limit_dbfs, true_peak_limit_dbtp : float, optional
        What the peaks of the new file are held to; without them full scale.
    tolerance_db : float
        How far a peak may lie beyond its limit and still be let be.

    Raises
    ------
    RenderRefused
        `render:upwards`, `render:channels`, `render:shaped-too-low`, `render:over-peak`.
    Unreadable
        When the master breaks a rule of structure.
    SandboxFailed
        When a FLAC master could not be unpacked for want of time, memory or disk.
    """
    with open_sound(path) as sound:
        layout = sound.layout
        ensure_downwards(layout.sample_rate_hz, target.sample_rate_hz)
        recipe = Recipe(
            sample_rate_hz=target.sample_rate_hz,
            bit_depth=target.bit_depth,
            encoding=target.encoding,
            gains=mixing_gains(layout.channels, target.channels),
            dither=target.dither,
            refuse_over_peak=target.over_peak == "refuse",
            sample_peak_limit_dbfs=sample_peak_limit_dbfs,
            true_peak_limit_dbtp=true_peak_limit_dbtp,
            tolerance_db=tolerance_db,
            loop=loop,
            loop_points=(loop_points,) if loop_points else None,
        )
        return render(sound, recipe, Path(out_path))


def render(sound: OpenSound, recipe: Recipe, out_path: Path) -> Rendered:
    """Make a file by a recipe; see `render_master`."""
    ensure_shapeable(recipe.dither, recipe.sample_rate_hz)
    work = _Work(sound, recipe)
    scratch = out_path.with_name(f".{out_path.name}.{os.getpid()}.part")
    try:
        lowered_db = 0.0
        for _ in range(ATTEMPTS):
            attempt = work.write(scratch, lowered_db)
            over_db = attempt.over_db(recipe)
            if over_db <= 0:
                break
            if recipe.refuse_over_peak:
                raise _over_peak(over_db)
            lowered_db += over_db
        else:
            raise _over_peak(over_db)
        rendered = work.describe(scratch, out_path, attempt, lowered_db)
        os.replace(scratch, out_path)
    finally:
        with suppress(FileNotFoundError):
            scratch.unlink()
    return rendered


class _Work:
    """One master being rendered: what holds for every attempt."""

    def __init__(self, sound: OpenSound, recipe: Recipe) -> None:
        self._file = sound.file
        self._layout = layout = sound.layout
        self._recipe = recipe
        whole = ((0, layout.frames - 1),)
        self._points = recipe.loop_points or tuple((loop.start, loop.end) for loop in layout.loops)
        self._circular = self._points == whole or (recipe.loop and not self._points)
        self._changes_rate = recipe.sample_rate_hz != layout.sample_rate_hz
        self._frames = frames_after(layout.frames, layout.sample_rate_hz, recipe.sample_rate_hz, loop=self._circular)
        self._channels = layout.channels if recipe.gains is None else recipe.gains.shape[1]
        self._mask = layout.channel_mask if recipe.gains is None else None
        self._seed = _digest(sound.original)
        self._new_points = tuple(self._moved(start, end) for start, end in self._points)

    def write(self, path: Path, lowered_db: float) -> "_Attempt":
        """Write the whole file once, lowered by so many dB, and measure it on its way."""
        recipe = self._recipe
        bit_depth, dither = self._depth(lowered_db)
        weights = channel_weights(self._channels, self._mask)
        attempt = _Attempt(recipe.sample_rate_hz, bit_depth, dither, self._channels, self._frames, weights)
        floats = self._floats(lowered_db)
        blocks: Iterator[NDArray[np.integer]] | Iterator[NDArray[np.floating]]
        if recipe.encoding == "float":
            dtype = np.float32 if bit_depth == 32 else np.float64
            blocks = attempt.watched_floats(block.astype(dtype) for block in floats)
        else:
            whole = quantised(floats, bit_depth=bit_depth, channels=self._channels, dither=dither, seed=self._seed)
            blocks = attempt.watched_steps(whole)
        wav.write_wav(
            path,
            blocks,
            sample_rate_hz=recipe.sample_rate_hz,
            bit_depth=bit_depth,
            encoding=recipe.encoding,
            channels=self._channels,
            frames=self._frames,
            channel_mask=self._mask if self._channels > 2 else None,
            chunks=self._chunks(),
        )
        return attempt

    def describe(self, scratch: Path, out_path: Path, attempt: "_Attempt", lowered_db: float) -> Rendered:
        sha256, pcm_sha256 = _digests(scratch)
        rate, loops = self._layout.sample_rate_hz, self._circular or bool(self._points)
        return Rendered(
            path=out_path,
            sample_rate_hz=self._recipe.sample_rate_hz,
            bit_depth=attempt.bit_depth,
            encoding=self._recipe.encoding,
            channels=self._channels,
            frames=self._frames,
            measurements=attempt.figures(),
            attenuation_db=lowered_db,
            recalculated=self._recalculated(lowered_db),
            dither=attempt.dither,
            loop=self._circular,
            loop_points=self._new_points,
            loop_fit_frames=(
                loop_fit_frames(self._layout.frames, rate, self._recipe.sample_rate_hz) if self._circular else 0.0
            ),
            seam_before=self._seam(self._file, self._layout, self._points) if loops else None,
            seam_after=self._seam_of(scratch) if loops else None,
            master_sha256=self._seed.hex(),
            sha256=sha256,
            pcm_sha256=pcm_sha256,
        )

    def _recalculated(self, lowered_db: float) -> bool:
        return self._changes_rate or self._recipe.gains is not None or lowered_db > 0

    def _depth(self, lowered_db: float) -> tuple[int, Dither]:
        """Return the bits to write, and the dither they need."""
        recipe, layout = self._recipe, self._layout
        bit_depth = recipe.bit_depth
        recalculated = self._recalculated(lowered_db)
        if not recalculated and recipe.encoding == layout.encoding:
            bit_depth = min(bit_depth, layout.container_bits)
        exact = not recalculated and layout.encoding == "pcm" and bit_depth >= layout.bit_depth
        dithers = recipe.encoding == "pcm" and bit_depth <= DITHERED_TO_BITS and not exact
        return bit_depth, recipe.dither if dithers else "none"

    def _mixed(self) -> Iterator[NDArray[np.float64]]:
        for block in wav.blocks(self._file, self._layout):
            yield block if self._recipe.gains is None else block @ self._recipe.gains

    def _floats(self, lowered_db: float) -> Iterator[NDArray[np.float64]]:
        factor = 10 ** (-lowered_db / 20)
        for block in resample_blocks(
            self._mixed,
            frames=self._layout.frames,
            channels=self._channels,
            sample_rate_hz=self._layout.sample_rate_hz,
            to_hz=self._recipe.sample_rate_hz,
            loop=self._circular,
        ):
            yield block * factor if lowered_db else block

    def _moved(self, start: int, end: int) -> tuple[int, int]:
        if self._circular:
            return 0, self._frames - 1
        rates = self._layout.sample_rate_hz, self._recipe.sample_rate_hz
        last = min(position_after(end + 1, *rates), self._frames) - 1
        return min(position_after(start, *rates), last), last

    def _chunks(self) -> Sequence[tuple[str, bytes]]:
        if not self._new_points:
            return ()
        note = (60, 0)
        for chunk in self._layout.chunks:
            if chunk.id == "smpl" and chunk.size >= 20:
                self._file.seek(chunk.offset + 12)
                note = struct.unpack("<2I", self._file.read(8))
        period_ns = round(1e9 / self._recipe.sample_rate_hz)
        kinds = [loop.kind for loop in self._layout.loops] if self._recipe.loop_points is None else []
        payload = struct.pack("<9I", 0, 0, period_ns, *note, 0, 0, len(self._new_points), 0)
        for number, (start, end) in enumerate(self._new_points):
            kind = LOOP_KINDS.get(kinds[number], 0) if kinds else 0
            payload += struct.pack("<6I", number, kind, start, end, 0, 0)
        return [("smpl", payload)]

    def _seam_of(self, path: Path) -> SeamFigures:
        with wav.open_regular(path) as file:
            return self._seam(file, wav.read_layout(file), self._new_points)

    @staticmethod
    def _seam(file: BinaryIO, layout: wav.WavLayout, points: Sequence[tuple[int, int]]) -> SeamFigures:
        seam = Seam(layout.sample_rate_hz, layout.channels, layout.frames, loop=points[0] if points else None)
        for block in wav.blocks(file, layout):
            seam.add(block)
        figures = seam.result()
        return SeamFigures(figures["seam_step_db"], figures["seam_slope_db"])


class _Attempt:
    """What one writing of the file came to."""

    def __init__(
        self, rate: int, bit_depth: int, dither: Dither, channels: int, frames: int, weights: NDArray[np.float64]
    ) -> None:
        self.bit_depth = bit_depth
        self.dither = dither
        self._lowest = self._highest = 0
        self._accumulators = (
            Levels(rate, channels, frames),
            TruePeak(rate, channels, frames),
            Loudness(rate, channels, frames, weights=weights),
        )
        self._figures: dict[str, Any] | None = None

    def watched_steps(self, blocks: Iterator[NDArray[np.int64]]) -> Iterator[NDArray[np.int64]]:
        """Pass whole numbers through, measured before they are held to the range that can be written."""
        full = 1 << (self.bit_depth - 1)
        for block in blocks:
            self._lowest = min(self._lowest, int(block.min(initial=0)))
            self._highest = max(self._highest, int(block.max(initial=0)))
            self._measure(block / full)
            yield np.clip(block, -full, full - 1)

    def watched_floats(self, blocks: Iterator[NDArray[np.floating]]) -> Iterator[NDArray[np.floating]]:
        for block in blocks:
            self._measure(block.astype(np.float64))
            yield block

    def figures(self) -> dict[str, Any]:
        if self._figures is None:
            self._figures = {}
            for accumulator in self._accumulators:
                self._figures |= accumulator.result()
        return self._figures

    def over_db(self, recipe: Recipe) -> float:
        """Return by how much the loudest peak must come down; 0 when none is beyond its limit."""
        figures = self.figures()
        over = [0.0]
        for level, limit in (
            (figures["sample_peak_dbfs"], recipe.sample_peak_limit_dbfs),
            (figures["true_peak_dbtp"], recipe.true_peak_limit_dbtp),
        ):
            if limit is not None and level > limit + recipe.tolerance_db:
                over.append(level - limit)
        full = 1 << (self.bit_depth - 1)
        clips = max(self._highest / (full - 1), -self._lowest / full)
        if clips > 1:
            over.append(20 * math.log10(clips))
        return max(over)

    def _measure(self, block: NDArray[np.float64]) -> None:
        for accumulator in self._accumulators:
            accumulator.add(block)


def _over_peak(over_db: float) -> RenderRefused:
    return RenderRefused(
        f"at the target's rate and depth the peaks are {over_db:.2f} dB over their limit",
        code="render:over-peak",
        fix=f'lower the master by {over_db:.2f} dB or more, or set the target\'s over_peak to "attenuate"',
    )


def _digest(file: BinaryIO) -> bytes:
    digest = hashlib.sha256()
    file.seek(0)
    while block := file.read(READ_BYTES):
        digest.update(block)
    return digest.digest()


def _digests(path: Path) -> tuple[str, str]:
    """Return the SHA-256 of a file and of its samples."""
    with wav.open_regular(path) as file:
        layout = wav.read_layout(file)
        samples = hashlib.sha256()
        for raw in wav.raw_blocks(file, layout):
            samples.update(raw)
        return _digest(file).hex(), samples.hexdigest()


def _without_infinity(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _without_infinity(held) for key, held in value.items()}
    if isinstance(value, (list, tuple)):
        return [_without_infinity(held) for held in value]
    return None if isinstance(value, float) and math.isinf(value) else value
