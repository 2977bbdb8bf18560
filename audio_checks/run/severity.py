"""The gravity of a finding: the spec's word first, then the check's, then the default."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from audio_checks.report.findings import Finding
from audio_checks.spec import check_names
from audio_checks.spec.check_names import Severity
from audio_checks.spec.delivery_spec import DeliverySpec


def graded(finding: Finding, spec: DeliverySpec) -> Finding | None:
    """Return the finding with its severity; None where the spec turns its check off."""
    level = spec.checks.get(finding.check)
    if level == "off":
        return None
    if finding.severity == "information":  # it asks for an ear, and never returns a file
        return finding
    severity: Severity = level or finding.severity or check_names.DEFAULT_SEVERITY[finding.check]
    return replace(finding, severity=severity)


def ordered(findings: Iterable[Finding]) -> tuple[Finding, ...]:
    """Return findings, what broke first, then errors, then warnings, then information."""

    def sort_key(finding: Finding) -> tuple[bool, int]:
        return not finding.code.endswith(":crashed"), check_names.GRAVITY[finding.severity or "warning"]

    return tuple(sorted(findings, key=sort_key))


def crash(what: str, error: BaseException) -> Finding:
    """Return the finding that a check itself broke."""
    return Finding(
        code=f"{what}:crashed",
        message=f"the check itself broke ({in_words(error)}); nothing is known to be wrong with the file",
        fix="report it to the maintainers of audio-checks, with the file",
        severity="error",
    )


def in_words(error: BaseException) -> str:
    """Return the type of an error, and what it says."""
    return f"{type(error).__name__}: {error}"
