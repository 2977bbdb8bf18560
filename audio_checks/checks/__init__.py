"""The checks: one module each, found by being here.

A check module has a docstring (one line `name`: what holds; then Why, How to fix, Source), from
which its page is made, and

- `SEVERITY`: "error" or "warning" by default; `OVER_FILES = True` where it judges files together;
- `LABEL`: what forms and lists call it, in one to three words;
- `LIMITS`, where the spec limits what it measures: keys of the table `limits`, each with the least and
  greatest value and, where it is not the check's, its label. The unit ends the key. A limit that is
  no field of `Limits` is read from `spec.limits.others`;
- `IN_CATEGORIES = True`, where the form of a category offers its severity;
- `NOT_FIXED`, where no fix is offered for what it finds: one sentence that says why;
- `FIGURES`: the measurements it reads, so that they are made while the file streams by;
- `JUDGEMENT`, where it makes a finding of a judgement: the name of that, see `audio_checks.judge`;
- `applies(spec, cue)`, where some limit must be stated for the check to be called;
- `check(file, spec)` or `check(file, spec, cue)`, which yields findings in one file;
- `check_set(files)`, where something holds over files together: it is called once with all judged
  files (see `sets`), and yields findings with the place of the file that each is for.

The module's name, with `-` for `_`, is the check's name.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

from audio_checks.report.findings import Finding
from audio_checks.spec import check_names
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec
from audio_checks.spec.parts import NO_LIMITS, Range

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile
    from audio_checks.report.judged import JudgedFile

UNITS = {  # by the word that ends a key
    "dbfs": "dBFS", "dbtp": "dBTP", "lufs": "LUFS", "lu": "LU", "db": "dB", "ms": "ms", "s": "s", "hz": "Hz",
    "percent": "%", "kbps": "kbit/s", "bytes": "bytes",
}  # fmt: skip


@dataclass(frozen=True)
class CheckLimit:
    """One limit that a check holds files to, as a form shows it.

    Attributes
    ----------
    key, label, unit : str
        Its key in the table `limits` of a spec, what it is called, and its unit, which ends the key.
    least, greatest : float
        What a spec may state.
    is_range : bool
        Whether a spec states `min` and `max`.
    usual : float or None
        What holds where the spec says nothing; None for no limit.
    """

    key: str
    label: str
    unit: str
    least: float
    greatest: float
    is_range: bool
    usual: float | None


@dataclass(frozen=True)
class Check:
    """One check, as found."""

    name: str
    module: ModuleType

    @cached_property
    def figures(self) -> tuple[str, ...]:
        """The measurements it reads."""
        figures: tuple[str, ...] = self.module.FIGURES
        return figures

    @cached_property
    def judgement(self) -> str | None:
        """The judgement it makes a finding of; None for a check of facts."""
        name: str | None = getattr(self.module, "JUDGEMENT", None)
        return name

    @property
    def label(self) -> str:
        """Return its name in forms and lists."""
        label: str = getattr(self.module, "LABEL", self.name.replace("-", " ").capitalize())
        return label

    @property
    def severity(self) -> check_names.Severity:
        """Its severity where the spec says nothing."""
        return check_names.DEFAULT_SEVERITY[self.name]

    @property
    def may_return(self) -> bool:
        """Whether a spec may make it an error: not where what it finds depends on what else was delivered."""
        return self.name not in check_names.OVER_FILES

    @property
    def is_in_categories(self) -> bool:
        """Whether the form of a category offers its severity."""
        return bool(getattr(self.module, "IN_CATEGORIES", False))

    @property
    def limits(self) -> tuple[CheckLimit, ...]:
        """The limits that it holds files to."""
        stated: dict[str, tuple[Any, ...]] = getattr(self.module, "LIMITS", {})
        return tuple(_limit(key, self.label, *facts) for key, facts in stated.items())

    @property
    def not_fixed(self) -> str | None:
        """Return its reason for offering no fix; None where it does not say."""
        why: str | None = getattr(self.module, "NOT_FIXED", None)
        return why

    @property
    def summary(self) -> str:
        """Return the meaning of no findings, in one line."""
        return self.parts["summary"]

    @property
    def why(self) -> str:
        """Return its purpose."""
        return self.parts["why"]

    @property
    def how_to_fix(self) -> str:
        """Return the remedy for its findings."""
        return self.parts["how to fix"]

    @property
    def parts(self) -> dict[str, str]:
        """The parts of its docstring: summary, why, how to fix, source."""
        return parts_of(self.module.__doc__ or "")

    def applies(self, spec: DeliverySpec, cue: CueFacts | None) -> bool:
        """Return whether the spec, or the cue, states anything that it could hold a file to."""
        ask = getattr(self.module, "applies", None)
        return ask is None or bool(ask(spec, cue))

    def run(self, file: "AudioFile", spec: DeliverySpec, cue: CueFacts | None) -> Iterator[Finding]:
        """Yield its findings in one file."""
        if not hasattr(self.module, "check"):
            return iter(())
        wants_cue = self.module.check.__code__.co_argcount == 3
        findings: Iterator[Finding] = self.module.check(file, spec, *([cue] if wants_cue else []))
        return findings

    @property
    def is_over_sets(self) -> bool:
        """Whether it finds anything over files together."""
        return hasattr(self.module, "check_set")

    def run_set(self, files: Sequence["JudgedFile"]) -> Iterator[tuple[int, Finding]]:
        """Yield its findings over files together, each with the place of its file."""
        findings: Iterator[tuple[int, Finding]] = self.module.check_set(files)
        return findings


@cache
def all_checks() -> dict[str, Check]:
    """Return every check of this version by name, in the order of the format."""
    here = check_names.present()
    return {name: _load(name) for name in check_names.DEFAULT_SEVERITY if name in here}


def _load(name: str) -> Check:
    return Check(name, import_module(f"{__name__}.{name.replace('-', '_')}"))


def _limit(key: str, of_check: str, least: float, greatest: float, label: str = "") -> CheckLimit:
    usual = getattr(NO_LIMITS, key, None)
    is_range = isinstance(usual, Range)
    return CheckLimit(
        key=key,
        label=label or of_check,
        unit=UNITS.get(key.rpartition("_")[2], ""),
        least=least,
        greatest=greatest,
        is_range=is_range,
        usual=None if is_range else usual,
    )


def parts_of(docstring: str) -> dict[str, str]:
    """Return the parts of a check's docstring, each as one paragraph; empty where it says nothing."""
    head, *rest = re.split(r"^(Why|How to fix|Source): ", docstring, flags=re.MULTILINE)
    paragraphs = {title.lower(): " ".join(text.split()) for title, text in zip(rest[::2], rest[1::2], strict=True)}
    summary = " ".join(head.split()).partition(": ")[2].rstrip(".")
    return {"summary": summary, "why": "", "how to fix": "", "source": "", **paragraphs}
