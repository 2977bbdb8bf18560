"""Facts of a master that a render needs beforehand, and those in its report: one pass over the file."""

import math
from typing import Any, BinaryIO, Protocol

from numpy import float64
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.measure.average_spectrum import AverageSpectrum
from audio_checks.measure.edges import Edges
from audio_checks.measure.levels import Levels
from audio_checks.measure.loudness import Loudness, channel_weights
from audio_checks.measure.phase import Phase
from audio_checks.measure.seam import Seam
from audio_checks.measure.true_peak import TruePeak
from audio_checks.render.rendered import SeamFigures, Spectra
from audio_checks.report.findings import Finding


class Accumulator(Protocol):
    """Something that measures a stream."""

    def add(self, block: NDArray[float64]) -> None:
        """Take the next samples, shape (n, channels)."""

    def result(self) -> Any:
        """Return the measurements."""


class Survey:
    """The figures asked of a master before it is rendered, measured in one pass."""

    def __init__(
        self, file: BinaryIO, layout: wav.WavLayout, *, to_mono: bool, trims: bool, measures_loss: bool
    ) -> None:
        size = layout.sample_rate_hz, layout.channels, layout.frames
        self._edges = Edges(*size) if trims else None
        self._phase = Phase(*size) if to_mono else None
        self._spectrum = AverageSpectrum(*size, bands_of_hz=size[0]) if measures_loss else None
        weights = channel_weights(layout.channels, layout.channel_mask)
        meters: tuple[Accumulator, ...] = ()
        if measures_loss:
            meters = Levels(*size), TruePeak(*size), Loudness(*size, weights=weights)
        others = [measure for measure in (self._edges, self._phase, self._spectrum) if measure is not None]
        if meters or others:
            for block in wav.blocks(file, layout):
                for accumulator in (*meters, *others):
                    accumulator.add(block)
        self.figures = {name: value for meter in meters for name, value in meter.result().items()}
        self._rate, self._frames = layout.sample_rate_hz, layout.frames

    def silence_frames(self, below_dbfs: float | None) -> tuple[int, int]:
        """Return the frames of silence at head and tail; none where nothing is trimmed, or all is digital silence."""
        if self._edges is None or below_dbfs is None:
            return 0, 0
        head_ms, tail_ms = self._edges.edges(below_dbfs)
        head, tail = round(head_ms * self._rate / 1000), round(tail_ms * self._rate / 1000)
        return (head, tail) if head + tail < self._frames else (0, 0)

    def mono_loss_db(self) -> float | None:
        """Return the sound's loss where stereo becomes mono; None where it does not, and for silence."""
        return None if self._phase is None else self._phase.result()["mono_loss_db"]

    def mono_warnings(self, limit_db: float) -> tuple[Finding, ...]:
        """Return the warning of a sound that phase eats."""
        loss = self.mono_loss_db()
        if self._phase is None or loss is None or loss <= limit_db:
            return ()
        spans = self._phase.result()["mono_loss_spans"](limit_db)
        start_s, end_s = max(spans, key=lambda span: span[1] - span[0], default=(0.0, None))
        return (
            Finding(
                code="render:mono-loss",
                message=f"{loss:.1f} dB are lost where left and right become mono, limit {limit_db:g} dB",
                fix="ask for a mono master, or give the target other mono_gains, such as [1.0, 0.0] for the left side",
                severity="warning",
                measured=loss,
                limit=limit_db,
                unit="dB",
                start_s=start_s,
                end_s=end_s,
            ),
        )

    def above_db(self, hz: float) -> float:
        """Return the energy above a frequency against all of it, in dB."""
        return -math.inf if self._spectrum is None else self._spectrum.above_db(hz)

    def spectra(self, render: AverageSpectrum | None) -> Spectra | None:
        """Return the bands of master and render; None where the loss is not measured."""
        if self._spectrum is None or render is None:
            return None
        master = self._spectrum.result()
        levels = render.result().levels_dbfs
        return Spectra(
            hz=tuple(round(float(hz), 1) for hz in master.centres_hz),
            master_dbfs=tuple(float(level) for level in master.levels_dbfs),
            render_dbfs=tuple(float(level) for level in levels),
        )


def seam_of(file: BinaryIO, layout: wav.WavLayout, points: tuple[tuple[int, int], ...]) -> SeamFigures:
    """Return the seam figures of a file's first loop, or of all of it."""
    seam = Seam(layout.sample_rate_hz, layout.channels, layout.frames, loops=[(*points[0], False)] if points else ())
    for block in wav.blocks(file, layout):
        seam.add(block)
    figures = seam.result()
    return SeamFigures(figures["seam_step_db"], figures["seam_slope_db"])
