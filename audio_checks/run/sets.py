"""Checks over a set of files: what no file can be blamed for alone.

A check module that has `check_set(files)` is called once over all judged files, and yields findings
with the place of the file that each is for. Severity and verdict follow as for any other finding.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from audio_checks.checks import all_checks, variation_set
from audio_checks.report.findings import FileReport, Finding
from audio_checks.report.judged import JudgedFile
from audio_checks.run.severity import crash, graded, ordered
from audio_checks.spec.delivery_spec import DeliverySpec


def set_findings(files: Sequence[JudgedFile]) -> list[tuple[Finding, ...]]:
    """Return the findings over files together, for each of them, with the severities of its own spec.

    Parameters
    ----------
    files : sequence of JudgedFile
        Of one delivery, one folder, or one cue. Files that cannot be read are left out.

    Returns
    -------
    list of tuple of Finding
        In the order of the files; empty for a file that nothing was found in.
    """
    findings_by_file: list[list[Finding]] = [[] for _ in files]
    for check in [candidate for candidate in all_checks().values() if candidate.is_over_sets]:
        places = [
            file_index
            for file_index, file in enumerate(files)
            if file.was_read and file.spec.checks.get(check.name) != "off"
        ]
        try:
            for index, finding in list(check.run_set([files[file_index] for file_index in places])):
                findings_by_file[places[index]].append(finding)
        except Exception as error:  # a check's bug is the tool's, never held against a file
            for index in places:
                findings_by_file[index].append(crash(check.name, error))
    return [tuple(_graded(findings, file.spec)) for findings, file in zip(findings_by_file, files, strict=True)]


def offset_from_set_lu(files: Sequence[JudgedFile]) -> list[float | None]:
    """Return the excess loudness of each file of one cue over its other variations, in LU; None where not known."""
    readable = [file for file in files if file.was_read]
    off = iter(variation_set.offset_from_set_lu(readable))
    return [next(off) if file.was_read else None for file in files]


def _graded(findings: Sequence[Finding], spec: DeliverySpec) -> Iterator[Finding]:
    for finding in findings:
        graded_finding = finding if finding.code.endswith(":crashed") else graded(finding, spec)
        if graded_finding is not None:
            yield graded_finding


def with_set_findings(files: Sequence[JudgedFile]) -> list[FileReport]:
    """Return the reports of files with what is found over them together, their verdicts following."""
    reports = []
    for file, findings in zip(files, set_findings(files), strict=True):
        report = file.report
        if findings:
            verdict = report.verdict
            if any(finding.code.endswith(":crashed") for finding in findings):
                verdict = "unjudged"
            elif verdict == "conforming" and any(finding.severity == "error" for finding in findings):
                verdict = "rejected"
            report = replace(report, verdict=verdict, findings=ordered([*report.findings, *findings]))
        reports.append(report)
    return reports
