"""An audit for people, and as a report of findings for the formats that CI services read."""

from __future__ import annotations

from dataclasses import replace

from audio_checks.audit.report import Audit, Entry
from audio_checks.audit.statuses import NO_DRIFT, STATUSES
from audio_checks.cli.terminal import BOLD, GREEN, RED, YELLOW, Ink
from audio_checks.middleware.values import Unread
from audio_checks.report.findings import FileReport, Finding, Report, printable
from audio_checks.system.plural import counted
from audio_checks.version import TOOL_VERSION

FIXES = {
    "gain": "put the approved file in its place, or have the new level approved",
    "trimmed": "put the approved file in its place, or have the cut approved",
    "resampled": "let the sounds be rendered to this rate and approved, or allow it: --allow resampled",
    "re-encoded": "put the approved file in its place, or allow it where the engine does it: --allow re-encoded",
    "changed": "put the approved file in its place, or have this one approved",
    "missing": "add the approved file, or take it off the manifest",
    "unknown": "have it approved, or take it out of the build",
    "placeholder": "put the real sound in its place",
    "duplicate": "let the game play one file for both, or take this one out",
    "converted": "turn the import setting off, or allow it where the engine needs it: --allow converted",
    "unapproved": "have it approved, or let the game play an approved sound",
    "unused": "let an event play it, or allow it while the game is not ready: --allow unused",
    "unread": "save the file again from its editor, as text; or leave it out: --allow unread",
}
LEVEL_FIX = "set the property back, or accept the level with its reason: --baseline, --add-baseline --reason"
COLOURS = {"same": GREEN, "resampled": YELLOW, "re-encoded": YELLOW, "duplicate": YELLOW}


def in_words(audit: Audit, *, allowed: tuple[str, ...] = (), colour: bool = False) -> str:
    """Return the differences, a line each, and the file counts by status."""
    ink = Ink(colour)
    lines = [
        f"{ink(printable(entry.path), BOLD)}  {ink(entry.status, COLOURS.get(entry.status, RED))}"
        f"{_figures(entry)}: {printable(entry.message)}{_also(entry)}"
        for entry in audit.drifted(allowed)
    ]
    if audit.project is not None and "unread" not in allowed:
        lines += [
            f"{ink(printable(_place(unread)), BOLD)}  {ink('unread', RED)}: {printable(unread.message)}"
            for unread in audit.project.unread
        ]
    counts = audit.summary
    by_status = ", ".join(f"{counts[status]} {status}" for status in STATUSES if counts[status])
    sounds = counted(counts["files"], "sound")
    accepted = sum(bool(entry.accepted) for entry in audit.entries)
    notes = [*([f"{', '.join(allowed)} allowed"] if allowed else []), *([f"{accepted} accepted"] if accepted else [])]
    allowed_note = f" ({'; '.join(notes)})" if notes else ""
    return "\n".join([*lines, f"{sounds}: {by_status or 'nothing to compare'}{allowed_note}"]) + "\n"


def as_findings(audit: Audit, allowed: tuple[str, ...] = ()) -> Report:
    """Return the audit as a report: each file that differs is rejected, by a finding such as `audit:gain`."""
    drifted = {id(entry) for entry in audit.drifted(allowed)}
    files = tuple(
        FileReport(entry.path, "rejected" if id(entry) in drifted else "conforming", findings=_findings(entry, drifted))
        for entry in audit.entries
    )
    if audit.project is not None and "unread" not in allowed:
        files += tuple(
            FileReport(
                _place(unread),
                "rejected",
                findings=(Finding("audit:unread", unread.message, FIXES["unread"], severity="error"),),
            )
            for unread in audit.project.unread
        )
    return Report(files=files, specs=(), not_run=(), tool_version=TOOL_VERSION)


def _findings(entry: Entry, drifted: set[int]) -> tuple[Finding, ...]:
    if id(entry) not in drifted and not entry.accepted:
        return ()
    status = entry.status if entry.status not in NO_DRIFT else entry.played_status
    fix = LEVEL_FIX if status == "gain" and entry.played_status == "gain" else FIXES[status]
    message = f"{entry.message}; accepted: {entry.accepted}" if entry.accepted else entry.message
    finding = Finding(f"audit:{status}", message, fix, severity="error", waived=bool(entry.accepted))
    louder = status == "gain"
    return (replace(finding, measured=entry.gain_db, limit=0.0, unit="dB") if louder else finding,)


def _place(unread: Unread) -> str:
    return f"{unread.file}:{unread.line}" if unread.line else unread.file


def _figures(entry: Entry) -> str:
    if entry.gain_db is None or entry.offset_s is None:
        return ""
    moved = f", {entry.offset_s:+.3f} s" if abs(entry.offset_s) >= 0.001 else ""
    return f" ({round(entry.gain_db, 1) + 0.0:+.1f} dB{moved})"


def _also(entry: Entry) -> str:
    others = [match.path for match in entry.matches if match.path != entry.approved]
    if not others or entry.status == "changed":
        return ""
    more = f" and {len(others) - 3} more" if len(others) > 3 else ""
    return printable(f"; also like {', '.join(others[:3])}{more}")
