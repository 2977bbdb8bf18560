"""The checks: one module each, found by being here.

A check module has a docstring (one line `name`: what holds; then Why, How to fix, Source), from
which its page is made, and

- `SEVERITY`: "error" or "warning" by default; `OVER_FILES = True` where it judges files together;
- `LIMITS`, where it brings limits of its own: keys of the table `limits` of a spec, with the least and
  greatest value; it reads them from `spec.limits.others`;
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
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec import check_names
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile
    from audio_checks.report.judged import JudgedFile


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
    def not_fixed(self) -> str | None:
        """Why no fix is offered for what it finds; None where it does not say."""
        why: str | None = getattr(self.module, "NOT_FIXED", None)
        return why

    @property
    def summary(self) -> str:
        """What holds when it finds nothing, in one line."""
        return self.parts["summary"]

    @property
    def parts(self) -> dict[str, str]:
        """The parts of its docstring: summary, why, how to fix, source."""
        return parts_of(self.module.__doc__ or "")

    def applies(self, spec: DeliverySpec, cue: CueFacts | None) -> bool:
        """Return whether the spec, or the cue, states anything that it could hold a file to."""
        ask = getattr(self.module, "applies", None)
        return ask is None or bool(ask(spec, cue))

    def run(self, file: "AudioFile", spec: DeliverySpec, cue: CueFacts | None) -> Iterator[Finding]:
        """Yield what it finds in one file."""
        if not hasattr(self.module, "check"):
            return iter(())
        wants_cue = self.module.check.__code__.co_argcount == 3
        found: Iterator[Finding] = self.module.check(file, spec, *([cue] if wants_cue else []))
        return found

    @property
    def is_over_sets(self) -> bool:
        """Whether it finds anything over files together."""
        return hasattr(self.module, "check_set")

    def run_set(self, files: Sequence["JudgedFile"]) -> Iterator[tuple[int, Finding]]:
        """Yield what it finds over files together, each with the place of its file."""
        found: Iterator[tuple[int, Finding]] = self.module.check_set(files)
        return found


@cache
def all_checks() -> dict[str, Check]:
    """Return every check of this version by name, in the order of the format."""
    here = check_names.present()
    return {name: _load(name) for name in check_names.DEFAULT_SEVERITY if name in here}


def _load(name: str) -> Check:
    return Check(name, import_module(f"{__name__}.{name.replace('-', '_')}"))


def parts_of(docstring: str) -> dict[str, str]:
    """Return the parts of a check's docstring, each as one paragraph; empty where it says nothing."""
    head, *rest = re.split(r"^(Why|How to fix|Source): ", docstring, flags=re.MULTILINE)
    paragraphs = {title.lower(): " ".join(text.split()) for title, text in zip(rest[::2], rest[1::2], strict=True)}
    summary = " ".join(head.split()).partition(": ")[2].rstrip(".")
    return {"summary": summary, "why": "", "how to fix": "", "source": "", **paragraphs}
