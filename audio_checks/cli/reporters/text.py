"""The report for people: grouped by file, the worst first, the figure before the limit before the fix."""

import textwrap
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from audio_checks.cli.decay_drawing import drawn
from audio_checks.cli.reporters import Style
from audio_checks.cli.terminal import BOLD, DIM, GREEN, MAGENTA, RED, YELLOW, Ink
from audio_checks.judge import CANNOT_TELL, score_in_words
from audio_checks.report.findings import FileReport, Finding, Report, printable
from audio_checks.spec.check_names import GRAVITY, Severity
from audio_checks.spec.loudness_presets import in_words

VERDICT_COLOURS = {"unjudged": MAGENTA, "unreadable": RED, "rejected": RED, "conforming": GREEN}
SEVERITIES: tuple[Severity, ...] = ("error", "warning")
SEVERITY_COLOURS = {"error": RED, "warning": YELLOW, "information": DIM}
SEVERITY_LABELS = {"information": "info"}
WORST_FIRST = tuple(VERDICT_COLOURS)
LAYOUTS = {1: "mono", 2: "stereo"}
UNITS = {
    "dbfs": "dBFS",
    "dbtp": "dBTP",
    "lufs": "LUFS",
    "lu": "LU",
    "db": "dB",
    "percent": "%",
    "hz": "Hz",
    "ms": "ms",
    "s": "s",
}
DECIMALS = {"s": 3, "ms": 1, "Hz": 0}
INDENT = " " * 11
FIX = "fix: "
MANY_FILES = 5  # from here on, what was found most is summed up too
MOST_FOUND = 5
LFS_POINTER = "container:git-lfs-pointer"


def judged(report: Report, style: Style) -> str:
    """Return the files that something was found in, and a few lines that sum up.

    A file is left out when all that was found in it is waived.
    """
    ink = Ink(style.colour)
    shown = sorted((entry for entry in report.files if _counting(entry)), key=_badness)
    blocks = ["\n".join(_file(entry, ink, style.columns)) + "\n" for entry in shown]
    summary = ["\n".join(_summary(report, ink)) + "\n"] if style.summary else []
    return "\n".join([*blocks, *summary])


def measured(report: Report, style: Style) -> str:
    """Return each file with its figures, one a line."""
    ink = Ink(style.colour)
    return "\n".join("\n".join(_figures(entry, ink)) + "\n" for entry in report.files)


def _counting(entry: FileReport) -> list[Finding]:
    return [finding for finding in entry.findings if not finding.waived]


def _badness(entry: FileReport) -> tuple[int, int, int]:
    return (
        WORST_FIRST.index(entry.verdict),
        -entry.count("error", waived=False),
        -entry.count("warning", waived=False),
    )


def _file(entry: FileReport, ink: Ink, columns: int | None) -> Iterator[str]:
    verdict = ink(entry.verdict, VERDICT_COLOURS[entry.verdict], BOLD)
    about = ink(", ".join(_facts(entry)), DIM)
    yield "  ".join(part for part in (ink(printable(entry.path), BOLD), verdict, about) if part)
    for finding in entry.findings:
        yield from _finding(finding, ink, columns)


def _finding(finding: Finding, ink: Ink, columns: int | None) -> Iterator[str]:
    severity = finding.severity or "warning"
    dim = (DIM,) if finding.waived else ()
    code = printable(finding.code) + ("  waived" if finding.waived else "")
    lines = _lines(printable(finding.sentence), columns)
    shown = [ink(line, *dim) for line in lines]
    if columns is None or len(INDENT) + len(lines[-1]) + 2 + len(code) <= columns:
        shown[-1] += f"  {ink(code, DIM)}"
    else:
        shown.append(ink(code, DIM))
    label = ink(f"{SEVERITY_LABELS.get(severity, severity):<7}", *(dim or (SEVERITY_COLOURS[severity],)))
    yield f"  {label}  {shown[0]}"
    yield from (f"{INDENT}{line}" for line in shown[1:])
    if not finding.waived:
        first, *rest = _lines(printable(finding.fix), None if columns is None else columns - len(FIX))
        yield f"{INDENT}{ink(FIX, DIM)}{first}"
        yield from (f"{INDENT}{' ' * len(FIX)}{line}" for line in rest)


def _lines(text: str, columns: int | None) -> list[str]:
    """Return text in lines that fit behind the indent; in one where there are no columns."""
    if columns is None:
        return [text]
    return textwrap.wrap(text, columns - len(INDENT), break_on_hyphens=False) or [""]


def _facts(entry: FileReport) -> Iterator[str]:
    if entry.facts is not None:
        channels = entry.facts["channels"]
        yield f"{entry.facts['sample_rate_hz'] / 1000:g} kHz"
        if (rate_kbps := entry.facts.get("bit_rate_kbps")) is not None:
            yield f"{entry.facts['encoding']} {rate_kbps:.0f} kbit/s"
        else:
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
    parts = [_count(sum(entry.count(level, waived=False) for entry in report.files), level) for level in SEVERITIES]
    if told := sum(entry.count("information", waived=False) for entry in report.files):
        parts.append(f"{told} to listen to")
    if counts["waived"]:
        parts.append(f"{counts['waived']} waived")
    total = ink(_count(counts["files"], "file"), BOLD)
    yield f"{total}: {', '.join(verdicts) or 'nothing to judge'}; {', '.join(parts)}"
    most = _most_found(report.files)
    if len([entry for entry in report.files if _counting(entry)]) >= MANY_FILES:
        yield ""
        yield from _table(most[:MOST_FOUND], ink)
        if len(most) > MOST_FOUND:
            yield ink(f"  and {_count(len(most) - MOST_FOUND, 'other kind')}", DIM)
        yield ""
    yield from _undecided(report.files, ink)
    yield from _next_steps(report.files, ink)
    if most:
        yield ink(f"why: audio-checks explain {most[0][0].partition(':')[0]}", DIM)


def _undecided(files: Iterable[FileReport], ink: Ink) -> Iterator[str]:
    """Yield the number of files whose reverb could not be judged."""
    verdicts = [entry.judgements["reverb"]["verdict"] for entry in files if "reverb" in entry.judgements]
    if undecided := verdicts.count(CANNOT_TELL):
        yield ink(f"reverb: cannot tell in {undecided} of {len(verdicts)}", DIM)


def _next_steps(files: Iterable[FileReport], ink: Ink) -> Iterator[str]:
    """Yield steps that would put several files right at once."""
    codes = [{finding.code for finding in _counting(entry)} for entry in files]
    pointers = sum(LFS_POINTER in code for code in codes)
    if pointers:
        yield ink(f"{_count(pointers, 'file')} of Git LFS not fetched: git lfs pull", YELLOW)
    if any(code.startswith(("naming:", "structure:")) for file_codes in codes for code in file_codes):
        from audio_checks.fixing.in_place import NAMES, SIZES

        fixable = sum(bool(of_file & (NAMES | SIZES) - {"naming:unlisted", "naming:listed"}) for of_file in codes)
        if fixable:
            these = _count(fixable, "file")
            yield ink(f"to put names and headers of {these} right: audio-checks check --diff, then --fix", DIM)


def _most_found(files: Iterable[FileReport]) -> list[tuple[str, Severity, int]]:
    """Return code, highest severity and number of files, of errors before warnings, the most common first."""
    within: Counter[str] = Counter()
    severities: dict[str, Severity] = {}
    for entry in files:
        codes: dict[str, Severity] = {
            finding.code: finding.severity or "warning" for finding in reversed(_counting(entry))
        }
        within.update(codes.keys())
        for code, severity in codes.items():
            severities[code] = min(severity, severities.get(code, severity), key=GRAVITY.__getitem__)
    rows = [(code, severities[code], count) for code, count in within.items()]
    return sorted(rows, key=lambda row: (GRAVITY[row[1]], -row[2], row[0]))


def _table(rows: list[tuple[str, Severity, int]], ink: Ink) -> Iterator[str]:
    digits = max((len(str(count)) for _, _, count in rows), default=0)
    for code, severity, count in rows:
        files = "file " if count == 1 else "files"
        label = ink(f"{SEVERITY_LABELS.get(severity, severity):<7}", SEVERITY_COLOURS[severity])
        yield f"  {label}  {count:>{digits}} {files}  {printable(code)}"


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def _figures(entry: FileReport, ink: Ink) -> Iterator[str]:
    yield "  ".join(part for part in (ink(printable(entry.path), BOLD), ink(", ".join(_facts(entry)), DIM)) if part)
    if entry.facts is None:
        yield from _failures(entry, ink) if entry.unjudged else [ink("  cannot be read", RED)]
        return
    figures = {"effective_bits": entry.facts["effective_bits"], **entry.to_measured()["measurements"]}
    named = {name: _words(name) for name in figures}
    often = Counter(words for words, _ in named.values())
    named = {name: (f"{words} in {unit}" if often[words] > 1 else words, unit) for name, (words, unit) in named.items()}
    columns = max(len(words) for words, _ in named.values()) + 2
    for name, value in figures.items():
        words, unit = named[name]
        shown = _value(value, unit)
        yield f"  {ink(f'{words:<{columns}}', DIM)}{shown}{f' {unit}' if unit and value is not None else ''}"
    for name, judged in entry.judgements.items():
        yield f"  {ink(f'{name}?'.ljust(columns), DIM)}{_judged(judged)}"
        if name == "reverb":
            yield from (f"    {ink(line, DIM)}" for line in drawn(judged.get("evidence") or {}))
    for name, stands in entry.loudness_presets.items():
        yield f"  {in_words(name, stands)}"
    yield from _failures(entry, ink)


def _failures(entry: FileReport, ink: Ink) -> Iterator[str]:
    """Yield the checks that the tool failed in, and why."""
    for failed in entry.unjudged:
        figures = f" ({', '.join(failed.figures)})" if failed.figures else ""
        yield f"  {ink('unjudged', MAGENTA)}  {printable(failed.check)}{figures}: {printable(failed.message)}"


def _judged(judged: Mapping[str, Any]) -> str:
    """Return a judgement in one line: verdict, score, and the figures that it gives."""
    parts = [judged["verdict"]]
    if judged["score"] is not None:
        parts.append(f"score {score_in_words(judged['score'])}")
    for name, value in judged.items():
        words, unit = _words(name)
        if unit and isinstance(value, float):
            parts.append(f"{words.removesuffix(' at')} {value:.2f} {unit}")
    return ", ".join(parts)


def _words(name: str) -> tuple[str, str]:
    """Return a figure's name in words, and its unit; every unit ends the name of its figure."""
    stem, _, ending = name.rpartition("_")
    unit = UNITS.get(ending, "")
    words = (stem if unit else name).replace("_", " ")
    if unit == "LUFS" and "loudness" not in words:
        words += " loudness"
    return (f"{words} at" if unit == "s" else words), unit


def _value(value: object, unit: str) -> str:
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{round(value, DECIMALS.get(unit, 2)) + 0.0:.{DECIMALS.get(unit, 2)}f}"  # no -0.00
    if isinstance(value, list | tuple):
        return ", ".join(map(str, value)) or "none"
    return printable(str(value))
