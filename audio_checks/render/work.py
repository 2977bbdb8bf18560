"""One master being rendered: what holds for every attempt, and the file that each attempt writes."""

import hashlib
import math
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.audio.sound_files import OpenSound, open_sound
from audio_checks.measure.decibels import decibels
from audio_checks.measure.loudness import channel_weights
from audio_checks.metadata.bext import coding_history_line
from audio_checks.metadata.moving import Move
from audio_checks.render.attempt import Attempt
from audio_checks.render.carried_chunks import carried_chunks, comments_of, kept_chunks, update_loudness
from audio_checks.render.channels import mixed
from audio_checks.render.coding import Coder
from audio_checks.render.dither import DITHERED_TO_BITS, Dither, quantised
from audio_checks.render.fades import faded
from audio_checks.render.loops import FittedLoop, fitted_loop, part, with_turns
from audio_checks.render.recipe import Recipe
from audio_checks.render.rendered import Loss, Rendered, SeamFigures, Spectra
from audio_checks.render.resample import frames_after, loop_fit_frames, resample_blocks
from audio_checks.render.shelf import compensating_gain
from audio_checks.render.survey import Survey, seam_of
from audio_checks.render.twiddles import gain_of
from audio_checks.report.findings import Finding
from audio_checks.spec.codings import CODINGS

RENDERER_VERSION = "5"  # changes when the same master and target give other bytes
READ_BYTES = 1 << 20


class Work:
    """One master being rendered: what holds for every attempt."""

    def __init__(self, sound: OpenSound, recipe: Recipe) -> None:
        self._sound = sound
        self._file = sound.file
        self._layout = layout = sound.layout
        self._recipe = recipe
        rates = layout.sample_rate_hz, recipe.sample_rate_hz
        whole = ((0, layout.frames - 1),)
        self._drops_loops = recipe.loop is False and recipe.loop_points is None and bool(layout.loops)
        self._points = recipe.loop_points or tuple(
            (loop.start, loop.end) for loop in layout.loops if not self._drops_loops
        )
        self._circular = self._points == whole or (recipe.loop is True and not self._points)
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
            measures_loss=recipe.measures_loss,
        )
        self._cut = self._survey.silence_frames(recipe.trim_below_dbfs)
        self._kept = layout.frames - sum(self._cut)
        self._frames = frames_after(self._kept, *rates, loop=self._circular)
        self._fitted = (
            () if self._circular else tuple(fitted_loop(*point, self._frames, *rates) for point in self._points)
        )
        self._new_points = (
            ((0, self._frames - 1),)
            if self._circular and self._points
            else tuple((loop.first, loop.last) for loop in self._fitted)
        )
        self._shelf = self._shelf_gain()

    @property
    def _loops(self) -> bool:
        return self._circular or bool(self._points)

    def write(self, path: Path, lowered_db: float, *, durable: bool) -> Attempt:
        """Write the whole file once, lowered by so many dB, and measure it on its way."""
        recipe = self._recipe
        bit_depth, dither = self._depth(lowered_db)
        attempt = Attempt(
            recipe.sample_rate_hz,
            bit_depth,
            dither,
            self._channels,
            self._frames,
            channel_weights(self._channels, self._mask),
            bands_of_hz=self._layout.sample_rate_hz if recipe.measures_loss else None,
        )
        coder = recipe.coder
        plain = path if coder is None else path.with_name(f"{path.name}.plain")
        floats = self._floats(lowered_db)
        blocks: Iterator[NDArray[np.integer]] | Iterator[NDArray[np.floating]]
        if recipe.is_lossy:
            blocks = (block.astype(np.float32) for block in floats)  # measured once it is decoded
        elif recipe.encoding == "float":
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
        move = self._move(bit_depth, dither, lowered_db)
        before, after = carried_chunks(
            self._sound,
            move,
            all_chunks=recipe.chunks == "all",
            new_loops=self._new_points if recipe.loop_points is not None or self._drops_loops else None,
        )
        try:
            wav.write_wav(
                plain,
                blocks,
                sample_rate_hz=recipe.sample_rate_hz,
                bit_depth=bit_depth,
                encoding=recipe.samples,
                channels=self._channels,
                frames=self._frames,
                channel_mask=self._mask if self._channels > 2 else None,
                chunks=before,
                chunks_after=after,
                durable=durable and coder is None,
            )
            if move.changed and recipe.chunks == "all" and not recipe.is_lossy:
                update_loudness(self._sound, plain, attempt.figures())
            if coder is not None:
                self._encode(coder, plain, path, attempt, durable=durable)
        finally:
            if coder is not None:
                plain.unlink(missing_ok=True)
        return attempt

    def _encode(self, coder: Coder, plain: Path, path: Path, attempt: Attempt, *, durable: bool) -> None:
        """Write the coded file, and measure what it decodes to."""
        with wav.open_regular(plain) as plain_file:
            layout = wav.read_layout(plain_file)
            coder.write(
                plain,
                path,
                seed=self._seed,
                comments=comments_of(plain_file, layout, self._sound, all_chunks=self._recipe.chunks == "all"),
                chunks=kept_chunks(plain_file, layout),
                durable=durable,
            )
            with open_sound(path, name=f"game{CODINGS[coder.encoding].ending}", coded=True) as decoded:
                if decoded.layout.frames != layout.frames:
                    raise AssertionError("a codec changed how long the sound is")
                if self._recipe.is_lossy:
                    attempt.watch_decoded(wav.blocks(decoded.file, decoded.layout), wav.blocks(plain_file, layout))
                attempt.pcm_sha256 = _sound_digest(decoded.file, decoded.layout)
                if self._loops:
                    attempt.seam = seam_of(decoded.file, decoded.layout, self._new_points)

    def describe(self, scratch: Path, out_path: Path, attempt: Attempt, lowered_db: float) -> Rendered:
        """Return the facts of the file that an attempt wrote, with its loss where the recipe measures it."""
        sha256, pcm_sha256 = _digests(scratch, attempt.pcm_sha256)
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
            seam_before=seam_of(self._file, self._layout, self._points) if self._loops else None,
            seam_after=(attempt.seam or self._seam_of(scratch)) if self._loops else None,
            master_sha256=self._seed.hex(),
            sha256=sha256,
            pcm_sha256=pcm_sha256,
            renderer_version=RENDERER_VERSION,
            warnings=(*self._survey.mono_warnings(self._recipe.mono_loss_limit_db), *self._loop_warnings()),
        )
        spectra = self._survey.spectra(attempt.spectrum)
        return rendered if spectra is None else replace(rendered, loss=self._loss(rendered, attempt, spectra))

    def _loss(self, rendered: Rendered, attempt: Attempt, spectra: Spectra) -> Loss:
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
            spectra=spectra,
        )

    def _loop_warnings(self) -> tuple[Finding, ...]:
        if not self._drops_loops:
            return ()
        return (
            Finding(
                code="render:loop-dropped",
                message="the master has loop points, and the sound list says that it is no loop:"
                " they are left out, or engines would repeat it",
                fix="call the cue a loop in the list if it is one",
                severity="warning",
            ),
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
        if not recalculated and recipe.samples == layout.encoding:
            bit_depth = min(bit_depth, layout.container_bits)
        exact = not recalculated and layout.encoding == "pcm" and bit_depth >= layout.bit_depth
        dithers = recipe.samples == "pcm" and bit_depth <= DITHERED_TO_BITS and not exact
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
        return [loop for loop, kind in zip(self._fitted, kinds, strict=False) if kind == "forward"]

    def _move(self, bit_depth: int, dither: Dither, lowered_db: float) -> Move:
        """Return the changes to the sound, for all that points into it."""
        recipe, layout = self._recipe, self._layout
        exact = recipe.samples == layout.encoding and bit_depth >= layout.bit_depth and dither == "none"
        fitted = self._frames * layout.sample_rate_hz / (layout.frames * recipe.sample_rate_hz)
        return Move(
            cut=self._cut[0],
            frames=self._frames,
            changed=self._recalculated(lowered_db) or not exact or recipe.is_lossy,
            new_depth=None if bit_depth == layout.bit_depth else bit_depth,
            sample_rate_hz=layout.sample_rate_hz,
            to_hz=recipe.sample_rate_hz,
            new_channels=recipe.gains is not None,
            loops={(loop.start, loop.end): (loop.first, loop.last) for loop in self._fitted},
            stretch=fitted if self._circular else 1.0,
            history=coding_history_line(recipe.sample_rate_hz, bit_depth, self._channels),
        )

    def _seam_of(self, path: Path) -> SeamFigures:
        with wav.open_regular(path) as file:
            return seam_of(file, wav.read_layout(file), self._new_points)


def _digest(file: BinaryIO) -> bytes:
    digest = hashlib.sha256()
    file.seek(0)
    while block := file.read(READ_BYTES):
        digest.update(block)
    return digest.digest()


def _digests(path: Path, pcm_sha256: str | None) -> tuple[str, str]:
    """Return the SHA-256 of a file and of its samples, which is known already where it had to be decoded."""
    with wav.open_regular(path) as file:
        return _digest(file).hex(), pcm_sha256 or _sound_digest(file, wav.read_layout(file))


def _sound_digest(file: BinaryIO, layout: wav.WavLayout) -> str:
    samples = hashlib.sha256()
    for raw in wav.raw_blocks(file, layout):
        samples.update(raw)
    return samples.hexdigest()
