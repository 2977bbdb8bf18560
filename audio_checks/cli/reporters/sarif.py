"""SARIF 2.1.0 (OASIS), as code scanning services read it: one rule a code, one result a finding.

A result is known again by its `primaryLocationLineHash`, made from its code and from the sound, not
from the place: a renamed or moved file keeps its alert. Where a service has limits, the worst
findings are kept: GitHub takes 25,000 results a run and shows the first 5,000.
Source: SARIF 2.1.0; GitHub's "SARIF support for code scanning".
"""

import hashlib
from collections import Counter
from collections.abc import Iterable
from typing import Any

from audio_checks.cli.locations import repository_root, uri_of
from audio_checks.cli.reporters import Style
from audio_checks.report.findings import FileReport, Finding, Report, dumps, printable
from audio_checks.spec import check_names

MOST_RESULTS = 25_000
SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
ROOT = "%SRCROOT%"


def judged(report: Report, style: Style) -> str:
    """Return the document."""
    results = [
        (entry, finding)
        for entry in report.files
        for finding in entry.findings
        if not finding.code.endswith(":crashed")
    ]
    results.sort(key=lambda pair: (pair[1].waived, check_names.GRAVITY[pair[1].severity or "warning"]))
    rules = list(dict.fromkeys(finding.code for _, finding in results[:MOST_RESULTS]))
    notes = [*_crashes(report.files)]
    if len(results) > MOST_RESULTS:
        notes.append(_note("warning", f"{len(results) - MOST_RESULTS} milder findings are left out of this file"))
    run = {
        "tool": {
            "driver": {
                "name": "audio-checks",
                "version": report.tool_version,  # of a commit between two releases it is no semantic version
                "rules": [_rule(code) for code in rules],
            }
        },
        "invocations": [
            {
                "executionSuccessful": not any(entry.verdict == "unjudged" for entry in report.files),
                "toolExecutionNotifications": notes,
            }
        ],
        "originalUriBaseIds": {ROOT: {"description": {"text": "The root of the repository."}}},
        "columnKind": "unicodeCodePoints",
        "properties": {"specs": [{"name": spec.name, "sha256": spec.sha256} for spec in report.specs]},
        "results": _results(results[:MOST_RESULTS], {code: index for index, code in enumerate(rules)}),
    }
    return dumps({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}) + "\n"


def _results(pairs: Iterable[tuple[FileReport, Finding]], places: dict[str, int]) -> list[dict[str, Any]]:
    root, seen = repository_root(), Counter[str]()
    locations: dict[str, dict[str, Any]] = {}
    results = []
    for entry, finding in pairs:
        if entry.path not in locations:
            locations[entry.path] = _location(entry.path, root)
        mark = _mark(entry, finding)
        seen[mark] += 1
        results.append(
            {
                "ruleId": finding.code,
                "ruleIndex": places[finding.code],
                "level": "note" if finding.severity == "information" else finding.severity,
                "message": {"text": f"{printable(finding.sentence)}. Fix: {printable(finding.fix)}."},
                "locations": [{"physicalLocation": locations[entry.path]}],
                "partialFingerprints": {"primaryLocationLineHash": f"{mark}:{seen[mark]}"},
                "properties": _figures(finding),
                **({"suppressions": [{"kind": "external", "status": "accepted"}]} if finding.waived else {}),
            }
        )
    return results


def _location(path: str, root: Any) -> dict[str, Any]:
    uri, relative = uri_of(path, root)
    artifact = {"uri": uri, **({"uriBaseId": ROOT} if relative else {})}
    return {"artifactLocation": artifact, "region": {"startLine": 1}}  # a sound has no lines, but GitHub wants one


def _mark(entry: FileReport, finding: Finding) -> str:
    """Return the mark of a finding; of a file that cannot be read only the path is known."""
    whole = f"{finding.code}\0{entry.pcm_sha256 or entry.path}"
    return hashlib.sha256(whole.encode("utf-8", "surrogatepass")).hexdigest()[:16]


def _figures(finding: Finding) -> dict[str, Any]:
    shown = finding.to_dict()
    keys = ("measured", "limit", "unit", "start_s", "end_s")
    return {key: shown[key] for key in keys if shown[key] is not None}


def _rule(code: str) -> dict[str, Any]:
    from audio_checks.checks import all_checks

    name = code.partition(":")[0]
    check = all_checks().get(name)
    parts = check.parts if check else {"summary": code, "why": code, "how to fix": "see the finding", "source": ""}
    level = check_names.DEFAULT_SEVERITY.get(name, "error")
    markdown = f"**Why.** {parts['why']}\n\n**How to fix.** {parts['how to fix']}\n\n**Source.** {parts['source']}"
    return {
        "id": code,
        "name": "".join(word.capitalize() for word in code.replace(":", "-").split("-")),
        "shortDescription": {"text": _sentence(parts["summary"])},
        "fullDescription": {"text": _sentence(parts["why"])[:1000]},
        "help": {"text": f"{parts['why']} How to fix: {parts['how to fix']}", "markdown": markdown},
        "defaultConfiguration": {"level": level},
        "properties": {"precision": "very-high", "problem.severity": level, "tags": ["audio", name]},
    }


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:].rstrip(".") + "."


def _crashes(files: Iterable[FileReport]) -> Iterable[dict[str, Any]]:
    for entry in files:
        for finding in entry.findings:
            if finding.code.endswith(":crashed"):
                text = f"{printable(entry.path)}: unjudged by {finding.check}: {printable(finding.message)}"
                yield _note("error", text) | {"associatedRule": {"id": finding.code}}


def _note(level: str, text: str) -> dict[str, Any]:
    return {"level": level, "message": {"text": text}}
