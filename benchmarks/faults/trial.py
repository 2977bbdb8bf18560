"""Puts faults into sounds, lets the checks look, and counts what they find."""

import re
import tempfile
from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

import numpy as np

from audio_checks import check_file
from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import parse_spec
from benchmarks.faults.injuries import Fault
from benchmarks.faults.sounds import Family, Samples, draw
from tests.support.waves import write_wav

CHECKS = ("clipping", "click", "cut-start", "cut-tail", "dropout", "dc-offset", "hum", "noise-floor")
SPEC = parse_spec("format = 1\nlimits.dc_offset_percent = 1.0\nlimits.noise_floor_dbfs = -60.0\n")
AUDIBLE = {"click": 20.0}  # from which level on a fault counts as audible; others at every level
NEAR_S = 0.003  # a click or a hole must be found where it is
NAMED_PLACE = re.compile(r"[(,] ?(\d+\.\d{3}) s(?=[,)])")
NO_PLACE = {  # the sound has by nature what the fault would leave
    "click": {"square"},
    "dropout": {"square", "stutter"},
    "clipping": {"square"},
    "noise-floor": {"stutter", "bell"},
}


class Trial(NamedTuple):
    """One fault in one sound: which, at which level, in which family's sound, and whether it was found."""

    fault: Fault
    level: float
    family: str
    seed: int
    found: bool


def findings_in(path: Path, checks: tuple[str, ...] = CHECKS) -> list[Finding]:
    """What the checks find in a file; one that breaks is not a finding."""
    report = check_file(path, SPEC, checks=checks)
    broken = [finding.message for finding in report.findings if finding.code.endswith(":crashed")]
    assert not broken, broken
    return list(report.findings)


def counts(fault: Fault, level: float) -> bool:
    """Return whether a fault is audible at a level, so that it must be found."""
    return level >= AUDIBLE.get(fault.check, level)


def trials(
    faults: tuple[Fault, ...], families: Mapping[str, Family], seeds: range, checks: Collection[str] = CHECKS
) -> Iterator[Trial]:
    """Every fault of these checks at every level in `seeds` sounds of every family that has a place for it."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "sound.wav")
        for name, family in families.items():
            for seed in seeds:
                sound, rate = draw(family, seed)
                for number, fault in enumerate(faults):
                    if fault.check not in checks or name in NO_PLACE.get(fault.check, ()):
                        continue
                    for level in fault.levels:
                        found = _try(path, fault, level, sound, rate, np.random.default_rng([seed, number]))
                        if found is not None:
                            yield Trial(fault, level, name, seed, found)


def false_alarms(families: Mapping[str, Family], seeds: range) -> tuple[int, Counter[tuple[str, str]]]:
    """How many whole sounds were looked at, and in how many of each family each check found something."""
    flagged: Counter[tuple[str, str]] = Counter()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "sound.wav")
        for name, family in families.items():
            for seed in seeds:
                sound, rate = draw(family, seed)
                found = findings_in(write_wav(path, sound, rate=rate))
                flagged.update((check, name) for check in {finding.check for finding in found})
    return len(families) * len(seeds), flagged


def _try(path: Path, fault: Fault, level: float, sound: Samples, rate: int, rng: np.random.Generator) -> bool | None:
    injured = fault.injure(rng, sound, rate, level)
    if injured is None:
        return None
    found = findings_in(write_wav(path, injured.samples, rate=rate), (fault.check,))
    if fault.check not in ("click", "dropout"):
        return bool(found)
    return any(
        start_s - NEAR_S <= injured.end_s and injured.start_s <= end_s + NEAR_S
        for one in found
        for start_s, end_s in _spans(one)
    )


def _spans(finding: Finding) -> Iterator[tuple[float, float]]:
    """Yield where a finding says that something is: its span, and the other places that its message names."""
    if finding.start_s is not None and finding.end_s is not None:
        yield finding.start_s, finding.end_s
    for place in NAMED_PLACE.findall(finding.message):
        yield float(place), float(place)
