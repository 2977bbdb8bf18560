"""The record of a master's way to a game file: the file's facts, and the losses."""

import math
from dataclasses import dataclass, is_dataclass
from pathlib import Path
from typing import Any, Literal

from audio_checks.render.dither import Dither
from audio_checks.report.findings import Finding
from audio_checks.spec.parts import Encoding

APART = frozenset({"path", "loss", "warnings"})  # of a game file's facts: left out, or reported separately


@dataclass(frozen=True)
class SeamFigures:
    """A loop's seam against the sound around it, in dB: step of level, change of slope."""

    step_db: float
    slope_db: float


@dataclass(frozen=True)
class Spectra:
    """Master and game file in the same bands, to be drawn over each other.

    Attributes
    ----------
    hz : tuple of float
        Middle of each band, rising from 20 Hz to half the master's rate.
    master_dbfs, render_dbfs : tuple of float
        RMS within the band; −inf where nothing does, above half its own rate for the game file.
    """

    hz: tuple[float, ...]
    master_dbfs: tuple[float, ...]
    render_dbfs: tuple[float, ...]


@dataclass(frozen=True)
class Loss:
    """The cost of a render.

    Attributes
    ----------
    before, after : dict
        Levels, true peak and loudness of the master and of the game file, named as in the report.
    above_nyquist_db : float
        Energy of the master above half the new rate, in dB against all of its energy; −inf for none.
    shelf_db : float
        By how much the top octave was lifted in its place.
    attenuation_db : float
        By how much the sound was lowered to keep the peak limits.
    requantisation_dbfs : float
        RMS of the difference between what was wanted and what was written (dither included), or of what the file of
        a lossy codec decodes to; −inf where every sample is exact.
    trimmed_s : (float, float)
        What was cut at the start and at the end.
    loop_fit_frames : float
        By how many frames a loop was lengthened (+) or shortened (−) to become whole.
    seam_before, seam_after : SeamFigures or None
        For loops.
    mono_loss_db : float or None
        What the sound lost where stereo became mono: 0 dB for equal channels, 3 for unrelated ones.
    spectra : Spectra
    """

    before: dict[str, Any]
    after: dict[str, Any]
    above_nyquist_db: float
    shelf_db: float
    attenuation_db: float
    requantisation_dbfs: float
    trimmed_s: tuple[float, float]
    loop_fit_frames: float
    seam_before: SeamFigures | None
    seam_after: SeamFigures | None
    mono_loss_db: float | None
    spectra: Spectra

    def to_dict(self) -> dict[str, Any]:
        """Return the report as plain values, −inf as None, levels of spectra to a tenth of a dB."""
        plain: dict[str, Any] = _plain(self)
        spectra = plain["spectra"]
        for key, levels in spectra.items():
            spectra[key] = [None if level is None else round(level, 1) for level in levels]
        return plain


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
        Whether samples were resampled, mixed, faded or lowered; if not, they are the master's own,
        rounded at most, and the bit depth is no higher than the master's.
    loop_points : tuple of (int, int)
        First and last frame of each loop written to the file.
    loop_fit_frames : float
        By how many frames a loop was lengthened (+) or shortened (−) to become whole.
    seam_before, seam_after : SeamFigures or None
        Of the master and of the file, for loops.
    bit_depth : int
        Of the samples; of a lossy codec, whose files have none, that of what it decodes to.
    measurements, loss
        Of a lossy codec's file: of what it decodes to.
    master_sha256, sha256, pcm_sha256 : str
        Digest of the master's bytes, of the file's, and of the file's samples. Decoders differ in the last bits, so
        that of what a lossy codec keeps holds on one machine.
    loss : Loss or None
        What was lost; None for previews.
    warnings : tuple of Finding
        What the ear should look into, such as a sound that phase eats in mono.
    """

    path: Path
    sample_rate_hz: int
    bit_depth: int
    encoding: Encoding | Literal["mp3"]
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
    renderer_version: str
    loss: Loss | None = None
    warnings: tuple[Finding, ...] = ()

    @property
    def duration_s(self) -> float:
        """Length in seconds."""
        return self.frames / self.sample_rate_hz

    def to_dict(self) -> dict[str, Any]:
        """Return everything but the path as plain values, −inf as None."""
        facts = {name: value for name, value in vars(self).items() if name not in APART}
        return {
            **_plain(facts),
            "loss": None if self.loss is None else self.loss.to_dict(),
            "warnings": [warning.to_dict() for warning in self.warnings],
            "duration_s": self.duration_s,
        }


def _plain(value: Any) -> Any:
    """Return data classes and plain values as plain values, every infinity as None, as JSON has it."""
    if isinstance(value, float):
        return None if math.isinf(value) else value
    if isinstance(value, dict):
        return {key: _plain(held) for key, held in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(held) for held in value]
    return _plain(vars(value)) if is_dataclass(value) else value
