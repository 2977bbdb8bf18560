"""Tries the check `padded-bits` on made sounds, and writes what it finds; nothing is learned.

`make weights` (`python -m training.padded`) rounds sounds to 16 bits, changes their level and writes them with 24, and
rounds others to 24 bits at once: sounds of all families, each at four levels. `RECORDED_DIR` (see `recorded.py`) adds
real recordings: those that came with 24 bits, so that what is not rounded to 16 here was not before.
"""

import csv

import numpy as np
import soundfile
from numpy.typing import NDArray

from audio_checks.measure.steps import Steps
from training import dataset, recorded
from training.shapes import Draws, Family
from training.tables import write_tables

Floats = NDArray[np.float64]
RATE = 48_000
LONGEST_S = 1.0
PADDED_SOUNDS, TRUE_SOUNDS, LEVELS = 100, 260, 4
SHARE_OF_DITHERED = 0.5


def is_found(draws: Draws, sound: Floats, *, padded: bool) -> bool | None:
    """Return whether steps are found in one file made of a sound; None if too few values differ to decide."""
    level_db = -draws.uniform(0.5, 20)
    x = sound * 10 ** (level_db / 20)
    if padded:  # moved by up to 6 dB, and never into clipping
        moved_db = draws.choice([-1, 1]) * draws.uniform(0.1, 6)
        x = _rounded(draws, x, 16) * 10 ** (min(moved_db, -0.1 - level_db) / 20)
    x = _rounded(draws, x, 24)
    steps = Steps(RATE, 1, len(x), step=2.0**-23)
    steps.add(x[:, np.newaxis])
    step = steps.result()["sample_step"]
    return None if step is None else step > 1


def _rounded(draws: Draws, x: Floats, bits: int) -> Floats:
    full = 2.0 ** (bits - 1)
    dither = draws.random(len(x)) - draws.random(len(x)) if draws.random() < SHARE_OF_DITHERED else 0.0
    return np.clip(np.round(x * full + dither), -full, full - 1) / full


def found_in(families: list[Family], sounds: int, seed: int, *, padded: bool) -> list[bool | None]:
    """Return what is found in files made of sounds of all families in turn, each at some levels."""
    found = []
    for number in range(sounds):
        draws = np.random.default_rng([seed, number])
        x = families[number % len(families)].make(draws, RATE)[: int(LONGEST_S * RATE)]
        x = x / (np.abs(x).max() + 1e-12)
        found += [is_found(draws, x, padded=padded) for _ in range(LEVELS)]
    return found


def found_in_recordings(seed: int, *, padded: bool) -> list[bool | None]:
    """Return what is found in files made of the recordings that came with 24 bits, each at some levels.

    Those that are to have 24 bits are never turned up: 24 bits turned up stand on steps indeed.
    """
    home = recorded.folder()
    if home is None:
        return []
    with (home / "FILES.csv").open(encoding="utf-8", newline="") as rows:
        names = [row["file"] for row in csv.DictReader(rows) if row["subtype"] == "PCM_24"]
    found = []
    for number, name in enumerate(names):
        draws = np.random.default_rng([seed, number])
        samples, rate = soundfile.read(home / name, always_2d=True)
        x = samples[: int(LONGEST_S * rate), 0]
        if padded:
            x = x / (np.abs(x).max() + 1e-12)
        found += [is_found(draws, x, padded=padded) for _ in range(LEVELS)]
    return found


def main() -> None:
    """Make, look, and write the table."""
    families = [*dataset.families(is_kept_apart=False), *dataset.families(is_kept_apart=True)]
    padded = found_in(families, PADDED_SOUNDS, 81, padded=True)
    true = found_in(families, TRUE_SOUNDS, 82, padded=False)
    rows = [
        "| | files | steps found | too few values |",
        "|---|---|---|---|",
        _row("16 bits, another level, written with 24", padded),
        _row("24 bits", true),
        _row("real recordings, so padded", found_in_recordings(83, padded=True)),
        _row("real recordings, 24 bits", found_in_recordings(84, padded=False)),
    ]
    write_tables({"padded": "\n".join(rows)})


def _row(name: str, found: list[bool | None]) -> str:
    return f"| {name} | {len(found)} | {found.count(True)} | {found.count(None)} |"


if __name__ == "__main__":
    main()
