"""The report for people: grouped by file, the worst first, the figure before the limit before the fix."""

from collections.abc import Iterator

from audio_checks.findings import FileReport, Finding, Report, printable
from audio_checks.terminal import BOLD, DIM, GREEN, MAGENTA, RED, YELLOW, Ink

VERDICT_COLOURS = {"unjudged": MAGENTA, "unreadable": RED, "rejected": RED, "conforming": GREEN}
SEVERITY_COLOURS = {"error": RED, "warning": YELLOW}
WORST_FIRST = tuple(VERDICT_COLOURS)
LAYOUTS = {1: "mono", 2: "stereo"}
FIX_INDENT = " " * 11


def judged(report: Report, *, colour: bool) -> str:
    """Return the files that something was found in, and a line that sums up."""
    ink = Ink(colour)
    shown = sorted((entry for entry in report.files if entry.findings), key=_badness)
    blocks = ["\n".join(_file(entry, ink)) + "\n" for entry in shown]
    return "\n".join([*blocks, "\n".join(_summary(report, ink)) + "\n"])


def measured(report: Report, *, colour: bool) -> str:
    """Return each file with its figures, one a line."""
    ink = Ink(colour)
    return "\n".join("\n".join(_figures(entry, ink)) + "\n" for entry in report.files)


def _badness(entry: FileReport) -> tuple[int, int, int]:
    return WORST_FIRST.index(entry.verdict), -entry.count("error"), -entry.count("warning")


def _file(entry: FileReport, ink: Ink) -> Iterator[str]:
    verdict = ink(entry.verdict, VERDICT_COLOURS[entry.verdict], BOLD)
    about = ink(", ".join(_facts(entry)), DIM)
    yield "  ".join(part for part in (ink(printable(entry.path), BOLD), verdict, about) if part)
    for finding in entry.findings:
        yield from _finding(finding, ink)


def _finding(finding: Finding, ink: Ink) -> Iterator[str]:
    severity = finding.severity or "warning"
    where = f" at {_span(finding)}" if finding.start_s is not None else ""
    waived = "  waived" if finding.waived else ""
    label = ink(f"{severity:<7}", *([DIM] if finding.waived else [SEVERITY_COLOURS[severity]]))
    yield f"  {label}  {printable(finding.message)}{where}  {ink(printable(finding.code), DIM)}{ink(waived, DIM)}"
    yield f"{FIX_INDENT}{ink('fix:', DIM)} {printable(finding.fix)}"


def _span(finding: Finding) -> str:
    start_s, end_s = finding.start_s or 0.0, finding.end_s
    return f"{start_s:.3f} s" if end_s is None or end_s - start_s < 0.0005 else f"{start_s:.3f} to {end_s:.3f} s"


def _facts(entry: FileReport) -> Iterator[str]:
    if entry.facts is not None:
        channels = entry.facts["channels"]
        yield f"{entry.facts['sample_rate_hz'] / 1000:g} kHz"
        yield f"{entry.facts['bit_depth']} bit{' float' if entry.facts['encoding'] == 'float' else ''}"
        yield LAYOUTS.get(channels, f"{channels} channels")
        yield f"{entry.facts['duration_s']:.2f} s"
    if entry.category:
        yield printable(entry.category)


def _summary(report: Report, ink: Ink) -> Iterator[str]:
    counts = report.summary
    if report.not_run:
        yield ink(f"not run, because this version lacks them: {', '.join(report.not_run)}", YELLOW)
    verdicts = [
        ink(f"{counts[verdict]} {verdict}", VERDICT_COLOURS[verdict])
        for verdict in reversed(WORST_FIRST)
        if counts[verdict]
    ]
    found = [_count(counts["errors"], "error"), _count(counts["warnings"], "warning")]
    if counts["waived"]:
        found.append(f"{counts['waived']} waived")
    total = ink(_count(counts["files"], "file"), BOLD)
    yield f"{total}: {', '.join(verdicts) or 'nothing to judge'}; {', '.join(found)}"
    checks = dict.fromkeys(finding.check for entry in report.files for finding in entry.findings if not finding.waived)
    if checks:
        yield ink(f"why: audio-checks explain {next(iter(checks))}", DIM)


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def _figures(entry: FileReport, ink: Ink) -> Iterator[str]:
    yield "  ".join(part for part in (ink(printable(entry.path), BOLD), ink(", ".join(_facts(entry)), DIM)) if part)
    if entry.facts is None:
        yield "  cannot be read"
        return
    figures = {"effective_bits": entry.facts["effective_bits"], **entry.to_measured()["measurements"]}
    for name, value in figures.items():
        yield f"  {name:<22}{_value(value)}"


def _value(value: object) -> str:
    if value is None:
        return "-"
    if isinstance(value, float):
        return f"{value:.2f}"
    if isinstance(value, list | tuple):
        return ", ".join(map(str, value)) or "none"
    return printable(str(value))
