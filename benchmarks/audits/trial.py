"""Approved sounds, changed as games change them, and found again or not."""

from __future__ import annotations

import tempfile
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import soundfile

from audio_checks import FingerprintedFile, audit_build, fingerprint_files
from audio_checks.audit.likeness import Waves, likeness
from benchmarks.audits.changes import CHANGES, MEASURED_GAIN, TRIMS
from benchmarks.faults.sounds import FAMILIES
from tests.support.waves import Samples

OF_EACH = 40
Sound = tuple[str, Samples, int]


@dataclass
class Found:
    """The results of a trial: by change how many of how many were found, and how far the gain was off at most."""

    tried: Counter[str] = field(default_factory=Counter)
    found: Counter[str] = field(default_factory=Counter)
    off_db: dict[str, float] = field(default_factory=dict)
    missed: list[str] = field(default_factory=list)
    false: list[str] = field(default_factory=list)
    pairs: int = 0

    def share(self, changes: Mapping[str, object]) -> float:
        """Of all that was changed in one of these ways, which share was found."""
        return sum(self.found[name] for name in changes) / sum(self.tried[name] for name in changes)


def generated(seed: int, count: int) -> Iterator[Sound]:
    """Sounds of every family in turn, so that there are variations of each, from a tenth of a second to two."""
    for place in range(count):
        variation, number = divmod(place, len(FAMILIES))
        name, family = list(FAMILIES.items())[number]
        rng = np.random.default_rng([seed, number, variation])
        rate = (44_100, 48_000)[variation % 2]
        samples = family(rng, rate, float(rng.uniform(0.1, 2.0)))
        yield f"{name}_{variation + 1:02}", samples / np.abs(samples).max() * 0.6, rate


def real(folder: Path) -> Iterator[Sound]:
    """The real masters of a folder."""
    for path in sorted(folder.glob("*.wav")):
        samples, rate = soundfile.read(path, always_2d=True)
        yield path.stem, samples, rate


def trial(sounds: list[Sound], seed: int) -> Found:
    """Change `OF_EACH` of the sounds in each way, and look for all of them among all sounds."""
    tally = Found()
    with tempfile.TemporaryDirectory() as folder:
        approved, built, names, gains_db = _written(sounds, Path(folder), seed)
    for entry, name, put_db in zip(audit_build(approved, built).entries, names, gains_db, strict=False):
        change, own = entry.path.split("/")[0], f"{name}.wav"
        tally.tried[change] += 1
        matched = {match.path: match for match in entry.matches}
        tally.false += [f"{entry.path} taken for {path}" for path in matched if path != own]
        if own not in matched:
            tally.missed.append(f"{entry.path}: {entry.message}")
            continue
        tally.found[change] += 1
        if change in MEASURED_GAIN and entry.approved == own and entry.gain_db is not None:
            tally.off_db[change] = max(tally.off_db.get(change, 0.0), abs(entry.gain_db - put_db))
    _pairwise(approved, tally)
    return tally


def _written(
    sounds: list[Sound], folder: Path, seed: int
) -> tuple[list[FingerprintedFile], list[FingerprintedFile], list[str], list[float]]:
    """Listen to the sounds as they are and as they were changed; return also whose each is, and its gain."""
    (folder / "approved").mkdir()
    shown = []
    for name, samples, rate in sounds:
        soundfile.write(folder / "approved" / f"{name}.wav", samples, rate, subtype="PCM_24")
        shown.append((str(folder / "approved" / f"{name}.wav"), f"{name}.wav"))
    changed, names, gains_db = [], [], []
    for number, (change, make) in enumerate({**CHANGES, **TRIMS}.items()):
        (folder / str(number)).mkdir()
        rng = np.random.default_rng([seed, number])
        for place in rng.permutation(len(sounds))[:OF_EACH]:
            name, samples, rate = sounds[place]
            made = make(samples, rate, rng)
            path = made.write(folder / str(number) / name)
            changed.append((str(path), f"{change}/{path.name}"))
            names.append(name)
            gains_db.append(made.gain_db)
    return fingerprint_files(shown), fingerprint_files(changed), names, gains_db


def _pairwise(approved: list[FingerprintedFile], tally: Found) -> None:
    """Compare every sound with every other one as it is."""
    waves = [(one.path, Waves(one.fingerprint)) for one in approved if one.fingerprint is not None]
    for path, wave in waves:
        for other_path, other in waves:
            if path != other_path:
                tally.pairs += 1
                like = likeness(wave, other)
                if like is not None and like.is_same_sound:
                    tally.false.append(f"{other_path} taken for {path} ({like.score:.2f})")
