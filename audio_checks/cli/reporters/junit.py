"""JUnit XML, as CI services read it: a file is a test case, and what makes it fail is its failure.

The report's severity is the type of a failure; a check that broke is an error, not a
failure; milder and waived findings are printed as the output of the case.
"""

from collections.abc import Iterator
from xml.sax.saxutils import escape, quoteattr

from audio_checks.cli.reporters import Style
from audio_checks.report.findings import FileReport, Finding, Report, printable


def judged(report: Report, style: Style) -> str:
    """Return the document."""
    cases = [_Case(entry, style) for entry in report.files]
    name = report.specs[0].name if len(report.specs) == 1 else ""
    counts = (
        f'tests="{len(cases)}" failures="{sum(case.failed for case in cases)}"'
        f' errors="{sum(case.broken for case in cases)}" skipped="0"'
    )
    return "\n".join(
        [
            '<?xml version="1.0" encoding="UTF-8"?>',
            f'<testsuites name="audio-checks" {counts}>',
            f"  <testsuite name={_quoted(name or 'audio-checks')} {counts}>",
            *(line for case in cases for line in case.lines()),
            "  </testsuite>",
            "</testsuites>\n",
        ]
    )


class _Case:
    """One file."""

    def __init__(self, entry: FileReport, style: Style) -> None:
        self._entry = entry
        self.broken = entry.verdict == "unjudged"
        self._graver = [
            finding for finding in entry.findings if not finding.waived and finding.severity in style.failing
        ]
        self._milder = [finding for finding in entry.findings if finding not in self._graver]
        self.failed = bool(self._graver) and not self.broken

    def lines(self) -> Iterator[str]:
        entry = self._entry
        kind = f"audio-checks.{entry.category}" if entry.category else "audio-checks"
        head = f"    <testcase name={_quoted(entry.path)} classname={_quoted(kind)} file={_quoted(entry.path)}"
        if not entry.findings:
            yield f"{head}/>"
            return
        yield f"{head}>"
        if self._graver:
            tag = "error" if self.broken else "failure"
            first = self._graver[0]
            more = f" (and {len(self._graver) - 1} more)" if len(self._graver) > 1 else ""
            yield f"      <{tag} type={_quoted(first.code)} message={_quoted(first.message + more)}>"
            yield from (escape(_line(line)) for line in self._graver)
            yield f"      </{tag}>"
        if self._milder:
            yield "      <system-out>"
            yield from (escape(_line(line)) for line in self._milder)
            yield "      </system-out>"
        yield "    </testcase>"


def _line(finding: Finding) -> str:
    level = "waived" if finding.waived else finding.severity
    return f"{level}: {printable(finding.sentence)}; fix: {printable(finding.fix)} [{printable(finding.code)}]"


def _quoted(text: str) -> str:
    return quoteattr(printable(text))
