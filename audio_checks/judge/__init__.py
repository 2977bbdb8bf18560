"""The judgements: one module each, found by being here.

A judgement answers a question that no figure settles alone: a verdict, how sure it is, and the evidence
for people to look at. It rejects nothing; a check of the same subject makes a finding of it where the
spec asks. A module has

- a docstring: one line `name`: the question; then what it goes by and where it fails;
- `FIGURES`: the measurements it reads, so that they are made while the file streams by;
- `judge(file, kind)`, which returns a `Judgement`; `kind` is what the category's sounds are (event,
  natural-decay, ambience, voice, music), None if unknown.

The module's name is the judgement's; a package beside the modules is not a judgement. What a judgement has
learned is stored next to it as numbers in a file.
"""

from __future__ import annotations

import math
import pkgutil
from dataclasses import dataclass, field
from functools import cache
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

CANNOT_TELL = "cannot tell"


@dataclass(frozen=True)
class Judgement:
    """The judgement of one sound.

    Parameters
    ----------
    verdict : str
        The positive word (as in "reverb"), the negative one ("dry"), or "cannot tell".
    score : float or None
        0..1, higher means more certainly the positive verdict; None where there is nothing to judge. See
        `truncated_score`.
    figures : dict
        What was estimated on the way, by name with unit, as in `rt60_s`; None where it is unknown.
    evidence : dict
        Plain lists and numbers that a picture is drawn from.
    """

    verdict: str
    score: float | None
    figures: dict[str, Any] = field(default_factory=dict)
    evidence: dict[str, Any] = field(default_factory=dict)

    def to_dict(self) -> dict[str, Any]:
        """Return the judgement as the report has it."""
        document = {"verdict": self.verdict, "score": self.score, **self.figures}
        return {**document, "evidence": self.evidence} if self.evidence else document


def truncated_score(score: float) -> float:
    """Return a score, 0..1, in three decimals, cut off and not rounded: 1 is only what is 1."""
    return math.floor(score * 1000) / 1000


def score_in_words(score: float | None) -> str:
    """Return a kept score as every finding and page says it: two decimals, cut off; 0.00 where there is none."""
    return f"{round((score or 0.0) * 1000) // 10 / 100:.2f}"


@cache
def names() -> tuple[str, ...]:
    """Return the names of the judgements in this version; none of them is imported for that."""
    return tuple(sorted(module.name for module in pkgutil.iter_modules(__path__) if not module.ispkg))


def figures_of(name: str) -> tuple[str, ...]:
    """Return the measurements that a judgement reads."""
    figures: tuple[str, ...] = _module(name).FIGURES
    return figures


def judge(name: str, file: AudioFile, kind: str | None = None) -> Judgement:
    """Return a judgement of a file, made once for each kind of sound; see the module of that name."""

    def compute() -> Judgement:
        judgement: Judgement = _module(name).judge(file, kind)
        return judgement

    return file.cached(("judgement", name, kind), compute)


@cache
def _module(name: str) -> ModuleType:
    return import_module(f"{__name__}.{name}")
