"""The findings in a file's name alone, before there is a file."""

from __future__ import annotations

from dataclasses import replace

from audio_checks.checks import all_checks
from audio_checks.report.findings import Finding
from audio_checks.run.severity import graded, ordered
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec
from audio_checks.spec.sound_names import parse_file_name, stem_of_file, stems_of

NAMING_RULES = frozenset({"naming:pattern", "naming:tokens", "naming:ucs"})


def check_name(name: str, spec: DeliverySpec, cue: CueFacts | None = None) -> tuple[Finding, ...]:
    """Return `naming`'s findings in a name, each with its severity, as the report on a file of this name has it.

    Parameters
    ----------
    name : str
        A file name without folders.
    spec : DeliverySpec
        The view that the file is judged by.
    cue : CueFacts, optional
        The cue that the file is for.
    """
    naming = all_checks()["naming"]
    if spec.checks.get("naming") == "off" or not naming.applies(spec, None):
        return ()
    findings = (graded(finding, spec) for finding in naming.module.of_name(name, spec))
    return ordered(as_listed([finding for finding in findings if finding is not None], name, cue))


def as_listed(findings: list[Finding], name: str, cue: CueFacts | None) -> list[Finding]:
    """Return findings in which a name that the sound list gives is the list's contradiction, and no fault of the file.

    Whoever delivers a file under the name that its cue has cannot do better, and is not told to rename it.
    """
    if cue is None:
        return findings
    stems = stems_of(cue.name, cue.file_name, cue.variations)
    if stem_of_file(name) not in stems and parse_file_name(name).stem not in stems:
        return findings
    return [_of_the_list(finding) if finding.code in NAMING_RULES else finding for finding in findings]


def _of_the_list(finding: Finding) -> Finding:
    return replace(
        finding,
        code="naming:listed",
        message=f"{finding.message}; the sound list calls the file so, and contradicts the spec",
        fix="keep the name; change the list or the naming rule of the spec, so that the two agree",
        severity="warning",
    )
