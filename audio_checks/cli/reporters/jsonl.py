"""One JSON object a line, one line a file."""

from audio_checks.cli.reporters import Style
from audio_checks.report.findings import Report, dumps


def judged(report: Report, style: Style) -> str:
    """Return the lines."""
    return "".join(dumps(entry.to_dict()) + "\n" for entry in report.files)


def measured(report: Report, style: Style) -> str:
    """Return the lines of figures, without verdict and findings."""
    return "".join(dumps(entry.to_measured()) + "\n" for entry in report.files)
