"""A game file from a master: one stream from the master's bytes to the file's, measured as it is written."""

import hashlib
import math
import os
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, BinaryIO, Literal

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.errors import RenderRefused
from audio_checks.measure.average_spectrum import AverageSpectrum
from audio_checks.measure.decibels import decibels
from audio_checks.measure.levels import Levels
from audio_checks.measure.loudness import Loudness, channel_weights
from audio_checks.measure.seam import Seam
from audio_checks.measure.true_peak import TruePeak
from audio_checks.metadata import CHUNKS, MOST_CHUNKS, read_metadata
from audio_checks.metadata import MOST_BYTES as MOST_READ_BYTES
from audio_checks.metadata.carrying import MOST_BYTES, Move, bytes_beside, carried, sampler
from audio_checks.metadata.mark import comment_chunk, cue_marked
from audio_checks.render.channels import mixed, mixing_gains
from audio_checks.render.dither import DITHERED_TO_BITS, Dither, Requantisation, ensure_shapeable, quantised
from audio_checks.render.fades import faded
from audio_checks.render.loops import FittedLoop, fitted_loop, part, with_turns
from audio_checks.render.rendered import Loss, Rendered, SeamFigures
from audio_checks.render.resample import ensure_downwards, frames_after, loop_fit_frames, resample_blocks
from audio_checks.render.shelf import compensating_gain
from audio_checks.render.survey import Survey
from audio_checks.render.turns import gain_of
from audio_checks.sound_files import OpenSound, open_sound
from audio_checks.spec import Target

RENDERER_VERSION = "3"  # changes when the same master and target give other bytes
TOLERANCE_DB = 0.05  # as for checks: what they would let pass is not touched
MONO_LOSS_LIMIT_DB = 6.0
ATTEMPTS = 12  # the second settles it but for a step of rounding; at 8 bit that step may take a few more
MILLIONTHS = 1_000_000  # of a dB: attenuation is a whole number of them, so that no machine's logarithm shows in bytes
READ_BYTES = 1 << 20
TELL_OF_THE_SOUND = frozenset({"cue ", "smpl", "inst", "acid", "plst"})  # and LIST/adtl, the labels of cue points


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
    mono_loss_limit_db: float = MONO_LOSS_LIMIT_DB
    loop: bool = False
    loop_points: tuple[tuple[int, int], ...] | None = None  # None keeps the master's
    chunks: Literal["sound", "all"] = "sound"
    shelf_db: float | Literal["auto"] = 0.0
    trim_below_dbfs: float | None = None
    fade_in_ms: float = 0.0
    fade_out_ms: float = 0.0
    tells_loss: bool = True


def render_master(
    path: str | os.PathLike[str],
    target: Target,
    out_path: str | os.PathLike[str],
    *,
    loop: bool = False,
    loop_points: tuple[int, int] | None = None,
    sample_peak_limit_dbfs: float | None = None,
    true_peak_limit_dbtp: float | None = None,
    tolerance_db: float = TOLERANCE_DB,
    mono_loss_limit_db: float = MONO_LOSS_LIMIT_DB,
) -> Rendered:
    """Make the game file of a target from a master; the master is only read.

    The file carries the sound and what tells of it: loops, cue points and their labels, notes, tempo.
    Everything else goes along only where the target asks for all chunks; the mark of a stand-in always
    does. It is written whole or not at all. The same master and target give the same bytes.

    Parameters
    ----------
    path, out_path : path
        The master, and the WAV file to write.
    target : Target
        Rate, depth, encoding, channels, dither, chunks, shelf, trim, fades, and what to do with peaks
        over the limits.
    loop : bool
        The whole file loops: it is filtered across its seam and fitted to whole frames.
    loop_points : (int, int), optional
        First and last frame of a loop within the master, in place of those of its own `smpl` chunk.
    sample_peak_limit_dbfs, true_peak_limit_dbtp : float, optional
        What the peaks of the new file are held to; without them full scale.
    tolerance_db : float
        How far a peak may lie beyond its limit and still be let be.
    mono_loss_limit_db : float
        What a stereo sound may lose in mono before a warning is given.

    Returns
    -------
    Rendered
        With the report of what was lost, and warnings.

    Raises
    ------
    RenderRefused
        `render:upwards`, `render:channels`, `render:shaped-too-low`, `render:over-peak`,
        `render:loop-points`, `render:large-chunks`.
    Unreadable
        When the master breaks a rule of structure.
    SandboxFailed
        When a FLAC master could not be unpacked for want of time, memory or disk.
    """
    with open_sound(path) as sound:
        layout = sound.layout
        ensure_downwards(layout.sample_rate_hz, target.sample_rate_hz)
        if loop_points is not None:
            _ensure_inside(loop_points, layout.frames)
        recipe = Recipe(
            sample_rate_hz=target.sample_rate_hz,
            bit_depth=target.bit_depth,
            encoding=target.encoding,
            gains=mixing_gains(layout.channels, target.channels, target.mono_gains),
            dither=target.dither,
            refuse_over_peak=target.over_peak == "refuse",
            sample_peak_limit_dbfs=sample_peak_limit_dbfs,
            true_peak_limit_dbtp=true_peak_limit_dbtp,
            tolerance_db=tolerance_db,
            mono_loss_limit_db=mono_loss_limit_db,
            loop=loop,
            loop_points=(loop_points,) if loop_points else None,
            chunks=target.chunks,
            shelf_db=target.shelf_db,
            trim_below_dbfs=target.trim_below_dbfs,
            fade_in_ms=target.fade_in_ms,
            fade_out_ms=target.fade_out_ms,
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
            lowered_db = math.ceil((lowered_db + over_db) * MILLIONTHS) / MILLIONTHS
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
        self._sound = sound
        self._file = sound.file
        self._layout = layout = sound.layout
        self._recipe = recipe
        rates = layout.sample_rate_hz, recipe.sample_rate_hz
        whole = ((0, layout.frames - 1),)
        self._points = recipe.loop_points or tuple((loop.start, loop.end) for loop in layout.loops)
        self._circular = self._points == whole or (recipe.loop and not self._points)
        self._changes_rate = recipe.sample_rate_hz != layout.sample_rate_hz
        self._channels = layout.channels if recipe.gains is None else recipe.gains.shape[1]
        self._mask = layout.channel_mask if recipe.gains is None else None
        self._seed = _digest(sound.original)
        trims = recipe.trim_below_dbfs is not None and not self._loops
        self._survey = Survey(
            self._file,
            layout,
            to_mono=recipe.gains is not None and recipe.gains.shape == (2, 1),
            trims=trims,
            tells_loss=recipe.tells_loss,
        )
        self._cut = self._survey.silence_frames(recipe.trim_below_dbfs)
        self._kept = layout.frames - sum(self._cut)
        self._frames = frames_after(self._kept, *rates, loop=self._circular)
        self._fitted = () if self._circular else tuple(fitted_loop(*one, self._frames, *rates) for one in self._points)
        self._new_points = (
            ((0, self._frames - 1),)
            if self._circular and self._points
            else tuple((one.first, one.last) for one in self._fitted)
        )
        self._shelf = self._shelf_gain()

    @property
    def _loops(self) -> bool:
        return self._circular or bool(self._points)

    def write(self, path: Path, lowered_db: float) -> "_Attempt":
        """Write the whole file once, lowered by so many dB, and measure it on its way."""
        recipe = self._recipe
        bit_depth, dither = self._depth(lowered_db)
        attempt = _Attempt(
            recipe.sample_rate_hz,
            bit_depth,
            dither,
            self._channels,
            self._frames,
            channel_weights(self._channels, self._mask),
            bands_of_hz=self._layout.sample_rate_hz if recipe.tells_loss else None,
        )
        floats = self._floats(lowered_db)
        blocks: Iterator[NDArray[np.integer]] | Iterator[NDArray[np.floating]]
        if recipe.encoding == "float":
            blocks = attempt.watched_floats(floats, np.float32 if bit_depth == 32 else np.float64)
        else:
            whole = quantised(
                floats,
                bit_depth=bit_depth,
                channels=self._channels,
                dither=dither,
                seed=self._seed,
                noise=attempt.noise,
            )
            blocks = attempt.watched_steps(whole)
        before, after = self._chunks(bit_depth, dither, lowered_db)
        wav.write_wav(
            path,
            blocks,
            sample_rate_hz=recipe.sample_rate_hz,
            bit_depth=bit_depth,
            encoding=recipe.encoding,
            channels=self._channels,
            frames=self._frames,
            channel_mask=self._mask if self._channels > 2 else None,
            chunks=before,
            chunks_after=after,
        )
        return attempt

    def describe(self, scratch: Path, out_path: Path, attempt: "_Attempt", lowered_db: float) -> Rendered:
        sha256, pcm_sha256 = _digests(scratch)
        rendered = Rendered(
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
            loop_fit_frames=self._fit_frames(),
            seam_before=self._seam(self._file, self._layout, self._points) if self._loops else None,
            seam_after=self._seam_of(scratch) if self._loops else None,
            master_sha256=self._seed.hex(),
            sha256=sha256,
            pcm_sha256=pcm_sha256,
            renderer_version=RENDERER_VERSION,
            warnings=self._survey.mono_warnings(self._recipe.mono_loss_limit_db),
        )
        return replace(rendered, loss=self._loss(rendered, attempt)) if self._recipe.tells_loss else rendered

    def _loss(self, rendered: Rendered, attempt: "_Attempt") -> Loss:
        assert attempt.spectrum is not None  # noqa: S101 - there where the loss is told
        rate = self._layout.sample_rate_hz
        return Loss(
            before=self._survey.figures,
            after=rendered.measurements,
            above_nyquist_db=self._survey.above_db(rendered.sample_rate_hz / 2) if self._changes_rate else -math.inf,
            shelf_db=decibels(self._shelf),
            attenuation_db=rendered.attenuation_db,
            requantisation_dbfs=attempt.noise.level_dbfs(),
            trimmed_s=(self._cut[0] / rate, self._cut[1] / rate),
            loop_fit_frames=rendered.loop_fit_frames,
            seam_before=rendered.seam_before,
            seam_after=rendered.seam_after,
            mono_loss_db=self._survey.mono_loss_db(),
            spectra=self._survey.spectra(attempt.spectrum),
        )

    def _fit_frames(self) -> float:
        if self._circular:
            return loop_fit_frames(self._layout.frames, self._layout.sample_rate_hz, self._recipe.sample_rate_hz)
        return self._fitted[0].fit_frames if self._fitted else 0.0

    def _shelf_gain(self) -> float:
        recipe, layout = self._recipe, self._layout
        if not self._changes_rate:
            return 1.0
        if recipe.shelf_db == "auto":
            return compensating_gain(self._kept_blocks(), self._channels, layout.sample_rate_hz, recipe.sample_rate_hz)
        return gain_of(recipe.shelf_db)

    def _recalculated(self, lowered_db: float) -> bool:
        return self._changes_rate or self._recipe.gains is not None or lowered_db > 0 or any(self._fades())

    def _fades(self) -> tuple[int, int]:
        """Return the frames of fade at head and tail: none where the sound loops."""
        if self._loops:
            return 0, 0
        rate = self._recipe.sample_rate_hz
        return round(self._recipe.fade_in_ms * rate / 1000), round(self._recipe.fade_out_ms * rate / 1000)

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
            yield block if self._recipe.gains is None else mixed(block, self._recipe.gains)

    def _kept_blocks(self) -> Iterator[NDArray[np.float64]]:
        yield from part(self._mixed, self._cut[0], self._kept, self._channels)() if any(self._cut) else self._mixed()

    def _floats(self, lowered_db: float) -> Iterator[NDArray[np.float64]]:
        rates = {"sample_rate_hz": self._layout.sample_rate_hz, "to_hz": self._recipe.sample_rate_hz}
        blocks = resample_blocks(
            self._kept_blocks,
            frames=self._kept,
            channels=self._channels,
            loop=self._circular,
            shelf=self._shelf,
            **rates,
        )
        turning = self._turning()
        if turning and self._changes_rate:
            blocks = with_turns(blocks, self._mixed, turning, channels=self._channels, shelf=self._shelf, **rates)
        fade_in, fade_out = self._fades()
        if fade_in or fade_out:
            blocks = faded(blocks, frames=self._frames, fade_in=fade_in, fade_out=fade_out)
        factor = gain_of(-lowered_db)
        for block in blocks:
            yield block * factor if lowered_db else block

    def _turning(self) -> list[FittedLoop]:
        """Return the loops that turn round from their last frame to their first; others play back and forth."""
        if self._recipe.loop_points is not None:
            return list(self._fitted)
        kinds = (loop.kind for loop in self._layout.loops)
        return [one for one, kind in zip(self._fitted, kinds, strict=False) if kind == "forward"]

    def _chunks(
        self, bit_depth: int, dither: Dither, lowered_db: float
    ) -> tuple[list[tuple[str, bytes]], list[tuple[str, bytes]]]:
        recipe, layout = self._recipe, self._layout
        beside = bytes_beside(layout)
        if beside > MOST_BYTES:
            raise RenderRefused(
                f"the master carries {beside >> 20} MiB beside its sound, and a render {MOST_BYTES >> 20} MiB at most",
                code="render:large-chunks",
                fix="leave out what the file need not carry, such as pictures, and deliver it again",
            )
        same_encoding = recipe.encoding == layout.encoding
        exact = same_encoding and bit_depth >= layout.bit_depth and dither == "none"
        move = Move(
            cut=self._cut[0],
            frames=self._frames,
            changed=self._recalculated(lowered_db) or not exact,
            new_depth=None if bit_depth == layout.bit_depth else bit_depth,
            sample_rate_hz=layout.sample_rate_hz,
            to_hz=recipe.sample_rate_hz,
            new_channels=recipe.gains is not None,
            loops={(one.start, one.end): (one.first, one.last) for one in self._fitted},
            stretch=self._frames * layout.sample_rate_hz / (layout.frames * recipe.sample_rate_hz)
            if self._circular
            else 1.0,
            history=self._history(bit_depth),
        )
        before, after = carried(self._file, layout, move, keep=self._keeps)
        if recipe.loop_points is not None:
            samplers = [payload for name, payload in (*before, *after) if name == "smpl"]
            new = sampler(recipe.sample_rate_hz, [(0, *one) for one in self._new_points], *samplers[:1])
            before = [chunk for chunk in before if chunk[0] != "smpl"] + [("smpl", new)]
            after = [chunk for chunk in after if chunk[0] != "smpl"]
        number = self._stand_in_for()
        if number is not None and recipe.chunks != "all":
            after.append(comment_chunk(number))
        return before, after

    def _stretch(self) -> float:
        if not self._circular:
            return 1.0
        return self._frames * self._layout.sample_rate_hz / (self._layout.frames * self._recipe.sample_rate_hz)

    def _keeps(self, name: str, payload: bytes) -> bool:
        if self._recipe.chunks == "all":
            return True
        return name in TELL_OF_THE_SOUND or (name == "LIST" and payload[:4] == b"adtl")

    def _stand_in_for(self) -> str | None:
        """Return the cue that the master is a stand-in for; None for a real sound."""
        chunks = [chunk for chunk in self._layout.chunks if chunk.id in CHUNKS][:MOST_CHUNKS]
        told = read_metadata(
            (chunk.id, wav.chunk_payload(self._file, replace(chunk, size=min(chunk.size, MOST_READ_BYTES))))
            for chunk in chunks
        )
        comments = self._sound.flac.comment_fields if self._sound.flac is not None else {}
        return cue_marked(told.fields | comments)

    def _history(self, bit_depth: int) -> str:
        """Return what EBU R 98 asks of each step of a sound's way."""
        mode = {1: ",M=mono", 2: ",M=stereo"}.get(self._channels, "")
        return f"A=PCM,F={self._recipe.sample_rate_hz},W={bit_depth}{mode}"

    def _seam_of(self, path: Path) -> SeamFigures:
        with wav.open_regular(path) as file:
            return self._seam(file, wav.read_layout(file), self._new_points)

    @staticmethod
    def _seam(file: BinaryIO, layout: wav.WavLayout, points: tuple[tuple[int, int], ...]) -> SeamFigures:
        seam = Seam(layout.sample_rate_hz, layout.channels, layout.frames, loop=points[0] if points else None)
        for block in wav.blocks(file, layout):
            seam.add(block)
        figures = seam.result()
        return SeamFigures(figures["seam_step_db"], figures["seam_slope_db"])


class _Attempt:
    """What one writing of the file came to."""

    def __init__(
        self,
        rate: int,
        bit_depth: int,
        dither: Dither,
        channels: int,
        frames: int,
        weights: NDArray[np.float64],
        *,
        bands_of_hz: int | None,
    ) -> None:
        self.bit_depth = bit_depth
        self.dither = dither
        self.noise = Requantisation()
        self.spectrum = (
            None if bands_of_hz is None else AverageSpectrum(rate, channels, frames, bands_of_hz=bands_of_hz)
        )
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

    def watched_floats(
        self, blocks: Iterator[NDArray[np.float64]], dtype: type[np.float32] | type[np.float64]
    ) -> Iterator[NDArray[np.floating]]:
        for block in blocks:
            written: NDArray[np.floating] = block.astype(dtype)
            kept = written.astype(np.float64)
            self.noise.add(kept - block)
            self._measure(kept)
            yield written

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
        if self.spectrum is not None:
            self.spectrum.add(block)


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


def _ensure_inside(points: tuple[int, int], frames: int) -> None:
    start, end = points
    if not 0 <= start <= end < frames:
        raise RenderRefused(
            f"a loop is asked for from frame {start} to {end}, and the master has frames 0 to {frames - 1}",
            code="render:loop-points",
            fix="give the loop's first and last frame inside the master, the first one first",
        )
