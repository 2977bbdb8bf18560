"""The figures of one file by name and unit, for checks and reports; `AudioFile` measures them."""

from __future__ import annotations

from typing import Any, Protocol

from audio_checks.measure.clicks import Click
from audio_checks.measure.codec_frames import Trace
from audio_checks.measure.cuts import Edge
from audio_checks.measure.decay import DecayFigures
from audio_checks.measure.dropouts import Dropout
from audio_checks.measure.flat_tops import FlatTop
from audio_checks.measure.repeats import Repeat
from audio_checks.measure.spectrum import MeanSpectrum

PLACES = frozenset(
    {
        "channel_peaks_dbfs",
        "clipped_spans",
        "click_places",
        "codec_traces",
        "decay",
        "dropout_places",
        "edges",
        "end_edge",
        "likeness_print",
        "mean_spectrum",
        "mono_loss_spans",
        "repeat_places",
        "pauses",
        "soft_spans",
        "start_edge",
    }
)
"""Figures that only checks and judgements read; reports list plain numbers."""

INAUDIBLE_BELOW_DBFS = -50.0  # peak of a sound whose faults no one hears
CUT_OFF_WITHIN_DB = 0.1  # of the highest sample: flat tops that low are what sets the peak


class Measured(Protocol):
    """An object that measures figures by name while its samples stream by, as `AudioFile` does."""

    def figure(self, name: str) -> Any:
        """Return one figure, measured when it is first asked for."""

    def measured(self) -> dict[str, Any]:
        """Return every measured figure by name."""


class Measurements:
    """The figures of one file; levels are -inf where there is only silence."""

    def __init__(self, file: Measured) -> None:
        self._file = file

    def to_dict(self) -> dict[str, Any]:
        """Return the measured figures by name; levels of silence are -inf still."""
        return {name: value for name, value in self._file.measured().items() if name not in PLACES}

    @property
    def is_silence(self) -> bool:
        """Whether every sample is zero."""
        return bool(self._file.figure("is_silence"))

    @property
    def sample_peak_dbfs(self) -> float:
        """The largest sample, in dBFS."""
        return float(self._file.figure("sample_peak_dbfs"))

    @property
    def sample_peak_s(self) -> float:
        """Return the time of the first largest sample, in seconds; 0 for silence."""
        return float(self._file.figure("sample_peak_s"))

    @property
    def true_peak_dbtp(self) -> float:
        """The highest point of the curve between the samples, in dBTP."""
        return float(self._file.figure("true_peak_dbtp"))

    @property
    def true_peak_s(self) -> float:
        """Return the curve's peak time, in seconds; 0 for silence."""
        return float(self._file.figure("true_peak_s"))

    @property
    def rms_dbfs(self) -> float:
        """RMS over all channels and the whole length, in dBFS (a full-scale square is 0)."""
        return float(self._file.figure("rms_dbfs"))

    @property
    def crest_db(self) -> float:
        """Sample peak over RMS, in dB; 0 for silence."""
        return float(self._file.figure("crest_db"))

    @property
    def dc_offset_percent(self) -> float:
        """The mean of the channel where it is farthest from zero, unsigned, in percent of full scale."""
        return float(self._file.figure("dc_offset_percent"))

    @property
    def silent_channels(self) -> tuple[int, ...]:
        """Channels of nothing but zeros; 1 is the first."""
        return tuple(self._file.figure("silent_channels"))

    @property
    def channel_peaks_dbfs(self) -> tuple[float, ...]:
        """The largest sample of each channel, in dBFS."""
        return tuple(self._file.figure("channel_peaks_dbfs"))

    @property
    def head_silence_ms(self) -> float:
        """Silence before the sound, in ms; see `edges`, at -60 dBFS."""
        return float(self._file.figure("head_silence_ms"))

    @property
    def tail_silence_ms(self) -> float:
        """Silence after the sound, in ms; see `edges`, at -60 dBFS."""
        return float(self._file.figure("tail_silence_ms"))

    def edges(self, below_dbfs: float) -> tuple[float, float]:
        """Return the silence at head and tail, in ms.

        Silent is what stays below `below_dbfs` or 60 dB under the file's peak, whichever is lower,
        in every channel. In a silent file both are the whole length.
        """
        head, tail = self._file.figure("edges")(below_dbfs)
        return float(head), float(tail)

    @property
    def pauses(self) -> tuple[tuple[float, float], ...]:
        """Silent stretches of 0.6 s or more with sound on both sides, each from when to when, in seconds."""
        return tuple(self._file.figure("pauses"))

    @property
    def clipped_runs(self) -> int:
        """Crests that are cut off, at full scale or at a lower ceiling."""
        return int(self._file.figure("clipped_runs"))

    @property
    def clipped_spans(self) -> tuple[FlatTop, ...]:
        """The first of these flat tops."""
        return tuple(self._file.figure("clipped_spans"))

    @property
    def is_inaudible(self) -> bool:
        """Whether the whole sound lies so low that no one hears what is wrong with it: that is then its level."""
        return self.sample_peak_dbfs < INAUDIBLE_BELOW_DBFS

    @property
    def is_cut_off(self) -> bool:
        """Whether the highest crests are cut off flat, so that no lower level brings them back.

        Floats over full scale are not: what lies there is kept, and comes back with a lower level.
        """
        peak = self.sample_peak_dbfs
        return peak <= CUT_OFF_WITHIN_DB and any(
            span.level_dbfs >= peak - CUT_OFF_WITHIN_DB for span in self.clipped_spans
        )

    @property
    def soft_tops(self) -> int:
        """Crests flattened softly, where most of the highest are."""
        return int(self._file.figure("soft_tops"))

    @property
    def soft_spans(self) -> tuple[FlatTop, ...]:
        """The first of these soft tops."""
        return tuple(self._file.figure("soft_spans"))

    @property
    def clicks(self) -> int:
        """Moments far sharper than everything around them."""
        return int(self._file.figure("clicks"))

    @property
    def click_places(self) -> tuple[Click, ...]:
        """The first of these clicks."""
        return tuple(self._file.figure("click_places"))

    @property
    def dropouts(self) -> int:
        """Holes in a sound that goes on before and after them."""
        return int(self._file.figure("dropouts"))

    @property
    def dropout_places(self) -> tuple[Dropout, ...]:
        """The first of these holes."""
        return tuple(self._file.figure("dropout_places"))

    @property
    def repeats(self) -> int:
        """Buffers that play again bit by bit."""
        return int(self._file.figure("repeats"))

    @property
    def repeat_places(self) -> tuple[Repeat, ...]:
        """The first of these repeats."""
        return tuple(self._file.figure("repeat_places"))

    @property
    def start_edge(self) -> Edge | None:
        """Return the start of the sound; None for silence."""
        edge: Edge | None = self._file.figure("start_edge")
        return edge

    @property
    def end_edge(self) -> Edge | None:
        """Return the end of the sound; None for silence."""
        edge: Edge | None = self._file.figure("end_edge")
        return edge

    @property
    def hum_dbfs(self) -> float | None:
        """RMS of the mains' steady lines; -inf where there are none, None for a sound that is too short."""
        value = self._file.figure("hum_dbfs")
        return None if value is None else float(value)

    @property
    def hum_hz(self) -> float | None:
        """50 or 60; None where there is no hum."""
        value = self._file.figure("hum_hz")
        return None if value is None else float(value)

    @property
    def noise_floor_dbfs(self) -> float | None:
        """RMS of the quietest pause in the noisiest channel; None for a sound that does not pause."""
        value = self._file.figure("noise_floor_dbfs")
        return None if value is None else float(value)

    @property
    def channel_correlation(self) -> float | None:
        """The least correlation of two channels, -1..1; None for mono or when only one channel sounds."""
        value = self._file.figure("channel_correlation")
        return None if value is None else float(value)

    @property
    def mono_loss_db(self) -> float | None:
        """Return the loss of the channels in left + right, in dB, 120 where nothing is left; None but for stereo."""
        value = self._file.figure("mono_loss_db")
        return None if value is None else float(value)

    @property
    def channel_difference_db(self) -> float | None:
        """Level of left − right under the louder channel, in dB, -inf for equal channels; None but for stereo."""
        value = self._file.figure("channel_difference_db")
        return None if value is None else float(value)

    def mono_loss_spans(self, limit_db: float) -> list[tuple[float, float]]:
        """Return the spans where a stereo sound loses more than a limit in mono: starts and ends in seconds."""
        spans = self._file.figure("mono_loss_spans")
        return [] if spans is None else list(spans(limit_db))

    @property
    def sample_step(self) -> float | None:
        """The step all samples stand on, in the file's own smallest; 1 where there is none, None where unknown."""
        value = self._file.figure("sample_step")
        return None if value is None else float(value)

    @property
    def likeness_print(self) -> str | None:
        """Return the print of nearly equal sounds, as text; None for silence, and where it was not asked for."""
        value = self._file.measured().get("likeness_print")
        return None if value is None else str(value)

    @property
    def integrated_lufs(self) -> float:
        """Gated loudness of the whole; -inf below 0.4 s, where `short_loudness_lufs` counts."""
        return float(self._file.figure("integrated_lufs"))

    @property
    def max_momentary_lufs(self) -> float:
        """The loudest 0.4 s, with silence before and after the file."""
        return float(self._file.figure("max_momentary_lufs"))

    @property
    def max_short_term_lufs(self) -> float:
        """The loudest 3 s, with silence before and after the file."""
        return float(self._file.figure("max_short_term_lufs"))

    @property
    def loudness_range_lu(self) -> float | None:
        """Loudness range; None when no 3 s of it are loud enough to count."""
        value = self._file.figure("loudness_range_lu")
        return None if value is None else float(value)

    @property
    def short_loudness_lufs(self) -> float:
        """Loudness for sounds of any length: the loudest 0.4 s, with silence around the file."""
        return float(self._file.figure("short_loudness_lufs"))

    @property
    def bandwidth_hz(self) -> float:
        """The highest frequency that stands out of the noise; 0 for silence."""
        return float(self._file.figure("bandwidth_hz"))

    @property
    def mean_spectrum(self) -> MeanSpectrum:
        """The mean power spectrum of all channels over the whole length."""
        spectrum: MeanSpectrum = self._file.figure("mean_spectrum")
        return spectrum

    @property
    def codec_traces(self) -> tuple[Trace, ...]:
        """Return the silence of lossy codecs' lines on the codecs' frames, one figure for each codec and rate."""
        traces: tuple[Trace, ...] = self._file.figure("codec_traces")
        return traces

    @property
    def decay(self) -> DecayFigures:
        """Energy by octave every 5 ms, and what its parts are made of."""
        figures: DecayFigures = self._file.figure("decay")
        return figures

    @property
    def seam_step_db(self) -> float:
        """Step from the loop's last frame to its first, over the largest step nearby, in dB."""
        return float(self._file.figure("seam_step_db"))

    @property
    def loop_seams(self) -> tuple[tuple[float, float], ...]:
        """Step and change of slope at the seam of each loop of the file, in dB over the largest nearby."""
        return tuple(self._file.figure("loop_seams"))

    @property
    def seam_slope_db(self) -> float:
        """Change of slope at the loop's seam, over the largest change nearby, in dB."""
        return float(self._file.figure("seam_slope_db"))
