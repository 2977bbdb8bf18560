"""A spec measured from a folder of sounds: what most files are is accepted, and the others are warned of."""

from __future__ import annotations

import json
import math
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

from audio_checks.report.findings import FileReport
from audio_checks.run.runner import judge, task_for, with_set_checks
from audio_checks.spec.delivery_spec import parse_spec
from audio_checks.system.plural import counted, verb

COMMON = 0.02  # of the files; what fewer have is the odd one out
USUAL_PEAK_DBTP = -1.0
# Everything that can be read is, and its true peak measured.
MEASURING = """\
format = 1
[accept]
containers = ["wav", "rf64", "flac", "ogg", "mp3"]
[limits]
true_peak_dbtp = 60.0
"""


@dataclass(frozen=True)
class MeasuredSpec:
    """A spec as TOML, and what it was measured from.

    Attributes
    ----------
    measured : int
        How many files it was measured from.
    warned : int
        How many of them have a warning by it.
    unreadable : tuple of (str, str)
        Files that cannot be read, and why.
    """

    text: str
    measured: int
    warned: int
    unreadable: tuple[tuple[str, str], ...]


def spec_from(
    paths: Sequence[str], *, name: str, jobs: int = 1, done: Callable[[FileReport], None] | None = None
) -> MeasuredSpec:
    """Return a spec by which no readable file has an error, and the unusual ones have a warning.

    Parameters
    ----------
    paths : sequence of str
        The sounds; WAV, FLAC, Ogg Vorbis, Opus and MP3 are read.
    name : str
        Of the spec.
    jobs : int
        The number of processes.
    done : callable, optional
        Called with the first report of each file as it is finished.
    """
    files = _judged(MEASURING, paths, jobs, done)
    readable = [file for file in files if file.facts is not None]
    text = _text(name, readable, ())
    entries = _judged(text, paths, jobs)
    failing = {finding.check for entry in entries for finding in entry.findings if finding.severity == "error"} - {
        "structure"
    }
    if failing:
        text = _text(name, readable, sorted(failing))
        entries = _judged(text, paths, jobs)
    return MeasuredSpec(
        text,
        len(readable),
        sum(bool(entry.count("warning", waived=False)) for entry in entries),
        tuple((file.path, file.findings[0].message) for file in files if file.facts is None and file.findings),
    )


def _judged(
    text: str, paths: Sequence[str], jobs: int, done: Callable[[FileReport], None] | None = None
) -> list[FileReport]:
    spec = parse_spec(text)
    tasks = [replace(task_for(path, spec), shipped=True) for path in paths]
    return with_set_checks(tasks, judge(tasks, jobs=jobs, done=done))


def _text(name: str, files: Sequence[FileReport], warned: Iterable[str]) -> str:
    lines = ["format = 1", f"name = {json.dumps(name, ensure_ascii=False)}".replace("\x7f", "\\u007f"), "", "[accept]"]
    facts = [file.facts for file in files if file.facts is not None]
    count = len(facts)
    lines.append(
        f"# measured from {counted(count, 'file')}; values of fewer than {100 * COMMON:.0f} % of them are left out"
    )
    coded = [fact for fact in facts if fact.get("bit_rate_kbps") is not None]
    plain = [fact for fact in facts if fact.get("bit_rate_kbps") is None]
    for key, listed, those in (
        ("container", "containers", facts),
        ("encoding", "encodings", facts),
        ("sample_rate_hz", "sample_rates_hz", facts),
        ("bit_depth", "bit_depths", plain),
        ("channels", "channels", facts),
    ):
        lines += _listed(listed, Counter(file_facts[key] for file_facts in those))
    lines += _range("duration_s", [fact["duration_s"] for fact in facts], 0.01)
    lines += _range("bit_rate_kbps", [file_facts["bit_rate_kbps"] for file_facts in coded], 1.0)
    measured = [file.to_dict()["measurements"] or {} for file in files]
    peaks = [figures["true_peak_dbtp"] for figures in measured if figures.get("true_peak_dbtp") is not None]
    over = sum(peak > USUAL_PEAK_DBTP for peak in peaks)
    limit_dbtp = USUAL_PEAK_DBTP if over <= COMMON * count else math.ceil(10 * max(peaks)) / 10
    above = f"{over:,} of {counted(count, 'file')} {verb(over, 'is', 'are')}"
    lines += ["", "[limits]", "silence_below_dbfs = -90.0"]
    lines.append(f"true_peak_dbtp = {limit_dbtp:.1f}  # {above} above {USUAL_PEAK_DBTP:g} dBTP")
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
