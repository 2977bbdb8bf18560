"""The report as one JSON document; see `audio-checks schema report`."""

from audio_checks.cli.reporters import Style
from audio_checks.report.findings import Report, dumps


def judged(report: Report, style: Style) -> str:
    """Return the document, indented."""
    return dumps(report.to_dict(), indent=2) + "\n"


def measured(report: Report, style: Style) -> str:
    """Return the document of figures: the same file entries, without verdict and findings."""
    whole = report.to_dict()
    head = {key: whole[key] for key in ("schema_version", "tool")}
    return dumps({**head, "files": [entry.to_measured() for entry in report.files]}, indent=2) + "\n"
