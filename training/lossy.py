"""Learns the score and the limits of the judgement `lossy`, and writes them and the tables of how good they are.

`make weights` (`python -m training.lossy`) has real encoders code sounds of many families, trims them, changes their
level and the rate of some; and takes sounds that were never coded, many of which look coded. Kept apart are
families of sounds, encoders and every second real recording. Needs ffmpeg; real recordings come from SOUNDS_DIR.
Those of RECORDED_DIR are tried as they came, and nothing is learned from them.
"""

import csv
import json
import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import soundfile
from scipy import signal
from sklearn.linear_model import LogisticRegression
from sklearn.metrics import roc_auc_score

from audio_checks.judge import CANNOT_TELL
from audio_checks.judge import lossy as judgement
from audio_checks.measure.cliff import cliff_of
from audio_checks.measure.codec_frames import USUAL_RATES_HZ, CodecFrames
from audio_checks.measure.spectrum import Spectrum
from training import dataset, recorded
from training.codecs import CODERS, LOOK_ALIKES, coded
from training.shapes import Draws, Floats
from training.tables import as_table, write_tables

FALSE_ALARMS = 0.005
UNDECIDED = 0.1  # of the clean sounds without a low-pass
LONGEST_S = 3.0
FULL_KBIT_S = 256  # of two channels: beyond, few lines are silent
REAL_SHARE = 0.3
PLAIN = "as it was made"
AFTERWARDS = {"trimmed": 0.7, "resampled": 0.3}


@dataclass(frozen=True)
class Made:
    """How some sounds are made."""

    clean: int
    of_each_coder: int  # at each bit rate
    seed: int
    is_kept_apart: bool = False


@dataclass(frozen=True)
class Known:
    """What is known of one sound, and what was measured of it."""

    way: str  # the coder, or what made a clean sound look coded
    kbit_s: int | None  # None: never coded
    afterwards: str
    contrast: float | None  # None: nothing to compare
    codec: str | None  # that stands out most
    low_pass_hz: float | None

    @property
    def is_coded(self) -> bool:
        return self.kbit_s is not None

    @property
    def verdict(self) -> str:
        if self.contrast is None:
            return CANNOT_TELL
        return judgement.verdict_of(judgement.score_of(self.contrast), self.low_pass_hz)


LEARNING = Made(400, 10, 91)
TRIED = {"development": Made(150, 4, 92), "kept apart": Made(500, 16, 93, is_kept_apart=True)}
CODECS = {coder.name: coder.codec for coder in CODERS}
MUST = {"falsely called lossy": -0.02}


def measured(made: Made) -> list[Known]:
    """Make some sounds, and return what is known and measured of each; what has nothing to compare counts as 0."""
    coders = [coder for coder in CODERS if made.is_kept_apart or not coder.is_kept_apart]
    source = _sources(made)
    known = []
    for number in range(made.clean):
        draws = np.random.default_rng([made.seed, 0, number])
        way = PLAIN if draws.random() < 0.4 else str(draws.choice(list(LOOK_ALIKES)))
        x, rate_hz = source(draws)
        known.append(_measured(draws, x if way == PLAIN else LOOK_ALIKES[way](draws, x, rate_hz), rate_hz, way, None))
    for place, coder in enumerate(coders):
        for kbit_s in coder.kbit_s:
            for number in range(made.of_each_coder):
                draws = np.random.default_rng([made.seed, 1 + place, kbit_s, number])
                x, rate_hz = coded(*source(draws), coder, kbit_s)
                known.append(_measured(draws, x, rate_hz, coder.name, kbit_s))
    return known


def _sources(made: Made) -> Callable[[Draws], tuple[Floats, int]]:
    """Return what draws a sound, shape (frames, channels), and its rate: made, or a real recording."""
    families, real = dataset.families(is_kept_apart=made.is_kept_apart), list(_recordings(made.is_kept_apart))

    def draw(draws: Draws) -> tuple[Floats, int]:
        if real and draws.random() < REAL_SHARE:
            x, rate_hz = real[draws.integers(len(real))]
        else:
            rate_hz = int(draws.choice([44_100, 48_000]))
            family = families[draws.integers(len(families))]
            x = _in_channels(draws, family.make(draws, rate_hz), family.make(draws, rate_hz))
            x = x + draws.standard_normal(x.shape) * np.abs(x).max() * 10 ** (-draws.uniform(55, 100) / 20)
        x = x[: int(LONGEST_S * rate_hz)]
        return x / (np.abs(x).max() + 1e-12) * 10 ** (-draws.uniform(0.5, 12) / 20), rate_hz

    return draw


def _in_channels(draws: Draws, x: Floats, other: Floats) -> Floats:
    """Return a made sound in one channel, or wide by some of another of its family."""
    if draws.random() < 0.5:
        return x[:, np.newaxis]
    shorter = min(len(x), len(other))
    width = draws.uniform(0, 1)
    return np.stack((x[:shorter], (1 - width) * x[:shorter] + width * other[:shorter]), axis=1)


def _recordings(is_kept_apart: bool) -> Iterator[tuple[Floats, int]]:
    """Yield every second real recording."""
    if folder := os.environ.get("SOUNDS_DIR"):
        for path in sorted(Path(folder, "masters").glob("*.wav"))[int(is_kept_apart) :: 2]:
            yield soundfile.read(path, always_2d=True)


def _measured(draws: Draws, x: Floats, rate_hz: int, way: str, kbit_s: int | None) -> Known:
    """Trim a sound, change its level and maybe its rate, round it as a file does, and measure it."""
    x = x[draws.integers(0, max(1, len(x) // 8)) :] * 10 ** (-draws.uniform(0, 6) / 20)
    afterwards = str(draws.choice(list(AFTERWARDS), p=list(AFTERWARDS.values())))
    if afterwards == "resampled":
        to_hz = 48_000 if rate_hz == 44_100 else 44_100
        x, rate_hz = signal.resample_poly(x, to_hz // 300, rate_hz // 300, window=("kaiser", 12.0)), to_hz
    full = 2.0 ** (15 if draws.random() < 0.5 else 23)
    return _as_it_is(np.clip(np.round(x * full), -full, full - 1) / full, rate_hz, 1 / full, way, kbit_s, afterwards)


def _as_it_is(x: Floats, rate_hz: int, step: float, way: str, kbit_s: int | None, afterwards: str) -> Known:
    """Measure a sound."""
    spectrum = Spectrum(rate_hz, x.shape[1], len(x), step=step)
    spectrum.add(x)
    frames = CodecFrames(rate_hz, x.shape[1], len(x), step=step)
    frames.add(x)
    best = max(frames.result()["codec_traces"], key=lambda trace: trace.contrast, default=None)
    return Known(
        way,
        kbit_s,
        afterwards,
        best and best.contrast,
        best and best.codec,
        judgement.low_pass_of(cliff_of(spectrum.result()["mean_spectrum"])),
    )


def recordings_as_they_came() -> Iterator[Known]:
    """Yield the recordings of RECORDED_DIR at the rates of codecs, those in Ogg Vorbis with their bit rate."""
    home = recorded.folder()
    with (home / "FILES.csv").open(encoding="utf-8", newline="") if home else open(os.devnull) as rows:
        for row in csv.DictReader(rows):
            file, kbit_s = row["file"], None
            if file.startswith("ir/") or int(row["rate"]) not in USUAL_RATES_HZ:
                continue
            if row["subtype"] == "VORBIS":
                kbit_s = vorbis_kbit_s(home / file)
            way = "Vorbis" if kbit_s else "game" if file.startswith("game/") else "instrument"
            full = 2.0 ** (23 if row["subtype"] == "PCM_24" else 15)
            x, rate_hz = soundfile.read(home / file, always_2d=True)
            x = np.clip(np.round(x * full), -full, full - 1) / full
            yield _as_it_is(x, rate_hz, 1 / full, way, kbit_s, "")


def vorbis_kbit_s(path: Path) -> int:
    """Return the nominal bit rate of an Ogg Vorbis file as that of two channels."""
    head = path.read_bytes()[:128]
    at = head.index(b"\x01vorbis")
    return round(int.from_bytes(head[at + 20 : at + 24], "little") / 500 / head[at + 11])


def learned(some: list[Known]) -> dict[str, list[float]]:
    """Return offset and slope of the score, and below what a sound is clean and from what on lossy."""
    judged = [one for one in some if one.contrast is not None]
    contrasts = np.array([[one.contrast] for one in judged])
    coded = np.array([one.is_coded for one in judged])
    fitted = LogisticRegression(C=100.0, class_weight="balanced").fit(contrasts, coded)
    scores = fitted.predict_proba(contrasts)[:, 1]
    ends = np.array([one.low_pass_hz is not None for one in judged])
    low = float(np.quantile(scores[~coded & ~ends], 1 - UNDECIDED))
    high = float(np.quantile(scores[~coded], 1 - FALSE_ALARMS))
    score = [round(float(fitted.intercept_[0]), 4), round(float(fitted.coef_[0, 0]), 4)]
    return {"score": score, "threshold": [round(low, 4), round(max(high, low, 0.5), 4)]}


def figures_on(some: list[Known]) -> dict[str, float]:
    """Return how good the judgement is on some sounds, as it ships."""
    truth = np.array([one.is_coded for one in some])
    verdicts = np.array([one.verdict for one in some])
    found, decided = verdicts == "lossy", verdicts != CANNOT_TELL
    right = np.array([one.codec == CODECS.get(one.way) for one in some])
    return {
        "AUC": roc_auc_score(truth, [one.contrast or 0.0 for one in some]),
        "found": found[truth].mean(),
        "falsely called lossy": found[~truth].mean(),
        "coded, called clean": (verdicts == "clean")[truth].mean(),
        "right when decided": (found == truth)[decided].mean(),
        "share decided": decided.mean(),
        "codec is the true one, of those found": right[found & truth].mean(),
    }


def by_coder(some: list[Known]) -> str:
    """Return for each coder and bit rate how often it is found, resampled afterwards and not."""
    lines = [
        "| codec (encoder) | kbit/s, stereo | sounds | found | called clean | resampled afterwards, found |",
        "|---|---|---|---|---|---|",
    ]
    for coder in CODERS:
        for kbit_s in coder.kbit_s:
            here = [one for one in some if one.way == coder.name and one.kbit_s == kbit_s]
            if here:
                trimmed = [one.verdict for one in here if one.afterwards == "trimmed"]
                resampled = [one.verdict for one in here if one.afterwards == "resampled"]
                shares = [_share(trimmed, "lossy"), _share(trimmed, "clean"), _share(resampled, "lossy")]
                lines.append(f"| {coder.name} | {kbit_s} | {len(here)} | {' | '.join(shares)} |")
    return "\n".join(lines)


def by_look_alike(some: list[Known]) -> str:
    """Return for each way of looking coded how often it is taken for it."""
    lines = ["| never coded | sounds | called lossy | called clean | cannot tell |", "|---|---|---|---|---|"]
    for way in (PLAIN, *LOOK_ALIKES):
        verdicts = [one.verdict for one in some if one.way == way]
        shares = " | ".join(_share(verdicts, verdict) for verdict in ("lossy", "clean", CANNOT_TELL))
        lines.append(f"| {way} | {len(verdicts)} | {shares} |")
    return "\n".join(lines)


def by_recording(sounds: list[Known]) -> str:
    """Return the verdicts on recordings as they came, by source or bit rate, as a table."""
    groups = {
        "uncoded: instruments, by their makers": [sound for sound in sounds if sound.way == "instrument"],
        "uncoded: sounds of games": [sound for sound in sounds if sound.way == "game"],
        f"Ogg Vorbis, up to {FULL_KBIT_S} kbit/s": [
            sound for sound in sounds if sound.kbit_s and sound.kbit_s <= FULL_KBIT_S
        ],
        "Ogg Vorbis, more than that": [sound for sound in sounds if sound.kbit_s and sound.kbit_s > FULL_KBIT_S],
    }
    lines = ["| came as | recordings | called lossy | called clean | cannot tell |", "|---|---|---|---|---|"]
    for name, group in groups.items():
        verdicts = [sound.verdict for sound in group]
        shares = " | ".join(_share(verdicts, verdict, 3) for verdict in ("lossy", "clean", CANNOT_TELL))
        lines.append(f"| {name} | {len(group)} | {shares} |")
    return "\n".join(lines)


def _share(verdicts: list[str], wanted: str, digits: int = 2) -> str:
    return f"{verdicts.count(wanted) / len(verdicts):.{digits}f}" if verdicts else ""


def main() -> None:
    """Make, learn, write the numbers, try them, and write the tables."""
    numbers = learned(measured(LEARNING))
    judgement.WEIGHTS.write_text(json.dumps(numbers, separators=(",", ":")) + "\n", encoding="ascii")
    tried = {name: measured(made) for name, made in TRIED.items()}
    write_tables(
        {
            "lossy": as_table({name: figures_on(some) for name, some in tried.items()}, MUST),
            "lossy by codec": by_coder(tried["kept apart"]),
            "lossy by look": by_look_alike(tried["kept apart"]),
        }
    )
    if recordings := list(recordings_as_they_came()):
        write_tables({"lossy, recordings": by_recording(recordings)})


if __name__ == "__main__":
    main()
