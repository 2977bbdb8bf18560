"""The result of fixing one master: what was fixed, what is left, and the reports on master and copy."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from audio_checks.fixing.offers import RepairKind
from audio_checks.report.findings import FileReport, Finding

FIXER_VERSION = "3"  # changes when the same master and spec give another copy


@dataclass(frozen=True)
class Repair:
    """One thing that was fixed.

    Attributes
    ----------
    kind : str
        "gain", "head", "tail", "name", "header", "depth" or "offset".
    codes : tuple of str
        The findings it answers.
    words : str
        What was done, as in "level lowered by 1.70 dB".
    start_s, end_s : float or None
        Where in the master: what was cut away, or the spot for which the level was moved.
    """

    kind: RepairKind
    codes: tuple[str, ...]
    words: str
    start_s: float | None = None
    end_s: float | None = None


@dataclass(frozen=True)
class Left:
    """A finding that remains in the fixed copy, and why and what to do, in a sentence."""

    finding: Finding
    why: str


@dataclass(frozen=True)
class FixedMaster:
    """The result of fixing one master.

    Attributes
    ----------
    path : Path or None
        The copy; None when nothing could be fixed, and nothing was written.
    name : str
        The copy's name; the master's where that is valid or cannot be fixed.
    repairs : tuple of Repair
        What was done, in processing order: header, trims, offset, level, depth, name.
    left : tuple of Left
        What is still found in the copy, or in the master when there is no copy.
    before, after : FileReport or None
        What the spec says of master and copy, with every figure; `after` is None without a copy.
    gain_db : float
        Change of level, in dB: one factor for the whole sound.
    cut_frames : (int, int)
        Frames taken from start and end.
    fade_frames : (int, int)
        Frames faded where a cut would click, within the silence that stays.
    """

    path: Path | None
    name: str
    repairs: tuple[Repair, ...]
    left: tuple[Left, ...]
    before: FileReport
    after: FileReport | None
    gain_db: float = 0.0
    cut_frames: tuple[int, int] = (0, 0)
    fade_frames: tuple[int, int] = (0, 0)
    fixer_version: str = FIXER_VERSION

    @property
    def conforms(self) -> bool:
        """Whether the copy, or a master that needed no fix, has no finding of severity error."""
        return (self.after or self.before).verdict == "conforming"

    def to_dict(self) -> dict[str, Any]:
        """Return everything but the path as plain values; −inf is None, as in the report."""
        return {
            "name": self.name,
            "repairs": [
                {
                    "kind": repair.kind,
                    "codes": list(repair.codes),
                    "words": repair.words,
                    "start_s": repair.start_s,
                    "end_s": repair.end_s,
                }
                for repair in self.repairs
            ],
            "left": [{**unfixed.finding.to_dict(), "why": unfixed.why} for unfixed in self.left],
            "conforms": self.conforms,
            "gain_db": self.gain_db,
            "cut_frames": list(self.cut_frames),
            "fade_frames": list(self.fade_frames),
            "before": self.before.to_dict(),
            "after": self.after and self.after.to_dict(),
            "fixer_version": self.fixer_version,
        }
