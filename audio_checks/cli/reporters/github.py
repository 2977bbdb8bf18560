"""Annotations of GitHub Actions: one a file, its worst finding first, and a table in the job's summary.

GitHub shows ten errors and ten warnings of a step, so no more are written; a notice counts the rest.
Where GITHUB_STEP_SUMMARY names a file, the whole is appended to it as a table.
Source: GitHub's "Workflow commands for GitHub Actions".
"""

import os
from collections.abc import Iterator
from pathlib import Path

from audio_checks.cli.locations import in_repository, repository_root
from audio_checks.cli.reporters import Style
from audio_checks.report.findings import FileReport, Finding, Report, printable
from audio_checks.spec.check_names import GRAVITY, Severity

SHARES_OUTPUT = True  # the runner picks its commands out of any other output
MOST_OF_A_LEVEL = 10
SUMMARY_BYTES = 900_000  # of the 1 MiB that a step may write
MOST_IN_A_CELL = 5
MARKUP = str.maketrans(
    {"&": "&amp;", "<": "&lt;", "|": "&#124;", **{character: f"\\{character}" for character in "\\`*_[]#@"}}
)
LEVELS: dict[Severity, str] = {"error": "error", "warning": "warning", "information": "notice"}


def judged(report: Report, style: Style) -> str:
    """Return the commands; append the summary of the job where GitHub asks for one."""
    if summary_path := os.environ.get("GITHUB_STEP_SUMMARY"):
        with Path(summary_path).open("a", encoding="utf-8", errors="backslashreplace", newline="\n") as summary:
            summary.write(_summary(report))
    return "".join(f"{line}\n" for line in _commands(report))


def _counting(entry: FileReport) -> list[Finding]:
    """Return the unwaived findings, the most severe first."""
    return sorted(
        (finding for finding in entry.findings if not finding.waived),
        key=lambda finding: GRAVITY[finding.severity or "warning"],
    )


def _commands(report: Report) -> Iterator[str]:
    root = repository_root()
    counted_files = [(entry, _counting(entry)) for entry in report.files]
    left = 0
    for severity, command in LEVELS.items():
        files = [(entry, ones) for entry, ones in counted_files if ones and ones[0].severity == severity]
        left += max(0, len(files) - MOST_OF_A_LEVEL)
        for entry, ones in files[:MOST_OF_A_LEVEL]:
            shown_path = in_repository(entry.path, root) or entry.path
            more = f" ({len(ones) - 1} more in the summary)" if len(ones) > 1 else ""
            text = f"{printable(ones[0].sentence)}; fix: {printable(ones[0].fix)}{more}"
            title = f"{printable(ones[0].code)} in {Path(shown_path).name}"
            yield f"::{command} file={_property(shown_path)},title={_property(title)}::{_data(text)}"
    if left:
        yield f"::notice title=audio-checks::{left} more file{'s' if left > 1 else ''} in the summary"


def _property(text: str) -> str:
    return _data(printable(text)).replace(":", "%3A").replace(",", "%2C")


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _summary(report: Report) -> str:
    counts = report.summary
    verdicts = ", ".join(
        f"{counts[verdict]} {verdict}"
        for verdict in ("conforming", "rejected", "unreadable", "unjudged")
        if counts[verdict]
    )
    waived = f", {counts['waived']} waived" if counts["waived"] else ""
    total = f"{counts['files']} file{'' if counts['files'] == 1 else 's'}: {verdicts or 'nothing to judge'}"
    head = f"## audio-checks\n\n{total}; {counts['errors']} errors, {counts['warnings']} warnings{waived}\n\n"
    rows = sorted(
        ((entry, ones) for entry in report.files if (ones := _counting(entry))),
        key=lambda row: (GRAVITY[row[1][0].severity or "warning"], -len(row[1])),
    )
    if not rows:
        return head
    lines = ["| file | verdict | found | how to fix |", "|---|---|---|---|"]
    size = len(head) + 200
    for index, (entry, ones) in enumerate(rows):
        line = _row(entry, ones)
        size += len(line.encode("utf-8", "replace")) + 1
        if size > SUMMARY_BYTES:
            lines.append(f"\n{len(rows) - index} more files are left out here; `--format json:FILE` has them all.")
            break
        lines.append(line)
    return head + "\n".join(lines) + "\n\n"


def _row(entry: FileReport, ones: list[Finding]) -> str:
    sentences = [
        f"{finding.severity}: {_cell(finding.sentence)} `{printable(finding.code)}`"
        for finding in ones[:MOST_IN_A_CELL]
    ]
    fixes = [_cell(finding.fix) for finding in ones[:MOST_IN_A_CELL]]
    if len(ones) > MOST_IN_A_CELL:
        sentences.append(f"and {len(ones) - MOST_IN_A_CELL} more")
    return f"| {_cell(entry.path)} | {entry.verdict} | {'<br>'.join(sentences)} | {'<br>'.join(dict.fromkeys(fixes))} |"


def _cell(text: str) -> str:
    """Return text that can break out of no table and starts no markup."""
    return printable(text).translate(MARKUP)
