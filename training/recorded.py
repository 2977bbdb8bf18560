"""Real recordings and measured rooms by the repository they come from, to try `reverb` on.

`RECORDED_DIR` names a folder with `FILES.csv` (file, repository), `dry/`, `pairs/`, `game/`, `unsure/` and `ir/`.
None of it is part of this repository, and share-alike recordings and rooms are tried on but never learned from.
Every sound is taken as one of 48 kHz: of 44.1 kHz it is 9 % faster and higher, as is the room it is sent to.
"""

import csv
import hashlib
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import soundfile
from scipy import signal

from training.dataset import RATE, Response, decay_time_s
from training.shapes import Floats

RESERVED_ONE_IN = 5
SHARE_ALIKE = frozenset({"MegaGlest/megaglest-data", "redeclipse/sounds"})
FREE_ROOMS = frozenset(
    {
        "medium_hall",
        "living_room_1",
        "reverbjs_Basement",
        "reverbjs_DomesticLivingRoom",
        "reverbjs_EmptyApartmentBedroom",
        "reverbjs_PurnodesRailroadTunnel",
        "reverbjs_SaintLawrenceChurchMolenbeekWersbeekBelgium",
        "reverbjs_SpokaneWomansClub",
    }
)
"""Measured rooms that may be learned from; all others are share-alike, or their licence is not stated."""
NOT_TRIED = frozenset({"reverbjs_InsidePiano", "reverbjs_StPatricksChurchPatringtonPosition2", "ir_sportscentre_omni"})
"""No room, and other responses of halls that the trial has already: the last look must not meet them."""
STATED_DRY = (
    "dry/guitar_di",
    "pairs/frankensnare/top_close",
    "pairs/muldjordkit/close",
    "pairs/archtop_guitar/magnetic",
)
IN_A_ROOM = ("pairs/muldjordkit/ambience_L", "pairs/frankensnare/overhead", "unsure/body_percussion")
LONG_DECAYS = ("frankensnare", "muldjordkit", "archtop_guitar", "hand_drum", "guitar_di")
DRY_FALLS_DB, DRY_WITHIN_S = 30.0, 0.15
DIRECT_S = 0.003
FRAMES_OF = {22_050: (2, 1), 24_000: (2, 1), 44_100: (1, 1), 48_000: (1, 1), 96_000: (1, 2)}


@dataclass(frozen=True)
class Recording:
    """One recording: its repository, its folder, what kind of sound it is, its samples as of 48 kHz."""

    repository: str
    folder: str
    kind: str
    samples: Floats


def is_reserved(name: str) -> bool:
    """Return whether a repository or a share-alike room is kept for the one last look, by the hash of its name."""
    return int(hashlib.sha256(name.encode()).hexdigest(), 16) % RESERVED_ONE_IN == 0


def folder() -> Path | None:
    """Return the folder of recordings, None where RECORDED_DIR is not set."""
    named = os.environ.get("RECORDED_DIR")
    return Path(named) if named else None


def recordings(*, in_a_room: bool = False) -> list[Recording]:
    """Return the recordings that count as dry, or those made by room microphones.

    Dry is what its makers say so of (recorded direct, by a pickup, by a close microphone), and what falls by 30 dB
    within 0.15 s of where it was last within 10 dB of its top: no audible reverb falls so fast.
    """
    home = folder()
    found = []
    with (home / "FILES.csv").open(encoding="utf-8", newline="") if home else open(os.devnull) as rows:
        for row in csv.DictReader(rows):
            file = row["file"]
            if file.startswith("ir/") or file.startswith(IN_A_ROOM) != in_a_room:
                continue
            samples = _as_48k(home / file)
            if in_a_room or file.startswith(STATED_DRY) or _falls_fast(samples):
                group = file.rsplit("/", 1)[0]
                kind = "natural-decay" if any(one in file for one in LONG_DECAYS) and "noises" not in file else "event"
                found.append(Recording(row["repository"], group, kind, samples))
    return found


def rooms(*, to_learn: bool, reserved: bool = False) -> list[Response]:
    """Return measured rooms without their direct sound: those to learn from, or those to try, reserved or not."""
    home = folder()
    found = []
    for path in sorted((home / "ir").glob("*.flac")) if home else []:
        name = path.stem
        if name in NOT_TRIED or (name in FREE_ROOMS) != to_learn or (not to_learn and is_last_room(name) != reserved):
            continue
        samples = _as_48k(path)
        samples = np.repeat(samples, 2, axis=1) if samples.shape[1] == 1 else samples[:, :2]
        peak = int(np.argmax(np.abs(samples).max(axis=1)))
        samples = _without_floor(samples[peak + int(DIRECT_S * RATE) :])
        for rt60_s in (None, 0.35, 0.6, 1.0, 1.6, 2.4):  # as it is, and more damped
            own = decay_time_s(samples)
            if rt60_s is None or rt60_s < 0.8 * own:
                slope = 0.0 if rt60_s is None else 6.91 * (1 / rt60_s - 1 / own)
                damped = samples * np.exp(-slope * np.arange(len(samples)) / RATE)[:, np.newaxis]
                damped = damped[: int(RATE * min(4.5, (rt60_s or own) * 1.2 + 0.1))]
                measured = decay_time_s(damped)
                if 0.2 <= measured <= 4.5 and (rt60_s is None or abs(measured / rt60_s - 1) < 0.3):
                    found.append(Response(name, damped, measured))
    return found


def is_last_room(name: str) -> bool:
    """Return whether a room that is not learned from is kept for the one last look: every second, by hash."""
    return int(hashlib.sha256(name.encode()).hexdigest(), 16) % 2 == 0


def _as_48k(path: Path) -> Floats:
    samples, rate = soundfile.read(path, always_2d=True)
    up, down = FRAMES_OF[rate]
    samples = samples[:, :2] if samples.shape[1] > 2 else samples
    return samples if up == down else signal.resample_poly(samples, up, down, axis=0)


def _levels_db(samples: Floats) -> Floats:
    row = RATE // 200
    count = len(samples) // row
    power = np.square(samples[: count * row]).sum(axis=1).reshape(count, row).mean(axis=1)
    return 10 * np.log10(power + 1e-12)


def _falls_fast(samples: Floats) -> bool:
    levels = _levels_db(samples)
    if len(levels) < 8 or levels.max() < -70:
        return False
    loud = np.flatnonzero(levels > levels.max() - 10)[-1]
    above = np.flatnonzero(levels > levels.max() - DRY_FALLS_DB)[-1]
    return bool((above - loud) * 0.005 <= DRY_WITHIN_S and above < len(levels) - 2)


def _without_floor(samples: Floats) -> Floats:
    """Return a response up to where its own noise begins, faded out there."""
    levels = _levels_db(samples)
    smooth = np.convolve(levels, np.ones(10) / 10, mode="same")
    floor = float(np.median(smooth[-max(4, len(smooth) // 10) :]))
    top = int(np.argmax(smooth))
    under = np.flatnonzero(smooth[top:] < floor + 6)
    end = (top + int(under[0]) if len(under) and under[0] > 20 else len(smooth)) * (RATE // 200)
    cut = samples[:end].copy()
    fade = min(len(cut), RATE // 20)
    cut[len(cut) - fade :] *= np.linspace(1, 0, fade)[:, np.newaxis]
    return cut
