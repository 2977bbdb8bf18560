"""Writes placeholders for the cues of a sound list without a take."""

import hashlib
import math
import os
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.errors import RenderRefused
from audio_checks.measure.loudness import Loudness
from audio_checks.metadata.layouts import LAYOUTS
from audio_checks.metadata.mark import broadcast_chunk, comment_chunk, marked_comment
from audio_checks.placeholders.pattern import pattern
from audio_checks.placeholders.recorded import read_recording
from audio_checks.placeholders.speech import synthesize_speech
from audio_checks.render.channels import ensure_codable
from audio_checks.render.coding import Coder
from audio_checks.render.dither import DITHERED_TO_BITS, quantised
from audio_checks.render.twiddles import gain_of
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec
from audio_checks.spec.sound_list import SoundList
from audio_checks.spec.sound_names import stems_of

DURATION_S = 1.0  # where the list asks for none
PEAK_DBFS = -12.0
UNDER_LIMIT_DB = 1.0  # true peaks lie that much above samples at most, for these tones
INSIDE_LU = 0.5  # of a loudness range
PAUSE_S = 0.2
PREFERRED_HZ, PREFERRED_BITS = 48_000, 24


@dataclass(frozen=True)
class Placeholder:
    """A placeholder that was made.

    Attributes
    ----------
    path : Path
        Of the file.
    number : str
        Of its cue.
    variation : int
        From 1.
    duration_s : float
        Of the file.
    is_spoken : bool
        Whether it says the cue's name; otherwise it is a pitched pattern.
    is_new : bool
        Whether it was written; False where the same file was there already.
    """

    path: Path
    number: str
    variation: int
    duration_s: float
    is_spoken: bool
    is_new: bool = True


def make_placeholders(
    sound_list: SoundList,
    spec: DeliverySpec,
    folder: str | os.PathLike[str],
    *,
    target: str | None = None,
    taken: Collection[str] = (),
    voice: bool = True,
) -> Iterator[Placeholder | RenderRefused]:
    """Write a placeholder for every variation of every cue that has none in `taken`; cut cues need none.

    Parameters
    ----------
    sound_list : SoundList
        The cues.
    spec : DeliverySpec
        The whole spec; each cue's category counts.
    folder : path
        Where they go, under the cue's own name; game files in the folders of the target, as packs have them.
    target : str, optional
        Make game files of this target; without it, files that conform as deliveries.
    taken : collection of str
        Stems that a take is there for.
    voice : bool
        Speak where an engine is installed.

    Yields
    ------
    Placeholder or RenderRefused
        In the list's order. Refused (`placeholder:no-name`, `placeholder:over-sound`,
        `placeholder:container`) is one placeholder, not the rest.

    Raises
    ------
    SpecError
        The spec names no such target.
    """
    for cue in sound_list.cues:
        if cue.state == "cut":
            continue
        category = cue.category
        view = spec.for_category(category) if target is None else spec.for_target(target, category)
        stems = stems_of(cue.name, cue.file_name, cue.variations)
        if not stems:
            yield RenderRefused(
                f"cue {cue.number} has neither a file name nor a name",
                "placeholder:no-name",
                "give it one in the sound list",
            )
        for variation, stem in enumerate(stems, start=1):
            if stem in taken:
                continue
            name = f"{stem}{view.ending}"
            path = Path(folder, name if view.target is None else view.target.path_of(name, category, cue.language))
            try:
                yield make_placeholder(cue, variation, view, path, voice=voice)
            except RenderRefused as refused:
                yield refused


def make_placeholder(
    cue: CueFacts, variation: int, view: DeliverySpec, path: Path, *, voice: bool = True, said: bytes | None = None
) -> Placeholder:
    """Write one placeholder: as long as its cue, within the limits of the view, and marked.

    Parameters
    ----------
    cue : CueFacts
        The cue that it replaces.
    variation : int
        From 1.
    view : DeliverySpec
        For the cue's category, and for a target where game files are wanted.
    path : Path
        Where to. An existing placeholder is rewritten only where something changed.
    voice : bool
        Speak where an engine is installed.
    said : bytes, optional
        What a person said for the cue, as `tidy_recording` returns it; heard in place of the engine.

    Returns
    -------
    Placeholder

    Raises
    ------
    RenderRefused
        `placeholder:over-sound`: another file than a placeholder has that name.
        `placeholder:container`: the spec accepts no WAV.
    """
    _ensure_free(path)
    form = _Form.of(view, cue)
    recording = read_recording(said, form.sample_rate_hz) if said is not None else None
    frames = _frames(
        cue, view, form.sample_rate_hz, DURATION_S if recording is None else len(recording) / form.sample_rate_hz
    )
    if recording is not None:
        word: NDArray[np.float64] | None = _fitted(recording, frames)
    else:
        word = _word(cue, variation, form.sample_rate_hz, frames) if voice else None
    samples = pattern(cue.number, variation, frames, form.sample_rate_hz) if word is None else word
    leveled = _leveled(samples, view, form)
    scratch = path.with_name(f".{path.name}.{os.getpid()}.part")
    path.parent.mkdir(parents=True, exist_ok=True)
    try:
        form.write(scratch, leveled, cue.number)
        is_new = not path.exists() or path.read_bytes() != scratch.read_bytes()
        if is_new:
            os.replace(scratch, path)
    finally:
        scratch.unlink(missing_ok=True)
    return Placeholder(path, cue.number, variation, len(leveled) / form.sample_rate_hz, word is not None, is_new)


def _ensure_free(path: Path) -> None:
    from audio_checks.run.runner import is_placeholder

    if path.exists() and not is_placeholder(path):
        raise RenderRefused(
            f"{path} is not a placeholder, and is not overwritten",
            "placeholder:over-sound",
            "name another --out, or name the folder of the takes: a cue with a take needs no placeholder",
        )


@dataclass(frozen=True)
class _Form:
    """The intended form of the file."""

    sample_rate_hz: int
    bit_depth: int
    encoding: Literal["pcm", "float"]
    channels: int
    channel_mask: int | None
    dither: Literal["tpdf", "shaped", "none"]
    coder: Coder | None = None

    @classmethod
    def of(cls, view: DeliverySpec, cue: CueFacts) -> "_Form":
        """Return the form of a target, or the plainest that deliveries may have."""
        accept, target = view.accept, view.target
        is_wav = target is None or target.coding is None
        if is_wav and accept.containers is not None and "wav" not in accept.containers:
            raise RenderRefused(
                f"the spec accepts {', '.join(accept.containers)}, and placeholders are WAV files",
                "placeholder:container",
                'name a --target, or add "wav" to [accept] containers',
            )
        layouts = sorted((LAYOUTS[name] for name in accept.layouts or ()), key=lambda layout: layout.channels)
        counts = view.channels_for(cue)
        fitting = [layout for layout in layouts if counts is None or layout.channels in counts]
        channels = fitting[0].channels if fitting else min(counts or (1,))
        mask = fitting[0].masks[0] if fitting and channels > 2 and fitting[0].masks else None
        if target is not None:
            ensure_codable(channels, target)
            is_float = target.is_lossy or target.encoding == "float"
            coder = None if is_wav else Coder(target.encoding, target.quality or 0.0)
            samples: Literal["pcm", "float"] = "float" if is_float else "pcm"
            return cls(target.sample_rate_hz, target.bit_depth, samples, channels, mask, target.dither, coder)
        rates, depths = accept.sample_rates_hz or (PREFERRED_HZ,), accept.bit_depths or (PREFERRED_BITS,)
        is_pcm = accept.encodings is None or "pcm" in accept.encodings
        valid = [depth for depth in depths if depth in ((8, 16, 24) if is_pcm else (32, 64))]
        depth = max(valid, default=PREFERRED_BITS if is_pcm else 32)
        rate = PREFERRED_HZ if PREFERRED_HZ in rates else min(rates)
        return cls(rate, depth, "pcm" if is_pcm else "float", channels, mask, "tpdf")

    def write(self, path: Path, samples: NDArray[np.float64], number: str) -> None:
        """Write the file and its mark: around the sound of a WAV file, since editors show one end or the other."""
        if self.coder is None:
            self._write_wav(path, samples, number)
            return
        plain = path.with_name(f"{path.name}.plain")
        seed = hashlib.sha256(number.encode("utf-8", "replace")).digest()
        try:
            self._write_wav(plain, samples, number)
            self.coder.write(plain, path, seed=seed, comments=[marked_comment(number)])
        finally:
            plain.unlink(missing_ok=True)

    def _write_wav(self, path: Path, samples: NDArray[np.float64], number: str) -> None:
        frames = np.repeat(samples[:, np.newaxis], self.channels, axis=1)
        blocks: Iterable[NDArray[np.integer] | NDArray[np.floating]]
        if self.encoding == "float":
            written: NDArray[np.floating] = frames.astype(np.float32 if self.bit_depth == 32 else np.float64)
            blocks = [written]
        else:
            seed = hashlib.sha256(number.encode("utf-8", "replace")).digest()
            dither = self.dither if self.bit_depth <= DITHERED_TO_BITS else "none"
            blocks = quantised([frames], bit_depth=self.bit_depth, channels=self.channels, dither=dither, seed=seed)
        wav.write_wav(
            path,
            blocks,
            sample_rate_hz=self.sample_rate_hz,
            bit_depth=self.bit_depth,
            encoding=self.encoding,
            channels=self.channels,
            frames=len(samples),
            channel_mask=self.channel_mask,
            chunks=[broadcast_chunk(number)],
            chunks_after=[comment_chunk(number)],
        )


def _fitted(recording: NDArray[np.float64], frames: int) -> NDArray[np.float64]:
    """Return a recording as long as its cue: cut, or with silence after it."""
    fitted = np.zeros(frames)
    fitted[: len(recording)] = recording[:frames]
    return fitted


def _frames(cue: CueFacts, view: DeliverySpec, sample_rate_hz: int, usual_s: float) -> int:
    bounds = view.accept.duration_s
    duration_s = max(cue.duration_s or usual_s, bounds.min or 0.0)
    if bounds.max is not None:
        duration_s = min(duration_s, bounds.max)
    return max(1, round(duration_s * sample_rate_hz))


def _word(cue: CueFacts, variation: int, sample_rate_hz: int, frames: int) -> NDArray[np.float64] | None:
    """Return the cue's name, spoken, then its pattern for what is left of its length; None where that cannot be."""
    name = cue.name or cue.file_name.rpartition(".")[0] or cue.file_name
    name = name.replace("_", " ")
    spoken = synthesize_speech(f"{name} {variation}" if cue.variations > 1 else name, sample_rate_hz, frames)
    if spoken is None:
        return None
    whole = np.zeros(frames)
    whole[: len(spoken)] = spoken
    rest = frames - len(spoken) - round(PAUSE_S * sample_rate_hz)
    if rest > 0:
        whole[frames - rest :] = pattern(cue.number, variation, rest, sample_rate_hz)
    return whole


def _leveled(samples: NDArray[np.float64], view: DeliverySpec, form: _Form) -> NDArray[np.float64]:
    """Return the sound at a level that the limits of the view let pass."""
    limits = view.limits
    peak_dbfs = min(
        PEAK_DBFS,
        (limits.sample_peak_dbfs or 0.0) - UNDER_LIMIT_DB,
        (limits.true_peak_dbtp or 0.0) - UNDER_LIMIT_DB,
    )
    sound = samples * (gain_of(peak_dbfs) / max(float(np.abs(samples).max()), 1e-9))
    loudness_limits = limits.loudness_lufs
    if not loudness_limits:
        return sound
    meter = Loudness(form.sample_rate_hz, form.channels, len(sound))
    meter.add(np.repeat(sound[:, np.newaxis], form.channels, axis=1))
    figures = meter.result()
    loudness = figures["integrated_lufs"]
    if loudness is None or not math.isfinite(loudness):
        loudness = figures["short_loudness_lufs"]
    low = loudness if loudness_limits.min is None else loudness_limits.min + INSIDE_LU
    high = loudness if loudness_limits.max is None else loudness_limits.max - INSIDE_LU
    ceiling_db = min(limits.sample_peak_dbfs or 0.0, limits.true_peak_dbtp or 0.0) - UNDER_LIMIT_DB - peak_dbfs
    change_db = min(max(loudness, low), max(high, low)) - loudness
    return sound * gain_of(round(min(change_db, ceiling_db), 3))  # no machine's logarithm shows in the bytes
