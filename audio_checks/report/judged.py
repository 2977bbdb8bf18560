"""One judged file among others: what checks over several files together are given."""

from __future__ import annotations

from dataclasses import dataclass

from audio_checks.report.findings import FileReport
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec


@dataclass(frozen=True)
class JudgedFile:
    """One judged file, with what is known of it.

    Attributes
    ----------
    report : FileReport
        The report on this file alone; its path identifies it.
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
        """Return its place, as the report has it."""
        return self.report.path

    @property
    def was_read(self) -> bool:
        """Whether the report says what the file is."""
        return self.report.facts is not None and "duration_s" in self.report.facts
