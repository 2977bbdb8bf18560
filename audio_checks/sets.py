"""Checks over a set of files: what no file can be blamed for alone.

A check module that has `check_set(files)` is called once over all judged files, and yields findings
with the place of the file that each is for. Severity and verdict follow as for any other finding.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from audio_checks.checks import all_checks, variation_set
from audio_checks.findings import FileReport, Finding
from audio_checks.severity import crash, graded, ordered
from audio_checks.spec import CueFacts, DeliverySpec


@dataclass(frozen=True)
class Judged:
    """One judged file, with what is known of it.

    Attributes
    ----------
    report : FileReport
        What was said of it alone; its path tells files apart.
    spec : DeliverySpec
        The view it was judged by.
    cue : CueFacts or None
        The cue it is for.
    variation : int
        Which of the cue's variations; 1 for a single file.
    is_alternate : bool
        Whether it is another take for a place that one has already.
    """

    report: FileReport
    spec: DeliverySpec
    cue: CueFacts | None = None
    variation: int = 1
    is_alternate: bool = False

    @property
    def path(self) -> str:
        """Where it is, as the report has it."""
        return self.report.path

    @property
    def was_read(self) -> bool:
        """Whether the report says what the file is."""
        return self.report.facts is not None and "duration_s" in self.report.facts


def set_findings(files: Sequence[Judged]) -> list[tuple[Finding, ...]]:
    """Return what is found over files together, for each of them, graded by its own spec.

    Parameters
    ----------
    files : sequence of Judged
        Of one delivery, one folder, or one cue. Files that cannot be read take no part.

    Returns
    -------
    list of tuple of Finding
        In the order of the files; empty for a file that nothing was found in.
    """
    found: list[list[Finding]] = [[] for _ in files]
    for check in [one for one in all_checks().values() if one.is_over_sets]:
        places = [place for place, one in enumerate(files) if one.was_read and one.spec.checks.get(check.name) != "off"]
        try:
            for place, finding in list(check.run_set([files[place] for place in places])):
                found[places[place]].append(finding)
        except Exception as error:  # a check's bug is the tool's, never held against a file
            for place in places:
                found[place].append(crash(check.name, error))
    return [tuple(_graded(findings, one.spec)) for findings, one in zip(found, files, strict=True)]


def off_its_set_lu(files: Sequence[Judged]) -> list[float | None]:
    """Return how much louder each file of one cue is than its other variations, in LU; None where it is not known."""
    readable = [one for one in files if one.was_read]
    off = iter(variation_set.off_its_set_lu(readable))
    return [next(off) if one.was_read else None for one in files]


def _graded(findings: Sequence[Finding], spec: DeliverySpec) -> Iterator[Finding]:
    for finding in findings:
        one = finding if finding.code.endswith(":crashed") else graded(finding, spec)
        if one is not None:
            yield one


def with_set_findings(files: Sequence[Judged]) -> list[FileReport]:
    """Return the reports of files with what is found over them together, their verdicts following."""
    reports = []
    for one, findings in zip(files, set_findings(files), strict=True):
        report = one.report
        if findings:
            verdict = report.verdict
            if any(finding.code.endswith(":crashed") for finding in findings):
                verdict = "unjudged"
            elif verdict == "conforming" and any(finding.severity == "error" for finding in findings):
                verdict = "rejected"
            report = replace(report, verdict=verdict, findings=ordered([*report.findings, *findings]))
        reports.append(report)
    return reports
