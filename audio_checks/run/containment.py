"""Runs checks and judgements so that a failure loses only its own answer, and is named."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from audio_checks import judge as judgements
from audio_checks.audio.audio_file import AudioFile
from audio_checks.checks import Check, all_checks
from audio_checks.errors import Unreadable
from audio_checks.judge import Judgement
from audio_checks.report.findings import Finding, Unjudged
from audio_checks.run.severity import crash, in_words
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec


def run_checks(
    checks: Iterable[Check], file: AudioFile, spec: DeliverySpec, cue: CueFacts | None
) -> tuple[list[Finding], list[Finding]]:
    """Return the findings, and the checks that broke; one whose figure could not be measured is among them."""
    findings: list[Finding] = []
    crashed: list[Finding] = []
    errors = file.errors
    for check in checks:
        error = next((errors[figure] for figure in check.figures if figure in errors), None)
        try:
            if error is not None:
                raise error
            findings += list(check.run(file, spec, cue))
        except Unreadable:
            raise
        except Exception as error:  # a check's bug is the tool's, and the other checks still count
            crashed.append(crash(check.name, error))
    return findings, crashed


def make_judgements(
    names: Iterable[str], file: AudioFile, kind: str | None
) -> tuple[dict[str, Judgement], dict[str, Exception]]:
    """Return the judgements by name, and why some could not be made."""
    judged: dict[str, Judgement] = {}
    failed: dict[str, Exception] = {}
    for name in names:
        try:
            judged[name] = judgements.judge(name, file, kind)
        except Unreadable:
            raise
        except Exception as error:  # as with a check, the others still count
            failed[name] = error
    return judged, failed


def failed_checks(file: AudioFile, failed: Mapping[str, Exception]) -> tuple[Unjudged, ...]:
    """Return the checks that figures or judgements are missing for, whether the spec asks them or not."""
    errors = file.errors
    if not (errors or failed):
        return ()  # as usual, and no unneeded judgement is imported
    entries = []
    for check in all_checks().values():
        read = [*check.figures, *(judgements.figures_of(check.judgement) if check.judgement else ())]
        figures = tuple(fromkey for fromkey in dict.fromkeys(read) if fromkey in errors)
        error = errors[figures[0]] if figures else failed.get(check.judgement or "")
        if error is not None:
            entries.append(Unjudged(check.name, figures, in_words(error)))
    return tuple(entries)
