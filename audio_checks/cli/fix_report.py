"""Output of `audio-checks fix`: for each file the fixes, and the findings left."""

import os
import textwrap
from collections.abc import Iterator

from audio_checks.cli.terminal import BOLD, DIM, GREEN, RED, YELLOW, Ink, width
from audio_checks.fixing.files import FixedFile, FixRun
from audio_checks.fixing.fixed import FixedMaster
from audio_checks.report.findings import printable

LEVELS = {
    "sample-peak": ("sample_peak_dbfs", "sample peak", "dBFS"),
    "true-peak": ("true_peak_dbtp", "true peak", "dBTP"),
    "loudness": ("integrated_lufs", "loudness", "LUFS"),
}
"""How a gain is reported: the figure, its name and its unit, by the check that asked for it."""
WORD_WIDTH = len("refused") + 2


def report_text(run: FixRun, *, colour: bool, summary: bool = True) -> str:
    """Return the fixes of each file and the findings left, with a line that sums up unless it is left out."""
    ink = Ink(colour)
    blocks = ["\n".join(_lines(file, ink)) + "\n" for file in run.files if file.state != "fine"]
    if not summary:
        return "\n".join(blocks)
    counts, files = run.counts(), f"{len(run.files)} file{'' if len(run.files) == 1 else 's'}"
    summed = f"{files}: {counts['fixed']} fixed, {counts['partly']} in part, {counts['left']} not"
    return "\n".join([*blocks, f"{summed}, {counts['fine']} had nothing to fix\n"])


def _lines(file: FixedFile, ink: Ink) -> Iterator[str]:
    yield ink(printable(file.path), BOLD)
    if file.refusal is not None:
        yield f"  {ink('refused'.ljust(WORD_WIDTH), RED)}{printable(f'{file.refusal}; {file.refusal.fix}')}"
    if file.fixed is None:
        return
    for repair in file.fixed.repairs:
        changes = f"{repair.words}{_figures(file.fixed, repair.codes)}"
        yield f"  {ink('fixed'.ljust(WORD_WIDTH), GREEN)}{printable(changes)}"
    for left in file.fixed.left:
        tone = RED if left.finding.severity == "error" else YELLOW
        yield f"  {ink('left'.ljust(WORD_WIDTH), tone)}{printable(left.finding.message)}  {ink(left.finding.code, DIM)}"
        indent = " " * (WORD_WIDTH + 2)
        yield textwrap.fill(printable(left.why), width(), initial_indent=indent, subsequent_indent=indent)
    if file.fixed.path is not None:
        yield f"  {ink('copy'.ljust(WORD_WIDTH), DIM)}{printable(os.fspath(file.fixed.path))}"


def _figures(fixed: FixedMaster, codes: tuple[str, ...]) -> str:
    """Return the levels that a gain moved, before and after."""
    if fixed.after is None:
        return ""
    changes = []
    for code in codes:
        figure, words, unit = LEVELS.get(code.partition(":")[0], ("", "", ""))
        before, after = fixed.before.measurements.get(figure), fixed.after.measurements.get(figure)
        if before is not None and after is not None:
            changes.append(f"{words} {before:z.2f} to {after:z.2f} {unit}")
    return f" ({', '.join(changes)})" if changes else ""
