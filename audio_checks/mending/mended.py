"""What came of a mend: what was put right, what is left, and what the spec says of master and copy."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from audio_checks.findings import FileReport, Finding
from audio_checks.mending.offers import RepairKind

MENDER_VERSION = "1"  # changes when the same master and spec give another copy


@dataclass(frozen=True)
class Repair:
    """One thing that was put right.

    Attributes
    ----------
    kind : str
        "gain", "head", "tail", "name", "header" or "depth".
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
    """A finding of the mended copy that no mend answers: its code, and why and what to do, in a sentence."""

    finding: Finding
    why: str


@dataclass(frozen=True)
class Mended:
    """What came of a mend.

    Attributes
    ----------
    path : Path or None
        The copy; None when nothing could be mended, and nothing was written.
    name : str
        The copy's name; the master's where that is lawful or cannot be put right.
    repairs : tuple of Repair
        What was done, in the order of the sound's way: header, trims, level, depth, name.
    left : tuple of Left
        What is still found in the copy, or in the master when there is no copy.
    before, after : FileReport or None
        What the spec says of master and copy, with every figure; `after` is None without a copy.
    gain_db : float
        By how much the level was moved: one factor for the whole sound.
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
    mender_version: str = MENDER_VERSION

    @property
    def conforms(self) -> bool:
        """Whether the copy, or a master that needed no mend, has no finding of severity error."""
        return (self.after or self.before).verdict == "conforming"

    def to_dict(self) -> dict[str, Any]:
        """Return everything but the path as plain values; −inf is None, as in the report."""
        return {
            "name": self.name,
            "repairs": [
                {
                    "kind": one.kind,
                    "codes": list(one.codes),
                    "words": one.words,
                    "start_s": one.start_s,
                    "end_s": one.end_s,
                }
                for one in self.repairs
            ],
            "left": [{**one.finding.to_dict(), "why": one.why} for one in self.left],
            "conforms": self.conforms,
            "gain_db": self.gain_db,
            "cut_frames": list(self.cut_frames),
            "fade_frames": list(self.fade_frames),
            "before": self.before.to_dict(),
            "after": self.after and self.after.to_dict(),
            "mender_version": self.mender_version,
        }
