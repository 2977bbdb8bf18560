"""A spec measured from a folder of sounds: what most files are is accepted, and the others are warned of."""

from __future__ import annotations

import json
import math
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field

from audio_checks.audio.audio_file import AudioFile
from audio_checks.errors import AudioChecksError
from audio_checks.report.findings import FileReport
from audio_checks.run.runner import judge, task_for, with_set_checks
from audio_checks.spec.delivery_spec import parse_spec

COMMON = 0.02  # of the files; what fewer have is the odd one out
FIGURES = ("sample_peak_dbfs", "true_peak_dbtp")
USUAL_PEAK_DBTP = -1.0


@dataclass
class Measured:
    """What the files of a folder are.

    Attributes
    ----------
    unreadable : list of (str, str)
        Files that cannot be read, and why.
    """

    facts: list[dict[str, object]] = field(default_factory=list)
    true_peaks_dbtp: list[float] = field(default_factory=list)
    unreadable: list[tuple[str, str]] = field(default_factory=list)


@dataclass(frozen=True)
class MeasuredSpec:
    """A spec as TOML, and what it was measured from; `warned` counts the files with a warning."""

    text: str
    measured: Measured
    warned: int


def spec_from(
    paths: Sequence[str], *, name: str, jobs: int = 1, done: Callable[[str], None] | None = None
) -> MeasuredSpec:
    """Return a spec by which no readable file has an error, and the unusual ones have a warning.

    Parameters
    ----------
    paths : sequence of str
        The sounds; WAV, FLAC, Ogg Vorbis, Opus and MP3 are read.
    name : str
        Of the spec.
    jobs : int
        The number of processes that judge.
    done : callable, optional
        Called with each path once it is measured.
    """
    measured = Measured()
    for path in paths:
        _measure(path, measured)
        if done:
            done(path)
    text = _text(name, measured, ())
    entries = _judged(text, paths, jobs)
    failing = {one.check for entry in entries for one in entry.findings if one.severity == "error"} - {"structure"}
    if failing:
        text = _text(name, measured, sorted(failing))
        entries = _judged(text, paths, jobs)
    return MeasuredSpec(text, measured, sum(bool(entry.count("warning", waived=False)) for entry in entries))


def _measure(path: str, measured: Measured) -> None:
    try:
        with AudioFile(path, coded=True) as file:
            file.prepare(FIGURES)
            facts, peak_dbtp = file.facts, file.measurements.true_peak_dbtp
            measured.facts.append(
                {
                    "container": facts.container,
                    "encoding": facts.encoding,
                    "sample_rate_hz": facts.sample_rate_hz,
                    "bit_depth": facts.bit_depth if facts.bit_rate_kbps is None else None,
                    "channels": facts.channels,
                    "duration_s": facts.duration_s,
                    "bit_rate_kbps": facts.bit_rate_kbps,
                }
            )
            measured.true_peaks_dbtp.append(peak_dbtp)
    except AudioChecksError as error:
        measured.unreadable.append((path, str(error)))


def _judged(text: str, paths: Sequence[str], jobs: int) -> list[FileReport]:
    spec = parse_spec(text)
    tasks = [task_for(path, spec, coded=True) for path in paths]
    return with_set_checks(tasks, judge(tasks, jobs=jobs))


def _text(name: str, measured: Measured, warned: Iterable[str]) -> str:
    lines = ["format = 1", f"name = {json.dumps(name, ensure_ascii=False)}".replace("\x7f", "\\u007f"), "", "[accept]"]
    count = len(measured.facts)
    lines.append(f"# measured from {count:,} files; values of fewer than {100 * COMMON:.0f} % of them are left out")
    for key, listed in (
        ("container", "containers"),
        ("encoding", "encodings"),
        ("sample_rate_hz", "sample_rates_hz"),
        ("bit_depth", "bit_depths"),
        ("channels", "channels"),
    ):
        lines += _listed(listed, Counter(one[key] for one in measured.facts if one[key] is not None))
    lines += _range("duration_s", [_number(one["duration_s"]) for one in measured.facts], 0.01)
    lines += _range(
        "bit_rate_kbps", [_number(one["bit_rate_kbps"]) for one in measured.facts if one["bit_rate_kbps"]], 1.0
    )
    peaks = [one for one in measured.true_peaks_dbtp if math.isfinite(one)]
    over = sum(one > USUAL_PEAK_DBTP for one in peaks)
    limit_dbtp = USUAL_PEAK_DBTP if over <= COMMON * count else math.ceil(10 * max(peaks)) / 10
    lines += ["", "[limits]", "silence_below_dbfs = -90.0"]
    lines.append(f"true_peak_dbtp = {limit_dbtp:.1f}  # {over:,} of {count:,} files are above {USUAL_PEAK_DBTP:g} dBTP")
    lines += ["", "[checks]", 'true-peak = "warning"']
    lines += [f'{check} = "warning"  # some files fail it' for check in warned if check != "true-peak"]
    return "\n".join(lines) + "\n"


def _listed(key: str, counts: Counter[object]) -> list[str]:
    """Return a line that accepts the common values, with how many files have each in a comment."""
    total = counts.total()
    if not total:
        return []
    common = [value for value, number in counts.most_common() if number >= COMMON * total]
    shown = ", ".join(f"{value}: {number:,}" for value, number in counts.most_common(8))
    return [f"{key} = {json.dumps(common)}  # {shown}"]


def _range(key: str, values: Sequence[float], step: float) -> list[str]:
    """Return a line from the least to the greatest value, rounded outwards."""
    if not values:
        return []
    low, high = math.floor(min(values) / step) * step, math.ceil(max(values) / step) * step
    return [f"{key} = {{ min = {low:.2f}, max = {high:.2f} }}"]


def _number(value: object) -> float:
    return float(value) if isinstance(value, int | float) else 0.0
